//! Pieces of cloth, grids and triangles alike, sewn together and held by what a maker puts in.
//!
//! All pieces take their substeps in turn, and meet each other where their settings have contact of
//! cloth with cloth. What comes to cross is repaired on all of them as one surface, where any of them asks for
//! that. Between the springs of a substep and its contacts come
//! the joints, each kind in a file of its own: [`ClothSeam`], [`Elastic`], [`Drawstring`], [`Pleat`] and
//! [`Attachment`] to a bone. They are solved once a substep, like every constraint of the method.

mod attachment;
mod contact;
mod drawstring;
mod elastic;
mod joint;
mod knot;
mod piece;
mod pleat;
mod seam;
mod step;
mod whole;

pub use attachment::{Attachment, BoneFrame};
pub use drawstring::Drawstring;
pub use elastic::Elastic;
pub use joint::{ClothJoint, JointError};
pub use knot::{EdgePoint, Ends, PieceParticle};
pub use piece::{ClothPiece, PieceState};
pub use pleat::Pleat;
pub use seam::ClothSeam;
pub use step::{Assembly, AssemblyInput, AssemblyState, step, step_observed};
