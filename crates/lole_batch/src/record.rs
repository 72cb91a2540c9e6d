//! What one run leaves behind. Its text is written by whoever performed it, on any machine, and read by
//! whoever makes the table.

use lole_language::Sentence;
use serde::{Deserialize, Serialize};

/// A run that ended: its figures, or why it has none.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Version of the program that ran it.
    pub lole: String,
    /// The document that was run.
    pub document: String,
    /// What was measured; `None` of a run that could not be begun.
    pub figures: Option<Figures>,
    /// Why it could not be begun, or not be danced to its end.
    pub error: Option<Said>,
    /// Processor time [s]: what a run cost, not what it found, and no column of the table.
    pub process_seconds: f64,
}

/// A sentence in both languages.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Said {
    /// 日本語
    pub japanese: String,
    /// English
    pub english: String,
}

impl From<Sentence> for Said {
    fn from(said: Sentence) -> Self {
        Self {
            japanese: said.japanese,
            english: said.english,
        }
    }
}

/// A dance in numbers. Of a run that ended early they are what was seen until then.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Figures {
    /// Frames danced, at 60 a second.
    pub frames: u32,
    /// How long was danced [s].
    pub dance_s: f64,
    /// Particles that move.
    pub particles: u64,
    /// Mean over the frames of the mean strain of the structural springs [%].
    pub strain_mean_pct: f64,
    /// Worst 99th percentile of it [%].
    pub strain_p99_worst_pct: f64,
    /// Worst of it [%].
    pub strain_worst_pct: f64,
    /// Deepest cloth below the drawn skin [mm].
    pub skin_depth_worst_mm: f64,
    /// Lowest mean height of the hem [cm].
    pub hem_low_cm: f64,
    /// Mean of it [cm].
    pub hem_mean_cm: f64,
    /// Highest [cm].
    pub hem_high_cm: f64,
    /// Amplitude of the hem's swing against the belt, see [`crate::hem::Sway`] [cm]; like the rest of what
    /// follows it is of the skirt, or of the first gathered garment, and `None` without one.
    pub sway_cm: Option<f64>,
    /// Farthest from the middle of the swing [cm].
    pub sway_worst_cm: Option<f64>,
    /// Folds of the hem at rest, before the dance.
    pub rest_fold_count: Option<u64>,
    /// Their depth [cm].
    pub rest_fold_depth_cm: Option<f64>,
    /// Mean over the frames of the folds of the hem.
    pub fold_count: Option<f64>,
    /// Mean of their depth [cm].
    pub fold_depth_cm: Option<f64>,
    /// Mean distance of the hem from its center [cm].
    pub hem_radius_cm: Option<f64>,
    /// Strongest pull at the elastics [N].
    pub pull_n: Option<f64>,
    /// What they hold [N].
    pub held_n: Option<f64>,
    /// Pull over what is held: from 1 on the skirt slips down.
    pub slip_ratio: Option<f64>,
    /// Of all bits of the cloth at the end, in hexadecimal digits.
    pub state_hash: String,
}

impl Record {
    /// The text of a record, on one line.
    #[must_use]
    pub fn to_json(&self) -> String {
        serde_json::to_string(self).unwrap_or_default() + "\n"
    }

    /// Reads one; `None` where it is none, or of another document than `document`.
    #[must_use]
    pub fn read(text: &[u8], document: &str) -> Option<Self> {
        let record: Self = serde_json::from_slice(text).ok()?;
        (record.document == document).then_some(record)
    }
}
