//! From a checked scene to the JSON and the bytes of a GLB.
//!
//! The JSON is put together with `serde_json` alone: the asset uses a dozen of glTF's objects, and
//! typed crates for it lag behind the extensions while the validator checks what matters.

use std::borrow::Cow;

use glam::Vec3;
use lole_body::skeleton::Bone;
use lole_geom::mesh::vertex_normals;
use serde_json::{Map, Value, json};

use super::buffer::Buffer;
use super::check::checked_frame;
use super::{
    BakedCloth, GlbFile, GlbMaterial, GlbMesh, GlbScene, GlbShape, GlbSides, MOST_TARGETS,
    skinned_cloth,
};
use crate::ExportError;

/// `glTF`, `JSON` and `BIN\0` as little-endian numbers; glTF 2.0, section 4.4.
const MAGIC: u32 = 0x4654_6c67;
const CHUNK_JSON: u32 = 0x4e4f_534a;
const CHUNK_BIN: u32 = 0x004e_4942;

/// Magnification, minification (with mip maps) and wrapping of the print's sampler.
const LINEAR: u32 = 9729;
const LINEAR_MIPMAP_LINEAR: u32 = 9987;
const REPEAT: u32 = 10_497;

/// How wide the shine of fibers spreads: that of cotton, which is neither velvet (less) nor felt (more).
const SHEEN_ROUGHNESS: f32 = 0.5;

/// The lists of the file as they grow.
#[derive(Default)]
pub(super) struct Document {
    pub(super) buffer: Buffer,
    pub(super) nodes: Vec<Value>,
    pub(super) meshes: Vec<Value>,
    pub(super) skins: Vec<Value>,
    materials: Vec<Value>,
    textures: Vec<Value>,
    images: Vec<Value>,
    samplers: Vec<Value>,
    channels: Vec<Value>,
    pub(super) roots: Vec<usize>,
    quantized: u32,
    has_sheen: bool,
}

/// Bytes of the GLB of a checked scene.
pub(super) fn write_scene(scene: &GlbScene<'_>) -> Result<GlbFile, ExportError> {
    let mut document = Document::default();
    write_skeleton(&mut document, scene);
    if !scene.skinned.is_empty() {
        let added = scene.added.iter().map(|joint| joint.place);
        let joints: Vec<Vec3> = scene.skeleton.joints.iter().copied().chain(added).collect();
        let inverse_binds = document.buffer.inverse_binds(&joints);
        let bone_nodes: Vec<usize> = (1..=joints.len()).collect();
        document.skins.push(json!({
            "name": "dancer", "skeleton": 1, "joints": bone_nodes,
            "inverseBindMatrices": inverse_binds,
        }));
    }
    for mesh in scene.skinned {
        write_skinned(&mut document, mesh);
    }
    let mut animations = Vec::new();
    animate_bones(&mut document, scene);
    let mut fits = Vec::new();
    for cloth in scene.cloths {
        if cloth.frames.count() <= MOST_TARGETS + 1 {
            write_cloth(&mut document, cloth)?;
        } else {
            fits.push(skinned_cloth::write(&mut document, cloth)?);
        }
    }
    if !document.channels.is_empty() {
        animations.push(json!({
            "name": "dance", "channels": document.channels, "samplers": document.samplers,
        }));
    }
    let mut json = document.json(animations);
    for (name, extension) in scene.extensions {
        json["extensions"][name] = extension.clone();
        match json["extensionsUsed"].as_array_mut() {
            Some(used) => used.push(json!(name)),
            None => json["extensionsUsed"] = json!([name]),
        }
    }
    let bytes = pack(&json, document.buffer.bytes)?;
    Ok(GlbFile { bytes, fits })
}

impl Document {
    /// All lists as they stand, but the skins.
    fn json(&mut self, animations: Vec<Value>) -> Value {
        let mut json = json!({
            "asset": { "version": "2.0", "generator": concat!("Lole ", env!("CARGO_PKG_VERSION")) },
            "scene": 0,
            "scenes": [{ "name": "hula", "nodes": self.roots }],
            "nodes": self.nodes,
            "bufferViews": self.buffer.views,
            "accessors": self.buffer.accessors,
            "buffers": [{ "byteLength": self.buffer.bytes.len() }],
        });
        let used = [
            (0 < self.quantized, "KHR_mesh_quantization"),
            (self.has_sheen, "KHR_materials_sheen"),
        ];
        let used = used.iter().filter(|(is_used, _)| *is_used);
        let used: Vec<&str> = used.map(|(_, name)| *name).collect();
        if !used.is_empty() {
            json["extensionsUsed"] = json!(used);
        }
        if 0 < self.quantized {
            json["extensionsRequired"] = json!(["KHR_mesh_quantization"]);
        }
        // glTF has no empty lists.
        if !self.textures.is_empty() {
            json["samplers"] = json!([{
                "magFilter": LINEAR, "minFilter": LINEAR_MIPMAP_LINEAR,
                "wrapS": REPEAT, "wrapT": REPEAT,
            }]);
        }
        let lists = [
            ("meshes", std::mem::take(&mut self.meshes)),
            ("skins", std::mem::take(&mut self.skins)),
            ("materials", std::mem::take(&mut self.materials)),
            ("textures", std::mem::take(&mut self.textures)),
            ("images", std::mem::take(&mut self.images)),
            ("animations", animations),
        ];
        for (name, list) in lists {
            if !list.is_empty() {
                json[name] = Value::Array(list);
            }
        }
        json
    }
}

/// Node 0 is the armature; the bones follow in the order of [`Bone::ALL`].
fn write_skeleton(document: &mut Document, scene: &GlbScene<'_>) {
    let node_of = |bone: Bone| bone.index() + 1;
    document.roots.push(0);
    document
        .nodes
        .push(json!({ "name": "dancer", "children": [node_of(Bone::Hips)] }));
    for &bone in Bone::ALL {
        let joint = scene.skeleton.joint(bone);
        let origin = bone
            .parent()
            .map_or(Vec3::ZERO, |parent| scene.skeleton.joint(parent));
        let mut node = json!({
            "name": bone.name(), "translation": (joint - origin).to_array(),
        });
        let bones = Bone::ALL.iter();
        let bones = bones.filter(|child| child.parent() == Some(bone));
        let bones = bones.map(|child| node_of(*child));
        let children: Vec<usize> = bones.chain(added_below(scene, bone.index())).collect();
        if !children.is_empty() {
            node["children"] = json!(children);
        }
        document.nodes.push(node);
    }
    for (place, joint) in scene.added.iter().enumerate() {
        let parent = match joint.parent.checked_sub(Bone::COUNT) {
            None => scene.skeleton.joints[joint.parent],
            Some(parent) => scene.added[parent].place,
        };
        let mut node = json!({
            "name": joint.name, "translation": (joint.place - parent).to_array(),
        });
        let children: Vec<usize> = added_below(scene, Bone::COUNT + place).collect();
        if !children.is_empty() {
            node["children"] = json!(children);
        }
        document.nodes.push(node);
    }
}

/// Nodes of the added joints below a joint.
fn added_below(scene: &GlbScene<'_>, parent: usize) -> impl Iterator<Item = usize> {
    let added = scene.added.iter().enumerate();
    let below = added.filter(move |(_, joint)| joint.parent == parent);
    below.map(|(place, _)| Bone::COUNT + place + 1)
}

/// Channels that turn the bones and carry the hips; bones that never turn get none.
fn animate_bones(document: &mut Document, scene: &GlbScene<'_>) {
    if scene.poses.is_empty() {
        return;
    }
    let input = document.buffer.times(scene.pose_times);
    let hips = scene.skeleton.joint(Bone::Hips);
    let places: Vec<f32> = scene
        .poses
        .iter()
        .flat_map(|pose| (hips + pose.hips_translation).to_array())
        .collect();
    let output = document.buffer.key_values(&places, 3, "VEC3");
    push_channel(document, [input, output], 1, "translation");
    for &bone in Bone::ALL {
        // A quaternion and its negative turn alike, but interpolation between them does not.
        let mut last = glam::Quat::IDENTITY;
        let mut turns = Vec::with_capacity(4 * scene.poses.len());
        for pose in scene.poses {
            let turn = pose.rotation(bone).normalize();
            last = if turn.dot(last) < 0.0 { -turn } else { turn };
            turns.extend_from_slice(&last.to_array());
        }
        let still = turns
            .chunks_exact(4)
            .all(|turn| turn == [0.0, 0.0, 0.0, 1.0]);
        if !still {
            let output = document.buffer.key_values(&turns, 4, "VEC4");
            push_channel(document, [input, output], bone.index() + 1, "rotation");
        }
    }
}

/// A linear animation of one property of one node.
pub(super) fn push_channel(
    document: &mut Document,
    [input, output]: [usize; 2],
    node: usize,
    path: &str,
) {
    document.channels.push(json!({
        "sampler": document.samplers.len(), "target": { "node": node, "path": path },
    }));
    document
        .samplers
        .push(json!({ "input": input, "output": output, "interpolation": "LINEAR" }));
}

/// A node of its own at the scene's root, as glTF wants skinned meshes.
fn write_skinned(document: &mut Document, mesh: &GlbMesh<'_>) {
    let buffer = &mut document.buffer;
    let weights: Vec<[f32; 4]> = mesh
        .weights
        .iter()
        .map(|weights| unit_sum(*weights))
        .collect();
    let joints: Vec<[u16; 4]> = mesh
        .joints
        .iter()
        .zip(&weights)
        .map(|(joints, weights)| used(*joints, *weights))
        .collect();
    let mut attributes = Map::new();
    attributes.insert("POSITION".into(), json!(buffer.positions(mesh.positions)));
    attributes.insert("NORMAL".into(), json!(buffer.vectors(&unit(mesh.normals))));
    let textured = mesh
        .parts
        .iter()
        .any(|part| part.material.texture_png.is_some());
    let uvs = (textured && !mesh.uvs.is_empty()).then(|| buffer.uvs(mesh.uvs));
    if !mesh.colors.is_empty() {
        attributes.insert("COLOR_0".into(), json!(buffer.vectors(mesh.colors)));
    }
    attributes.insert("JOINTS_0".into(), json!(buffer.joints(&joints)));
    attributes.insert("WEIGHTS_0".into(), json!(buffer.weights(&weights)));
    let shapes = mesh.shapes.iter().filter(|shape| !shape.moved.is_empty());
    let shapes: Vec<&GlbShape> = shapes.collect();
    let targets: Vec<Value> = (shapes.iter())
        .map(|shape| json!({ "POSITION": buffer.moves(mesh.positions.len(), &shape.moved) }))
        .collect();
    let mut primitives = Vec::new();
    for part in mesh.parts.iter().filter(|part| !part.triangles.is_empty()) {
        let indices = document.buffer.triangles(part.triangles);
        let material = write_material(document, &part.material);
        let mut attributes = attributes.clone();
        // A part without a picture has no use for the coordinates that the others share.
        if let (Some(uvs), Some(_)) = (uvs, part.material.texture_png) {
            attributes.insert("TEXCOORD_0".into(), json!(uvs));
        }
        let mut primitive = json!({
            "attributes": attributes, "indices": indices, "material": material,
        });
        if !targets.is_empty() {
            primitive["targets"] = json!(targets);
        }
        primitives.push(primitive);
    }
    if primitives.is_empty() {
        return;
    }
    let mut whole = json!({ "name": mesh.name, "primitives": primitives });
    let node = document.nodes.len();
    if !shapes.is_empty() {
        whole["weights"] = json!(vec![0.0; shapes.len()]);
        let names: Vec<&str> = shapes.iter().map(|shape| shape.name).collect();
        whole["extras"] = json!({ "targetNames": names });
        animate_shapes(document, &shapes, (mesh.shape_times, node));
    }
    document.meshes.push(whole);
    document.roots.push(node);
    document.nodes.push(json!({
        "name": mesh.name, "mesh": document.meshes.len() - 1, "skin": 0,
    }));
}

/// A channel for the shapes of a mesh, where one of them is ever on.
fn animate_shapes(document: &mut Document, shapes: &[&GlbShape], (times, node): (&[f32], usize)) {
    let at = |shape: &GlbShape, key: usize| shape.weights.get(key).copied().unwrap_or(0.0);
    let keys = 0..times.len();
    let weights: Vec<f32> = keys
        .flat_map(|key| shapes.iter().map(move |shape| at(shape, key)))
        .collect();
    if weights.iter().any(|weight| *weight != 0.0) {
        let input = document.buffer.times(times);
        let output = document.buffer.scalars(&weights);
        push_channel(document, [input, output], node, "weights");
    }
}

/// The first frame is the mesh; each later one is a morph target that is fully on at its time.
fn write_cloth(document: &mut Document, cloth: &BakedCloth<'_>) -> Result<(), ExportError> {
    let particle_count = cloth.frames.frame(0)?.len();
    let frames = (0..cloth.frames.count()).map(|frame| checked_frame(cloth, frame, particle_count));
    let frames: Vec<Cow<'_, [Vec3]>> = frames.collect::<Result<_, _>>()?;
    let base = Base::of(cloth, &frames);
    let buffer = &mut document.buffer;
    let attributes = base.attributes(buffer, cloth);
    let targets = frames[1..].iter();
    let targets: Vec<Value> = targets
        .map(|frame| base.target(buffer, cloth, frame))
        .collect();
    let indices = document.buffer.triangles(&cloth.mesh.triangles);
    let material = write_material(document, &cloth.material);
    let mut mesh = json!({
        "name": cloth.name,
        "primitives": [{ "attributes": attributes, "indices": indices, "material": material }],
    });
    let node = document.nodes.len();
    if !targets.is_empty() {
        document.quantized += 1;
        mesh["weights"] = json!(vec![0.0; targets.len()]);
        let names: Vec<String> = (1..=targets.len())
            .map(|index| format!("frame_{index:04}"))
            .collect();
        mesh["extras"] = json!({ "targetNames": names });
        let input = document.buffer.times(cloth.key_times);
        let output = document.buffer.scalars(&one_hot(targets.len()));
        push_channel(document, [input, output], node, "weights");
        mesh["primitives"][0]["targets"] = Value::Array(targets);
    }
    document.meshes.push(mesh);
    document.roots.push(node);
    let mut json = json!({ "name": cloth.name, "mesh": document.meshes.len() - 1 });
    if base.scale != 1.0 {
        json["scale"] = json!([base.scale, base.scale, base.scale]);
    }
    document.nodes.push(json);
    Ok(())
}

/// The first frame of a cloth, from which its targets are told.
struct Base {
    /// Vertices [m].
    vertices: Vec<Vec3>,
    normals: Vec<Vec3>,
    /// What a displacement of 1 stands for [m].
    scale: f32,
}

impl Base {
    fn of(cloth: &BakedCloth<'_>, frames: &[Cow<'_, [Vec3]>]) -> Self {
        Self {
            vertices: vertices(cloth, &frames[0]),
            normals: cloth.mesh.normals(&frames[0]),
            scale: displacement_scale(frames),
        }
    }

    fn attributes(&self, buffer: &mut Buffer, cloth: &BakedCloth<'_>) -> Value {
        let scaled = self.vertices.iter().map(|point| *point / self.scale);
        let mut attributes = json!({
            "POSITION": buffer.positions(&scaled.collect::<Vec<_>>()),
            "NORMAL": buffer.vectors(&self.normals),
        });
        if cloth.material.texture_png.is_some() {
            attributes["TEXCOORD_0"] = json!(buffer.uvs(&cloth.mesh.uvs));
        }
        if !cloth.colors.is_empty() {
            attributes["COLOR_0"] = json!(buffer.vectors(cloth.colors));
        }
        attributes
    }

    /// A later frame as a morph target.
    fn target(&self, buffer: &mut Buffer, cloth: &BakedCloth<'_>, frame: &[Vec3]) -> Value {
        let moved: Vec<Vec3> = vertices(cloth, frame)
            .iter()
            .zip(&self.vertices)
            .map(|(now, then)| (*now - *then) / self.scale)
            .collect();
        // A glTF normal is the base plus the weighted differences, which reach 2 in length; half
        // a byte's range is kept by clamping, for a fold that turned right over.
        let turned: Vec<Vec3> = cloth
            .mesh
            .normals(frame)
            .iter()
            .zip(&self.normals)
            .map(|(now, then)| *now - *then)
            .collect();
        json!({
            "POSITION": buffer.displacements(&moved),
            "NORMAL": buffer.turns(&turned),
        })
    }
}

/// Where the vertices of a cloth are in a frame of its particles [m].
pub(super) fn vertices(cloth: &BakedCloth<'_>, frame: &[Vec3]) -> Vec<Vec3> {
    let particles = cloth.mesh.particles.iter();
    particles
        .map(|particle| frame[*particle as usize])
        .collect()
}

/// Meters that a full displacement stands for: 1, or the power of two that reaches the farthest
/// vertex of a dance that travels. Steps are then `scale / 32767`, 0.03 mm at 1.
fn displacement_scale(frames: &[Cow<'_, [Vec3]>]) -> f32 {
    let rest = &frames[0];
    let moved = frames.iter().flat_map(|frame| frame.iter().zip(&rest[..]));
    let farthest = moved.fold(0.0_f32, |far, (now, then)| {
        far.max((*now - *then).abs().max_element())
    });
    let mut scale = 1.0;
    while scale < farthest {
        scale *= 2.0;
    }
    scale
}

/// Weights of `count` targets over `count + 1` keys: none, then one after the other.
fn one_hot(count: usize) -> Vec<f32> {
    let mut weights = vec![0.0; count * (count + 1)];
    for index in 0..count {
        weights[(index + 1) * count + index] = 1.0;
    }
    weights
}

/// Appends a material, with its texture, and gives its index.
pub(super) fn write_material(document: &mut Document, material: &GlbMaterial<'_>) -> usize {
    let [red, green, blue] = material.base_color.map(|channel| channel.clamp(0.0, 1.0));
    let mut surface = json!({
        "baseColorFactor": [red, green, blue, 1.0],
        "metallicFactor": 0.0,
        "roughnessFactor": material.roughness.clamp(0.0, 1.0),
    });
    if let Some(png) = material.texture_png {
        let view = document.buffer.picture(png);
        document.images.push(json!({
            "name": material.name, "bufferView": view, "mimeType": "image/png",
        }));
        document
            .textures
            .push(json!({ "source": document.images.len() - 1, "sampler": 0 }));
        surface["baseColorTexture"] = json!({ "index": document.textures.len() - 1 });
    }
    let mut made = json!({
        "name": material.name,
        "pbrMetallicRoughness": surface,
        "doubleSided": material.sides == GlbSides::Both,
    });
    if 0.0 < material.sheen {
        document.has_sheen = true;
        let color = [material.sheen.min(1.0); 3];
        made["extensions"] = json!({ "KHR_materials_sheen": {
            "sheenColorFactor": color, "sheenRoughnessFactor": SHEEN_ROUGHNESS,
        }});
    }
    document.materials.push(made);
    document.materials.len() - 1
}

/// Weights that sum to 1.
fn unit_sum(weights: [f32; 4]) -> [f32; 4] {
    let sum: f32 = weights.iter().sum();
    weights.map(|weight| weight / sum)
}

/// Joints of zero weight become joint 0, as glTF recommends.
fn used(joints: [u16; 4], weights: [f32; 4]) -> [u16; 4] {
    [0, 1, 2, 3].map(|slot| if 0.0 < weights[slot] { joints[slot] } else { 0 })
}

/// Unit normals; a vertex without one looks up, since glTF has no zero normals.
fn unit(normals: &[Vec3]) -> Vec<Vec3> {
    normals
        .iter()
        .map(|normal| normal.normalize_or(Vec3::Y))
        .collect()
}

impl super::GridMesh {
    /// Unit vertex normals for particle positions. They are those of the particles, so that the
    /// two sides of a seam agree.
    pub(super) fn normals(&self, particles: &[Vec3]) -> Vec<Vec3> {
        let triangles: Vec<[u32; 3]> = self
            .triangles
            .iter()
            .map(|triangle| triangle.map(|vertex| self.particles[vertex as usize]))
            .collect();
        let normals = unit(&vertex_normals(particles, &triangles));
        self.particles
            .iter()
            .map(|particle| normals[*particle as usize])
            .collect()
    }
}

/// The header, the JSON chunk and the binary chunk.
fn pack(json: &Value, mut binary: Vec<u8>) -> Result<Vec<u8>, ExportError> {
    let mut text = json.to_string().into_bytes();
    while !text.len().is_multiple_of(4) {
        text.push(b' ');
    }
    while !binary.len().is_multiple_of(4) {
        binary.push(0);
    }
    let total = 12 + 8 + text.len() + 8 + binary.len();
    let too_large = || ExportError::TooLarge { bytes: total };
    let size = |length: usize| u32::try_from(length).map_err(|_| too_large());
    let mut bytes = Vec::with_capacity(total);
    for word in [MAGIC, 2, size(total)?, size(text.len())?, CHUNK_JSON] {
        bytes.extend_from_slice(&word.to_le_bytes());
    }
    bytes.append(&mut text);
    for word in [size(binary.len())?, CHUNK_BIN] {
        bytes.extend_from_slice(&word.to_le_bytes());
    }
    bytes.append(&mut binary);
    Ok(bytes)
}
