//! Anyone's avatar, anyone's dance: files of other programs, brought to the product's own types.
//!
//! | Step | Where |
//! |---|---|
//! | bytes of a glTF, GLB, VRM 0.x, VRM 1.0 or VRMA file to text and numbers | `container`, `accessor` |
//! | which node is which bone, up, front, unit, pose at rest | `rig` |
//! | meshes in the pose they were bound in, in meters, on the floor | `geometry` |
//! | an animation as a recording that any dancer dances | [`read_dance`] |
//! | pictures and base colors | `look` |
//! | skeleton, skin and tape of a dancer | [`Avatar`] |
//! | what may be done with it | [`License`] |
//! | what a file holds, in words | [`AvatarInspection`] |
//!
//! It opens no file. Whatever bytes it is given, it answers with a finite result or with one
//! sentence.

mod accessor;
mod animation;
mod avatar;
mod bounded;
mod container;
mod dance;
mod error;
mod figure;
mod gather;
mod geometry;
mod inspect;
mod license;
mod look;
mod rig;
mod tree;
mod vrm;

pub use animation::AnimationSummary;
pub use avatar::Avatar;
pub use container::is_gltf;
pub use dance::{ReadDance, list_clips, read_clip, read_dance};
pub use error::AvatarError;
pub use gather::{gathered, neighbors};
pub use inspect::{AvatarInspection, BodySummary, Humanoid, MeshSummary};
pub use license::{License, Permission};
pub use rig::RestPose;
pub use vrm::Format;
