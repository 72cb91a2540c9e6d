//! A strip that stands upright in a clamp: beyond a certain length it falls over.

use glam::DVec3;
use lole_cloth::BuildError;

use super::Check;
use super::beam::{Strip, middle, weight};
use super::rig::{Rig, Subject};

/// `Γ = w L³ / B` at which an upright clamped strip buckles, after Greenhill.
const CRITICAL: f64 = 7.8373;
/// Free length [m].
const LENGTH: f64 = 0.2;
/// Segments for the reference, and for the real-time method: eight cells on a bending length, as in
/// the cantilever.
const SEGMENTS: [u32; 2] = [40, 16];
/// First displacement of the tip over the length.
const SEED: f64 = 1.0e-3;
/// Drag [1/s], and frames it is watched.
const DRAG: f64 = 2.0;
const WATCH: u32 = 420;
/// Where the critical value is sought, over the true one, and how often the bracket is halved.
const BRACKET: [f64; 2] = [0.85, 1.15];
const HALVINGS: u32 = 5;

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    let [mut stands, mut falls] = BRACKET.map(|share| share * CRITICAL);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (stands + falls);
        if falls_over(subject, middle)? {
            falls = middle;
        } else {
            stands = middle;
        }
    }
    let found = 0.5 * (stands + falls);
    let gate = 3.0;
    Ok(vec![Check::new("Γ", [found, CRITICAL], gate)])
}

/// Whether a small lean grows.
fn falls_over(subject: Subject, gamma: f64) -> Result<bool, BuildError> {
    let segments = match subject {
        Subject::FbEuler => SEGMENTS[0],
        Subject::Xpbd => SEGMENTS[1],
    };
    let spacing = LENGTH / f64::from(segments);
    let strip = Strip {
        length: LENGTH + spacing,
        segments: segments + 1,
        stretch: weight() * LENGTH / 2.5e-4,
        bend: weight() * LENGTH * LENGTH * LENGTH / gamma,
        drag: DRAG,
        friction: 0.0,
    };
    let start = strip.laid(|along| {
        let free = (along - spacing).max(0.0) / LENGTH;
        DVec3::new(SEED * LENGTH * free * free, along - spacing, 0.0)
    });
    let mut rig = Rig::new(subject, &strip.spec(&[0, 1]), &start)?;
    rig.settle(WATCH);
    let lean = middle(&rig.positions(), strip.segments).x.abs();
    Ok(SEED * LENGTH < lean)
}
