//! A dance of any file: BVH, or an animation of glTF, VRM or VRMA.

use lole_motion::{BoneMap, Recording, bvh};

use crate::container::{File, is_gltf};
use crate::rig::Rig;
use crate::{AvatarError, animation};

/// A recording, and which of its joints is which bone.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadDance {
    /// Joints and frames.
    pub recording: Recording,
    /// Which joint is which bone.
    pub map: BoneMap,
}

/// Reads the bytes of a file that holds a dance.
///
/// # Errors
/// A damaged file, one that is no person's, or one without motion.
pub fn read_dance(bytes: &[u8]) -> Result<ReadDance, AvatarError> {
    if !is_gltf(bytes) {
        let recording = bvh::parse(bytes)?;
        let map = BoneMap::recognize(&recording)?;
        return Ok(ReadDance { recording, map });
    }
    let file = File::read(bytes)?;
    let rig = Rig::new(&file, None)?;
    Ok(ReadDance {
        recording: animation::recording(&file, &rig)?,
        map: rig.map,
    })
}
