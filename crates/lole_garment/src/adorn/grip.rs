//! Hands that hold something: fingers close around it, and an arm may come down to the side.

use glam::{Mat3, Quat, Vec3};
use lole_body::{Bone, Pose, Side, Skeleton};
use lole_geom::trig;

/// A hand closed around something.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grip {
    /// The hand.
    pub side: Side,
    /// Thickness of what it holds [m].
    pub thickness: f32,
    /// Where the thumb's side of the fist is turned, in the world, as far as a forearm turns; the dance has
    /// it where this is `None`.
    pub facing: Option<Vec3>,
    /// Where upper arm and forearm point while it is held at the side of the body, in the directions
    /// of the chest; the dance has the arm where this is `None`.
    pub arm: Option<[Vec3; 2]>,
}

/// Bones of one arm.
struct Arm {
    upper: Bone,
    lower: Bone,
    hand: Bone,
    thumb: [Bone; 3],
    fingers: [[Bone; 3]; 4],
    /// +1 left, -1 right.
    sign: f32,
}

fn arm(side: Side) -> Arm {
    let (place, sign) = match side {
        Side::Left => (0, 1.0),
        Side::Right => (1, -1.0),
    };
    let [_, upper, lower, hand] = Bone::ARMS[place];
    Arm {
        upper,
        lower,
        hand,
        thumb: Bone::THUMBS[place],
        fingers: Bone::FINGERS[place],
        sign,
    }
}

/// Bend of the three joints of a finger around a thin stick, and around one of 8 cm [°].
const THIN: [f32; 3] = [72.0, 88.0, 48.0];
const THICK: [f32; 3] = [38.0, 42.0, 26.0];
const THICKEST: f32 = 0.08;

/// The hand in the bind pose: along it, out of its palm and from the index to the little finger.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Palm {
    /// Unit directions.
    pub(crate) along: Vec3,
    pub(crate) out: Vec3,
    pub(crate) to_little: Vec3,
    /// Middle of the palm's skin [m].
    pub(crate) center: Vec3,
    pub(crate) hand: Bone,
}

impl Palm {
    /// The palm of one hand, `half` [m] being half the thickness of the flesh there.
    pub(crate) fn new(skeleton: &Skeleton, side: Side, half: f32) -> Self {
        let arm = &arm(side);
        let joint = |bone: Bone| skeleton.joint(bone);
        let [index, middle, _, little] = arm.fingers.map(|finger| joint(finger[0]));
        let frame = hand_frame(skeleton, arm);
        let wrist = joint(arm.hand);
        let knuckles = (index + middle + little) / 3.0;
        Self {
            along: frame.x_axis,
            out: frame.y_axis,
            to_little: (frame.z_axis * (little - index).dot(frame.z_axis)).normalize_or_zero(),
            center: wrist.lerp(knuckles, 0.86) + frame.y_axis * half,
            hand: arm.hand,
        }
    }
}

/// Along the hand, out of the palm, and the axis about which fingers curl towards it.
fn hand_frame(skeleton: &Skeleton, arm: &Arm) -> Mat3 {
    let joint = |bone: Bone| skeleton.joint(bone);
    let [index, middle, _, little] = arm.fingers.map(|finger| joint(finger[0]));
    let along = (middle - joint(arm.hand)).normalize_or(Vec3::X);
    let palm = (little - index).cross(along) * arm.sign;
    let curl = along.cross(palm).normalize_or(Vec3::Z);
    Mat3::from_cols(along, curl.cross(along), curl)
}

impl Grip {
    /// Closes the hand of a pose, and brings its arm to the side if it is held there.
    pub fn apply(&self, skeleton: &Skeleton, pose: &mut Pose) {
        let arm = &arm(self.side);
        if let Some([upper, fore]) = self.arm {
            hold_at_side(skeleton, arm, [upper, fore], pose);
        }
        let frame = hand_frame(skeleton, arm);
        let share = (self.thickness / THICKEST).clamp(0.0, 1.0);
        for finger in arm.fingers {
            let [root, middle, last] = finger.map(|bone| frame.transpose() * skeleton.joint(bone));
            let bend = |way: Vec3| trig::atan2(way.y, way.x);
            let first = bend(middle - root);
            let second = bend(last - middle) - first;
            let bent = [first, second, 0.5 * second];
            for (joint, bone) in finger.into_iter().enumerate() {
                let wanted = THIN[joint] + (THICK[joint] - THIN[joint]) * share;
                let turn = wanted.to_radians() - bent[joint];
                pose.rotate(bone, Quat::from_axis_angle(frame.z_axis, turn));
            }
        }
        close_thumb(skeleton, arm, frame, share, pose);
        if let Some(facing) = self.facing {
            turn_fist(skeleton, arm, facing, pose);
        }
    }
}

/// Farthest that forearm and wrist turn about themselves [rad].
const MOST_TURN: f32 = 2.3;

/// Turns forearm and hand about themselves until the thumb's side looks in a direction of the world.
fn turn_fist(skeleton: &Skeleton, arm: &Arm, facing: Vec3, pose: &mut Pose) {
    let joint = |bone: Bone| skeleton.joint(bone);
    let frame = hand_frame(skeleton, arm);
    let to_thumb = joint(arm.fingers[0][0]) - joint(arm.fingers[3][0]);
    let lower = turned(pose, arm.lower);
    let hand = lower * pose.rotation(arm.hand);
    let along = (hand * frame.x_axis).normalize_or(Vec3::X);
    let square = |v: Vec3| v - along * v.dot(along);
    let (from, to) = (square(hand * to_thumb), square(facing));
    let turn = trig::atan2(from.cross(to).dot(along), from.dot(to));
    // Where it looks nearly along the arm, no turn brings it nearer.
    let worth = (to.length() / 0.4).min(1.0);
    let turn = turn.clamp(-MOST_TURN, MOST_TURN) * worth;
    let fore = (lower * (joint(arm.hand) - joint(arm.lower))).normalize_or(along);
    let lower_after = Quat::from_axis_angle(fore, 0.55 * turn) * lower;
    let hand_after = Quat::from_axis_angle(along, turn) * hand;
    let upper = turned(pose, arm.upper);
    pose.rotate(arm.lower, upper.inverse() * lower_after);
    pose.rotate(arm.hand, lower_after.inverse() * hand_after);
}

/// How a bone of a pose is turned in the world.
fn turned(pose: &Pose, bone: Bone) -> Quat {
    let turns = bone.lineage().map(|bone| pose.rotation(bone));
    turns.fold(Quat::IDENTITY, |turn, above| above * turn)
}

/// Lays the thumb over the fingers.
fn close_thumb(skeleton: &Skeleton, arm: &Arm, frame: Mat3, share: f32, pose: &mut Pose) {
    let [root, middle, last] = arm.thumb.map(|bone| skeleton.joint(bone));
    let thumb = (last - root).normalize_or(frame.x_axis);
    let little = skeleton.joint(arm.fingers[3][0]) - skeleton.joint(arm.fingers[0][0]);
    // In front of the palm, over what is held, the tip towards the little finger.
    let wanted = (frame.x_axis * 0.55
        + frame.y_axis * (0.75 + 0.2 * share)
        + little.normalize_or_zero() * 0.25)
        .normalize_or(thumb);
    let whole = Quat::from_rotation_arc(thumb, wanted);
    pose.rotate(arm.thumb[0], Quat::IDENTITY.slerp(whole, 0.55));
    pose.rotate(arm.thumb[1], Quat::IDENTITY.slerp(whole, 0.35));
    let bend = (middle - root)
        .cross(frame.y_axis)
        .normalize_or(frame.z_axis);
    pose.rotate(arm.thumb[2], Quat::from_axis_angle(bend, 0.5 - 0.3 * share));
}

/// Turns upper arm and forearm into two directions of the chest; the hand goes on straight.
fn hold_at_side(skeleton: &Skeleton, arm: &Arm, [upper, fore]: [Vec3; 2], pose: &mut Pose) {
    let joint = |bone: Bone| skeleton.joint(bone);
    let clavicle = arm.upper.parent().map_or(Quat::IDENTITY, |bone| {
        pose.rotate(bone, Quat::IDENTITY);
        Quat::IDENTITY
    });
    let [elbow, wrist] = [joint(arm.lower), joint(arm.hand)];
    let bind_upper = (elbow - joint(arm.upper)).normalize_or(Vec3::X);
    let bind_fore = (wrist - elbow).normalize_or(Vec3::X);
    let turned = Quat::from_rotation_arc(bind_upper, upper.normalize_or(Vec3::NEG_Y));
    let bent = Quat::from_rotation_arc(turned * bind_fore, fore.normalize_or(Vec3::NEG_Y)) * turned;
    pose.rotate(arm.upper, clavicle.inverse() * turned);
    pose.rotate(arm.lower, turned.inverse() * bent);
    pose.rotate(arm.hand, Quat::IDENTITY);
}
