//! Methods with four stages: the classical Runge-Kutta method, and equation (10) as it is printed.
//!
//! The print departs from the classical method in four places. Each is a switch of its own here,
//! so that its effect can be seen alone.

use glam::DVec3;

use super::{ContactEvaluation, Course};
use crate::method::reference::ReferenceState;

/// Which four-stage method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RungeKutta {
    /// Where the fourth stage looks.
    pub last_stage: LastStage,
    /// Which velocity the resistance (3) of the later stages sees.
    pub damping: StageDamping,
    /// How often gravity and resistance count.
    pub counting: Counting,
    /// When wind, pins and capsules are looked at.
    pub time: StageTime,
}

/// Where the fourth stage of a step looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LastStage {
    /// At the end of the step, `x + kx_3`, `v + kv_3`: fourth order.
    Full,
    /// In its middle, `x + kx_3 / 2`, `v + kv_3 / 2`, as printed: first order, and unstable for
    /// every undamped oscillator.
    Half,
}

/// Which velocity the damping of stages two to four sees.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StageDamping {
    /// The velocity that the stage itself has.
    PerStage,
    /// `v(t)` of the start of the step, as printed: first order where there is damping.
    Frozen,
}

/// How often gravity and resistance count in stages two to four.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Counting {
    /// Once.
    Once,
    /// Twice: in `F` of (6), and again in `- c v(t) + g` of (10). Cloth then falls with
    /// `11/6 g`.
    Twice,
}

/// When the stages look at wind, pins and capsules.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StageTime {
    /// At their own time.
    Moving,
    /// At the start of the step: `F` has no time in the print.
    Frozen,
}

impl RungeKutta {
    /// The classical method of fourth order.
    pub const CLASSICAL: Self = Self {
        last_stage: LastStage::Full,
        damping: StageDamping::PerStage,
        counting: Counting::Once,
        time: StageTime::Moving,
    };

    /// Equation (10) as printed, with gravity and resistance counted once.
    pub const AS_PRINTED: Self = Self {
        last_stage: LastStage::Half,
        damping: StageDamping::Frozen,
        counting: Counting::Once,
        time: StageTime::Frozen,
    };

    /// Equation (10) as printed, with `F` read as (6), which has gravity and resistance in it.
    pub const DOUBLE_COUNTED: Self = Self {
        counting: Counting::Twice,
        ..Self::AS_PRINTED
    };

    /// Shares of the step at which the four stages look.
    const fn nodes(self) -> [f64; 4] {
        match self.last_stage {
            LastStage::Full => [0.0, 0.5, 0.5, 1.0],
            LastStage::Half => [0.0, 0.5, 0.5, 0.5],
        }
    }
}

/// Weights of the stages' slopes, over six.
const WEIGHTS: [f64; 4] = [1.0, 2.0, 2.0, 1.0];

/// What the stages need room for, by particle.
struct Stages {
    /// `x + kx / 2` and the like: where the stage looks [m].
    positions: Vec<DVec3>,
    /// The velocity of the stage [m/s].
    velocities: Vec<DVec3>,
    /// The acceleration of the stage [m/s²].
    accelerations: Vec<DVec3>,
    /// `kx_1 + 2 kx_2 + 2 kx_3 + kx_4` [m], as far as known.
    position_sums: Vec<DVec3>,
    /// `kv_1 + 2 kv_2 + 2 kv_3 + kv_4` [m/s], as far as known.
    velocity_sums: Vec<DVec3>,
    /// Contact forces held through the step [N].
    penalties: Vec<DVec3>,
}

/// All substeps of a step by `method`.
pub(super) fn run(course: &Course<'_>, method: RungeKutta, state: &mut ReferenceState) {
    let zeros = || vec![DVec3::ZERO; state.positions.len()];
    let mut stages = Stages {
        positions: zeros(),
        velocities: zeros(),
        accelerations: zeros(),
        position_sums: zeros(),
        velocity_sums: zeros(),
        penalties: zeros(),
    };
    for substep in 0..course.substep_count {
        let start = f64::from(substep);
        method.advance(course, start, state, &mut stages);
        course.place_pins(start + 1.0, &mut state.positions);
        course.carry_pins(&mut state.velocities);
    }
}

impl RungeKutta {
    /// The substep that begins `start` substeps after the start of the step.
    fn advance(
        self,
        course: &Course<'_>,
        start: f64,
        state: &mut ReferenceState,
        stages: &mut Stages,
    ) {
        let dt = course.substep_dt();
        let is_held = course.config.contact_evaluation == ContactEvaluation::PerStep;
        stages.position_sums.fill(DVec3::ZERO);
        stages.velocity_sums.fill(DVec3::ZERO);
        for (stage, (&node, &weight)) in self.nodes().iter().zip(&WEIGHTS).enumerate() {
            let node_time = match self.time {
                StageTime::Moving => start + node,
                StageTime::Frozen => start,
            };
            // kx and kv of the stage before, of which this one goes `node` of the way.
            for index in 0..state.positions.len() {
                let velocity_before = stages.velocities[index];
                let acceleration_before = stages.accelerations[index];
                let ahead = if stage == 0 { 0.0 } else { node * dt };
                stages.positions[index] = state.positions[index] + velocity_before * ahead;
                stages.velocities[index] = state.velocities[index] + acceleration_before * ahead;
            }
            course.place_pins(node_time, &mut stages.positions);
            let world = course.world_at(node_time);
            if is_held && stage == 0 {
                world.penalties(&stages.positions, &stages.velocities, &mut stages.penalties);
            }
            let damped = match self.damping {
                StageDamping::PerStage => &stages.velocities,
                StageDamping::Frozen => &state.velocities,
            };
            let held = is_held.then_some(stages.penalties.as_slice());
            world.accelerations(&stages.positions, damped, held, &mut stages.accelerations);
            if self.counting == Counting::Twice && stage > 0 {
                count_again(course, &state.velocities, &mut stages.accelerations);
            }
            for index in 0..state.positions.len() {
                stages.position_sums[index] += stages.velocities[index] * (weight * dt);
                stages.velocity_sums[index] += stages.accelerations[index] * (weight * dt);
            }
        }
        for (index, &is_pinned) in course.model.pinned().iter().enumerate() {
            if !is_pinned {
                state.positions[index] += stages.position_sums[index] / 6.0;
                state.velocities[index] += stages.velocity_sums[index] / 6.0;
            }
        }
    }
}

/// The second `- c v(t) + g` of a printed stage.
fn count_again(course: &Course<'_>, velocities: &[DVec3], accelerations: &mut [DVec3]) {
    let rate = course.model.drag_rate();
    for (acceleration, &velocity) in accelerations.iter_mut().zip(velocities) {
        *acceleration += course.config.gravity - velocity * rate;
    }
}
