//! A clamped strip nears the elastica with the square of the spacing.

use lole_cloth::BuildError;
use lole_geom::trig64;

use super::rig::Subject;
use super::{Check, cantilever};

/// `Γ` of the strip, and its height over width.
const GAMMA: f64 = 8.0;
const ELASTICA: f64 = 0.88433;
/// Cells of the free length: as many as each method bears.
const REFERENCE_CELLS: [u32; 4] = [5, 8, 12, 20];
const REAL_TIME_CELLS: [u32; 3] = [5, 8, 14];
/// Largest error [%] times the square of the cells: what the plate of a discrete chain has by
/// theory, and a tenth more.
const CHAIN_ERROR: f64 = 180.0;
/// Cells between which the order is measured.
const ORDER_BETWEEN: [u32; 2] = [8, 20];

/// The elastica's value, whatever the cells.
pub(super) fn points() -> Vec<[f64; 2]> {
    vec![[0.0, ELASTICA], [20.0, ELASTICA]]
}

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    let cells: &[u32] = match subject {
        Subject::FbEuler => &REFERENCE_CELLS,
        Subject::Xpbd => &REAL_TIME_CELLS,
    };
    let mut checks = Vec::new();
    for &count in cells {
        let found = cantilever::height_over_width(subject, GAMMA, count)?;
        let cells = f64::from(count);
        let gate = CHAIN_ERROR / (cells * cells);
        checks.push(Check::new(format!("N = {count}"), [found, ELASTICA], gate).along(cells));
    }
    let error = |count: u32| {
        let at = cells.iter().position(|&cells| cells == count)?;
        Some((checks[at].measured / ELASTICA - 1.0).abs())
    };
    let [coarse, fine] = ORDER_BETWEEN;
    if let (Some(first), Some(second)) = (error(coarse), error(fine)) {
        let finer = f64::from(fine) / f64::from(coarse);
        let order = trig64::ln(first / second) / trig64::ln(finer);
        checks.push(Check::new("order", [order, 2.0], 10.0));
    }
    Ok(checks)
}
