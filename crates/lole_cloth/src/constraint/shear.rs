//! The cell: both shear springs across it and the twist term of the plate energy.

use fearless_simd::{Simd, f32x16, prelude::*};

use crate::constraint::{Rows, add_to_partner, load_partner};
use crate::lanes::{RowLink, Vectors};

/// Compliances of one cell over the substep squared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cell {
    /// Rest length of both diagonals [m].
    pub(crate) diagonal: f32,
    /// Of a shear spring [1/kg].
    pub(crate) shear_compliance: f32,
    /// Of the twist constraint `x₁₁ - x₁₀ - x₀₁ + x₀₀ = 0` [1/kg].
    pub(crate) twist_compliance: f32,
}

/// Below this length [m] a spring has no direction; a thread is 1e-4 m thick.
const DEGENERATE_LENGTH: f32 = 1.0e-7;

/// Solves every cell, from the top row of cells to the bottom.
#[inline(always)]
pub(crate) fn solve<S: Simd>(simd: S, rows: &mut Rows<'_>, links: &[RowLink<2>], cell: Cell) {
    rows.each_row_pair(
        1,
        #[inline(always)]
        |[upper, lower], [inv_upper, inv_lower]| {
            for link in links {
                let corners = [
                    load_partner(simd, link, 0, upper, inv_upper),
                    load_partner(simd, link, 1, upper, inv_upper),
                    load_partner(simd, link, 0, lower, inv_lower),
                    load_partner(simd, link, 1, lower, inv_lower),
                ];
                let mask = match &link.mask {
                    Some(mask) => f32x16::load_array_ref(simd, &mask.0),
                    None => f32x16::splat(simd, 1.0),
                };
                let inv_masses = corners.map(
                    #[inline(always)]
                    |(_, inv_mass)| inv_mass * mask,
                );
                let mut points = corners.map(
                    #[inline(always)]
                    |(point, _)| point,
                );
                solve_twist(simd, &mut points, &inv_masses, cell);
                solve_diagonal(simd, &mut points, &inv_masses, ([0, 3], cell));
                solve_diagonal(simd, &mut points, &inv_masses, ([1, 2], cell));
                let [left, right] = link.groups.map(usize::from);
                if left == right {
                    // A narrow cloth: both corners of a row live in one vector, so only changes add up.
                    let changes = [0, 1, 2, 3].map(
                        #[inline(always)]
                        |i| points[i].sub(corners[i].0),
                    );
                    add_to_partner(link, 0, changes[0], upper);
                    add_to_partner(link, 1, changes[1], upper);
                    add_to_partner(link, 0, changes[2], lower);
                    add_to_partner(link, 1, changes[3], lower);
                    continue;
                }
                points[0].store(&mut upper[left]);
                points[2].store(&mut lower[left]);
                points[1]
                    .rotate_right(link.shifts[1])
                    .store(&mut upper[right]);
                points[3]
                    .rotate_right(link.shifts[1])
                    .store(&mut lower[right]);
            }
        },
    );
}

#[inline(always)]
fn solve_twist<S: Simd>(
    simd: S,
    points: &mut [Vectors<S>; 4],
    inv_masses: &[f32x16<S>; 4],
    cell: Cell,
) {
    let twist = points[0].add(points[3]).sub(points[1].add(points[2]));
    let sum = (inv_masses[0] + inv_masses[1]) + (inv_masses[2] + inv_masses[3]);
    let change = twist.scale(f32x16::splat(simd, 1.0) / (sum + cell.twist_compliance));
    points[0] = points[0].sub(change.scale(inv_masses[0]));
    points[1] = points[1].add(change.scale(inv_masses[1]));
    points[2] = points[2].add(change.scale(inv_masses[2]));
    points[3] = points[3].sub(change.scale(inv_masses[3]));
}

#[inline(always)]
fn solve_diagonal<S: Simd>(
    simd: S,
    points: &mut [Vectors<S>; 4],
    inv_masses: &[f32x16<S>; 4],
    (ends, cell): ([usize; 2], Cell),
) {
    let offset = points[ends[1]].sub(points[ends[0]]);
    let length = offset.dot(offset).sqrt() + DEGENERATE_LENGTH;
    let sum = inv_masses[ends[0]] + inv_masses[ends[1]] + cell.shear_compliance;
    let factor = (length - f32x16::splat(simd, cell.diagonal)) / (length * sum);
    points[ends[0]] = points[ends[0]].add(offset.scale(factor * inv_masses[ends[0]]));
    points[ends[1]] = points[ends[1]].sub(offset.scale(factor * inv_masses[ends[1]]));
}
