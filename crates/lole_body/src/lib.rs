//! The dancer: measurements, skeleton, skin, and capsules around bones.
//!
//! Body space is meters, right-handed, `+Y` up, `+Z` front, `+X` the dancer's left, floor at 0.
//! The crate knows no cloth and no dance, and opens no file.

pub mod appearance;
pub mod capsules;
pub mod dancer;
mod drawn;
pub mod error;
mod given;
pub mod ik;
pub mod measured;
pub mod measurements;
mod parts;
mod sections;
pub mod skeleton;
pub mod skin;
mod skin_build;
mod skin_weights;
mod surface;
pub mod tape;

pub use appearance::{Appearance, BodyPicture, Face, Feature, HairStyle, Makeup};
pub use capsules::{BodyCapsule, CapsuleLayout, Coverage};
pub use dancer::{Dancer, Landmarks};
pub use drawn::{Combed, DrawnBody, Expression, HairKnot, OpenHair, Swing};
pub use error::BodyError;
pub use measured::Taped;
pub use measurements::{Figure, Measure, Measurements, Tape};
pub use skeleton::{Bone, Pose, Side, Skeleton};
pub use skin::{Look, MeshPart, PartKind, SkinPicture, SkinnedMesh};
pub use tape::TapePoint;
