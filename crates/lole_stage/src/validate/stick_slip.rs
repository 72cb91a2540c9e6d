//! A strip clamped above a table and pushed down: it bows, and its tip sticks until the bow pushes
//! it sideways harder than friction holds.

use std::num::NonZeroU32;

use glam::{DVec3, Vec3};
use lole_cloth::BuildError;
use lole_geom::{Capsule, trig64};

use super::Check;
use super::beam::{Strip, middle, weight};
use super::rig::{FRAME, Rig, Subject};

/// Coefficient of friction, and the push over the length at which the tip slips: where the
/// sideways force at the tip of an elastica, clamped above and free to turn below, is that share of
/// the force along the strip.
const ONSETS: [(f64, f64); 3] = [(0.15, 0.0969), (0.2, 0.1549), (0.3, 0.2715)];

/// Sideways force at the tip over the force along the strip, and the push over the length, from the
/// elastica's equation, integrated by an independent program.
const ELASTICA: &[[f64; 2]] = &[
    [0.01409, 0.00100],
    [0.01648, 0.00137],
    [0.01928, 0.00187],
    [0.02256, 0.00256],
    [0.02641, 0.00350],
    [0.03092, 0.00479],
    [0.03621, 0.00655],
    [0.04244, 0.00897],
    [0.04976, 0.01226],
    [0.05841, 0.01678],
    [0.06865, 0.02295],
    [0.08083, 0.03140],
    [0.09542, 0.04295],
    [0.11306, 0.05876],
    [0.13467, 0.08038],
    [0.16165, 0.10996],
    [0.19627, 0.15043],
    [0.24265, 0.20578],
    [0.30911, 0.28150],
];

/// Free length [m] and segments.
const LENGTH: f64 = 0.2;
const SEGMENTS: u32 = 20;
/// `w L³ / B`: there is no gravity, but the weight measures the stiffness.
const GAMMA: f64 = 20.0;
/// By how much the force that buckles the strip shortens it before, over its length.
const SHORTENED: f64 = 1.0e-3;
/// `N L² / B` at which it buckles.
const BUCKLING: f64 = 20.19;
/// The push over the length at the start: the strip is bowed already, as the linear theory has it,
/// so that it does not snap.
const START: f64 = 0.01;
/// Speed of the push [lengths/s].
const PUSH: f64 = 0.06;
/// Frames until it presses evenly.
const SETTLE: u32 = 60;
/// Sideways way of the tip over the length at which it has slipped.
const SLIPPED: f64 = 2.0e-4;
/// Farthest push over the onset.
const FARTHEST: f64 = 1.2;
/// Drag [1/s].
const DRAG: f64 = 3.0;
/// Radius of the table [m], a cylinder along the way of the tip, and half the length of its axis.
const RADIUS: f32 = 1.0;
const HALF_LENGTH: f32 = 1.0;
/// Substeps of the real-time method.
const SUBSTEPS: NonZeroU32 = NonZeroU32::MIN.saturating_add(119);

/// The push over the length, by the sideways force at the tip over the force along the strip.
pub(super) fn points() -> Vec<[f64; 2]> {
    ELASTICA.to_vec()
}

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    ONSETS
        .iter()
        .map(|&(friction, reference)| {
            let found = onset(subject, friction, reference)?;
            let case = format!("μ = {friction}");
            Ok(Check::new(case, [found, reference], 5.0).along(friction))
        })
        .collect()
}

/// The push over the length at which the tip slips; not a number where it does not.
fn onset(subject: Subject, friction: f64, reference: f64) -> Result<f64, BuildError> {
    let spacing = LENGTH / f64::from(SEGMENTS);
    let bend = weight() * LENGTH * LENGTH * LENGTH / GAMMA;
    let strip = Strip {
        // One row more lies in the clamp.
        length: LENGTH + spacing,
        segments: SEGMENTS + 1,
        stretch: BUCKLING * bend / (LENGTH * LENGTH * SHORTENED),
        bend,
        drag: DRAG,
        friction,
    };
    let start = bowed(&strip);
    let mut rig = Rig::new(subject, &strip.spec(&[0, 1]), &start)?
        .with_gravity(DVec3::ZERO)
        .with_capsules(&[table()])
        .with_substeps(SUBSTEPS);
    rig.settle(SETTLE);
    let first = middle(&rig.positions(), strip.segments).x;
    let mut pushed = START;
    while pushed < FARTHEST * reference {
        rig.move_pins(|_| DVec3::NEG_Y * (PUSH * LENGTH * FRAME));
        rig.advance();
        pushed += PUSH * FRAME;
        let tip = middle(&rig.positions(), strip.segments).x;
        if SLIPPED * LENGTH < (tip - first).abs() {
            return Ok(pushed);
        }
    }
    Ok(f64::NAN)
}

/// The strip in the shape in which a strip, clamped above and free to turn below, buckles, its tip
/// on the table: `y = sin(k x) - k x + k (1 - cos(k x))` with `tan k = k`, for the length 1.
fn bowed(strip: &Strip) -> Vec<DVec3> {
    const WAVE: f64 = 4.493_409_5;
    let slope = |share: f64| {
        let (sin, cos) = trig64::sin_cos(WAVE * share);
        WAVE * (cos - 1.0 + WAVE * sin)
    };
    let middles = |row: u32| slope((f64::from(row) + 0.5) / f64::from(SEGMENTS));
    let mean_square =
        (0..SEGMENTS).map(|row| middles(row).powi(2)).sum::<f64>() / f64::from(SEGMENTS);
    let size = (2.0 * START / mean_square).sqrt();
    let cell = strip.spacing() * (1.0 - SHORTENED);
    let places = |lean: f64| {
        let mut place = DVec3::ZERO;
        let mut places = vec![DVec3::Y * strip.spacing(), place];
        for row in 0..SEGMENTS {
            let slope = size * middles(row) + lean;
            place += DVec3::new(slope, -1.0, 0.0).normalize_or_zero() * cell;
            places.push(place);
        }
        (places, place)
    };
    // The linear shape leaves the tip a little to the side.
    let (_, aside) = places(0.0);
    let (places, tip) = places(-aside.x / LENGTH);
    strip.laid(|along| {
        let row = (along / strip.spacing()).round();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a row of the strip"
        )]
        let row = row as usize;
        places[row] - DVec3::Y * tip.y
    })
}

/// The table, its crest below the middle column.
#[expect(clippy::cast_possible_truncation, reason = "capsules are in f32")]
fn table() -> Capsule {
    let half = 0.5 * (super::beam::COLUMNS - 1) as f32 * (LENGTH / f64::from(SEGMENTS)) as f32;
    let center = Vec3::new(0.0, -RADIUS, half);
    let axis = Vec3::X * HALF_LENGTH;
    Capsule::uniform(center - axis, center + axis, RADIUS)
}
