//! Orthotropic plate bending with a twist term, in place of the paper's bend springs.
//!
//! `E = h_u h_v / 2 Σ [B_u |d_uu x|² + B_v |d_vv x|² + 2 B_t |d_uv x|²]` with second differences of
//! the positions themselves: the curvature of a nearly inextensible sheet, with a constant Hessian.
//!
//! * Each difference is weighted by the area it stands for: a half at the free borders.
//! * At a clamp, a pinned particle with one pinned and one free neighbor in line, the arm between
//!   wall and first free particle is only half a cell, so the curvature is twice the difference on
//!   half the length: the energy, and the hinge stiffness, is doubled. Without this the clamp is
//!   too soft and convergence only first order.
//! * Free ends need nothing: no difference is centered there, which is the natural condition of
//!   zero moment.

use glam::DVec3;

use super::springs::{particle, row_starts};
use super::{SpringConstants, column_share, row_share};
use crate::{ClothSpec, Grid, Topology};

/// One quadratic term `½ weight |Σ coefficient × position|²`; the coefficients add up to zero.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stencil {
    particles: [u32; 4],
    coefficients: [f64; 4],
    weight: f64,
}

impl Stencil {
    /// Energy [J].
    fn energy(&self, positions: &[DVec3]) -> f64 {
        let mut difference = DVec3::ZERO;
        for (&index, &coefficient) in self.particles.iter().zip(&self.coefficients) {
            difference += positions[index as usize] * coefficient;
        }
        0.5 * self.weight * difference.length_squared()
    }
}

/// One entry of the Hessian as a spring of rest length zero towards `index`.
#[derive(Debug, Clone, Copy)]
struct Pull {
    index: u32,
    /// Minus the entry of the Hessian [N/m]; negative where particles push each other apart.
    stiffness: f64,
}

/// The bending of the whole cloth.
#[derive(Debug, Clone)]
pub(super) struct Plate {
    stencils: Vec<Stencil>,
    starts: Vec<u32>,
    pulls: Vec<Pull>,
}

impl Plate {
    /// All differences of the grid, and the Hessian they add up to.
    pub(super) fn new(spec: &ClothSpec, constants: &SpringConstants) -> Self {
        let ClothSpec { grid, pinned, .. } = spec;
        let mut stencils = Vec::new();
        if 0.0 < constants.plate_u {
            stencils.extend(line_stencils(spec, Line::Row, constants.plate_u));
        }
        if 0.0 < constants.plate_v {
            stencils.extend(line_stencils(spec, Line::Column, constants.plate_v));
        }
        if 0.0 < constants.twist {
            stencils.extend(twist_stencils(grid, constants.twist));
        }
        stencils.retain(|stencil| !stencil.particles.iter().all(|&i| pinned[i as usize]));
        let (starts, pulls) = hessian(grid.particle_count(), &stencils);
        Self {
            stencils,
            starts,
            pulls,
        }
    }

    /// Force [N] on the particle `index`, minus the gradient of the energy. Written with
    /// differences so that a moved cloth feels exactly the same.
    #[inline]
    pub(super) fn force(&self, index: usize, positions: &[DVec3]) -> DVec3 {
        let position = positions[index];
        let mut force = DVec3::ZERO;
        for pull in self.pulls_of(index) {
            force += (positions[pull.index as usize] - position) * pull.stiffness;
        }
        force
    }

    /// Energy [J].
    pub(super) fn energy(&self, positions: &[DVec3]) -> f64 {
        self.stencils
            .iter()
            .map(|stencil| stencil.energy(positions))
            .sum()
    }

    /// Gershgorin's bound [N/m] on the plate's share of the stiffness of a free particle: the
    /// absolute row sum over free particles, diagonal included.
    pub(super) fn row_bound(&self, index: usize, pinned: &[bool]) -> f64 {
        let mut diagonal = 0.0;
        let mut off_diagonal = 0.0;
        for pull in self.pulls_of(index) {
            diagonal += pull.stiffness;
            if !pinned[pull.index as usize] {
                off_diagonal += pull.stiffness.abs();
            }
        }
        diagonal + off_diagonal
    }

    fn pulls_of(&self, index: usize) -> &[Pull] {
        &self.pulls[self.starts[index] as usize..self.starts[index + 1] as usize]
    }
}

/// Along which grid line a second difference is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Line {
    Row,
    Column,
}

/// Second differences along rows or columns, with `rigidity` [N·m] of one layer.
fn line_stencils(spec: &ClothSpec, line: Line, rigidity: f64) -> Vec<Stencil> {
    let ClothSpec { grid, pinned, .. } = spec;
    let h_v = f64::from(grid.spacing[1]);
    let mut stencils = Vec::with_capacity(grid.particle_count());
    for row in 0..grid.row_count {
        let h_u = f64::from(grid.row_spacing(row));
        let rigidity = rigidity * f64::from(spec.row_layers[row as usize]);
        for column in 0..grid.column_count {
            let Some([before, after]) = arms(grid, line, row, column) else {
                continue;
            };
            let center = particle(grid, row, column);
            let (length, share) = match line {
                Line::Row => (h_u, row_share(grid, row)),
                Line::Column => (h_v, column_share(grid, column)),
            };
            let clamp = clamp_factor([before, center, after].map(|i| pinned[i as usize]));
            let inv_square = 1.0 / (length * length);
            stencils.push(Stencil {
                particles: [before, center, after, center],
                coefficients: [inv_square, -2.0 * inv_square, inv_square, 0.0],
                weight: rigidity * h_u * h_v * share * clamp,
            });
        }
    }
    stencils
}

/// Neighbors in line before and after a particle; `None` at a free border.
fn arms(grid: &Grid, line: Line, row: u32, column: u32) -> Option<[u32; 2]> {
    match line {
        Line::Row => {
            let left = match grid.topology {
                Topology::Tube => (column + grid.column_count - 1) % grid.column_count,
                Topology::Sheet => column.checked_sub(1)?,
            };
            let right = grid.column_right(column, 1)?;
            Some([left, right].map(|column| particle(grid, row, column)))
        }
        Line::Column => {
            let above = row.checked_sub(1)?;
            let below = (row + 1 < grid.row_count).then_some(row + 1)?;
            Some([above, below].map(|row| particle(grid, row, column)))
        }
    }
}

/// 2 where a pinned particle holds a free arm against a pinned one, else 1.
fn clamp_factor([before, center, after]: [bool; 3]) -> f64 {
    if center && before != after { 2.0 } else { 1.0 }
}

/// The mixed difference of every cell, `d_uv = (x_11 - x_10 - x_01 + x_00) / (h_u h_v)`.
fn twist_stencils(grid: &Grid, twist: f64) -> Vec<Stencil> {
    let mut stencils = Vec::with_capacity(grid.particle_count());
    for row in 0..grid.row_count - 1 {
        let width = 0.5 * f64::from(grid.row_spacing(row) + grid.row_spacing(row + 1));
        let area = width * f64::from(grid.spacing[1]);
        for column in 0..grid.column_count {
            let Some(right) = grid.column_right(column, 1) else {
                continue;
            };
            stencils.push(Stencil {
                particles: [
                    particle(grid, row, column),
                    particle(grid, row, right),
                    particle(grid, row + 1, column),
                    particle(grid, row + 1, right),
                ],
                coefficients: [1.0, -1.0, -1.0, 1.0].map(|sign| sign / area),
                weight: 2.0 * twist * area,
            });
        }
    }
    stencils
}

/// The off-diagonal Hessian of all stencils, row by row: where each row starts, and its entries.
fn hessian(particle_count: usize, stencils: &[Stencil]) -> (Vec<u32>, Vec<Pull>) {
    let mut rows: Vec<Vec<Pull>> = vec![Vec::new(); particle_count];
    for stencil in stencils {
        for a in 0..4 {
            for b in 0..4 {
                let [i, j] = [stencil.particles[a], stencil.particles[b]];
                let product = stencil.coefficients[a] * stencil.coefficients[b];
                if i != j && product != 0.0 {
                    add_pull(&mut rows[i as usize], j, -stencil.weight * product);
                }
            }
        }
    }
    (row_starts(&rows), rows.concat())
}

/// Adds `stiffness` to the entry towards `index`.
fn add_pull(row: &mut Vec<Pull>, index: u32, stiffness: f64) {
    match row.iter_mut().find(|pull| pull.index == index) {
        Some(pull) => pull.stiffness += stiffness,
        None => row.push(Pull { index, stiffness }),
    }
}
