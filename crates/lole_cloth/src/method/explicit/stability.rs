//! How large a step may be: by theory for one oscillator, and measured on a whole cloth.

use std::num::NonZeroU32;

use glam::DVec3;
use lole_geom::trig64;

use super::runge_kutta::{Counting, LastStage, StageDamping};
use super::{
    ContactEvaluation, ExplicitConfig, Integrator, ReferenceInput, RungeKutta, Substeps, step,
};
use crate::collision::penalty::Penalty;
use crate::method::paper;
use crate::method::reference::{ReferenceModel, ReferenceState};

/// A spectral radius this far above 1 is growth; what is below is rounding.
const GROWTH: f64 = 1.0e-12;
/// Smallest phase `ω Δt` looked at: a method that grows here has no stable step.
const SMALLEST_PHASE: f64 = 1.0e-5;
/// Largest phase looked at; no method of four stages or fewer reaches it.
const LARGEST_PHASE: f64 = 10.0;
/// Factor from one phase looked at to the next.
const PHASE_RATIO: f64 = 1.005;

/// Largest stable step [s] of `integrator` on the oscillator `x'' = -ω² x - c v` with `frequency`
/// `ω` [rad/s] and `drag_rate` `c` [1/s]; `None` where every step grows.
///
/// Found from the spectral radius of the method's own amplification matrix. For small `c` it is
/// `c / ω²` for Euler, `6 c / ω²` for (10) as printed and `11 c / ω²` with gravity and resistance
/// counted twice; `(sqrt(c² + 4 ω²) - c) / ω²` for FB Euler; `sqrt(8) / ω` for the classical
/// method without damping.
#[must_use]
pub fn stability_limit(integrator: Integrator, frequency: f64, drag_rate: f64) -> Option<f64> {
    let damping = drag_rate / frequency;
    if integrator == Integrator::Euler && 0.0 < damping {
        // In closed form: with little damping the limit lies below any phase worth a search.
        let phase = if damping < 2.0 {
            damping
        } else {
            2.0 / (0.5 * damping + (0.25 * damping * damping - 1.0).sqrt())
        };
        return Some(phase / frequency);
    }
    let grows =
        |phase: f64| 1.0 + GROWTH < spectral_radius(amplification(integrator, damping, phase));
    let mut stable = SMALLEST_PHASE;
    if grows(stable) {
        return None;
    }
    let mut unstable = stable * PHASE_RATIO;
    while !grows(unstable) {
        stable = unstable;
        unstable *= PHASE_RATIO;
        if LARGEST_PHASE < unstable {
            return Some(stable / frequency);
        }
    }
    for _ in 0..60 {
        let middle = 0.5 * (stable + unstable);
        if grows(middle) {
            unstable = middle;
        } else {
            stable = middle;
        }
    }
    Some(stable / frequency)
}

/// What one step makes of `[x, v / ω]`, for `damping` `c / ω` and `phase` `ω Δt`; by columns.
fn amplification(integrator: Integrator, damping: f64, phase: f64) -> [[f64; 2]; 2] {
    [[1.0, 0.0], [0.0, 1.0]].map(|start| scalar_step(integrator, damping, phase, start))
}

/// One step of the oscillator with `ω = 1`.
fn scalar_step(integrator: Integrator, damping: f64, dt: f64, [x, v]: [f64; 2]) -> [f64; 2] {
    let acceleration = |x: f64, v: f64| -x - damping * v;
    let one_stage = |scheme: fn(DVec3, DVec3, DVec3, f64) -> (DVec3, DVec3)| {
        let (x, v) = scheme(
            DVec3::X * x,
            DVec3::X * v,
            DVec3::X * acceleration(x, v),
            dt,
        );
        [x.x, v.x]
    };
    match integrator {
        Integrator::Euler => one_stage(paper::euler),
        Integrator::FbEuler => one_stage(paper::fb_euler),
        Integrator::RungeKutta(method) => four_stages(method, damping, dt, [x, v]),
    }
}

/// One step of (10) or its kin on the oscillator with `ω = 1`.
fn four_stages(method: RungeKutta, damping: f64, dt: f64, [x, v]: [f64; 2]) -> [f64; 2] {
    let last = match method.last_stage {
        LastStage::Full => 1.0,
        LastStage::Half => 0.5,
    };
    let (mut slope, mut sum) = ([0.0; 2], [0.0; 2]);
    for (stage, (node, weight)) in [(0.0, 1.0), (0.5, 2.0), (0.5, 2.0), (last, 1.0)]
        .into_iter()
        .enumerate()
    {
        let (x_stage, v_stage) = (x + slope[0] * dt * node, v + slope[1] * dt * node);
        let damped = match method.damping {
            StageDamping::PerStage => v_stage,
            StageDamping::Frozen => v,
        };
        let again = match method.counting {
            Counting::Twice if stage > 0 => damping * v,
            _ => 0.0,
        };
        slope = [v_stage, -x_stage - damping * damped - again];
        sum = [sum[0] + weight * slope[0], sum[1] + weight * slope[1]];
    }
    [x + sum[0] * dt / 6.0, v + sum[1] * dt / 6.0]
}

/// Largest size of an eigenvalue of a matrix given by columns.
fn spectral_radius([[a, c], [b, d]]: [[f64; 2]; 2]) -> f64 {
    let half_trace = 0.5 * (a + d);
    let determinant = a * d - b * c;
    let discriminant = half_trace * half_trace - determinant;
    if discriminant < 0.0 {
        determinant.sqrt()
    } else {
        half_trace.abs() + discriminant.sqrt()
    }
}

/// The fastest motion a cloth can make.
#[derive(Debug, Clone, PartialEq)]
pub struct HighestMode {
    /// Angular frequency `ω` [rad/s].
    pub frequency: f64,
    /// Displacements by particle, of unit size together; zero where pinned.
    pub shape: Vec<DVec3>,
    rest: Vec<DVec3>,
}

impl HighestMode {
    /// The highest mode of `model` about the positions `rest` [m], by `iterations` power
    /// iterations on the forces: the frequency creeps up to its value from below.
    #[must_use]
    pub fn of(model: &ReferenceModel, rest: &[DVec3], iterations: u32) -> Self {
        // Any start will do that is not by chance at right angles to the mode.
        let mut shape: Vec<DVec3> = (0..rest.len())
            .map(|index| {
                let turn = index as f64;
                let [x, y, z] = [1.7, 2.3, 2.9].map(|step| trig64::sin(1.0 + step * turn));
                DVec3::new(x, y, z)
            })
            .zip(model.pinned())
            .map(|(vector, &pinned)| if pinned { DVec3::ZERO } else { vector })
            .collect();
        let mut frequency_squared = 0.0;
        for _ in 0..iterations {
            normalize(&mut shape);
            shape = accelerations_against(model, rest, &shape);
            frequency_squared = norm(&shape);
        }
        normalize(&mut shape);
        Self {
            frequency: frequency_squared.sqrt(),
            shape,
            rest: rest.to_vec(),
        }
    }

    /// Natural logarithm of the growth a step of the mode in `model`, which may have another drag
    /// than the one the mode was found with: `count` steps of `dt` [s] from a displacement of
    /// `size` [m], then as many more to compare with.
    #[must_use]
    pub fn growth(
        &self,
        model: &ReferenceModel,
        integrator: Integrator,
        [dt, size]: [f64; 2],
        count: NonZeroU32,
    ) -> f64 {
        let displaced = self.rest.iter().zip(&self.shape);
        let mut state = ReferenceState::at_rest(
            displaced
                .map(|(rest, shape)| *rest + *shape * size)
                .collect(),
        );
        let config = ExplicitConfig {
            gravity: DVec3::ZERO,
            wind: None,
            penalty: Penalty::new(0.0, 0.0),
            substeps: Substeps::Fixed(count),
            integrator,
            contact_evaluation: ContactEvaluation::PerStage,
        };
        let pins: Vec<DVec3> = (model.pin_indices().iter())
            .map(|&index| self.rest[index as usize])
            .collect();
        let input = ReferenceInput {
            time: 0.0,
            pin_targets: &pins,
            capsules: &[],
        };
        let steps = f64::from(count.get());
        let mut advanced = || {
            step(model, &config, &input, &mut state, dt * steps).expect("a target for every pin");
            let sum: f64 = (state
                .positions
                .iter()
                .zip(&self.rest)
                .zip(&state.velocities))
            .map(|((position, rest), velocity)| {
                (*position - *rest).length_squared()
                    + velocity.length_squared() / (self.frequency * self.frequency)
            })
            .sum();
            sum.sqrt()
        };
        let early = advanced();
        let late = advanced();
        trig64::ln(late / early) / steps
    }
}

/// Displacement [m] over which forces are differenced.
const DIFFERENCE: f64 = 1.0e-7;

/// `-a'(x) u`: minus the change of the accelerations [m/s²] with the displacement `shape` [m].
fn accelerations_against(model: &ReferenceModel, rest: &[DVec3], shape: &[DVec3]) -> Vec<DVec3> {
    let moved = |sign: f64| -> Vec<DVec3> {
        let vectors = rest.iter().zip(shape);
        vectors
            .map(|(rest, shape)| *rest + *shape * (sign * DIFFERENCE))
            .collect()
    };
    let (plus, minus) = (moved(1.0), moved(-1.0));
    (0..rest.len())
        .map(|index| {
            if model.pinned()[index] {
                return DVec3::ZERO;
            }
            let difference =
                model.internal_force(index, &minus) - model.internal_force(index, &plus);
            difference / (2.0 * DIFFERENCE * model.masses()[index])
        })
        .collect()
}

fn norm(vectors: &[DVec3]) -> f64 {
    vectors
        .iter()
        .map(|vector| vector.length_squared())
        .sum::<f64>()
        .sqrt()
}

fn normalize(vectors: &mut [DVec3]) {
    let size = norm(vectors);
    for vector in vectors {
        *vector /= size;
    }
}
