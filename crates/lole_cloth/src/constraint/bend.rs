//! Bending along rows and down columns: the pure terms of the orthotropic plate energy.
//!
//! `E = h_u h_v / 2 (B_u |d_uu x|² + B_v |d_vv x|² + 2 B_t |d_uv x|²)` with the second differences
//! `d_uu x = (x₋ - 2 x₀ + x₊) / h_u²`. Its Hessian is constant, so each term is a linear
//! constraint `C = x₋ - 2 x₀ + x₊ = 0` that knows no direction: rotations leave it alone, and a
//! flat sheet has none of it. The twist term is solved with the shear springs of its cell.
//!
//! Each term is weighted by the area that it stands for: a half at the free borders, as in the
//! reference. With whole weights a strip of four cells is a quarter too stiff.
//!
//! At a clamp, a pinned particle between a pinned and a free one, the arm that bends is half as
//! long and the energy twice as large, as in the reference: without it a clamped strip converges
//! only with the spacing, from 62 % too deep on two cells a bending length.

use fearless_simd::{Simd, f32x16, prelude::*};

use crate::constraint::hysteresis::BendFriction;
use crate::constraint::{RowMasses, resistance, resistances, shared};
use crate::lanes::{LANES, Layout, Points, RowLink, Scalars, Vectors, are_apart};
use crate::{ClothSpec, Topology};

/// Which bending terms have a clamp in them.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Clamps {
    /// By row: whether a term along it has one.
    pub(crate) rows: Vec<bool>,
    /// By upper row of a term down the columns.
    pub(crate) columns: Vec<bool>,
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

/// By group of a row, what the compliance of bending down the columns is multiplied by in each
/// lane: 2 at the free borders of a sheet; `None` where there are none.
pub(crate) fn borders(spec: &ClothSpec, layout: &Layout) -> Vec<Option<Box<Scalars>>> {
    let grid = &spec.grid;
    let mut borders = vec![None; layout.group_count];
    if grid.topology == Topology::Sheet {
        for column in [0, grid.column_count - 1] {
            let (group, lane) = layout.slot(column as usize);
            let factors = borders[group].get_or_insert_with(|| Box::new(Scalars([1.0; LANES])));
            factors.0[lane] = 2.0;
        }
    }
    borders
}

/// The compliance of a term with these inverse masses [1/kg]: halved where it has a clamp in it.
#[inline(always)]
fn at_clamp<S: Simd>(
    simd: S,
    [before, center, after]: [f32x16<S>; 3],
    whole: f32x16<S>,
) -> f32x16<S> {
    let zero = f32x16::splat(simd, 0.0);
    let is_free = |inv_mass: f32x16<S>| zero.simd_lt(inv_mass);
    let is_clamp = (is_free(before) ^ is_free(after)) & !is_free(center);
    is_clamp.select(whole * 0.5, whole)
}

/// Bending terms of one row or of three, one below the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bend {
    /// Compliance over the substep squared [1/kg].
    pub(crate) scaled_compliance: f32,
    /// Whether any of them has a clamp in it.
    pub(crate) has_clamp: bool,
}

impl Bend {
    /// Share of the second difference by which both ends move where all have the same inverse mass
    /// [1/kg]; the middle moves twice as far, the other way.
    fn share_of_equals(&self, inv_mass: f32) -> f32 {
        inv_mass / resistance(6.0 * inv_mass, self.scaled_compliance)
    }

    /// How much of itself a term between equals of this inverse mass [1/kg] takes away.
    pub(crate) fn own_share(&self, inv_mass: f32) -> f32 {
        6.0 * self.share_of_equals(inv_mass)
    }

    #[inline(always)]
    fn compliance<S: Simd>(&self, simd: S, border: Option<&Scalars>) -> f32x16<S> {
        let whole = f32x16::splat(simd, self.scaled_compliance);
        match border {
            Some(factors) => whole * f32x16::load_array_ref(simd, &factors.0),
            None => whole,
        }
    }

    /// What the second difference is multiplied by, before it is divided among the three.
    #[inline(always)]
    fn factor<S: Simd>(
        &self,
        simd: S,
        inv_masses: [f32x16<S>; 3],
        border: Option<&Scalars>,
    ) -> f32x16<S> {
        let [before, center, after] = inv_masses;
        let mut compliance = self.compliance(simd, border);
        if self.has_clamp {
            compliance = at_clamp(simd, inv_masses, compliance);
        }
        f32x16::splat(simd, 1.0) / resistances(simd, before + after + center * 4.0, compliance)
    }
}

/// Bending terms, and what yarns that rub on each other add to them.
pub(crate) struct Bending<'a, F> {
    pub(crate) bend: Bend,
    pub(crate) friction: &'a mut F,
}

impl<F: BendFriction> Bending<'_, F> {
    /// Solves bending along a row.
    #[inline(always)]
    pub(crate) fn solve_row<S: Simd>(
        self,
        simd: S,
        row: &mut [Points],
        masses: RowMasses<'_>,
        links: &[RowLink<3>],
    ) {
        match masses.even {
            Some(inv_mass) if inv_mass <= 0.0 => {}
            Some(inv_mass) if are_apart(links) => {
                let share = self.bend.share_of_equals(inv_mass);
                self.solve_even_row(simd, row, links, share);
            }
            _ => self.solve_uneven_row(simd, row, masses, links),
        }
    }

    /// Moves ends of equal mass by a `share` of the second difference.
    #[inline(always)]
    fn solve_even_row<S: Simd>(
        self,
        simd: S,
        row: &mut [Points],
        links: &[RowLink<3>],
        share: f32,
    ) {
        let share = f32x16::splat(simd, share);
        for (index, link) in links.iter().enumerate() {
            let groups = link.groups.map(usize::from);
            let left = Vectors::load(simd, &row[groups[0]]);
            let middle = Vectors::load(simd, &row[groups[1]]);
            let right = Vectors::load(simd, &row[groups[2]]);
            if link.is_straight() {
                let curvature = left.add(right).sub(middle.add(middle));
                let change = curvature.scale(self.friction.share(simd, index, curvature, share));
                left.sub(change).store(&mut row[groups[0]]);
                middle.add(change.add(change)).store(&mut row[groups[1]]);
                right.sub(change).store(&mut row[groups[2]]);
                continue;
            }
            let center = middle.rotate_left(link.shifts[1]);
            let curvature = (left.add(right.rotate_left(link.shifts[2]))).sub(center.add(center));
            let mut factor = self.friction.share(simd, index, curvature, share);
            if let Some(mask) = &link.mask {
                factor *= f32x16::load_array_ref(simd, &mask.0);
            }
            let change = curvature.scale(factor);
            left.sub(change).store(&mut row[groups[0]]);
            middle
                .add(change.add(change).rotate_right(link.shifts[1]))
                .store(&mut row[groups[1]]);
            right
                .sub(change.rotate_right(link.shifts[2]))
                .store(&mut row[groups[2]]);
        }
    }

    #[inline(always)]
    fn solve_uneven_row<S: Simd>(
        self,
        simd: S,
        row: &mut [Points],
        masses: RowMasses<'_>,
        links: &[RowLink<3>],
    ) {
        for (index, link) in links.iter().enumerate() {
            let (left, inv_left) = link.load(simd, 0, row, masses.lanes);
            let (middle, inv_middle) = link.load(simd, 1, row, masses.lanes);
            let (right, inv_right) = link.load(simd, 2, row, masses.lanes);
            let curvature = left.add(right).sub(middle.add(middle));
            let elastic = self
                .bend
                .factor(simd, [inv_left, inv_middle, inv_right], None);
            let mut factor = self.friction.share(simd, index, curvature, elastic);
            if let Some(mask) = &link.mask {
                factor *= f32x16::load_array_ref(simd, &mask.0);
            }
            link.add_to(0, curvature.scale(-(factor * inv_left)), row);
            link.add_to(1, curvature.scale(factor * inv_middle * 2.0), row);
            link.add_to(2, curvature.scale(-(factor * inv_right)), row);
        }
    }

    /// Solves bending down the columns of three rows.
    #[inline(always)]
    pub(crate) fn solve_triple<S: Simd>(
        self,
        simd: S,
        [upper, middle, lower]: [&mut [Points]; 3],
        masses: [RowMasses<'_>; 3],
        borders: &[Option<Box<Scalars>>],
    ) {
        let Self { bend, friction } = self;
        let rows = upper.iter_mut().zip(middle).zip(lower).zip(borders);
        if let Some(inv_mass) = shared(masses) {
            if inv_mass <= 0.0 {
                return;
            }
            let even = f32x16::splat(simd, bend.share_of_equals(inv_mass));
            for (group, (((upper, middle), lower), border)) in rows.enumerate() {
                let share = match border.as_deref() {
                    None => even,
                    border => {
                        let inv_mass = f32x16::splat(simd, inv_mass);
                        let own = inv_mass * f32x16::splat(simd, 6.0);
                        inv_mass / resistances(simd, own, bend.compliance(simd, border))
                    }
                };
                let first = Vectors::load(simd, upper);
                let center = Vectors::load(simd, middle);
                let last = Vectors::load(simd, lower);
                let curvature = first.add(last).sub(center.add(center));
                let change = curvature.scale(friction.share(simd, group, curvature, share));
                first.sub(change).store(upper);
                center.add(change.add(change)).store(middle);
                last.sub(change).store(lower);
            }
            return;
        }
        for (group, (((upper, middle), lower), border)) in rows.enumerate() {
            let border = border.as_deref();
            let first = Vectors::load(simd, upper);
            let center = Vectors::load(simd, middle);
            let last = Vectors::load(simd, lower);
            let curvature = first.add(last).sub(center.add(center));
            let inv_upper = f32x16::load_array_ref(simd, &masses[0].lanes[group].0);
            let inv_middle = f32x16::load_array_ref(simd, &masses[1].lanes[group].0);
            let inv_lower = f32x16::load_array_ref(simd, &masses[2].lanes[group].0);
            let elastic = bend.factor(simd, [inv_upper, inv_middle, inv_lower], border);
            let factor = friction.share(simd, group, curvature, elastic);
            first.sub(curvature.scale(factor * inv_upper)).store(upper);
            center
                .add(curvature.scale(factor * inv_middle * 2.0))
                .store(middle);
            last.sub(curvature.scale(factor * inv_lower)).store(lower);
        }
    }
}
