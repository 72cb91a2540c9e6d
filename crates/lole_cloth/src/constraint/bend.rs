//! Bending along rows and down columns: the pure terms of the orthotropic plate energy.
//!
//! `E = h_u h_v / 2 (B_u |d_uu x|² + B_v |d_vv x|² + 2 B_t |d_uv x|²)` with the second differences
//! `d_uu x = (x₋ - 2 x₀ + x₊) / h_u²`. Its Hessian is constant, so each term is a linear
//! constraint `C = x₋ - 2 x₀ + x₊ = 0` that knows no direction: rotations leave it alone, and a
//! flat sheet has none of it. The twist term is solved with the shear springs of its cell.
//!
//! At a clamp, a pinned particle between a pinned and a free one, the arm that bends is half as
//! long and the energy twice as large, as in the reference: without it a clamped strip converges
//! only with the spacing, from 62 % too deep on two cells a bending length.

use fearless_simd::{Simd, f32x16, prelude::*};

use crate::ClothSpec;
use crate::constraint::{Rows, add_to_partner, load_partner};
use crate::lanes::{RowLink, Vectors};

/// Which bending terms have a clamp in them.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Clamps {
    /// By row: whether a term along it has one.
    rows: Vec<bool>,
    /// By upper row of a term down the columns.
    columns: Vec<bool>,
}

impl Clamps {
    pub(crate) fn new(spec: &ClothSpec) -> Self {
        let grid = &spec.grid;
        let pinned = |row: u32, column: u32| spec.pinned[grid.index(row, column)];
        let is_clamp = |ends: [bool; 2], center: bool| center && ends[0] != ends[1];
        let along = |row: u32| {
            (0..grid.column_count).any(|column| {
                let [Some(middle), Some(right)] = [1, 2].map(|by| grid.column_right(column, by))
                else {
                    return false;
                };
                is_clamp(
                    [pinned(row, column), pinned(row, right)],
                    pinned(row, middle),
                )
            })
        };
        let down = |row: u32| {
            (0..grid.column_count).any(|column| {
                let ends = [pinned(row, column), pinned(row + 2, column)];
                is_clamp(ends, pinned(row + 1, column))
            })
        };
        Self {
            rows: (0..grid.row_count).map(along).collect(),
            columns: (0..grid.row_count.saturating_sub(2)).map(down).collect(),
        }
    }
}

/// The compliance of a term with these inverse masses [1/kg]: halved where it has a clamp in it.
#[inline(always)]
fn at_clamp<S: Simd>(
    simd: S,
    [before, center, after]: [f32x16<S>; 3],
    scaled_compliance: f32,
) -> f32x16<S> {
    let zero = f32x16::splat(simd, 0.0);
    let whole = f32x16::splat(simd, scaled_compliance);
    let is_free = |inv_mass: f32x16<S>| zero.simd_lt(inv_mass);
    let is_clamp = (is_free(before) ^ is_free(after)) & !is_free(center);
    is_clamp.select(whole * 0.5, whole)
}

/// Solves bending along rows; `scaled_compliance` [1/kg] is the compliance over the substep
/// squared.
#[inline(always)]
pub(crate) fn solve_rows<S: Simd>(
    simd: S,
    rows: &mut Rows<'_>,
    links: &[RowLink<3>],
    (scaled_compliance, clamps): (f32, &Clamps),
) {
    let mut has_clamp = clamps.rows.iter().copied();
    rows.each_row(
        #[inline(always)]
        |row, inv_masses| {
            let has_clamp = has_clamp.next().unwrap_or(false);
            for link in links {
                let (left, inv_left) = load_partner(simd, link, 0, row, inv_masses);
                let (middle, inv_middle) = load_partner(simd, link, 1, row, inv_masses);
                let (right, inv_right) = load_partner(simd, link, 2, row, inv_masses);
                let curvature = left.add(right).sub(middle.add(middle));
                let compliance = if has_clamp {
                    at_clamp(simd, [inv_left, inv_middle, inv_right], scaled_compliance)
                } else {
                    f32x16::splat(simd, scaled_compliance)
                };
                let mut factor = f32x16::splat(simd, 1.0)
                    / (inv_left + inv_right + inv_middle * 4.0 + compliance);
                if let Some(mask) = &link.mask {
                    factor *= f32x16::load_array_ref(simd, &mask.0);
                }
                add_to_partner(link, 0, curvature.scale(-(factor * inv_left)), row);
                add_to_partner(link, 1, curvature.scale(factor * inv_middle * 2.0), row);
                add_to_partner(link, 2, curvature.scale(-(factor * inv_right)), row);
            }
        },
    );
}

/// Solves bending down columns, from the top to the bottom.
#[inline(always)]
pub(crate) fn solve_columns<S: Simd>(
    simd: S,
    rows: &mut Rows<'_>,
    (scaled_compliance, clamps): (f32, &Clamps),
) {
    let width = rows.group_count;
    let row_count = rows.positions.len() / width;
    for row in 0..row_count.saturating_sub(2) {
        let start = row * width;
        let has_clamp = clamps.columns[row];
        let (upper, rest) = rows.positions[start..start + 3 * width].split_at_mut(width);
        let (middle, lower) = rest.split_at_mut(width);
        let inv_masses = &rows.inv_masses[start..start + 3 * width];
        for group in 0..width {
            let inv_upper = f32x16::load_array_ref(simd, &inv_masses[group].0);
            let inv_middle = f32x16::load_array_ref(simd, &inv_masses[width + group].0);
            let inv_lower = f32x16::load_array_ref(simd, &inv_masses[2 * width + group].0);
            let points = [&upper[group], &middle[group], &lower[group]].map(
                #[inline(always)]
                |p| Vectors::load(simd, p),
            );
            let curvature = points[0].add(points[2]).sub(points[1].add(points[1]));
            let compliance = if has_clamp {
                at_clamp(simd, [inv_upper, inv_middle, inv_lower], scaled_compliance)
            } else {
                f32x16::splat(simd, scaled_compliance)
            };
            let factor =
                f32x16::splat(simd, 1.0) / (inv_upper + inv_lower + inv_middle * 4.0 + compliance);
            points[0]
                .sub(curvature.scale(factor * inv_upper))
                .store(&mut upper[group]);
            points[1]
                .add(curvature.scale(factor * inv_middle * 2.0))
                .store(&mut middle[group]);
            points[2]
                .sub(curvature.scale(factor * inv_lower))
                .store(&mut lower[group]);
        }
    }
}
