//! The heavy elastica: a strip clamped level that bends under its own weight.
//!
//! `θ'' = -Γ (1 - s) cos θ`, `θ(0) = 0`, `θ'(1) = 0`, with `θ` below the horizontal and `s` along
//! the strip from the clamp, both over its length.

use lole_geom::trig64;

/// Steps of the integration.
const STEPS: u32 = 400;
/// Halvings of the bracket of the slope at the tip.
const HALVINGS: u32 = 60;

/// How far out and how far down the tip hangs, over the length, for `gamma = w L³ / B` up to about
/// 500.
pub(super) fn reach(gamma: f64) -> [f64; 2] {
    let (mut low, mut high) = (0.0, std::f64::consts::FRAC_PI_2);
    for _ in 0..HALVINGS {
        let tip = 0.5 * (low + high);
        if from_tip(gamma, tip)[0] < 0.0 {
            low = tip;
        } else {
            high = tip;
        }
    }
    let [_, width, height] = from_tip(gamma, 0.5 * (low + high));
    [width, height]
}

/// Slope at the clamp, width and height of the strip whose tip has the slope `tip`, by Runge and
/// Kutta's method from the tip on: `θ(u)` with `u = 1 - s`.
fn from_tip(gamma: f64, tip: f64) -> [f64; 3] {
    let step = 1.0 / f64::from(STEPS);
    let rate = |u: f64, [slope, turning, _, _]: [f64; 4]| {
        let (sin, cos) = trig64::sin_cos(slope);
        [turning, -gamma * u * cos, cos, sin]
    };
    let moved = |state: [f64; 4], rate: [f64; 4], by: f64| {
        let mut moved = state;
        for (value, rate) in moved.iter_mut().zip(rate) {
            *value += by * rate;
        }
        moved
    };
    let mut state = [tip, 0.0, 0.0, 0.0];
    for index in 0..STEPS {
        let u = f64::from(index) * step;
        let first = rate(u, state);
        let second = rate(u + 0.5 * step, moved(state, first, 0.5 * step));
        let third = rate(u + 0.5 * step, moved(state, second, 0.5 * step));
        let last = rate(u + step, moved(state, third, step));
        for (rate, share) in [(first, 1.0), (second, 2.0), (third, 2.0), (last, 1.0)] {
            state = moved(state, rate, share * step / 6.0);
        }
    }
    [state[0], state[2], state[3]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_strip_hangs_as_an_independent_program_says() {
        for (gamma, width, height) in [
            (0.1, 0.99991, 0.01250),
            (1.0, 0.99125, 0.12347),
            (8.0, 0.72442, 0.64063),
            (20.0, 0.44523, 0.82988),
            (100.0, 0.15922, 0.93752),
        ] {
            let found = reach(gamma);
            assert!((found[0] - width).abs() < 2e-5, "Γ = {gamma}: {found:?}");
            assert!((found[1] - height).abs() < 2e-5, "Γ = {gamma}: {found:?}");
        }
    }
}
