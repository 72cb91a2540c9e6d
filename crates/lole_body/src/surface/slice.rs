//! Slicing a mesh along the zero line of a function of position: both sides share the new
//! vertices, so a closed surface stays closed.

use std::collections::BTreeMap;

/// A crossing nearer to an end of its edge than this share uses the end: no slivers.
const SNAP: f32 = 0.06;

/// A vertex of the sliced mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Cut {
    /// An old vertex.
    Kept(u32),
    /// A share of the way from one old vertex to another.
    Between(u32, u32, f32),
}

/// The sliced mesh: old vertices first, then the new ones.
pub(crate) struct Sliced {
    pub(crate) vertices: Vec<Cut>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Whether the function is positive on each triangle.
    pub(crate) is_positive: Vec<bool>,
    /// The old triangle each one is a piece of.
    pub(crate) parents: Vec<u32>,
}

struct Slicer {
    values: Vec<f32>,
    vertices: Vec<Cut>,
    crossings: BTreeMap<(u32, u32), u32>,
}

/// Slices `triangles` where the linear interpolation of `values` at the vertices is 0.
pub(crate) fn slice(triangles: &[[u32; 3]], values: &[f32]) -> Sliced {
    let vertices = (0..values.len())
        .map(|vertex| Cut::Kept(u32::try_from(vertex).unwrap_or(u32::MAX)))
        .collect();
    let mut slicer = Slicer {
        values: snapped(triangles, values),
        vertices,
        crossings: BTreeMap::new(),
    };
    let mut sliced = Sliced {
        vertices: Vec::new(),
        triangles: Vec::with_capacity(triangles.len()),
        is_positive: Vec::with_capacity(triangles.len()),
        parents: Vec::with_capacity(triangles.len()),
    };
    for (parent, &triangle) in triangles.iter().enumerate() {
        let (pieces, count) = slicer.pieces(triangle);
        for &piece in &pieces[..count] {
            let sum: f32 = piece.iter().map(|&vertex| slicer.value(vertex)).sum();
            sliced.triangles.push(piece);
            sliced
                .parents
                .push(u32::try_from(parent).unwrap_or(u32::MAX));
            sliced.is_positive.push(sum > 0.0);
        }
    }
    sliced.vertices = slicer.vertices;
    sliced
}

/// Values with those of vertices that lie almost on the line set to 0.
fn snapped(triangles: &[[u32; 3]], values: &[f32]) -> Vec<f32> {
    let mut snapped = values.to_vec();
    for &[a, b, c] in triangles {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let (v0, v1) = (values[from as usize], values[to as usize]);
            if v0 * v1 < 0.0 {
                let share = v0 / (v0 - v1);
                if share < SNAP {
                    snapped[from as usize] = 0.0;
                } else if share > 1.0 - SNAP {
                    snapped[to as usize] = 0.0;
                }
            }
        }
    }
    snapped
}

impl Slicer {
    fn value(&self, vertex: u32) -> f32 {
        self.values.get(vertex as usize).copied().unwrap_or(0.0)
    }

    /// One to three triangles that cover `triangle`, none of which crosses the line, and how many.
    fn pieces(&mut self, triangle: [u32; 3]) -> ([[u32; 3]; 3], usize) {
        for turn in 0..3 {
            // `a` alone on its side: both its edges may be cut.
            let [a, b, c] = [0, 1, 2].map(|corner| triangle[(corner + turn) % 3]);
            let [va, vb, vc] = [a, b, c].map(|vertex| self.value(vertex));
            if va * vb < 0.0 && va * vc < 0.0 {
                let (ab, ca) = (self.crossing(a, b), self.crossing(c, a));
                return ([[a, ab, ca], [ab, b, c], [ab, c, ca]], 3);
            }
            if va == 0.0 && vb * vc < 0.0 {
                let bc = self.crossing(b, c);
                return ([[a, b, bc], [a, bc, c], [0; 3]], 2);
            }
        }
        ([triangle, [0; 3], [0; 3]], 1)
    }

    fn crossing(&mut self, a: u32, b: u32) -> u32 {
        let (low, high) = (a.min(b), a.max(b));
        if let Some(&vertex) = self.crossings.get(&(low, high)) {
            return vertex;
        }
        let (v0, v1) = (self.value(low), self.value(high));
        let vertex = u32::try_from(self.vertices.len()).unwrap_or(u32::MAX);
        self.vertices.push(Cut::Between(low, high, v0 / (v0 - v1)));
        self.crossings.insert((low, high), vertex);
        vertex
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_sides_share_the_new_vertices() {
        let triangles = [[0, 1, 2], [0, 2, 3]];
        let sliced = slice(&triangles, &[-1.0, 1.0, 1.0, -1.0]);
        assert_eq!(sliced.vertices.len(), 4 + 3);
        assert_eq!(sliced.triangles.len(), 6);
        assert_eq!(
            sliced
                .is_positive
                .iter()
                .filter(|&&positive| positive)
                .count(),
            3
        );
    }
}
