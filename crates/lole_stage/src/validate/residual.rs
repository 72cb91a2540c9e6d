//! A rolled strip let go in empty space: the friction of its yarns keeps `2HB / (2 B)` of its
//! curvature, on any grid. An elastic strip unrolls until it is flat.

use glam::DVec3;
use lole_cloth::BuildError;
use lole_geom::trig64;

use super::Check;
use super::beam::{Strip, middle};
use super::rig::{Rig, Subject};

/// Length [m], and segments of the coarse and the fine strip.
const LENGTH: f64 = 0.1;
const SEGMENTS: [u32; 2] = [10, 20];
/// Bending rigidity [N·m], and the membrane stiffness [N/m] of a strip that hardly stretches.
const BEND: f64 = 2.0e-6;
const STRETCH: f64 = 50.0;
/// Curvature of the roll, and those that friction keeps [1/m].
const ROLLED: f64 = 25.0;
const RESIDUALS: [f64; 2] = [3.0, 8.0];
/// Drag in which it creeps back and does not swing past [1/s], and frames until it lies still.
const DRAG: f64 = 60.0;
const SETTLE: u32 = 420;
/// Largest curvature of a strip that is called flat [1/m].
const FLAT: f64 = 0.5;

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    let mut checks = Vec::new();
    for residual in RESIDUALS {
        for segments in SEGMENTS {
            let found = left(subject, residual, segments)?;
            let case = format!("{residual} 1/m, {segments} segments");
            let check = match subject {
                Subject::FbEuler => Check::vanishing(case, found, FLAT),
                Subject::Xpbd => Check::new(case, [found, residual], 5.0),
            };
            checks.push(check.unit("1/m"));
        }
    }
    Ok(checks)
}

/// Mean curvature [1/m] that is left of the roll.
#[expect(clippy::cast_possible_truncation, reason = "specifications are in f32")]
fn left(subject: Subject, residual: f64, segments: u32) -> Result<f64, BuildError> {
    let strip = Strip {
        length: LENGTH,
        segments,
        stretch: STRETCH,
        bend: BEND,
        drag: DRAG,
        friction: 0.0,
    };
    let mut spec = strip.spec(&[]);
    spec.fabric.hysteresis.bend[1] = (2.0 * BEND * residual) as f32;
    let start = strip.laid(|along| {
        let (sin, cos) = trig64::sin_cos(ROLLED * along);
        DVec3::new(sin, 1.0 - cos, 0.0) / ROLLED
    });
    let mut rig = Rig::new(subject, &spec, &start)?.with_gravity(DVec3::ZERO);
    rig.settle(SETTLE);
    let positions = rig.positions();
    let spacing = strip.spacing();
    let curvatures = (1..segments).map(|row| {
        let [before, here, after] = [row - 1, row, row + 1].map(|row| middle(&positions, row));
        let up = DVec3::Z.cross(after - before).normalize_or_zero();
        (before + after - 2.0 * here).dot(up) / (spacing * spacing)
    });
    Ok(curvatures.sum::<f64>() / f64::from(segments - 1))
}
