//! Methods with one evaluation of the forces a step: (8) and (9).

use glam::DVec3;
use rayon::prelude::*;

use super::forces::{BlockContact, NearbyBodies, World};
use super::{BLOCK, Course, PARALLEL_FROM};
use crate::method::reference::ReferenceState;

/// Position and velocity after `dt` from position, velocity, acceleration and `dt`.
type Scheme = fn(DVec3, DVec3, DVec3, f64) -> (DVec3, DVec3);

/// All substeps of a step by `scheme`.
pub(super) fn run(course: &Course<'_>, scheme: Scheme, state: &mut ReferenceState) {
    let mut next_positions = state.positions.clone();
    for substep in 0..course.substep_count {
        let world = course.world_at(f64::from(substep));
        advance(&world, scheme, state, &mut next_positions);
        course.place_pins(f64::from(substep + 1), &mut state.positions);
        course.carry_pins(&mut state.velocities);
    }
}

/// One substep for every free particle. `next_positions` is room for the new positions; the old
/// ones stay readable until all are known.
fn advance(
    world: &World<'_>,
    scheme: Scheme,
    state: &mut ReferenceState,
    next_positions: &mut Vec<DVec3>,
) {
    let positions = &state.positions;
    let run = |(block, (nexts, velocities)): (usize, (&mut [DVec3], &mut [DVec3]))| {
        advance_block(world, scheme, positions, block * BLOCK, (nexts, velocities));
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

/// One substep of the particles from `first` on: next positions and velocities.
fn advance_block(
    world: &World<'_>,
    scheme: Scheme,
    positions: &[DVec3],
    first: usize,
    (next_positions, velocities): (&mut [DVec3], &mut [DVec3]),
) {
    let nearby = NearbyBodies::new(world, &positions[first..first + next_positions.len()]);
    let contact = BlockContact::Near(&nearby);
    for (index, (next, velocity)) in (first..).zip(next_positions.iter_mut().zip(velocities)) {
        if !world.model.pinned()[index] {
            let acceleration = world.acceleration(index, positions, *velocity, contact);
            (*next, *velocity) = scheme(positions[index], *velocity, acceleration, world.dt);
        }
    }
}
