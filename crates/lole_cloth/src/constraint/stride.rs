//! Unilateral stride constraints: particles `s` cells apart may not be farther than `s` cells.
//!
//! The bound is a geodesic one, true for any cloth that hardly stretches, and it conserves
//! momentum. It carries tension across many cells in one pass, so that the error does not grow
//! with resolution. Folds are free: a slack pair is not touched.

use fearless_simd::{Simd, f32x16, prelude::*};

use crate::constraint::{INV_MASS_FLOOR, Rows, add_to_partner, load_partner};
use crate::lanes::{RowLink, Vectors, larger};

/// Factor of the offset, zero where slack; `None` where no lane is taut.
#[inline(always)]
fn taut_factor<S: Simd>(
    simd: S,
    offset: Vectors<S>,
    inv_mass_sum: f32x16<S>,
    limit_squared: f32,
) -> Option<f32x16<S>> {
    let squared = offset.dot(offset);
    let excess = squared - limit_squared;
    let zero = f32x16::splat(simd, 0.0);
    if !zero.simd_lt(excess).any_true() {
        return None;
    }
    Some(larger(excess, zero) / ((squared + limit_squared) * (inv_mass_sum + INV_MASS_FLOOR)))
}

/// Solves every stride along rows; `limit_squared` is the largest squared distance [m²].
#[inline(always)]
pub(crate) fn solve_rows<S: Simd>(
    simd: S,
    rows: &mut Rows<'_>,
    links: &[RowLink<2>],
    limit_squared: f32,
) {
    rows.each_row(
        #[inline(always)]
        |row, inv_masses| {
            for link in links {
                let (first, inv_mass_first) = load_partner(simd, link, 0, row, inv_masses);
                let (second, inv_mass_second) = load_partner(simd, link, 1, row, inv_masses);
                let offset = second.sub(first);
                let sum = inv_mass_first + inv_mass_second;
                let Some(mut factor) = taut_factor(simd, offset, sum, limit_squared) else {
                    continue;
                };
                if let Some(mask) = &link.mask {
                    factor *= f32x16::load_array_ref(simd, &mask.0);
                }
                add_to_partner(link, 0, offset.scale(factor * inv_mass_first), row);
                add_to_partner(link, 1, offset.scale(-(factor * inv_mass_second)), row);
            }
        },
    );
}

/// Solves every stride down columns, from the top row to the bottom.
#[inline(always)]
pub(crate) fn solve_columns<S: Simd>(
    simd: S,
    rows: &mut Rows<'_>,
    stride: usize,
    limit_squared: f32,
) {
    rows.each_row_pair(
        stride,
        #[inline(always)]
        |[upper, lower], [inv_upper, inv_lower]| {
            let pairs = upper
                .iter_mut()
                .zip(lower)
                .zip(inv_upper.iter().zip(inv_lower));
            for ((upper, lower), (inv_upper, inv_lower)) in pairs {
                let first = Vectors::load(simd, upper);
                let second = Vectors::load(simd, lower);
                let inv_mass_first = f32x16::load_array_ref(simd, &inv_upper.0);
                let inv_mass_second = f32x16::load_array_ref(simd, &inv_lower.0);
                let offset = second.sub(first);
                let sum = inv_mass_first + inv_mass_second;
                let Some(factor) = taut_factor(simd, offset, sum, limit_squared) else {
                    continue;
                };
                first
                    .add(offset.scale(factor * inv_mass_first))
                    .store(upper);
                second
                    .sub(offset.scale(factor * inv_mass_second))
                    .store(lower);
            }
        },
    );
}
