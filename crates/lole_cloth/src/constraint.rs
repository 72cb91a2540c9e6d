//! What holds the cloth together, in the order in which a substep solves it.
//!
//! Every constraint projects once a substep with `λ = 0`, as in Macklin, Müller and Chentanez
//! 2016, "XPBD": `Δλ = -C / (Σ wᵢ |∇ᵢC|² + compliance / dt²)`.

pub(crate) mod bend;
pub(crate) mod pull;
pub(crate) mod shear;
pub(crate) mod stride;
pub(crate) mod structural;
pub(crate) mod tether;

use fearless_simd::{Simd, f32x16};

use crate::lanes::{Points, RowLink, Scalars, Vectors};

/// Keeps the quotient finite where both partners are pinned [1/kg]; a particle of cloth has
/// 1e3 to 1e6.
pub(crate) const INV_MASS_FLOOR: f32 = 1.0e-6;

/// Inverse masses of one row [1/kg]; 0 for what is pinned and for lanes without a column.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RowMasses<'a> {
    pub(crate) lanes: &'a [Scalars],
    /// That of every particle, where all have the same.
    pub(crate) even: Option<f32>,
}

/// The inverse mass [1/kg] that all particles of these rows share.
#[inline(always)]
pub(crate) fn shared<const N: usize>(masses: [RowMasses<'_>; N]) -> Option<f32> {
    let first = masses[0].even?;
    let alike = masses.iter().all(|row| {
        row.even
            .is_some_and(|even| even.to_bits() == first.to_bits())
    });
    alike.then_some(first)
}

/// A partner of a row link: where it is and how heavy.
#[inline(always)]
pub(crate) fn load_partner<S: Simd, const N: usize>(
    simd: S,
    link: &RowLink<N>,
    partner: usize,
    row: &[Points],
    inv_masses: &[Scalars],
) -> (Vectors<S>, f32x16<S>) {
    use fearless_simd::SimdBase as _;
    let group = usize::from(link.groups[partner]);
    let shift = link.shifts[partner];
    let inv_mass = f32x16::load_array_ref(simd, &inv_masses[group].0);
    let point = Vectors::load(simd, &row[group]);
    (
        point.rotate_left(shift),
        crate::lanes::rotate_left(inv_mass, shift),
    )
}

/// Adds `change` to a partner of a row link.
#[inline(always)]
pub(crate) fn add_to_partner<S: Simd, const N: usize>(
    link: &RowLink<N>,
    partner: usize,
    change: Vectors<S>,
    row: &mut [Points],
) {
    let points = &mut row[usize::from(link.groups[partner])];
    let moved =
        Vectors::load(change_token(change), points).add(change.rotate_right(link.shifts[partner]));
    moved.store(points);
}

#[inline(always)]
fn change_token<S: Simd>(change: Vectors<S>) -> S {
    use fearless_simd::ExtractToken as _;
    change.x.token()
}
