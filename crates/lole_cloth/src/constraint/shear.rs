//! The cell: both shear springs across it and the twist term of the plate energy.

use fearless_simd::{Simd, f32x16, prelude::*};

use crate::constraint::hysteresis::ShearFriction;
use crate::constraint::pull::Pull;
use crate::constraint::{RowMasses, resistance, resistances, shared};
use crate::lanes::{Points, RowLink, Scalars, Vectors, are_apart};

/// Compliances of one cell over the substep squared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cell {
    /// How far both diagonals pull by their length.
    pub(crate) diagonal: Pull,
    /// Scaled compliance of a shear spring [1/kg].
    pub(crate) shear_compliance: f32,
    /// Scaled compliance of the twist constraint `x₁₁ - x₁₀ - x₀₁ + x₀₀ = 0` [1/kg].
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

/// Cells, and what yarns that rub on each other add to them.
pub(crate) struct Shearing<'a, F> {
    pub(crate) cell: Cell,
    pub(crate) friction: &'a mut F,
}

impl<F: ShearFriction> Shearing<'_, F> {
    /// Solves every cell between a row and the next.
    #[inline(always)]
    pub(crate) fn solve_pair<S: Simd>(
        self,
        simd: S,
        rows: [&mut [Points]; 2],
        masses: [RowMasses<'_>; 2],
        links: &[RowLink<2>],
    ) {
        match shared(masses) {
            Some(inv_mass) if inv_mass <= 0.0 => {}
            Some(inv_mass) if are_apart(links) => {
                let equals = Equals::new(self.cell, inv_mass);
                self.solve_even_pair(simd, rows, links, equals);
            }
            _ => self.solve_uneven_pair(simd, rows, masses, links),
        }
    }

    #[inline(always)]
    fn solve_even_pair<S: Simd>(
        self,
        simd: S,
        [upper, lower]: [&mut [Points]; 2],
        links: &[RowLink<2>],
        cell: Equals,
    ) {
        for (index, link) in links.iter().enumerate() {
            let (left, right) = (usize::from(link.groups[0]), usize::from(link.groups[1]));
            let shift = link.shifts[1];
            let mut corners = Corners {
                points: [
                    Vectors::load(simd, &upper[left]),
                    Vectors::load(simd, &upper[right]),
                    Vectors::load(simd, &lower[left]),
                    Vectors::load(simd, &lower[right]),
                ],
                mask: None,
            };
            if link.is_straight() {
                cell.solve(simd, &mut corners, index, self.friction);
            } else {
                corners.points[1] = corners.points[1].rotate_left(shift);
                corners.points[3] = corners.points[3].rotate_left(shift);
                corners.mask = link.mask.as_deref();
                cell.solve(simd, &mut corners, index, self.friction);
                corners.points[1] = corners.points[1].rotate_right(shift);
                corners.points[3] = corners.points[3].rotate_right(shift);
            }
            corners.points[0].store(&mut upper[left]);
            corners.points[1].store(&mut upper[right]);
            corners.points[2].store(&mut lower[left]);
            corners.points[3].store(&mut lower[right]);
        }
    }

    #[inline(always)]
    fn solve_uneven_pair<S: Simd>(
        self,
        simd: S,
        [upper, lower]: [&mut [Points]; 2],
        masses: [RowMasses<'_>; 2],
        links: &[RowLink<2>],
    ) {
        for (index, link) in links.iter().enumerate() {
            let [inv_upper, inv_lower] = masses.map(|row| row.lanes);
            let corners = [
                link.load(simd, 0, upper, inv_upper),
                link.load(simd, 1, upper, inv_upper),
                link.load(simd, 0, lower, inv_lower),
                link.load(simd, 1, lower, inv_lower),
            ];
            let mask = match &link.mask {
                Some(mask) => f32x16::load_array_ref(simd, &mask.0),
                None => f32x16::splat(simd, 1.0),
            };
            let mut heavy = HeavyCorners {
                points: [corners[0].0, corners[1].0, corners[2].0, corners[3].0],
                inv_masses: [
                    corners[0].1 * mask,
                    corners[1].1 * mask,
                    corners[2].1 * mask,
                    corners[3].1 * mask,
                ],
            };
            heavy.solve_twist(simd, self.cell);
            let held = if F::ACTS {
                let strain = self.friction.strain(simd, index, squares(&heavy.points));
                [Some(strain), Some(strain * -1.0)]
            } else {
                [None, None]
            };
            heavy.solve_diagonal(simd, self.cell, [0, 3], held[0]);
            heavy.solve_diagonal(simd, self.cell, [1, 2], held[1]);
            let points = heavy.points;
            // In a narrow cloth both corners of a row live in one vector, so only changes add up.
            let changes = [
                points[0].sub(corners[0].0),
                points[1].sub(corners[1].0),
                points[2].sub(corners[2].0),
                points[3].sub(corners[3].0),
            ];
            link.add_to(0, changes[0], upper);
            link.add_to(1, changes[1], upper);
            link.add_to(0, changes[2], lower);
            link.add_to(1, changes[3], lower);
        }
    }
}

/// Corners of a vector of cells that have the same mass: upper left and right, lower left and right.
struct Corners<'a, S: Simd> {
    points: [Vectors<S>; 4],
    /// 1 in lanes that have a cell, 0 in others; all have one where `None`.
    mask: Option<&'a Scalars>,
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

impl Equals {
    /// Corners of this inverse mass [1/kg].
    #[inline(always)]
    fn new(cell: Cell, inv_mass: f32) -> Self {
        let spring = cell.spring_share(inv_mass);
        Self {
            diagonal: cell.diagonal.shared(spring),
            spring,
            twist: inv_mass / resistance(4.0 * inv_mass, cell.twist_compliance),
        }
    }

    /// Moves the corners of the vector of cells `index`.
    #[inline(always)]
    fn solve<S: Simd, F: ShearFriction>(
        self,
        simd: S,
        corners: &mut Corners<'_, S>,
        index: usize,
        friction: &mut F,
    ) {
        let Corners { points, mask } = corners;
        let twist = points[0].add(points[3]).sub(points[1].add(points[2]));
        let change = twist.scale(masked(simd, f32x16::splat(simd, self.twist), *mask));
        points[0] = points[0].sub(change);
        points[1] = points[1].add(change);
        points[2] = points[2].add(change);
        points[3] = points[3].sub(change);
        if F::ACTS {
            let held = friction.strain(simd, index, squares(points)) * self.spring;
            self.solve_diagonal(simd, corners, [0, 3], Some(held));
            self.solve_diagonal(simd, corners, [1, 2], Some(held * -1.0));
        } else {
            self.solve_diagonal(simd, corners, [0, 3], None);
            self.solve_diagonal(simd, corners, [1, 2], None);
        }
    }

    /// Moves the ends of a diagonal; `held` is the strain that friction adds.
    #[inline(always)]
    fn solve_diagonal<S: Simd>(
        self,
        simd: S,
        corners: &mut Corners<'_, S>,
        [first, second]: [usize; 2],
        held: Option<f32x16<S>>,
    ) {
        let Corners { points, mask } = corners;
        let offset = points[second].sub(points[first]);
        let mut factor = self.diagonal.factor(simd, offset.dot(offset));
        if let Some(held) = held {
            factor += held;
        }
        let change = offset.scale(masked(simd, factor, *mask));
        points[first] = points[first].add(change);
        points[second] = points[second].sub(change);
    }
}

/// Corners of a vector of cells, each with its own mass: upper left and right, lower left and right.
struct HeavyCorners<S: Simd> {
    points: [Vectors<S>; 4],
    /// [1/kg]; 0 in lanes that have no cell.
    inv_masses: [f32x16<S>; 4],
}

impl<S: Simd> HeavyCorners<S> {
    #[inline(always)]
    fn solve_twist(&mut self, simd: S, cell: Cell) {
        let Self { points, inv_masses } = self;
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

    /// Moves the ends of a diagonal; `held` is the strain that friction adds.
    #[inline(always)]
    fn solve_diagonal(
        &mut self,
        simd: S,
        cell: Cell,
        [first, second]: [usize; 2],
        held: Option<f32x16<S>>,
    ) {
        let Self { points, inv_masses } = self;
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
