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
        let block = Block {
            first: block * BLOCK,
            nexts,
            velocities,
        };
        block.advance(world, scheme, positions);
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

/// Particles that follow each other.
struct Block<'a> {
    /// Number of the first among all.
    first: usize,
    /// Where they will be after the substep [m].
    nexts: &'a mut [DVec3],
    velocities: &'a mut [DVec3],
}

impl Block<'_> {
    /// One substep; `positions` are those of all particles before it.
    fn advance(self, world: &World<'_>, scheme: Scheme, positions: &[DVec3]) {
        let first = self.first;
        let nearby = NearbyBodies::new(world, &positions[first..first + self.nexts.len()]);
        let contact = BlockContact::Near(&nearby);
        let moving = self.nexts.iter_mut().zip(self.velocities);
        for (index, (next, velocity)) in (first..).zip(moving) {
            if !world.model.pinned()[index] {
                let acceleration = world.acceleration(index, positions, *velocity, contact);
                (*next, *velocity) = scheme(positions[index], *velocity, acceleration, world.dt);
            }
        }
    }
}
