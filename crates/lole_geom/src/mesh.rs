//! A plain indexed triangle mesh, the common currency between body, cloth, pictures and files.

use glam::{Vec2, Vec3};

/// Indexed triangles with equal-length vertex columns.
///
/// Invariant: `normals` and `uvs` are empty or as long as `positions`; every index is in range.
/// Triangles wind counter-clockwise seen from outside.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TriangleMesh {
    /// Vertex positions [m], shape `[vertex_count, 3]`.
    pub positions: Vec<Vec3>,
    /// Unit outward normals, shape `[vertex_count, 3]`.
    pub normals: Vec<Vec3>,
    /// Texture coordinates, v down, shape `[vertex_count, 2]`.
    pub uvs: Vec<Vec2>,
    /// Vertex indices, shape `[triangle_count, 3]`.
    pub triangles: Vec<[u32; 3]>,
}

/// Area-weighted unit vertex normals of indexed triangles; zero where a vertex has no area.
#[must_use]
pub fn vertex_normals(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut normals = vec![Vec3::ZERO; positions.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|index| positions[index as usize]);
        let area_normal = (b - a).cross(c - a);
        for &index in triangle {
            normals[index as usize] += area_normal;
        }
    }
    for normal in &mut normals {
        *normal = normal.normalize_or_zero();
    }
    normals
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flat_triangle_faces_its_winding() {
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let normals = vertex_normals(&positions, &[[0, 1, 2]]);
        assert_eq!(normals, vec![Vec3::Z; 3]);
    }
}
