//! A strip clamped level: `Γ = w L³ / B` decides how it hangs.

use glam::DVec3;
use lole_cloth::BuildError;
use lole_geom::trig64;

use super::beam::{Strip, middle, weight};
use super::rig::{Rig, Subject};
use super::{Check, elastica};

/// `Γ` and the height over width of the free part, from `θ'' = -Γ (1 - s) cos θ`, `θ(0) = 0`,
/// `θ'(1) = 0`, integrated by an independent program.
const ELASTICA: [(f64, f64); 5] = [
    (1.0, 0.12456),
    (5.0, 0.58572),
    (8.0, 0.88433),
    (10.0, 1.06680),
    (30.0, 2.54721),
];

/// Free length [m].
const LENGTH: f64 = 0.2;
/// Segments of the free part for the reference.
const SEGMENTS: u32 = 24;
/// Cells on a bending length `(B / w)^(1/3)` for the real-time method: as many as it straightens
/// in a substep, and three times what a skirt has. Finer strips hang deeper with it.
const CELLS: f64 = 8.0;
/// Fewest segments that hang like the elastica at all.
const FEWEST: f64 = 6.0;
/// Stretch at the clamp under the strip's own weight.
const STRAIN: f64 = 2.5e-4;
/// Near critical damping of the slowest swing [1/s], and frames until it hangs still.
const DRAG: f64 = 17.0;
const SETTLE: u32 = 240;

/// The elastica's height over width, by `Γ`.
pub(super) fn points() -> Vec<[f64; 2]> {
    (0..=60_u8)
        .map(|index| {
            let gamma = 0.5 * f64::from(index);
            let [width, height] = elastica::reach(gamma);
            [gamma, height / width]
        })
        .collect()
}

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    ELASTICA
        .iter()
        .map(|&(gamma, reference)| {
            let measured = height_over_width(subject, gamma, segments(subject, gamma))?;
            let gate = subject.gate([1.0, 1.5]);
            Ok(Check::new(format!("Γ = {gamma}"), [measured, reference], gate).along(gamma))
        })
        .collect()
}

/// Height over width of a strip with so many segments.
pub(super) fn height_over_width(
    subject: Subject,
    gamma: f64,
    segments: u32,
) -> Result<f64, BuildError> {
    let spacing = LENGTH / f64::from(segments);
    // One row more lies in the clamp; its tangent is then that of the first free segment's start.
    let strip = Strip {
        length: LENGTH + spacing,
        segments: segments + 1,
        stretch: weight() * LENGTH / STRAIN,
        bend: weight() * LENGTH * LENGTH * LENGTH / gamma,
        drag: DRAG,
        friction: 0.0,
    };
    let start = strip.laid(|along| DVec3::X * (along - spacing));
    let mut rig = Rig::new(subject, &strip.spec(&[0, 1]), &start)?;
    rig.settle(SETTLE);
    let tip = middle(&rig.positions(), strip.segments);
    Ok(-tip.y / tip.x)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a few tens at most"
)]
fn segments(subject: Subject, gamma: f64) -> u32 {
    match subject {
        Subject::FbEuler => SEGMENTS,
        Subject::Xpbd => (CELLS * trig64::powf(gamma, 1.0 / 3.0)).round().max(FEWEST) as u32,
    }
}
