//! Round specimens of ten measured fabrics on a disc, after BS 5058: the drape coefficient and the folds,
//! against the rests of a plate that was made in another way ([`super::equilibrium`]).
//!
//! Weight, stretch, shear and bending at 0, 45 and 90 degrees are those that Wang, O'Brien and Ramamoorthi
//! measured (2011, "Data-Driven Elastic Models for Cloth": the samples nearest to rest). They measured no drape
//! coefficient, and of one piece of cloth it differs from time to time by several points (Kenkare and others
//! 2008), so what a plate of these figures does is what an elastic cloth can be held to.

use lole_cloth::BuildError;
use lole_cloth::drape_test::{Hung, RoundDrape};
use lole_costume::fabrics::PUBLISHED;
use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};

use super::Check;
use super::equilibrium::{Rest, Sheet};
use super::rig::{GRAVITY, Subject};

/// Farthest that a coefficient may be from that of a plate with as many folds, in points.
const POINTS: f64 = 2.0;
/// Largest energy [%] by which that plate may lie above the lowest: with a fold more or less it is about the
/// same, so cloth has several rests and takes one that is near where it came from.
const ENERGY: f64 = 6.0;
/// Folds of one of which the lowest plate begins.
const CANDIDATES: std::ops::RangeInclusive<u32> = 4..=6;

/// For the real-time method: specimens are of triangles, which the reference has none of.
pub(super) fn run(_: Subject) -> Result<Vec<Check>, BuildError> {
    let mut checks = Vec::new();
    for measured in &PUBLISHED {
        let fabric = measured.fabric();
        // What is no cloth has no figures, which pass no gate.
        let nothing = Hung {
            coefficient: f32::NAN,
            folds: 0,
        };
        let found = RoundDrape::BS.hang(fabric).unwrap_or(nothing);
        let sheet = Sheet::new(RoundDrape::BS, &fabric, GRAVITY);
        let mut starts: Vec<u32> = CANDIDATES.collect();
        if !CANDIDATES.contains(&found.folds) {
            starts.push(found.folds);
        }
        let rests = starts.into_par_iter().map(|folds| sheet.rest(folds));
        let rests: Vec<Rest> = rests.collect();
        checks.extend(compared(measured.name, found, &rests));
    }
    Ok(checks)
}

/// A specimen against the plate with as many folds, and that against the lowest.
fn compared(name: &str, found: Hung, rests: &[Rest]) -> [Check; 2] {
    let alike = rests.iter().filter(|rest| rest.hung.folds == found.folds);
    let lowest = |one: &&Rest, other: &&Rest| one.energy.total_cmp(&other.energy);
    let [alike, best] = [alike.min_by(lowest), rests.iter().min_by(lowest)];
    let coefficients = [
        f64::from(found.coefficient),
        alike.map_or(f64::NAN, |rest| f64::from(rest.hung.coefficient)),
    ];
    let energies = [alike, best].map(|rest| rest.map_or(f64::NAN, |rest| 1.0e3 * rest.energy));
    let folds = [found.folds, best.map_or(0, |rest| rest.hung.folds)];
    let [own, least] = folds;
    [
        Check::new(name, coefficients.map(|share| 100.0 * share), POINTS)
            .scale(100.0)
            .unit("%"),
        Check::new(
            format!("{name}, {own} folds (lowest {least})"),
            energies,
            ENERGY,
        )
        .unit("mJ"),
    ]
}
