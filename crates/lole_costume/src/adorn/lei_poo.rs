//! The lei poʻo: a wreath worn level around the head, over the hair.

use lole_body::{Bone, PartKind};
use lole_pattern::DraftError;

use glam::Vec3;

use super::blade::Blade;
use super::body::{Around, Girdle, bone_alone};
use super::chosen::{Chosen, whole};
use super::wreath::{Wound, wind};
use super::{Finish, Made, Wearer, flower};
use crate::document::WornTemplate;

/// Where it lies on the forehead, from the head's joint to the crown.
const FOREHEAD: f32 = 0.72;
/// How far it is lower behind, over its depth: it rests on the back of the head.
const FALL: f32 = 0.16;
/// Fern and flower of the mean woman's wreath [m].
const LEAF: [f32; 2] = [0.052, 0.019];
const FLOWER: f32 = 0.024;
/// Radius of the base [m].
const BASE: f32 = 0.006;
/// Farthest that hair reaches from the middle of the head [m]: what is knotted behind lies farther out.
const REACH: f32 = 0.115;

pub(super) fn make(worn: &WornTemplate, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
    let chosen = Chosen(worn);
    let dancer = wearer.dancer;
    let joint = dancer.skeleton.joint(Bone::Head);
    let rise = dancer.landmarks.crown_height - joint.y;
    let size = rise / 0.20;
    // The middle of the skull lies over the joint, between face and nape.
    let parts: &[PartKind] = &[PartKind::Skin, PartKind::Face, PartKind::Hair];
    let level = joint.y + FOREHEAD * rise;
    let near = super::body::vertices(dancer, parts)
        .filter(|vertex| (vertex.y - level).abs() < 0.02 && (vertex.x).abs() < 0.2);
    let [low, high] = near
        .filter(|vertex| (vertex.z - joint.z).abs() < REACH * size)
        .fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], vertex| {
            [low.min(vertex.z), high.max(vertex.z)]
        });
    let middle = if low < high {
        0.5 * (low + high)
    } else {
        joint.z
    };
    let axis = Vec3::new(0.0, 1.0, -FALL).normalize_or(Vec3::Y);
    let girdle = Girdle::new(
        dancer,
        &Around {
            center: Vec3::new(joint.x, level - 0.5 * FALL * 0.2 * size, middle),
            axis,
            front: Vec3::Z,
            half_height: 0.012 * size,
            reach: REACH * size,
            parts,
        },
        96,
    );
    let around_cm = f64::from(girdle.length()) * 100.0;
    let per_cm = |key: &str, usual: f64| whole(around_cm * chosen.number(key, usual));
    let wound = Wound {
        leaf: Blade {
            length: LEAF[0] * size,
            width: LEAF[1] * size,
            fold: 0.35,
            droop: 0.12,
            color: chosen.leaf(),
        },
        leaf_count: 2 * per_cm("leaves_per_cm_ratio", 1.0),
        flower: flower::rosette(FLOWER * size, chosen.flower(), chosen.shadow()),
        flower_count: per_cm("flowers_per_cm_ratio", 0.3),
        base: BASE * size.max(0.7),
    };
    let [leaves, flowers] = wind(&girdle, &wound);
    let head = bone_alone(Bone::Head);
    Ok(Made {
        surfaces: vec![
            leaves.ridden(Finish::Leaf, head),
            flowers.ridden(Finish::Petal, head),
        ],
        ..Made::default()
    })
}
