//! A strip without bending stiffness swings like a hanging chain.

use glam::DVec3;
use lole_cloth::BuildError;

use super::Check;
use super::beam::{Strip, middle, weight};
use super::rig::{FRAME, GRAVITY, Rig, Subject};

/// `ω sqrt(L / g)` of the slowest modes: half the zeros of the Bessel function `J0`.
const FREQUENCIES: [f64; 3] = [1.202_413, 2.760_039, 4.326_864];
/// Length [m] and segments.
const LENGTH: f64 = 0.6;
const SEGMENTS: u32 = 40;
/// First displacement of the tip over the length: small, so that the chain swings linearly.
const AMPLITUDE: f64 = 0.01;
/// Swings that are timed.
const SWINGS: usize = 6;

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    let strip = Strip {
        length: LENGTH,
        segments: SEGMENTS,
        stretch: 1.0e4 * weight() * LENGTH,
        bend: 0.0,
        drag: 0.0,
        friction: 0.0,
    };
    (1..)
        .zip(FREQUENCIES)
        .map(|(number, frequency)| {
            let start = strip.laid(|along| {
                let shape = mode(frequency, along / LENGTH);
                DVec3::new(AMPLITUDE / f64::from(number) * LENGTH * shape, -along, 0.0)
            });
            let mut rig = Rig::new(subject, &strip.spec(&[0]), &start)?;
            let reference = std::f64::consts::TAU / frequency * (LENGTH / GRAVITY).sqrt();
            let gate = subject.gate([1.0, 2.0]);
            let found = [period(&mut rig, frequency), reference];
            Ok(Check::new(format!("mode {number}"), found, gate).unit("s"))
        })
        .collect()
}

/// Displacement of the mode of this frequency at the share `along` of the length from the top: `J0` of twice
/// the frequency times the root of the share below.
fn mode(frequency: f64, along: f64) -> f64 {
    let quarter = frequency * frequency * (1.0 - along).max(0.0);
    let (mut term, mut sum) = (1.0, 1.0);
    for order in 1..40 {
        let order = f64::from(order);
        term *= -quarter / (order * order);
        sum += term;
    }
    sum
}

/// Mean time of a swing there and back [s], from where the motion along the mode changes sign.
fn period(rig: &mut Rig, frequency: f64) -> f64 {
    let mut crossings: Vec<f64> = Vec::new();
    let mut before = along_mode(rig, frequency);
    let mut time = 0.0;
    while crossings.len() < 2 * SWINGS + 1 && time < 60.0 {
        rig.advance();
        let now = along_mode(rig, frequency);
        if (before < 0.0) != (now < 0.0) {
            crossings.push(time + FRAME * before / (before - now));
        }
        before = now;
        time += FRAME;
    }
    match (crossings.first(), crossings.last()) {
        (Some(first), Some(last)) if 1 < crossings.len() => {
            2.0 * (last - first) / (crossings.len() - 1) as f64
        }
        _ => f64::NAN,
    }
}

/// How far the strip is displaced along the mode: other modes are at right angles to it.
fn along_mode(rig: &Rig, frequency: f64) -> f64 {
    let positions = rig.positions();
    (0..=SEGMENTS)
        .map(|row| {
            let share = f64::from(row) / f64::from(SEGMENTS);
            let weight = if row == SEGMENTS { 0.5 } else { 1.0 };
            weight * mode(frequency, share) * middle(&positions, row).x
        })
        .sum()
}
