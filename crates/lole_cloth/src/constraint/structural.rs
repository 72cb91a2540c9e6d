//! Structural springs: along rows and down columns.

use fearless_simd::{Simd, f32x16, prelude::*};

use crate::constraint::pull::Pull;
use crate::constraint::{RowMasses, resistance, resistances, shared};
use crate::lanes::{Points, RowLink, Vectors, are_apart};

/// One family of distance springs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Spring {
    /// How far it pulls by its length.
    pub(crate) pull: Pull,
    /// Compliance over the substep squared [1/kg].
    pub(crate) scaled_compliance: f32,
}

impl Spring {
    /// What pulls where both ends have the same inverse mass [1/kg].
    #[inline(always)]
    pub(crate) fn between_equals(&self, inv_mass: f32) -> Pull {
        let share = inv_mass / resistance(inv_mass + inv_mass, self.scaled_compliance);
        self.pull.shared(share)
    }

    /// Solves every spring along a row.
    #[inline(always)]
    pub(crate) fn solve_row<S: Simd>(
        self,
        simd: S,
        row: &mut [Points],
        masses: RowMasses<'_>,
        links: &[RowLink<2>],
    ) {
        match masses.even {
            Some(inv_mass) if inv_mass <= 0.0 => {}
            Some(inv_mass) if are_apart(links) => {
                solve_even_row(simd, row, links, self.between_equals(inv_mass));
            }
            _ => self.solve_uneven_row(simd, row, masses, links),
        }
    }

    #[inline(always)]
    fn solve_uneven_row<S: Simd>(
        self,
        simd: S,
        row: &mut [Points],
        masses: RowMasses<'_>,
        links: &[RowLink<2>],
    ) {
        let pull = self.pull;
        let compliance = f32x16::splat(simd, self.scaled_compliance);
        for link in links {
            let (first, inv_mass_first) = link.load(simd, 0, row, masses.lanes);
            let (second, inv_mass_second) = link.load(simd, 1, row, masses.lanes);
            let offset = second.sub(first);
            let sum = resistances(simd, inv_mass_first + inv_mass_second, compliance);
            let mut factor = pull.factor(simd, offset.dot(offset)) / sum;
            if let Some(mask) = &link.mask {
                factor *= f32x16::load_array_ref(simd, &mask.0);
            }
            link.add_to(0, offset.scale(factor * inv_mass_first), row);
            link.add_to(1, offset.scale(-(factor * inv_mass_second)), row);
        }
    }

    /// Solves every spring from a row down to the next.
    #[inline(always)]
    pub(crate) fn solve_pair<S: Simd>(
        self,
        simd: S,
        [upper, lower]: [&mut [Points]; 2],
        masses: [RowMasses<'_>; 2],
    ) {
        if let Some(inv_mass) = shared(masses) {
            if 0.0 < inv_mass {
                solve_even_pair(simd, [upper, lower], self.between_equals(inv_mass));
            }
            return;
        }
        let pull = self.pull;
        let compliance = f32x16::splat(simd, self.scaled_compliance);
        let inv_masses = masses[0].lanes.iter().zip(masses[1].lanes);
        for ((upper, lower), (inv_upper, inv_lower)) in upper.iter_mut().zip(lower).zip(inv_masses)
        {
            let first = Vectors::load(simd, upper);
            let second = Vectors::load(simd, lower);
            let inv_mass_first = f32x16::load_array_ref(simd, &inv_upper.0);
            let inv_mass_second = f32x16::load_array_ref(simd, &inv_lower.0);
            let offset = second.sub(first);
            let sum = resistances(simd, inv_mass_first + inv_mass_second, compliance);
            let factor = pull.factor(simd, offset.dot(offset)) / sum;
            first
                .add(offset.scale(factor * inv_mass_first))
                .store(upper);
            second
                .sub(offset.scale(factor * inv_mass_second))
                .store(lower);
        }
    }
}

#[inline(always)]
fn solve_even_row<S: Simd>(simd: S, row: &mut [Points], links: &[RowLink<2>], pull: Pull) {
    for link in links {
        let (left, right) = (usize::from(link.groups[0]), usize::from(link.groups[1]));
        let first = Vectors::load(simd, &row[left]);
        let second = Vectors::load(simd, &row[right]);
        if link.is_straight() {
            let offset = second.sub(first);
            let change = offset.scale(pull.factor(simd, offset.dot(offset)));
            first.add(change).store(&mut row[left]);
            second.sub(change).store(&mut row[right]);
            continue;
        }
        let offset = second.rotate_left(link.shifts[1]).sub(first);
        let mut factor = pull.factor(simd, offset.dot(offset));
        if let Some(mask) = &link.mask {
            factor *= f32x16::load_array_ref(simd, &mask.0);
        }
        let change = offset.scale(factor);
        first.add(change).store(&mut row[left]);
        second
            .sub(change.rotate_right(link.shifts[1]))
            .store(&mut row[right]);
    }
}

#[inline(always)]
fn solve_even_pair<S: Simd>(simd: S, [upper, lower]: [&mut [Points]; 2], pull: Pull) {
    for (upper, lower) in upper.iter_mut().zip(lower) {
        let first = Vectors::load(simd, upper);
        let second = Vectors::load(simd, lower);
        let offset = second.sub(first);
        let change = offset.scale(pull.factor(simd, offset.dot(offset)));
        first.add(change).store(upper);
        second.sub(change).store(lower);
    }
}
