//! An order of the particles of any surface in which neighbors stand near each other: strips of
//! particles about as far from one end, each of them cut into patches that hang together.

use std::collections::VecDeque;

use crate::lanes::{LANES, narrow};
use crate::mesh::order::PATCH_VECTORS;
use crate::mesh::particles::{BASE_STEP, WINDOW_SLOTS};

/// Neighbors that a strip may be wide, the best first: as patches are, or less where strips are so long
/// that the particles of a constraint would stand too far apart.
const STRIP_WIDTHS: [u32; 4] = [8, 4, 2, 1];

/// Particles of a patch.
const PATCH: usize = LANES * PATCH_VECTORS;

/// Stands for what was not reached.
const FAR: u32 = u32::MAX;

/// All particles, part after part; `neighbors` are by particle.
pub(crate) fn patch_by_patch(neighbors: &[Vec<u32>]) -> Vec<u32> {
    let mut steps = vec![FAR; neighbors.len()];
    let mut order = Vec::with_capacity(neighbors.len());
    for particle in 0..neighbors.len() {
        if steps[particle] != FAR {
            continue;
        }
        // The farthest from anywhere is an end.
        let part = walk(neighbors, narrow(particle), &mut steps);
        let end = part.last().copied().unwrap_or_default();
        for &particle in &part {
            steps[particle as usize] = FAR;
        }
        let part = walk(neighbors, end, &mut steps);
        add_strips(neighbors, &steps, &part, &mut order);
    }
    order
}

/// Visits what hangs together with a particle, the nearest first, and writes how many neighbors away
/// each is.
fn walk(neighbors: &[Vec<u32>], from: u32, steps: &mut [u32]) -> Vec<u32> {
    steps[from as usize] = 0;
    let mut part = vec![from];
    let mut next = 0;
    while next < part.len() {
        let here = part[next] as usize;
        for &neighbor in &neighbors[here] {
            if steps[neighbor as usize] == FAR {
                steps[neighbor as usize] = steps[here] + 1;
                part.push(neighbor);
            }
        }
        next += 1;
    }
    part
}

/// Adds a part strip by strip; it comes by steps.
fn add_strips(neighbors: &[Vec<u32>], steps: &[u32], part: &[u32], order: &mut Vec<u32>) {
    let strips = |width: u32| {
        part.chunk_by(move |&a, &b| steps[a as usize] / width == steps[b as usize] / width)
    };
    let longest = |width: u32| {
        let lengths: Vec<usize> = strips(width).map(<[u32]>::len).collect();
        let pairs = lengths.windows(2).map(|pair| pair.iter().sum());
        pairs.max().unwrap_or(0)
    };
    let fits = |&&width: &&u32| longest(width) < WINDOW_SLOTS - BASE_STEP;
    let width = STRIP_WIDTHS.iter().find(fits).copied().unwrap_or(1);
    let mut is_left = vec![false; neighbors.len()];
    for strip in strips(width) {
        for &particle in strip {
            is_left[particle as usize] = true;
        }
        let mut seed = None;
        let mut first = 0;
        while let Some(start) = seed.or_else(|| left_in(strip, &is_left, &mut first)) {
            seed = grow(neighbors, start, &mut is_left, order);
        }
    }
}

/// The first particle of a strip that is left, from `first` on.
fn left_in(strip: &[u32], is_left: &[bool], first: &mut usize) -> Option<u32> {
    while *first < strip.len() && !is_left[strip[*first] as usize] {
        *first += 1;
    }
    strip.get(*first).copied()
}

/// Adds a patch around a particle, and says where the next may grow.
fn grow(
    neighbors: &[Vec<u32>],
    start: u32,
    is_left: &mut [bool],
    order: &mut Vec<u32>,
) -> Option<u32> {
    let mut queue = VecDeque::from([start]);
    is_left[start as usize] = false;
    let mut count = 0;
    while let Some(here) = queue.pop_front() {
        order.push(here);
        count += 1;
        for &neighbor in &neighbors[here as usize] {
            if count + queue.len() < PATCH && is_left[neighbor as usize] {
                is_left[neighbor as usize] = false;
                queue.push_back(neighbor);
            }
        }
    }
    let patch = order[order.len() - count..].iter();
    let mut beside = patch.flat_map(|&particle| &neighbors[particle as usize]);
    beside
        .find(|&&neighbor| is_left[neighbor as usize])
        .copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tube of so many particles around and along.
    fn tube(around: u32, along: u32) -> Vec<Vec<u32>> {
        let at = |row: u32, column: u32| row * around + column % around;
        (0..around * along)
            .map(|particle| {
                let (row, column) = (particle / around, particle % around);
                let mut ring = vec![at(row, column + 1), at(row, column + around - 1)];
                if 0 < row {
                    ring.push(at(row - 1, column));
                }
                if row + 1 < along {
                    ring.push(at(row + 1, column));
                }
                ring
            })
            .collect()
    }

    #[test]
    fn every_particle_comes_once_and_neighbors_stand_within_two_strips() {
        for (around, along) in [(300, 80), (80, 300), (1500, 30)] {
            let mut neighbors = tube(around, along);
            // And a part of its own.
            let first = narrow(neighbors.len());
            neighbors.extend([vec![first + 1], vec![first]]);
            let order = patch_by_patch(&neighbors);
            let mut places = vec![usize::MAX; neighbors.len()];
            for (place, &particle) in order.iter().enumerate() {
                assert_eq!(places[particle as usize], usize::MAX);
                places[particle as usize] = place;
            }
            assert_eq!(order.len(), neighbors.len());
            let gaps = (0..neighbors.len()).flat_map(|particle| {
                let places = &places;
                (neighbors[particle].iter())
                    .map(move |&it| places[particle].abs_diff(places[it as usize]))
            });
            let widest = gaps.max().expect("some");
            assert!(widest < WINDOW_SLOTS - BASE_STEP, "{around}: {widest}");
        }
    }
}
