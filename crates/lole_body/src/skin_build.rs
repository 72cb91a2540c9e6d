//! From the half surface to the whole skin: regions cut, mirrored, weighted.

use glam::Vec3;

use crate::skin_weights::{Row, four_largest, half_weights, mirror_table, mirrored_row};
use crate::surface::Shape;
use crate::surface::half::is_on_plane;
use crate::surface::regions::Regions;
use crate::{MeshPart, PartKind, SkinnedMesh};

/// The left half with regions and dense weights.
struct Half {
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    rows: Vec<Row>,
    triangles: Vec<[u32; 3]>,
    kinds: Vec<PartKind>,
}

/// The whole body: skin, leotard and face.
pub(crate) fn build_skin(shape: &Shape) -> SkinnedMesh {
    let half = Half {
        positions: shape.positions.clone(),
        normals: shape.normals.clone(),
        rows: half_weights(shape),
        triangles: shape.triangles.clone(),
        kinds: shape.kinds.clone(),
    };
    half.mirrored(&shape.regions)
}

impl Half {
    /// The half and its mirror image, sharing the vertices on the plane.
    fn mirrored(&self, regions: &Regions) -> SkinnedMesh {
        let flip = Vec3::new(-1.0, 1.0, 1.0);
        let mirror = mirror_table();
        let mut mesh = SkinnedMesh::default();
        let mut twin = Vec::with_capacity(self.positions.len());
        for (vertex, &position) in self.positions.iter().enumerate() {
            twin.push(u32::try_from(vertex).unwrap_or(u32::MAX));
            let (joints, weights) = four_largest(&self.rows[vertex]);
            mesh.positions.push(position);
            mesh.normals.push(self.normals[vertex]);
            mesh.uvs.push(regions.face_uv(position));
            mesh.joints.push(joints);
            mesh.weights.push(weights);
        }
        for (vertex, &position) in self.positions.iter().enumerate() {
            if is_on_plane(position) {
                continue;
            }
            twin[vertex] = u32::try_from(mesh.positions.len()).unwrap_or(u32::MAX);
            let (joints, weights) = four_largest(&mirrored_row(&self.rows[vertex], &mirror));
            mesh.positions.push(position * flip);
            mesh.normals.push(self.normals[vertex] * flip);
            mesh.uvs.push(regions.face_uv(position * flip));
            mesh.joints.push(joints);
            mesh.weights.push(weights);
        }
        for kind in [PartKind::Skin, PartKind::Leotard, PartKind::Face] {
            let mut triangles = Vec::new();
            for (&[a, b, c], _) in
                (self.triangles.iter().zip(&self.kinds)).filter(|(_, k)| **k == kind)
            {
                triangles.push([a, b, c]);
                triangles.push([a, c, b].map(|vertex| twin[vertex as usize]));
            }
            mesh.parts.push(MeshPart { kind, triangles });
        }
        mesh
    }
}
