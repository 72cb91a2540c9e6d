//! BVH (Biovision hierarchy): a text of joints with offsets and channels, then one line of numbers
//! for each frame.
//!
//! The format has no standard; what stands in files is read: any order of channels, none to six of
//! them on any joint, ends of bones, several roots, tabs, any line ends, comments, names with
//! spaces and in any encoding. Rotations are applied in the order of the channels, the first one
//! outermost. Numbers that are none, infinite or beyond [`LARGEST_NUMBER`] are refused.
//!
//! Whether a position channel takes the place of the joint's offset or is added to it differs
//! between programs: the reading is taken that leaves the joint nearer to its offset on average.

mod hierarchy;
mod lines;
mod motion;

use crate::{Recording, RecordingError};

/// Largest absolute value of a number that is read [file units or °].
pub const LARGEST_NUMBER: f64 = 1.0e7;
/// Joints and ends of a skeleton at most.
pub const MOST_JOINTS: usize = 4096;
/// Joints between a root and an end at most.
pub const DEEPEST: usize = 256;
/// Numbers of all frames at most: half an hour of a hundred joints.
pub const MOST_NUMBERS: usize = 1 << 27;

/// What a channel moves: an axis (0 to 2) along or about which.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Channel {
    Position(usize),
    Rotation(usize),
}

/// Reads the bytes of a file.
///
/// # Errors
/// [`RecordingError::Syntax`] with the line of the first mistake, [`RecordingError::TooLarge`].
pub fn parse(bytes: &[u8]) -> Result<Recording, RecordingError> {
    let text = String::from_utf8_lossy(bytes);
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    let mut lines = lines::Lines::new(text);
    let skeleton = hierarchy::read(&mut lines)?;
    motion::read(&mut lines, skeleton)
}
