//! Room for a skirt: arms of a recording that would hang in its folds are brought out of it.
//!
//! Who was recorded wore no skirt. Its room is a cone about the pelvis, elliptical, from the waist down,
//! and what folds take around trunk and legs, wherever these go; an arm that reaches into either is
//! turned about its shoulder, the shortest way out. Where the arms end is continuous in the pose, so
//! that the dance stays smooth.

use glam::{Affine3A, Quat, Vec2, Vec3};
use lole_body::{Bone, Dancer, Pose};
use lole_geom::Capsule;

/// Half the hips' width over the place of a hip joint aside, and their depth over their width, in
/// measured women and men.
const HIP_OVER_JOINT: f32 = 2.0;
const DEPTH_OVER_WIDTH: f32 = 0.72;
/// What folds take between the skin and an arm [m]: a little more than what an arm is taken from the
/// cloth at, because there it finds no room (`lole_stage`).
const FOLDS: f32 = 0.036;
/// Half a hand [m]: it hangs beside the skirt with its side or its palm.
const HALF_HAND: f32 = 0.015;
/// How much wider a skirt is a meter farther down [m].
const FLARE: f32 = 0.3;
/// Height over the waist in which the room begins [m].
const FADE: f32 = 0.06;
/// Farthest that an arm is brought at a time [m], and how often.
const MOST: f32 = 0.12;
const PASSES: usize = 6;
/// Places along the upper arm and the forearm at which an arm is looked at.
const UPPER_SHARES: [f32; 1] = [0.8];
const LOWER_SHARES: [f32; 5] = [0.0, 0.2, 0.4, 0.65, 0.9];
/// Half of the stretch of a limb, over its length, whose flesh a place along it stands for.
const STRETCH: f32 = 0.12;

/// The room of a skirt, in the pelvis's bind pose [m].
pub(crate) struct Room<'a> {
    dancer: &'a Dancer,
    waist: Vec3,
    hip: Vec3,
    arms: [Vec<Flesh>; 2],
}

/// A place in the axis of an arm.
struct Flesh {
    bone: Bone,
    /// In the bind pose [m].
    place: Vec3,
    /// Of the flesh around it [m].
    radius: f32,
}

/// A body from waist to ankle as it stands.
struct Body {
    pelvis: Affine3A,
    capsules: Vec<Capsule>,
}

impl<'a> Room<'a> {
    /// The room on a body; nothing where its waist was not measured.
    pub(crate) fn of(dancer: &'a Dancer) -> Option<Self> {
        let skeleton = &dancer.skeleton;
        let (waist, hip) = (skeleton.waist_side, skeleton.joint(Bone::LeftUpperLeg));
        let arms = [0, 1].map(|side| arm(dancer, side));
        (hip.y < waist.y && 0.0 < hip.x && 0.0 < waist.x).then_some(Self {
            dancer,
            waist,
            hip,
            arms,
        })
    }

    /// Brings the arms of a pose out.
    pub(crate) fn clear(&self, pose: &mut Pose) {
        let skeleton = &self.dancer.skeleton;
        let world = skeleton.world_from_bind(pose);
        // The arms move, and nothing that they are brought out of.
        let capsules = self.dancer.capsules.iter();
        let body = Body {
            pelvis: world[Bone::Hips.index()],
            capsules: capsules.map(|it| it.posed(&world)).collect(),
        };
        for ([_, upper, ..], arm) in Bone::ARMS.into_iter().zip(&self.arms) {
            for _ in 0..PASSES {
                let world = skeleton.world_from_bind(pose);
                let Some(turn) = self.way_out(&body, &world, (upper, arm)) else {
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

    /// The turn about the shoulder, in the world, that brings the deepest place of an arm out.
    fn way_out(
        &self,
        body: &Body,
        world: &[Affine3A],
        (upper, arm): (Bone, &[Flesh]),
    ) -> Option<Quat> {
        let skeleton = &self.dancer.skeleton;
        let pelvis_from_world = body.pelvis.inverse();
        let side = skeleton.joint(upper).x.signum();
        let outward = arm.iter().map(|flesh| {
            let place = world[flesh.bone.index()].transform_point3(flesh.place);
            let in_pelvis = pelvis_from_world.transform_point3(place);
            let margin = FOLDS + flesh.radius;
            let cone = self.outward(in_pelvis, (side, margin));
            let cone = body.pelvis.transform_vector3(cone);
            let begins = self.begins(in_pelvis.y);
            let flesh = away_from(&body.capsules, place, margin) * begins;
            let farther = if cone.length() < flesh.length() {
                flesh
            } else {
                cone
            };
            (place, farther)
        });
        let (place, way) = outward.max_by(|(_, a), (_, b)| a.length().total_cmp(&b.length()))?;
        if way.length() < 1.0e-4 {
            return None;
        }
        let shoulder = world[upper.index()].transform_point3(skeleton.joint(upper));
        let from = (place - shoulder).try_normalize()?;
        let to = (place + way - shoulder).try_normalize()?;
        Some(Quat::from_rotation_arc(from, to))
    }

    /// 1 from the waist down, 0 from a little above it.
    fn begins(&self, height: f32) -> f32 {
        smooth((self.waist.y + FADE - height) / FADE)
    }

    /// How far and where a place in the pelvis's bind pose is to be brought, level, to be so far off the
    /// hips [m]; nothing outside.
    fn outward(&self, place: Vec3, (side, margin): (f32, f32)) -> Vec3 {
        let below = smooth((self.waist.y - place.y) / (self.waist.y - self.hip.y));
        let waist = self.waist.x;
        let width = waist + (HIP_OVER_JOINT * self.hip.x - waist) * below;
        let spread = margin + FLARE * (self.hip.y - place.y).max(0.0);
        let axes = Vec2::new(width + spread, DEPTH_OVER_WIDTH * width + spread);
        // A place on the axis is nearer to its own side.
        let from_axis = Vec2::new(place.x + side * 0.02, place.z - self.hip.z);
        let reach = (from_axis / axes).length();
        let begins = self.begins(place.y);
        if !(reach < 1.0 && 0.0 < begins) {
            return Vec3::ZERO;
        }
        let way = from_axis * (reach.max(0.05).recip() - 1.0) * begins;
        let way = way.clamp_length_max(MOST);
        Vec3::new(way.x, 0.0, way.y)
    }
}

/// Places along an arm with the flesh around them, and those that show where its hand is.
fn arm(dancer: &Dancer, side: usize) -> Vec<Flesh> {
    let [_, upper, lower, hand] = Bone::ARMS[side];
    let joint = |bone| dancer.skeleton.joint(bone);
    let limb = |bone: Bone, end: Vec3, share: f32| Flesh {
        bone,
        place: joint(bone).lerp(end, share),
        radius: flesh_around(dancer, bone, (end, share)),
    };
    let [_, [knuckle, _, tip], ..] = Bone::FINGERS[side];
    let of_hand = |bone: Bone| Flesh {
        bone,
        place: joint(bone),
        radius: HALF_HAND,
    };
    let uppers = UPPER_SHARES.map(|share| limb(upper, joint(lower), share));
    let lowers = LOWER_SHARES.map(|share| limb(lower, joint(hand), share));
    let hands = [hand, knuckle, tip].map(of_hand);
    uppers.into_iter().chain(lowers).chain(hands).collect()
}

/// Mean distance of the skin that a bone carries most from the axis to `end`, about a share of the way
/// there [m]; half a hand where it carries none.
fn flesh_around(dancer: &Dancer, bone: Bone, (end, share): (Vec3, f32)) -> f32 {
    let start = dancer.skeleton.joint(bone);
    let axis = end - start;
    let skin = &dancer.skin;
    let carried = (skin.positions.iter().zip(&skin.joints))
        .filter(|(_, joints)| usize::from(joints[0]) == bone.index());
    let (mut sum, mut count) = (0.0, 0.0);
    for (&position, _) in carried {
        let along = (position - start).dot(axis) / axis.length_squared().max(f32::MIN_POSITIVE);
        if (along - share).abs() < STRETCH {
            sum += (position - start - axis * along).length();
            count += 1.0;
        }
    }
    if count < 1.0 { HALF_HAND } else { sum / count }
}

/// The way [m] that brings a place as far as `margin` from all capsules: the mean of the ways out of
/// each, by how far it is, so that it grows from nothing where another one comes near.
fn away_from(capsules: &[Capsule], place: Vec3, margin: f32) -> Vec3 {
    let (mut sum, mut weights) = (Vec3::ZERO, 0.0);
    for capsule in capsules {
        let missing = margin - capsule.signed_distance(place);
        if 0.0 < missing {
            let [start, end] = capsule.ends;
            let foot = start.lerp(end, capsule.axis_parameter(place));
            sum += (place - foot).normalize_or_zero() * (missing * missing);
            weights += missing;
        }
    }
    if weights <= 0.0 {
        return Vec3::ZERO;
    }
    (sum / weights).clamp_length_max(MOST)
}

fn smooth(share: f32) -> f32 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

#[cfg(test)]
mod tests {
    use super::*;
    use lole_body::{Measurements, Skeleton};

    /// The left arm straight down, straight out, or between.
    fn hanging(skeleton: &Skeleton, degrees: f32) -> Pose {
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
        let dancer = Dancer::new(&Measurements::woman()).expect("a woman");
        let skeleton = &dancer.skeleton;
        let room = Room::of(&dancer).expect("she has a waist");
        let cleared = |degrees| {
            let mut pose = hanging(skeleton, degrees);
            room.clear(&mut pose);
            pose
        };
        let hand = |pose: &Pose| {
            let world = skeleton.world_from_bind(pose);
            world[Bone::LeftHand.index()].transform_point3(skeleton.joint(Bone::LeftHand))
        };
        let [before, cleared_hand] = [hand(&hanging(skeleton, 0.0)), hand(&cleared(0.0))];
        assert!(0.02 < cleared_hand.x - before.x, "{before} {cleared_hand}");
        assert_eq!(
            room.outward(cleared_hand, (1.0, FOLDS + HALF_HAND))
                .length()
                .max(0.005),
            0.005
        );
        for degrees in [60.0, 90.0, 120.0] {
            assert_eq!(cleared(degrees), hanging(skeleton, degrees), "{degrees}");
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
