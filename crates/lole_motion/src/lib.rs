//! Recorded motion: somebody's dance, read from the bytes of a file and danced by any body.
//!
//! | Step | Where |
//! |---|---|
//! | text of a BVH file to joints and frames | [`bvh::parse`] |
//! | which joint is which bone | [`BoneMap`]: by names, by the hierarchy, by a list |
//! | up, front, unit | [`Axes`], [`Unit`] |
//! | the dancer's poses, sixty a second | [`Clip::retarget`] |
//! | what a file holds, in words | [`RecordingInspection`] |
//!
//! It opens no file, and knows no cloth.

mod axes;
pub mod bvh;
mod clip;
mod error;
mod feet;
mod hierarchy;
mod inspect;
mod names;
mod recording;
mod repeat;
mod retarget;
mod room;
mod skeleton_map;

pub use axes::{Axes, Unit, axis_name};
pub use clip::{Clip, ClipSettings, Drift, Repeat};
pub use error::RecordingError;
pub use inspect::{Person, RecordingInspection};
pub use recording::{Joint, JointPlace, Recording};
pub use skeleton_map::{BoneMap, MapSource};
