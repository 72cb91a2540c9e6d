//! Where a grid meets the body and itself in a step, and what of that is solved apart from its rows.

use fearless_simd::dispatch;
use glam::Vec3;

use super::Plan;
use super::substep::Substep;
use crate::ClothState;
use crate::collision::capsule::MovingCapsule;
use crate::collision::capsule::near::{CapsuleSweep, Rows};
use crate::collision::cloth_cloth::{ClothContactLaw, Columns, Shape};
use crate::collision::face_contact::Moving;
use crate::collision::surfel::{Cloth, Encounter, Skin, SurfelContacts};
use crate::lanes::LANES;
use crate::method::fineness::Substeps;
use crate::phase::{Observer, Phase};
use crate::state::Scratch;
use crate::step::{GridStep, Progress};

/// Where each row may touch the body in this step.
pub(crate) fn find_body_contacts(step: GridStep<'_>, state: &mut ClothState) {
    let (model, config) = (step.model, step.config);
    let scratch = &mut state.scratch;
    let rows = Rows {
        positions: &state.positions,
        velocities: &state.velocities,
        width: model.layout.group_count,
    };
    let sweep = CapsuleSweep {
        before: &state.capsules,
        after: step.input.capsules,
        contact_offset: config.contact_offset,
        speed_gain: step.speed_gain(),
        dt: step.dt,
    };
    let level = config.instruction_set.level();
    dispatch!(level, simd => scratch.row_contacts.find(simd, rows, sweep));
    let spacing = model.spec().grid.spacing[1];
    model.pinned_rows.held_depths(
        (config.held_depth, model.spec().grid.row_count, spacing),
        &mut scratch.held_depths,
    );
    let substep_count = state.fineness.substep_count(Substeps::of(config));
    with_skin(step, state, |contacts, encounter| {
        contacts.plan(encounter, substep_count);
    });
}

/// Moves the capsules to where they are when the step has come so far.
pub(crate) fn move_capsules(step: GridStep<'_>, progress: Progress, state: &mut ClothState) {
    let pairs = state.capsules.iter().zip(step.input.capsules);
    let moving = pairs.map(|(before, after)| {
        MovingCapsule::new([before, after], progress, step.config.contact_offset)
    });
    state.scratch.moving_capsules.clear();
    state.scratch.moving_capsules.extend(moving);
}

/// Calls with the contacts with the skin, and with cloth and skin at the start of the step.
pub(super) fn with_skin(
    step: GridStep<'_>,
    state: &mut ClothState,
    act: impl FnOnce(&mut SurfelContacts, Encounter<'_>),
) {
    let mut contacts = std::mem::take(&mut state.scratch.surfel_contacts);
    act(&mut contacts, encounter(step, state));
    state.scratch.surfel_contacts = contacts;
}

/// The cloth as it is, and the skin that it may touch in the step.
fn encounter<'a>(step: GridStep<'a>, state: &'a ClothState) -> Encounter<'a> {
    let Scratch {
        held_depths,
        crossing_repair,
        ..
    } = &state.scratch;
    Encounter {
        cloth: Cloth {
            layout: &step.model.layout,
            positions: &state.positions,
            velocities: &state.velocities,
            held: held_depths,
            spacing: step.model.spec().grid.spacing[0],
            speed_gain: step.speed_gain(),
            dt: step.dt,
            held_back: &crossing_repair.held_back,
            torn: crossing_repair.torn(),
            hanging: step.model,
        },
        skin: Skin {
            before: &state.surfels,
            after: step.input.surfels,
            offset: step.config.contact_offset,
        },
    }
}

/// Where the cloth may touch the skin, and, at the same time, where it may touch itself in this
/// step: the law of that, and the interval of substeps.
pub(super) fn find_contacts(
    step: GridStep<'_>,
    substep: &Substep,
    state: &mut ClothState,
    observer: Observer<'_>,
) -> Option<(ClothContactLaw, u32)> {
    let mut surfel_contacts = std::mem::take(&mut state.scratch.surfel_contacts);
    let mut cloth_contacts = std::mem::take(&mut state.scratch.cloth_contacts);
    let (model, config) = (step.model, step.config);
    let encounter = encounter(step, state);
    let level = config.instruction_set.level();
    let mut find_skin = || surfel_contacts.begin_substep(level, (0, substep.count), encounter);
    let found = if let Some(contact) = config.self_collision {
        let shape = Shape {
            grid: &model.spec().grid,
            layout: &model.layout,
            pinned_rows: &model.pinned_rows,
            inv_masses: &model.inv_masses,
            is_tangled: &state.scratch.crossing_repair.is_tangled,
        };
        let friction = model.spec().fabric.cloth_friction;
        let law = ClothContactLaw::new(shape.grid, contact.radius, friction, substep.h);
        let positions = &state.positions;
        let mut find_cloth =
            || dispatch!(level, simd => cloth_contacts.find(simd, shape, positions, law));
        if let Some(passed) = observer {
            find_skin();
            passed(Phase::FindBody);
            find_cloth();
            passed(Phase::FindSelf);
        } else {
            rayon::join(find_skin, find_cloth);
        }
        Some((law, contact.substep_interval.get()))
    } else {
        find_skin();
        if let Some(passed) = observer {
            passed(Phase::FindBody);
        }
        None
    };
    state.scratch.surfel_contacts = surfel_contacts;
    state.scratch.cloth_contacts = cloth_contacts;
    found
}

/// Keeps what was parted apart.
pub(super) fn keep_guards(plan: &Plan, state: &mut ClothState) {
    let guards = std::mem::take(&mut state.scratch.crossing_repair.guards);
    guards.solve(state, plan.friction, plan.substep.h);
    state.scratch.crossing_repair.guards = guards;
}

/// Parts what of the cloth is nearer to other cloth than it may be.
pub(super) fn solve_cloth_contacts(law: ClothContactLaw, state: &mut ClothState) {
    let columns = Columns {
        positions: &mut state.positions,
        predicted: &mut state.scratch.predicted,
        velocities: &state.velocities,
    };
    state.scratch.cloth_contacts.solve(columns, law);
}

impl Moving for ClothState {
    fn place(&self, _piece: usize, slot: usize) -> Vec3 {
        self.positions[slot / LANES].get(slot % LANES)
    }

    fn start(&self, _piece: usize, slot: usize, h: f32) -> Vec3 {
        let (vector, lane) = (slot / LANES, slot % LANES);
        self.scratch.predicted[vector].get(lane) - self.velocities[vector].get(lane) * h
    }

    fn put(&mut self, _piece: usize, slot: usize, position: Vec3, quiet: Vec3) {
        let (vector, lane) = (slot / LANES, slot % LANES);
        self.positions[vector].set(lane, position);
        let predicted = &mut self.scratch.predicted[vector];
        predicted.set(lane, predicted.get(lane) + quiet);
    }
}
