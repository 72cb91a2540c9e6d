//! Structural springs: along rows and down columns.

use fearless_simd::{Simd, f32x16, prelude::*};

use crate::constraint::{Rows, add_to_partner, load_partner};
use crate::lanes::{RowLink, Vectors};

/// One family of distance springs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Spring {
    /// Rest length squared [m²].
    pub(crate) rest_length_squared: f32,
    /// Compliance over the substep squared [1/kg].
    pub(crate) scaled_compliance: f32,
}

/// Correction of the first particle over its inverse mass; the second moves the other way.
///
/// `(q - L²) / (q + L²)` with `q` the squared length stands for `1 - L / length`: it agrees to
/// second order near rest, needs no square root, and is gentler on a collapsed spring.
#[inline(always)]
fn correction<S: Simd>(
    offset: Vectors<S>,
    inv_mass_sum: f32x16<S>,
    spring: Spring,
) -> (Vectors<S>, f32x16<S>) {
    let squared = offset.dot(offset);
    let factor = (squared - spring.rest_length_squared)
        / ((squared + spring.rest_length_squared) * (inv_mass_sum + spring.scaled_compliance));
    (offset, factor)
}

/// Solves every spring along rows.
#[inline(always)]
pub(crate) fn solve_rows<S: Simd>(
    simd: S,
    rows: &mut Rows<'_>,
    links: &[RowLink<2>],
    spring: Spring,
) {
    rows.each_row(
        #[inline(always)]
        |row, inv_masses| {
            for link in links {
                let (first, inv_mass_first) = load_partner(simd, link, 0, row, inv_masses);
                let (second, inv_mass_second) = load_partner(simd, link, 1, row, inv_masses);
                let (offset, mut factor) =
                    correction(second.sub(first), inv_mass_first + inv_mass_second, spring);
                if let Some(mask) = &link.mask {
                    factor *= f32x16::load_array_ref(simd, &mask.0);
                }
                add_to_partner(link, 0, offset.scale(factor * inv_mass_first), row);
                add_to_partner(link, 1, offset.scale(-(factor * inv_mass_second)), row);
            }
        },
    );
}

/// Solves every spring down columns, from the top row to the bottom.
#[inline(always)]
pub(crate) fn solve_columns<S: Simd>(simd: S, rows: &mut Rows<'_>, spring: Spring) {
    rows.each_row_pair(
        1,
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
                let (offset, factor) =
                    correction(second.sub(first), inv_mass_first + inv_mass_second, spring);
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
