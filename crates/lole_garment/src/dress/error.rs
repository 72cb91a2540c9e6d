//! Why a garment could not be put on.

use lole_cloth::Lost;
use lole_cloth::assembly::JointError;
use lole_cloth::mesh::MeshError;
use lole_language::Bilingual;
use lole_pattern::DraftError;

/// Why a garment could not be put on.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DressError {
    /// It cannot be drafted to these measures.
    #[error(transparent)]
    Draft(#[from] DraftError),
    /// Nobody has said how it is worn.
    #[error("the garment {template} is drafted and not worn; nothing says where its pieces lie")]
    NotWorn {
        /// Its template.
        template: &'static str,
    },
    /// A piece's border crosses itself, so that it cannot be cut.
    #[error("the pieces of {template} cross themselves with these measures; check {measure}")]
    CrossedPiece {
        /// Its template.
        template: &'static str,
        /// What to measure again.
        measure: &'static str,
    },
    /// The dancer has no trunk where the garment lies.
    #[error("the dancer has no trunk where {template} should lie; make it shorter")]
    NoTrunk {
        /// Its template.
        template: &'static str,
    },
    /// The panels of a file cannot be laid around her.
    #[error(
        "the panels of {template} cannot be laid around the dancer; they must lie before and behind the trunk, and panels beside it must be sewn to them"
    )]
    Unlaid {
        /// Its template.
        template: &'static str,
    },
    /// The mesh cannot be built.
    #[error("the cloth of {template} cannot be divided into triangles: {error}")]
    Mesh {
        /// Its template.
        template: &'static str,
        /// Why.
        error: MeshError,
    },
    /// A seam or elastic cannot be made.
    #[error("{template} cannot be sewn: {error}")]
    Joint {
        /// Its template.
        template: &'static str,
        /// Why.
        error: JointError,
    },
    /// The cloth flew away while it was put on.
    #[error("{template} did not come to rest on the dancer: {lost}")]
    Lost {
        /// Its template.
        template: &'static str,
        /// Where.
        lost: Lost,
    },
}

impl Bilingual for DressError {
    fn japanese(&self) -> String {
        match self {
            Self::Draft(error) => error.japanese(),
            Self::NotWorn { template } => {
                format!("{template} は製図だけの服で、着せ方が決まっていません")
            }
            Self::CrossedPiece { template, .. } => {
                format!(
                    "この採寸では {template} の型紙の線が交わります。バストと背丈を測り直してください"
                )
            }
            Self::NoTrunk { template } => {
                format!("{template} の来る所に胴がありません。丈を短くしてください")
            }
            Self::Unlaid { template } => {
                format!(
                    "{template} の型紙を体のまわりに置けません。胴の前と後ろに型紙が要り、その横の型紙は縫い合わせてください"
                )
            }
            Self::Mesh { template, error } => {
                format!("{template} の布を三角形に分けられません（{error}）")
            }
            Self::Joint { template, error } => format!("{template} を縫えません（{error}）"),
            Self::Lost { template, lost } => {
                format!("{template} を着せる途中で布が飛びました（{lost}）")
            }
        }
    }
}
