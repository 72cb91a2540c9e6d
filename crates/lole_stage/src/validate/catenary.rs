//! A strip held at both ends hangs as a catenary.

use glam::DVec3;
use lole_cloth::BuildError;
use lole_geom::trig64;

use super::Check;
use super::beam::{Strip, middle, weight};
use super::rig::{Rig, Subject};

/// Length over the distance of the ends, and the sag over that distance: from
/// `sinh(x) / x = L / d` with `x = d / 2a` and `sag = a (cosh(x) - 1)`.
const SAGS: [(f64, f64); 3] = [(1.1, 0.200_301), (1.25, 0.331_797), (2.0, 0.796_388)];

/// Distance of the ends [m] and segments.
const SPAN: f64 = 0.4;
const SEGMENTS: u32 = 40;
/// Stiffness over the strip's own weight, per width.
const STIFFNESS: f64 = 1.0e4;
/// Near critical damping of the slowest swing [1/s], and frames until it hangs still.
const DRAG: f64 = 12.0;
const SETTLE: u32 = 300;

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    SAGS.iter()
        .map(|&(ratio, reference)| {
            let length = ratio * SPAN;
            let strip = Strip {
                length,
                segments: SEGMENTS,
                stretch: STIFFNESS * weight() * length,
                bend: 0.0,
                drag: DRAG,
                friction: 0.0,
            };
            let mut rig = Rig::new(subject, &strip.spec(&[0, SEGMENTS]), &arc(&strip))?;
            rig.settle(SETTLE);
            let lowest = middle(&rig.positions(), SEGMENTS / 2);
            let case = format!("L / d = {ratio}");
            Ok(Check::new(case, [-lowest.y / SPAN, reference], 0.5))
        })
        .collect()
}

/// The strip as an arc of a circle over the span, unstretched: `sin φ / φ = d / L`, by bisection.
fn arc(strip: &Strip) -> Vec<DVec3> {
    let (mut low, mut high) = (1e-6, std::f64::consts::PI - 1e-6);
    for _ in 0..100 {
        let half = 0.5 * (low + high);
        if trig64::sin(half) / half > SPAN / strip.length {
            low = half;
        } else {
            high = half;
        }
    }
    let radius = 0.5 * strip.length / low;
    let depth = radius * trig64::cos(low);
    strip.laid(|along| {
        let (sin, cos) = trig64::sin_cos(along / radius - low);
        DVec3::new(0.5 * SPAN + radius * sin, depth - radius * cos, 0.0)
    })
}
