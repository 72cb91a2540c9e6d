//! The paper's integrators on the reference model: Euler (8), FB Euler (9) and Runge-Kutta (10), as
//! many substeps as asked for or as the highest frequency needs.

mod forces;
mod one_stage;
mod runge_kutta;
mod stability;

use std::num::NonZeroU32;

use glam::DVec3;
use lole_geom::Capsule;

pub use runge_kutta::{Counting, LastStage, RungeKutta, StageDamping, StageTime};
pub use stability::{HighestMode, stability_limit};

use crate::collision::penalty::{MovingCapsule, Penalty};
use crate::lost::{Lost, check_cloth};
use crate::method::paper;
use crate::method::reference::{ReferenceModel, ReferenceState};
use crate::wind::Wind;
use forces::World;

/// Particles that share one look at the capsules and one task; fixed, so that the work is cut the
/// same way on any number of threads.
const BLOCK: usize = 64;

/// Below this many particles handing blocks to threads costs more than it saves.
const PARALLEL_FROM: usize = 2048;

/// How positions and velocities follow from forces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Integrator {
    /// Equation (8): explicit Euler. An undamped oscillator gains energy in every step.
    Euler,
    /// Equation (9): symplectic Euler, which the paper calls FB Euler.
    #[default]
    FbEuler,
    /// Equation (10) and its kin: four evaluations of the forces a step.
    RungeKutta(RungeKutta),
}

impl Integrator {
    /// Evaluations of all forces in one step.
    #[must_use]
    pub const fn evaluations_per_step(self) -> u32 {
        match self {
            Self::Euler | Self::FbEuler => 1,
            Self::RungeKutta(_) => 4,
        }
    }
}

/// When the contact force (14) is worked out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ContactEvaluation {
    /// In every stage, like every other force.
    #[default]
    PerStage,
    /// Once at the start of a step and then held, as the paper's text reads: where particle and
    /// body "have collided, the post-collision behavior is calculated". Methods of one stage do
    /// this anyway.
    PerStep,
}

/// How a step is divided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Substeps {
    /// As many as [`ReferenceModel::stable_substeps_at`] asks for, which keep [`Integrator::FbEuler`]
    /// stable whatever the integrator is.
    Automatic,
    /// A fixed number; too few and the cloth flies apart.
    Fixed(NonZeroU32),
}

/// What the user turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExplicitConfig {
    /// Acceleration of free fall, `g` [m/s²].
    pub gravity: DVec3,
    /// Still air when `None`.
    pub wind: Option<Wind>,
    /// How capsules push.
    pub penalty: Penalty,
    /// How a step is divided.
    pub substeps: Substeps,
    /// How the particles move.
    pub integrator: Integrator,
    /// When contact is worked out.
    pub contact_evaluation: ContactEvaluation,
}

impl ExplicitConfig {
    /// Gravity on Earth, no wind, automatic substeps, and a penalty as stiff as the model's own
    /// substeps over `dt` [s] allow (`ω_c Δt = 0.5` for the lightest particle), critically damped
    /// for it, so that contact asks for hardly more substeps than the cloth itself.
    #[must_use]
    pub fn for_model(model: &ReferenceModel, dt: f64) -> Self {
        let substeps = model.stable_substeps(dt, &Penalty::new(0.0, 0.0));
        let frequency = 0.5 * f64::from(substeps) / dt;
        let mass = model.lightest_mass();
        Self {
            gravity: DVec3::new(0.0, -9.81, 0.0),
            wind: None,
            penalty: Penalty::new(mass * frequency * frequency, 2.0 * mass * frequency),
            substeps: Substeps::Automatic,
            integrator: Integrator::FbEuler,
            contact_evaluation: ContactEvaluation::PerStage,
        }
    }
}

/// What the dancer does during one step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReferenceInput<'a> {
    /// Time at the start of the step [s], for the wind.
    pub time: f64,
    /// Where the pinned particles are at the end of the step [m], in the order of
    /// [`ReferenceModel::pin_indices`].
    pub pin_targets: &'a [DVec3],
    /// The capsules at the end of the step. They move there from where the last step left them; in
    /// the first step, or when their number changes, they stand still.
    pub capsules: &'a [Capsule],
}

/// Advances the cloth by `dt` [s] and returns the number of substeps it took.
///
/// Pinned particles and capsules move on straight lines to where `input` has them at the end of the
/// step.
///
/// # Errors
/// A state of another cloth, or as many targets as there are not pins; the cloth is as it was then.
pub fn step(
    model: &ReferenceModel,
    config: &ExplicitConfig,
    input: &ReferenceInput<'_>,
    state: &mut ReferenceState,
    dt: f64,
) -> Result<u32, Lost> {
    check_cloth(0, [model.masses().len(), state.positions.len()])?;
    let (expected, found) = (model.pin_indices().len(), input.pin_targets.len());
    if expected != found {
        return Err(Lost::Pins { expected, found });
    }
    let substep_count = match config.substeps {
        Substeps::Automatic => model.stable_substeps_at(&state.positions, dt, &config.penalty),
        Substeps::Fixed(count) => count.get(),
    };
    if state.capsules.len() != input.capsules.len() {
        state.capsules = input.capsules.to_vec();
    }
    let course = Course {
        model,
        config,
        input,
        pin_starts: pin_positions(model, state),
        capsule_starts: std::mem::take(&mut state.capsules),
        dt,
        substep_count,
    };
    match config.integrator {
        Integrator::Euler => one_stage::run(&course, paper::euler, state),
        Integrator::FbEuler => one_stage::run(&course, paper::fb_euler, state),
        Integrator::RungeKutta(method) => runge_kutta::run(&course, method, state),
    }
    state.capsules = course.capsule_starts;
    state.capsules.copy_from_slice(input.capsules);
    Ok(substep_count)
}

/// Positions of the pinned particles before the step.
fn pin_positions(model: &ReferenceModel, state: &ReferenceState) -> Vec<DVec3> {
    model
        .pin_indices()
        .iter()
        .map(|&index| state.positions[index as usize])
        .collect()
}

/// What pins, capsules and wind do during one step.
struct Course<'a> {
    model: &'a ReferenceModel,
    config: &'a ExplicitConfig,
    input: &'a ReferenceInput<'a>,
    pin_starts: Vec<DVec3>,
    capsule_starts: Vec<Capsule>,
    /// Duration of the step [s].
    dt: f64,
    substep_count: u32,
}

impl Course<'_> {
    /// Duration of a substep [s].
    fn substep_dt(&self) -> f64 {
        self.dt / f64::from(self.substep_count)
    }

    /// Everything that acts on the particles `substeps` after the start of the step.
    fn world_at(&self, substeps: f64) -> World<'_> {
        let fraction = substeps / f64::from(self.substep_count);
        let offset = self.config.penalty.contact_offset;
        let bodies = self.capsule_starts.iter().zip(self.input.capsules);
        let dt = self.substep_dt();
        World {
            model: self.model,
            config: self.config,
            bodies: bodies
                .map(|(from, to)| {
                    MovingCapsule::between(from, to, fraction, self.dt).inflated(offset)
                })
                .collect(),
            wind: self.config.wind.map_or(DVec3::ZERO, |wind| {
                wind.force(self.input.time + substeps * dt)
            }),
            dt,
        }
    }

    /// Puts the pinned particles where they are `substeps` after the start of the step; at its end
    /// exactly onto their targets.
    fn place_pins(&self, substeps: f64, positions: &mut [DVec3]) {
        let fraction = substeps / f64::from(self.substep_count);
        let pins = self.model.pin_indices().iter().zip(&self.pin_starts);
        for ((&index, &start), &target) in pins.zip(self.input.pin_targets) {
            positions[index as usize] = if fraction < 1.0 {
                start + (target - start) * fraction
            } else {
                target
            };
        }
    }

    /// Gives the pinned particles the velocity with which they are carried.
    fn carry_pins(&self, velocities: &mut [DVec3]) {
        let pins = self.model.pin_indices().iter().zip(&self.pin_starts);
        for ((&index, &start), &target) in pins.zip(self.input.pin_targets) {
            velocities[index as usize] = (target - start) / self.dt;
        }
    }
}
