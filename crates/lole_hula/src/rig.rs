//! Turns a figure into joint rotations on one skeleton.
//!
//! Order: pelvis, then the spine that keeps shoulders and head in place above it, then the legs
//! to the feet, then the arms. The pelvis sinks, softly, where a leg would otherwise be too short.

use glam::{Quat, Vec2, Vec3};
use lole_body::{Bone, Pose, Skeleton};
use lole_geom::trig;

use super::ease::{soft_max, soft_min};
use super::figure::{Figure, Foot, Pelvis, Place};
use super::limbs::{ArmRig, LegRig};
use super::score::Score;
use super::settings::{MotionError, MotionSettings};

/// Legs (hip joint to ankle) of the fitted woman [statures]: thigh 0.225 and shank 0.236.
const LEGS_PER_STATURE: f32 = 0.461;
/// How far behind the ankles the hip joints stand [statures]: the weight is on the heels.
const HIPS_BEHIND_ANKLES: f32 = 0.010;
/// Part of the sway that the shoulders and the head take part in: 1.4 cm of 7 cm in kaʻo.
const SWAY_OF_SHOULDERS: f32 = 0.18;
/// Straightest knee of a dancing leg [°].
const LEAST_KNEE_DEGREES: f32 = 11.0;
/// Room for the hips to sway while the feet are farthest apart [statures].
const SHIFT_IN_STRIDE: f32 = 0.04;
/// Width over which the pelvis gives way to a short leg [statures], 1 cm.
const GIVE_WAY: f32 = 0.0065;

/// Width over which the pelvis gives way to the side to a short leg [statures], 3 cm.
const GIVE_WAY_ASIDE: f32 = 0.02;

/// Measures of one skeleton that every pose needs.
#[derive(Debug, Clone)]
pub(super) struct Rig {
    /// Stature that fits the legs [m]; the unit of figures.
    stature: f32,
    /// Middle between the hip joints in the bind pose [m].
    hip_middle: Vec3,
    hips: Vec3,
    spine: Vec3,
    chest: Vec3,
    upper_chest: Vec3,
    legs: [LegRig; 2],
    arms: [ArmRig; 2],
}

impl Rig {
    /// Measures `skeleton`.
    pub(super) fn new(skeleton: &Skeleton) -> Result<Self, MotionError> {
        let legs = [LegRig::new(skeleton, 1.0)?, LegRig::new(skeleton, -1.0)?];
        let arms = [ArmRig::new(skeleton, 1.0)?, ArmRig::new(skeleton, -1.0)?];
        let leg = 0.5 * (legs[0].length() + legs[1].length());
        Ok(Self {
            stature: leg / LEGS_PER_STATURE,
            hip_middle: 0.5 * (legs[0].hip + legs[1].hip),
            hips: skeleton.joint(Bone::Hips),
            spine: skeleton.joint(Bone::Spine),
            chest: skeleton.joint(Bone::Chest),
            upper_chest: skeleton.joint(Bone::UpperChest),
            legs,
            arms,
        })
    }

    /// Height of the middle between the hip joints [m] while standing even as `settings` say; low
    /// enough for both legs to reach in the widest step.
    pub(super) fn standing_height(&self, settings: &MotionSettings, score: &Score) -> f32 {
        let leg = &self.legs[0];
        let behind = HIPS_BEHIND_ANKLES * self.stature;
        let height = |knee_degrees: f32, feet_apart: f32, shift: f32| {
            let aside = (0.5 * feet_apart + shift) * self.stature - (leg.hip.x - self.hip_middle.x);
            let chord = leg.chord(knee_degrees);
            leg.ankle.y
                + (chord * chord - aside * aside - behind * behind)
                    .max(0.0)
                    .sqrt()
        };
        let standing =
            height(settings.knee_degrees, settings.stance_width, 0.0) - score.sink * self.stature;
        let stride = score.stride.length(settings);
        standing.min(height(LEAST_KNEE_DEGREES + 4.0, stride, SHIFT_IN_STRIDE))
    }

    /// From the ankle to the ball of each foot, flat [statures], `[x, z]`.
    pub(super) fn to_balls(&self) -> [[f32; 2]; 2] {
        [0, 1].map(|side| {
            let to_ball = (self.legs[side].ball - self.legs[side].ankle) / self.stature;
            [to_ball.x, to_ball.z]
        })
    }

    /// Pose of `figure` for a pelvis that stands `standing_height` [m] high.
    ///
    /// The body is solved as if it faced the front, and turned to its heading at the end.
    pub(super) fn pose(&self, figure: &Figure, standing_height: f32) -> Pose {
        let heading = figure.pelvis.heading;
        if heading == 0.0 {
            return self.pose_facing_front(figure, standing_height);
        }
        let front = Place {
            heading: -heading,
            ..Place::default()
        };
        let mut ahead = figure.placed(&front);
        ahead.feet = figure.feet.map(|foot| front.foot(foot));
        let mut pose = self.pose_facing_front(&ahead, standing_height);
        // The floor turns about the middle between the ankles of the bind pose.
        let turn = quat_y(heading.to_radians());
        let middle = Vec3::new(self.hip_middle.x, 0.0, self.ankle_line());
        let hips = pose.hips_translation + self.hips - middle;
        pose.hips_translation = turn * hips + middle - self.hips;
        pose.rotate(Bone::Hips, turn * pose.rotation(Bone::Hips));
        pose
    }

    /// Where the ankles stand in the bind pose, along `+Z` [m].
    fn ankle_line(&self) -> f32 {
        0.5 * (self.legs[0].ankle + self.legs[1].ankle).z
    }

    /// Stature by the legs [m].
    pub(super) const fn stature(&self) -> f32 {
        self.stature
    }

    fn pose_facing_front(&self, figure: &Figure, standing_height: f32) -> Pose {
        let mut pose = Pose::default();
        let pelvis_turn = pelvis_turn(&figure.pelvis);
        let feet = [0, 1].map(|side| self.legs[side].place_foot(&figure.feet[side], self.stature));
        let pelvis = self.within_reach(&figure.pelvis, &feet, pelvis_turn, standing_height);
        let (spine_turn, chest_turn) = self.spine_turns(&pelvis, pelvis_turn);
        let lean = |share: f32| quat_z(-(share * pelvis.lean).to_radians());
        let (spine_turn, chest_turn) = (lean(0.4) * spine_turn, lean(0.75) * chest_turn);
        let upper_turn = lean(1.0);

        // The head keeps its height; the pelvis takes what the bent spine lost.
        let straight = self.upper_chest - self.hip_middle;
        let bent = pelvis_turn * (self.spine - self.hip_middle)
            + spine_turn * (self.chest - self.spine)
            + chest_turn * (self.upper_chest - self.chest);
        let wanted = standing_height - pelvis.drop * self.stature + straight.y - bent.y;
        let mut middle = self.pelvis_on_floor(&pelvis);
        middle.y = wanted;
        for (leg, foot) in self.legs.iter().zip(&feet) {
            let hip_offset = pelvis_turn * (leg.hip - self.hip_middle);
            let highest = leg.highest_hip(middle + hip_offset, foot.ankle, LEAST_KNEE_DEGREES);
            middle.y = soft_min(middle.y, highest - hip_offset.y, GIVE_WAY * self.stature);
        }

        pose.hips_translation = middle + pelvis_turn * (self.hips - self.hip_middle) - self.hips;
        pose.rotate(Bone::Hips, pelvis_turn);
        pose.rotate(Bone::Spine, pelvis_turn.inverse() * spine_turn);
        pose.rotate(Bone::Chest, spine_turn.inverse() * chest_turn);
        pose.rotate(Bone::UpperChest, chest_turn.inverse() * upper_turn);
        // The head rights itself by half of what the body leans.
        let look = |share: f32| {
            quat_z((0.25 * pelvis.lean).to_radians())
                * quat_y((share * figure.gaze).to_radians())
                * quat_x((share * figure.nod).to_radians())
        };
        pose.rotate(Bone::Neck, look(0.35));
        pose.rotate(Bone::Head, look(0.65));
        for (leg, foot) in self.legs.iter().zip(&feet) {
            let hip = middle + pelvis_turn * (leg.hip - self.hip_middle);
            leg.solve(hip, foot, pelvis_turn, &mut pose);
        }
        for (arm, target) in self.arms.iter().zip(&figure.arms) {
            arm.solve(target, &mut pose);
        }
        pose
    }

    /// The pelvis moved to where both legs reach their feet without straightening, if the height
    /// allows it: hips that would leave a foot behind stay nearer to it.
    fn within_reach(
        &self,
        pelvis: &Pelvis,
        feet: &[PlacedFoot; 2],
        turn: Quat,
        standing_height: f32,
    ) -> Pelvis {
        let middle = self.pelvis_on_floor(pelvis);
        let height = standing_height - pelvis.drop * self.stature;
        let mut range = [f32::MIN, f32::MAX];
        for (leg, foot) in self.legs.iter().zip(feet) {
            let hip = turn * (leg.hip - self.hip_middle);
            let over = height + hip.y - foot.ankle.y;
            let ahead = middle.z + hip.z - foot.ankle.z;
            let widest = leg.widest(over, ahead, LEAST_KNEE_DEGREES + 4.0);
            let center = foot.ankle.x - hip.x;
            range = [range[0].max(center - widest), range[1].min(center + widest)];
        }
        // Feet too far apart for this height: the middle, and the pelvis will sink.
        let middle_of_range = 0.5 * (range[0] + range[1]);
        let [lowest, highest] = [range[0].min(middle_of_range), range[1].max(middle_of_range)];
        let width = GIVE_WAY_ASIDE * self.stature;
        let x = soft_max(soft_min(middle.x, highest, width), lowest, width);
        Pelvis {
            x: pelvis.x + (x - middle.x) / self.stature,
            ..*pelvis
        }
    }

    /// Middle between the hip joints seen from above [m]; its height is left at 0.
    fn pelvis_on_floor(&self, pelvis: &Pelvis) -> Vec3 {
        let ankles = 0.5 * (self.legs[0].ankle + self.legs[1].ankle);
        Vec3::new(
            self.hip_middle.x + (pelvis.travel + pelvis.x) * self.stature,
            0.0,
            ankles.z + (pelvis.ahead + pelvis.z - HIPS_BEHIND_ANKLES) * self.stature,
        )
    }

    /// World turns of the spine and the chest bone that bring the upper chest back above the feet
    /// while the pelvis sways; the upper chest itself stays level.
    fn spine_turns(&self, pelvis: &Pelvis, pelvis_turn: Quat) -> (Quat, Quat) {
        let lower = self.chest - self.spine;
        let upper = self.upper_chest - self.chest;
        let horizontal = |v: Vec3| Vec2::new(v.x, v.z);
        let sway = Vec2::new(pelvis.x, pelvis.z) * self.stature;
        let by_pelvis = self.spine - self.hip_middle;
        let carried = horizontal(pelvis_turn * by_pelvis - by_pelvis);
        let to_bend = (SWAY_OF_SHOULDERS - 1.0) * sway - carried;
        // The spine bone leans fully, the chest bone by 0.7 of it; lean is sin(angle) nearly.
        let lean = to_bend / (lower.y + 0.7 * upper.y);
        let axis = Vec3::new(lean.y, 0.0, -lean.x);
        let yaw = pelvis_yaw(pelvis);
        let spine = quat_scaled(axis) * quat_y(0.5 * yaw);
        let chest = quat_scaled(0.7 * axis) * quat_y(0.15 * yaw);
        (spine, chest)
    }
}

/// Rotation about +Y [rad] that brings the side of a positive yaw forward.
fn pelvis_yaw(pelvis: &Pelvis) -> f32 {
    -pelvis.yaw.to_radians()
}

fn pelvis_turn(pelvis: &Pelvis) -> Quat {
    quat_y(pelvis_yaw(pelvis)) * quat_x(pelvis.tilt.to_radians()) * quat_z(pelvis.roll.to_radians())
}

/// A foot in the world.
#[derive(Debug, Clone, Copy)]
pub(super) struct PlacedFoot {
    /// Ankle joint [m].
    pub ankle: Vec3,
    /// World turn of the foot bone.
    pub turn: Quat,
    /// Pitch of the foot, heel up [rad]; the toes bend back by it.
    pub pitch: f32,
    /// Direction the knee points to, horizontal.
    pub knee: Vec3,
}

impl LegRig {
    /// Where the foot bone goes: it turns about the ball, which stays where it is with a flat sole.
    fn place_foot(&self, foot: &Foot, stature: f32) -> PlacedFoot {
        let set_down = self.side * foot.turn_out.to_radians() + foot.heading.to_radians();
        let yaw = set_down + foot.twist.to_radians();
        let to_ball = self.ball - self.ankle;
        let [x, z] = [foot.x * stature, self.ankle.z + foot.z * stature];
        let flat_ankle = Vec3::new(x, self.ankle.y, z);
        let ball = flat_ankle + quat_y(set_down) * to_ball + Vec3::Y * (foot.lift * stature);
        let turn_flat = quat_y(yaw);
        let pitch = trig::asin(foot.heel * stature / self.heel_arm());
        let turn = turn_flat * quat_x(pitch);
        let inward = (-self.side * yaw).to_degrees();
        let knee_yaw = yaw + self.side * (foot.knee_out + knee_lag(inward)).to_radians();
        PlacedFoot {
            ankle: ball - turn * to_ball,
            turn,
            pitch,
            knee: quat_y(knee_yaw) * Vec3::Z,
        }
    }
}

/// By how much a knee stays behind toes that point `inward` of the body [°]: nothing up to a few
/// degrees, then more and more of it. The shank and the foot take the rest, and the thighs stay out
/// of each other.
fn knee_lag(inward: f32) -> f32 {
    const FOLLOWS: f32 = 8.0;
    const MOST: f32 = 0.9;
    let beyond = (inward - FOLLOWS).max(0.0);
    MOST * beyond * beyond / (beyond + FOLLOWS)
}

/// Rotation about +X by `angle` [rad].
pub(super) fn quat_x(angle: f32) -> Quat {
    let (sin, cos) = trig::sin_cos(0.5 * angle);
    Quat::from_xyzw(sin, 0.0, 0.0, cos)
}

/// Rotation about +Y by `angle` [rad].
pub(super) fn quat_y(angle: f32) -> Quat {
    let (sin, cos) = trig::sin_cos(0.5 * angle);
    Quat::from_xyzw(0.0, sin, 0.0, cos)
}

/// Rotation about +Z by `angle` [rad].
pub(super) fn quat_z(angle: f32) -> Quat {
    let (sin, cos) = trig::sin_cos(0.5 * angle);
    Quat::from_xyzw(0.0, 0.0, sin, cos)
}

/// Rotation about the unit vector `axis` by `angle` [rad].
pub(super) fn quat_about(axis: Vec3, angle: f32) -> Quat {
    let (sin, cos) = trig::sin_cos(0.5 * angle);
    let v = axis * sin;
    Quat::from_xyzw(v.x, v.y, v.z, cos)
}

/// Rotation whose axis and angle [rad] are the direction and length of `axis`.
fn quat_scaled(axis: Vec3) -> Quat {
    quat_about(axis.normalize_or_zero(), axis.length())
}
