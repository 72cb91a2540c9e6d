//! The edge lists of the paper's springs, and the gather that sums them particle by particle.

use glam::{DVec2, DVec3};

use super::SpringConstants;
use crate::method::paper;
use crate::{Fabric, Grid};

/// The families of the paper's figure 5; the two diagonals share one constant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpringFamily {
    /// Neighbors along a row.
    StructuralU,
    /// Neighbors down a column.
    StructuralV,
    /// Diagonal from the upper left to the lower right.
    ShearFalling,
    /// Diagonal from the upper right to the lower left.
    ShearRising,
    /// Every other particle along a row.
    SkipU,
    /// Every other particle down a column.
    SkipV,
}

/// All springs of one family in columns of one width: equal rest lengths, equal stiffness.
#[derive(Debug, Clone, PartialEq)]
pub struct Springs {
    /// The family that they are.
    pub family: SpringFamily,
    /// Particles at both ends, shape `[spring_count]`.
    pub ends: Vec<[u32; 2]>,
    /// Rest length `L` [m].
    pub rest_length: f64,
    /// Stiffness `k` [N/m].
    pub stiffness: f64,
    /// Unit vector of the spring in the flat cloth, `(u, v)`.
    pub direction: DVec2,
}

/// Edge lists of every family whose constant is above zero; where cloth is crimped, one for each width that
/// its columns have there.
pub(super) fn build(grid: &Grid, constants: &SpringConstants, fabric: &Fabric) -> Vec<Springs> {
    type Constant = fn(&SpringConstants) -> f64;
    let families: [(SpringFamily, Constant, [i32; 2]); 6] = [
        (SpringFamily::StructuralU, |it| it.structural_u, [1, 0]),
        (SpringFamily::StructuralV, |it| it.structural_v, [0, 1]),
        (SpringFamily::ShearFalling, |it| it.shear, [1, 1]),
        (SpringFamily::ShearRising, |it| it.shear, [-1, 1]),
        (SpringFamily::SkipU, |it| it.skip_u, [2, 0]),
        (SpringFamily::SkipV, |it| it.skip_v, [0, 2]),
    ];
    let mut springs = Vec::new();
    for (family, constant, steps) in families {
        if constant(constants) <= 0.0 {
            continue;
        }
        let below = steps[1].unsigned_abs();
        let rows: Vec<u32> = (0..grid.row_count.saturating_sub(below)).collect();
        let width =
            |row: u32| 0.5 * f64::from(grid.row_spacing(row) + grid.row_spacing(row + below));
        for alike in rows.chunk_by(|&one, &next| width(one).total_cmp(&width(next)).is_eq()) {
            let width = width(alike[0]);
            let flat = DVec2::new(
                f64::from(steps[0]) * width,
                f64::from(steps[1]) * f64::from(grid.spacing[1]),
            );
            springs.push(Springs {
                family,
                ends: edges(grid, alike, steps),
                rest_length: flat.length(),
                stiffness: constant(&constants.at_width((grid, fabric), width)),
                direction: flat.normalize_or_zero(),
            });
        }
    }
    springs
}

/// All pairs that lie `steps` columns and rows apart, the upper in one of `rows`. A negative column step is
/// written from its left end, so that one rule for the seam serves both diagonals.
fn edges(grid: &Grid, of_rows: &[u32], steps: [i32; 2]) -> Vec<[u32; 2]> {
    let [columns, rows] = steps.map(i32::unsigned_abs);
    let mut ends = Vec::with_capacity(of_rows.len() * grid.column_count as usize);
    for &row in of_rows {
        for column in 0..grid.column_count {
            let Some(right) = grid.column_right(column, columns) else {
                continue;
            };
            let (upper, lower) = if steps[0] < 0 {
                (right, column)
            } else {
                (column, right)
            };
            ends.push([
                particle(grid, row, upper),
                particle(grid, row + rows, lower),
            ]);
        }
    }
    ends
}

/// [`Grid::index`] as the `u32` that columns of indices hold.
pub(super) fn particle(grid: &Grid, row: u32, column: u32) -> u32 {
    row * grid.column_count + column
}

/// Where each of `rows` starts when they are written one after another, and where the last ends.
pub(super) fn row_starts<T>(rows: &[Vec<T>]) -> Vec<u32> {
    let mut starts = vec![0];
    let mut end = 0;
    for row in rows {
        end += row.iter().fold(0, |count, _| count + 1);
        starts.push(end);
    }
    starts
}

/// One end of a spring as its other end sees it.
#[derive(Debug, Clone, Copy)]
struct Neighbor {
    index: u32,
    kind: u32,
}

/// Stiffness and rest length of one family.
#[derive(Debug, Clone, Copy)]
struct Kind {
    rest_length: f64,
    stiffness: f64,
}

/// One spring as one of its ends sees it.
#[derive(Debug, Clone, Copy)]
pub(super) struct SpringEnd {
    /// The particle at the other end.
    pub(super) other: usize,
    /// `L` [m].
    pub(super) rest_length: f64,
    /// `k` [N/m].
    pub(super) stiffness: f64,
}

/// The springs of every particle, side by side, in the order of the edge lists.
#[derive(Debug, Clone)]
pub(super) struct SpringGather {
    kinds: Vec<Kind>,
    starts: Vec<u32>,
    neighbors: Vec<Neighbor>,
}

impl SpringGather {
    /// Turns edge lists into one list per particle.
    pub(super) fn new(particle_count: usize, springs: &[Springs]) -> Self {
        let mut lists: Vec<Vec<Neighbor>> = vec![Vec::new(); particle_count];
        for (kind, family) in (0u32..).zip(springs) {
            for &[a, b] in &family.ends {
                lists[a as usize].push(Neighbor { index: b, kind });
                lists[b as usize].push(Neighbor { index: a, kind });
            }
        }
        let starts = row_starts(&lists);
        let kinds = springs
            .iter()
            .map(|family| Kind {
                rest_length: family.rest_length,
                stiffness: family.stiffness,
            })
            .collect();
        Self {
            kinds,
            starts,
            neighbors: lists.concat(),
        }
    }

    /// The springs of particle `index`.
    pub(super) fn springs_of(&self, index: usize) -> impl Iterator<Item = SpringEnd> {
        let range = self.starts[index] as usize..self.starts[index + 1] as usize;
        self.neighbors[range].iter().map(|neighbor| {
            let kind = self.kinds[neighbor.kind as usize];
            SpringEnd {
                other: neighbor.index as usize,
                rest_length: kind.rest_length,
                stiffness: kind.stiffness,
            }
        })
    }

    /// Equation (1) summed over the springs of particle `index` [N].
    #[inline]
    pub(super) fn force(&self, index: usize, positions: &[DVec3]) -> DVec3 {
        let range = self.starts[index] as usize..self.starts[index + 1] as usize;
        let position = positions[index];
        let mut force = DVec3::ZERO;
        for neighbor in &self.neighbors[range] {
            let kind = self.kinds[neighbor.kind as usize];
            force += paper::spring_force(
                position,
                positions[neighbor.index as usize],
                kind.rest_length,
                kind.stiffness,
            );
        }
        force
    }
}
