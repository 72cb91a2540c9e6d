//! Where the dance is seen.

/// What is around the dancer in pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct StageDesign {
    /// Floor, background and light.
    pub set: StageSet,
}

/// Floor, background and light of pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum StageSet {
    /// A photographer's studio: sand-colored, without a horizon.
    #[default]
    Studio,
    /// White and even, for catalogues.
    Plain,
    /// A dark stage with lamps from behind and a pool of light.
    Theater,
    /// A beach when the sun goes down.
    Beach,
    /// A lawn before trees and mountains, by day.
    Lawn,
}

impl StageSet {
    /// All of them, the usual one first.
    pub const ALL: [Self; 5] = [
        Self::Studio,
        Self::Plain,
        Self::Theater,
        Self::Beach,
        Self::Lawn,
    ];

    /// Its name in documents.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Studio => "studio",
            Self::Plain => "plain",
            Self::Theater => "theater",
            Self::Beach => "beach",
            Self::Lawn => "lawn",
        }
    }

    /// What a person calls it.
    #[must_use]
    pub const fn name(self) -> lole_language::Words {
        use lole_language::words;
        match self {
            Self::Studio => words("写真スタジオ", "studio"),
            Self::Plain => words("白い背景", "plain white"),
            Self::Theater => words("劇場", "theater"),
            Self::Beach => words("夕暮れの浜", "beach at dusk"),
            Self::Lawn => words("芝生と山", "lawn and mountains"),
        }
    }
}
