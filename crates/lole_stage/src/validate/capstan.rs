//! A strip over half a turn of a cylinder, pulled at one end: friction multiplies its tension.

use std::num::NonZeroU32;

use glam::{DVec3, Vec3};
use lole_cloth::BuildError;
use lole_geom::{Capsule, trig64};

use super::Check;
use super::beam::{Strip, middle};
use super::rig::{FRAME, Rig, Subject};

/// Coefficients of friction.
const FRICTIONS: [f64; 4] = [0.1, 0.2, 0.3, 0.5];
/// Radius of the cylinder [m], and half the length of its axis.
const RADIUS: f64 = 0.05;
const HALF_LENGTH: f32 = 0.1;
/// Cells on the arc, and on each of the free ends.
const ARC_CELLS: u32 = 48;
const FREE_CELLS: u32 = 8;
/// Strain before the pull.
const STRAIN: f64 = 0.005;
/// Membrane stiffness [N/m].
const STIFFNESS: f64 = 25.0;
/// Speed of the pull [m/s], frames of it, and of these the last that are measured.
const PULL: f64 = 4.0e-3;
const FRAMES: u32 = 75;
const MEASURED: u32 = 15;
/// Drag [1/s].
const DRAG: f64 = 2.0;
/// Substeps of the real-time method: as many as bear the tension of such short cells.
const SUBSTEPS: NonZeroU32 = NonZeroU32::MIN.saturating_add(99);

/// `exp(μ π)`, by `μ`.
pub(super) fn points() -> Vec<[f64; 2]> {
    (0..=50_u8)
        .map(|index| {
            let friction = 0.01 * f64::from(index);
            [friction, trig64::exp(friction * std::f64::consts::PI)]
        })
        .collect()
}

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    FRICTIONS
        .iter()
        .map(|&friction| {
            let reference = trig64::exp(friction * std::f64::consts::PI);
            let found = tension_ratio(subject, friction)?;
            let case = format!("μ = {friction}");
            Ok(Check::new(case, [found, reference], 3.0).along(friction))
        })
        .collect()
}

/// Tension of the pulled end over that of the held one, while the strip slides.
fn tension_ratio(subject: Subject, friction: f64) -> Result<f64, BuildError> {
    let cell = std::f64::consts::PI * RADIUS / f64::from(ARC_CELLS);
    let segments = ARC_CELLS + 2 * FREE_CELLS;
    let strip = Strip {
        length: f64::from(segments) * cell / (1.0 + STRAIN),
        segments,
        stretch: STIFFNESS,
        bend: 0.0,
        drag: DRAG,
        friction,
    };
    let free = f64::from(FREE_CELLS) * cell;
    let start = strip.laid(|along| over_cylinder(along * (1.0 + STRAIN) - free));
    let mut rig = Rig::new(subject, &strip.spec(&[0, segments]), &start)?
        .with_gravity(DVec3::ZERO)
        .with_capsules(&[cylinder()])
        .with_substeps(SUBSTEPS);
    let mut sums = [0.0; 2];
    for frame in 0..FRAMES {
        let pull = DVec3::NEG_Y * (PULL * FRAME);
        rig.move_pins(|pin| if 0.0 < pin.x { pull } else { DVec3::ZERO });
        rig.advance();
        if FRAMES - MEASURED <= frame {
            let positions = rig.positions();
            for (sum, first) in sums.iter_mut().zip([0, segments - FREE_CELLS / 2]) {
                *sum += stretched(&strip, &positions, first);
            }
        }
    }
    Ok(sums[1] / sums[0])
}

/// By how much half of a free end is longer than at rest, from the row `first` on [m].
fn stretched(strip: &Strip, positions: &[DVec3], first: u32) -> f64 {
    let cells = FREE_CELLS / 2;
    let length = middle(positions, first).distance(middle(positions, first + cells));
    length - f64::from(cells) * strip.spacing()
}

/// The place `along` the path [m] from where it meets the cylinder: up, over, and down.
fn over_cylinder(along: f64) -> DVec3 {
    let arc = std::f64::consts::PI * RADIUS;
    if along < 0.0 {
        return DVec3::new(-RADIUS, along, 0.0);
    }
    if arc < along {
        return DVec3::new(RADIUS, arc - along, 0.0);
    }
    let (sin, cos) = trig64::sin_cos(along / RADIUS);
    DVec3::new(-cos, sin, 0.0) * RADIUS
}

#[expect(clippy::cast_possible_truncation, reason = "capsules are in f32")]
fn cylinder() -> Capsule {
    Capsule::uniform(
        Vec3::NEG_Z * HALF_LENGTH,
        Vec3::Z * HALF_LENGTH,
        RADIUS as f32,
    )
}
