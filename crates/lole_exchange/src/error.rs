//! Why a file of another program was not read.

use lole_language::{Bilingual, Sentence, Words, repeated};

/// Why a file of another program was not read, and what to do.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExchangeError {
    /// It has more bytes than such a file.
    #[error("the file has {kilobytes} kB, and {} has {most} kB at most; choose another file", what.english)]
    TooLarge {
        /// What was asked for.
        what: Words,
        /// Its size, in kB.
        kilobytes: usize,
        /// Most that is read, in kB.
        most: usize,
    },
    /// It is no JSON.
    #[error(
        "this is no JSON (line {line}, column {column}); export the file again from its program"
    )]
    NotJson {
        /// Line of the first mistake, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
    },
    /// Something is missing.
    #[error("{place} is missing; {} has it: export the file again from its program", what.english)]
    Missing {
        /// Where, as a path of keys.
        place: String,
        /// What was asked for.
        what: Words,
    },
    /// Something is not what stands in such a place.
    #[error("{place}: {found} is not {}", wanted.english)]
    Wrong {
        /// Where, as a path of keys.
        place: String,
        /// What stands there, shortened.
        found: String,
        /// What should.
        wanted: Sentence,
    },
    /// There is more of something than is read.
    #[error("{place}: {count} {} are too many; leave {most} at most", what.english)]
    TooMany {
        /// Where, as a path of keys.
        place: String,
        /// What is counted.
        what: Words,
        /// How many there are.
        count: usize,
        /// How many are read.
        most: usize,
    },
    /// What stands there cannot be sewn.
    #[error("{place}: {}", why.english)]
    Unsewable {
        /// Where, as a path of keys.
        place: String,
        /// Why, and what to do.
        why: Sentence,
    },
}

impl ExchangeError {
    /// What stands at a place is not what is wanted there.
    pub(crate) fn wrong(
        place: impl Into<String>,
        found: &str,
        (japanese, english): (&str, &str),
    ) -> Self {
        Self::Wrong {
            place: place.into(),
            found: repeated(found),
            wanted: Sentence::new(japanese, english),
        }
    }

    /// What stands at a place cannot be sewn.
    pub(crate) fn unsewable(
        place: impl Into<String>,
        japanese: impl Into<String>,
        english: impl Into<String>,
    ) -> Self {
        Self::Unsewable {
            place: place.into(),
            why: Sentence::new(japanese, english),
        }
    }
}

impl Bilingual for ExchangeError {
    fn japanese(&self) -> String {
        match self {
            Self::TooLarge {
                what,
                kilobytes,
                most,
            } => format!(
                "{kilobytes} kB あります。{}は {most} kB までです。別のファイルを選んでください",
                what.japanese
            ),
            Self::NotJson { line, column } => format!(
                "JSON ではありません（{line} 行 {column} 文字目）。元のプログラムから書き出し直してください"
            ),
            Self::Missing { place, what } => format!(
                "{place} がありません。{}にはあるはずです。元のプログラムから書き出し直してください",
                what.japanese
            ),
            Self::Wrong {
                place,
                found,
                wanted,
            } => format!("{place}: {found} は{}ではありません", wanted.japanese),
            Self::TooMany {
                place,
                what,
                count,
                most,
            } => format!(
                "{place}: {}が {count} あります。{most} までにしてください",
                what.japanese
            ),
            Self::Unsewable { place, why } => format!("{place}: {}", why.japanese),
        }
    }
}
