//! A sentence that the window shows until it is closed or another one comes.

use std::path::{Path, PathBuf};

use lole_language::{Bilingual, Sentence};

/// News or trouble.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Message {
    /// What is said.
    pub sentence: Sentence,
    /// How it is meant.
    pub kind: MessageKind,
    /// A file or folder that it is about, to be shown.
    pub place: Option<PathBuf>,
}

/// How a sentence is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MessageKind {
    /// Something was done.
    News,
    /// Something was not done.
    Trouble,
}

impl Message {
    /// Something was done.
    pub fn news(japanese: impl Into<String>, english: impl Into<String>) -> Self {
        Self {
            sentence: Sentence::new(japanese, english),
            kind: MessageKind::News,
            place: None,
        }
    }

    /// Something was not done, in the words of an error.
    pub fn trouble(error: &impl Bilingual) -> Self {
        Self {
            sentence: Sentence::of(error),
            kind: MessageKind::Trouble,
            place: None,
        }
    }

    /// The message with the file or folder that it is about.
    #[must_use]
    pub fn at(self, place: &Path) -> Self {
        Self {
            place: Some(place.to_owned()),
            ..self
        }
    }
}
