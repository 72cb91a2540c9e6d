//! One call of the engine: a piece moves on by `dt`, in small substeps with one solution of every
//! constraint each, as the grid does.

use fearless_simd::{dispatch, f32x16, prelude::*};
use glam::Vec3;
use lole_geom::trig;

use crate::collision::placement::Placement as _;
use crate::collision::response::ContactLaw;
use crate::lanes::{LANES, Vectors};
use crate::lost::{Lost, SubstepPart, check_cloth};
use crate::mesh::bend;
use crate::mesh::build::Stars;
use crate::mesh::contact;
use crate::mesh::finite::{self, all_finite, first_lost, lost_in_input};
use crate::mesh::model::MeshModel;
use crate::mesh::particles::{self, Gathered, WIDTH};
use crate::mesh::resistance::Resisting;
use crate::mesh::self_contact;
use crate::mesh::state::{MeshScratch, MeshState};
use crate::mesh::strain::{self, Strain};
use crate::mesh::stride;
use crate::mesh::tether;
use crate::method::fineness::Substeps;
use crate::phase::Phase;
use crate::pins::PinSlots;
use crate::step::StepOf;
use crate::{SolverConfig, StepInput};

/// One step of a piece.
pub(crate) type MeshStep<'a> = StepOf<'a, MeshModel>;

/// Numbers that hold for every substep of one step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Substep {
    /// Duration [s].
    pub(crate) h: f32,
    pub(crate) count: u32,
    sweep_count: u32,
    /// What gravity adds to a velocity [m/s].
    gravity_gain: Vec3,
    air_velocity: Vec3,
    /// What drag leaves of a velocity relative to the air: `exp(-drag_rate h)`.
    drag_kept: f32,
    strain: Strain,
    /// One over the longest tether allowed, squared, in units of its length.
    inv_tether_square: Option<f32>,
    pub(crate) contact: ContactLaw,
}

impl Substep {
    /// Of a step that is cut into `count` substeps.
    fn new(step: MeshStep<'_>, count: u32) -> Self {
        let MeshStep {
            model,
            config,
            input,
            dt,
        } = step;
        let sweep_count = config.structural_sweep_count.get();
        #[expect(clippy::cast_precision_loss, reason = "substeps and sweeps are few")]
        let (h, sweeps) = (dt / count as f32, sweep_count as f32);
        let fabric = &model.spec().fabric;
        // A pass without `λ` adds its own stiffness to the passes before it, hence the sweeps.
        let compliance = |modulus: f32| sweeps / (modulus * h * h);
        Self {
            h,
            count,
            sweep_count,
            gravity_gain: config.gravity * h,
            air_velocity: input.air_velocity,
            drag_kept: trig::exp(-fabric.drag_rate * h),
            strain: Strain {
                stretch: fabric.stretch.map(compliance),
                shear: compliance(fabric.shear),
            },
            inv_tether_square: config.tether_scale.map(|scale| 1.0 / (scale * scale)),
            contact: ContactLaw {
                friction: fabric.friction,
                depenetration: config.depenetration_speed * h,
            },
        }
    }
}

/// Moves the piece on by `dt` [s].
///
/// Pins, capsules and surfels move evenly from where the previous call left them to where `input` has them.
/// Of `config` the held depth is the grid's alone; strides along rows are along
/// the warp here, those down columns along the weft, in distances of a square grid as fine.
///
/// # Errors
/// The first thing that does not fit or is no finite number; the piece is as it was before the step then.
pub fn step(
    model: &MeshModel,
    config: &SolverConfig,
    input: &StepInput<'_>,
    state: &mut MeshState,
    dt: f32,
) -> Result<(), Lost> {
    check_cloth(0, [model.inv_masses.len(), state.positions.len()])?;
    if let Some(cause) = lost_in_input(model, config, input, dt) {
        return Err(cause);
    }
    let step = MeshStep {
        model,
        config,
        input,
        dt,
    };
    state.keep();
    advance(step, state, &mut None);
    if !(all_finite(&state.positions) && all_finite(&state.velocities)) {
        // The same again, looking at every particle after every phase.
        state.restore();
        let mut watch = Some(Watch::new(model, state));
        advance(step, state, &mut watch);
        state.restore();
        if let Some(cause) = watch.and_then(|watch| watch.cause) {
            return Err(cause);
        }
    }
    let positions = &state.positions;
    (state.fineness).learn(Substeps::of(config), |strained, points| {
        model.slots.gather_points(positions, points);
        strained.count_mesh(model, points);
    });
    state.pin_targets.clear();
    state.pin_targets.extend_from_slice(input.pin_targets);
    state.capsules.clear();
    state.capsules.extend_from_slice(input.capsules);
    state.surfels.clear();
    state.surfels.extend_from_slice(input.surfels);
    Ok(())
}

/// Looks for the first particle that goes nowhere.
pub(crate) struct Watch {
    substep: u32,
    cause: Option<Lost>,
}

impl Watch {
    fn new(model: &MeshModel, state: &MeshState) -> Self {
        let velocity_of = |slot| finite::at(&state.velocities, slot);
        let lost = first_lost(model, |slot| {
            finite::at(&state.positions, slot) + 0.0 * velocity_of(slot)
        });
        let cause = lost.map(|(particle, _)| {
            let slot = model.slots.of_particle[particle as usize] as usize;
            Lost::Start {
                particle,
                position: finite::at(&state.positions, slot),
                velocity: velocity_of(slot),
            }
        });
        Self { substep: 0, cause }
    }

    fn look(&mut self, model: &MeshModel, state: &MeshState, phase: SubstepPart) {
        if self.cause.is_some() {
            return;
        }
        let lost = first_lost(model, |slot| {
            if phase == SubstepPart::Contact {
                let velocity = finite::at(&state.velocities, slot);
                finite::at(&state.positions, slot) + 0.0 * velocity
            } else {
                Vec3::from_slice(&state.scratch.particles[slot * WIDTH..])
            }
        });
        self.cause = lost.map(|(particle, position)| Lost::Particle {
            particle,
            substep: self.substep,
            phase,
            position,
        });
    }
}

fn advance(step: MeshStep<'_>, state: &mut MeshState, watch: &mut Option<Watch>) {
    let substep = &begin(step, state);
    self_contact::keep_starts(step.model, step.config, state);
    self_contact::find(step.model, step.config, state, step.dt);
    for index in 0..substep.count {
        if let Some(watch) = watch {
            watch.substep = index;
        }
        let now = SubstepNow {
            step,
            substep,
            index,
        };
        now.predict_and_project(state, watch, &mut |_| {});
        self_contact::solve(now, state);
        look(watch, step.model, state, SubstepPart::Cloth);
        contact::finish(now, state);
        look(watch, step.model, state, SubstepPart::Contact);
    }
    end(step, state);
}

/// What is done once, after the last substep.
fn end(step: MeshStep<'_>, state: &mut MeshState) {
    finish_pins(step.model, state);
    self_contact::repair(step, state);
}

fn look(watch: &mut Option<Watch>, model: &MeshModel, state: &MeshState, phase: SubstepPart) {
    if let Some(watch) = watch {
        watch.look(model, state, phase);
    }
}

/// What is done once, before the first substep.
pub(crate) fn begin(step: MeshStep<'_>, state: &mut MeshState) -> Substep {
    start(step, state);
    contact::find(step, state);
    let count = state.fineness.substep_count(Substeps::of(step.config));
    let substep = Substep::new(step, count);
    (state.scratch.resisting).set(step.model, substep.h, substep.strain);
    substep
}

/// One substep of a step.
#[derive(Clone, Copy)]
pub(crate) struct SubstepNow<'a> {
    pub(crate) step: MeshStep<'a>,
    pub(crate) substep: &'a Substep,
    /// Counted from 0.
    pub(crate) index: u32,
}

impl SubstepNow<'_> {
    /// The first part: everything but contact. `passed` is told of every phase that has ended.
    pub(crate) fn predict_and_project(
        self,
        state: &mut MeshState,
        watch: &mut Option<Watch>,
        passed: &mut dyn FnMut(Phase),
    ) {
        contact::begin_substep(self, state);
        passed(Phase::FindBody);
        let (model, substep) = (self.step.model, self.substep);
        let level = self.step.config.instruction_set.level();
        dispatch!(level, simd => predict(simd, model, substep, state));
        look(watch, model, state, SubstepPart::Flight);
        passed(Phase::Predict);
        let MeshScratch {
            particles, strides, ..
        } = &mut state.scratch;
        dispatch!(level, simd => stride::solve(simd, particles, strides));
        look(watch, model, state, SubstepPart::Strides);
        passed(Phase::Strides);
        let MeshScratch {
            particles,
            resisting,
            ..
        } = &mut state.scratch;
        dispatch!(level, simd => solve_stars(simd, particles, &resisting.stars));
        look(watch, model, state, SubstepPart::Bending);
        let MeshScratch {
            particles,
            resisting,
            ..
        } = &mut state.scratch;
        let sweep_count = substep.sweep_count;
        dispatch!(level, simd => solve_triangles(simd, particles, resisting, sweep_count));
        look(watch, model, state, SubstepPart::Strain);
        passed(Phase::Stars);
    }
}

/// Bending, and the first sweep over the triangles, most of which the stars solve.
#[inline(always)]
fn solve_stars<S: Simd>(simd: S, particles: &mut [f32], stars: &Stars) {
    bend::solve(simd, particles, &stars.few);
    bend::solve(simd, particles, &stars.more);
    bend::solve(simd, particles, &stars.many);
    bend::solve_bent(simd, particles, &stars.bent_few);
    bend::solve_bent(simd, particles, &stars.bent_more);
    bend::solve_bent(simd, particles, &stars.bent_many);
}

/// The triangles that no star solves, and all of them in sweeps after the first.
#[inline(always)]
fn solve_triangles<S: Simd>(
    simd: S,
    particles: &mut [f32],
    resisting: &Resisting,
    sweep_count: u32,
) {
    for sweep in 0..sweep_count {
        let triangles = if sweep == 0 {
            &resisting.other_triangles
        } else {
            &resisting.triangles
        };
        strain::solve(simd, particles, triangles);
    }
}

/// Pinned particles fly straight to their targets, so every substep finds them on the way.
fn start(step: MeshStep<'_>, state: &mut MeshState) {
    let (model, input) = (step.model, step.input);
    state.scratch.strides.set(model, step.config);
    if state.capsules.len() != input.capsules.len() {
        state.capsules.clear();
        state.capsules.extend_from_slice(input.capsules);
    }
    if state.surfels.len() != input.surfels.len() {
        state.surfels.clear();
        state.surfels.extend_from_slice(input.surfels);
    }
    let pins = pins_of(model);
    let goals = &mut state.scratch.pin_goals;
    goals.set(
        pins,
        &state.pin_targets,
        input.pin_targets,
        &state.positions,
    );
    goals.start(pins, &state.positions, &mut state.velocities, step.dt);
}

/// Rounding has moved the pins a little off where they go.
pub(crate) fn finish_pins(model: &MeshModel, state: &mut MeshState) {
    let goals = &state.scratch.pin_goals;
    goals.finish(pins_of(model), &mut state.positions);
}

fn pins_of(model: &MeshModel) -> PinSlots<'_> {
    PinSlots {
        layout: &model.slots,
        indices: model.pin_indices(),
    }
}

/// Gravity, drag towards the air, a straight flight, and tethers.
#[inline(always)]
fn predict<S: Simd>(simd: S, model: &MeshModel, substep: &Substep, state: &mut MeshState) {
    let zero = f32x16::splat(simd, 0.0);
    let gravity = Vectors::splat(simd, substep.gravity_gain);
    let air = Vectors::splat(simd, substep.air_velocity);
    let kept = f32x16::splat(simd, substep.drag_kept);
    let h = f32x16::splat(simd, substep.h);
    fly_pins(model, substep.h, state);
    let scratch = &mut state.scratch;
    let columns = (state.positions.iter_mut())
        .zip(&mut state.velocities)
        .zip(&mut scratch.predicted)
        .zip(&model.inv_masses)
        .enumerate();
    for (vector, (((position, velocity), predicted), inv_mass)) in columns {
        let inv_mass = f32x16::load_array_ref(simd, &inv_mass.0);
        let free = zero.simd_lt(inv_mass);
        let before = Vectors::load(simd, velocity);
        // Drag slows what moves and leaves the whole weight to what hangs still.
        let after = before.sub(air).scale(kept).add(air).add(gravity);
        let after = Vectors {
            x: free.select(after.x, before.x),
            y: free.select(after.y, before.y),
            z: free.select(after.z, before.z),
        };
        let place = Vectors::load(simd, position).add(after.scale(h));
        after.store(velocity);
        place.store(predicted);
        let mut sixteen = Gathered { place, inv_mass };
        if let Some(inv_scale) = substep.inv_tether_square {
            for tethers in &model.tethers {
                let inv_square = f32x16::load_array_ref(simd, &tethers.inv_squares[vector].0);
                let anchor = tethers.anchor(simd, &scratch.particles, vector);
                sixteen.place = tether::pulled(simd, sixteen, anchor, inv_square * inv_scale);
            }
        }
        if let Some(particles) = scratch.particles[vector * LANES * WIDTH..].first_chunk_mut() {
            particles::store(sixteen, particles);
        }
    }
}

/// Tethers pull to where the pins will be after a substep of `h` [s].
fn fly_pins(model: &MeshModel, h: f32, state: &mut MeshState) {
    for &pin in model.pin_indices() {
        let slot = model.slots.of_particle[pin as usize] as usize;
        let (vector, lane) = (slot / LANES, slot % LANES);
        let place = state.positions[vector].get(lane) + state.velocities[vector].get(lane) * h;
        let particles = &mut state.scratch.particles[slot * WIDTH..][..WIDTH];
        particles.copy_from_slice(&[place.x, place.y, place.z, 0.0]);
    }
}
