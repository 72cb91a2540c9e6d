//! What never changes of a layer: which triangles meet where, and where it ends.

use glam::Vec3;

/// Triangles of a layer, counterclockwise seen from the outside, and what follows from them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LayerShape {
    /// Corners of every triangle, shape `[triangle_count]`.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Particles on the border, shape `[particle_count]`.
    pub(super) is_border: Vec<bool>,
    /// Start of each particle's run in `around`, shape `[particle_count + 1]`.
    starts: Vec<u32>,
    /// Triangles that meet in a particle, ascending.
    around: Vec<u32>,
}

impl LayerShape {
    /// Prepares a layer of `particle_count` particles; its border is where an edge belongs to one
    /// triangle alone.
    #[must_use]
    pub fn new(triangles: &[[u32; 3]], particle_count: usize) -> Self {
        let mut starts = vec![0_u32; particle_count + 1];
        for &corner in triangles.iter().flatten() {
            starts[corner as usize + 1] += 1;
        }
        for particle in 0..particle_count {
            starts[particle + 1] += starts[particle];
        }
        let mut next = starts.clone();
        let mut around = vec![0; 3 * triangles.len()];
        for (triangle, index) in triangles.iter().zip(0_u32..) {
            for &corner in triangle {
                around[next[corner as usize] as usize] = index;
                next[corner as usize] += 1;
            }
        }
        Self {
            triangles: triangles.to_vec(),
            is_border: border(triangles, particle_count),
            starts,
            around,
        }
    }

    /// The triangles that meet in a particle.
    pub(super) fn around(&self, particle: u32) -> &[u32] {
        let particle = particle as usize;
        &self.around[self.starts[particle] as usize..self.starts[particle + 1] as usize]
    }
}

/// Particles on an edge that belongs to one triangle alone.
pub(super) fn border(triangles: &[[u32; 3]], particle_count: usize) -> Vec<bool> {
    let sides = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut sides: Vec<[u32; 2]> = sides.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    sides.sort_unstable();
    let mut is_border = vec![false; particle_count];
    for alike in sides.chunk_by(|one, other| one == other) {
        if let [[one, other]] = alike {
            is_border[*one as usize] = true;
            is_border[*other as usize] = true;
        }
    }
    is_border
}

/// Writes over `normals` the sum of the normals of the triangles around every particle, of unit
/// length or zero.
pub(super) fn write_normals(triangles: &[[u32; 3]], positions: &[Vec3], normals: &mut Vec<Vec3>) {
    normals.clear();
    normals.resize(positions.len(), Vec3::ZERO);
    for triangle in triangles {
        let [a, b, c] = triangle.map(|corner| positions[corner as usize]);
        let normal = (b - a).cross(c - a);
        for &corner in triangle {
            normals[corner as usize] += normal;
        }
    }
    for normal in normals {
        *normal = normal.normalize_or_zero();
    }
}
