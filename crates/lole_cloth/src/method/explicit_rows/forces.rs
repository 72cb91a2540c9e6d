//! Forces of springs and plate, row by row: every one is worked out once and added to both ends.

use fearless_simd::{Simd, f32x16, prelude::*};

use super::spring::Spring;
use crate::lanes::{Points, RowLink, Scalars, Vectors, rotate_left};

/// Springs between two rows, and along the upper one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cell {
    pub(super) along: Spring,
    pub(super) diagonal: Spring,
    /// Of the mixed difference `x₁₁ - x₁₀ - x₀₁ + x₀₀` [N/m].
    pub(super) twist: f32,
}

/// Adds `force` to a partner of a link.
#[inline(always)]
fn add<S: Simd>(forces: &mut Points, force: Vectors<S>, shift: u8) {
    Vectors::load(force.x.token(), forces)
        .add(force.rotate_right(shift))
        .store(forces);
}

#[inline(always)]
fn subtract<S: Simd>(forces: &mut Points, force: Vectors<S>, shift: u8) {
    Vectors::load(force.x.token(), forces)
        .sub(force.rotate_right(shift))
        .store(forces);
}

#[inline(always)]
fn masked<S: Simd>(simd: S, value: f32x16<S>, mask: Option<&Scalars>) -> f32x16<S> {
    match mask {
        Some(mask) => value * f32x16::load_array_ref(simd, &mask.0),
        None => value,
    }
}

impl Spring {
    /// Adds the forces of springs along a row: the last one, which has no cells below it.
    #[inline(always)]
    pub(super) fn add_row<S: Simd>(
        &self,
        simd: S,
        forces: &mut [Points],
        row: &[Points],
        links: &[RowLink<2>],
    ) {
        for link in links {
            let [left, right] = link.groups.map(usize::from);
            let shift = link.shifts[1];
            let first = Vectors::load(simd, &row[left]);
            let offset = Vectors::load(simd, &row[right])
                .rotate_left(shift)
                .sub(first);
            let stretch = self.stretch(offset.dot(offset));
            let factor = self.factor(stretch);
            let factor = self.exact_where_far(simd, factor, stretch);
            let force = offset.scale(masked(simd, factor, link.mask.as_deref()));
            add(&mut forces[left], force, 0);
            subtract(&mut forces[right], force, shift);
        }
    }
}

impl Cell {
    /// Adds the forces of springs along the upper row and across the cells below it, and of the cells'
    /// twist.
    #[inline(always)]
    pub(super) fn add_to_rows<S: Simd>(
        &self,
        simd: S,
        [upper_forces, lower_forces]: [&mut [Points]; 2],
        [upper, lower]: [&[Points]; 2],
        links: &[RowLink<2>],
    ) {
        for link in links {
            let [left, right] = link.groups.map(usize::from);
            if link.is_straight() {
                let corners = [
                    Vectors::load(simd, &upper[left]),
                    Vectors::load(simd, &upper[right]),
                    Vectors::load(simd, &lower[left]),
                    Vectors::load(simd, &lower[right]),
                ];
                let forces = self.forces(simd, corners, None);
                add(&mut upper_forces[left], forces[0], 0);
                add(&mut upper_forces[right], forces[1], 0);
                add(&mut lower_forces[left], forces[2], 0);
                subtract(&mut lower_forces[right], forces[3], 0);
                continue;
            }
            let shift = link.shifts[1];
            let corners = [
                Vectors::load(simd, &upper[left]),
                Vectors::load(simd, &upper[right]).rotate_left(shift),
                Vectors::load(simd, &lower[left]),
                Vectors::load(simd, &lower[right]).rotate_left(shift),
            ];
            let forces = self.forces(simd, corners, link.mask.as_deref());
            add(&mut upper_forces[left], forces[0], 0);
            add(&mut upper_forces[right], forces[1], shift);
            add(&mut lower_forces[left], forces[2], 0);
            subtract(&mut lower_forces[right], forces[3], shift);
        }
    }

    /// Forces [N] on the corners: upper left and right, lower left, and against that on the lower
    /// right.
    #[inline(always)]
    fn forces<S: Simd>(
        &self,
        simd: S,
        [x00, x01, x10, x11]: [Vectors<S>; 4],
        mask: Option<&Scalars>,
    ) -> [Vectors<S>; 4] {
        let along = x01.sub(x00);
        let falling = x11.sub(x00);
        let rising = x10.sub(x01);
        let stretches = [
            self.along.stretch(along.dot(along)),
            self.diagonal.stretch(falling.dot(falling)),
            self.diagonal.stretch(rising.dot(rising)),
        ];
        let mut factors = [
            self.along.factor(stretches[0]),
            self.diagonal.factor(stretches[1]),
            self.diagonal.factor(stretches[2]),
        ];
        let farthest = stretches[0].farther(stretches[1]).farther(stretches[2]);
        if farthest.any_far(simd) {
            factors = [
                self.along.exact_where_far(simd, factors[0], stretches[0]),
                self.diagonal
                    .exact_where_far(simd, factors[1], stretches[1]),
                self.diagonal
                    .exact_where_far(simd, factors[2], stretches[2]),
            ];
        }
        let along = along.scale(masked(simd, factors[0], mask));
        let falling = falling.scale(masked(simd, factors[1], mask));
        let rising = rising.scale(masked(simd, factors[2], mask));
        let stiffness = masked(simd, f32x16::splat(simd, self.twist), mask);
        // The mixed difference is x₁₁ - x₀₁ - (x₁₀ - x₀₀).
        let twist = x11.sub(x01).sub(x10.sub(x00)).scale(stiffness);
        [
            along.add(falling).sub(twist),
            twist.add(rising).sub(along),
            twist.sub(rising),
            falling.add(twist),
        ]
    }
}

/// Bending along a row.
pub(super) struct RowBending<'a> {
    pub(super) links: &'a [RowLink<3>],
    /// By the particle at the middle of every term [N/m].
    pub(super) weights: &'a [Scalars],
}

impl RowBending<'_> {
    /// Adds its forces.
    #[inline(always)]
    pub(super) fn add<S: Simd>(&self, simd: S, forces: &mut [Points], row: &[Points]) {
        for link in self.links {
            let [left, middle, right] = link.groups.map(usize::from);
            let [_, to_middle, to_right] = link.shifts;
            let weight = f32x16::load_array_ref(simd, &self.weights[middle].0);
            let weight = masked(simd, rotate_left(weight, to_middle), link.mask.as_deref());
            let center = Vectors::load(simd, &row[middle]).rotate_left(to_middle);
            let curvature = Vectors::load(simd, &row[left])
                .sub(center)
                .sub(center.sub(Vectors::load(simd, &row[right]).rotate_left(to_right)));
            let force = curvature.scale(weight);
            subtract(&mut forces[left], force, 0);
            add(&mut forces[middle], force.add(force), to_middle);
            subtract(&mut forces[right], force, to_right);
        }
    }
}

/// What acts down the columns of three rows: springs from the first to the second, and bending.
pub(super) struct Columns<'a> {
    pub(super) spring: &'a Spring,
    /// Bending of the terms in the middle row [N/m].
    pub(super) bend: &'a [Scalars],
    /// The three rows of points.
    pub(super) rows: [&'a [Points]; 3],
}

impl Columns<'_> {
    /// Adds the forces of one group to those on the second row, sets those on the third, and
    /// returns those on the first.
    #[inline(always)]
    pub(super) fn add<S: Simd>(
        &self,
        simd: S,
        group: usize,
        forces: [&mut Points; 3],
    ) -> Vectors<S> {
        let [first, center, last] = self.rows.map(|row| Vectors::load(simd, &row[group]));
        let offset = center.sub(first);
        let pull = self.spring.force(simd, offset);
        let weight = f32x16::load_array_ref(simd, &self.bend[group].0);
        let straight = offset.sub(last.sub(center));
        let bend = straight.scale(weight);
        let [this, next, far] = forces;
        (Vectors::load(simd, next).sub(bend.add(bend)).sub(pull)).store(next);
        bend.store(far);
        Vectors::load(simd, this).add(pull).add(bend)
    }
}

/// Adds the springs of one group from the last row but one to the last, and returns the forces on
/// the upper.
#[inline(always)]
pub(super) fn add_last_pair<S: Simd>(
    simd: S,
    spring: &Spring,
    [upper, lower]: [&Points; 2],
    [this, next]: [&mut Points; 2],
) -> Vectors<S> {
    let offset = Vectors::load(simd, lower).sub(Vectors::load(simd, upper));
    let pull = spring.force(simd, offset);
    Vectors::load(simd, next).sub(pull).store(next);
    Vectors::load(simd, this).add(pull)
}
