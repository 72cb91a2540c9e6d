//! What holds the cloth together, in the order in which a substep solves it.
//!
//! Every constraint projects once a substep with `λ = 0`, much as in Macklin, Müller and Chentanez
//! 2016, "XPBD": `Δλ = -C / D`, with `D` from [`resistance`].

pub(crate) mod bend;
pub(crate) mod hysteresis;
pub(crate) mod pull;
pub(crate) mod shear;
pub(crate) mod stride;
pub(crate) mod structural;
pub(crate) mod tether;

use fearless_simd::{Simd, f32x16};

use crate::lanes::{Points, RowLink, Scalars, Vectors, larger, smaller};

/// Keeps the quotient finite where both partners are pinned [1/kg]; a particle of cloth has
/// 1e3 to 1e6.
pub(crate) const INV_MASS_FLOOR: f32 = 1.0e-6;

/// What a constraint with `own = Σ wᵢ |∇ᵢC|²` [1/kg] is divided by: `½ own + compliance`, and up to
/// XPBD's `own + compliance` where it is so stiff that a substep nearly closes it.
///
/// XPBD's whole `own` makes a cloth softer than its fabric: an even strain or curvature asks for the
/// impulse `C / compliance`, and what a constraint takes from itself its neighbors give back,
/// because opposite pulls cancel. Solved one after the other, half of the neighbors have given
/// their half before it is its turn; so half of `own` is left to take away. Stiff constraints need
/// the other half to stay calm: without it a fine cloth of few substeps shakes itself apart.
pub(crate) const fn resistance(own: f32, compliance: f32) -> f32 {
    let calm = (own + compliance).min(1.5 * own);
    calm.max(0.5 * own + compliance)
}

/// [`resistance`] lane by lane.
#[inline(always)]
pub(crate) fn resistances<S: Simd>(simd: S, own: f32x16<S>, compliance: f32x16<S>) -> f32x16<S> {
    use fearless_simd::SimdBase as _;
    let half = own * f32x16::splat(simd, 0.5);
    let calm = smaller(own + compliance, own + half);
    larger(calm, half + compliance)
}

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

impl<const N: usize> RowLink<N> {
    /// Where a partner is, and its inverse mass [1/kg], in the lanes of the first partner.
    #[inline(always)]
    pub(crate) fn load<S: Simd>(
        &self,
        simd: S,
        partner: usize,
        row: &[Points],
        inv_masses: &[Scalars],
    ) -> (Vectors<S>, f32x16<S>) {
        use fearless_simd::SimdBase as _;
        let group = usize::from(self.groups[partner]);
        let shift = self.shifts[partner];
        let inv_mass = f32x16::load_array_ref(simd, &inv_masses[group].0);
        let point = Vectors::load(simd, &row[group]);
        (
            point.rotate_left(shift),
            crate::lanes::rotate_left(inv_mass, shift),
        )
    }

    /// Adds `change`, in the lanes of the first partner, to a partner.
    #[inline(always)]
    pub(crate) fn add_to<S: Simd>(&self, partner: usize, change: Vectors<S>, row: &mut [Points]) {
        let points = &mut row[usize::from(self.groups[partner])];
        let moved = Vectors::load(change_token(change), points)
            .add(change.rotate_right(self.shifts[partner]));
        moved.store(points);
    }
}

#[inline(always)]
fn change_token<S: Simd>(change: Vectors<S>) -> S {
    use fearless_simd::ExtractToken as _;
    change.x.token()
}
