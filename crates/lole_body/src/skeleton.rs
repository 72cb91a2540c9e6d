//! The skeleton: VRM humanoid bones, their joints in the bind pose, and poses of them.
//!
//! Every bone's axes are aligned with body space in the bind pose (no bind rotation), so a local
//! rotation is a turn about the bone's joint written in body axes. Bone order is fixed, parents
//! before children.

use glam::{Affine3A, Quat, Vec3};

macro_rules! bones {
    ($($variant:ident $name:literal $parent:expr;)*) => {
        /// A VRM 1.0 humanoid bone.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[expect(missing_docs, reason = "the names are VRM's")]
        pub enum Bone { $($variant,)* }

        impl Bone {
            /// All bones, parents before children.
            pub const ALL: &'static [Self] = &[$(Self::$variant,)*];

            /// VRM's name of the bone, such as `leftUpperLeg`.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* }
            }

            /// The bone it hangs on; `None` for the hips.
            #[must_use]
            pub const fn parent(self) -> Option<Self> {
                match self { $(Self::$variant => $parent,)* }
            }

            /// The bone and all that it hangs on, up to the hips.
            pub fn lineage(self) -> impl Iterator<Item = Self> {
                std::iter::successors(Some(self), |bone| bone.parent())
            }
        }
    };
}

bones! {
    Hips "hips" None;
    Spine "spine" Some(Self::Hips);
    Chest "chest" Some(Self::Spine);
    UpperChest "upperChest" Some(Self::Chest);
    Neck "neck" Some(Self::UpperChest);
    Head "head" Some(Self::Neck);
    LeftShoulder "leftShoulder" Some(Self::UpperChest);
    LeftUpperArm "leftUpperArm" Some(Self::LeftShoulder);
    LeftLowerArm "leftLowerArm" Some(Self::LeftUpperArm);
    LeftHand "leftHand" Some(Self::LeftLowerArm);
    LeftThumbMetacarpal "leftThumbMetacarpal" Some(Self::LeftHand);
    LeftThumbProximal "leftThumbProximal" Some(Self::LeftThumbMetacarpal);
    LeftThumbDistal "leftThumbDistal" Some(Self::LeftThumbProximal);
    LeftIndexProximal "leftIndexProximal" Some(Self::LeftHand);
    LeftIndexIntermediate "leftIndexIntermediate" Some(Self::LeftIndexProximal);
    LeftIndexDistal "leftIndexDistal" Some(Self::LeftIndexIntermediate);
    LeftMiddleProximal "leftMiddleProximal" Some(Self::LeftHand);
    LeftMiddleIntermediate "leftMiddleIntermediate" Some(Self::LeftMiddleProximal);
    LeftMiddleDistal "leftMiddleDistal" Some(Self::LeftMiddleIntermediate);
    LeftRingProximal "leftRingProximal" Some(Self::LeftHand);
    LeftRingIntermediate "leftRingIntermediate" Some(Self::LeftRingProximal);
    LeftRingDistal "leftRingDistal" Some(Self::LeftRingIntermediate);
    LeftLittleProximal "leftLittleProximal" Some(Self::LeftHand);
    LeftLittleIntermediate "leftLittleIntermediate" Some(Self::LeftLittleProximal);
    LeftLittleDistal "leftLittleDistal" Some(Self::LeftLittleIntermediate);
    RightShoulder "rightShoulder" Some(Self::UpperChest);
    RightUpperArm "rightUpperArm" Some(Self::RightShoulder);
    RightLowerArm "rightLowerArm" Some(Self::RightUpperArm);
    RightHand "rightHand" Some(Self::RightLowerArm);
    RightThumbMetacarpal "rightThumbMetacarpal" Some(Self::RightHand);
    RightThumbProximal "rightThumbProximal" Some(Self::RightThumbMetacarpal);
    RightThumbDistal "rightThumbDistal" Some(Self::RightThumbProximal);
    RightIndexProximal "rightIndexProximal" Some(Self::RightHand);
    RightIndexIntermediate "rightIndexIntermediate" Some(Self::RightIndexProximal);
    RightIndexDistal "rightIndexDistal" Some(Self::RightIndexIntermediate);
    RightMiddleProximal "rightMiddleProximal" Some(Self::RightHand);
    RightMiddleIntermediate "rightMiddleIntermediate" Some(Self::RightMiddleProximal);
    RightMiddleDistal "rightMiddleDistal" Some(Self::RightMiddleIntermediate);
    RightRingProximal "rightRingProximal" Some(Self::RightHand);
    RightRingIntermediate "rightRingIntermediate" Some(Self::RightRingProximal);
    RightRingDistal "rightRingDistal" Some(Self::RightRingIntermediate);
    RightLittleProximal "rightLittleProximal" Some(Self::RightHand);
    RightLittleIntermediate "rightLittleIntermediate" Some(Self::RightLittleProximal);
    RightLittleDistal "rightLittleDistal" Some(Self::RightLittleIntermediate);
    LeftUpperLeg "leftUpperLeg" Some(Self::Hips);
    LeftLowerLeg "leftLowerLeg" Some(Self::LeftUpperLeg);
    LeftFoot "leftFoot" Some(Self::LeftLowerLeg);
    LeftToes "leftToes" Some(Self::LeftFoot);
    RightUpperLeg "rightUpperLeg" Some(Self::Hips);
    RightLowerLeg "rightLowerLeg" Some(Self::RightUpperLeg);
    RightFoot "rightFoot" Some(Self::RightLowerLeg);
    RightToes "rightToes" Some(Self::RightFoot);
}

impl Bone {
    /// Number of bones.
    pub const COUNT: usize = Self::ALL.len();

    /// Upper leg, lower leg, foot and toes: the left leg, then the right.
    pub const LEGS: [[Self; 4]; 2] = [
        [
            Self::LeftUpperLeg,
            Self::LeftLowerLeg,
            Self::LeftFoot,
            Self::LeftToes,
        ],
        [
            Self::RightUpperLeg,
            Self::RightLowerLeg,
            Self::RightFoot,
            Self::RightToes,
        ],
    ];

    /// Clavicle, upper arm, forearm and hand: the left arm, then the right.
    pub const ARMS: [[Self; 4]; 2] = [
        [
            Self::LeftShoulder,
            Self::LeftUpperArm,
            Self::LeftLowerArm,
            Self::LeftHand,
        ],
        [
            Self::RightShoulder,
            Self::RightUpperArm,
            Self::RightLowerArm,
            Self::RightHand,
        ],
    ];

    /// Proximal, intermediate and distal bones of the four fingers, index to little: the left
    /// hand, then the right.
    pub const FINGERS: [[[Self; 3]; 4]; 2] = [
        [
            [
                Self::LeftIndexProximal,
                Self::LeftIndexIntermediate,
                Self::LeftIndexDistal,
            ],
            [
                Self::LeftMiddleProximal,
                Self::LeftMiddleIntermediate,
                Self::LeftMiddleDistal,
            ],
            [
                Self::LeftRingProximal,
                Self::LeftRingIntermediate,
                Self::LeftRingDistal,
            ],
            [
                Self::LeftLittleProximal,
                Self::LeftLittleIntermediate,
                Self::LeftLittleDistal,
            ],
        ],
        [
            [
                Self::RightIndexProximal,
                Self::RightIndexIntermediate,
                Self::RightIndexDistal,
            ],
            [
                Self::RightMiddleProximal,
                Self::RightMiddleIntermediate,
                Self::RightMiddleDistal,
            ],
            [
                Self::RightRingProximal,
                Self::RightRingIntermediate,
                Self::RightRingDistal,
            ],
            [
                Self::RightLittleProximal,
                Self::RightLittleIntermediate,
                Self::RightLittleDistal,
            ],
        ],
    ];

    /// Metacarpal, proximal and distal bones of the thumbs: the left, then the right.
    pub const THUMBS: [[Self; 3]; 2] = [
        [
            Self::LeftThumbMetacarpal,
            Self::LeftThumbProximal,
            Self::LeftThumbDistal,
        ],
        [
            Self::RightThumbMetacarpal,
            Self::RightThumbProximal,
            Self::RightThumbDistal,
        ],
    ];

    /// Position in [`Bone::ALL`] and in every column indexed by bone.
    #[must_use]
    pub const fn index(self) -> usize {
        self as usize
    }

    /// The one that carries most of a vertex with these joints and weights; of equals the first.
    #[must_use]
    pub fn strongest(joints: [u16; 4], weights: [f32; 4]) -> Self {
        let strongest = (1..4).fold(0, |most, next| {
            if weights[most] < weights[next] {
                next
            } else {
                most
            }
        });
        Self::ALL[usize::from(joints[strongest])]
    }
}

/// A side of the body, or the one that a step begins on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Side {
    /// Right: as a step is taught, ʻākau.
    #[default]
    Right,
    /// Left: the mirror image, hema.
    Left,
}

/// Joints of one body in its bind pose.
#[derive(Debug, Clone, PartialEq)]
pub struct Skeleton {
    /// Joint of each bone in body space [m], shape `[Bone::COUNT, 3]`.
    pub joints: Vec<Vec3>,
    /// Where a hand rests on the left side of the waist: a point of the skin [m], carried by the
    /// spine.
    pub waist_side: Vec3,
}

/// One position of a skeleton.
#[derive(Debug, Clone, PartialEq)]
pub struct Pose {
    /// How far the hips joint has moved from its bind position [m], world axes.
    pub hips_translation: Vec3,
    /// Turn of each bone about its joint, relative to its parent, shape `[Bone::COUNT]`.
    pub rotations: Vec<Quat>,
}

impl Default for Pose {
    fn default() -> Self {
        Self {
            hips_translation: Vec3::ZERO,
            rotations: vec![Quat::IDENTITY; Bone::COUNT],
        }
    }
}

impl Pose {
    /// Local rotation of one bone.
    #[must_use]
    pub fn rotation(&self, bone: Bone) -> Quat {
        self.rotations[bone.index()]
    }

    /// Sets the local rotation of one bone.
    pub fn rotate(&mut self, bone: Bone, rotation: Quat) {
        self.rotations[bone.index()] = rotation;
    }
}

impl Skeleton {
    /// Joint of `bone` in the bind pose [m].
    #[must_use]
    pub fn joint(&self, bone: Bone) -> Vec3 {
        self.joints[bone.index()]
    }

    /// For every bone, the transform that carries a point of the bind pose to the posed world
    /// ("skin matrix"), shape `[Bone::COUNT]`.
    #[must_use]
    pub fn world_from_bind(&self, pose: &Pose) -> Vec<Affine3A> {
        let mut transforms: Vec<Affine3A> = Vec::with_capacity(Bone::COUNT);
        for &bone in Bone::ALL {
            let joint = self.joint(bone);
            let about_joint = Affine3A::from_translation(joint)
                * Affine3A::from_quat(pose.rotation(bone))
                * Affine3A::from_translation(-joint);
            let parent_from_bind = match bone.parent() {
                Some(parent) => transforms[parent.index()],
                None => Affine3A::from_translation(pose.hips_translation),
            };
            transforms.push(parent_from_bind * about_joint);
        }
        transforms
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parents_come_before_children() {
        for &bone in Bone::ALL {
            assert!(
                bone.parent()
                    .is_none_or(|parent| parent.index() < bone.index())
            );
        }
    }

    #[test]
    fn a_turned_upper_leg_carries_the_ankle() {
        let mut joints = vec![Vec3::ZERO; Bone::COUNT];
        joints[Bone::LeftUpperLeg.index()] = Vec3::Y;
        let skeleton = Skeleton {
            joints,
            waist_side: Vec3::ZERO,
        };
        let mut pose = Pose::default();
        pose.rotate(
            Bone::LeftUpperLeg,
            Quat::from_rotation_x(-std::f32::consts::FRAC_PI_2),
        );
        let world_from_bind = skeleton.world_from_bind(&pose);
        let ankle = world_from_bind[Bone::LeftFoot.index()].transform_point3(Vec3::ZERO);
        assert!(
            (ankle - Vec3::new(0.0, 1.0, 1.0)).length() < 1e-6,
            "{ankle}"
        );
    }
}
