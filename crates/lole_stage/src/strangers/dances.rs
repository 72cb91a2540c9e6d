//! Dances of strangers: a step at any tempo, or what recordings hold.

use std::f32::consts::TAU;
use std::sync::Arc;

use glam::{EulerRot, Quat, Vec3};
use lole_body::{Bone, Dancer, Pose};
use lole_costume::document::Design;
use lole_geom::{Chance, trig};
use lole_hula::DanceStep;
use lole_motion::Clip;

use crate::{Danced, FRAME_SECONDS, StageError};

/// Length of a recording [s].
const SECONDS: f32 = 8.0;
/// Time in which a recording comes in from her stance [s].
const EASE: f32 = 0.6;

/// Farthest that thighs are raised in a crouch [rad]; knees bend by twice as much, as far as they go.
const DEEPEST: f32 = 1.3;

/// Draws a dance for a dancer, with its name.
pub(super) fn draw(
    chance: &mut Chance,
    design: &mut Design,
    dancer: &Dancer,
) -> Result<(Danced, String), StageError> {
    let step = (chance.choose(&DanceStep::ALL).copied()).unwrap_or(DanceStep::Kaholo);
    design.motion.step = step;
    design.motion.tempo_bpm = f64::from(chance.between(step.tempo()[0], step.tempo()[1]).round());
    let danced = Danced::new(design, dancer)?;
    if chance.falls(0.3) {
        let name = format!("{} at {:.0}", step.id(), design.motion.tempo_bpm);
        return Ok((danced, name));
    }
    let stance = danced.pose_at(0.0);
    let kind = chance.choose(RECORDINGS).unwrap_or(&RECORDINGS[0]);
    let mut motion = (kind.1)(chance, dancer);
    let mut name = kind.0.to_owned();
    let jump = chance.falls(0.3);
    if jump {
        name.push_str(", jumping");
    }
    let mut poses = Vec::new();
    let mut off = Vec3::ZERO;
    let mut time = 0.0;
    while time < SECONDS {
        let mut pose = stance.clone();
        motion(time, (time / EASE).min(1.0), &mut pose);
        if jump && 1.0 < time && chance.falls(0.03) {
            let to = [(); 3].map(|()| chance.between(-1.0, 1.0));
            off = Vec3::from_array(to).normalize_or_zero() * 0.03;
        }
        pose.hips_translation += off;
        poses.push(pose);
        time += FRAME_SECONDS;
    }
    let clip = Clip::of_poses(poses).clear_of_skirt(dancer);
    Ok((Danced::Recording(Arc::new(clip)), name))
}

/// What a pose does at a time [s], with how far it has come in, from 0 to 1.
type Motion = Box<dyn FnMut(f32, f32, &mut Pose)>;

type Kind = (&'static str, fn(&mut Chance, &Dancer) -> Motion);

const RECORDINGS: &[Kind] = &[
    ("a walk", |chance, dancer| walk(chance, dancer)),
    ("twisting", |chance, _| twist(chance)),
    ("crouches", |chance, dancer| crouch(chance, dancer)),
    ("hands in the hips", |chance, dancer| press(chance, dancer)),
    ("all joints wandering", |chance, _| wander(chance)),
    ("whirling", |chance, _| whirl(chance)),
];

fn wave(time: f32, hertz: f32, phase: f32) -> f32 {
    trig::sin_cos(TAU * ((hertz * time + phase) % 1.0)).0
}

fn turn(pose: &mut Pose, bone: Bone, by: Quat) {
    let rotation = &mut pose.rotations[bone.index()];
    *rotation = by * *rotation;
}

/// Lets an arm hang, so far out to the side.
fn hang(pose: &mut Pose, dancer: &Dancer, side: usize, out: f32) {
    let [_, upper, lower, hand] = Bone::ARMS[side];
    let skeleton = &dancer.skeleton;
    let along = (skeleton.joint(lower) - skeleton.joint(upper)).normalize_or_zero();
    let sign = if side == 0 { 1.0 } else { -1.0 };
    let hanging = Vec3::new(sign * out, -1.0, 0.0).normalize_or_zero();
    pose.rotate(upper, Quat::from_rotation_arc(along, hanging));
    pose.rotate(lower, Quat::IDENTITY);
    pose.rotate(hand, Quat::IDENTITY);
}

/// Legs swing, knees bend, arms hang beside the hips and swing against them, and she goes on.
fn walk(chance: &mut Chance, dancer: &Dancer) -> Motion {
    let (hertz, swing) = (chance.between(0.7, 1.3), chance.between(0.3, 0.65));
    let leg = dancer.landmarks.hip_joint_height;
    let speed = 4.0 * swing * leg * hertz * 0.8;
    let arms = chance.between(0.0, 0.25);
    let dancer = dancer.clone();
    Box::new(move |time, ease, pose| {
        let base = pose.clone();
        for (side, limb) in Bone::LEGS.iter().enumerate() {
            let phase = 0.5 * side as f32;
            let forward = ease * swing * wave(time, hertz, phase);
            let bend = ease * swing * (1.0 + wave(time, hertz, phase + 0.2));
            turn(pose, limb[0], Quat::from_rotation_x(-forward - 0.4 * bend));
            turn(pose, limb[1], Quat::from_rotation_x(bend));
            let mut hanging = base.clone();
            hang(&mut hanging, &dancer, side, arms);
            let [_, upper, lower, hand] = Bone::ARMS[side];
            for bone in [upper, lower, hand] {
                let mixed = base.rotation(bone).slerp(hanging.rotation(bone), ease);
                pose.rotate(bone, mixed);
            }
            turn(pose, upper, Quat::from_rotation_x(0.8 * forward));
        }
        pose.hips_translation.z += ease * speed * time;
        pose.hips_translation.y -=
            ease * 0.15 * swing * leg * (0.5 + 0.5 * wave(time, 2.0 * hertz, 0.0)) * swing;
    })
}

/// Hips and spine turn against each other.
fn twist(chance: &mut Chance) -> Motion {
    let (hertz, angle) = (chance.between(0.5, 1.6), chance.between(0.3, 0.9));
    Box::new(move |time, ease, pose| {
        let angle = ease * angle * wave(time, hertz, 0.0);
        turn(pose, Bone::Hips, Quat::from_rotation_y(angle));
        turn(pose, Bone::Spine, Quat::from_rotation_y(-0.8 * angle));
        turn(pose, Bone::Chest, Quat::from_rotation_z(0.4 * angle));
    })
}

/// Deep knee bends, and a leap after some of them.
fn crouch(chance: &mut Chance, dancer: &Dancer) -> Motion {
    let (hertz, angle) = (chance.between(0.3, 0.8), chance.between(0.7, DEEPEST));
    let leap = chance.between(0.0, 0.3);
    let thigh =
        dancer.skeleton.joint(Bone::LeftUpperLeg).y - dancer.skeleton.joint(Bone::LeftLowerLeg).y;
    Box::new(move |time, ease, pose| {
        let down = ease * 0.5 * (1.0 - trig::sin_cos(TAU * ((hertz * time) % 1.0)).1);
        let bend = angle * down;
        let (_, cos) = trig::sin_cos(bend);
        for limb in Bone::LEGS {
            turn(pose, limb[0], Quat::from_rotation_x(-bend));
            turn(pose, limb[1], Quat::from_rotation_x(2.0 * bend));
            turn(pose, limb[2], Quat::from_rotation_x(-bend));
        }
        turn(pose, Bone::Spine, Quat::from_rotation_x(0.4 * bend));
        let up = ease * (wave(time, hertz, 0.25) - 0.6).max(0.0) * 2.5 * leap;
        pose.hips_translation.y += up - 2.0 * thigh * (1.0 - cos);
    })
}

/// Hands that hang in the hips and go in and out.
fn press(chance: &mut Chance, dancer: &Dancer) -> Motion {
    let (hertz, reach) = (chance.between(0.3, 1.2), chance.between(0.15, 0.45));
    let dancer = dancer.clone();
    Box::new(move |time, ease, pose| {
        let base = pose.clone();
        let mut hanging = base.clone();
        for side in 0..2 {
            hang(
                &mut hanging,
                &dancer,
                side,
                0.1 - reach * wave(time, hertz, 0.0),
            );
        }
        for [_, upper, lower, hand] in Bone::ARMS {
            for bone in [upper, lower, hand] {
                pose.rotate(
                    bone,
                    base.rotation(bone).slerp(hanging.rotation(bone), ease),
                );
            }
        }
    })
}

/// Every joint goes to and fro by itself.
fn wander(chance: &mut Chance) -> Motion {
    let joints: Vec<(Bone, Vec3, Vec3, Vec3)> = (Bone::ALL.iter())
        .filter(|bone| !is_finger(**bone))
        .map(|&bone| {
            let most = match bone {
                Bone::Hips => 0.25,
                Bone::LeftUpperArm
                | Bone::RightUpperArm
                | Bone::LeftLowerArm
                | Bone::RightLowerArm => 0.7,
                Bone::LeftUpperLeg
                | Bone::RightUpperLeg
                | Bone::LeftLowerLeg
                | Bone::RightLowerLeg => 0.4,
                _ => 0.15,
            };
            let mut draw =
                |low: f32, high: f32| Vec3::from_array([(); 3].map(|()| chance.between(low, high)));
            (bone, draw(-most, most), draw(0.2, 1.1), draw(0.0, 1.0))
        })
        .collect();
    Box::new(move |time, ease, pose| {
        for &(bone, reach, hertz, phase) in &joints {
            let part = |axis: usize| ease * reach[axis] * wave(time, hertz[axis], phase[axis]);
            let by = Quat::from_euler(EulerRot::XYZ, part(0), part(1), part(2));
            turn(pose, bone, by);
        }
        pose.hips_translation.x += ease * 0.1 * wave(time, 0.6, 0.0);
    })
}

/// Turns on the spot, faster and faster, to and fro.
fn whirl(chance: &mut Chance) -> Motion {
    let (hertz, turns) = (chance.between(0.1, 0.3), chance.between(1.0, 6.0));
    Box::new(move |time, ease, pose| {
        let angle = ease * turns * wave(time, hertz, 0.0);
        turn(pose, Bone::Hips, Quat::from_rotation_y(angle));
    })
}

fn is_finger(bone: Bone) -> bool {
    let hands = [Bone::LeftHand, Bone::RightHand];
    !hands.contains(&bone) && bone.lineage().any(|above| hands.contains(&above))
}
