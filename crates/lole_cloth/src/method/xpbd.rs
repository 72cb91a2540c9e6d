//! Small substeps with one projection of every constraint each: the real-time method.
//!
//! Macklin and others 2019, "Small Steps in Physics Simulation", with XPBD's compliance. Every
//! substep predicts, solves the constraints from the farthest-reaching to the nearest, then
//! contacts, and turns what the projections changed into velocity: `v += (x - prediction) / h`
//! rather than `v = (x - x_before) / h`, because the second loses bits in `f32` at small `h`.

mod contact;
pub(crate) mod observed;
mod schedule;
mod substep;
mod work;
mod woven;

use fearless_simd::{Simd, dispatch};
use glam::Vec3;

use crate::collision::capsule::near::Range;
use crate::collision::cloth_cloth::ClothContactLaw;
use crate::collision::outside::Body;
use crate::collision::repair::Fixed;
use crate::collision::surfel::SurfelContacts;
use crate::method::fineness::Substeps;
use crate::phase::Observer;
use crate::pins::PinSlots;
use crate::step::{GridStep, Progress};
use crate::{ClothModel, ClothState, Crossings, SelfCollision, diagnose};
pub(crate) use contact::{find_body_contacts, move_capsules};
use contact::{find_contacts, keep_guards, solve_cloth_contacts, with_skin};
pub(crate) use schedule::Schedules;
use schedule::{Part, set_schedules};
use substep::Substep;
pub(crate) use work::RowStrides;
use work::Work;
pub(crate) use woven::WovenRows;

/// Far capsules are tested in every so manyth substep, and in the last of a step.
const FAR_INTERVAL: u32 = 4;

/// One step of one cloth, cut into substeps so that several cloths can take theirs in turn.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Plan {
    substep: Substep,
    cloth_contact: Option<(ClothContactLaw, u32)>,
    /// Coulomb friction coefficient of cloth on cloth.
    friction: f32,
}

impl Plan {
    /// How the cloth meets itself in this substep, where it is due.
    fn law(&self, index: u32) -> Option<ClothContactLaw> {
        let (law, interval) = self.cloth_contact?;
        index.is_multiple_of(interval).then_some(law)
    }

    /// Which capsules are tested in this substep.
    fn range(&self, index: u32) -> Range {
        let is_last = index + 1 == self.substep.count;
        if is_last || (index + 1).is_multiple_of(FAR_INTERVAL) {
            Range::All
        } else {
            Range::Near
        }
    }
}

/// Moves the cloth on by `dt`.
pub(crate) fn advance(step: GridStep<'_>, state: &mut ClothState) {
    let plan = &begin(step, state);
    for index in 0..plan.substep.count {
        let now = SubstepNow { step, plan, index };
        if now.meets_itself(state) {
            now.predict_and_project(state);
            now.collide_and_finish(state);
        } else {
            now.start(state);
            now.run(Part::Whole, state);
        }
    }
    end(step, state);
}

/// What is done once, before the first substep.
pub(crate) fn begin(step: GridStep<'_>, state: &mut ClothState) -> Plan {
    begin_observed(step, state, None)
}

/// What is done once, before the first substep; whoever observes is told how long each search takes.
fn begin_observed(step: GridStep<'_>, state: &mut ClothState, observer: Observer<'_>) -> Plan {
    let GridStep {
        model,
        config,
        input,
        dt,
    } = step;
    let count = state.fineness.substep_count(Substeps::of(config));
    let substep = Substep::new(step, count);
    let woven = &mut state.scratch.woven;
    woven.set(model, config, substep.h);
    if woven.has_friction() {
        let [rows, width] = [model.layout.row_count, model.layout.group_count];
        let bend_counts = [rows * model.row_triples.len(), rows * width];
        let shear_count = rows * model.row_pairs.len();
        state.yarn_sets.prepare(bend_counts, shear_count);
    }
    if state.capsules.len() != input.capsules.len() {
        state.capsules.clear();
        state.capsules.extend_from_slice(input.capsules);
    }
    if state.surfels.len() != input.surfels.len() {
        state.surfels.clear();
        state.surfels.extend_from_slice(input.surfels);
    }
    start_pins(model, input.pin_targets, state, dt);
    find_body_contacts(step, state);
    let cloth_contact = find_contacts(step, &substep, state, observer);
    set_schedules(model, config, state);
    let scratch = &mut state.scratch;
    let starts = scratch.cloth_contacts.start_positions();
    let guards = &mut scratch.crossing_repair.guards;
    guards.prepare(starts, &model.layout, &model.inv_masses);
    Plan {
        friction: model.spec().fabric.cloth_friction,
        substep,
        cloth_contact,
    }
}

/// One substep of a step.
#[derive(Clone, Copy)]
pub(crate) struct SubstepNow<'a> {
    pub(crate) step: GridStep<'a>,
    pub(crate) plan: &'a Plan,
    /// Counted from 0.
    pub(crate) index: u32,
}

impl SubstepNow<'_> {
    /// The first part: a straight flight, and all springs but the last sweep.
    pub(crate) fn predict_and_project(self, state: &mut ClothState) {
        self.start(state);
        self.run(Part::BeforeContact, state);
    }

    /// The rest: contact of the cloth with itself, the last sweep, contact with the body, and
    /// velocities.
    pub(crate) fn collide_and_finish(self, state: &mut ClothState) {
        if let Some(law) = self.plan.law(self.index) {
            solve_cloth_contacts(law, state);
        }
        keep_guards(self.plan, state);
        self.run(Part::AfterContact, state);
    }

    /// Whether the cloth meets itself: where it is due, and where something is guarded.
    fn meets_itself(self, state: &ClothState) -> bool {
        self.plan.law(self.index).is_some() || !state.scratch.crossing_repair.guards.is_empty()
    }

    /// Brings the body to where it is at the end of the substep.
    fn start(self, state: &mut ClothState) {
        let (index, count) = (self.index, self.plan.substep.count);
        move_capsules(self.step, Progress::after(index + 1, count), state);
        let level = self.step.config.instruction_set.level();
        with_skin(self.step, state, |contacts, encounter| {
            contacts.begin_substep(level, (index, count), encounter);
        });
    }

    /// Vector instructions are chosen here and where contacts are found, and nowhere between: what
    /// calls them stays small for the compiler, however many ways lead here.
    fn run(self, part: Part, state: &mut ClothState) {
        let level = self.step.config.instruction_set.level();
        dispatch!(level, simd => self.run_with(simd, part, state));
    }

    #[inline(always)]
    fn run_with<S: Simd>(self, simd: S, part: Part, state: &mut ClothState) {
        let model = self.step.model;
        let scratch = &mut state.scratch;
        let mut work = Work {
            model,
            config: self.step.config,
            substep: &self.plan.substep,
            woven: &scratch.woven,
            strides: &scratch.row_strides,
            positions: &mut state.positions,
            velocities: &mut state.velocities,
            yarn_sets: &mut state.yarn_sets,
            predicted: &mut scratch.predicted,
            capsules: &scratch.moving_capsules,
            contacts: &scratch.row_contacts,
            range: self.plan.range(self.index),
            surfel_contacts: &scratch.surfel_contacts,
            skin_progress: scratch.surfel_contacts.progress(self.index),
            held: &scratch.held_depths,
        };
        scratch.schedules.of(part).run(
            model.layout.row_count,
            #[inline(always)]
            |stage, row| work.perform(simd, stage, row),
        );
    }
}

/// What is done once, after the last substep.
pub(crate) fn end(step: GridStep<'_>, state: &mut ClothState) {
    finish_pins(step.model, state);
    let repairs = |contact: SelfCollision| contact.crossings == Crossings::Repair;
    let repairs = step.config.self_collision.is_some_and(repairs);
    if repairs {
        repair_crossings(step, state);
    } else {
        // What a repair has left without contact, for the next one to draw out, would stay so.
        state.scratch.crossing_repair.forget();
    }
    let positions = &state.positions;
    let is_torn = (state.fineness).learn(Substeps::of(step.config), |strained, points| {
        step.model.layout.gather_points(positions, points);
        strained.count_grid(step.model, points);
    });
    if repairs && is_torn {
        limit_strain(step, state);
    }
}

/// Takes back what came to cross in this step.
fn repair_crossings(step: GridStep<'_>, state: &mut ClothState) {
    let scratch = &mut state.scratch;
    let body = body_of(step, &scratch.surfel_contacts, &scratch.held_depths);
    scratch.crossing_repair.repair(
        fixed_of(step, &body),
        scratch.cloth_contacts.start_positions(),
        &mut state.positions,
        &mut state.velocities,
    );
}

/// Brings to its lengths what this step has strained too far.
fn limit_strain(step: GridStep<'_>, state: &mut ClothState) {
    let scratch = &mut state.scratch;
    let body = body_of(step, &scratch.surfel_contacts, &scratch.held_depths);
    scratch
        .crossing_repair
        .limit_strain(fixed_of(step, &body), &mut state.positions, &|edge| {
            diagnose::each_structural_edge(step.model.spec(), edge);
        });
}

fn body_of<'a>(step: GridStep<'a>, skin: &'a SurfelContacts, held: &'a [f32]) -> Body<'a> {
    Body {
        layout: &step.model.layout,
        capsules: step.input.capsules,
        contact_offset: step.config.contact_offset,
        skin,
        held,
    }
}

fn fixed_of<'a>(step: GridStep<'a>, body: &'a Body<'a>) -> Fixed<'a> {
    Fixed {
        level: step.config.instruction_set.level(),
        surface: &step.model.surface,
        layout: &step.model.layout,
        inv_masses: &step.model.inv_masses,
        body,
        dt: step.dt,
    }
}

/// Pinned particles fly straight to where they go, so every substep finds them on the way.
pub(crate) fn start_pins(model: &ClothModel, targets: &[Vec3], state: &mut ClothState, dt: f32) {
    let pins = pins_of(model);
    let goals = &mut state.scratch.pin_goals;
    goals.set(pins, &state.pin_targets, targets, &state.positions);
    goals.start(pins, &state.positions, &mut state.velocities, dt);
}

/// Rounding has moved the pins a little off where they go.
pub(crate) fn finish_pins(model: &ClothModel, state: &mut ClothState) {
    let goals = &state.scratch.pin_goals;
    goals.finish(pins_of(model), &mut state.positions);
}

fn pins_of(model: &ClothModel) -> PinSlots<'_> {
    PinSlots {
        layout: &model.layout,
        indices: model.pin_indices(),
    }
}
