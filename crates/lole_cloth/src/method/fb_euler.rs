//! `fb-euler`: the paper's winning scheme (9) on the reference model, with as many substeps as its
//! highest frequency needs.

use std::num::NonZeroU32;

use glam::DVec3;
use lole_geom::Capsule;
use rayon::prelude::*;

use crate::collision::penalty::{MovingCapsule, Penalty, contact_force, friction_force};
use crate::method::paper;
use crate::method::reference::{ReferenceModel, ReferenceState};
use crate::wind::Wind;

/// Particles that share one look at the capsules and one task; fixed, so that the work is cut the
/// same way on any number of threads.
const BLOCK: usize = 64;

/// Below this many particles handing blocks to threads costs more than it saves.
const PARALLEL_FROM: usize = 2048;

/// How a step is divided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Substeps {
    /// As many as [`ReferenceModel::stable_substeps`] asks for.
    Automatic,
    /// A fixed number; too few and the cloth flies apart.
    Fixed(NonZeroU32),
}

/// What the user turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FbEulerConfig {
    /// `g` [m/s²].
    pub gravity: DVec3,
    /// Still air when `None`.
    pub wind: Option<Wind>,
    /// How capsules push.
    pub penalty: Penalty,
    /// How a step is divided.
    pub substeps: Substeps,
}

impl FbEulerConfig {
    /// Gravity on Earth, no wind, automatic substeps, and a penalty as stiff as the model's own
    /// substeps over `dt` [s] allow (`ω_c Δt = 0.5` for the lightest particle), critically damped
    /// for it, so that contact asks for hardly more substeps than the cloth itself.
    #[must_use]
    pub fn for_model(model: &ReferenceModel, dt: f64) -> Self {
        let substeps = model.stable_substeps(dt, &Penalty::new(0.0, 0.0));
        let frequency = 0.5 * f64::from(substeps) / dt;
        let mass = lightest_mass(model);
        Self {
            gravity: DVec3::new(0.0, -9.81, 0.0),
            wind: None,
            penalty: Penalty::new(mass * frequency * frequency, 2.0 * mass * frequency),
            substeps: Substeps::Automatic,
        }
    }
}

/// Mass [kg] of the lightest free particle; zero if all are pinned.
fn lightest_mass(model: &ReferenceModel) -> f64 {
    let lightest = model
        .masses()
        .iter()
        .zip(model.pinned())
        .filter(|&(_, &is_pinned)| !is_pinned)
        .fold(f64::INFINITY, |least, (&mass, _)| least.min(mass));
    if lightest.is_finite() { lightest } else { 0.0 }
}

/// What the dancer does during one step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepInput<'a> {
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
/// # Panics
/// When the state does not have the model's number of particles, or the targets its number of pins.
pub fn step(
    model: &ReferenceModel,
    config: &FbEulerConfig,
    input: &StepInput<'_>,
    state: &mut ReferenceState,
    dt: f64,
) -> u32 {
    assert_eq!(state.positions.len(), model.masses().len(), "particles");
    assert_eq!(input.pin_targets.len(), model.pin_indices().len(), "pins");
    let substep_count = match config.substeps {
        Substeps::Automatic => model.stable_substeps(dt, &config.penalty),
        Substeps::Fixed(count) => count.get(),
    };
    if state.capsules.len() != input.capsules.len() {
        state.capsules = input.capsules.to_vec();
    }
    let pin_starts = pin_positions(model, state);
    let mut next_positions = state.positions.clone();
    let mut bodies = Vec::with_capacity(input.capsules.len());
    let count = f64::from(substep_count);
    let dt_substep = dt / count;
    for substep in 0..substep_count {
        let start = f64::from(substep);
        place_capsules(config, state, input, [start / count, dt], &mut bodies);
        let world = World {
            model,
            config,
            bodies: &bodies,
            wind: wind_at(config, input.time + start * dt_substep),
            dt: dt_substep,
        };
        advance(&world, state, &mut next_positions);
        carry_pins(
            &pin_starts,
            input,
            [(start + 1.0) / count, dt],
            model,
            state,
        );
    }
    state.capsules.copy_from_slice(input.capsules);
    substep_count
}

/// Positions of the pinned particles before the step.
fn pin_positions(model: &ReferenceModel, state: &ReferenceState) -> Vec<DVec3> {
    model
        .pin_indices()
        .iter()
        .map(|&index| state.positions[index as usize])
        .collect()
}

/// The capsules a `fraction` of the way through a step of `dt` [s].
fn place_capsules(
    config: &FbEulerConfig,
    state: &ReferenceState,
    input: &StepInput<'_>,
    [fraction, dt]: [f64; 2],
    bodies: &mut Vec<MovingCapsule>,
) {
    bodies.clear();
    bodies.extend(state.capsules.iter().zip(input.capsules).map(|(from, to)| {
        MovingCapsule::between(from, to, fraction, dt).inflated(config.penalty.contact_offset)
    }));
}

/// Equation (4) at `time` [s].
fn wind_at(config: &FbEulerConfig, time: f64) -> DVec3 {
    config.wind.map_or(DVec3::ZERO, |wind| wind.force(time))
}

/// Moves the pinned particles a `fraction` of the way to their targets; at 1 exactly onto them.
fn carry_pins(
    starts: &[DVec3],
    input: &StepInput<'_>,
    [fraction, dt]: [f64; 2],
    model: &ReferenceModel,
    state: &mut ReferenceState,
) {
    let pins = model
        .pin_indices()
        .iter()
        .zip(starts)
        .zip(input.pin_targets);
    for ((&index, &start), &target) in pins {
        state.positions[index as usize] = if fraction < 1.0 {
            start + (target - start) * fraction
        } else {
            target
        };
        state.velocities[index as usize] = (target - start) / dt;
    }
}

/// Everything that acts on the particles during one substep.
struct World<'a> {
    model: &'a ReferenceModel,
    config: &'a FbEulerConfig,
    bodies: &'a [MovingCapsule],
    wind: DVec3,
    dt: f64,
}

/// One substep of (9) for every free particle. `next_positions` is room for the new positions; the
/// old ones stay readable until all are known.
fn advance(world: &World<'_>, state: &mut ReferenceState, next_positions: &mut Vec<DVec3>) {
    let positions = &state.positions;
    let run = |(block, (nexts, velocities)): (usize, (&mut [DVec3], &mut [DVec3]))| {
        advance_block(world, positions, block * BLOCK, nexts, velocities);
    };
    if positions.len() < PARALLEL_FROM {
        next_positions
            .chunks_mut(BLOCK)
            .zip(state.velocities.chunks_mut(BLOCK))
            .enumerate()
            .for_each(run);
    } else {
        next_positions
            .par_chunks_mut(BLOCK)
            .zip(state.velocities.par_chunks_mut(BLOCK))
            .enumerate()
            .for_each(run);
    }
    std::mem::swap(&mut state.positions, next_positions);
}

/// One substep of the particles from `first` on.
fn advance_block(
    world: &World<'_>,
    positions: &[DVec3],
    first: usize,
    next_positions: &mut [DVec3],
    velocities: &mut [DVec3],
) {
    let nearby = NearbyBodies::new(
        world.bodies,
        &positions[first..first + next_positions.len()],
    );
    let moving = next_positions.iter_mut().zip(velocities).enumerate();
    for (offset, (next_position, velocity)) in moving {
        let index = first + offset;
        if world.model.pinned()[index] {
            continue;
        }
        let mass = world.model.masses()[index];
        let mut forces = paper::Forces {
            gravity: paper::gravity_force(mass, world.config.gravity),
            damper: paper::damper_force(world.model.drag_rate() * mass, *velocity),
            stretch: world.model.internal_force(index, positions),
            wind: world.wind,
            penalty: DVec3::ZERO,
        };
        if nearby.mask != 0 {
            forces.penalty = penalty(world, &nearby, [positions[index], *velocity], &forces, mass);
        }
        let acceleration = paper::acceleration(mass, paper::total_force(&forces));
        (*next_position, *velocity) =
            paper::fb_euler(positions[index], *velocity, acceleration, world.dt);
    }
}

/// Equation (14) with its direction, and friction, on the particle with this position and velocity
/// under the other `forces`.
fn penalty(
    world: &World<'_>,
    nearby: &NearbyBodies<'_>,
    [position, velocity]: [DVec3; 2],
    forces: &paper::Forces,
    mass: f64,
) -> DVec3 {
    let penalty = &world.config.penalty;
    let Some(contact) = contact_force(penalty, nearby.iter(), position, velocity) else {
        return DVec3::ZERO;
    };
    if penalty.friction <= 0.0 {
        return contact.force;
    }
    let driving = paper::total_force(forces) + contact.force;
    let next_velocity = velocity + driving * (world.dt / mass);
    let max_friction = penalty.friction * contact.force.length();
    contact.force
        + friction_force(
            &contact.deepest,
            max_friction,
            next_velocity,
            mass / world.dt,
        )
}

/// The capsules whose bounding boxes touch that of a block of particles: exact, because a particle
/// inside a capsule lies inside its box.
struct NearbyBodies<'a> {
    bodies: &'a [MovingCapsule],
    mask: u64,
}

impl<'a> NearbyBodies<'a> {
    fn new(bodies: &'a [MovingCapsule], positions: &[DVec3]) -> Self {
        let mut mask = 0;
        if !bodies.is_empty() {
            let mut low = DVec3::INFINITY;
            let mut high = DVec3::NEG_INFINITY;
            for &position in positions {
                low = low.min(position);
                high = high.max(position);
            }
            for (slot, body) in bodies.iter().enumerate() {
                let radius = DVec3::splat(body.radii[0].max(body.radii[1]));
                let is_apart = high.cmplt(body.ends[0].min(body.ends[1]) - radius).any()
                    || (body.ends[0].max(body.ends[1]) + radius).cmplt(low).any();
                // Capsules beyond the mask share its last bit.
                mask |= u64::from(!is_apart) << slot.min(63);
            }
        }
        Self { bodies, mask }
    }

    fn iter(&self) -> impl Iterator<Item = &'a MovingCapsule> {
        let mask = self.mask;
        self.bodies
            .iter()
            .enumerate()
            .filter_map(move |(slot, body)| (mask >> slot.min(63) & 1 == 1).then_some(body))
    }
}
