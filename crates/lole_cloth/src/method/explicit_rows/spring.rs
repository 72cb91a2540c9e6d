//! The spring (1) of a family, as a factor of the offset between its ends, in vectors.

use fearless_simd::{Simd, f32x16, prelude::*};

use crate::lanes::{Vectors, larger};

/// `(1 - (1 + e)^-½) / e` for `e` of `-0.4..0.4`, which are lengths of 0.775 to 1.183 of the rest
/// length: the polynomial of degree five with the least largest relative error, 6.9e-5 (Remez).
/// Near rest the force loses no bits to `1 - L / |P|`, a difference of nearly equal numbers.
const SERIES: [f32; 6] = [
    0.500_034_34,
    -0.375_066_2,
    0.308_711_3,
    -0.269_025_4,
    0.306_003_86,
    -0.286_138_48,
];

/// Largest `e²` for which the polynomial holds.
const FARTHEST_SQUARED: f32 = 0.16;

/// Below this squared share of its rest length a spring has no direction.
const DEGENERATE_SHARE: f32 = 1.0e-12;

/// All springs of one family.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spring {
    /// `1 / L²` [1/m²].
    inv_squared: f32,
    /// `k` [N/m].
    stiffness: f32,
}

/// How far springs are stretched: `e = |P|² / L² - 1`, 0 at rest, and its square.
#[derive(Clone, Copy)]
pub(super) struct Stretch<S: Simd> {
    e: f32x16<S>,
    squared: f32x16<S>,
}

impl Spring {
    /// Springs of a squared rest length [m²] and a stiffness [N/m].
    #[expect(
        clippy::cast_possible_truncation,
        reason = "worked out in f64 and used in f32"
    )]
    pub(super) fn new(rest_squared: f64, stiffness: f64) -> Self {
        Self {
            inv_squared: (1.0 / rest_squared) as f32,
            stiffness: stiffness as f32,
        }
    }

    /// `k` [N/m].
    pub(super) const fn stiffness(&self) -> f32 {
        self.stiffness
    }

    /// How far springs of the squared lengths `squared` [m²] are stretched.
    #[inline(always)]
    pub(super) fn stretch<S: Simd>(&self, squared: f32x16<S>) -> Stretch<S> {
        let e = squared * self.inv_squared - 1.0;
        Stretch { e, squared: e * e }
    }

    /// `k (1 - L / |P|)` [N/m] by the polynomial.
    #[inline(always)]
    pub(super) fn factor<S: Simd>(&self, Stretch { e, squared }: Stretch<S>) -> f32x16<S> {
        let [c0, c1, c2, c3, c4, c5] = SERIES;
        let (low, middle, high) = (e * c1 + c0, e * c3 + c2, e * c5 + c4);
        (e * self.stiffness) * (low + squared * (middle + squared * high))
    }

    /// `k (1 - L / |P|)` [N/m] by root and quotient in lanes where the polynomial does not hold; `factor` in
    /// others.
    #[inline(always)]
    pub(super) fn exact_where_far<S: Simd>(
        &self,
        simd: S,
        factor: f32x16<S>,
        stretch: Stretch<S>,
    ) -> f32x16<S> {
        let floor = f32x16::splat(simd, DEGENERATE_SHARE);
        let one = f32x16::splat(simd, 1.0);
        let share = larger(stretch.e + 1.0, floor);
        let exact = (one - one / share.sqrt()) * self.stiffness;
        f32x16::splat(simd, FARTHEST_SQUARED)
            .simd_lt(stretch.squared)
            .select(exact, factor)
    }
}

impl Spring {
    /// Force [N] on the near end of springs with this offset to the far end.
    #[inline(always)]
    pub(super) fn force<S: Simd>(&self, simd: S, offset: Vectors<S>) -> Vectors<S> {
        let stretch = self.stretch(offset.dot(offset));
        let mut factor = self.factor(stretch);
        if stretch.any_far(simd) {
            factor = self.exact_where_far(simd, factor, stretch);
        }
        offset.scale(factor)
    }
}

impl<S: Simd> Stretch<S> {
    /// The larger square of the two.
    #[inline(always)]
    pub(super) fn farther(self, other: Self) -> Self {
        Self {
            squared: larger(self.squared, other.squared),
            ..self
        }
    }

    /// Whether any of these is beyond the polynomial's range.
    #[inline(always)]
    pub(super) fn any_far(self, simd: S) -> bool {
        f32x16::splat(simd, FARTHEST_SQUARED)
            .simd_lt(self.squared)
            .any_true()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fearless_simd::{Level, dispatch};

    fn force(length: f32) -> f32 {
        let spring = Spring::new(1.0, 1.0);
        dispatch!(Level::baseline(), simd => {
            let stretch = spring.stretch(f32x16::splat(simd, length * length));
            let factor = spring.factor(stretch);
            length * spring.exact_where_far(simd, factor, stretch).to_array()[0]
        })
    }

    #[test]
    fn a_spring_pulls_by_hooke_whatever_its_length() {
        for thousandth in (50..4000_i16).filter(|&length| length != 1000) {
            let length = f32::from(thousandth) / 1000.0;
            let error = force(length) / (length - 1.0) - 1.0;
            // Next to its rest length the length itself is only known to so many bits.
            let rounding = 3e-7 / (length - 1.0).abs();
            assert!(error.abs() < 9e-5 + rounding, "{length}: {error}");
        }
        assert!(force(1.0).abs() < 1e-7);
        assert!(force(0.0).is_finite());
    }
}
