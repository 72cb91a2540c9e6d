//! The shape of one gather: a sine-generated curve, the curve a strip takes when it is pushed
//! together lengthwise and bends as evenly as it can (Langbein and Leopold 1966, for meanders).

use lole_geom::trig;

/// Points along one fold that are integrated; the cloth has about a dozen particles a fold.
pub(super) const SAMPLE_COUNT: usize = 64;
/// Past this swing [rad] neighboring loops of the curve would touch.
pub(super) const LARGEST_SWING: f32 = 2.15;

/// One period of a fold that fills a unit of ring, tabulated evenly over its cloth.
#[derive(Debug, Clone)]
pub(super) struct FoldCurve {
    /// Place along the ring, from 0; the next fold starts at 1. Shape `[SAMPLE_COUNT]`.
    pub(super) along: [f32; SAMPLE_COUNT],
    /// Place across the ring, from 0 at the inner turn. Shape `[SAMPLE_COUNT]`.
    pub(super) outward: [f32; SAMPLE_COUNT],
}

impl FoldCurve {
    /// The fold whose direction swings as `swing · sin 2πt` [rad], `t` in `0..1` over its cloth.
    /// It holds `1 / J₀(swing)` of cloth; a swing of 0 is a straight line.
    #[must_use]
    pub(super) fn new(swing: f32) -> Self {
        let (mut along, mut outward) = ([0.0; SAMPLE_COUNT], [0.0; SAMPLE_COUNT]);
        let (mut x, mut y) = (0.0, 0.0);
        for index in 0..SAMPLE_COUNT {
            along[index] = x;
            outward[index] = y;
            let middle = (index as f32 + 0.5) / SAMPLE_COUNT as f32;
            let direction = swing * trig::sin(std::f32::consts::TAU * middle);
            let (sin, cos) = trig::sin_cos(direction);
            x += cos;
            y += sin;
        }
        for value in along.iter_mut().chain(&mut outward) {
            *value /= x;
        }
        Self { along, outward }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn length(curve: &FoldCurve) -> f32 {
        let point = |index: usize| match index {
            SAMPLE_COUNT => (1.0, curve.outward[0]),
            _ => (curve.along[index], curve.outward[index]),
        };
        (0..SAMPLE_COUNT)
            .map(|index| {
                let (a, b) = (point(index), point(index + 1));
                ((b.0 - a.0).powi(2) + (b.1 - a.1).powi(2)).sqrt()
            })
            .sum()
    }

    #[test]
    fn a_fold_holds_the_inverse_of_the_bessel_function_of_its_swing() {
        // J₀: Abramowitz and Stegun, table 9.1.
        for (swing, bessel) in [(0.0, 1.0), (1.0, 0.765_197_7), (2.0, 0.223_890_78)] {
            let held = length(&FoldCurve::new(swing));
            assert!((held * bessel - 1.0).abs() < 1e-3, "swing {swing}: {held}");
        }
    }

    #[test]
    fn a_fold_returns_to_the_ring() {
        for swing in [0.3, 1.2, 2.1] {
            let curve = FoldCurve::new(swing);
            let lowest = curve.outward.iter().copied().fold(f32::MAX, f32::min);
            assert!(lowest.abs() < 1e-5 && curve.outward[SAMPLE_COUNT - 1] < 0.2);
        }
    }
}
