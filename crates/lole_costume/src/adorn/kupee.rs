//! Kūpeʻe: bands of leaves around wrists and ankles.

use glam::Vec3;
use lole_body::{Bone, PartKind};
use lole_pattern::DraftError;

use super::blade::Blade;
use super::body::{Around, Girdle, carrier_at};
use super::chosen::{Chosen, whole};
use super::shape::Shape;
use super::wreath::{Wound, wind};
use super::{Finish, Made, Wearer};
use crate::document::WornTemplate;

/// Where the band of a wrist lies, from elbow to wrist.
const WRIST: f32 = 0.93;
/// Leaf of the mean woman's band [m], and radius of its base.
const LEAF: [f32; 2] = [0.036, 0.014];
const BASE: f32 = 0.005;
const SKIN: &[PartKind] = &[PartKind::Skin, PartKind::Leotard];

pub(super) fn make(worn: &WornTemplate, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
    let chosen = Chosen(worn);
    let dancer = wearer.dancer;
    let joint = |bone: Bone| dancer.skeleton.joint(bone);
    let size = (dancer.landmarks.crown_height / 1.58).clamp(0.6, 1.3);
    let place = chosen.choice("place");
    let mut limbs = Vec::new();
    if place != "ankles" {
        for [elbow, wrist] in [
            [Bone::LeftLowerArm, Bone::LeftHand],
            [Bone::RightLowerArm, Bone::RightHand],
        ] {
            let way = joint(wrist) - joint(elbow);
            limbs.push((joint(elbow) + way * WRIST, way));
        }
    }
    if place != "wrists" {
        for [knee, ankle] in [
            [Bone::LeftLowerLeg, Bone::LeftFoot],
            [Bone::RightLowerLeg, Bone::RightFoot],
        ] {
            let way = joint(ankle) - joint(knee);
            let height = dancer.landmarks.ankle_tape_height;
            let share = (height - joint(knee).y) / way.y.min(-1e-3);
            limbs.push((joint(knee) + way * share.clamp(0.5, 1.0), way));
        }
    }
    let mut surfaces = Vec::new();
    for (center, way) in limbs {
        let girdle = Girdle::new(
            dancer,
            &Around {
                center,
                axis: way,
                front: Vec3::Z,
                half_height: 0.014 * size,
                reach: 0.085 * size,
                parts: SKIN,
            },
            48,
        );
        let cm = f64::from(girdle.length()) * 100.0 + chosen.number("ease_cm", 1.5);
        let wound = Wound {
            leaf: Blade {
                length: LEAF[0] * size,
                width: LEAF[1] * size,
                fold: 0.35,
                droop: 0.2,
                color: chosen.leaf(),
            },
            leaf_count: 2 * whole(cm * chosen.number("leaves_per_cm_ratio", 1.0)),
            flower: Shape::default(),
            flower_count: 0,
            base: BASE * size,
        };
        let [leaves, _] = wind(&girdle, &wound);
        let carrier = carrier_at(dancer, center, 0.05 * size);
        surfaces.push(leaves.ridden(Finish::Leaf, carrier));
    }
    Ok(Made {
        surfaces,
        ..Made::default()
    })
}
