//! Contact of a piece with itself: vertices and triangles in the substeps, and at the end of a step
//! the repair of what came to cross all the same.

use glam::Vec3;

use crate::collision::face_contact::{Meeting, Moving};
use crate::collision::outside::Body;
use crate::collision::placement::Placement as _;
use crate::collision::repair::Fixed;
use crate::lanes::{LANES, Points};
use crate::mesh::model::MeshModel;
use crate::mesh::particles::WIDTH;
use crate::mesh::state::{MeshScratch, MeshState};
use crate::mesh::step::{MeshStep, SubstepNow};
use crate::{Crossings, SolverConfig};

/// How a piece meets cloth.
pub(crate) fn meeting(model: &MeshModel, config: &SolverConfig) -> Meeting {
    Meeting {
        radius: config.self_collision.map(|contact| contact.radius),
        friction: model.spec().fabric.cloth_friction,
    }
}

/// Remembers where the piece is at the start of a step.
pub(crate) fn keep_starts(model: &MeshModel, config: &SolverConfig, state: &mut MeshState) {
    if config.self_collision.is_some() {
        let starts = &mut state.scratch.face_contacts.positions;
        model.slots.gather_points(&state.positions, starts);
        let MeshScratch {
            face_contacts,
            crossing_repair,
            ..
        } = &mut state.scratch;
        let guards = &mut crossing_repair.guards;
        guards.prepare(&face_contacts.positions, &model.slots, &model.inv_masses);
    }
}

/// Finds where the piece may touch itself in a step.
pub(crate) fn find(model: &MeshModel, config: &SolverConfig, state: &mut MeshState, dt: f32) {
    let scratch = &mut state.scratch;
    let contacts = &mut scratch.face_contacts;
    if config.self_collision.is_none() {
        contacts.clear();
        return;
    }
    contacts
        .is_tangled
        .clone_from(&scratch.crossing_repair.is_tangled);
    let level = config.instruction_set.level();
    contacts.find(level, &model.faces, &[meeting(model, config)], dt);
}

/// Keeps what was parted in earlier steps apart in a substep of `h` [s].
fn keep_guards(model: &MeshModel, h: f32, state: &mut MeshState) {
    let guards = std::mem::take(&mut state.scratch.crossing_repair.guards);
    guards.solve(state, model.spec().fabric.cloth_friction, h);
    state.scratch.crossing_repair.guards = guards;
}

/// Moves apart what touches in a substep, where that is due, and what is guarded in every one.
pub(crate) fn solve(now: SubstepNow<'_>, state: &mut MeshState) {
    let Some(contact) = now.step.config.self_collision else {
        return;
    };
    let h = now.substep.h;
    if now.index.is_multiple_of(contact.substep_interval.get()) {
        let mut contacts = std::mem::take(&mut state.scratch.face_contacts);
        contacts.solve(state, h);
        state.scratch.face_contacts = contacts;
    }
    keep_guards(now.step.model, h, state);
}

/// Takes back what came to cross in this step.
pub(crate) fn repair(step: MeshStep<'_>, state: &mut MeshState) {
    let MeshStep {
        model,
        config,
        input,
        dt,
    } = step;
    let is_wanted =
        (config.self_collision).is_some_and(|contact| contact.crossings == Crossings::Repair);
    if !is_wanted {
        state.scratch.crossing_repair.forget();
        return;
    }
    let scratch = &mut state.scratch;
    scratch.crossing_repair.repair(
        Fixed {
            level: config.instruction_set.level(),
            surface: &model.surface,
            layout: &model.slots,
            inv_masses: &model.inv_masses,
            body: &Body {
                layout: &model.slots,
                capsules: input.capsules,
                contact_offset: config.contact_offset,
                skin: &scratch.surfel_contacts,
                held: &scratch.held,
            },
            dt,
        },
        &scratch.face_contacts.positions,
        &mut state.positions,
        &mut state.velocities,
    );
}

impl Moving for MeshState {
    fn place(&self, _piece: usize, slot: usize) -> Vec3 {
        Vec3::from_slice(&self.scratch.particles[slot * WIDTH..])
    }

    fn start(&self, _piece: usize, slot: usize, h: f32) -> Vec3 {
        began(&self.scratch.predicted, &self.velocities, (slot, h))
    }

    fn put(&mut self, _piece: usize, slot: usize, position: Vec3, quiet: Vec3) {
        position.write_to_slice(&mut self.scratch.particles[slot * WIDTH..]);
        shift(&mut self.scratch.predicted, slot, quiet);
    }
}

/// Where a slot began a substep of `h` [s] in which it flew to where it was predicted.
pub(crate) fn began(predicted: &[Points], velocities: &[Points], (slot, h): (usize, f32)) -> Vec3 {
    let (vector, lane) = (slot / LANES, slot % LANES);
    predicted[vector].get(lane) - velocities[vector].get(lane) * h
}

/// Moves a slot [m].
pub(crate) fn shift(points: &mut [Points], slot: usize, change: Vec3) {
    let points = &mut points[slot / LANES];
    points.set(slot % LANES, points.get(slot % LANES) + change);
}
