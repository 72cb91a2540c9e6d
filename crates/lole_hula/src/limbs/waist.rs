//! A hand on the waist: the arm that brings it to the skin, wherever hips and spine have gone.

use glam::{Quat, Vec3};
use lole_body::ik::two_bone;
use lole_body::{Bone, Pose, Skeleton};
use lole_geom::trig;

use super::super::figure::Arm;
use super::index_of;

/// From the skin of the waist out to the wrist joint, of the upper arm: 4 cm on the mean woman, half
/// a wrist and what the ball of the thumb is thicker.
const WRIST_OFF_SKIN: f32 = 0.17;
/// Which way elbows point: to the side, down, to the back.
const ELBOW: [f32; 3] = [0.80, -0.10, -0.60];
/// Turn of the hand about the forearm: its palm lies on the waist [°].
const PALM: f32 = 84.0;
/// The wrist bends back at most this far [°].
const MOST_WRIST: f32 = 62.0;

/// What one arm needs to know of the trunk.
#[derive(Debug, Clone)]
pub(super) struct WaistRig {
    /// +1 left, −1 right.
    side: f32,
    /// Joints of spine, chest, upper chest, clavicle and shoulder [m].
    spine: Vec3,
    chest: Vec3,
    upper_chest: Vec3,
    clavicle: Vec3,
    shoulder: Vec3,
    /// Upper arm and forearm [m].
    lengths: [f32; 2],
    /// Where the wrist comes to be in the bind pose [m].
    wrist: Vec3,
}

impl WaistRig {
    pub(super) fn new(skeleton: &Skeleton, side: f32) -> Self {
        let [clavicle, upper, lower, hand] =
            Bone::ARMS[index_of(side)].map(|bone| skeleton.joint(bone));
        let mirror = Vec3::new(side, 1.0, 1.0);
        let out = Vec3::X * (WRIST_OFF_SKIN * upper.distance(lower));
        Self {
            side,
            spine: skeleton.joint(Bone::Spine),
            chest: skeleton.joint(Bone::Chest),
            upper_chest: skeleton.joint(Bone::UpperChest),
            clavicle,
            shoulder: upper,
            lengths: [upper.distance(lower), lower.distance(hand)],
            wrist: (skeleton.waist_side + out) * mirror,
        }
    }

    /// Where the wrist comes to be, in the bind space of the upper chest [m].
    pub(super) fn in_chest(&self, pose: &Pose) -> Vec3 {
        let [chest_turn, upper_turn] =
            [Bone::Chest, Bone::UpperChest].map(|bone| pose.rotation(bone));
        let in_spine = self.wrist - self.spine;
        let to_chest = self.chest - self.spine;
        let in_chest_bone = chest_turn.inverse() * (in_spine - to_chest);
        let to_upper = self.upper_chest - self.chest;
        self.upper_chest + upper_turn.inverse() * (in_chest_bone - to_upper)
    }

    /// The arm from the shoulder, moved by the `clavicle`, to the `wrist` in chest space.
    pub(super) fn arm(&self, wrist: Vec3, clavicle: Quat) -> Arm {
        let mirror = Vec3::new(self.side, 1.0, 1.0);
        let shoulder = self.clavicle + clavicle * (self.shoulder - self.clavicle);
        let elbow = Vec3::from_array(ELBOW) * mirror;
        let limb = two_bone(shoulder, wrist, self.lengths, elbow);
        let angles = |direction: Vec3| {
            let own = direction * mirror;
            let azimuth = trig::atan2(own.z, own.x).to_degrees();
            // Behind the back counts from the front over the other side, as forearms do.
            let azimuth = if azimuth < -90.0 {
                azimuth + 360.0
            } else {
                azimuth
            };
            (azimuth, trig::asin(own.y).to_degrees())
        };
        let (azimuth, elevation) = angles(limb.upper);
        let (fore_azimuth, fore_elevation) = angles(limb.lower);
        Arm {
            azimuth,
            elevation,
            fore_azimuth,
            fore_elevation,
            palm: PALM,
            // The hand points to the front whichever way the forearm comes.
            wrist: (90.0 - fore_azimuth).clamp(-MOST_WRIST, 0.0),
            fingers: 2.0,
            on_waist: 1.0,
        }
    }
}
