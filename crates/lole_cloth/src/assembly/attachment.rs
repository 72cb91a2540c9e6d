//! Attachments: particles tied to a bone, with a tie that gives.
//!
//! `C = x - p` with `p` the place that the particle has on the bone, and compliance one over the
//! stiffness of the tie. Pins are the ties that do not give.

use glam::{Quat, Vec3};

use crate::assembly::joint::{JointError, positive};
use crate::assembly::knot::{Knot, PieceParticle};
use crate::assembly::piece::{ClothPiece, PieceState};

/// Where a bone is: `world_from_bone`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoneFrame {
    /// Rotation from the bone to the world, of length 1.
    pub rotation: Quat,
    /// Origin of the bone in the world [m].
    pub translation: Vec3,
}

impl BoneFrame {
    /// The bone at rest in the middle of the world.
    pub const IDENTITY: Self = Self {
        rotation: Quat::IDENTITY,
        translation: Vec3::ZERO,
    };

    /// Where a point of the bone is in the world [m].
    #[must_use]
    pub fn world_from_bone(&self, point_in_bone: Vec3) -> Vec3 {
        self.rotation * point_in_bone + self.translation
    }
}

/// Particles tied to a bone.
#[derive(Debug, Clone, PartialEq)]
pub struct Attachment {
    /// Position in the list of bones.
    pub bone: usize,
    /// Each particle, and where it is on the bone [m].
    pub ties: Vec<(PieceParticle, Vec3)>,
    /// Force per distance of one tie [N/m].
    pub stiffness: f32,
}

/// Bones on their way through a step.
pub(crate) struct Bones<'a> {
    pub(crate) before: &'a [BoneFrame],
    pub(crate) after: &'a [BoneFrame],
    /// Share of the step that is over at the end of the substep.
    pub(crate) share: f32,
}

impl Bones<'_> {
    /// Where a point of a bone is, having gone straight [m].
    fn place(&self, bone: usize, point_in_bone: Vec3) -> Option<Vec3> {
        let before = self.before.get(bone)?.world_from_bone(point_in_bone);
        let after = self.after.get(bone)?.world_from_bone(point_in_bone);
        Some(before + (after - before) * self.share)
    }
}

/// A prepared attachment.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Attached {
    bone: usize,
    ties: Vec<(Knot, Vec3)>,
    stiffness: f32,
}

impl Attached {
    pub(crate) fn new(pieces: &[ClothPiece], attachment: &Attachment) -> Result<Self, JointError> {
        let ties = (attachment.ties.iter()).map(|&(place, point)| {
            if !point.is_finite() {
                return Err(JointError::OutOfRange {
                    field: "attachment.ties",
                    value: point.length(),
                    rule: "finite",
                });
            }
            Ok((Knot::new(pieces, place)?, point))
        });
        Ok(Self {
            bone: attachment.bone,
            ties: ties.collect::<Result<_, _>>()?,
            stiffness: positive("attachment.stiffness", attachment.stiffness)?,
        })
    }

    pub(crate) fn solve(&self, states: &mut [PieceState], bones: &Bones<'_>, h: f32) {
        let compliance = 1.0 / (self.stiffness * h * h);
        for &(knot, point) in &self.ties {
            let Some(target) = bones.place(self.bone, point) else {
                continue;
            };
            let off = knot.place(states) - target;
            knot.push(states, off * (-1.0 / (knot.inv_mass + compliance)));
        }
    }
}
