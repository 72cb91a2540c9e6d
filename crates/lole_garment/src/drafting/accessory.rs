//! What accessories share: they take materials and hours rather than cloth.

use lole_language::{Sentence, Words};
use lole_pattern::pattern::{Amount, Notion, NotionKind, Step};
use lole_pattern::{Pattern, Piece};

use super::making::pattern;

/// A pattern of these pieces, which may be none, whose figures are estimates.
pub(crate) fn accessory(
    pieces: Vec<Piece>,
    notions: Vec<Notion>,
    steps: Vec<Step>,
    estimate: Sentence,
) -> Pattern {
    pattern(pieces, Vec::new(), notions, steps).warn(estimate)
}

/// Something counted, with a sentence on it.
pub(crate) fn counted(kind: NotionKind, name: Words, count: u32, note: Sentence) -> Notion {
    Notion {
        note: Some(note),
        ..super::making::notion(kind, name, Amount::Count(count))
    }
}

/// Raffia that is braided and wound, by its length [m].
pub(crate) fn raffia(meters: f64) -> Notion {
    super::making::notion(
        NotionKind::Raffia,
        lole_language::words("ラフィア", "raffia"),
        Amount::Length(lole_geom::Length::from_m(meters)),
    )
}

/// A length of cord or ribbon.
pub(crate) fn cord(name: Words, meters: f64) -> Notion {
    super::making::notion(
        NotionKind::Cord,
        name,
        Amount::Length(lole_geom::Length::from_m(meters)),
    )
}
