//! The largest stable step of each method: in theory, and on the skirt by its highest mode.

use std::num::NonZeroU32;

use lole_cloth::method::explicit::{HighestMode, Integrator, stability_limit};
use lole_cloth::method::reference::ReferenceModel;
use lole_cloth::{BuildError, Topology};
use lole_export::study::{SkirtOfStudy, Threshold};
use lole_stage::Performance;

use super::methods::Method;
use crate::StudyError;

/// Damping over frequency at which limits are measured: small, as the formulas want it, and large
/// enough for growth to show within seconds.
const DAMPING_RATIO: f64 = 0.05;
/// Power iterations for the highest mode.
const ITERATIONS: u32 = 1500;
/// Where the measured limit is sought, around the one in theory.
const BRACKET: [f64; 2] = [0.9, 1.1];
/// Halvings of the bracket: to 0.2 %.
const HALVINGS: u32 = 7;
/// Displacement of the mode [m]: in the linear range by far.
const DISPLACEMENT: f64 = 1.0e-9;

/// The skirt's cloth lying flat, its seam open, with another damping [1/s]: a tube bends, and would
/// not lie still.
fn flat_model(settled: &Performance, drag_rate: f64) -> Result<ReferenceModel, BuildError> {
    let mut spec = settled.production().garments[0].sewn.spec.clone();
    spec.grid.topology = Topology::Sheet;
    #[expect(clippy::cast_possible_truncation, reason = "fabrics hold drag in f32")]
    let drag = drag_rate as f32;
    spec.fabric.drag_rate = drag;
    ReferenceModel::new(&spec)
}

/// The highest mode of the skirt's cloth lying flat, and the skirt in numbers.
pub(super) fn highest_mode(
    settled: &Performance,
) -> Result<(HighestMode, SkirtOfStudy), StudyError> {
    let (model, _) = settled.explicit().ok_or(StudyError::NotOfThePaper)?;
    let flat = flat_model(settled, model.drag_rate())?;
    let mode = HighestMode::of(&flat, &flat.rest_positions(), ITERATIONS);
    let skirt = SkirtOfStudy {
        particles: model.masses().len(),
        springs: model.spring_count(),
        damping_per_s: model.drag_rate(),
        highest_frequency_rad_per_s: mode.frequency,
    };
    Ok((mode, skirt))
}

/// The limit of one method.
pub(super) fn measure(
    settled: &Performance,
    mode: &HighestMode,
    method: &Method,
) -> Result<Threshold, BuildError> {
    let integrator = method.integrator();
    let drag_rate = DAMPING_RATIO * mode.frequency;
    let theory = stability_limit(integrator, mode.frequency, drag_rate);
    let model = flat_model(settled, drag_rate)?;
    // Near the limit the first-order methods grow by millionths a step, the others by hundredths.
    let count = match integrator {
        Integrator::Euler => 4000,
        Integrator::FbEuler => 200,
        Integrator::RungeKutta(_) if method.order[1] > 1 => 100,
        Integrator::RungeKutta(_) => 1500,
    };
    let count = NonZeroU32::new(count).unwrap_or(NonZeroU32::MIN);
    let measured = theory.map(|limit| {
        let [mut stable, mut growing] = BRACKET.map(|share| share * limit);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (stable + growing);
            let growth = mode.growth(&model, integrator, [middle, DISPLACEMENT], count);
            if growth > 0.0 {
                growing = middle;
            } else {
                stable = middle;
            }
        }
        0.5 * (stable + growing)
    });
    Ok(Threshold {
        damping_ratio: DAMPING_RATIO,
        formula: method.formula.to_owned(),
        theory: theory.map(|limit| limit * mode.frequency),
        measured: measured.map(|limit| limit * mode.frequency),
    })
}
