//! One particle on a spring hardly stretched: the pendulum, whose period grows with its amplitude.

use std::num::NonZeroU32;

use glam::DVec3;
use lole_cloth::BuildError;
use lole_geom::trig64;

use super::Check;
use super::beam::{Strip, middle, weight};
use super::rig::{FRAME, GRAVITY, Rig, Subject};

/// Amplitude in degrees, and the period over that of a small swing: `2 K(sin(α / 2)) / π`.
const PERIODS: [(f64, f64); 4] = [
    (10.0, 1.001_907),
    (30.0, 1.017_409),
    (60.0, 1.073_182),
    (90.0, 1.180_341),
];
/// Length [m].
const LENGTH: f64 = 0.5;
/// By how much the weight stretches the spring, over its length.
const STRETCHED: f64 = 1.0e-4;
/// Half swings that are timed: few, because the real-time method loses amplitude.
const HALF_SWINGS: usize = 2;
/// Substeps of the real-time method.
const SUBSTEPS: NonZeroU32 = NonZeroU32::MIN.saturating_add(39);

/// The period over that of a small swing, by amplitude in degrees: `1 / M(1, cos(α / 2))` with the
/// arithmetic-geometric mean `M`.
pub(super) fn points() -> Vec<[f64; 2]> {
    (0..=90_u8)
        .map(|degrees| {
            let amplitude = f64::from(degrees);
            let mut means = [1.0, trig64::cos(0.5 * amplitude.to_radians())];
            for _ in 0..6 {
                let [a, b] = means;
                means = [0.5 * (a + b), (a * b).sqrt()];
            }
            [amplitude, 1.0 / means[0]]
        })
        .collect()
}

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    PERIODS
        .iter()
        .map(|&(amplitude, reference)| {
            let found = period(subject, amplitude.to_radians())?;
            let small = std::f64::consts::TAU * (LENGTH / GRAVITY).sqrt();
            let case = format!("{amplitude}°");
            Ok(
                Check::new(case, [found / small, reference], subject.gate([0.2, 1.0]))
                    .along(amplitude),
            )
        })
        .collect()
}

/// Mean time of a swing there and back [s].
fn period(subject: Subject, amplitude: f64) -> Result<f64, BuildError> {
    let strip = Strip {
        length: 2.0 * LENGTH,
        segments: 2,
        stretch: weight() * LENGTH / STRETCHED,
        bend: 0.0,
        drag: 0.0,
        friction: 0.0,
    };
    let (sin, cos) = trig64::sin_cos(amplitude);
    // The first two rows are held; the last hangs from the second.
    let start = strip.laid(|along| {
        let free = along - LENGTH;
        if free <= 0.0 {
            DVec3::NEG_Y * free
        } else {
            DVec3::new(sin, -cos, 0.0) * free
        }
    });
    let mut rig = Rig::new(subject, &strip.spec(&[0, 1]), &start)?.with_substeps(SUBSTEPS);
    let aside = |rig: &Rig| middle(&rig.positions(), 2).x;
    let mut before = aside(&rig);
    let mut crossings = Vec::new();
    let mut time = 0.0;
    while crossings.len() <= HALF_SWINGS && time < 20.0 {
        rig.advance();
        let now = aside(&rig);
        if (before < 0.0) != (now < 0.0) {
            crossings.push(time + FRAME * before / (before - now));
        }
        (before, time) = (now, time + FRAME);
    }
    let [Some(first), Some(last)] = [crossings.first(), crossings.get(HALF_SWINGS)] else {
        return Ok(f64::NAN);
    };
    Ok(2.0 * (last - first) / HALF_SWINGS as f64)
}
