//! Settings for a mesh that nobody has tuned: how many substeps cloth as long and as fine needs to bear
//! its own weight.

use std::num::NonZeroU32;

use crate::mesh::model::MeshModel;
use crate::{Crossings, SelfCollision, SolverConfig};

/// Rate of the steps that the settings are for [1/s].
const STEPS_PER_SECOND: f32 = 60.0;

/// Cells that strides bridge, the longest first: a dress hangs from its shoulders by a hundred cells, and what
/// one pass over the triangles leaves of its weight is a tenth of it with these.
const STRIDES: [u32; 3] = [16, 8, 4];

/// Largest `g h² L / d²` for substeps `h`, cloth of length `L` and cells `d`: the strain that one pass over the
/// triangles in each substep leaves where all the cloth hangs from cells as wide as itself. With the strides a
/// dress on narrow shoulders has about twice that.
const WEIGHT_LEFT: f32 = 0.03;

/// Fewest and most substeps.
const SUBSTEPS: [f32; 2] = [12.0, 120.0];

/// Times as many substeps at most where cloth is strained, as where a dance pulls at it.
const STRAINED_PARTS: NonZeroU32 = NonZeroU32::MIN.saturating_add(1);

/// Half of the distance that cloth keeps from cloth [m], and the most of a cell that it may be.
const HALF_GAP: f32 = 0.002;
const HALF_GAP_SHARE: f32 = 0.25;

impl MeshModel {
    /// Settings for steps of a sixtieth of a second with which the piece, hanging from some of its
    /// particles or worn, bears its own weight with few hundredths of strain, keeps 4 mm from the body
    /// and does not go through itself.
    ///
    /// A mesh twice as fine takes twice as many substeps, and eight times as long.
    #[must_use]
    pub fn settings(&self) -> SolverConfig {
        let gravity = SolverConfig::default().gravity;
        let length = (self.longest_way() * gravity.length() / WEIGHT_LEFT).sqrt();
        let count = length / (self.spacing() * STEPS_PER_SECOND);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between the fewest and the most"
        )]
        let count = count.ceil().clamp(SUBSTEPS[0], SUBSTEPS[1]) as u32;
        let substep_count = NonZeroU32::new(count).unwrap_or(NonZeroU32::MIN);
        SolverConfig {
            substep_count,
            strained_substep_count: substep_count.saturating_mul(STRAINED_PARTS),
            structural_sweep_count: NonZeroU32::MIN,
            contact_offset: 0.004,
            depenetration_speed: 1.0,
            row_strides: STRIDES.to_vec(),
            column_strides: STRIDES.to_vec(),
            self_collision: Some(SelfCollision {
                radius: HALF_GAP.min(HALF_GAP_SHARE * self.spacing()),
                substep_interval: NonZeroU32::MIN.saturating_add(2),
                crossings: Crossings::Repair,
            }),
            gravity,
            ..SolverConfig::default()
        }
    }
}
