//! Marching cubes: the zero surface of a lattice, watertight, with cases traced and not listed.
//!
//! On each face of a cell the crossings are joined around every run of inner corners; since a face
//! looks the same from both its cells, the surface has no holes. No triangle side crosses a face
//! but along such a segment, so no edge has more than two triangles.
//! The lattice's first slice is the mirror plane: vertices on it have `x = 0` exactly.

use super::field::Lattice;
use super::half::HalfMesh;
use crate::sections::Tube;

/// Samples are kept at least this share of a step from zero, so that no triangle vanishes.
const KEEP_OFF: f32 = 0.06;
/// Faces of a cell: corners in order, counter-clockwise seen from outside. A corner has a bit for
/// each axis (1 x, 2 y, 4 z).
const FACES: [[usize; 4]; 6] = [
    [0, 4, 6, 2],
    [1, 3, 7, 5],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 2, 3, 1],
    [4, 5, 7, 6],
];
const NO_VERTEX: u32 = u32::MAX;

/// A lattice point: slice, row, column.
type Corner = [usize; 3];

/// An edge of a cell: its lower corner, and the axis along which it runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct CellEdge {
    low: usize,
    axis: usize,
}

/// Triangles of a cell, corners on its edges, counter-clockwise seen from outside the body.
type Case = Vec<[CellEdge; 3]>;

impl CellEdge {
    const fn between(a: usize, b: usize) -> Self {
        Self {
            low: a & b,
            axis: (a ^ b).trailing_zeros() as usize,
        }
    }

    const fn corners(self) -> [usize; 2] {
        [self.low, self.low | 1 << self.axis]
    }

    /// Whether one face of the cell has both edges.
    fn shares_face(self, other: Self) -> bool {
        let holds = |face: &[usize; 4], edge: Self| {
            edge.corners().iter().all(|corner| face.contains(corner))
        };
        (FACES.iter()).any(|face| holds(face, self) && holds(face, other))
    }
}

/// The triangles of a cell whose corners `inside` (a bit each) lie inside.
fn case(inside: usize) -> Case {
    let is_inside = |corner: usize| inside >> corner & 1 == 1;
    let mut segments: Vec<[CellEdge; 2]> = Vec::new();
    for face in FACES {
        for last in 0..4 {
            if !is_inside(face[last]) || is_inside(face[(last + 1) % 4]) {
                continue;
            }
            let first = (0..4)
                .map(|back| (last + 4 - back) % 4)
                .find(|&corner| !is_inside(face[(corner + 3) % 4]))
                .unwrap_or(last);
            let leaves = CellEdge::between(face[last], face[(last + 1) % 4]);
            let enters = CellEdge::between(face[(first + 3) % 4], face[first]);
            segments.push([enters, leaves]);
        }
    }
    let mut triangles = Vec::new();
    while let Some([start, mut end]) = segments.pop() {
        let mut polygon = vec![start];
        while end != start {
            polygon.push(end);
            let Some(next) = segments.iter().position(|segment| segment[0] == end) else {
                break;
            };
            end = segments.swap_remove(next)[1];
        }
        triangles.extend(triangulated(&polygon).unwrap_or_default());
    }
    triangles
}

/// A polygon cut into triangles so that no cut lies in a face of the cell; `None` where that is
/// not possible, which no case is.
fn triangulated(polygon: &[CellEdge]) -> Option<Case> {
    let &[first, .., last] = polygon else {
        return Some(Vec::new());
    };
    if polygon.len() < 3 {
        return Some(Vec::new());
    }
    (1..polygon.len() - 1).find_map(|apex| {
        let allowed = |from: usize, to: usize, end: CellEdge| {
            to - from < 2 || !end.shares_face(polygon[apex])
        };
        if !allowed(0, apex, first) || !allowed(apex, polygon.len() - 1, last) {
            return None;
        }
        let mut triangles = vec![[first, polygon[apex], last]];
        triangles.extend(triangulated(&polygon[..=apex])?);
        triangles.extend(triangulated(&polygon[apex..])?);
        Some(triangles)
    })
}

struct March<'a> {
    lattice: &'a Lattice,
    /// Vertex on each lattice edge of two neighboring slices: `[slice % 2][y, z][axis]`.
    edges: [Vec<[u32; 3]>; 2],
    mesh: HalfMesh,
}

/// The left half of the zero surface.
pub(crate) fn march(lattice: &Lattice) -> HalfMesh {
    let cases: Vec<Case> = (0..256).map(case).collect();
    let [slices, rows, columns] = lattice.size;
    let no_edges = vec![[NO_VERTEX; 3]; rows * columns];
    let mut march = March {
        lattice,
        edges: [no_edges.clone(), no_edges],
        mesh: HalfMesh::default(),
    };
    for x in 0..slices - 1 {
        march.edges[(x + 1) % 2].fill([NO_VERTEX; 3]);
        for y in 0..rows - 1 {
            let has_inside = |x: usize| {
                let row = x * rows + y;
                lattice.is_row_inside[row] || lattice.is_row_inside[row + 1]
            };
            if has_inside(x) || has_inside(x + 1) {
                march.row(&cases, x, y);
            }
        }
    }
    march.mesh
}

impl March<'_> {
    /// The cells of one row.
    fn row(&mut self, cases: &[Case], x: usize, y: usize) {
        let columns = self.lattice.size[2];
        let lines = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[dx, dy]| {
            let start = self.lattice.index(x + dx, y + dy, 0);
            &self.lattice.values[start..start + columns]
        });
        let inside = |z: usize| {
            (lines.iter().enumerate())
                .map(|(bit, line)| usize::from(line[z] < 0.0) << bit)
                .sum::<usize>()
        };
        let mut near = inside(0);
        for z in 0..columns - 1 {
            let far = inside(z + 1);
            for triangle in &cases[near | far << 4] {
                let corners = triangle.map(|edge| self.vertex([x, y, z], edge));
                self.mesh.triangles.push(corners);
            }
            near = far;
        }
    }

    /// The vertex on an edge of a cell, one end of which is inside.
    fn vertex(&mut self, [x, y, z]: Corner, edge: CellEdge) -> u32 {
        let [from, to] =
            (edge.corners()).map(|bits| [x + (bits & 1), y + (bits >> 1 & 1), z + (bits >> 2 & 1)]);
        let row = from[1] * self.lattice.size[2] + from[2];
        let known = self.edges[from[0] % 2][row][edge.axis];
        if known != NO_VERTEX {
            return known;
        }
        let least = KEEP_OFF * self.lattice.step;
        let index_of = |[x, y, z]: Corner| self.lattice.index(x, y, z);
        let [v0, v1] = [from, to].map(|corner| {
            let value = self.lattice.values[index_of(corner)];
            if value < 0.0 {
                value.min(-least)
            } else {
                value.max(least)
            }
        });
        let [p0, p1] = [from, to].map(|[x, y, z]| self.lattice.point(x, y, z));
        let position = p0 + (p1 - p0) * (v0 / (v0 - v1));
        let inner = if v0 < 0.0 { from } else { to };
        let label: Tube = self.lattice.labels[index_of(inner)];
        let index = u32::try_from(self.mesh.positions.len()).unwrap_or(NO_VERTEX);
        self.mesh.positions.push(position);
        self.mesh.labels.push(label);
        self.edges[from[0] % 2][row][edge.axis] = index;
        index
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    /// Every crossing of every case is used, and no cut lies in a face.
    #[test]
    fn every_case_is_cut_inside_its_cell() {
        for inside in 0..256_usize {
            let triangles = case(inside);
            let is_inside = |corner: usize| inside >> corner & 1 == 1;
            let mut sides: Vec<[CellEdge; 2]> = (triangles.iter())
                .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
                .collect();
            let crossings = (0..8_usize)
                .flat_map(|corner| [1, 2, 4].map(|bit| (corner, corner | bit)))
                .filter(|&(a, b)| a != b && is_inside(a) != is_inside(b));
            for (a, b) in crossings {
                let edge = CellEdge::between(a, b);
                assert!(triangles.iter().flatten().any(|&used| used == edge));
            }
            // What two triangles share is inside the cell; what is left runs along faces.
            while let Some([a, b]) = sides.pop() {
                let twin = sides.iter().position(|&side| side == [b, a]);
                assert_eq!(twin.is_none(), a.shares_face(b), "case {inside}");
                if let Some(twin) = twin {
                    sides.swap_remove(twin);
                }
            }
        }
    }

    #[test]
    fn a_ball_on_the_plane_is_a_disk_of_its_area() {
        let (step, radius) = (0.01, 0.1);
        let size = [13, 25, 25];
        let mut lattice = Lattice {
            origin: Vec3::new(0.0, -0.12, -0.12),
            step,
            size,
            values: Vec::new(),
            labels: vec![Tube::Torso; 13 * 25 * 25],
            is_row_inside: vec![true; 13 * 25],
        };
        for x in 0..size[0] {
            for y in 0..size[1] {
                for z in 0..size[2] {
                    let distance = lattice.point(x, y, z).length() - radius;
                    lattice.values.push(distance);
                }
            }
        }
        let mesh = march(&lattice);
        assert_eq!(mesh.euler_characteristic(), 1);
        let area: f32 = (mesh.triangles.iter())
            .map(|triangle| {
                let [a, b, c] = triangle.map(|vertex| mesh.positions[vertex as usize]);
                let cross = (b - a).cross(c - a);
                assert!(cross.dot(a + b + c) > 0.0, "a triangle faces inwards");
                0.5 * cross.length()
            })
            .sum();
        let half_sphere = std::f32::consts::TAU * radius * radius;
        assert!((area / half_sphere - 1.0).abs() < 0.01, "area {area}");
    }
}
