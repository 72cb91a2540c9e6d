//! Where a layer ends, and which way it faces.

use glam::Vec3;

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
