//! A performance: dancer, costume and motion become frames, and frames become numbers.
//!
//! It opens no file, reads no clock and draws nothing: whoever calls [`Performance::advance`] times
//! it, draws what it holds and writes it down.

mod adorned;
pub mod danced;
mod double_pau;
#[cfg(test)]
mod extremes;
mod hold;
pub mod live;
pub mod machine;
pub mod metrics;
pub mod performance;
pub mod production;
mod six_dancers;
pub mod skin_check;
mod solver;
pub mod strangers;
pub mod validate;
pub mod worn;
mod yielding;

pub use adorned::Adornment;
pub use danced::Danced;
pub use double_pau::double_pau;
pub use hold::{ElasticHold, HoldWatch, OFF};
pub use live::{PartNow, Pull, Show, Vitals, Wish};
pub use lole_garment::dress::Division;
pub use lole_hula::{Formation, assign_places};
pub use metrics::{FrameMetrics, RunMetrics};
pub use performance::{
    Divergence, Energy, FRAME_SECONDS, FRAMES_PER_SECOND, GarmentLayers, LayerWatch, NoRoom,
    Performance, no_room_now,
};
pub use production::{DressedGarment, Garment, Production, dancer};
pub use six_dancers::six_dancers;
pub use strangers::Stranger;
pub use worn::{Vertices, Worn, WornSurface};
pub use yielding::give_way;

use lole_language::Bilingual;

/// Why a design cannot be performed.
#[derive(Debug, thiserror::Error)]
pub enum StageError {
    /// The dancer cannot be built.
    #[error(transparent)]
    Body(#[from] lole_body::BodyError),
    /// The avatar that is to be dressed cannot be.
    #[error("{file}: {error}")]
    Avatar {
        /// Its name in the document.
        file: String,
        /// Why.
        error: Box<lole_avatar::AvatarError>,
    },
    /// The bytes of the avatar were not given with the design.
    #[error("the avatar {file} was not read")]
    AvatarNotRead {
        /// Its name in the document.
        file: String,
    },
    /// The dance cannot be danced.
    #[error(transparent)]
    Motion(#[from] lole_hula::MotionError),
    /// The recording that is to be danced cannot be.
    #[error("{file}: {error}")]
    Recording {
        /// Its name in the document.
        file: String,
        /// Why.
        error: Box<lole_avatar::AvatarError>,
    },
    /// The recording's bytes were not given with the design.
    #[error("the recording {file} was not read")]
    RecordingNotRead {
        /// Its name in the document.
        file: String,
    },
    /// The skirt cannot be drafted.
    #[error(transparent)]
    Draft(#[from] lole_pattern::DraftError),
    /// The skirt cannot be sewn.
    #[error(transparent)]
    Sew(#[from] lole_costume::sew::SewError),
    /// A garment of a template cannot be put on.
    #[error(transparent)]
    Dress(#[from] lole_garment::dress::DressError),
    /// A garment that is worn with the skirt cannot be made.
    #[error("garment {place} of the list: {error}")]
    Garment {
        /// Its place in the list, counted from 1.
        place: usize,
        /// Why.
        error: Box<Self>,
    },
    /// What hangs beside the cloth cannot be prepared.
    #[error(transparent)]
    Strands(#[from] lole_cloth::strands::StrandError),
    /// The cloth cannot be built.
    #[error(transparent)]
    Build(#[from] lole_cloth::BuildError),
}

impl Bilingual for StageError {
    fn japanese(&self) -> String {
        match self {
            Self::Body(error) => error.japanese(),
            Self::Avatar { file, error } => format!("{file}: {}", error.japanese()),
            Self::AvatarNotRead { file } => {
                format!("アバター {file} が読み込まれていません")
            }
            Self::Motion(error) => error.japanese(),
            Self::Recording { file, error } => format!("{file}: {}", error.japanese()),
            Self::RecordingNotRead { file } => format!("記録 {file} が読み込まれていません"),
            Self::Draft(error) => error.japanese(),
            Self::Sew(error) => error.japanese(),
            Self::Dress(error) => error.japanese(),
            Self::Garment { place, error } => {
                format!("{place} 枚目の服: {}", error.japanese())
            }
            Self::Strands(error) => format!("ひも状の飾りを組み立てられません（{error}）"),
            Self::Build(error) => format!("布を組み立てられません（{error}）"),
        }
    }
}
