//! A wind with gusts that a seed decides: eddies of many sizes that drift with the mean wind.
//!
//! `u(x, t) = U + Σ_k a_k sin 2π(q_k · (x - U t) + φ_k)`: a frozen pattern carried past the cloth
//! (Taylor 1938, "The spectrum of turbulence"), made of plane waves with random directions and
//! phases (Kraichnan 1970, "Diffusion by a random velocity field"). Every `a_k` stands at right
//! angles to its `q_k`, so no air is made or lost, and grows with the cube root of the wave's
//! length, as in Kolmogorov's inertial range.

use fearless_simd::{Simd, prelude::*};
use glam::{DVec3, Vec3};
use lole_geom::{Chance, trig64};

use crate::lanes::Vectors;

/// Plane waves: with fewer a listener hears the tune repeat.
const WAVE_COUNT: u16 = 12;

/// Longest wave [m], and the length of each next over that of the one before: from 6 m, a breath of
/// seconds, to 0.4 m, half a skirt.
const LONGEST: f64 = 6.0;
const SHORTENING: f64 = 0.78;

/// One plane wave.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Wave {
    /// `q` [1/m].
    number: DVec3,
    /// `a` [m/s].
    amplitude: Vec3,
    /// `φ`, in turns.
    phase: f64,
}

/// A wind as it is everywhere and at any time.
#[derive(Debug, Clone, PartialEq)]
pub struct GustyWind {
    mean: Vec3,
    waves: Vec<Wave>,
}

/// A [`GustyWind`] at one moment.
#[derive(Debug, Clone, PartialEq)]
pub struct WindNow {
    mean: Vec3,
    /// `q` [1/m], `a` [m/s] and the phase in turns now.
    waves: Vec<(Vec3, Vec3, f32)>,
}

impl GustyWind {
    /// A wind that blows with `mean` [m/s] on the whole, with gusts whose root mean square in each
    /// direction is `intensity` times the mean's speed: 0 is a steady wind, 0.1 to 0.2 what blows
    /// over open land, 0.3 and more between houses. The same seed gives the same gusts.
    #[must_use]
    pub fn new(mean: Vec3, intensity: f32, seed: u64) -> Self {
        let mut dice = Dice(Chance::new(seed));
        let share = |index: u16| trig64::powf(SHORTENING, f64::from(index));
        let is_gusty = 0.0 < intensity && mean != Vec3::ZERO;
        let count = if is_gusty { WAVE_COUNT } else { 0 };
        // Each wave adds half its amplitude squared; three directions share the sum.
        let squares: f64 = (0..count)
            .map(|index| trig64::powf(share(index), 2.0 / 3.0))
            .sum();
        let rms = f64::from(intensity) * f64::from(mean.length());
        let scale = rms * (6.0 / squares.max(f64::MIN_POSITIVE)).sqrt();
        let waves = (0..count).map(|index| {
            let direction = dice.direction();
            let across = loop {
                let other = dice.direction();
                let across = other - direction * other.dot(direction);
                if 0.01 < across.length_squared() {
                    break across.normalize_or_zero();
                }
            };
            let amplitude = scale * trig64::powf(share(index), 1.0 / 3.0);
            Wave {
                number: direction / (LONGEST * share(index)),
                amplitude: (across * amplitude).as_vec3(),
                phase: dice.unit(),
            }
        });
        Self {
            mean,
            waves: waves.collect(),
        }
    }

    /// The wind at `time` [s].
    #[must_use]
    #[expect(
        clippy::cast_possible_truncation,
        reason = "what is left of a turn needs no more than f32 holds"
    )]
    pub fn at(&self, time: f64) -> WindNow {
        let waves = self.waves.iter().map(|wave| {
            let turns = wave.phase - wave.number.dot(self.mean.as_dvec3()) * time;
            let phase = (turns - turns.floor()) as f32;
            (wave.number.as_vec3(), wave.amplitude, phase)
        });
        WindNow {
            mean: self.mean,
            waves: waves.collect(),
        }
    }
}

impl WindNow {
    /// A steady wind.
    #[must_use]
    pub const fn steady(velocity: Vec3) -> Self {
        Self {
            mean: velocity,
            waves: Vec::new(),
        }
    }

    /// These gusts in another mean wind [m/s].
    #[must_use]
    pub fn with_mean(self, velocity: Vec3) -> Self {
        Self {
            mean: velocity,
            ..self
        }
    }

    /// Velocity of the air at `position` [m/s].
    #[must_use]
    pub fn velocity(&self, position: Vec3) -> Vec3 {
        let waves = self.waves.iter().map(|&(number, amplitude, phase)| {
            let turns = number.dot(position) + phase;
            amplitude * sine(turns - (turns + 0.5).floor())
        });
        waves.fold(self.mean, |sum, wave| sum + wave)
    }

    /// Velocities of the air [m/s] at sixteen positions [m].
    #[inline(always)]
    pub(super) fn velocities<S: Simd>(&self, simd: S, position: Vectors<S>) -> Vectors<S> {
        let mut sum = Vectors::splat(simd, self.mean);
        for &(number, amplitude, phase) in &self.waves {
            let turns = position.dot(Vectors::splat(simd, number)) + phase;
            let rest = turns - (turns + 0.5).floor();
            let bow = rest * 8.0 - rest * rest.abs() * 16.0;
            let sine = (bow * bow.abs() - bow) * 0.225 + bow;
            sum = sum.add(Vectors::splat(simd, amplitude).scale(sine));
        }
        sum
    }
}

/// `sin 2πx` for `x` of `-½..½` to 1e-3: two parabolas, and the same once more.
fn sine(x: f32) -> f32 {
    let bow = x * 8.0 - x * x.abs() * 16.0;
    (bow * bow.abs() - bow) * 0.225 + bow
}

/// Chance that a seed repeats.
struct Dice(Chance);

impl Dice {
    /// A number in `0..1`.
    const fn unit(&mut self) -> f64 {
        self.0.finest_share()
    }

    /// A unit vector, every direction alike.
    fn direction(&mut self) -> DVec3 {
        let height = 2.0 * self.unit() - 1.0;
        let (sin, cos) = trig64::sin_cos(std::f64::consts::TAU * self.unit());
        let radius = (1.0 - height * height).max(0.0).sqrt();
        DVec3::new(radius * cos, height, radius * sin)
    }
}
