//! The table of joints, and what may be wrong with one.

use crate::assembly::attachment::{Attached, Attachment, Bones};
use crate::assembly::drawstring::{Drawstring, DrawstringKnots};
use crate::assembly::elastic::{Elastic, ElasticKnots};
use crate::assembly::piece::{ClothPiece, PieceState};
use crate::assembly::pleat::{Pleat, PleatKnots};
use crate::assembly::seam::{ClothSeam, Stitches};

/// Something that holds particles of one or several pieces.
#[derive(Debug, Clone, PartialEq)]
pub enum ClothJoint {
    /// Two lines sewn together.
    Seam(ClothSeam),
    /// A line drawn together by an elastic band.
    Elastic(Elastic),
    /// A line that a string keeps from getting longer.
    Drawstring(Drawstring),
    /// A crease pressed into the cloth.
    Pleat(Pleat),
    /// Particles tied to a bone.
    Attachment(Attachment),
}

/// Why a [`ClothJoint`] cannot be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum JointError {
    /// A piece that does not exist.
    #[error("a joint names piece {piece}, and there are {piece_count}")]
    NoSuchPiece {
        /// The piece named.
        piece: usize,
        /// Pieces there are.
        piece_count: usize,
    },
    /// A particle that does not exist.
    #[error("a joint names particle {particle} of piece {piece}, which has {particle_count}")]
    NoSuchParticle {
        /// The piece.
        piece: usize,
        /// The particle named.
        particle: u32,
        /// Particles there are.
        particle_count: usize,
    },
    /// A line of too few particles, or lists of different lengths.
    #[error("{joint} has {actual} particles; it needs {rule}")]
    WrongCount {
        /// Kind of the joint.
        joint: &'static str,
        /// Particles found.
        actual: usize,
        /// What would be allowed.
        rule: &'static str,
    },
    /// A number that is not finite or out of its range.
    #[error("`{field}` is {value}; it must be {rule}")]
    OutOfRange {
        /// Kind and field.
        field: &'static str,
        /// The value found.
        value: f32,
        /// What would be allowed.
        rule: &'static str,
    },
}

/// A joint prepared for its pieces.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Made {
    Seam(Stitches),
    Elastic(ElasticKnots),
    Drawstring(DrawstringKnots),
    Pleat(PleatKnots),
    Attachment(Attached),
}

impl Made {
    pub(crate) fn new(pieces: &[ClothPiece], joint: &ClothJoint) -> Result<Self, JointError> {
        Ok(match joint {
            ClothJoint::Seam(seam) => Self::Seam(Stitches::new(pieces, seam)?),
            ClothJoint::Elastic(elastic) => Self::Elastic(ElasticKnots::new(pieces, elastic)?),
            ClothJoint::Drawstring(string) => {
                Self::Drawstring(DrawstringKnots::new(pieces, string)?)
            }
            ClothJoint::Pleat(pleat) => Self::Pleat(PleatKnots::new(pieces, pleat)?),
            ClothJoint::Attachment(attachment) => {
                Self::Attachment(Attached::new(pieces, attachment)?)
            }
        })
    }

    /// Solves it once in a substep of `h` [s], with bones at `bones`.
    pub(crate) fn solve(&self, states: &mut [PieceState], bones: &Bones<'_>, h: f32) {
        match self {
            Self::Seam(stitches) => stitches.solve(states),
            Self::Elastic(elastic) => elastic.solve(states, h),
            Self::Drawstring(string) => string.solve(states),
            Self::Pleat(pleat) => pleat.solve(states, h),
            Self::Attachment(attached) => attached.solve(states, bones, h),
        }
    }
}

/// `value`, where it is finite and positive.
pub(crate) fn positive(field: &'static str, value: f32) -> Result<f32, JointError> {
    if value.is_finite() && 0.0 < value {
        Ok(value)
    } else {
        Err(JointError::OutOfRange {
            field,
            value,
            rule: "finite and above 0",
        })
    }
}
