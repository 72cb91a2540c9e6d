//! Where the capsules stand before they are fitted.

use glam::DVec3;

use super::Part;
use crate::{Bone, Landmarks, Skeleton};

/// The paper's 13, from joints and landmarks.
pub(super) fn of_paper(skeleton: &Skeleton, landmarks: &Landmarks) -> Vec<Part> {
    let joint = |bone: Bone| skeleton.joint(bone).as_dvec3();
    let [hip, knee, ankle] = [Bone::LeftUpperLeg, Bone::LeftLowerLeg, Bone::LeftFoot].map(joint);
    let k = f64::from(landmarks.crown_height) / 1.58;
    let [waist, asis] = [landmarks.waist_height, landmarks.asis_height].map(f64::from);
    let at = |x: f64, y: f64, z: f64| DVec3::new(x * k, y, z * k);
    let along = |from: DVec3, to: DVec3, share: f64| from.lerp(to, share);
    let crosswise = |name, bone, end: DVec3, radius: f64| Part {
        names: [name, name],
        bones: [bone; 2],
        ends: [end * DVec3::new(-1.0, 1.0, 1.0), end],
        radii: [radius * k; 2],
        is_crosswise: true,
    };
    let sided = |names, bone, ends, radii: [f64; 2]| Part {
        names,
        bones: [bone; 2],
        ends,
        radii: radii.map(|radius| radius * k),
        is_crosswise: false,
    };
    let thigh = along(hip, knee, 0.62);
    let calf = along(knee, ankle, 0.45);
    vec![
        crosswise("waist", Bone::Spine, at(0.035, waist, 0.035), 0.083),
        crosswise(
            "belly",
            Bone::Hips,
            at(0.055, 0.5 * (waist + asis), 0.02),
            0.09,
        ),
        crosswise("seat", Bone::Hips, at(0.055, hip.y - 0.01, -0.01), 0.098),
        sided(
            ["left pelvis", "right pelvis"],
            Bone::Hips,
            [at(0.08, asis + 0.01, 0.02), at(0.09, hip.y - 0.03, 0.03)],
            [0.08, 0.085],
        ),
        sided(
            ["left upper thigh", "right upper thigh"],
            Bone::LeftUpperLeg,
            [along(hip, knee, 0.18), thigh],
            [0.085, 0.066],
        ),
        sided(
            ["left lower thigh", "right lower thigh"],
            Bone::LeftUpperLeg,
            [thigh, knee],
            [0.066, 0.054],
        ),
        sided(
            ["left upper shin", "right upper shin"],
            Bone::LeftLowerLeg,
            [knee, calf],
            [0.053, 0.05],
        ),
        sided(
            ["left lower shin", "right lower shin"],
            Bone::LeftLowerLeg,
            [calf, along(knee, ankle, 0.97)],
            [0.05, 0.034],
        ),
    ]
}

/// Two capsules of one radius, from the pelvis to the ankle of each leg.
pub(super) fn two_cylinders(skeleton: &Skeleton, landmarks: &Landmarks) -> Part {
    let joint = |bone: Bone| skeleton.joint(bone).as_dvec3();
    let scale = f64::from(landmarks.crown_height) / REFERENCE_STATURE;
    let (hip, ankle) = (joint(Bone::LeftUpperLeg), joint(Bone::LeftFoot));
    let top = DVec3::new(hip.x, f64::from(landmarks.asis_height), hip.z);
    Part {
        names: ["left leg", "right leg"],
        bones: [Bone::Hips, Bone::LeftLowerLeg],
        ends: [top, ankle],
        radii: [0.085 * scale; 2],
        is_crosswise: false,
    }
}

/// Stature [m] of the woman whose radii are written here.
const REFERENCE_STATURE: f64 = 1.58;

/// Any number of capsules: two in five lie on each side, the rest across the trunk; of those on a
/// side a fifth covers the pelvis, half of the others the thigh. A segment with four or more has
/// two strands, before and behind the bone.
pub(super) fn by_count(skeleton: &Skeleton, landmarks: &Landmarks, count: u32) -> Vec<Part> {
    let count = count.clamp(1, super::CapsuleLayout::MOST);
    let sided = count * 2 / 5;
    let joint = |bone: Bone| skeleton.joint(bone).as_dvec3();
    let [hip, knee, ankle] = [Bone::LeftUpperLeg, Bone::LeftLowerLeg, Bone::LeftFoot].map(joint);
    let scale = f64::from(landmarks.crown_height) / REFERENCE_STATURE;
    let asis = f64::from(landmarks.asis_height);
    let mut parts = trunk(landmarks, hip, count - 2 * sided, scale);
    let pelvis = sided / 5;
    let thigh = (sided - pelvis).div_ceil(2);
    let shin = sided - pelvis - thigh;
    let from = DVec3::new(0.08 * scale, asis, 0.02 * scale);
    let to = DVec3::new(0.09 * scale, hip.y - 0.03 * scale, 0.02 * scale);
    let strands = |names, bones, ends: [DVec3; 2], radii: [f64; 2], count| {
        let limb = Limb {
            names,
            bones,
            ends,
            radii: radii.map(|radius| radius * scale),
        };
        limb.strands(count)
    };
    let thigh_bones = [Bone::LeftUpperLeg; 2];
    let shin_bones = [Bone::LeftLowerLeg; 2];
    parts.extend(strands(
        ["left pelvis", "right pelvis"],
        [Bone::Hips; 2],
        [from, to],
        [0.08, 0.085],
        pelvis,
    ));
    if shin == 0 {
        let whole_leg = [Bone::LeftUpperLeg, Bone::LeftLowerLeg];
        let names = ["left leg", "right leg"];
        parts.extend(strands(
            names,
            whole_leg,
            [hip, ankle],
            [0.085, 0.034],
            thigh,
        ));
        return parts;
    }
    let names = ["left thigh", "right thigh"];
    let top = hip.lerp(knee, 0.15);
    parts.extend(strands(
        names,
        thigh_bones,
        [top, knee],
        [0.085, 0.054],
        thigh,
    ));
    let names = ["left shin", "right shin"];
    let bottom = knee.lerp(ankle, 0.97);
    parts.extend(strands(
        names,
        shin_bones,
        [knee, bottom],
        [0.053, 0.034],
        shin,
    ));
    parts
}

/// Crosswise capsules at even heights from the waist to the hip joints.
fn trunk(landmarks: &Landmarks, hip: DVec3, count: u32, scale: f64) -> Vec<Part> {
    let waist = f64::from(landmarks.waist_height);
    (0..count)
        .map(|index| {
            // A single one lies lowest, where the body is widest.
            let share = if count == 1 {
                1.0
            } else {
                f64::from(index) / f64::from(count - 1)
            };
            let half_width = 0.035 + 0.02 * share;
            let end = DVec3::new(
                half_width * scale,
                waist + (hip.y - 0.01 - waist) * share,
                (0.035 - 0.045 * share) * scale,
            );
            Part {
                names: ["trunk"; 2],
                bones: [if index == 0 && 2 < count {
                    Bone::Spine
                } else {
                    Bone::Hips
                }; 2],
                ends: [end * DVec3::new(-1.0, 1.0, 1.0), end],
                radii: [(0.083 + 0.015 * share) * scale; 2],
                is_crosswise: true,
            }
        })
        .collect()
}

/// A stretch of the left leg between two points, to be covered.
struct Limb {
    names: [&'static str; 2],
    bones: [Bone; 2],
    ends: [DVec3; 2],
    radii: [f64; 2],
}

impl Limb {
    /// `count` capsules in one strand, or from four on in two.
    fn strands(&self, count: u32) -> Vec<Part> {
        if count < 4 {
            return self.strand(count, 0.0);
        }
        let front = count.div_ceil(2);
        let mut parts = self.strand(front, 1.0);
        parts.extend(self.strand(count - front, -1.0));
        parts
    }

    /// `count` capsules end to end, to the front (`side` 1), to the back (-1) or centered (0).
    fn strand(&self, count: u32, side: f64) -> Vec<Part> {
        let slimness = 1.0 - 0.15 * side.abs();
        let at = |index: u32| {
            let share = f64::from(index) / f64::from(count);
            let radius = self.radii[0] + (self.radii[1] - self.radii[0]) * share;
            let shift = DVec3::Z * (0.25 * side * radius);
            (
                self.ends[0].lerp(self.ends[1], share) + shift,
                radius * slimness,
            )
        };
        (0..count)
            .map(|index| {
                let (start, end) = (at(index), at(index + 1));
                Part {
                    names: self.names,
                    bones: self.bones,
                    ends: [start.0, end.0],
                    radii: [start.1, end.1],
                    is_crosswise: false,
                }
            })
            .collect()
    }
}
