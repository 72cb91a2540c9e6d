//! The shape of one gather: a sine-generated curve, the curve a strip takes when it is pushed
//! together lengthwise and bends as evenly as it can (Langbein and Leopold 1966, for meanders).

use lole_geom::trig;

/// Points along one fold that are integrated; the cloth has about a dozen particles a fold.
const SAMPLE_COUNT: usize = 256;
/// Past this swing [rad] neighboring loops of the curve would touch.
const LARGEST_SWING: f32 = 2.1;

/// One period of a fold, tabulated over its cloth length.
#[derive(Debug, Clone)]
pub(super) struct FoldCurve {
    /// Sideways place [m] minus what an even advance would give, shape `[SAMPLE_COUNT]`.
    sideways: Vec<f32>,
    /// Place across the fold [m], from 0 at the inner turn, shape `[SAMPLE_COUNT]`.
    outward: Vec<f32>,
    depth: f32,
}

impl FoldCurve {
    /// The fold that lays `cloth_length` [m] of cloth into `pitch` [m] of ring.
    ///
    /// The direction of the cloth swings as `ω sin 2πt`, where the Bessel function `J₀(ω)` equals
    /// `pitch / cloth_length`. A pitch of at least the cloth length gives a straight line.
    #[must_use]
    pub(super) fn new(cloth_length: f32, pitch: f32) -> Self {
        let swing = swing_for_ratio(pitch / cloth_length);
        let step = cloth_length / SAMPLE_COUNT as f32;
        let (mut sideways, mut outward) = (Vec::new(), Vec::new());
        let (mut along, mut across) = (0.0, 0.0);
        for index in 0..SAMPLE_COUNT {
            sideways.push(along);
            outward.push(across);
            let middle = (index as f32 + 0.5) / SAMPLE_COUNT as f32;
            let direction = swing * trig::sin(std::f32::consts::TAU * middle);
            along += step * trig::cos(direction);
            across += step * trig::sin(direction);
        }
        for (index, place) in sideways.iter_mut().enumerate() {
            *place -= along * index as f32 / SAMPLE_COUNT as f32;
        }
        let depth = outward.iter().copied().fold(0.0, f32::max);
        Self {
            sideways,
            outward,
            depth,
        }
    }

    /// Distance from the inner to the outer turn [m].
    #[must_use]
    pub(super) const fn depth(&self) -> f32 {
        self.depth
    }

    /// `(sideways, outward)` [m] at `phase` (1 is one fold): how far the cloth lies from an even
    /// advance along the ring, and how far outside the inner turns.
    #[must_use]
    pub(super) fn at(&self, phase: f32) -> (f32, f32) {
        let place = (phase - phase.floor()) * SAMPLE_COUNT as f32;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and the sample count"
        )]
        let index = (place as usize).min(SAMPLE_COUNT - 1);
        let next = (index + 1) % SAMPLE_COUNT;
        let fraction = place - index as f32;
        let mix = |column: &[f32]| column[index] * (1.0 - fraction) + column[next] * fraction;
        (mix(&self.sideways), mix(&self.outward))
    }
}

/// The swing `ω` [rad] with `J₀(ω) = ratio`, by bisection; 0 for ratios of 1 and more.
fn swing_for_ratio(ratio: f32) -> f32 {
    let (mut low, mut high) = (0.0, LARGEST_SWING);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if bessel_j0(middle) < ratio {
            high = middle;
        } else {
            low = middle;
        }
    }
    if 1.0 <= ratio {
        0.0
    } else {
        0.5 * (low + high)
    }
}

/// `J₀(x) = 1/π ∫₀^π cos(x sin θ) dθ`, by the midpoint rule (exponentially accurate here).
fn bessel_j0(x: f32) -> f32 {
    let count = 64_i16;
    let mean = |index: i16| {
        let theta = std::f32::consts::PI * (f32::from(index) + 0.5) / f32::from(count);
        trig::cos(x * trig::sin(theta))
    };
    (0..count).map(mean).sum::<f32>() / f32::from(count)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bessel_function_has_its_known_values() {
        // Abramowitz and Stegun, table 9.1.
        for (x, value) in [(0.0, 1.0), (1.0, 0.765_197_7), (2.0, 0.223_890_78)] {
            assert!((bessel_j0(x) - value).abs() < 1e-6);
        }
    }

    #[test]
    fn a_fold_keeps_the_length_of_its_cloth() {
        for ratio in [1.2, 2.0, 4.0] {
            let (cloth, pitch) = (0.06, 0.06 / ratio);
            let curve = FoldCurve::new(cloth, pitch);
            let count = 1000_i16;
            let point = |index: i16| {
                let phase = f32::from(index) / f32::from(count);
                let (sideways, outward) = curve.at(phase);
                (pitch * phase + sideways, outward)
            };
            let length: f32 = (0..count)
                .map(|i| {
                    let (a, b) = (point(i), point(i + 1));
                    let wrapped = if i + 1 == count {
                        pitch + curve.at(0.0).0
                    } else {
                        b.0
                    };
                    ((wrapped - a.0).powi(2) + (b.1 - a.1).powi(2)).sqrt()
                })
                .sum();
            assert!(
                (length / cloth - 1.0).abs() < 2e-3,
                "ratio {ratio}: {length}"
            );
            assert!(curve.at(0.0).1.abs() < 1e-6);
        }
    }

    #[test]
    fn cloth_that_is_not_gathered_lies_straight() {
        let curve = FoldCurve::new(0.02, 0.02);
        assert!(curve.depth() < 1e-6);
    }
}
