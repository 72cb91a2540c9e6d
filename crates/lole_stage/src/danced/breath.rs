//! Her breath: chest and shoulders rise and fall while she dances, and hands and gaze stay where they were.

use std::f32::consts::TAU;

use glam::Quat;
use lole_body::{Bone, Pose};
use lole_geom::trig;

/// How long one breath takes about [s]: some fifteen a minute, as in a walk.
const BREATH: f32 = 4.0;
/// How far the chest leans back and the shoulders rise when she has breathed in [rad].
const CHEST: f32 = 0.022;
const SHOULDERS: f32 = 0.055;
/// Share of a breath in which she breathes in.
const INHALING: f32 = 0.42;

/// Breathes at `time` [s] of a dance that begins to repeat after `lead_in` and repeats every `period` [s]: so many
/// whole breaths that the pose repeats too. Up to time 0 nothing moves.
pub(super) fn breathe(pose: &mut Pose, time: f32, [lead_in, period]: [f32; 2]) {
    if time <= 0.0 || period <= 0.0 {
        return;
    }
    let count = (period / BREATH).round().max(1.0);
    let one = period / count;
    let share = ((time - lead_in) / one).rem_euclid(1.0);
    let turn = if share < INHALING {
        0.5 * share / INHALING
    } else {
        0.5 + 0.5 * (share - INHALING) / (1.0 - INHALING)
    };
    let begun = (time / lead_in.max(0.5)).min(1.0);
    // Quick breaths are shallow.
    let deep = begun * begun * (3.0 - 2.0 * begun) * (one / BREATH).min(1.0);
    let full = deep * (0.5 - 0.5 * trig::cos(TAU * turn));
    let lean = Quat::from_rotation_x(-CHEST * full);
    pose.rotate(Bone::UpperChest, lean);
    let neck = &mut pose.rotations[Bone::Neck.index()];
    *neck = lean.inverse() * *neck;
    for (shoulder, arm, side) in [
        (Bone::LeftShoulder, Bone::LeftUpperArm, 1.0),
        (Bone::RightShoulder, Bone::RightUpperArm, -1.0),
    ] {
        let before = pose.rotations[shoulder.index()];
        let after = before * Quat::from_rotation_z(side * SHOULDERS * full);
        pose.rotations[shoulder.index()] = after;
        // The arm keeps its direction.
        let arm = &mut pose.rotations[arm.index()];
        *arm = after.inverse() * lean.inverse() * before * *arm;
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use lole_body::{Dancer, Measurements};

    use super::*;

    /// Shoulders rise by some millimeters, hands and head by no more than shoulders and chest carry them, and neither
    /// turns; hips and legs stay to the bit; and after a round all is as it was.
    #[test]
    fn shoulders_rise_and_hands_and_gaze_keep_their_directions() {
        let dancer = Dancer::new(&Measurements::woman()).unwrap();
        let still = Pose::default();
        let bones = |pose: &Pose| dancer.skeleton.world_from_bind(pose);
        let rest = bones(&still);
        let mut most = 0.0_f32;
        for frame in 0..400 {
            let time = frame as f32 / 60.0;
            let at = |time: f32| {
                let mut pose = still.clone();
                breathe(&mut pose, time, [1.5, 6.0]);
                bones(&pose)
            };
            let now = at(time);
            let joint = |of: &[glam::Affine3A], bone: Bone| {
                of[bone.index()].transform_point3(dancer.skeleton.joint(bone))
            };
            let moved = |bone: Bone| joint(&now, bone) - joint(&rest, bone);
            let up = moved(Bone::LeftUpperArm).y;
            most = most.max(up);
            assert!(-1.0e-5 < up);
            for bone in [Bone::LeftHand, Bone::RightHand, Bone::Head] {
                assert!(moved(bone).length() < 0.012, "{bone:?} {}", moved(bone));
                let turned = now[bone.index()].transform_vector3(Vec3::Y);
                assert!(turned.distance(Vec3::Y) < 1.0e-4, "{bone:?} {turned}");
            }
            for bone in [Bone::Hips, Bone::LeftFoot, Bone::Spine] {
                assert_eq!(moved(bone), Vec3::ZERO);
            }
            let apart = |(a, b): (&glam::Affine3A, &glam::Affine3A)| a.abs_diff_eq(*b, 1.0e-4);
            assert!(time <= 1.5 || now.iter().zip(&at(time + 6.0)).all(apart));
        }
        assert!((0.003..0.012).contains(&most), "{most}");
    }
}
