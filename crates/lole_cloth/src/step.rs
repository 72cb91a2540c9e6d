//! One call of the engine: the cloth moves on by `dt`.

use glam::Vec3;
use lole_geom::{Capsule, Surfel};

use crate::collision::surfel::REACH;
use crate::lost::{Lost, check_cloth, check_pins};
use crate::method::xpbd;
use crate::phase::Phase;
use crate::{ClothModel, ClothState, SolverConfig};

/// How deep in a body of surfels, below the distance that it keeps, cloth that lies still is brought out of it
/// [m]. What moves against the body is looked for as much farther as it comes in a step, 6 cm at most. Deeper,
/// it is let alone: another limb would be as near.
pub const SKIN_REACH: f32 = REACH;

/// What the world does during one step; by default nothing is in it.
#[derive(Debug, Clone, Copy, Default)]
pub struct StepInput<'a> {
    /// Where the pinned particles are at the end of the step [m], in the order of
    /// [`ClothModel::pin_indices`]; none where all of them stay where they are.
    pub pin_targets: &'a [Vec3],
    /// Where the capsules are at the end of the step; always the same ones in the same order.
    pub capsules: &'a [Capsule],
    /// Where the surfels of a skinned body are at the end of the step, about a centimeter apart;
    /// always the same ones in the same order. Cloth keeps to the side to which they face.
    /// [`lole_geom::MeshSurfels`] makes them of a moving triangle mesh and its normals.
    ///
    /// Cloth that lies still deeper than [`SKIN_REACH`] in it is not brought out.
    pub surfels: &'a [Surfel],
    /// Velocity of the air [m/s]; the fabric's drag rate pulls every particle towards it.
    pub air_velocity: Vec3,
}

/// One step of a cloth, all but what it moves.
pub struct StepOf<'a, M> {
    /// What never changes.
    pub model: &'a M,
    /// What the user turns.
    pub config: &'a SolverConfig,
    /// What the world does in the step.
    pub input: &'a StepInput<'a>,
    /// Duration of the step [s].
    pub dt: f32,
}

/// One step of a grid.
pub type GridStep<'a> = StepOf<'a, ClothModel>;

// Not derived: a step can be copied whether or not its model can.
impl<M> Clone for StepOf<'_, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for StepOf<'_, M> {}

impl<M> StepOf<'_, M> {
    /// What gravity adds to a speed in the step [m/s].
    pub(crate) fn speed_gain(&self) -> f32 {
        self.config.gravity.length() * self.dt
    }
}

/// How far a step, or a part of it, has come at the end of a substep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Progress {
    /// Share of it that is over, from 0 to 1.
    pub(crate) fraction: f32,
    /// Share of it that the substep alone is.
    pub(crate) share: f32,
}

impl Progress {
    /// After `done` of `count` substeps that are equally long.
    #[expect(clippy::cast_precision_loss, reason = "substeps are few")]
    pub(crate) const fn after(done: u32, count: u32) -> Self {
        Self {
            fraction: done as f32 / count as f32,
            share: 1.0 / count as f32,
        }
    }
}

/// Moves the cloth on by `dt` [s].
///
/// Pins, capsules and surfels move evenly from where the previous call left them to where `input` has them.
/// Inside a rayon thread pool the work is shared; the result is the same bit for bit.
///
/// # Errors
/// A state of another cloth, or as many targets as there are not pins; the cloth is as it was then. Whoever
/// cannot be sure of what comes in looks at the positions: what is no number goes on as that.
pub fn step(
    model: &ClothModel,
    config: &SolverConfig,
    input: &StepInput<'_>,
    state: &mut ClothState,
    dt: f32,
) -> Result<(), Lost> {
    check_cloth(0, [model.layout.vector_count(), state.positions.len()])?;
    check_pins(model.pin_indices().len(), input.pin_targets)?;
    let step = StepOf {
        model,
        config,
        input,
        dt,
    };
    xpbd::advance(step, state);
    keep_surroundings(input, state);
    Ok(())
}

/// Moves the cloth on as [`step`](step()) does, bit for bit, and calls `passed` whenever a [`Phase`] has
/// ended: first of all for what the caller did before. A phase ends several times in a step.
///
/// Nothing is shared among threads then, so that no phase hides behind another.
///
/// # Errors
/// A state of another cloth, or as many targets as there are not pins; the cloth is as it was then.
pub fn step_observed(
    step: GridStep<'_>,
    state: &mut ClothState,
    passed: &mut dyn FnMut(Phase),
) -> Result<(), Lost> {
    let (model, targets) = (step.model, step.input.pin_targets);
    check_cloth(0, [model.layout.vector_count(), state.positions.len()])?;
    check_pins(model.pin_indices().len(), targets)?;
    xpbd::observed::advance(step, state, passed);
    keep_surroundings(step.input, state);
    Ok(())
}

/// From here pins, capsules and surfels move on in the next step.
fn keep_surroundings(input: &StepInput<'_>, state: &mut ClothState) {
    state.pin_targets.clear();
    state.pin_targets.extend_from_slice(input.pin_targets);
    state.capsules.clear();
    state.capsules.extend_from_slice(input.capsules);
    state.surfels.clear();
    state.surfels.extend_from_slice(input.surfels);
}
