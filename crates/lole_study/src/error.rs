//! What can keep a study from its figures.

use lole_cloth::BuildError;
use lole_picture::LookError;
use lole_render::RenderError;
use lole_stage::StageError;

/// Why there are no figures.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// It was called off.
    #[error("called off")]
    CalledOff,
    /// A design cannot be put on the stage.
    #[error(transparent)]
    Stage(#[from] StageError),
    /// A cloth cannot be built.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// A skirt cannot be painted.
    #[error(transparent)]
    Look(#[from] LookError),
    /// A skirt cannot be drawn.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// The skirt flew apart before it hung still.
    #[error("the skirt of the study does not settle; please report this")]
    Unsettled,
    /// There is no skirt to study.
    #[error("no skirt is worn")]
    NoSkirt,
    /// The skirt moves by another method than the paper's.
    #[error("the skirt of the study moves by a method of the paper")]
    NotOfThePaper,
}
