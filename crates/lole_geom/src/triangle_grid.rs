//! Nearest-point and short-ray queries on a triangle mesh, through a uniform grid of cells.
//!
//! Made for meshes that move: building is one counting sort over the triangles. Meant for queries
//! that reach a few cells; it is not a ray tracer.

use glam::{IVec3, Vec3};

/// Most cells of a grid: two hundred times those of a body.
const MOST_CELLS: f32 = 4.0e6;
/// Most entries of triangles in cells.
const MOST_MEMBERS: f32 = 2.0e7;

/// Cells that a box of this `extent` [m] may touch, as a number that cannot overflow.
fn cells_in(extent: Vec3, cell_size: f32) -> f32 {
    (extent / cell_size + 1.0).element_product()
}

/// Triangles sorted into cubic cells.
#[derive(Debug, Clone)]
pub struct TriangleGrid<'a> {
    positions: &'a [Vec3],
    triangles: &'a [[u32; 3]],
    origin: Vec3,
    cell_size: f32,
    cell_counts: IVec3,
    /// Start of each cell's run in `members`, shape `[cell_count + 1]`.
    starts: Vec<u32>,
    /// Triangle indices, ascending within a cell.
    members: Vec<u32>,
    /// Box of each triangle [m]: most queries end here.
    boxes: Vec<Bounds>,
}

/// A box [m].
#[derive(Debug, Clone, Copy, PartialEq)]
struct Bounds {
    low: Vec3,
    high: Vec3,
}

/// Distances are compared after rounding, so a box is left out only if it is this much farther away.
const ROUNDING: f32 = 1.0 - 1.0e-5;

impl Bounds {
    const NOWHERE: Self = Self {
        low: Vec3::INFINITY,
        high: Vec3::NEG_INFINITY,
    };

    /// Around points; nowhere unless all are finite.
    fn around<const N: usize>(points: [Vec3; N]) -> Self {
        if !points.iter().all(|point| point.is_finite()) {
            return Self::NOWHERE;
        }
        let boxes = points.map(|point| Self {
            low: point,
            high: point,
        });
        boxes.into_iter().fold(Self::NOWHERE, Self::and)
    }

    fn and(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }

    fn is_nowhere(&self) -> bool {
        self.high.x < self.low.x
    }

    /// Whether it certainly lies farther than `limit` [m] from a point.
    fn is_beyond(&self, point: Vec3, limit: f32) -> bool {
        let gap = (self.low - point).max(point - self.high).max(Vec3::ZERO);
        limit * limit < gap.length_squared() * ROUNDING
    }

    fn meets(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }
}

/// Point of a mesh that lies nearest to a query point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// Index of the triangle.
    pub triangle: u32,
    /// Weights of its three corners, summing to 1.
    pub barycentric: Vec3,
    /// The nearest point [m].
    pub point: Vec3,
    /// Its distance [m], not negative.
    pub distance: f32,
}

impl<'a> TriangleGrid<'a> {
    /// Sorts triangles into cells of `cell_size` [m].
    ///
    /// Choose about twice the mean edge length. Non-finite triangles are left out. Where the mesh has
    /// burst, the cells are made larger, so that memory stays bounded.
    #[must_use]
    pub fn new(positions: &'a [Vec3], triangles: &'a [[u32; 3]], cell_size: f32) -> Self {
        let boxes: Vec<Bounds> = (triangles.iter())
            .map(|triangle| Bounds::around(triangle.map(|corner| positions[corner as usize])))
            .collect();
        let all = boxes.iter().filter(|one| !one.is_nowhere());
        let all = all.copied().reduce(Bounds::and);
        let (low, high) = all.map_or_else(Default::default, |all| (all.low, all.high));
        let origin = low;
        let mut cell_size = cell_size;
        while MOST_CELLS < cells_in(high - low, cell_size)
            || MOST_MEMBERS
                < (boxes.iter().filter(|one| !one.is_nowhere()))
                    .map(|one| cells_in(one.high - one.low, cell_size))
                    .sum()
        {
            cell_size *= 2.0;
        }
        let cell_counts = ((high - low) / cell_size).as_ivec3() + IVec3::ONE;
        let cell_count = cell_counts.x as usize * cell_counts.y as usize * cell_counts.z as usize;
        let mut grid = Self {
            positions,
            triangles,
            origin,
            cell_size,
            cell_counts,
            starts: vec![0; cell_count + 1],
            members: Vec::new(),
            boxes,
        };
        grid.sort_triangles();
        grid
    }

    fn sort_triangles(&mut self) {
        let mut starts = vec![0_u32; self.starts.len()];
        self.for_each_membership(|cell, _| starts[cell + 1] += 1);
        for cell in 1..starts.len() {
            starts[cell] += starts[cell - 1];
        }
        let mut next = starts.clone();
        let mut members = vec![0_u32; starts.last().map_or(0, |&count| count as usize)];
        self.for_each_membership(|cell, triangle| {
            members[next[cell] as usize] = triangle;
            next[cell] += 1;
        });
        self.starts = starts;
        self.members = members;
    }

    fn for_each_membership(&self, mut visit: impl FnMut(usize, u32)) {
        for (bounds, index) in self.boxes.iter().zip(0_u32..) {
            if !bounds.is_nowhere() {
                self.for_each_cell(bounds.low, bounds.high, |cell| visit(cell, index));
            }
        }
    }

    fn for_each_cell(&self, low: Vec3, high: Vec3, mut visit: impl FnMut(usize)) {
        let last = self.cell_counts - IVec3::ONE;
        let from = ((low - self.origin) / self.cell_size)
            .floor()
            .as_ivec3()
            .max(IVec3::ZERO);
        let to = ((high - self.origin) / self.cell_size)
            .floor()
            .as_ivec3()
            .min(last);
        for z in from.z..=to.z {
            for y in from.y..=to.y {
                for x in from.x..=to.x {
                    let row = z as usize * self.cell_counts.y as usize + y as usize;
                    visit(row * self.cell_counts.x as usize + x as usize);
                }
            }
        }
    }

    fn members_of(&self, cell: usize) -> &[u32] {
        &self.members[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }

    /// Nearest point of the mesh within `reach` [m] of `point`; the lowest triangle index wins a tie.
    #[must_use]
    pub fn nearest(&self, point: Vec3, reach: f32) -> Option<Nearest> {
        if !point.is_finite() {
            return None;
        }
        // Boxes that double: most of a large one is farther than what is found.
        let mut near = 0.5 * self.cell_size;
        while near < reach {
            let close = self.nearest_in_box(point, near);
            if close.is_some() {
                return close;
            }
            near *= 2.0;
        }
        self.nearest_in_box(point, reach)
    }

    fn nearest_in_box(&self, point: Vec3, reach: f32) -> Option<Nearest> {
        let mut best: Option<Nearest> = None;
        let mut limit = reach;
        let reach = Vec3::splat(reach);
        self.for_each_cell(point - reach, point + reach, |cell| {
            for &triangle in self.members_of(cell) {
                if self.boxes[triangle as usize].is_beyond(point, limit) {
                    continue;
                }
                let corners =
                    self.triangles[triangle as usize].map(|corner| self.positions[corner as usize]);
                let barycentric = nearest_barycentric(point, corners);
                let foot = blend(corners, barycentric);
                let distance = foot.distance(point);
                let ties = best.is_some_and(|held| {
                    held.distance.to_bits() == distance.to_bits() && triangle < held.triangle
                });
                if distance < limit || ties {
                    limit = distance;
                    best = Some(Nearest {
                        triangle,
                        barycentric,
                        point: foot,
                        distance,
                    });
                }
            }
        });
        best
    }

    /// Writes over `near` the triangles whose boxes meet that of the segment `start → end`, ascending.
    pub fn near_segment(&self, start: Vec3, end: Vec3, near: &mut Vec<u32>) {
        near.clear();
        let segment = Bounds::around([start, end]);
        self.for_each_cell(segment.low, segment.high, |cell| {
            let members = self.members_of(cell).iter();
            near.extend(members.filter(|&&it| self.boxes[it as usize].meets(&segment)));
        });
        near.sort_unstable();
        near.dedup();
    }

    /// Writes over `crossed` the triangles that the segment `start → end` crosses, ascending.
    pub fn crossed_by(&self, start: Vec3, end: Vec3, crossed: &mut Vec<u32>) {
        crossed.clear();
        let segment = Bounds::around([start, end]);
        self.for_each_cell(segment.low, segment.high, |cell| {
            for &triangle in self.members_of(cell) {
                if !self.boxes[triangle as usize].meets(&segment) {
                    continue;
                }
                let corners =
                    self.triangles[triangle as usize].map(|corner| self.positions[corner as usize]);
                if segment_crossing(start, end, corners).is_some() {
                    crossed.push(triangle);
                }
            }
        });
        crossed.sort_unstable();
        crossed.dedup();
    }

    /// Fraction in `0..=1` of the first crossing of the segment `start → end` with the mesh.
    #[must_use]
    pub fn first_crossing(&self, start: Vec3, end: Vec3) -> Option<f32> {
        let mut first: Option<f32> = None;
        let segment = Bounds::around([start, end]);
        self.for_each_cell(segment.low, segment.high, |cell| {
            for &triangle in self.members_of(cell) {
                if !self.boxes[triangle as usize].meets(&segment) {
                    continue;
                }
                let corners =
                    self.triangles[triangle as usize].map(|corner| self.positions[corner as usize]);
                if let Some(t) = segment_crossing(start, end, corners)
                    && first.is_none_or(|held| t < held)
                {
                    first = Some(t);
                }
            }
        });
        first
    }
}

/// Value at `barycentric` of a quantity known at three corners.
#[must_use]
pub fn blend(corners: [Vec3; 3], barycentric: Vec3) -> Vec3 {
    corners[0] * barycentric.x + corners[1] * barycentric.y + corners[2] * barycentric.z
}

/// Barycentric weights of the point of a triangle nearest to `point`, by Voronoi regions of its
/// features (Ericson, "Real-Time Collision Detection", section 5.1.5).
#[must_use]
pub fn nearest_barycentric(point: Vec3, [a, b, c]: [Vec3; 3]) -> Vec3 {
    let (ab, ac, ap) = (b - a, c - a, point - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return Vec3::X;
    }
    let bp = point - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if 0.0 <= d3 && d4 <= d3 {
        return Vec3::Y;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && 0.0 <= d1 && d3 <= 0.0 && d1 != d3 {
        let t = d1 / (d1 - d3);
        return Vec3::new(1.0 - t, t, 0.0);
    }
    let cp = point - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if 0.0 <= d6 && d5 <= d6 {
        return Vec3::Z;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && 0.0 <= d2 && d6 <= 0.0 && d2 != d6 {
        let t = d2 / (d2 - d6);
        return Vec3::new(1.0 - t, 0.0, t);
    }
    let va = d3 * d6 - d5 * d4;
    let (along_bc, from_c) = (d4 - d3, d5 - d6);
    if va <= 0.0 && 0.0 <= along_bc && 0.0 <= from_c && 0.0 < along_bc + from_c {
        let t = along_bc / (along_bc + from_c);
        return Vec3::new(0.0, 1.0 - t, t);
    }
    let sum = va + vb + vc;
    if sum == 0.0 {
        return Vec3::X;
    }
    Vec3::new(va, vb, vc) / sum
}

/// Sine of the angle between a segment and a triangle below which they are parallel: `f64` rounds
/// far below it, and the `f32` corners of one plane far below one another.
const PARALLEL_SINE: f64 = 1.0e-7;

/// Fraction along `start → end` where it crosses a triangle, from either side
/// (Möller and Trumbore 1997); `None` for parallel or degenerate ones.
fn segment_crossing(start: Vec3, end: Vec3, corners: [Vec3; 3]) -> Option<f32> {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    let (start, end) = (start.as_dvec3(), end.as_dvec3());
    let direction = end - start;
    let (ab, ac) = (b - a, c - a);
    let p = direction.cross(ac);
    let determinant = ab.dot(p);
    let largest = direction.length_squared() * ab.cross(ac).length_squared();
    if determinant * determinant <= PARALLEL_SINE * PARALLEL_SINE * largest {
        return None;
    }
    let from_a = start - a;
    let u = from_a.dot(p) / determinant;
    let q = from_a.cross(ab);
    let v = direction.dot(q) / determinant;
    let t = ac.dot(q) / determinant;
    let inside = 0.0 <= u && 0.0 <= v && u + v <= 1.0 && (0.0..=1.0).contains(&t);
    #[expect(clippy::cast_possible_truncation, reason = "a fraction of a segment")]
    let t = t as f32;
    inside.then_some(t)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Repeatable numbers in `-1..1`.
    fn noise(state: &mut u64) -> f32 {
        *state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let top = u16::try_from(*state >> 48).unwrap();
        f32::from(top) / 32_768.0 - 1.0
    }

    fn soup(count: u32, state: &mut u64) -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let mut positions = Vec::new();
        for _ in 0..count {
            let center = Vec3::new(noise(state), noise(state), noise(state));
            for _ in 0..3 {
                positions.push(center + 0.1 * Vec3::new(noise(state), noise(state), noise(state)));
            }
        }
        (
            positions,
            (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
        )
    }

    #[test]
    fn the_grid_agrees_with_trying_every_triangle() {
        let mut state = 7;
        let (positions, triangles) = soup(200, &mut state);
        let grid = TriangleGrid::new(&positions, &triangles, 0.15);
        for _ in 0..300 {
            let point = Vec3::new(noise(&mut state), noise(&mut state), noise(&mut state));
            let truth = triangles
                .iter()
                .map(|t| {
                    let corners = t.map(|i| positions[i as usize]);
                    blend(corners, nearest_barycentric(point, corners)).distance(point)
                })
                .fold(f32::MAX, f32::min);
            match grid.nearest(point, 0.3) {
                Some(found) => assert!((found.distance - truth).abs() < 1e-6),
                None => assert!(truth >= 0.3),
            }
        }
    }

    #[test]
    fn no_sampled_point_of_a_triangle_is_nearer_than_the_nearest() {
        let mut state = 11;
        for _ in 0..200 {
            let mut random = || Vec3::new(noise(&mut state), noise(&mut state), noise(&mut state));
            let (corners, point) = ([random(), random(), random()], random());
            let found = blend(corners, nearest_barycentric(point, corners)).distance(point);
            for i in 0_u8..=20 {
                for j in 0_u8..=(20 - i) {
                    let (u, v) = (f32::from(i) / 20.0, f32::from(j) / 20.0);
                    let sample = blend(corners, Vec3::new(1.0 - u - v, u, v));
                    assert!(found <= sample.distance(point) + 1e-5);
                }
            }
        }
    }

    #[test]
    fn a_segment_crosses_a_plane_where_it_should() {
        let positions = [
            Vec3::new(-1.0, 0.0, -1.0),
            Vec3::new(3.0, 0.0, -1.0),
            Vec3::new(-1.0, 0.0, 3.0),
        ];
        let grid = TriangleGrid::new(&positions, &[[0, 1, 2]], 0.5);
        let hit = grid.first_crossing(Vec3::Y, Vec3::new(0.0, -3.0, 0.0));
        assert!((hit.unwrap() - 0.25).abs() < 1e-6);
        assert_eq!(grid.first_crossing(Vec3::Y, Vec3::new(0.0, 0.5, 0.0)), None);
    }

    #[test]
    fn degenerate_and_absent_triangles_are_harmless() {
        let grid = TriangleGrid::new(&[], &[], 0.1);
        assert_eq!(grid.nearest(Vec3::ZERO, 1.0), None);
        let positions = [Vec3::ONE; 3];
        let grid = TriangleGrid::new(&positions, &[[0, 1, 2]], 0.1);
        let found = grid.nearest(Vec3::ZERO, 2.0).unwrap();
        assert!((found.distance - 3.0_f32.sqrt()).abs() < 1e-6);
        assert_eq!(grid.nearest(Vec3::splat(f32::NAN), 1.0), None);
    }

    #[test]
    fn a_burst_mesh_takes_no_more_memory_than_a_large_one() {
        let far = 99.0;
        let positions = [
            Vec3::ZERO,
            Vec3::X * far,
            Vec3::Y * far,
            Vec3::new(-far, -far, far),
            Vec3::splat(f32::NAN),
        ];
        let triangles: Vec<[u32; 3]> = (0..600)
            .flat_map(|_| [[0, 1, 2], [1, 2, 3], [0, 1, 4]])
            .collect();
        let grid = TriangleGrid::new(&positions, &triangles, 0.01);
        assert!(grid.starts.len() < 5_000_000 && grid.members.len() < 30_000_000);
        let nearest = grid.nearest(Vec3::new(1.0, 1.0, 0.003), 0.1).unwrap();
        assert!((nearest.distance - 0.003).abs() < 1e-5, "{nearest:?}");
    }
}
