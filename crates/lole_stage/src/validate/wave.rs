//! A pulse along a taut strip: it travels at the membrane's wave speed.

use std::num::NonZeroU32;

use glam::DVec3;
use lole_cloth::BuildError;
use lole_geom::trig64;

use super::Check;
use super::beam::{AREAL_DENSITY, Strip, middle};
use super::rig::{FRAME, Rig, Subject};

/// Length [m] and segments.
const LENGTH: f64 = 1.2;
const SEGMENTS: u32 = 240;
/// Wave speed [m/s].
const SPEED: f64 = 6.0;
/// Where the pulse starts and its width [m], and its height.
const START: f64 = 0.25;
const WIDTH: f64 = 0.05;
const HEIGHT: f64 = 2.0e-3;
/// Frames that it travels.
const TRAVEL: u32 = 7;
/// Substeps of the real-time method.
const SUBSTEPS: NonZeroU32 = NonZeroU32::MIN.saturating_add(39);

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    let strip = Strip {
        length: LENGTH,
        segments: SEGMENTS,
        stretch: SPEED * SPEED * f64::from(AREAL_DENSITY),
        bend: 0.0,
        drag: 0.0,
        friction: 0.0,
    };
    let height = |along: f64| {
        let away = (along - START) / WIDTH;
        HEIGHT * trig64::exp(-0.5 * away * away)
    };
    let start = strip.laid(|along| DVec3::X * (along - 0.5 * LENGTH + height(along)));
    // A wave that travels onward has `v = -c u'`.
    let velocities =
        strip.laid(|along| DVec3::X * (SPEED * height(along) * (along - START) / (WIDTH * WIDTH)));
    let velocities: Vec<DVec3> = velocities.iter().map(|v| DVec3::X * v.x).collect();
    let mut rig = Rig::new(subject, &strip.spec(&[0, SEGMENTS]), &start)?
        .with_gravity(DVec3::ZERO)
        .with_velocities(&velocities)
        .with_substeps(SUBSTEPS);
    let before = center(&strip, &rig);
    rig.settle(TRAVEL);
    let found = (center(&strip, &rig) - before) / (f64::from(TRAVEL) * FRAME);
    Ok(vec![Check::new("pulse", [found, SPEED], 2.0).unit("m/s")])
}

/// Where the pulse is [m]: the center of the squared displacements.
fn center(strip: &Strip, rig: &Rig) -> f64 {
    let positions = rig.positions();
    let (mut sum, mut weights) = (0.0, 0.0);
    for row in 0..=SEGMENTS {
        let along = f64::from(row) * strip.spacing();
        let displaced = middle(&positions, row).x - (along - 0.5 * LENGTH);
        sum += along * displaced * displaced;
        weights += displaced * displaced;
    }
    sum / weights
}
