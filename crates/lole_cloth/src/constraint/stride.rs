//! Unilateral stride constraints: particles `s` cells apart may not be farther than `s` cells.
//!
//! The bound is a geodesic one, true for any cloth that hardly stretches, and it conserves
//! momentum. It carries tension across many cells in one pass, so that the error does not grow
//! with resolution. Folds are free: a slack pair is not touched.

use fearless_simd::{Simd, f32x16, prelude::*};

use crate::constraint::pull::Pull;
use crate::constraint::{INV_MASS_FLOOR, RowMasses, shared};
use crate::lanes::{Points, RowLink, Vectors};

/// The largest distance that two particles may have, as the rest length of what pulls them back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Limit(Pull);

impl Limit {
    /// So many cells of a spacing [m].
    #[expect(clippy::cast_precision_loss, reason = "a stride is far below 2^24")]
    pub(crate) fn new(cells: u32, spacing: f32) -> Self {
        let reach = cells as f32 * spacing;
        Self(Pull::new(reach * reach))
    }

    /// Solves every stride along a row.
    #[inline(always)]
    pub(crate) fn solve_row<S: Simd>(
        self,
        simd: S,
        row: &mut [Points],
        masses: RowMasses<'_>,
        links: &[RowLink<2>],
    ) {
        match masses.even {
            Some(inv_mass) if inv_mass <= 0.0 => return,
            Some(_) => return solve_even_row(simd, row, links, self.0.shared(0.5)),
            None => {}
        }
        for link in links {
            let (first, inv_mass_first) = link.load(simd, 0, row, masses.lanes);
            let (second, inv_mass_second) = link.load(simd, 1, row, masses.lanes);
            let offset = second.sub(first);
            let Some(mut factor) = taut_factor(simd, offset, self.0) else {
                continue;
            };
            factor /= inv_mass_first + inv_mass_second + INV_MASS_FLOOR;
            if let Some(mask) = &link.mask {
                factor *= f32x16::load_array_ref(simd, &mask.0);
            }
            link.add_to(0, offset.scale(factor * inv_mass_first), row);
            link.add_to(1, offset.scale(-(factor * inv_mass_second)), row);
        }
    }

    /// Solves the stride from a row down to another.
    #[inline(always)]
    pub(crate) fn solve_pair<S: Simd>(
        self,
        simd: S,
        [upper, lower]: [&mut [Points]; 2],
        masses: [RowMasses<'_>; 2],
    ) {
        if let Some(inv_mass) = shared(masses) {
            if 0.0 < inv_mass {
                solve_even_pair(simd, [upper, lower], self.0.shared(0.5));
            }
            return;
        }
        let inv_masses = masses[0].lanes.iter().zip(masses[1].lanes);
        for ((upper, lower), (inv_upper, inv_lower)) in upper.iter_mut().zip(lower).zip(inv_masses)
        {
            let first = Vectors::load(simd, upper);
            let second = Vectors::load(simd, lower);
            let inv_mass_first = f32x16::load_array_ref(simd, &inv_upper.0);
            let inv_mass_second = f32x16::load_array_ref(simd, &inv_lower.0);
            let offset = second.sub(first);
            let Some(factor) = taut_factor(simd, offset, self.0) else {
                continue;
            };
            let factor = factor / (inv_mass_first + inv_mass_second + INV_MASS_FLOOR);
            first
                .add(offset.scale(factor * inv_mass_first))
                .store(upper);
            second
                .sub(offset.scale(factor * inv_mass_second))
                .store(lower);
        }
    }
}

/// Factor of the offset, zero where slack; `None` where no lane is taut.
#[inline(always)]
fn taut_factor<S: Simd>(simd: S, offset: Vectors<S>, pull: Pull) -> Option<f32x16<S>> {
    let squared = offset.dot(offset);
    let limit = f32x16::splat(simd, pull.rest_length_squared());
    if limit.simd_lt(squared).any_true() {
        Some(pull.taut_factor(simd, squared))
    } else {
        None
    }
}

#[inline(always)]
fn solve_even_row<S: Simd>(simd: S, row: &mut [Points], links: &[RowLink<2>], pull: Pull) {
    for link in links {
        let (left, right) = (usize::from(link.groups[0]), usize::from(link.groups[1]));
        let shift = link.shifts[1];
        let first = Vectors::load(simd, &row[left]);
        let second = Vectors::load(simd, &row[right]);
        let offset = second.rotate_left(shift).sub(first);
        let Some(mut factor) = taut_factor(simd, offset, pull) else {
            continue;
        };
        if let Some(mask) = &link.mask {
            factor *= f32x16::load_array_ref(simd, &mask.0);
        }
        let change = offset.scale(factor);
        let first = first.add(change);
        first.store(&mut row[left]);
        // In a narrow cloth both ends live in one vector.
        let second = if left == right { first } else { second };
        second
            .sub(change.rotate_right(shift))
            .store(&mut row[right]);
    }
}

#[inline(always)]
fn solve_even_pair<S: Simd>(simd: S, [upper, lower]: [&mut [Points]; 2], pull: Pull) {
    for (upper, lower) in upper.iter_mut().zip(lower) {
        let first = Vectors::load(simd, upper);
        let second = Vectors::load(simd, lower);
        let offset = second.sub(first);
        let Some(factor) = taut_factor(simd, offset, pull) else {
            continue;
        };
        let change = offset.scale(factor);
        first.add(change).store(upper);
        second.sub(change).store(lower);
    }
}
