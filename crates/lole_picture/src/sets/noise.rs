//! Noise that repeats: what clouds, sand and leaves are made of.

use glam::Vec3;

/// A number in 0..1 for a place of a lattice.
pub(super) fn hash(x: i32, y: i32, seed: u32) -> f32 {
    let mixed = (x.cast_unsigned().wrapping_mul(0x8da6_b343))
        ^ (y.cast_unsigned().wrapping_mul(0xd816_3841))
        ^ seed.wrapping_mul(0xcb1a_b31f);
    let mixed = (mixed ^ (mixed >> 15)).wrapping_mul(0x2c1b_3c6d);
    let mixed = (mixed ^ (mixed >> 12)).wrapping_mul(0x297a_2d39);
    let [high, low, ..] = (mixed ^ (mixed >> 15)).to_be_bytes();
    f32::from(u16::from_be_bytes([high, low])) / 65_536.0
}

/// Noise of many sizes. It repeats after `period` steps of its coarsest lattice, across and down.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fractal {
    /// Steps of the coarsest lattice until it repeats.
    pub(super) period: [i32; 2],
    /// Lattices, each twice as fine and half as strong as the one before.
    pub(super) octaves: u8,
    /// Another seed is another noise.
    pub(super) seed: u32,
}

impl Fractal {
    /// The same that repeats after other steps across.
    pub(super) const fn every(self, across: i32) -> Self {
        Self {
            period: [across, self.period[1]],
            ..self
        }
    }

    /// At a place in steps of the coarsest lattice: 0 to 1, around 0.5.
    pub(super) fn at(&self, x: f32, y: f32) -> f32 {
        let [mut sum, mut all, mut strength, mut finer] = [0.0, 0.0, 1.0, 1.0_f32];
        let mut period = self.period;
        for octave in 0..self.octaves {
            let seed = self.seed + u32::from(octave) * 101;
            sum += strength * smooth_noise(x * finer, y * finer, period, seed);
            all += strength;
            strength *= 0.5;
            finer *= 2.0;
            period = period.map(|steps| steps * 2);
        }
        sum / all
    }
}

/// Between the values of a lattice, without an edge at its lines.
fn smooth_noise(x: f32, y: f32, [across, down]: [i32; 2], seed: u32) -> f32 {
    let (column, row) = (floor(x), floor(y));
    let ease = |share: f32| share * share * share * (share * (share * 6.0 - 15.0) + 10.0);
    let (right, below) = (ease(x - column as f32), ease(y - row as f32));
    let value = |dx: i32, dy: i32| {
        let (x, y) = (
            (column + dx).rem_euclid(across),
            (row + dy).rem_euclid(down),
        );
        hash(x, y, seed)
    };
    let top = value(0, 0) * (1.0 - right) + value(1, 0) * right;
    let bottom = value(0, 1) * (1.0 - right) + value(1, 1) * right;
    top * (1.0 - below) + bottom * below
}

/// The greatest whole number that is not above `x`.
#[expect(
    clippy::cast_possible_truncation,
    reason = "`as` saturates, and places of pictures are small"
)]
pub(super) fn floor(x: f32) -> i32 {
    let cut = x as i32;
    cut - i32::from(x < cut as f32)
}

/// 0 up to `low`, 1 from `high` on, smooth between.
pub(super) fn smooth_between(low: f32, high: f32, value: f32) -> f32 {
    let share = ((value - low) / (high - low)).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// A color between some, which stand at growing places.
pub(super) fn ramp(stops: &[(f32, Vec3)], at: f32) -> Vec3 {
    let Some(&(_, first)) = stops.first() else {
        return Vec3::ZERO;
    };
    let mut color = first;
    for pair in stops.windows(2) {
        let [(low, from), (high, to)] = [pair[0], pair[1]];
        if at >= low {
            color = from.lerp(to, ((at - low) / (high - low)).clamp(0.0, 1.0));
        }
    }
    color
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_repeats_and_stays_within_its_bounds() {
        let noise = Fractal {
            period: [6, 4],
            octaves: 5,
            seed: 3,
        };
        let mut all = Vec::new();
        for step in 0..500_u16 {
            let (x, y) = (f32::from(step) * 0.037, f32::from(step) * 0.053);
            let here = noise.at(x, y);
            assert!((here - noise.at(x + 6.0, y)).abs() < 1.0e-3);
            assert!((here - noise.at(x, y + 4.0)).abs() < 1.0e-3);
            assert!((0.0..=1.0).contains(&here));
            all.push(here);
        }
        let mean = all.iter().sum::<f32>() / 500.0;
        assert!((mean - 0.5).abs() < 0.1, "{mean}");
        assert!(all.iter().any(|value| *value < 0.35) && all.iter().any(|value| *value > 0.65));
    }
}
