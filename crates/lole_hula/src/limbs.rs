//! One leg and one arm: from targets to joint rotations.

mod waist;

use glam::{Mat3, Quat, Vec3};
use lole_body::ik::two_bone;
use lole_body::{Bone, Pose, Skeleton};
use lole_geom::trig;

use super::ease::soft_max;
use super::figure::Arm;
use super::rig::{PlacedFoot, quat_about, quat_x, quat_y, quat_z};
use super::settings::MotionError;
use waist::WaistRig;

/// The heel is about 1.35 times as far behind the ball as the ankle joint is.
const HEEL_BEYOND_ANKLE: f32 = 1.35;
/// Part of the arm's raise and of its turn to the front that the clavicle takes.
const CLAVICLE_RAISE: f32 = 0.16;
const ABOVE_HORIZONTAL: f32 = 0.14;
const CLAVICLE_FORWARD: f32 = 0.12;
/// Part of the upper arm's turn about itself that is made at the shoulder; the skin of the
/// shoulder would tear with all of it.
const UPPER_ARM_TWIST: f32 = 0.3;
/// Part of the hand's turn about the forearm that is made along the forearm.
const FOREARM_TWIST: f32 = 0.5;

/// Bend of a relaxed finger's joints [°], root first, and their shares of the wave.
const RELAXED_FINGER: [f32; 3] = [6.0, 12.0, 6.0];
const WAVE_OF_JOINTS: [f32; 3] = [1.0, 0.8, 0.5];
/// Part of the bind pose's spread that is taken away: hula hands keep the fingers together.
const GATHERED: f32 = 0.85;

/// Part of the bind pose's opening of the thumb that each of its bones takes away.
const THUMB_CLOSED: [f32; 3] = [0.25, 0.2, 0.1];

/// Position of a side in `[left, right]` tables; `side` is +1 left, −1 right.
fn index_of(side: f32) -> usize {
    usize::from(side < 0.0)
}

fn direction(skeleton: &Skeleton, from: Bone, to: Bone) -> Result<Vec3, MotionError> {
    (skeleton.joint(to) - skeleton.joint(from))
        .try_normalize()
        .ok_or(MotionError::BoneWithoutLength { bone: from.name() })
}

/// Right-handed frame whose first axis is `along` and whose second lies nearest to `beside`.
fn frame(along: Vec3, beside: Vec3) -> Mat3 {
    let second = (beside - along * beside.dot(along))
        .try_normalize()
        .unwrap_or_else(|| along.any_orthonormal_vector());
    Mat3::from_cols(along, second, along.cross(second))
}

/// Rotation that carries one frame to another.
fn turn_between(from: Mat3, to: Mat3) -> Quat {
    Quat::from_mat3(&(to * from.transpose())).normalize()
}

/// Measures of one leg in the bind pose.
#[derive(Debug, Clone)]
pub(super) struct LegRig {
    /// +1 left, −1 right.
    pub side: f32,
    /// Hip joint, ankle and ball of the foot [m].
    pub hip: Vec3,
    pub ankle: Vec3,
    pub ball: Vec3,
    lengths: [f32; 2],
    /// Frames of thigh and shank with the hinge of the knee as second axis.
    thigh: Mat3,
    shank: Mat3,
}

impl LegRig {
    pub(super) fn new(skeleton: &Skeleton, side: f32) -> Result<Self, MotionError> {
        let [upper, lower, foot, toes] = Bone::LEGS[index_of(side)];
        let thigh = direction(skeleton, upper, lower)?;
        let shank = direction(skeleton, lower, foot)?;
        direction(skeleton, foot, toes)?;
        let whole = direction(skeleton, upper, foot)?;
        // The feet point to the front in the bind pose, and so do the knees.
        let hinge = Vec3::Z.cross(whole);
        Ok(Self {
            side,
            hip: skeleton.joint(upper),
            ankle: skeleton.joint(foot),
            ball: skeleton.joint(toes),
            lengths: [
                skeleton.joint(lower).distance(skeleton.joint(upper)),
                skeleton.joint(foot).distance(skeleton.joint(lower)),
            ],
            thigh: frame(thigh, hinge),
            shank: frame(shank, hinge),
        })
    }

    /// Thigh and shank together [m].
    pub(super) fn length(&self) -> f32 {
        self.lengths[0] + self.lengths[1]
    }

    /// Distance from hip joint to ankle [m] with the knee bent by `knee_degrees`.
    pub(super) fn chord(&self, knee_degrees: f32) -> f32 {
        let [a, b] = self.lengths;
        let cos = trig::cos(knee_degrees.to_radians());
        (a * a + b * b + 2.0 * a * b * cos).max(0.0).sqrt()
    }

    /// Distance from the ball of the foot to the end of the heel [m], seen from above.
    pub(super) fn heel_arm(&self) -> f32 {
        let to_ball = self.ball - self.ankle;
        HEEL_BEYOND_ANKLE * to_ball.with_y(0.0).length().max(1e-3)
    }

    /// How far from the ankle a hip joint may stand, seen along the floor, for the knee to stay
    /// bent by `knee_degrees`; both are lengths [m], `over` and `ahead` the known distances.
    pub(super) fn widest(&self, over: f32, ahead: f32, knee_degrees: f32) -> f32 {
        let chord = self.chord(knee_degrees);
        let least = 0.1 * chord;
        (chord * chord - over * over - ahead * ahead)
            .max(least * least)
            .sqrt()
    }

    /// Height above which `hip` [m] may not rise, for the knee to stay bent by `knee_degrees`.
    pub(super) fn highest_hip(&self, hip: Vec3, ankle: Vec3, knee_degrees: f32) -> f32 {
        let chord = self.chord(knee_degrees);
        let aside = (hip - ankle).with_y(0.0).length_squared();
        // A foot that no height could reach leaves the hip at a third of the leg's length.
        let least = 0.33 * chord;
        ankle.y + (chord * chord - aside).max(least * least).sqrt()
    }

    /// Turns the bones so that the leg goes from `hip` [m] to the foot.
    pub(super) fn solve(&self, hip: Vec3, foot: &PlacedFoot, pelvis: Quat, pose: &mut Pose) {
        let [upper, lower, foot_bone, toes] = Bone::LEGS[index_of(self.side)];
        let limb = two_bone(hip, foot.ankle, self.lengths, foot.knee);
        let thigh = turn_between(self.thigh, frame(limb.upper, limb.hinge));
        let shank = turn_between(self.shank, frame(limb.lower, limb.hinge));
        pose.rotate(upper, pelvis.inverse() * thigh);
        pose.rotate(lower, thigh.inverse() * shank);
        pose.rotate(foot_bone, shank.inverse() * foot.turn);
        pose.rotate(toes, quat_x(-foot.pitch));
    }
}

/// Measures of one arm in the bind pose.
#[derive(Debug, Clone)]
pub(super) struct ArmRig {
    /// +1 left, −1 right.
    side: f32,
    /// Directions of upper arm and forearm.
    upper: Vec3,
    fore: Vec3,
    /// Frame of the hand: along it, out of the palm.
    hand: Mat3,
    /// Axis about which the thumb closes toward the hand's direction, and how far it is open [rad].
    thumb: (Vec3, f32),
    /// What the fingers need to lie beside each other, softly bent, index to little.
    fingers: [FingerRig; 4],
    /// Azimuth and elevation of the upper arm [°], as in [`Arm`].
    azimuth: f32,
    elevation: f32,
    waist: WaistRig,
}

impl ArmRig {
    pub(super) fn new(skeleton: &Skeleton, side: f32) -> Result<Self, MotionError> {
        let i = index_of(side);
        let [clavicle, upper, lower, hand] = Bone::ARMS[i];
        let [index, middle, _, little] = Bone::FINGERS[i].map(|finger| finger[0]);
        direction(skeleton, clavicle, upper)?;
        let upper_direction = direction(skeleton, upper, lower)?;
        let fore = direction(skeleton, lower, hand)?;
        let along = direction(skeleton, hand, middle)?;
        let across = direction(skeleton, index, little)?;
        // Left hand: (index → little) × along points out of the palm; mirrored on the right.
        let palm = across.cross(along) * side;
        let horizontal = upper_direction.with_y(0.0).length();
        Ok(Self {
            side,
            upper: upper_direction,
            fore,
            hand: frame(along, palm),
            thumb: {
                let [root, _, end] = Bone::THUMBS[i].map(|bone| skeleton.joint(bone));
                let thumb = (end - root).normalize_or_zero();
                let axis = thumb.cross(along).normalize_or_zero();
                (axis, trig::acos(thumb.dot(along)))
            },
            fingers: Bone::FINGERS[i]
                .map(|finger| FingerRig::new(skeleton, finger, frame(along, palm))),
            azimuth: trig::atan2(upper_direction.z, upper_direction.x * side).to_degrees(),
            elevation: trig::atan2(upper_direction.y, horizontal).to_degrees(),
            waist: WaistRig::new(skeleton, side),
        })
    }

    /// Direction in chest space of an azimuth and an elevation [°].
    fn direction(&self, azimuth: f32, elevation: f32) -> Vec3 {
        let (sin_a, cos_a) = trig::sin_cos(azimuth.to_radians());
        let (sin_e, cos_e) = trig::sin_cos(elevation.to_radians());
        Vec3::new(self.side * cos_a * cos_e, sin_e, sin_a * cos_e)
    }

    /// Turn of the clavicle that goes with an upper arm.
    fn turn_clavicle(&self, arm: &Arm) -> Quat {
        let above = ABOVE_HORIZONTAL * soft_max(arm.elevation, 0.0, 20.0);
        let raise = (CLAVICLE_RAISE * (arm.elevation - self.elevation) + above).to_radians();
        let forward = (CLAVICLE_FORWARD * (arm.azimuth - self.azimuth)).to_radians();
        quat_y(-self.side * forward) * quat_z(self.side * raise)
    }

    /// The arm as it is asked for, or with its hand on the waist where the trunk of `pose` has it.
    fn reached(&self, arm: &Arm, pose: &Pose) -> Arm {
        const PASSES: usize = 3;
        if arm.on_waist <= 0.0 {
            return *arm;
        }
        // The shoulder follows the arm that starts from it.
        let waist = self.waist.in_chest(pose);
        let mut resting = *arm;
        for _ in 0..PASSES {
            resting = self.waist.arm(waist, self.turn_clavicle(&resting));
        }
        arm.mixed(&resting, arm.on_waist)
    }

    /// Turns the bones of the arm and the fingers; the trunk is already in `pose`.
    pub(super) fn solve(&self, arm: &Arm, pose: &mut Pose) {
        let arm = &self.reached(arm, pose);
        let i = index_of(self.side);
        let [clavicle_bone, upper_bone, lower_bone, hand_bone] = Bone::ARMS[i];
        let clavicle = self.turn_clavicle(arm);

        let upper_direction = self.direction(arm.azimuth, arm.elevation);
        let fore_direction = self.direction(arm.fore_azimuth, arm.fore_elevation);
        let upper = self.turn_upper(clavicle, upper_direction, fore_direction);
        let fore = swing(upper, self.fore, fore_direction);

        let hand = self.turn_hand(arm, fore_direction);
        let twist = twist_about(hand * fore.inverse(), fore_direction);
        let fore = quat_about(fore_direction, FOREARM_TWIST * twist) * fore;

        pose.rotate(clavicle_bone, clavicle);
        pose.rotate(upper_bone, clavicle.inverse() * upper);
        pose.rotate(lower_bone, upper.inverse() * fore);
        pose.rotate(hand_bone, fore.inverse() * hand);
        self.curl_fingers(arm.fingers, pose);
    }

    /// Turn of the upper arm: along its direction, with the elbow's hinge square to the plane of
    /// the arm as far as [`UPPER_ARM_TWIST`] goes.
    fn turn_upper(&self, clavicle: Quat, upper: Vec3, fore: Vec3) -> Quat {
        let swung = swing(clavicle, self.upper, upper);
        let hinge = swung * self.upper.cross(self.fore);
        let wanted = upper.cross(fore);
        let twist = trig::atan2(hinge.cross(wanted).dot(upper), hinge.dot(wanted));
        quat_about(upper, UPPER_ARM_TWIST * twist) * swung
    }

    /// Turn of the hand at the end of a forearm that points along `fore`.
    fn turn_hand(&self, arm: &Arm, fore: Vec3) -> Quat {
        let down = frame(fore, Vec3::NEG_Y).y_axis;
        let roll = quat_about(fore, -arm.palm.to_radians() * self.side);
        let palm = roll * down;
        let (sin, cos) = trig::sin_cos(arm.wrist.to_radians());
        turn_between(
            self.hand,
            frame(fore * cos + palm * sin, palm * cos - fore * sin),
        )
    }

    fn curl_fingers(&self, degrees: f32, pose: &mut Pose) {
        let (axis, open) = self.thumb;
        for (bone, share) in Bone::THUMBS[index_of(self.side)]
            .into_iter()
            .zip(THUMB_CLOSED)
        {
            pose.rotate(bone, quat_about(axis, share * open));
        }
        for (finger, bones) in self.fingers.iter().zip(Bone::FINGERS[index_of(self.side)]) {
            for (i, bone) in bones.into_iter().enumerate() {
                let wanted = RELAXED_FINGER[i] + WAVE_OF_JOINTS[i] * degrees;
                let curl = quat_about(finger.curl, wanted.to_radians() - finger.bent[i]);
                let turn = match i {
                    0 => quat_about(finger.palm, -GATHERED * finger.spread) * curl,
                    _ => curl,
                };
                pose.rotate(bone, turn);
            }
        }
    }
}

/// One finger in the bind pose, where it is spread and bent.
#[derive(Debug, Clone, Copy)]
struct FingerRig {
    /// Axis about which it curls toward the palm, and the direction out of the palm.
    curl: Vec3,
    palm: Vec3,
    /// Angle [rad] about `palm` from the hand's direction to the finger's.
    spread: f32,
    /// Bend [rad] of its joints about `curl`.
    bent: [f32; 3],
}

impl FingerRig {
    fn new(skeleton: &Skeleton, bones: [Bone; 3], hand: Mat3) -> Self {
        let [root, middle, last] = bones.map(|bone| skeleton.joint(bone));
        // Components along the hand, out of the palm and across it.
        let first = hand.transpose() * (middle - root);
        let second = hand.transpose() * (last - middle);
        let bend = |v: Vec3| trig::atan2(v.y, v.x);
        // The last bone has no joint at its end; fingers bend there about as at the middle joint.
        let middle_bend = bend(second) - bend(first);
        Self {
            curl: hand.z_axis,
            palm: hand.y_axis,
            spread: trig::atan2(-first.z, first.x),
            bent: [bend(first), middle_bend, 0.5 * middle_bend],
        }
    }
}

/// `turn` with the least additional rotation that carries the bind direction `from` to `to`.
fn swing(turn: Quat, from: Vec3, to: Vec3) -> Quat {
    Quat::from_rotation_arc(turn * from, to) * turn
}

/// Angle [rad] by which `turn` rotates about the unit vector `axis`.
fn twist_about(turn: Quat, axis: Vec3) -> f32 {
    let turn = if turn.w < 0.0 { -turn } else { turn };
    2.0 * trig::atan2(turn.xyz().dot(axis), turn.w)
}
