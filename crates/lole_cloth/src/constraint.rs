//! What holds the cloth together, in the order in which a substep solves it.
//!
//! Every constraint projects once a substep with `λ = 0`, as in Macklin, Müller and Chentanez
//! 2016, "XPBD": `Δλ = -C / (Σ wᵢ |∇ᵢC|² + compliance / dt²)`.

pub(crate) mod bend;
pub(crate) mod shear;
pub(crate) mod stride;
pub(crate) mod structural;
pub(crate) mod tether;

use fearless_simd::{Simd, f32x16};

use crate::lanes::{Points, RowLink, Scalars, Vectors};

/// Keeps the quotient finite where both partners are pinned [1/kg]; a particle of cloth has
/// 1e3 to 1e6.
pub(crate) const INV_MASS_FLOOR: f32 = 1.0e-6;

/// Rows of particles with their inverse masses [1/kg], `group_count` vectors a row.
pub(crate) struct Rows<'a> {
    pub(crate) positions: &'a mut [Points],
    pub(crate) inv_masses: &'a [Scalars],
    pub(crate) group_count: usize,
}

impl Rows<'_> {
    /// Runs `kernel(row, inverse masses of the row)` for every row.
    #[inline(always)]
    pub(crate) fn each_row(&mut self, mut kernel: impl FnMut(&mut [Points], &[Scalars])) {
        let rows = self.positions.chunks_exact_mut(self.group_count);
        for (row, inv_masses) in rows.zip(self.inv_masses.chunks_exact(self.group_count)) {
            kernel(row, inv_masses);
        }
    }

    /// Runs `kernel(row, row below by stride, and their inverse masses)` from the top down.
    #[inline(always)]
    pub(crate) fn each_row_pair(
        &mut self,
        stride: usize,
        mut kernel: impl FnMut([&mut [Points]; 2], [&[Scalars]; 2]),
    ) {
        let width = self.group_count;
        let row_count = self.positions.len() / width;
        for row in 0..row_count.saturating_sub(stride) {
            let (above, below) = self.positions.split_at_mut((row + stride) * width);
            let first = row * width..(row + 1) * width;
            let second = (row + stride) * width..(row + stride + 1) * width;
            kernel(
                [&mut above[first.clone()], &mut below[..width]],
                [&self.inv_masses[first], &self.inv_masses[second]],
            );
        }
    }
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
