//! An avatar that wears what is designed: its skeleton, its skin and its tape as a dancer's.

use lole_body::Dancer;

use crate::container::File;
use crate::figure::skeleton_and_skin;
use crate::geometry::Geometry;
use crate::rig::Rig;
use crate::vrm::Format;
use crate::{AvatarError, License};

/// Somebody's avatar as a dancer.
#[derive(Debug, Clone, PartialEq)]
pub struct Avatar {
    /// Measured, with skeleton, skin and capsules.
    pub dancer: Dancer,
    /// What may be done with it.
    pub license: License,
}

impl Avatar {
    /// Reads and measures the bytes of a file.
    ///
    /// # Errors
    /// A damaged file, one that is no person's, has no mesh, or cannot be measured.
    pub fn read(bytes: &[u8]) -> Result<Self, AvatarError> {
        let file = File::read(bytes)?;
        Self::of_file(&file, None)
    }

    /// Measures the avatar of a file whose text was read; `list` says which node is which bone.
    pub(crate) fn of_file(file: &File<'_>, list: Option<&str>) -> Result<Self, AvatarError> {
        let rig = Rig::new(file, list)?;
        let geometry = Geometry::read(file, &rig)?;
        let (skeleton, skin) = skeleton_and_skin(file, &rig, &geometry)?;
        Ok(Self {
            dancer: Dancer::of_skin(skeleton, skin)?,
            license: License::of(file, Format::of(file)),
        })
    }
}
