//! The table of designs: one file and one row for each garment that can be drafted.

pub mod pau_skirt;
pub mod pau_top;
mod rectangle;
mod steps;
pub(crate) use steps::Sewn;

/// One garment that can be drafted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DesignRow {
    /// Identifier without diacritics, as typed in a document.
    pub id: &'static str,
    /// Name as people write it.
    pub name: &'static str,
    /// What it is, in one sentence.
    pub about: &'static str,
}

/// Every design, in the order a menu shows them.
pub const DESIGNS: &[DesignRow] = &[
    DesignRow {
        id: "pau_skirt",
        name: "pāʻū skirt",
        about: "One rectangle of cloth, gathered onto rows of elastic and worn on the hips.",
    },
    DesignRow {
        id: "pau_top",
        name: "pāʻū top",
        about: "A tube of cloth, held over the bust by elastic.",
    },
];
