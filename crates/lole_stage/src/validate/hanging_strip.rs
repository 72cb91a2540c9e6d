//! A strip hung from its top row: each spring carries the weight below it.

use glam::DVec3;
use lole_cloth::BuildError;
use lole_cloth::method::reference::ReferenceModel;

use super::Check;
use super::beam::{COLUMNS, Strip, middle, weight};
use super::rig::{GRAVITY, Rig, Subject};

/// Length [m] and segments.
const LENGTH: f64 = 0.6;
const SEGMENTS: u32 = 40;
/// Strains at the top under the strip's own weight.
const STRAINS: [f64; 2] = [0.005, 0.02];
/// Near critical damping of the slowest mode [1/s], and frames until it hangs still.
const DRAG: f64 = 30.0;
const SETTLE: u32 = 180;

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    STRAINS
        .into_iter()
        .map(|strain| {
            let strip = Strip {
                length: LENGTH,
                segments: SEGMENTS,
                stretch: weight() * LENGTH / strain,
                bend: 0.0,
                drag: DRAG,
                friction: 0.0,
            };
            let spec = strip.spec(&[0]);
            let start = strip.laid(|along| DVec3::NEG_Y * along);
            let mut rig = Rig::new(subject, &spec, &start)?;
            rig.settle(SETTLE);
            let tip = middle(&rig.positions(), SEGMENTS);
            let measured = 1e3 * (-tip.y - LENGTH);
            let reference = 1e3 * extension(&ReferenceModel::new(&spec)?);
            let case = format!("strain {} %", 100.0 * strain);
            let gate = subject.gate([1e-3, 1.5]);
            Ok(Check::new(case, [measured, reference], gate).unit("mm"))
        })
        .collect()
}

/// `Σ m g / k`: what every spring of the middle column carries, over its constant [m].
fn extension(model: &ReferenceModel) -> f64 {
    let stiffness = model.constants().structural_v;
    let masses = model.masses().iter().skip((COLUMNS / 2) as usize);
    let column: Vec<f64> = masses.step_by(COLUMNS as usize).copied().collect();
    (1..column.len())
        .map(|row| column[row..].iter().sum::<f64>() * GRAVITY / stiffness)
        .sum()
}
