//! How far a stretched spring pulls its ends together, without a division or a square root.

use fearless_simd::{Simd, f32x16};

use crate::lanes::{larger, smaller};

/// Coefficients of `e`, `e²` and `e³` in what stands for `1 - L / length = 1 - (1 + e)^-½`, with
/// `e = length² / L² - 1`. The first two are Taylor's; the third is chosen so that the cubic meets
/// the curve again where a spring is stretched by 41 % (`e = 1`). Between 18 % of compression and
/// 41 % of stretch it is within 5 % of the curve; a collapsed spring is pushed apart more gently.
const CUBIC: [f64; 3] = [0.5, -0.375, 0.168];

/// Stretched further than this, `length² / L²`, a spring pulls like one that is stretched so far.
const FARTHEST: f32 = 2.0;

/// A family of springs that share rest length and masses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pull {
    /// Of `1`, `q`, `q²` and `q³`, with `q` the squared length [m²].
    coefficients: [f32; 4],
    /// Largest `q` that counts [m²].
    farthest: f32,
    /// Squared rest length [m²].
    rest: f32,
}

impl Pull {
    /// Springs of a squared rest length [m²].
    #[expect(
        clippy::cast_possible_truncation,
        reason = "coefficients are worked out in f64 and used in f32"
    )]
    pub(crate) const fn new(rest_length_squared: f32) -> Self {
        let [a, b, c] = CUBIC;
        let s = 1.0 / rest_length_squared as f64;
        Self {
            coefficients: [
                (-a + b - c) as f32,
                (s * (a - 2.0 * b + 3.0 * c)) as f32,
                (s * s * (b - 3.0 * c)) as f32,
                (s * s * s * c) as f32,
            ],
            farthest: FARTHEST * rest_length_squared,
            rest: rest_length_squared,
        }
    }

    /// These springs with `share` of their pull: what one end takes of it.
    #[inline(always)]
    pub(crate) const fn shared(self, share: f32) -> Self {
        let [k0, k1, k2, k3] = self.coefficients;
        Self {
            coefficients: [k0 * share, k1 * share, k2 * share, k3 * share],
            ..self
        }
    }

    /// Share of the offset between the ends, of this squared length [m²], by which one of them moves towards
    /// the other.
    #[inline(always)]
    pub(crate) fn factor<S: Simd>(&self, simd: S, squared: f32x16<S>) -> f32x16<S> {
        use fearless_simd::SimdBase as _;
        let q = smaller(squared, f32x16::splat(simd, self.farthest));
        let [k0, k1, k2, k3] = self.coefficients;
        ((q * k3 + k2) * q + k1) * q + k0
    }

    /// Share of the offset between the ends by which one of them moves towards the other where springs only
    /// pull: 0 where they are shorter than at rest.
    #[inline(always)]
    pub(crate) fn taut_factor<S: Simd>(&self, simd: S, squared: f32x16<S>) -> f32x16<S> {
        use fearless_simd::SimdBase as _;
        larger(self.factor(simd, squared), f32x16::splat(simd, 0.0))
    }

    /// Squared rest length [m²].
    pub(crate) const fn rest_length_squared(&self) -> f32 {
        self.rest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fearless_simd::{Level, SimdBase as _, dispatch};

    fn factor(pull: Pull, squared: f32) -> f32 {
        dispatch!(Level::baseline(), simd => pull.factor(simd, f32x16::splat(simd, squared)).to_array()[0])
    }

    #[test]
    fn the_cubic_follows_the_spring_where_cloth_lives_and_never_turns_around() {
        let length = 0.0137_f32;
        let pull = Pull::new(length * length);
        let mut last = f32::NEG_INFINITY;
        for percent in -100..200_i16 {
            let strain = f32::from(percent) / 100.0;
            let stretched = length * (1.0 + strain);
            let found = factor(pull, stretched * stretched);
            let exact = strain / (1.0 + strain);
            if (-0.18..0.41).contains(&strain) {
                assert!(
                    (found - exact).abs() <= 0.05 * exact.abs() + 1e-6,
                    "{percent} %"
                );
            }
            assert!(found.is_finite() && last <= found, "{percent} %");
            last = found;
        }
    }

    #[test]
    fn a_spring_at_rest_is_left_alone() {
        for length in [0.001_f32, 0.0119, 0.35] {
            let found = factor(Pull::new(length * length), length * length);
            assert!(found.abs() < 5e-7, "{found}");
        }
    }
}
