//! Does skin show through cloth? Measured against the body's skin, not against its capsules.

use glam::Vec3;
use lole_geom::triangle_grid::{TriangleGrid, blend};
use rayon::prelude::*;

/// Cloth nearer than this behind the drawn skin [m] is touching it, not through it: half a
/// millimeter is a fold of thread, and no picture shows it.
const TOLERANCE: f32 = 0.5e-3;

/// How far behind the skin cloth is looked for [m]; a limb is thicker.
const REACH: f32 = 0.05;
/// How far in front of a poking body vertex other cloth may still cover it [m].
const COVER_REACH: f32 = 0.12;
/// Edge of a cell [m]: about two edges of either mesh.
const CELL: f32 = 0.02;

/// A surface in one frame.
#[derive(Debug, Clone, Copy)]
pub struct CheckedSurface<'a> {
    /// Vertex positions [m].
    pub positions: &'a [Vec3],
    /// Unit outward vertex normals.
    pub normals: &'a [Vec3],
    /// Vertex indices of each triangle.
    pub triangles: &'a [[u32; 3]],
}

/// What one frame shows.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SkinCheck {
    /// Deepest cloth vertex below the drawn skin [m], 0 when none is.
    pub worst_depth: f32,
    /// Cloth vertices more than half a millimeter below the drawn skin.
    pub sunken_cloth_vertices: u32,
    /// Body vertices outside the cloth that should cover them.
    pub showing_body_vertices: u32,
}

impl SkinCheck {
    /// Adds what another garment shows.
    pub(crate) fn add(&mut self, other: Self) {
        self.worst_depth = self.worst_depth.max(other.worst_depth);
        self.sunken_cloth_vertices += other.sunken_cloth_vertices;
        self.showing_body_vertices += other.showing_body_vertices;
    }
}

/// Compares one frame's cloth with one frame's body.
///
/// A cloth vertex is inside when it lies behind the nearest point of the skin. A body vertex shows
/// when cloth lies behind it, inside the body, and none lies in front of it.
#[must_use]
pub fn check(body: CheckedSurface<'_>, cloth: CheckedSurface<'_>) -> SkinCheck {
    let (low, high) = bounds(cloth.positions);
    let near = near_triangles(body, low - Vec3::splat(REACH), high + Vec3::splat(REACH));
    let body_grid = TriangleGrid::new(body.positions, &near, CELL);
    let neighborhood = Neighborhood::of(body, &near);
    let looked = (cloth.positions.par_iter())
        .filter(|&&position| neighborhood.holds(position))
        .map(|&position| depth_below_skin(&body_grid, body, &near, position));
    // Greatest and count: the same on any number of threads.
    let (worst_depth, sunken_cloth_vertices) = looked
        .map(|depth| (depth, u32::from(TOLERANCE < depth)))
        .reduce(|| (0.0, 0), |a, b| (a.0.max(b.0), a.1 + b.1));
    let mut result = SkinCheck {
        worst_depth,
        sunken_cloth_vertices,
        ..SkinCheck::default()
    };
    if 0.0 < result.worst_depth {
        let showing = showing_of(body, cloth, &near, &body_grid);
        result.showing_body_vertices = u32::try_from(showing.len()).unwrap_or(u32::MAX);
    }
    result
}

/// The body vertices that [`check`] counts as showing, ascending.
pub(crate) fn showing(body: CheckedSurface<'_>, cloth: CheckedSurface<'_>) -> Vec<usize> {
    let (low, high) = bounds(cloth.positions);
    let near = near_triangles(body, low - Vec3::splat(REACH), high + Vec3::splat(REACH));
    let body_grid = TriangleGrid::new(body.positions, &near, CELL);
    showing_of(body, cloth, &near, &body_grid)
}

fn showing_of(
    body: CheckedSurface<'_>,
    cloth: CheckedSurface<'_>,
    near: &[[u32; 3]],
    body_grid: &TriangleGrid<'_>,
) -> Vec<usize> {
    let cloth_grid = TriangleGrid::new(cloth.positions, cloth.triangles, CELL);
    used_vertices(near, body.positions.len())
        .filter(|&vertex| {
            let (position, outward) = (body.positions[vertex], body.normals[vertex]);
            shows(&cloth_grid, body_grid, position, outward)
        })
        .collect()
}

/// Depth of each place below the drawn skin [m], 0 outside, as [`check`] measures it.
pub(crate) fn depths(body: CheckedSurface<'_>, places: &[Vec3]) -> Vec<f32> {
    let (low, high) = bounds(places);
    let near = near_triangles(body, low - Vec3::splat(REACH), high + Vec3::splat(REACH));
    let grid = TriangleGrid::new(body.positions, &near, CELL);
    let depth = |&place: &Vec3| depth_below_skin(&grid, body, &near, place);
    places.iter().map(depth).collect()
}

/// The cloth vertices that [`check`] counts as sunken.
#[must_use]
pub fn sunken(body: CheckedSurface<'_>, cloth: CheckedSurface<'_>) -> Vec<u32> {
    let (low, high) = bounds(cloth.positions);
    let near = near_triangles(body, low - Vec3::splat(REACH), high + Vec3::splat(REACH));
    let grid = TriangleGrid::new(body.positions, &near, CELL);
    let below =
        |&(_, &position): &(u32, &Vec3)| TOLERANCE < depth_below_skin(&grid, body, &near, position);
    (0..)
        .zip(cloth.positions)
        .filter(below)
        .map(|(vertex, _)| vertex)
        .collect()
}

/// Where skin is within [`REACH`]: most of a skirt hangs farther away, and is not looked at closely.
struct Neighborhood {
    origin: Vec3,
    counts: [usize; 3],
    near: Vec<bool>,
}

impl Neighborhood {
    /// Edge of its cells [m].
    const CELL: f32 = 0.04;
    /// Cells at most; a body that has burst is looked at everywhere.
    const MOST: usize = 1 << 20;

    fn of(body: CheckedSurface<'_>, triangles: &[[u32; 3]]) -> Self {
        let corners = |triangle: &[u32; 3]| triangle.map(|index| body.positions[index as usize]);
        let reach = Vec3::splat(REACH);
        let (low, high) = triangles
            .iter()
            .map(corners)
            .fold((Vec3::MAX, Vec3::MIN), |(low, high), [a, b, c]| {
                (low.min(a.min(b).min(c)), high.max(a.max(b).max(c)))
            });
        let (origin, extent) = (low - reach, high - low + 2.0 * reach);
        let mut found = Self {
            origin,
            counts: [0; 3],
            near: Vec::new(),
        };
        let is_bounded = extent.is_finite() && extent.cmpge(Vec3::ZERO).all();
        let counts = extent.to_array().map(|side| cells(side) + 1);
        if !is_bounded
            || Self::MOST
                < counts
                    .iter()
                    .fold(1, |all: usize, n| all.saturating_mul(*n))
        {
            return found;
        }
        found.counts = counts;
        found.near = vec![false; counts.iter().product()];
        for [a, b, c] in triangles.iter().map(corners) {
            let low = (a.min(b).min(c) - reach - origin).to_array().map(cells);
            let high = (a.max(b).max(c) + reach - origin).to_array().map(cells);
            for z in low[2]..=high[2].min(counts[2] - 1) {
                for y in low[1]..=high[1].min(counts[1] - 1) {
                    let row = (z * counts[1] + y) * counts[0];
                    found.near[row + low[0]..=row + high[0].min(counts[0] - 1)].fill(true);
                }
            }
        }
        found
    }

    /// Whether skin may be within reach of a place.
    fn holds(&self, place: Vec3) -> bool {
        let at = place - self.origin;
        if self.near.is_empty() || !at.is_finite() {
            return true;
        }
        let [x, y, z] = at.to_array().map(cells);
        let [columns, rows, layers] = self.counts;
        let is_inside = at.cmpge(Vec3::ZERO).all() && x < columns && y < rows && z < layers;
        is_inside && self.near[(z * rows + y) * columns + x]
    }
}

/// How many whole cells of a [`Neighborhood`] a length has [m].
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "`as` saturates, and counts are checked"
)]
fn cells(length: f32) -> usize {
    (length / Neighborhood::CELL).max(0.0) as usize
}

fn bounds(positions: &[Vec3]) -> (Vec3, Vec3) {
    let start = (Vec3::splat(f32::MAX), Vec3::splat(f32::MIN));
    positions
        .iter()
        .filter(|position| position.is_finite())
        .fold(start, |(low, high), &position| {
            (low.min(position), high.max(position))
        })
}

fn near_triangles(body: CheckedSurface<'_>, low: Vec3, high: Vec3) -> Vec<[u32; 3]> {
    let inside = |index: u32| {
        let position = body.positions[index as usize];
        position.cmpge(low).all() && position.cmple(high).all()
    };
    body.triangles
        .iter()
        .copied()
        .filter(|triangle| triangle.iter().any(|&i| inside(i)))
        .collect()
}

fn used_vertices(triangles: &[[u32; 3]], vertex_count: usize) -> impl Iterator<Item = usize> {
    let mut used = vec![false; vertex_count];
    for &index in triangles.iter().flatten() {
        used[index as usize] = true;
    }
    used.into_iter()
        .enumerate()
        .filter_map(|(index, used)| used.then_some(index))
}

/// Depth of `position` below the drawn skin [m], 0 outside.
fn depth_below_skin(
    grid: &TriangleGrid<'_>,
    body: CheckedSurface<'_>,
    triangles: &[[u32; 3]],
    position: Vec3,
) -> f32 {
    let Some(nearest) = grid.nearest(position, REACH) else {
        return 0.0;
    };
    let normals = triangles[nearest.triangle as usize].map(|i| body.normals[i as usize]);
    let outward = blend(normals, nearest.barycentric);
    if (position - nearest.point).dot(outward) < 0.0 {
        nearest.distance
    } else {
        0.0
    }
}

/// Does a vertex of the skin, and its outward normal, lie outside the cloth that should cover it?
///
/// Cloth behind it counts only up to the middle of the limb: that which a hand is held before covers the
/// chest, not the hand, though its palm is pressed into it.
fn shows(cloth: &TriangleGrid<'_>, body: &TriangleGrid<'_>, position: Vec3, outward: Vec3) -> bool {
    let (start, end) = (position - outward * TOLERANCE, position - outward * REACH);
    let Some(behind) = cloth.first_crossing(start, end) else {
        return false;
    };
    let is_of_this_side = (body.first_crossing(start, end)).is_none_or(|out| 2.0 * behind < out);
    is_of_this_side
        && cloth
            .first_crossing(position, position + outward * COVER_REACH)
            .is_none()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A latitude–longitude sphere of `radius` about `center`.
    fn sphere(center: Vec3, radius: f32) -> (Vec<Vec3>, Vec<Vec3>, Vec<[u32; 3]>) {
        let (rings, sectors) = (24_u16, 48_u16);
        let (mut positions, mut normals, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
        for ring in 0..=rings {
            for sector in 0..sectors {
                let theta = std::f32::consts::PI * f32::from(ring) / f32::from(rings);
                let phi = std::f32::consts::TAU * f32::from(sector) / f32::from(sectors);
                let (sin, cos) = lole_geom::trig::sin_cos(theta);
                let (sin_phi, cos_phi) = lole_geom::trig::sin_cos(phi);
                let normal = Vec3::new(sin * cos_phi, cos, sin * sin_phi);
                normals.push(normal);
                positions.push(center + normal * radius);
            }
        }
        for ring in 0..u32::from(rings) {
            for sector in 0..u32::from(sectors) {
                let next = (sector + 1) % u32::from(sectors);
                let row = ring * u32::from(sectors);
                let below = row + u32::from(sectors);
                triangles.push([row + sector, row + next, below + sector]);
                triangles.push([row + next, below + next, below + sector]);
            }
        }
        (positions, normals, triangles)
    }

    fn check_spheres(body_radius: f32, cloth_radius: f32) -> SkinCheck {
        let body = sphere(Vec3::ZERO, body_radius);
        let cloth = sphere(Vec3::ZERO, cloth_radius);
        check(
            CheckedSurface {
                positions: &body.0,
                normals: &body.1,
                triangles: &body.2,
            },
            CheckedSurface {
                positions: &cloth.0,
                normals: &cloth.1,
                triangles: &cloth.2,
            },
        )
    }

    #[test]
    fn a_shell_outside_the_body_hides_it() {
        let found = check_spheres(0.10, 0.12);
        assert_eq!(found, SkinCheck::default());
    }

    #[test]
    fn a_shell_inside_the_body_shows_it_everywhere() {
        let found = check_spheres(0.10, 0.09);
        assert!((found.worst_depth - 0.01).abs() < 1e-3, "{found:?}");
        let (positions, normals, triangles) = sphere(Vec3::ZERO, 0.1);
        assert_eq!(found.sunken_cloth_vertices as usize, positions.len());
        let (inner, ..) = sphere(Vec3::ZERO, 0.09);
        let shell = |positions, normals| CheckedSurface {
            positions,
            normals,
            triangles: &triangles,
        };
        let sunken = sunken(shell(&positions, &normals), shell(&inner, &[]));
        assert_eq!(sunken.len(), positions.len());
        assert!(
            found.showing_body_vertices as usize > positions.len() * 9 / 10,
            "{found:?}"
        );
    }

    /// Cloth that is left out because no skin is near it is outside of it, and no other is left out.
    #[test]
    fn what_is_not_looked_at_closely_is_far_from_skin() {
        let (positions, normals, triangles) = sphere(Vec3::new(0.1, 1.0, -0.2), 0.15);
        let body = CheckedSurface {
            positions: &positions,
            normals: &normals,
            triangles: &triangles,
        };
        let neighborhood = Neighborhood::of(body, &triangles);
        let grid = TriangleGrid::new(&positions, &triangles, CELL);
        let mut chance = lole_geom::chance::Chance::new(5);
        let mut left_out = 0;
        for _ in 0..4000 {
            let at = [(); 3].map(|()| chance.between(-0.5, 0.5));
            let place = Vec3::new(0.1, 1.0, -0.2) + Vec3::from(at);
            if !neighborhood.holds(place) {
                left_out += 1;
                assert!(grid.nearest(place, REACH).is_none(), "{place}");
            }
        }
        assert!(left_out > 2000, "{left_out}");
    }
}
