//! Room for a skirt: hands of a recording that would hang in its folds are brought out of it.
//!
//! Who was recorded wore no skirt. Its room is a cone about the pelvis, elliptical, from the waist down;
//! an arm that reaches into it is turned about its shoulder, the shortest way out. Where the hands
//! end is continuous in the pose, so that the dance stays smooth.

use glam::{Affine3A, Quat, Vec2, Vec3};
use lole_body::{Bone, Pose, Skeleton};

/// Half the hips' width over the place of a hip joint aside, and their depth over their width, in
/// measured women and men.
const HIP_OVER_JOINT: f32 = 2.0;
const DEPTH_OVER_WIDTH: f32 = 0.72;
/// Folds and half a hand, side by side [m].
const MARGIN: f32 = 0.05;
/// How much wider a skirt is a meter farther down [m].
const FLARE: f32 = 0.3;
/// Height over the waist in which the room begins [m].
const FADE: f32 = 0.06;
/// Farthest that a hand is brought at a time [m], and how often.
const MOST: f32 = 0.12;
const PASSES: usize = 4;

/// The room of a skirt, in the pelvis's bind pose [m].
pub(crate) struct Room {
    waist: Vec3,
    hip: Vec3,
}

impl Room {
    /// The room on a body; nothing where its waist was not measured.
    pub(crate) fn of(skeleton: &Skeleton) -> Option<Self> {
        let (waist, hip) = (skeleton.waist_side, skeleton.joint(Bone::LeftUpperLeg));
        (hip.y < waist.y && 0.0 < hip.x && 0.0 < waist.x).then_some(Self { waist, hip })
    }

    /// Brings the hands of a pose out.
    pub(crate) fn clear(&self, skeleton: &Skeleton, pose: &mut Pose) {
        for ([_, upper, lower, hand], fingers) in Bone::ARMS.into_iter().zip(Bone::FINGERS) {
            let [_, [knuckle, _, tip], ..] = fingers;
            let arm = (upper, lower, [hand, knuckle, tip]);
            for _ in 0..PASSES {
                let world = skeleton.world_from_bind(pose);
                let Some(turn) = self.way_out(skeleton, &world, &arm) else {
                    break;
                };
                let parent = upper.parent().map_or(Quat::IDENTITY, |bone| {
                    Quat::from_mat3a(&world[bone.index()].matrix3)
                });
                let turned = parent.inverse() * turn * parent * pose.rotation(upper);
                pose.rotate(upper, turned.normalize());
            }
        }
    }

    /// The turn about the shoulder, in the world, that brings the deepest joint of an arm out: its upper
    /// arm, its forearm, and the joints that show where its hand is.
    fn way_out(
        &self,
        skeleton: &Skeleton,
        world: &[Affine3A],
        (upper, lower, hand): &(Bone, Bone, [Bone; 3]),
    ) -> Option<Quat> {
        let at = |bone: Bone| world[bone.index()].transform_point3(skeleton.joint(bone));
        let pelvis = world[Bone::Hips.index()];
        let pelvis_from_world = pelvis.inverse();
        let side = skeleton.joint(*upper).x.signum();
        let wrist = at(hand[0]);
        let places = hand.map(at).into_iter().chain([at(*lower).midpoint(wrist)]);
        let outward = places.map(|place| {
            let way = self.outward(pelvis_from_world.transform_point3(place), side);
            (place, way)
        });
        let (place, way) = outward.max_by(|(_, a), (_, b)| a.length().total_cmp(&b.length()))?;
        if way.length() < 1.0e-4 {
            return None;
        }
        let shoulder = at(*upper);
        let moved = place + pelvis.transform_vector3(way);
        let from = (place - shoulder).try_normalize()?;
        let to = (moved - shoulder).try_normalize()?;
        Some(Quat::from_rotation_arc(from, to))
    }

    /// How far and where a place in the pelvis's bind pose is to be brought, level; nothing outside.
    fn outward(&self, place: Vec3, side: f32) -> Vec3 {
        let below = smooth((self.waist.y - place.y) / (self.waist.y - self.hip.y));
        let waist = self.waist.x;
        let width = waist + (HIP_OVER_JOINT * self.hip.x - waist) * below;
        let spread = MARGIN + FLARE * (self.hip.y - place.y).max(0.0);
        let axes = Vec2::new(width + spread, DEPTH_OVER_WIDTH * width + spread);
        // A place on the axis is nearer to its own side.
        let from_axis = Vec2::new(place.x + side * 0.02, place.z - self.hip.z);
        let reach = (from_axis / axes).length();
        let begins = smooth((self.waist.y + FADE - place.y) / FADE);
        if !(reach < 1.0 && 0.0 < begins) {
            return Vec3::ZERO;
        }
        let way = from_axis * (reach.max(0.05).recip() - 1.0) * begins;
        let way = way.clamp_length_max(MOST);
        Vec3::new(way.x, 0.0, way.y)
    }
}

fn smooth(share: f32) -> f32 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

#[cfg(test)]
mod tests {
    use super::*;
    use lole_body::{Dancer, Measurements};

    /// The left arm straight down, straight out, or between.
    fn arm(skeleton: &Skeleton, degrees: f32) -> Pose {
        let joint = |bone| skeleton.joint(bone);
        let from = joint(Bone::LeftHand) - joint(Bone::LeftUpperArm);
        let (sin, cos) = lole_geom::trig::sin_cos(degrees.to_radians());
        let mut pose = Pose::default();
        let turn = Quat::from_rotation_arc(from.normalize_or_zero(), Vec3::new(sin, -cos, 0.0));
        pose.rotate(Bone::LeftUpperArm, turn);
        pose
    }

    #[test]
    fn a_hanging_hand_is_brought_out_and_a_raised_one_stays() {
        let skeleton = Dancer::new(&Measurements::woman())
            .expect("a woman")
            .skeleton;
        let room = Room::of(&skeleton).expect("she has a waist");
        let cleared = |degrees| {
            let mut pose = arm(&skeleton, degrees);
            room.clear(&skeleton, &mut pose);
            pose
        };
        let hand = |pose: &Pose| {
            let world = skeleton.world_from_bind(pose);
            world[Bone::LeftHand.index()].transform_point3(skeleton.joint(Bone::LeftHand))
        };
        let [hanging, cleared_hand] = [hand(&arm(&skeleton, 0.0)), hand(&cleared(0.0))];
        assert!(
            0.02 < cleared_hand.x - hanging.x,
            "{hanging} {cleared_hand}"
        );
        assert_eq!(room.outward(cleared_hand, 1.0).length().max(0.005), 0.005);
        for degrees in [60.0, 90.0, 120.0] {
            assert_eq!(cleared(degrees), arm(&skeleton, degrees), "{degrees}");
        }
        // Nothing jumps as the arm sinks.
        let mut before = hand(&cleared(60.0));
        for step in 1..=120 {
            let here = hand(&cleared(60.0 - 0.5 * step as f32));
            assert!(here.distance(before) < 0.02, "{step}: {before} {here}");
            before = here;
        }
    }
}
