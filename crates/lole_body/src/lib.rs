//! The dancer: measurements, skeleton, skin, capsules around bones, and hula steps.
//!
//! Body space is meters, right-handed, `+Y` up, `+Z` front, `+X` the dancer's left, floor at 0.
//! The crate knows no cloth and opens no file.

pub mod skeleton;

pub use skeleton::{Bone, Pose, Skeleton};
