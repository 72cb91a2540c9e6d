//! The cell: both shear springs across it and the twist term of the plate energy.

use fearless_simd::{Simd, f32x16, prelude::*};

use crate::constraint::hysteresis::ShearFriction;
use crate::constraint::pull::Pull;
use crate::constraint::{RowMasses, add_to_partner, load_partner, resistance, resistances, shared};
use crate::lanes::{Points, RowLink, Scalars, Vectors, are_apart};

/// Compliances of one cell over the substep squared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cell {
    /// How far both diagonals pull by their length.
    pub(crate) diagonal: Pull,
    /// Of a shear spring [1/kg].
    pub(crate) shear_compliance: f32,
    /// Of the twist constraint `x₁₁ - x₁₀ - x₀₁ + x₀₀ = 0` [1/kg].
    pub(crate) twist_compliance: f32,
}

impl Cell {
    /// How much of itself a shear spring between equals of this inverse mass [1/kg] takes away.
    pub(crate) fn own_share(&self, inv_mass: f32) -> f32 {
        2.0 * self.spring_share(inv_mass)
    }

    /// By how much of its strain such a spring moves either end.
    fn spring_share(&self, inv_mass: f32) -> f32 {
        inv_mass / resistance(2.0 * inv_mass, self.shear_compliance)
    }
}

/// Solves every cell between a row and the next.
#[inline(always)]
pub(crate) fn solve_pair<S: Simd>(
    simd: S,
    [upper, lower]: [&mut [Points]; 2],
    masses: [RowMasses<'_>; 2],
    links: &[RowLink<2>],
    (cell, friction): (Cell, &mut impl ShearFriction),
) {
    match shared(masses) {
        Some(inv_mass) if inv_mass <= 0.0 => {}
        Some(inv_mass) if are_apart(links) => {
            let spring = cell.spring_share(inv_mass);
            let equals = Equals {
                diagonal: cell.diagonal.shared(spring),
                spring,
                twist: inv_mass / resistance(4.0 * inv_mass, cell.twist_compliance),
            };
            solve_even_pair(simd, [upper, lower], links, (equals, friction));
        }
        _ => solve_uneven_pair(simd, [upper, lower], masses, links, (cell, friction)),
    }
}

/// A cell whose corners have the same mass.
#[derive(Clone, Copy)]
struct Equals {
    diagonal: Pull,
    /// By how much of its strain a shear spring moves either end.
    spring: f32,
    /// Share of the twist by which every corner moves.
    twist: f32,
}

#[inline(always)]
fn solve_even_pair<S: Simd>(
    simd: S,
    [upper, lower]: [&mut [Points]; 2],
    links: &[RowLink<2>],
    (cell, friction): (Equals, &mut impl ShearFriction),
) {
    for (index, link) in links.iter().enumerate() {
        let (left, right) = (usize::from(link.groups[0]), usize::from(link.groups[1]));
        let shift = link.shifts[1];
        let mut points = [
            Vectors::load(simd, &upper[left]),
            Vectors::load(simd, &upper[right]),
            Vectors::load(simd, &lower[left]),
            Vectors::load(simd, &lower[right]),
        ];
        if link.is_straight() {
            cell.solve(simd, &mut points, None, (index, friction));
        } else {
            points[1] = points[1].rotate_left(shift);
            points[3] = points[3].rotate_left(shift);
            let mask = link.mask.as_deref();
            cell.solve(simd, &mut points, mask, (index, friction));
            points[1] = points[1].rotate_right(shift);
            points[3] = points[3].rotate_right(shift);
        }
        points[0].store(&mut upper[left]);
        points[1].store(&mut upper[right]);
        points[2].store(&mut lower[left]);
        points[3].store(&mut lower[right]);
    }
}

impl Equals {
    /// Moves the corners of a cell: upper left and right, lower left and right.
    #[inline(always)]
    fn solve<S: Simd, F: ShearFriction>(
        self,
        simd: S,
        points: &mut [Vectors<S>; 4],
        mask: Option<&Scalars>,
        (index, friction): (usize, &mut F),
    ) {
        let twist = points[0].add(points[3]).sub(points[1].add(points[2]));
        let change = twist.scale(masked(simd, f32x16::splat(simd, self.twist), mask));
        points[0] = points[0].sub(change);
        points[1] = points[1].add(change);
        points[2] = points[2].add(change);
        points[3] = points[3].sub(change);
        if F::ACTS {
            let held = friction.strain(simd, index, squares(points)) * self.spring;
            self.solve_diagonal(simd, points, [0, 3], (mask, Some(held)));
            self.solve_diagonal(simd, points, [1, 2], (mask, Some(held * -1.0)));
        } else {
            self.solve_diagonal(simd, points, [0, 3], (mask, None));
            self.solve_diagonal(simd, points, [1, 2], (mask, None));
        }
    }

    #[inline(always)]
    fn solve_diagonal<S: Simd>(
        self,
        simd: S,
        points: &mut [Vectors<S>; 4],
        [first, second]: [usize; 2],
        (mask, held): (Option<&Scalars>, Option<f32x16<S>>),
    ) {
        let offset = points[second].sub(points[first]);
        let mut factor = self.diagonal.factor(simd, offset.dot(offset));
        if let Some(held) = held {
            factor += held;
        }
        let change = offset.scale(masked(simd, factor, mask));
        points[first] = points[first].add(change);
        points[second] = points[second].sub(change);
    }
}

/// Squared lengths of both diagonals [m²], the falling one first.
#[inline(always)]
fn squares<S: Simd>(points: &[Vectors<S>; 4]) -> [f32x16<S>; 2] {
    let falling = points[3].sub(points[0]);
    let rising = points[2].sub(points[1]);
    [falling.dot(falling), rising.dot(rising)]
}

/// `value` in the lanes of the mask, 0 in others.
#[inline(always)]
fn masked<S: Simd>(simd: S, value: f32x16<S>, mask: Option<&Scalars>) -> f32x16<S> {
    match mask {
        Some(mask) => value * f32x16::load_array_ref(simd, &mask.0),
        None => value,
    }
}

#[inline(always)]
fn solve_uneven_pair<S: Simd, F: ShearFriction>(
    simd: S,
    [upper, lower]: [&mut [Points]; 2],
    masses: [RowMasses<'_>; 2],
    links: &[RowLink<2>],
    (cell, friction): (Cell, &mut F),
) {
    for (index, link) in links.iter().enumerate() {
        let [inv_upper, inv_lower] = masses.map(|row| row.lanes);
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
        let inv_masses = [
            corners[0].1 * mask,
            corners[1].1 * mask,
            corners[2].1 * mask,
            corners[3].1 * mask,
        ];
        let mut points = [corners[0].0, corners[1].0, corners[2].0, corners[3].0];
        solve_twist(simd, &mut points, &inv_masses, cell);
        let held = if F::ACTS {
            let strain = friction.strain(simd, index, squares(&points));
            [Some(strain), Some(strain * -1.0)]
        } else {
            [None, None]
        };
        solve_diagonal(simd, &mut points, &inv_masses, ([0, 3], cell, held[0]));
        solve_diagonal(simd, &mut points, &inv_masses, ([1, 2], cell, held[1]));
        // In a narrow cloth both corners of a row live in one vector, so only changes add up.
        let changes = [
            points[0].sub(corners[0].0),
            points[1].sub(corners[1].0),
            points[2].sub(corners[2].0),
            points[3].sub(corners[3].0),
        ];
        add_to_partner(link, 0, changes[0], upper);
        add_to_partner(link, 1, changes[1], upper);
        add_to_partner(link, 0, changes[2], lower);
        add_to_partner(link, 1, changes[3], lower);
    }
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
    let change = twist.scale(
        f32x16::splat(simd, 1.0)
            / resistances(simd, sum, f32x16::splat(simd, cell.twist_compliance)),
    );
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
    ([first, second], cell, held): ([usize; 2], Cell, Option<f32x16<S>>),
) {
    let offset = points[second].sub(points[first]);
    let compliance = f32x16::splat(simd, cell.shear_compliance);
    let sum = resistances(simd, inv_masses[first] + inv_masses[second], compliance);
    let mut strain = cell.diagonal.factor(simd, offset.dot(offset));
    if let Some(held) = held {
        strain += held;
    }
    let factor = strain / sum;
    points[first] = points[first].add(offset.scale(factor * inv_masses[first]));
    points[second] = points[second].sub(offset.scale(factor * inv_masses[second]));
}
