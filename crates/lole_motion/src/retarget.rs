//! From the joints of a recording to the bones of a dancer, one pose at a time.
//!
//! Of every joint it is known how far it has turned from the rest pose, in axes that both bodies
//! share: left, up, front. A bone of the trunk turns by as much. A bone of a limb first turns from
//! where it points in the dancer's bind pose to where the recording's bone points at rest, by the
//! shortest way: so it points where the recorded one points in every frame, whatever the rest poses.

use glam::{Quat, Vec3};
use lole_body::{Bone, Pose, Skeleton};

use crate::axes::{self, Axes};
use crate::clip::{POSES_PER_SECOND, whole};
use crate::{BoneMap, JointPlace, Recording, RecordingError};

/// Feet that point less steeply than this (the sine of their elevation) stand flat at rest.
const FLAT: f32 = 0.87;
/// Frames that say which way is up.
const UP_FRAMES: usize = 64;

/// Bones of the trunk above the hips, each a third of the way up it.
const TRUNK: [Bone; 3] = [Bone::Spine, Bone::Chest, Bone::UpperChest];
/// Bones above the trunk.
const NECK: [Bone; 2] = [Bone::Neck, Bone::Head];
/// Bones of the limbs with where they end.
const LIMBS: [[Bone; 2]; 8] = [
    [Bone::LeftUpperArm, Bone::LeftLowerArm],
    [Bone::LeftLowerArm, Bone::LeftHand],
    [Bone::RightUpperArm, Bone::RightLowerArm],
    [Bone::RightLowerArm, Bone::RightHand],
    [Bone::LeftUpperLeg, Bone::LeftLowerLeg],
    [Bone::LeftLowerLeg, Bone::LeftFoot],
    [Bone::RightUpperLeg, Bone::RightLowerLeg],
    [Bone::RightLowerLeg, Bone::RightFoot],
];
/// Feet with their toes.
const FEET: [[Bone; 2]; 2] = [
    [Bone::LeftFoot, Bone::LeftToes],
    [Bone::RightFoot, Bone::RightToes],
];

/// A recording and a skeleton, with what carries one to the other.
pub(crate) struct Retarget<'a> {
    recording: &'a Recording,
    map: &'a BoneMap,
    skeleton: &'a Skeleton,
    /// The first frame that is danced.
    first_frame: usize,
    /// Turn from the file's space to the world.
    world_from_file: Quat,
    /// For each joint, the turn from the body's axes to the joint's own at rest.
    joint_from_body: Vec<Quat>,
    /// For each bone, the turn from the bind pose to the recording's rest pose, in body axes.
    rest_from_bind: Vec<Quat>,
    /// Meters of the dancer per unit of the file.
    scale: f32,
    /// Middle between the hip joints in the first frame [file units].
    start: Vec3,
}

impl<'a> Retarget<'a> {
    pub(crate) fn new(
        recording: &'a Recording,
        map: &'a BoneMap,
        skeleton: &'a Skeleton,
    ) -> Result<Self, RecordingError> {
        if recording.frame_count() == 0 {
            return Err(RecordingError::NoFrames);
        }
        let (rest, first_frame) = rest(recording);
        let recorded_leg = leg_length(map, &rest)?;
        let dancer_leg = [FEET[0][0], FEET[1][0]]
            .iter()
            .zip([Bone::LeftUpperLeg, Bone::RightUpperLeg])
            .map(|(&foot, hip)| {
                let knee = foot.parent().unwrap_or(hip);
                let [hip, knee, foot] = [hip, knee, foot].map(|bone| skeleton.joint(bone));
                0.5 * (hip.distance(knee) + knee.distance(foot))
            })
            .sum::<f32>();
        let first = recording.places(first_frame);
        let rest_axes = Axes::of(map, &rest);
        let floor_axes = facing(recording, map, first_frame);
        let body_from_file = rest_axes.world_from_file();
        let joint_from_body = rest
            .iter()
            .map(|place| place.rotation.inverse() * body_from_file.inverse())
            .collect();
        Ok(Self {
            recording,
            map,
            skeleton,
            first_frame,
            world_from_file: floor_axes.world_from_file(),
            joint_from_body,
            rest_from_bind: Rest {
                recording,
                map,
                places: &rest,
                body_from_file,
            }
            .turns_from_bind(skeleton),
            scale: dancer_leg / recorded_leg,
            start: hip_middle(map, &first),
        })
    }

    /// Poses of the whole recording.
    pub(crate) fn pose_count(&self) -> usize {
        let intervals = self.recording.frame_count() - 1 - self.first_frame;
        let seconds = intervals as f64 * self.recording.frame_seconds;
        // A last interval that misses a whole one by rounding counts.
        1 + whole(seconds * f64::from(POSES_PER_SECOND) + 1e-3)
    }

    /// One pose; the floor is where the recording's lies, up to a constant.
    pub(crate) fn pose(&self, index: usize) -> Pose {
        let seconds = index as f64 / f64::from(POSES_PER_SECOND);
        let frame = self.first_frame as f64 + seconds / self.recording.frame_seconds;
        let places = self.recording.places_between(frame);
        let mut pose = Pose::default();
        let mut turns: Vec<Quat> = Vec::with_capacity(Bone::COUNT);
        for &bone in Bone::ALL {
            let parent = bone.parent().map(|parent| turns[parent.index()]);
            let parent = parent.unwrap_or(Quat::IDENTITY);
            let turn = self.turn_of(bone, &places).unwrap_or(parent);
            pose.rotate(bone, (parent.inverse() * turn).normalize());
            turns.push(turn);
        }
        let joint = |bone| self.skeleton.joint(bone);
        let middle = 0.5 * (joint(Bone::LeftUpperLeg) + joint(Bone::RightUpperLeg));
        let moved = self.world_from_file * (hip_middle(self.map, &places) - self.start);
        let from_middle = joint(Bone::Hips) - middle;
        pose.hips_translation = moved * self.scale + turns[Bone::Hips.index()] * from_middle
            - from_middle
            - middle.with_y(0.0);
        pose
    }

    /// Turn of a bone in the world; `None` where it has no joint and goes with its parent.
    fn turn_of(&self, bone: Bone, places: &[JointPlace]) -> Option<Quat> {
        let hips = self.map.needed(Bone::Hips);
        if let Some(place) = TRUNK.iter().position(|&other| other == bone) {
            let trunk = Chain {
                below: hips,
                joints: self.map.spine(),
            };
            return Some(self.turn_along(&trunk, (place + 1, 3), places));
        }
        if let Some(place) = NECK.iter().position(|&other| other == bone) {
            let neck = Chain {
                below: self.map.chest(),
                joints: self.map.neck(),
            };
            return Some(self.turn_along(&neck, (place + 1, 2), places));
        }
        let joint = self.map.joint(bone)?;
        Some(self.turned(joint, places) * self.rest_from_bind[bone.index()])
    }

    /// How far a joint has turned from rest, in the world.
    fn turned(&self, joint: usize, places: &[JointPlace]) -> Quat {
        self.world_from_file * places[joint].rotation * self.joint_from_body[joint]
    }

    /// How far a chain has turned `part` of `of` of the way up it.
    fn turn_along(
        &self,
        chain: &Chain<'_>,
        (part, of): (usize, usize),
        places: &[JointPlace],
    ) -> Quat {
        let steps = part * chain.joints.len();
        let (whole, rest) = (steps / of, steps % of);
        let from = self.turned(chain.joint(whole), places);
        if rest == 0 {
            return from;
        }
        let to = self.turned(chain.joint(whole + 1), places);
        from.slerp(to, rest as f32 / of as f32)
    }
}

/// Joints above one another.
struct Chain<'a> {
    /// What they stand on.
    below: usize,
    joints: &'a [usize],
}

impl Chain<'_> {
    /// The joint at which so many of the chain end.
    fn joint(&self, count: usize) -> usize {
        count.checked_sub(1).map_or(self.below, |i| self.joints[i])
    }
}

/// Every joint at rest, and the first frame that is danced.
pub(crate) fn rest(recording: &Recording) -> (Vec<JointPlace>, usize) {
    if recording.begins_with_a_stance() {
        (recording.places(0), 1)
    } else {
        (recording.rest_places(), 0)
    }
}

/// Mean length of thigh and shank [file units].
pub(crate) fn leg_length(map: &BoneMap, rest: &[JointPlace]) -> Result<f32, RecordingError> {
    let mut length = 0.0;
    for &[upper, lower] in &LIMBS {
        let [from, to] = [upper, lower].map(|bone| rest[map.needed(bone)].position);
        let bone = from.distance(to);
        if !(bone.is_finite() && 0.0 < bone) {
            return Err(RecordingError::BoneWithoutLength { bone: upper.name() });
        }
        if LIMBS[4..].contains(&[upper, lower]) {
            length += 0.5 * bone;
        }
    }
    Ok(length)
}

/// Axes of the floor's space: up is the axis along which the dancer stands on the whole, and she
/// faces the front in the frame `first`.
pub(crate) fn facing(recording: &Recording, map: &BoneMap, first: usize) -> Axes {
    let count = recording.frame_count().saturating_sub(first).max(1);
    let stride = count.div_ceil(UP_FRAMES);
    let up = (first..first + count).step_by(stride).map(|frame| {
        let places = recording.places(frame);
        axes::upright(map, &places).normalize_or_zero()
    });
    let up: Vec3 = up.sum();
    Axes::of(map, &recording.places(first)).over_floor(up)
}

fn hip_middle(map: &BoneMap, places: &[JointPlace]) -> Vec3 {
    let at = |bone| places[map.needed(bone)].position;
    0.5 * (at(Bone::LeftUpperLeg) + at(Bone::RightUpperLeg))
}

/// The rest pose of a recording.
struct Rest<'a> {
    recording: &'a Recording,
    map: &'a BoneMap,
    /// Of every joint.
    places: &'a [JointPlace],
    body_from_file: Quat,
}

impl Rest<'_> {
    /// Where a joint lies from another, in body axes.
    fn direction(&self, from: usize, to: usize) -> Vec3 {
        let way = self.places[to].position - self.places[from].position;
        (self.body_from_file * way).normalize_or_zero()
    }

    /// For each bone, the turn from the bind pose to this one, in body axes: none for the trunk, the
    /// shortest for limbs, and hands and fingers go with the forearm.
    fn turns_from_bind(&self, skeleton: &Skeleton) -> Vec<Quat> {
        let map = self.map;
        let mut turns = vec![Quat::IDENTITY; Bone::COUNT];
        let bound = |from, to| (skeleton.joint(to) - skeleton.joint(from)).normalize_or_zero();
        for [bone, end] in LIMBS {
            let to = self.direction(map.needed(bone), map.needed(end));
            turns[bone.index()] = Quat::from_rotation_arc(bound(bone, end), to);
        }
        for [foot, toes] in FEET {
            let joint = map.needed(foot);
            let tip = map
                .joint(toes)
                .or_else(|| self.recording.children(joint).next());
            let Some(tip) = tip else { continue };
            let (from, to) = (bound(foot, toes), self.direction(joint, tip));
            turns[foot.index()] = if to.y.abs() < FLAT {
                let level = |v: Vec3| v.with_y(0.0).normalize_or(Vec3::Z);
                Quat::from_rotation_arc(level(from), level(to))
            } else {
                Quat::from_rotation_arc(from, to)
            };
            turns[toes.index()] = turns[foot.index()];
        }
        for &bone in Bone::ALL {
            let above = |side: Bone| bone.lineage().skip(1).any(|parent| parent == side);
            for forearm in [Bone::LeftLowerArm, Bone::RightLowerArm] {
                if above(forearm) {
                    turns[bone.index()] = turns[forearm.index()];
                }
            }
        }
        turns
    }
}
