//! Does skin show through cloth? Measured against the body's skin, not against its capsules.

use glam::Vec3;
use lole_geom::triangle_grid::{TriangleGrid, blend};

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
    let mut result = SkinCheck::default();
    for &position in cloth.positions {
        let depth = depth_below_skin(&body_grid, body, &near, position);
        result.worst_depth = result.worst_depth.max(depth);
        if TOLERANCE < depth {
            result.sunken_cloth_vertices += 1;
        }
    }
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
}
