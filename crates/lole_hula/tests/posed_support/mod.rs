//! A skeleton in a pose, and what the laws of motion ask of it.

use glam::{Affine3A, Quat, Vec3};
use lole_body::{Bone, Pose, Skeleton};

/// Upper leg, lower leg and foot, left and right.
pub(crate) const LEGS: [[Bone; 3]; 2] = [
    [Bone::LeftUpperLeg, Bone::LeftLowerLeg, Bone::LeftFoot],
    [Bone::RightUpperLeg, Bone::RightLowerLeg, Bone::RightFoot],
];

/// A skeleton at one time of a dance.
pub(crate) struct Moment<'a> {
    pub(crate) skeleton: &'a Skeleton,
    pub(crate) pose: Pose,
    /// World from bind, by bone.
    pub(crate) skin: Vec<Affine3A>,
}

impl<'a> Moment<'a> {
    pub(crate) fn of(skeleton: &'a Skeleton, pose: Pose) -> Self {
        let skin = skeleton.world_from_bind(&pose);
        Self {
            skeleton,
            pose,
            skin,
        }
    }

    /// Whether the place is finite and every rotation is one.
    pub(crate) fn is_whole(&self) -> bool {
        let mut rotations = self.pose.rotations.iter();
        self.pose.hips_translation.is_finite()
            && rotations.all(|rotation| (rotation.length() - 1.0).abs() < 1e-4)
    }

    /// Where a joint is [m].
    pub(crate) fn at(&self, bone: Bone) -> Vec3 {
        self.carried(bone, self.skeleton.joint(bone))
    }

    /// Where a bone carries a point of the bind pose [m].
    pub(crate) fn carried(&self, bone: Bone, point: Vec3) -> Vec3 {
        self.skin[bone.index()].transform_point3(point)
    }

    /// How a bone is turned against the bind pose.
    pub(crate) fn turn(&self, bone: Bone) -> Quat {
        Quat::from_mat3a(&self.skin[bone.index()].matrix3)
    }

    pub(crate) fn knee_degrees(&self, leg: [Bone; 3]) -> f32 {
        let [hip, knee, ankle] = leg.map(|bone| self.at(bone));
        (knee - hip).angle_between(ankle - knee).to_degrees()
    }

    /// Adduction of a hip [°]: how far the thigh leans inward in the pelvis.
    pub(crate) fn adduction(&self, side: usize) -> f32 {
        let inward = [-1.0, 1.0][side];
        let [hip, knee, _] = LEGS[side].map(|bone| self.at(bone));
        let thigh = self.turn(Bone::Hips).inverse() * (knee - hip);
        lole_geom::trig::atan2(inward * thigh.x, -thigh.y).to_degrees()
    }
}
