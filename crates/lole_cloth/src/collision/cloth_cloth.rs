//! Contact of the cloth with itself.
//!
//! Every particle carries a sphere drawn out along its column to half-way to the next row: in a
//! gathered skirt rows lie farther apart than columns, and spheres alone would let one fold slip
//! between two rows of another. Candidates are found once a step, and solved in a fixed order.

use glam::Vec3;
use rayon::prelude::*;

use crate::collision::grid::{CellGrid, Entry};
use crate::lanes::{Layout, Points, Scalars};
use crate::{Grid, Topology};

/// How far beyond touching candidates are kept [diameters]: folds move together, so what one
/// gains on another in a step is far less than its speed.
const MARGIN: f32 = 1.0;

/// Columns and rows within which particles are held apart by their springs alone.
const NEIGHBOR_COLUMNS: u32 = 1;
const NEIGHBOR_ROWS: u32 = 2;

/// Share of a correction that becomes velocity. The rest moves the cloth without a push, so that
/// overlapping folds part and do not bounce.
const BOUNCE: f32 = 0.5;

/// Entries of one parallel task; fixed, so that the order of pairs never depends on threads.
const TASK_LENGTH: usize = 1024;

/// Below this squared length [m²] two particles have no direction between them.
const DEGENERATE_SQUARED: f32 = 1.0e-14;

/// A particle as the pair loop wants it: near its neighbors in memory.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Particle {
    position: Vec3,
    inv_mass: f32,
}

/// Candidates of one step and room to solve them.
#[derive(Debug, Clone, Default)]
pub(crate) struct ClothContacts {
    grid: CellGrid,
    positions: Vec<Vec3>,
    /// Pairs of row-major indices, task by task.
    pairs: Vec<Vec<[u32; 2]>>,
    particles: Vec<Particle>,
}

/// Distances of one contact law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ClothContactLaw {
    /// Kept between particles and threads [m].
    pub(crate) diameter: f32,
    /// Farthest a pair is moved apart in one solution [m].
    pub(crate) depenetration: f32,
}

impl ClothContactLaw {
    /// Spheres of `radius` that never reach farther than the cloth's own columns.
    pub(crate) fn new(grid: &Grid, radius: f32, depenetration: f32) -> Self {
        let diameter = (2.0 * radius).min(grid.spacing[0]);
        Self {
            diameter,
            depenetration,
        }
    }

    /// Half of the part of a column that a particle stands for [m].
    fn half_thread(&self, grid: &Grid) -> f32 {
        (0.5 * grid.spacing[1]).max(self.diameter) - 0.5 * self.diameter
    }
}

impl ClothContacts {
    /// Finds the candidates of a step. Where the cloth has blown up there are none.
    pub(crate) fn find(
        &mut self,
        grid: &Grid,
        layout: &Layout,
        positions: &[Points],
        law: ClothContactLaw,
    ) {
        self.pairs
            .resize_with(grid.particle_count().div_ceil(TASK_LENGTH), Vec::new);
        layout.gather_points(positions, &mut self.positions);
        if !self.positions.iter().all(|position| position.is_finite()) {
            self.pairs.iter_mut().for_each(Vec::clear);
            return;
        }
        let along = law.half_thread(grid);
        let across = law.diameter * (1.0 + MARGIN);
        let reach = (along * along + across * across).sqrt();
        self.grid.sort(&self.positions, reach);
        let cells = &self.grid;
        let find_task = |(task, pairs): (usize, &mut Vec<[u32; 2]>)| {
            pairs.clear();
            let start = task * TASK_LENGTH;
            for index in start..(start + TASK_LENGTH).min(cells.entries.len()) {
                let first = cells.entries[index];
                cells.following_runs(index, |run| {
                    collect_near(grid, &first, run, reach * reach, pairs);
                });
            }
        };
        if rayon::current_num_threads() == 1 {
            self.pairs.iter_mut().enumerate().for_each(find_task);
        } else {
            self.pairs.par_iter_mut().enumerate().for_each(find_task);
        }
    }

    /// Moves apart what is nearer than the law allows, and `predicted` with it but for the share
    /// that becomes velocity.
    pub(crate) fn solve(
        &mut self,
        grid: &Grid,
        layout: &Layout,
        (positions, predicted, inv_masses): (&mut [Points], &mut [Points], &[Scalars]),
        law: ClothContactLaw,
    ) {
        self.load(layout, positions, inv_masses);
        let columns = grid.column_count as usize;
        let half_thread = law.half_thread(grid);
        for &[first, second] in self.pairs.iter().flatten() {
            let (first, second) = (first as usize, second as usize);
            solve_pair(
                &mut self.particles,
                [first, second],
                columns,
                half_thread,
                law,
            );
        }
        self.store(layout, positions, predicted);
    }

    fn load(&mut self, layout: &Layout, positions: &[Points], inv_masses: &[Scalars]) {
        layout.gather_points(positions, &mut self.positions);
        self.particles.clear();
        self.particles.extend(
            self.positions
                .iter()
                .enumerate()
                .map(|(particle, &position)| {
                    let (vector, lane) = layout.slot(particle);
                    Particle {
                        position,
                        inv_mass: inv_masses[vector].0[lane],
                    }
                }),
        );
    }

    fn store(&self, layout: &Layout, positions: &mut [Points], predicted: &mut [Points]) {
        let moved = self.particles.iter().zip(&self.positions).enumerate();
        for (index, (particle, &before)) in moved {
            if particle.position == before {
                continue;
            }
            let (vector, lane) = layout.slot(index);
            positions[vector].set(lane, particle.position);
            let quiet = (particle.position - before) * (1.0 - BOUNCE);
            let start = predicted[vector].get(lane);
            predicted[vector].set(lane, start + quiet);
        }
    }
}

#[inline(always)]
fn collect_near(
    grid: &Grid,
    first: &Entry,
    run: &[Entry],
    reach_squared: f32,
    pairs: &mut Vec<[u32; 2]>,
) {
    for second in run {
        if (second.position - first.position).length_squared() < reach_squared
            && !are_neighbors(grid, first.particle, second.particle)
        {
            pairs.push([first.particle, second.particle]);
        }
    }
}

fn are_neighbors(grid: &Grid, first: u32, second: u32) -> bool {
    let columns = grid.column_count;
    let down = (first / columns).abs_diff(second / columns);
    let across = (first % columns).abs_diff(second % columns);
    let across = match grid.topology {
        Topology::Sheet => across,
        Topology::Tube => across.min(columns - across),
    };
    across <= NEIGHBOR_COLUMNS && down <= NEIGHBOR_ROWS
}

#[inline(always)]
fn solve_pair(
    particles: &mut [Particle],
    [first, second]: [usize; 2],
    columns: usize,
    half_thread: f32,
    law: ClothContactLaw,
) {
    let (one, other) = (particles[first], particles[second]);
    let offset = other.position - one.position;
    let reach_squared = law.diameter * law.diameter + half_thread * half_thread;
    let inv_mass_sum = one.inv_mass + other.inv_mass;
    if reach_squared < offset.length_squared() || inv_mass_sum <= 0.0 {
        return;
    }
    let above = second.checked_sub(columns).unwrap_or(second);
    let below = if second + columns < particles.len() {
        second + columns
    } else {
        second
    };
    let thread = particles[below].position - particles[above].position;
    let thread_squared = thread.length_squared();
    let along = if thread_squared < DEGENERATE_SQUARED {
        0.0
    } else {
        offset.dot(thread)
    };
    // The foot on the thread: as far along it as the particle stands for.
    let limit = half_thread * thread_squared.sqrt();
    let foot = along.clamp(-limit, limit) / thread_squared.max(DEGENERATE_SQUARED);
    let gap = offset - thread * foot;
    let squared = gap.length_squared();
    if law.diameter * law.diameter <= squared || squared < DEGENERATE_SQUARED {
        return;
    }
    let distance = squared.sqrt();
    let depth = (law.diameter - distance).min(law.depenetration);
    let change = gap * (depth / (distance * inv_mass_sum));
    particles[first].position -= change * one.inv_mass;
    particles[second].position += change * other.inv_mass;
}
