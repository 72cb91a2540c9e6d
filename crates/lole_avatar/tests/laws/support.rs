//! The product's own dancer written as a file of another program would be: the truth that reading
//! is held against.

use glam::{Mat4, Quat, Vec3};
use lole_body::{Bone, Dancer, Measurements, Pose, Skeleton};
use serde_json::{Value, json};

/// How the other program writes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Manner {
    /// Kind of file.
    pub(crate) kind: Kind,
    /// Turn from the product's space to the file's.
    pub(crate) file_from_world: Quat,
    /// File units of one meter.
    pub(crate) units_per_meter: f32,
    /// Turn of every node's own axes at rest.
    pub(crate) axes: Quat,
    /// What nodes are called.
    pub(crate) name: fn(Bone) -> String,
}

/// Kinds of files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Gltf,
    Vrm0,
    Vrm1,
    Vrma,
}

impl Default for Manner {
    fn default() -> Self {
        Self {
            kind: Kind::Gltf,
            file_from_world: Quat::IDENTITY,
            units_per_meter: 1.0,
            axes: Quat::IDENTITY,
            name: |bone| bone.name().to_owned(),
        }
    }
}

/// The dancer that all tests share.
pub(crate) fn dancer() -> &'static Dancer {
    static DANCER: std::sync::LazyLock<Dancer> = std::sync::LazyLock::new(|| {
        Dancer::new(&Measurements::woman()).expect("the default woman can be built")
    });
    &DANCER
}

/// A file of the folder that `LOLE_ASSETS` names; `None`, with the reason said, where there is none.
#[expect(clippy::print_stderr, reason = "says why nothing was tested")]
pub(crate) fn asset(name: &str) -> Option<Vec<u8>> {
    let found = std::env::var("LOLE_ASSETS")
        .map_err(|error| error.to_string())
        .and_then(|folder| {
            let path = std::path::Path::new(&folder).join(name);
            std::fs::read(path).map_err(|error| error.to_string())
        });
    match found {
        Ok(bytes) => Some(bytes),
        Err(error) => {
            eprintln!("skipped: LOLE_ASSETS names no folder with {name} ({error})");
            None
        }
    }
}

/// A GLB that is being written.
#[derive(Default)]
pub(crate) struct Writer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Writer {
    /// Adds numbers of `kind` as an accessor.
    pub(crate) fn floats(&mut self, kind: &str, parts: usize, values: &[f32]) -> usize {
        let bytes: Vec<u8> = values
            .iter()
            .flat_map(|value| value.to_le_bytes())
            .collect();
        self.add(&bytes, 5126, kind, values.len() / parts)
    }

    fn add(&mut self, bytes: &[u8], component: u32, kind: &str, count: usize) -> usize {
        self.views.push(json!({
            "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len(),
        }));
        self.bytes.extend(bytes);
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        self.accessors.push(json!({
            "bufferView": self.views.len() - 1, "componentType": component, "type": kind,
            "count": count,
        }));
        self.accessors.len() - 1
    }

    /// The file, around the text's other parts.
    pub(crate) fn finish(self, mut text: Value) -> Vec<u8> {
        text["asset"] = json!({"version": "2.0", "generator": "the tests"});
        text["buffers"] = json!([{ "byteLength": self.bytes.len() }]);
        text["bufferViews"] = Value::Array(self.views);
        text["accessors"] = Value::Array(self.accessors);
        glb(&text.to_string(), &self.bytes)
    }
}

/// Text and bytes as a GLB.
pub(crate) fn glb(text: &str, bytes: &[u8]) -> Vec<u8> {
    let mut text = text.as_bytes().to_vec();
    text.resize(text.len().next_multiple_of(4), b' ');
    let size = |length: usize| u32::try_from(length).expect("a small file").to_le_bytes();
    let mut file = b"glTF\x02\0\0\0".to_vec();
    file.extend(size(28 + text.len() + bytes.len()));
    file.extend(size(text.len()));
    file.extend(b"JSON");
    file.extend(text);
    file.extend(size(bytes.len()));
    file.extend(b"BIN\0");
    file.extend(bytes);
    file
}

/// Nodes of a skeleton, hips first, and the transform of each at rest.
fn nodes(skeleton: &Skeleton, manner: &Manner) -> (Vec<Value>, Vec<Mat4>) {
    let turn = manner.file_from_world * manner.axes;
    let world: Vec<Mat4> = (Bone::ALL.iter())
        .map(|&bone| {
            let place = manner.file_from_world * skeleton.joint(bone) * manner.units_per_meter;
            Mat4::from_rotation_translation(turn, place)
        })
        .collect();
    let nodes = Bone::ALL.iter().map(|&bone| {
        let local = match bone.parent() {
            Some(parent) => world[parent.index()].inverse() * world[bone.index()],
            None => world[bone.index()],
        };
        let (_, rotation, translation) = local.to_scale_rotation_translation();
        let children: Vec<usize> = (Bone::ALL.iter())
            .filter(|child| child.parent() == Some(bone))
            .map(|child| child.index())
            .collect();
        let mut node = json!({
            "name": (manner.name)(bone),
            "translation": translation.to_array(),
            "rotation": rotation.to_array(),
        });
        if !children.is_empty() {
            node["children"] = json!(children);
        }
        node
    });
    (nodes.collect(), world)
}

/// The extension that says which node is which bone.
fn extension(kind: Kind) -> Value {
    let table: serde_json::Map<String, Value> = (Bone::ALL.iter())
        .map(|bone| (bone.name().to_owned(), json!({ "node": bone.index() })))
        .collect();
    match kind {
        Kind::Gltf => json!({}),
        Kind::Vrm1 => json!({ "VRMC_vrm": {
            "specVersion": "1.0",
            "meta": {
                "name": "own", "authors": ["the tests"], "avatarPermission": "everyone",
                "allowRedistribution": true, "modification": "allowModificationRedistribution",
                "creditNotation": "unnecessary",
            },
            "humanoid": { "humanBones": table },
        } }),
        Kind::Vrma => json!({ "VRMC_vrm_animation": {
            "specVersion": "1.0", "humanoid": { "humanBones": table },
        } }),
        Kind::Vrm0 => {
            let renamed = |name: &str| {
                name.replace("ThumbProximal", "ThumbIntermediate")
                    .replace("ThumbMetacarpal", "ThumbProximal")
            };
            let list: Vec<Value> = (Bone::ALL.iter())
                .map(|bone| json!({ "bone": renamed(bone.name()), "node": bone.index() }))
                .collect();
            json!({ "VRM": {
                "specVersion": "0.0",
                "meta": { "title": "own", "author": "the tests", "licenseName": "CC0" },
                "humanoid": { "humanBones": list },
            } })
        }
    }
}

/// A file in which `skeleton` dances `poses`, sixty a second.
pub(crate) fn write_dance(skeleton: &Skeleton, poses: &[Pose], manner: &Manner) -> Vec<u8> {
    let (nodes, rest) = nodes(skeleton, manner);
    let mut writer = Writer::default();
    let times: Vec<f32> = (0..poses.len()).map(|frame| frame as f32 / 60.0).collect();
    let input = writer.floats("SCALAR", 1, &times);
    let (mut channels, mut samplers) = (Vec::new(), Vec::new());
    let worlds: Vec<Vec<Mat4>> = poses
        .iter()
        .map(|pose| {
            let moved = skeleton.world_from_bind(pose);
            let file = Mat4::from_scale_rotation_translation(
                Vec3::splat(manner.units_per_meter),
                manner.file_from_world,
                Vec3::ZERO,
            );
            let placed = moved.iter().zip(&rest);
            placed
                .map(|(moved, rest)| file * Mat4::from(*moved) * file.inverse() * *rest)
                .collect()
        })
        .collect();
    for &bone in Bone::ALL {
        let locals = worlds.iter().map(|world: &Vec<Mat4>| match bone.parent() {
            Some(parent) => world[parent.index()].inverse() * world[bone.index()],
            None => world[bone.index()],
        });
        let locals: Vec<_> = locals
            .map(|local| local.to_scale_rotation_translation())
            .collect();
        let turns: Vec<f32> = locals
            .iter()
            .flat_map(|(_, turn, _)| turn.to_array())
            .collect();
        let mut outputs = vec![("rotation", writer.floats("VEC4", 4, &turns))];
        if bone == Bone::Hips {
            let ways: Vec<f32> = locals.iter().flat_map(|(.., way)| way.to_array()).collect();
            outputs.push(("translation", writer.floats("VEC3", 3, &ways)));
        }
        for (path, output) in outputs {
            channels.push(json!({
                "sampler": samplers.len(), "target": { "node": bone.index(), "path": path },
            }));
            samplers.push(json!({ "input": input, "output": output }));
        }
    }
    writer.finish(json!({
        "scene": 0, "scenes": [{ "nodes": [0] }], "nodes": nodes,
        "animations": [{ "name": "dance", "channels": channels, "samplers": samplers }],
        "extensions": extension(manner.kind),
    }))
}

/// The product's dancer with her skin, as an avatar of `manner`; seams are cut as files have them:
/// each part has its own vertices.
pub(crate) fn write_avatar(manner: &Manner) -> Vec<u8> {
    let (skeleton, skin) = (&dancer().skeleton, &dancer().skin);
    let (mut nodes, rest) = nodes(skeleton, manner);
    let mut writer = Writer::default();
    let file = Mat4::from_scale_rotation_translation(
        Vec3::splat(manner.units_per_meter),
        manner.file_from_world,
        Vec3::ZERO,
    );
    let mut primitives = Vec::new();
    for part in &skin.parts {
        let mut vertices: Vec<u32> = part.triangles.iter().flatten().copied().collect();
        vertices.sort_unstable();
        vertices.dedup();
        let corners: Vec<u32> = (part.triangles.iter().flatten())
            .map(|vertex| {
                let place = vertices.binary_search(vertex).expect("it is among them");
                u32::try_from(place).expect("a small mesh")
            })
            .collect();
        let of = |column: &dyn Fn(usize) -> Vec<f32>| -> Vec<f32> {
            vertices
                .iter()
                .flat_map(|&vertex| column(vertex as usize))
                .collect()
        };
        let places = of(&|vertex| {
            file.transform_point3(skin.positions[vertex])
                .to_array()
                .into()
        });
        let normals = of(&|vertex| {
            (manner.file_from_world * skin.normals[vertex])
                .to_array()
                .into()
        });
        let weights = of(&|vertex| skin.weights[vertex].to_vec());
        let joints: Vec<u8> = (vertices.iter())
            .flat_map(|&vertex| skin.joints[vertex as usize])
            .flat_map(u16::to_le_bytes)
            .collect();
        let indices: Vec<u8> = corners
            .iter()
            .flat_map(|corner| corner.to_le_bytes())
            .collect();
        primitives.push(json!({
            "attributes": {
                "POSITION": writer.floats("VEC3", 3, &places),
                "NORMAL": writer.floats("VEC3", 3, &normals),
                "WEIGHTS_0": writer.floats("VEC4", 4, &weights),
                "JOINTS_0": writer.add(&joints, 5123, "VEC4", vertices.len()),
            },
            "indices": writer.add(&indices, 5125, "SCALAR", corners.len()),
        }));
    }
    let inverses: Vec<f32> = rest
        .iter()
        .flat_map(|rest| rest.inverse().to_cols_array())
        .collect();
    let inverses = writer.floats("MAT4", 16, &inverses);
    let joints: Vec<usize> = (0..Bone::COUNT).collect();
    nodes.push(json!({ "name": "Body", "mesh": 0, "skin": 0 }));
    writer.finish(json!({
        "scene": 0, "scenes": [{ "nodes": [0, Bone::COUNT] }], "nodes": nodes,
        "meshes": [{ "name": "Body", "primitives": primitives }],
        "skins": [{ "joints": joints, "inverseBindMatrices": inverses }],
        "extensions": extension(manner.kind),
    }))
}
