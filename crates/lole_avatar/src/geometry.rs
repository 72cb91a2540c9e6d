//! The meshes of a file in the pose in which they were bound: in body space, on the floor, each
//! vertex with the bones that carry it.

use glam::{Affine3A, Mat3A, Vec2, Vec3, Vec3A};
use gltf_json::mesh::{Mode, Primitive, Semantic};
use gltf_json::validation::Checked;
use gltf_json::{Index, accessor};
use lole_language::words;

use crate::AvatarError;
use crate::container::File;
use crate::rig::{Rig, skin_joints};

/// Vertices of all meshes at most.
const MOST_VERTICES: usize = 1 << 21;
/// Triangles of all meshes at most.
const MOST_TRIANGLES: usize = 1 << 22;
/// Morph targets of one mesh that are mixed in at most.
const MOST_TARGETS: usize = 1024;

/// Meshes of a file.
#[derive(Debug, Clone, Default)]
pub(crate) struct Geometry {
    /// Places in body space [m], the lowest at height 0.
    pub(crate) positions: Vec<Vec3>,
    /// Unit normals; zero where the file has none.
    pub(crate) normals: Vec<Vec3>,
    /// Texture coordinates, `v` down; zero where the file has none.
    pub(crate) uvs: Vec<Vec2>,
    /// Joints of the rig with their shares, which sum to 1; empty where no bone carries a vertex.
    pub(crate) carriers: Vec<Vec<(usize, f32)>>,
    /// Triangles by material of the file.
    pub(crate) parts: Vec<Part>,
    /// What set them on the floor [m].
    pub(crate) shift: Vec3,
    /// Meshes that are shown.
    pub(crate) mesh_count: usize,
    /// Morph targets of all meshes.
    pub(crate) morph_count: usize,
}

/// Triangles of one primitive.
#[derive(Debug, Clone)]
pub(crate) struct Part {
    /// Its material in the file.
    pub(crate) material: Option<usize>,
    /// Counter-clockwise seen from outside.
    pub(crate) triangles: Vec<[u32; 3]>,
}

/// What brings the vertices of one mesh to its bind pose.
struct Binding {
    /// For each joint of the skin, or for the node alone: the transform, and the rig's joint.
    joints: Vec<(Affine3A, Option<usize>)>,
    is_skinned: bool,
}

impl Geometry {
    /// Reads all meshes of the shown scene.
    pub(crate) fn read(file: &File<'_>, rig: &Rig) -> Result<Self, AvatarError> {
        let mut geometry = Self::default();
        for node in shown(file, rig) {
            let said = &file.root.nodes[node];
            let Some(mesh) = said.mesh else { continue };
            let mesh_said = file.root.get(mesh).ok_or_else(|| {
                AvatarError::part(
                    format!("nodes[{node}].mesh"),
                    "メッシュがありません",
                    "there is no such mesh",
                )
            })?;
            let binding = Binding::of(file, rig, node)?;
            let weights = said.weights.as_ref().or(mesh_said.weights.as_ref());
            let weights = weights.map_or(&[][..], Vec::as_slice);
            geometry.mesh_count += 1;
            for (place, primitive) in mesh_said.primitives.iter().enumerate() {
                let reader = Reader {
                    file,
                    primitive,
                    place: format!("meshes[{}].primitives[{place}]", mesh.value()),
                };
                let part = Part {
                    material: primitive.material.map(|material| material.value()),
                    triangles: Vec::new(),
                };
                geometry.add(&reader, &binding, weights, part)?;
            }
        }
        if geometry.parts.iter().all(|part| part.triangles.is_empty()) {
            return Err(AvatarError::NoMesh);
        }
        geometry.stand(rig);
        Ok(geometry)
    }

    /// Number of triangles.
    pub(crate) fn triangle_count(&self) -> usize {
        self.parts.iter().map(|part| part.triangles.len()).sum()
    }

    fn add(
        &mut self,
        reader: &Reader<'_>,
        binding: &Binding,
        weights: &[f32],
        part: Part,
    ) -> Result<(), AvatarError> {
        let targets = reader.primitive.targets.as_ref().map_or(0, Vec::len);
        self.morph_count += targets;
        let Some(positions) = reader.attribute(&Semantic::Positions) else {
            return Ok(());
        };
        let mut positions = reader.vectors(positions)?;
        reader.mix(&mut positions, weights)?;
        let count = positions.len();
        let normals = match reader.attribute(&Semantic::Normals) {
            Some(index) => reader.vectors(index)?,
            None => vec![Vec3::ZERO; count],
        };
        let uvs = match reader.attribute(&Semantic::TexCoords(0)) {
            Some(index) => {
                let uvs = reader.file.floats::<2>(index)?;
                uvs.into_iter().map(Vec2::from_array).collect()
            }
            None => vec![Vec2::ZERO; count],
        };
        let carriers = reader.carriers(binding, count)?;
        if [normals.len(), uvs.len(), carriers.len()]
            .iter()
            .any(|&len| len < count)
        {
            return Err(AvatarError::part(
                reader.place.clone(),
                "頂点の属性の個数がそろっていません",
                "its attributes differ in number",
            ));
        }
        let first = self.positions.len();
        let triangles = reader.triangles(first, count)?;
        check_limits(first + count, self.triangle_count() + triangles.len())?;
        for vertex in 0..count {
            let world = binding.blended(&carriers[vertex]);
            self.positions
                .push(world.transform_point3(positions[vertex]));
            self.normals
                .push(world.transform_vector3(normals[vertex]).normalize_or_zero());
            self.carriers.push(binding.joints_of(&carriers[vertex]));
        }
        self.uvs.extend(&uvs[..count]);
        self.parts.push(Part { triangles, ..part });
        Ok(())
    }

    /// Brings everything to body space: meters, turned to the front, on the floor, the hip joints
    /// over the middle.
    fn stand(&mut self, rig: &Rig) {
        let turn = rig.axes.world_from_file();
        let meters = rig.scene_per_bind * rig.unit.1;
        for position in &mut self.positions {
            *position = turn * *position * meters;
        }
        for normal in &mut self.normals {
            *normal = turn * *normal;
        }
        self.shift = rig.shift(self.heights()[0]);
        for position in &mut self.positions {
            *position += self.shift;
        }
    }

    /// Lowest and highest vertex of any triangle [m].
    pub(crate) fn heights(&self) -> [f32; 2] {
        let used = self.parts.iter().flat_map(|part| &part.triangles).flatten();
        let heights = used.map(|&vertex| self.positions[vertex as usize].y);
        let start = [f32::INFINITY, f32::NEG_INFINITY];
        heights.fold(start, |[low, high], y| [low.min(y), high.max(y)])
    }
}

fn check_limits(vertices: usize, triangles: usize) -> Result<(), AvatarError> {
    for (what, count, limit) in [
        (words("頂点", "vertices"), vertices, MOST_VERTICES),
        (words("三角形", "triangles"), triangles, MOST_TRIANGLES),
    ] {
        if limit < count {
            return Err(AvatarError::TooLarge {
                what,
                count: count as u64,
                limit: limit as u64,
            });
        }
    }
    Ok(())
}

/// Nodes of the shown scene; all of them where there is no scene.
fn shown(file: &File<'_>, rig: &Rig) -> Vec<usize> {
    let scene = file.root.scene.map_or(0, |scene| scene.value());
    let Some(scene) = file.root.scenes.get(scene) else {
        return rig.tree.order.clone();
    };
    let roots: Vec<usize> = scene.nodes.iter().map(|node| node.value()).collect();
    let below = |node: usize| {
        rig.tree
            .nearest(node, |node| roots.contains(&node).then_some(()))
    };
    let order = rig.tree.order.iter().copied();
    order.filter(|&node| below(node).is_some()).collect()
}

impl Binding {
    fn of(file: &File<'_>, rig: &Rig, node: usize) -> Result<Self, AvatarError> {
        let Some(skin) = file.root.nodes[node].skin else {
            return Ok(Self {
                joints: vec![(rig.binds[node], rig.joint_above(node))],
                is_skinned: false,
            });
        };
        if file.root.get(skin).is_none() {
            return Err(AvatarError::part(
                format!("nodes[{node}].skin"),
                "スキンがありません",
                "there is no such skin",
            ));
        }
        let joints = skin_joints(file, skin.value())?;
        if joints.is_empty() {
            return Err(AvatarError::part(
                format!("skins[{}]", skin.value()),
                "関節がありません",
                "it has no joints",
            ));
        }
        let joints = joints.into_iter().map(|(joint, inverse)| {
            let inverse = inverse.unwrap_or(Affine3A::IDENTITY);
            (rig.binds[joint] * inverse, rig.joint_above(joint))
        });
        Ok(Self {
            joints: joints.collect(),
            is_skinned: true,
        })
    }

    fn blended(&self, carriers: &[(usize, f32)]) -> Affine3A {
        let mut matrix3 = Mat3A::ZERO;
        let mut translation = Vec3A::ZERO;
        for &(joint, share) in carriers {
            let transform = &self.joints[joint].0;
            matrix3 += transform.matrix3 * share;
            translation += transform.translation * share;
        }
        Affine3A {
            matrix3,
            translation,
        }
    }

    /// The rig's joints of a vertex; shares of joints that no bone carries are left out, and the
    /// rest brought to 1.
    fn joints_of(&self, carriers: &[(usize, f32)]) -> Vec<(usize, f32)> {
        let mut found: Vec<(usize, f32)> = Vec::new();
        for &(place, share) in carriers {
            let Some(joint) = self.joints[place].1 else {
                continue;
            };
            match found.iter_mut().find(|(known, _)| *known == joint) {
                Some((_, sum)) => *sum += share,
                None => found.push((joint, share)),
            }
        }
        let sum: f32 = found.iter().map(|(_, share)| share).sum();
        for (_, share) in &mut found {
            *share /= sum.max(f32::MIN_POSITIVE);
        }
        found
    }
}

/// One primitive of a mesh.
struct Reader<'f> {
    file: &'f File<'f>,
    primitive: &'f Primitive,
    place: String,
}

impl Reader<'_> {
    fn attribute(&self, semantic: &Semantic) -> Option<Index<accessor::Accessor>> {
        let attributes = self.primitive.attributes.iter();
        let mut found = attributes
            .filter(|(name, _)| matches!(name, Checked::Valid(name) if name == semantic))
            .map(|(_, index)| *index);
        found.next()
    }

    fn vectors(&self, index: Index<accessor::Accessor>) -> Result<Vec<Vec3>, AvatarError> {
        let found = self.file.floats::<3>(index)?;
        Ok(found.into_iter().map(Vec3::from_array).collect())
    }

    /// Mixes in morph targets by their weights in the file's resting state.
    fn mix(&self, positions: &mut [Vec3], weights: &[f32]) -> Result<(), AvatarError> {
        let targets = self.primitive.targets.iter().flatten().take(MOST_TARGETS);
        for (target, &weight) in targets.zip(weights) {
            let Some(index) = target
                .positions
                .filter(|_| weight != 0.0 && weight.is_finite())
            else {
                continue;
            };
            for (position, offset) in positions.iter_mut().zip(self.vectors(index)?) {
                *position += offset * weight;
            }
        }
        Ok(())
    }

    /// For each vertex, places among the binding's joints with shares that sum to 1.
    fn carriers(
        &self,
        binding: &Binding,
        count: usize,
    ) -> Result<Vec<Vec<(usize, f32)>>, AvatarError> {
        let mut carriers = vec![Vec::new(); count];
        for set in 0..2 {
            let joints = self.attribute(&Semantic::Joints(set));
            let weights = self.attribute(&Semantic::Weights(set));
            let (Some(joints), Some(weights), true) = (joints, weights, binding.is_skinned) else {
                continue;
            };
            let joints = self.file.integers::<4>(joints)?;
            let weights = self.file.floats::<4>(weights)?;
            let pairs = joints.into_iter().zip(weights).zip(&mut carriers);
            for (vertex, ((joints, weights), shares)) in pairs.enumerate() {
                let joints = joints.map(|joint| joint as usize);
                let parts = joints.into_iter().zip(weights);
                shares.extend(parts.filter(|(_, weight)| 0.0 < *weight));
                if shares
                    .iter()
                    .any(|&(joint, _)| binding.joints.len() <= joint)
                {
                    return Err(AvatarError::part(
                        self.place.clone(),
                        format!("頂点 {vertex} の関節がスキンにありません"),
                        format!("the skin has not all joints of vertex {vertex}"),
                    ));
                }
            }
        }
        for shares in &mut carriers {
            let sum: f32 = shares.iter().map(|(_, share)| share).sum();
            if shares.is_empty() {
                shares.push((0, 1.0));
            } else {
                shares.iter_mut().for_each(|(_, share)| *share /= sum);
            }
        }
        Ok(carriers)
    }

    /// Triangles of whatever mode, their vertices counted from `first`.
    fn triangles(&self, first: usize, count: usize) -> Result<Vec<[u32; 3]>, AvatarError> {
        let corners: Vec<u32> = match self.primitive.indices {
            Some(index) => self.file.integers::<1>(index)?.concat(),
            None => (0..).take(count).collect(),
        };
        if corners.iter().any(|&corner| count <= corner as usize) {
            return Err(AvatarError::part(
                self.place.clone(),
                "ない頂点を指す三角形があります",
                "a triangle has a vertex that is not there",
            ));
        }
        let first = u32::try_from(first).unwrap_or(u32::MAX);
        let at = |corner: u32| corner.saturating_add(first);
        let triples: Vec<[u32; 3]> = match &self.primitive.mode {
            Checked::Valid(Mode::Triangles) => {
                let (triples, _) = corners.as_chunks::<3>();
                triples.to_vec()
            }
            Checked::Valid(Mode::TriangleStrip) => {
                let windows = corners.windows(3).enumerate();
                windows
                    .map(|(place, w)| {
                        if place % 2 == 0 {
                            [w[0], w[1], w[2]]
                        } else {
                            [w[1], w[0], w[2]]
                        }
                    })
                    .collect()
            }
            Checked::Valid(Mode::TriangleFan) => {
                let pairs = corners.get(1..).unwrap_or_default().windows(2);
                pairs.map(|pair| [corners[0], pair[0], pair[1]]).collect()
            }
            // Points and lines are no skin.
            _ => Vec::new(),
        };
        let whole = triples
            .into_iter()
            .filter(|[a, b, c]| a != b && b != c && c != a);
        Ok(whole.map(|triangle| triangle.map(at)).collect())
    }
}
