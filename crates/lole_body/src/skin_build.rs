//! From the half surface to the whole skin: regions cut, mirrored, weighted, and the centers about
//! which knees turn.

use glam::Vec3;

use crate::skin::Turning;
use crate::skin_weights::{Row, four_largest, half_weights, mirror_table, mirrored_row};
use crate::surface::Shape;
use crate::surface::half::is_on_plane;
use crate::surface::regions::Regions;
use crate::{Bone, MeshPart, PartKind, SkinnedMesh};

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
    let mut skin = half.mirrored(&shape.regions);
    skin.turning = turning(&skin);
    skin
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

/// The bones of the knees. Elbows keep their section without, and fold deeper into themselves with it.
const HINGES: [[Bone; 2]; 2] = [
    [Bone::LeftUpperLeg, Bone::LeftLowerLeg],
    [Bone::RightUpperLeg, Bone::RightLowerLeg],
];
/// Vertices that one of the two bones carries less than this are left to linear blending.
const LEAST_SHARE: f32 = 0.004;
/// How far apart shares are that still count as alike.
const ALIKE: f32 = 0.12;

/// Vertices that both bones of a hinge carry, and nothing else, with their centers.
fn turning(skin: &SkinnedMesh) -> Vec<Turning> {
    let areas = areas(skin);
    let mut turning = Vec::new();
    for [upper, lower] in HINGES.map(|bones| bones.map(Bone::index)) {
        let shared: Vec<(usize, f32)> = (0..skin.positions.len())
            .filter_map(|vertex| {
                let share = |bone: usize| {
                    let carried = skin.joints[vertex].iter().zip(skin.weights[vertex]);
                    let of_bone = carried.filter(|(joint, _)| usize::from(**joint) == bone);
                    of_bone.map(|(_, weight)| weight).sum::<f32>()
                };
                let [above, below] = [share(upper), share(lower)];
                let is_shared = above.min(below) > LEAST_SHARE && above + below > 0.999;
                is_shared.then_some((vertex, below))
            })
            .collect();
        for &(vertex, share) in &shared {
            let (mut sum, mut total) = (Vec3::ZERO, 0.0);
            for &(other, other_share) in &shared {
                let apart = (share - other_share) / ALIKE;
                let weight = areas[other] * (1.0 - apart * apart).max(0.0);
                sum += skin.positions[other] * weight;
                total += weight;
            }
            turning.push(Turning {
                vertex: u32::try_from(vertex).unwrap_or(u32::MAX),
                center: sum / total.max(f32::MIN_POSITIVE),
            });
        }
    }
    turning.sort_by_key(|turning| turning.vertex);
    turning
}

/// Area around each vertex [m²], times 6.
fn areas(skin: &SkinnedMesh) -> Vec<f32> {
    let mut areas = vec![0.0; skin.positions.len()];
    for triangle in skin.body_triangles() {
        let [a, b, c] = triangle.map(|vertex| skin.positions[vertex as usize]);
        for vertex in triangle {
            areas[vertex as usize] += (b - a).cross(c - a).length();
        }
    }
    areas
}
