//! `group.json`: who stands where in a film of a group, and how her costume danced.

use serde::Serialize;

use crate::ExportError;

/// A film of a group.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroupReport {
    /// How they stand.
    pub formation: String,
    /// Everybody, from the front to the back.
    pub dancers: Vec<GroupDancer>,
}

/// One dancer of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroupDancer {
    /// As the list has it.
    pub name: String,
    /// Where she stands [m]: to the right as the audience sees it, and towards it.
    pub place_m: [f32; 2],
    /// Particles of what she wears.
    pub particles: usize,
    /// Strain (p99) in the worst picture [%].
    pub strain_p99_pct: f32,
    /// Deepest cloth below her skin in any picture [mm].
    pub below_skin_mm: f32,
    /// Of the last state of her cloth.
    pub state_hash: String,
}

/// The bytes of `group.json`.
///
/// # Errors
/// [`ExportError::Encoding`] when it cannot be written as JSON.
pub fn group_json(report: &GroupReport) -> Result<String, ExportError> {
    serde_json::to_string_pretty(report)
        .map(|text| text + "\n")
        .map_err(|error| ExportError::Encoding {
            file: "group.json",
            cause: error.to_string(),
        })
}
