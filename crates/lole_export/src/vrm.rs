//! The parts of VRM 1.0 that glTF has not: who may do what with a model, its bones, its springs.

use lole_body::Bone;
use serde_json::{Value, json};

/// The license that VRM 1.0's own terms are written in.
const LICENSE: &str = "https://vrm.dev/licenses/1.0/";

/// Who made a model, and what it is called.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct VrmMeta {
    /// Its name.
    pub name: String,
    /// Who made it; at least one.
    pub authors: Vec<String>,
}

/// A joint of a chain, by its place among bones and added joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VrmJoint {
    /// Place of the joint.
    pub joint: usize,
    /// How far it keeps from colliders [m].
    pub hit_radius: f32,
    /// Pull back to where it rests.
    pub stiffness: f32,
    /// Pull downward.
    pub gravity_power: f32,
    /// Share of its motion that it loses in a frame, 0 to 1.
    pub drag_force: f32,
}

/// A chain that swings, from its root down; the last joint is its end.
#[derive(Debug, Clone, PartialEq)]
pub struct VrmSpring {
    /// Its name.
    pub name: String,
    /// Its joints.
    pub joints: Vec<VrmJoint>,
}

/// What chains keep away from: a capsule about two points off a joint [m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VrmCollider {
    /// Place of the joint that carries it.
    pub joint: usize,
    /// Both ends off that joint [m].
    pub ends: [[f32; 3]; 2],
    /// Its radius [m].
    pub radius: f32,
}

/// `VRMC_vrm`: only who made it may use it, which they may widen; every bone is one of VRM's. `blinks` is the node
/// whose mesh has closed eyes as its first shape.
#[must_use]
pub fn humanoid(meta: &VrmMeta, blinks: Option<usize>) -> Value {
    let bones = Bone::ALL.iter();
    let bones: serde_json::Map<String, Value> = bones
        .map(|bone| (bone.name().to_owned(), json!({ "node": bone.index() + 1 })))
        .collect();
    let mut humanoid = json!({
        "specVersion": "1.0",
        "meta": {
            "name": meta.name, "authors": meta.authors, "licenseUrl": LICENSE,
            "avatarPermission": "onlyAuthor", "commercialUsage": "personalNonProfit",
            "creditNotation": "required", "modification": "prohibited",
        },
        "humanoid": { "humanBones": bones },
    });
    if let Some(node) = blinks {
        humanoid["expressions"] = json!({ "preset": { "blink": {
            "morphTargetBinds": [{ "node": node, "index": 0, "weight": 1.0 }],
            "overrideBlink": "none", "overrideLookAt": "none", "overrideMouth": "none",
        }}});
    }
    humanoid
}

/// `VRMC_springBone`: every chain keeps away from every collider.
#[must_use]
pub fn spring_bone(springs: &[VrmSpring], colliders: &[VrmCollider]) -> Value {
    let shapes = colliders.iter().map(|collider| {
        let [offset, tail] = collider.ends;
        json!({ "node": collider.joint + 1, "shape": {
            "capsule": { "offset": offset, "radius": collider.radius, "tail": tail },
        }})
    });
    let shapes: Vec<Value> = shapes.collect();
    let all: Vec<usize> = (0..shapes.len()).collect();
    let springs = springs.iter().map(|spring| {
        let joints: Vec<Value> = spring.joints.iter().map(spring_joint).collect();
        json!({ "name": spring.name, "joints": joints, "colliderGroups": [0] })
    });
    let springs: Vec<Value> = springs.collect();
    json!({
        "specVersion": "1.0", "colliders": shapes,
        "colliderGroups": [{ "name": "legs", "colliders": all }],
        "springs": springs,
    })
}

fn spring_joint(joint: &VrmJoint) -> Value {
    json!({
        "node": joint.joint + 1, "hitRadius": joint.hit_radius, "stiffness": joint.stiffness,
        "gravityPower": joint.gravity_power, "gravityDir": [0.0, -1.0, 0.0],
        "dragForce": joint.drag_force,
    })
}
