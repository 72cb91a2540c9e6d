//! A dance of any file: BVH, or an animation of glTF, VRM or VRMA.

use lole_motion::{BoneMap, Recording, bvh};

use crate::container::{File, is_gltf, visible};
use crate::rig::Rig;
use crate::{AnimationSummary, AvatarError, animation};

/// A recording, and which of its joints is which bone.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadDance {
    /// Joints and frames.
    pub recording: Recording,
    /// Which joint is which bone.
    pub map: BoneMap,
}

/// Reads the bytes of a file that holds a dance: its first animation.
///
/// # Errors
/// A damaged file, one that is no person's, or one without motion.
pub fn read_dance(bytes: &[u8]) -> Result<ReadDance, AvatarError> {
    read_clip(bytes, "")
}

/// The animations of a file, in its order, with those that move no bone; none of a BVH file, whose one
/// motion has no name.
///
/// # Errors
/// A damaged file, or one that is no person's.
pub fn list_clips(bytes: &[u8]) -> Result<Vec<AnimationSummary>, AvatarError> {
    if !is_gltf(bytes) {
        return Ok(Vec::new());
    }
    let file = File::read(bytes)?;
    animation::summaries(&file, &Rig::new(&file, None)?)
}

/// Reads one of several animations: by its name, or by its number, counted from 1; the first that
/// moves bones where `clip` is empty. A BVH file has one, `1`.
///
/// # Errors
/// As [`read_dance`], and [`AvatarError::UnknownClip`].
pub fn read_clip(bytes: &[u8], clip: &str) -> Result<ReadDance, AvatarError> {
    if !is_gltf(bytes) {
        if !matches!(clip, "" | "1") {
            return Err(AvatarError::UnknownClip {
                clip: visible(clip),
                known: "1".to_owned(),
            });
        }
        let recording = bvh::parse(bytes)?;
        let map = BoneMap::recognize(&recording)?;
        return Ok(ReadDance { recording, map });
    }
    let file = File::read(bytes)?;
    let rig = Rig::new(&file, None)?;
    Ok(ReadDance {
        recording: animation::recording(&file, &rig, clip)?,
        map: rig.map,
    })
}
