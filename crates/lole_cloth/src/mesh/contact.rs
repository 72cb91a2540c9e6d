//! Contact of a piece with the body, by the laws of the grid: capsules, and the skin itself.

use fearless_simd::{dispatch, f32x16, prelude::*};

use crate::collision::capsule::MovingCapsule;
use crate::collision::capsule::near::Range;
use crate::collision::response::ContactRow;
use crate::collision::surfel::{Cloth, Skin, SurfelContacts};
use crate::lanes::{LANES, Vectors};
use crate::mesh::model::MeshModel;
use crate::mesh::order::PATCH_VECTORS;
use crate::mesh::particles::{self, WIDTH};
use crate::mesh::state::MeshState;
use crate::mesh::step::Substep;
use crate::method::fineness::Substeps;
use crate::{SolverConfig, StepInput};

/// Far capsules are tested in every so manyth substep, and in the last of a step.
const FAR_INTERVAL: u32 = 4;

/// Which capsules each patch may touch in this step, and how often the nearest surfels are looked
/// for.
pub(crate) fn find(
    (model, config): (&MeshModel, &SolverConfig),
    (input, dt): (&StepInput<'_>, f32),
    state: &mut MeshState,
) {
    let level = config.instruction_set.level();
    let rows = (&state.positions[..], &state.velocities[..], PATCH_VECTORS);
    let contacts = &mut state.scratch.contacts;
    dispatch!(level, simd => contacts.find(
        simd,
        rows,
        [&state.capsules, input.capsules],
        (config.contact_offset, config.gravity.length() * dt, dt),
    ));
    let substep_count = state.fineness.substep_count(Substeps::of(config));
    with_skin(
        (model, config),
        (input, dt),
        state,
        |contacts, cloth, skin| {
            contacts.plan(cloth, skin, substep_count);
        },
    );
}

/// Where the body is in a substep.
pub(crate) fn begin_substep(
    (model, config, input): (&MeshModel, &SolverConfig, &StepInput<'_>),
    (substep, index): (&Substep, u32),
    state: &mut MeshState,
) {
    move_capsules(config, input, (index, substep.count), state);
    let (substeps, dt) = ((index, substep.count), substep.dt);
    let level = config.instruction_set.level();
    with_skin(
        (model, config),
        (input, dt),
        state,
        |contacts, cloth, skin| {
            contacts.begin_substep(level, substeps, cloth, skin);
        },
    );
}

fn move_capsules(
    config: &SolverConfig,
    input: &StepInput<'_>,
    (index, count): (u32, u32),
    state: &mut MeshState,
) {
    #[expect(clippy::cast_precision_loss, reason = "substeps are few")]
    let (fraction, share) = ((index + 1) as f32 / count as f32, 1.0 / count as f32);
    let pairs = state.capsules.iter().zip(input.capsules);
    let moving = pairs.map(|(before, after)| {
        MovingCapsule::new([before, after], fraction, share, config.contact_offset)
    });
    state.scratch.moving_capsules.clear();
    state.scratch.moving_capsules.extend(moving);
}

fn with_skin(
    (model, config): (&MeshModel, &SolverConfig),
    (input, dt): (&StepInput<'_>, f32),
    state: &mut MeshState,
    act: impl FnOnce(&mut SurfelContacts, Cloth<'_>, Skin<'_>),
) {
    let scratch = &mut state.scratch;
    let cloth = Cloth {
        layout: &model.slots,
        positions: &state.positions,
        velocities: &state.velocities,
        held: &scratch.held,
        // Neighbors in memory are not always neighbors on the cloth: every particle is looked up.
        spacing: f32::INFINITY,
        speed_gain: config.gravity.length() * dt,
        dt,
        held_back: &scratch.crossing_repair.held_back,
        torn: scratch.crossing_repair.torn(),
        hanging: model,
    };
    let skin = Skin {
        before: &state.surfels,
        after: input.surfels,
        offset: config.contact_offset,
    };
    act(&mut scratch.surfel_contacts, cloth, skin);
}

/// Contact with the body; then what the projections changed becomes velocity.
pub(crate) fn finish(
    (model, config): (&MeshModel, &SolverConfig),
    (substep, index): (&Substep, u32),
    state: &mut MeshState,
) {
    let level = config.instruction_set.level();
    dispatch!(level, simd => finish_with(simd, model, (substep, index), state));
}

#[inline(always)]
fn finish_with<S: Simd>(
    simd: S,
    model: &MeshModel,
    (substep, index): (&Substep, u32),
    state: &mut MeshState,
) {
    let is_last = index + 1 == substep.count;
    let range = if is_last || (index + 1).is_multiple_of(FAR_INTERVAL) {
        Range::All
    } else {
        Range::Near
    };
    let inv_h = f32x16::splat(simd, 1.0 / substep.h);
    let scratch = &mut state.scratch;
    let skin = &scratch.surfel_contacts;
    let (has_skin, passed) = (!skin.is_empty(), skin.passed(index));
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
                positions: &mut state.positions[patch.clone()],
                predicted: &mut scratch.predicted[patch.clone()],
                velocities: &state.velocities[patch.clone()],
                inv_masses: &model.inv_masses[patch.clone()],
                h: substep.h,
                held: 0.0,
            };
            row.project(simd, &scratch.moving_capsules, indices, substep.contact);
            if has_skin {
                row.project_out_of_skin(simd, (skin, first), passed, substep.contact);
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
