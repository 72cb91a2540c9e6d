//! Avatars and dances whose parts name each other, now and then wrongly.

use arbitrary::Unstructured;
use serde_json::{Value, json};

use crate::{choose, count, once_in};

/// Name, parent and place from there [m] of each bone of a body that is right.
const BONES: [(&str, Option<usize>, [f32; 3]); 18] = [
    ("hips", None, [0.0, 0.9, 0.0]),
    ("spine", Some(0), [0.0, 0.1, 0.0]),
    ("chest", Some(1), [0.0, 0.2, 0.0]),
    ("neck", Some(2), [0.0, 0.2, 0.0]),
    ("head", Some(3), [0.0, 0.1, 0.0]),
    ("leftUpperLeg", Some(0), [0.1, -0.05, 0.0]),
    ("leftLowerLeg", Some(5), [0.0, -0.4, 0.0]),
    ("leftFoot", Some(6), [0.0, -0.4, 0.0]),
    ("rightUpperLeg", Some(0), [-0.1, -0.05, 0.0]),
    ("rightLowerLeg", Some(8), [0.0, -0.4, 0.0]),
    ("rightFoot", Some(9), [0.0, -0.4, 0.0]),
    ("leftUpperArm", Some(2), [0.15, 0.15, 0.0]),
    ("leftLowerArm", Some(11), [0.25, 0.0, 0.0]),
    ("leftHand", Some(12), [0.25, 0.0, 0.0]),
    ("rightUpperArm", Some(2), [-0.15, 0.15, 0.0]),
    ("rightLowerArm", Some(14), [-0.25, 0.0, 0.0]),
    ("rightHand", Some(15), [-0.25, 0.0, 0.0]),
    ("jaw", Some(4), [0.0, 0.05, 0.05]),
];
/// Nodes beside the bones: they carry meshes.
const CARRIERS: usize = 3;
/// Parts of each kind, at most.
const MOST: u32 = 6;

/// Component type, type, count and size [byte] of each accessor that is right: places, normals, joints, weights,
/// corners, matrices, times, turns.
const ACCESSORS: [(u32, &str, u32, u32); 8] = [
    (5126, "VEC3", 24, 288),
    (5126, "VEC3", 24, 288),
    (5121, "VEC4", 24, 96),
    (5126, "VEC4", 24, 384),
    (5123, "SCALAR", 36, 72),
    (5126, "MAT4", 21, 1344),
    (5126, "SCALAR", 8, 32),
    (5126, "VEC4", 8, 128),
];
/// Which of them are whole numbers.
const WHOLE: [usize; 2] = [2, 4];

/// A file of the binary kind.
pub fn glb(bytes: &mut Unstructured<'_>) -> Vec<u8> {
    let mut text = document(bytes).to_string().into_bytes();
    while text.len() % 4 != 0 {
        text.push(b' ');
    }
    let data = data(bytes);
    let words = |value: usize| u32::try_from(value).unwrap_or(0).to_le_bytes();
    let mut file = b"glTF\x02\0\0\0".to_vec();
    file.extend(words(28 + text.len() + data.len()));
    file.extend(words(text.len()));
    file.extend(b"JSON");
    file.extend(text);
    file.extend(words(data.len()));
    file.extend(b"BIN\0");
    file.extend(data);
    file
}

/// What the accessors that are right look at: numbers of about the size of a body, times that grow.
fn data(bytes: &mut Unstructured<'_>) -> Vec<u8> {
    let mut data = Vec::new();
    for (accessor, (_, _, _, size)) in ACCESSORS.iter().enumerate() {
        if WHOLE.contains(&accessor) {
            data.extend(
                (0..*size)
                    .map(|at| u8::try_from((at % 2) * count(bytes, 24)).unwrap_or(0))
                    .rev(),
            );
            continue;
        }
        let mut time = 0.0_f32;
        for _ in 0..size / 4 {
            let step = f32::from(bytes.arbitrary::<u8>().unwrap_or(128)) / 128.0;
            time += step;
            let number = match accessor {
                6 => time,
                _ if once_in(bytes, 250) => {
                    *choose(bytes, &[f32::NAN, f32::INFINITY, 1e30, -1e-40])
                }
                _ => step - 1.0,
            };
            data.extend(number.to_le_bytes());
        }
    }
    data.resize(4096, 0);
    data
}

/// The number of an accessor, mostly the right one.
fn accessor_of(bytes: &mut Unstructured<'_>, right: usize) -> Value {
    if once_in(bytes, 12) {
        return index(bytes, ACCESSORS.len());
    }
    json!(right)
}

/// The number of a part, now and then of one that is not there.
fn index(bytes: &mut Unstructured<'_>, count_of_parts: usize) -> Value {
    if once_in(bytes, 200) {
        return json!(choose(bytes, &[-1_i64, 1 << 20, 0xffff_ffff, 1 << 40]));
    }
    let most = u32::try_from(count_of_parts).unwrap_or(1).saturating_sub(1);
    json!(count(bytes, most))
}

/// A size in bytes, now and then a large one.
fn size(bytes: &mut Unstructured<'_>, most: u32) -> Value {
    if once_in(bytes, 40) {
        return json!(choose(bytes, &[u64::MAX, 1 << 31, 1 << 32, 4097]));
    }
    json!(count(bytes, most))
}

fn list(
    bytes: &mut Unstructured<'_>,
    most: u32,
    mut one: impl FnMut(&mut Unstructured<'_>) -> Value,
) -> Value {
    let count = 1 + count(bytes, most - 1);
    (0..count).map(|_| one(bytes)).collect()
}

fn document(bytes: &mut Unstructured<'_>) -> Value {
    let nodes = BONES.len() + CARRIERS;
    let accessors = ACCESSORS.len();
    let views = ACCESSORS.iter().scan(0, |offset, (_, _, _, size)| {
        *offset += size;
        Some((*offset - size, *size))
    });
    let views: Vec<(u32, u32)> = views.collect();
    let bones: serde_json::Map<String, Value> = (BONES.iter().enumerate())
        .map(|(node, (bone, ..))| {
            let node = if once_in(bytes, 30) {
                index(bytes, nodes)
            } else {
                json!(node)
            };
            ((*bone).to_owned(), json!({ "node": node }))
        })
        .collect();
    let roots = [0, BONES.len(), BONES.len() + 1, BONES.len() + 2];
    let mut value = json!({
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": roots}],
        "nodes": (0..nodes).map(|number| node(bytes, number, nodes)).collect::<Vec<_>>(),
        "meshes": [mesh(bytes), mesh(bytes)],
        "skins": list(bytes, 2, |bytes| json!({
            "joints": (0..21).map(|joint| {
                if once_in(bytes, 60) { index(bytes, nodes) } else { json!(joint % BONES.len()) }
            }).collect::<Vec<_>>(),
            "inverseBindMatrices": accessor_of(bytes, 5),
            "skeleton": 0,
        })),
        "accessors": (0..accessors).map(|number| accessor(bytes, number)).collect::<Vec<_>>(),
        "bufferViews": views.iter().map(|&(offset, length)| view(bytes, offset, length)).collect::<Vec<_>>(),
        "buffers": [{"byteLength": 4096}],
        "animations": list(bytes, 3, |bytes| animation(bytes, nodes)),
        "materials": list(bytes, 2, |bytes| json!({
            "pbrMetallicRoughness": {"baseColorTexture": {"index": index(bytes, 2)}},
        })),
        "textures": [{"source": index(bytes, 2)}],
        "images": [{"bufferView": index(bytes, 8), "mimeType": "image/png"}, {"uri": "data:image/png;base64,iVBOR"}],
    });
    // Without bones of a name they are recognized by their place.
    if !once_in(bytes, 3) {
        value["extensions"] = match count(bytes, 2) {
            0 => json!({"VRMC_vrm": {"specVersion": "1.0", "meta": {"name": "n", "authors": ["a"],
                "licenseUrl": "u"}, "humanoid": {"humanBones": bones}}}),
            1 => {
                json!({"VRMC_vrm_animation": {"specVersion": "1.0", "humanoid": {"humanBones": bones}}})
            }
            _ => {
                json!({"VRM": {"specVersion": "0.0", "meta": {"title": "t"}, "humanoid": {"humanBones":
                BONES.iter().enumerate().map(|(node, (bone, ..))| json!({"bone": bone, "node": node}))
                    .collect::<Vec<_>>()}}})
            }
        };
    }
    value
}

fn node(bytes: &mut Unstructured<'_>, number: usize, nodes: usize) -> Value {
    let (name, _, place) = BONES
        .get(number)
        .copied()
        .unwrap_or(("mesh", None, [0.0; 3]));
    let children = (BONES.iter().enumerate()).filter(|(_, (_, parent, _))| *parent == Some(number));
    let mut children: Vec<Value> = children.map(|(child, _)| json!(child)).collect();
    if once_in(bytes, 40) {
        children.push(index(bytes, nodes));
    }
    let mut node = json!({"name": name});
    if !children.is_empty() {
        node["children"] = children.into();
    }
    // A node has a place or a matrix.
    if once_in(bytes, 60) {
        node["matrix"] = (0..16).map(|_| number_of(bytes)).collect();
    } else if once_in(bytes, 20) {
        node["translation"] = (0..3).map(|_| number_of(bytes)).collect();
    } else {
        node["translation"] = json!(place);
    }
    if once_in(bytes, 20) {
        node["rotation"] = (0..4).map(|_| number_of(bytes)).collect();
    }
    if number >= BONES.len() {
        node["mesh"] = json!(count(bytes, 1));
        node["skin"] = json!(0);
    }
    node
}

fn number_of(bytes: &mut Unstructured<'_>) -> Value {
    json!(choose(
        bytes,
        &[0.0, 0.1, 0.25, 0.5, 1.0, -0.1, -1.0, 1e-30, 1e30, 3.5]
    ))
}

fn mesh(bytes: &mut Unstructured<'_>) -> Value {
    let primitives = list(bytes, 3, |bytes| {
        let mut primitive = json!({"attributes": {"POSITION": accessor_of(bytes, 0)}});
        let attributes = [
            ("NORMAL", 1),
            ("TEXCOORD_0", 1),
            ("JOINTS_0", 2),
            ("WEIGHTS_0", 3),
            ("COLOR_0", 3),
        ];
        for (key, right) in attributes {
            if !once_in(bytes, 4) && key != "TEXCOORD_0" {
                primitive["attributes"][key] = accessor_of(bytes, right);
            }
        }
        if !once_in(bytes, 4) {
            primitive["indices"] = accessor_of(bytes, 4);
        }
        if once_in(bytes, 4) {
            primitive["targets"] =
                list(bytes, 3, |bytes| json!({"POSITION": accessor_of(bytes, 0)}));
        }
        primitive["mode"] = json!(choose(bytes, &[4, 4, 4, 5, 6, 0]));
        primitive
    });
    json!({ "primitives": primitives })
}

fn view(bytes: &mut Unstructured<'_>, offset: u32, length: u32) -> Value {
    let mut view = json!({"buffer": 0, "byteOffset": offset, "byteLength": length});
    if once_in(bytes, 20) {
        view["byteOffset"] = size(bytes, 4096);
        view["byteLength"] = size(bytes, 4096);
        view["byteStride"] = json!(choose(bytes, &[4, 8, 12, 16, 32, 252]));
    }
    view
}

fn accessor(bytes: &mut Unstructured<'_>, number: usize) -> Value {
    let (component, kind, count, _) = ACCESSORS[number];
    let mut accessor =
        json!({"bufferView": number, "componentType": component, "count": count, "type": kind});
    if once_in(bytes, 20) {
        accessor["bufferView"] = index(bytes, ACCESSORS.len());
        accessor["byteOffset"] = size(bytes, 64);
        accessor["componentType"] = json!(choose(bytes, &[5126, 5121, 5123, 5125, 5120, 5122]));
        accessor["count"] = size(bytes, 40);
        accessor["type"] = json!(choose(
            bytes,
            &["VEC3", "SCALAR", "VEC4", "MAT4", "VEC2", "MAT3"]
        ));
        accessor["normalized"] = json!(once_in(bytes, 4));
    }
    if once_in(bytes, 30) {
        accessor["sparse"] = json!({
            "count": size(bytes, 20),
            "indices": {"bufferView": index(bytes, 8), "componentType": choose(bytes, &[5121, 5123, 5125])},
            "values": {"bufferView": index(bytes, 8)},
        });
    }
    accessor
}

fn animation(bytes: &mut Unstructured<'_>, nodes: usize) -> Value {
    json!({
        "channels": list(bytes, MOST, |bytes| json!({
            "sampler": index(bytes, 3),
            "target": {
                "node": if once_in(bytes, 12) { index(bytes, nodes) } else { json!(count(bytes, 17)) },
                "path": choose(bytes, &["rotation", "rotation", "rotation", "translation", "scale", "weights"]),
            },
        })),
        "samplers": (0..3).map(|_| json!({
            "input": accessor_of(bytes, 6), "output": accessor_of(bytes, 7),
            "interpolation": choose(bytes, &["LINEAR", "STEP", "CUBICSPLINE"]),
        })).collect::<Vec<_>>(),
    })
}
