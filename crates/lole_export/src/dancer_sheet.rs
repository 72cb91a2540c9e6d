//! `dancer.json`: the tape on a dancer's body, and how well capsules stand for her skin.

use serde::Serialize;

use crate::ExportError;
use crate::report::DancerMeasure;

/// A dancer in figures.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct DancerSheet {
    /// Version of the program.
    pub lole: String,
    /// Name of the avatar's file; left out of a body built to its tape.
    pub avatar: Option<String>,
    /// What may be done with the avatar, line by line, in English.
    pub license: Vec<String>,
    /// The tape.
    pub measures: Vec<DancerMeasure>,
    /// The largest difference between a given measure and the body's [cm]; `None` where nothing was
    /// given.
    pub worst_difference_cm: Option<f64>,
    /// What stands for the legs and hips.
    pub capsules: Vec<CapsuleFacts>,
    /// How well.
    pub capsule_coverage: CoverageFacts,
    /// Vertices of the body.
    pub vertices: usize,
    /// Its triangles.
    pub triangles: usize,
}

/// One capsule in the bind pose.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CapsuleFacts {
    /// What it covers.
    pub name: String,
    /// Bones that carry its ends.
    pub bones: [String; 2],
    /// Ends of its axis [m].
    pub ends_m: [[f32; 3]; 2],
    /// Radius at each end [m].
    pub radii_m: [f32; 2],
}

/// How well capsules stand for the skin between ankle and waist.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct CoverageFacts {
    /// Share of the skin's area from 8 mm inside to 3 mm outside a capsule [%].
    pub close_pct: f64,
    /// Share that lies farther outside [%].
    pub outside_pct: f64,
    /// Farthest that skin lies outside [mm].
    pub farthest_mm: f64,
}

/// The sheet as JSON, ending in a line break; serde writes a number that is none as `null`.
///
/// # Errors
/// [`ExportError::Encoding`] when it cannot be written.
pub fn dancer_json(sheet: &DancerSheet) -> Result<String, ExportError> {
    serde_json::to_string_pretty(sheet)
        .map(|text| text + "\n")
        .map_err(|error| ExportError::Encoding {
            file: "dancer.json",
            cause: error.to_string(),
        })
}
