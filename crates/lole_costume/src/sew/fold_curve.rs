//! The shape of one gather: a chain of equal links that swings like a meander and never past a right
//! angle, so that the strands of deep gathers hang side by side instead of bulging into each other.

use lole_geom::trig;

/// Sharpest swing that is laid: all but the links at the two turns stand at right angles.
pub(super) const SHARPEST: f32 = 1000.0;

/// Direction [rad] from the ring, outward positive, of link `index` of a fold of `count` links.
///
/// It is `π/2 · s / √(1 + s²)` with `s = sharpness · sin 2πt`, `t` in `0..1` along the fold: a
/// sine-generated meander (Langbein and Leopold 1966) while the fold is shallow, straight strands
/// between round turns when it is deep. What a fold holds grows with its sharpness.
pub(super) fn direction(sharpness: f32, index: usize, count: usize) -> f32 {
    let middle = (index as f32 + 0.5) / count as f32;
    let swing = sharpness * trig::sin(std::f32::consts::TAU * middle);
    std::f32::consts::FRAC_PI_2 * swing / (1.0 + swing * swing).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ring that a fold of links of unit length fills.
    fn filled(sharpness: f32, count: usize) -> f32 {
        (0..count)
            .map(|index| trig::cos(direction(sharpness, index, count)))
            .sum()
    }

    #[test]
    fn a_shallow_fold_holds_the_inverse_of_the_bessel_function_of_its_swing() {
        // J₀: Abramowitz and Stegun, table 9.1. While it is shallow, the swing is π/2 · sharpness.
        for (swing, bessel) in [(0.0, 1.0), (0.1, 0.997_501_6), (0.2, 0.990_025)] {
            let share = filled(swing / std::f32::consts::FRAC_PI_2, 100) / 100.0;
            assert!((share - bessel).abs() < 1e-3, "swing {swing}: {share}");
        }
    }

    #[test]
    fn a_sharper_fold_fills_less_of_the_ring() {
        for count in [7, 8, 10, 11] {
            let filled =
                [0.0, 0.5, 1.0, 2.0, 4.0, 8.0, SHARPEST].map(|sharpness| filled(sharpness, count));
            assert!(
                filled.windows(2).all(|pair| pair[1] < pair[0]),
                "{filled:?}"
            );
        }
    }

    #[test]
    fn a_fold_returns_to_the_ring_and_never_turns_back() {
        for (sharpness, count) in [(0.3, 7), (1.2, 8), (3.0, 10), (10.0, 11)] {
            let directions: Vec<f32> = (0..count)
                .map(|index| direction(sharpness, index, count))
                .collect();
            assert!(
                directions
                    .iter()
                    .all(|angle| angle.abs() < std::f32::consts::FRAC_PI_2)
            );
            let end: f32 = directions.iter().map(|&angle| trig::sin(angle)).sum();
            assert!(end.abs() < 1e-4, "{sharpness}: {end}");
        }
    }
}
