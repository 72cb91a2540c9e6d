//! Contact of a piece with the body, by the laws of the grid: capsules, and the skin itself.

use fearless_simd::{dispatch, f32x16, prelude::*};

use crate::collision::capsule::MovingCapsule;
use crate::collision::capsule::near::{CapsuleSweep, Range, Rows};
use crate::collision::response::ContactRow;
use crate::collision::surfel::{Cloth, Encounter, Skin, SurfelContacts};
use crate::lanes::{LANES, Vectors};
use crate::mesh::order::PATCH_VECTORS;
use crate::mesh::particles::{self, WIDTH};
use crate::mesh::state::MeshState;
use crate::mesh::step::{MeshStep, SubstepNow};
use crate::method::fineness::Substeps;
use crate::step::Progress;

/// Far capsules are tested in every so manyth substep, and in the last of a step.
const FAR_INTERVAL: u32 = 4;

/// Which capsules each patch may touch in this step, and how often the nearest surfels are looked
/// for.
pub(crate) fn find(step: MeshStep<'_>, state: &mut MeshState) {
    let config = step.config;
    let rows = Rows {
        positions: &state.positions,
        velocities: &state.velocities,
        width: PATCH_VECTORS,
    };
    let sweep = CapsuleSweep {
        before: &state.capsules,
        after: step.input.capsules,
        contact_offset: config.contact_offset,
        speed_gain: step.speed_gain(),
        dt: step.dt,
    };
    let level = config.instruction_set.level();
    let contacts = &mut state.scratch.contacts;
    dispatch!(level, simd => contacts.find(simd, rows, sweep));
    let substep_count = state.fineness.substep_count(Substeps::of(config));
    with_skin(step, state, |contacts, encounter| {
        contacts.plan(encounter, substep_count);
    });
}

/// Brings the body to where it is at the end of a substep.
pub(crate) fn begin_substep(now: SubstepNow<'_>, state: &mut MeshState) {
    let (index, count) = (now.index, now.substep.count);
    move_capsules(now.step, Progress::after(index + 1, count), state);
    let level = now.step.config.instruction_set.level();
    with_skin(now.step, state, |contacts, encounter| {
        contacts.begin_substep(level, (index, count), encounter);
    });
}

/// Moves the capsules to where they are when the step has come so far.
fn move_capsules(step: MeshStep<'_>, progress: Progress, state: &mut MeshState) {
    let pairs = state.capsules.iter().zip(step.input.capsules);
    let moving = pairs.map(|(before, after)| {
        MovingCapsule::new([before, after], progress, step.config.contact_offset)
    });
    state.scratch.moving_capsules.clear();
    state.scratch.moving_capsules.extend(moving);
}

/// Calls with the contacts with the skin, and with piece and skin at the start of the step.
fn with_skin(
    step: MeshStep<'_>,
    state: &mut MeshState,
    act: impl FnOnce(&mut SurfelContacts, Encounter<'_>),
) {
    let scratch = &mut state.scratch;
    let cloth = Cloth {
        layout: &step.model.slots,
        positions: &state.positions,
        velocities: &state.velocities,
        held: &scratch.held,
        // Neighbors in memory are not always neighbors on the cloth: every particle is looked up.
        spacing: f32::INFINITY,
        speed_gain: step.speed_gain(),
        dt: step.dt,
        held_back: &scratch.crossing_repair.held_back,
        torn: scratch.crossing_repair.torn(),
        hanging: step.model,
    };
    let skin = Skin {
        before: &state.surfels,
        after: step.input.surfels,
        offset: step.config.contact_offset,
    };
    act(&mut scratch.surfel_contacts, Encounter { cloth, skin });
}

/// Contact with the body; then what the projections changed becomes velocity.
pub(crate) fn finish(now: SubstepNow<'_>, state: &mut MeshState) {
    let level = now.step.config.instruction_set.level();
    dispatch!(level, simd => finish_with(simd, now, state));
}

#[inline(always)]
fn finish_with<S: Simd>(simd: S, now: SubstepNow<'_>, state: &mut MeshState) {
    let (model, substep, index) = (now.step.model, now.substep, now.index);
    let is_last = index + 1 == substep.count;
    let range = if is_last || (index + 1).is_multiple_of(FAR_INTERVAL) {
        Range::All
    } else {
        Range::Near
    };
    let inv_h = f32x16::splat(simd, 1.0 / substep.h);
    let scratch = &mut state.scratch;
    let skin = &scratch.surfel_contacts;
    let (has_skin, progress) = (!skin.is_empty(), skin.progress(index));
    for first in (0..model.vector_count()).step_by(PATCH_VECTORS) {
        let patch = first..first + PATCH_VECTORS;
        for vector in patch.clone() {
            if let Some(sixteen) = scratch.particles[vector * LANES * WIDTH..].first_chunk() {
                let place = particles::load(simd, sixteen).place;
                place.store(&mut state.positions[vector]);
            }
        }
        let indices = scratch.contacts.row(first / PATCH_VECTORS, range);
        if has_skin || !indices.is_empty() {
            let mut row = ContactRow {
                first,
                positions: &mut state.positions[patch.clone()],
                predicted: &mut scratch.predicted[patch.clone()],
                velocities: &state.velocities[patch.clone()],
                inv_masses: &model.inv_masses[patch.clone()],
                h: substep.h,
                held: 0.0,
                law: substep.contact,
            };
            row.project(simd, &scratch.moving_capsules, indices);
            if has_skin {
                row.project_out_of_skin(simd, skin, progress);
            }
        }
        let columns = (state.positions[patch.clone()].iter())
            .zip(&scratch.predicted[patch.clone()])
            .zip(&mut state.velocities[patch]);
        for ((position, predicted), velocity) in columns {
            let change = Vectors::load(simd, position).sub(Vectors::load(simd, predicted));
            let gained = Vectors::load(simd, velocity).add(change.scale(inv_h));
            gained.store(velocity);
        }
    }
}
