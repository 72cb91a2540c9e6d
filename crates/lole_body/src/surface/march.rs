//! Marching tetrahedra: the zero surface of a lattice, watertight without case tables.
//!
//! Every cell is cut into the six tetrahedra along its main diagonal (Kuhn's subdivision), which
//! agree on shared faces, so the surface has no holes, no ambiguous cells and no doubled edges.
//! The lattice's first slice is the mirror plane: vertices on it have `x = 0` exactly.

use glam::Vec3;

use super::field::Lattice;
use super::half::HalfMesh;
use crate::sections::Tube;

/// Samples are kept at least this share of a step from zero, so that no triangle vanishes.
const KEEP_OFF: f32 = 0.06;
/// The paths from a cell's low corner to its high one, a bit per axis (1 x, 2 y, 4 z).
const PATHS: [[usize; 4]; 6] = [
    [0, 1, 3, 7],
    [0, 1, 5, 7],
    [0, 2, 3, 7],
    [0, 2, 6, 7],
    [0, 4, 5, 7],
    [0, 4, 6, 7],
];
const NO_VERTEX: u32 = u32::MAX;

struct March<'a> {
    lattice: &'a Lattice,
    /// Vertex on each lattice edge of two neighboring slices: `[slice % 2][y, z][direction]`.
    edges: [Vec<[u32; 8]>; 2],
    mesh: HalfMesh,
}

/// A lattice point: slice, row, column.
type Corner = [usize; 3];

/// The left half of the zero surface.
pub(crate) fn march(lattice: &Lattice) -> HalfMesh {
    let slice = lattice.size[1] * lattice.size[2];
    let mut march = March {
        lattice,
        edges: [vec![[NO_VERTEX; 8]; slice], vec![[NO_VERTEX; 8]; slice]],
        mesh: HalfMesh::default(),
    };
    for x in 0..lattice.size[0] - 1 {
        march.edges[(x + 1) % 2].fill([NO_VERTEX; 8]);
        for y in 0..lattice.size[1] - 1 {
            for z in 0..lattice.size[2] - 1 {
                march.cell([x, y, z]);
            }
        }
    }
    march.mesh
}

const fn corner_of([x, y, z]: Corner, bits: usize) -> Corner {
    [x + (bits & 1), y + (bits >> 1 & 1), z + (bits >> 2 & 1)]
}

impl March<'_> {
    fn value(&self, [x, y, z]: Corner) -> f32 {
        self.lattice.values[self.lattice.index(x, y, z)]
    }

    fn cell(&mut self, base: Corner) {
        let mut inside = 0;
        for bits in 0..8 {
            inside += usize::from(self.value(corner_of(base, bits)) < 0.0);
        }
        if inside == 0 || inside == 8 {
            return;
        }
        for path in PATHS {
            self.tetrahedron(base, path);
        }
    }

    fn tetrahedron(&mut self, base: Corner, path: [usize; 4]) {
        let mut sorted = path;
        sorted.sort_by_key(|&bits| self.value(corner_of(base, bits)) >= 0.0);
        let inside_count = (sorted.iter())
            .take_while(|&&bits| self.value(corner_of(base, bits)) < 0.0)
            .count();
        let (inside, outside) = sorted.split_at(inside_count);
        let mut outward = Vec3::ZERO;
        for &from in inside {
            for &to in outside {
                let (from, to) = (corner_of([0; 3], from), corner_of([0; 3], to));
                outward += Vec3::from_array(to.map(|x| x as f32))
                    - Vec3::from_array(from.map(|x| x as f32));
            }
        }
        match (inside, outside) {
            (&[i], &[a, b, c]) => {
                let triangle = [a, b, c].map(|o| self.vertex(base, [i, o]));
                self.push(triangle, outward);
            }
            (&[a, b, c], &[o]) => {
                let triangle = [a, b, c].map(|i| self.vertex(base, [i, o]));
                self.push(triangle, outward);
            }
            (&[i, j], &[o, p]) => {
                let quad = [[i, o], [i, p], [j, p], [j, o]].map(|edge| self.vertex(base, edge));
                self.push([quad[0], quad[1], quad[2]], outward);
                self.push([quad[0], quad[2], quad[3]], outward);
            }
            _ => {}
        }
    }

    fn push(&mut self, [a, b, c]: [u32; 3], outward: Vec3) {
        let [pa, pb, pc] = [a, b, c].map(|index| self.mesh.positions[index as usize]);
        let faces_out = (pb - pa).cross(pc - pa).dot(outward) > 0.0;
        let triangle = if faces_out { [a, b, c] } else { [a, c, b] };
        self.mesh.triangles.push(triangle);
    }

    /// The vertex on the edge between two corners of a cell, one of which is inside.
    fn vertex(&mut self, base: Corner, bits: [usize; 2]) -> u32 {
        let low = bits[0] & bits[1];
        let direction = bits[0] ^ bits[1];
        let from = corner_of(base, low);
        let to = corner_of(base, low | direction);
        let row = from[1] * self.lattice.size[2] + from[2];
        let known = self.edges[from[0] % 2][row][direction];
        if known != NO_VERTEX {
            return known;
        }
        let least = KEEP_OFF * self.lattice.step;
        let keep_off = |value: f32| {
            if value < 0.0 {
                value.min(-least)
            } else {
                value.max(least)
            }
        };
        let [v0, v1] = [from, to].map(|corner| keep_off(self.value(corner)));
        let [p0, p1] = [from, to].map(|[x, y, z]| self.lattice.point(x, y, z));
        let position = p0 + (p1 - p0) * (v0 / (v0 - v1));
        let inner = if v0 < 0.0 { from } else { to };
        let label: Tube = self.lattice.labels[self.lattice.index(inner[0], inner[1], inner[2])];
        let index = u32::try_from(self.mesh.positions.len()).unwrap_or(NO_VERTEX);
        self.mesh.positions.push(position);
        self.mesh.labels.push(label);
        self.edges[from[0] % 2][row][direction] = index;
        index
    }
}
