//! One sentence for each way a document can be wrong: file, line, place, what, and what to do.

use std::fmt;

use lole_language::{Bilingual, Sentence, Words};

use super::VERSION;

/// Why a design cannot be used. Its text is one sentence, such as
/// `mine.lole:4: [skirt] hem_hight_cm: there is no such key; did you mean hem_height_cm?`
#[derive(Debug, Clone, PartialEq)]
pub struct DesignError {
    /// Name of the file as it was given, or of whatever else the design came from.
    pub file_name: String,
    /// Line counted from 1; `None` for a design that has no text.
    pub line: Option<usize>,
    /// Table and key, such as `[skirt] hem_height_cm`; empty for the document as a whole.
    pub place: String,
    /// What is wrong and what to do; boxed, because a result carries it up many calls.
    pub problem: Box<Problem>,
}

impl fmt::Display for DesignError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.file_name)?;
        if let Some(line) = self.line {
            write!(formatter, ":{line}")?;
        }
        if !self.place.is_empty() {
            write!(formatter, ": {}", self.place)?;
        }
        write!(formatter, ": {}", self.problem)
    }
}

impl std::error::Error for DesignError {}

/// What is wrong and what to do.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// The bytes are not UTF-8.
    #[error("the text is not UTF-8; save the document again as UTF-8")]
    NotUtf8,
    /// The text is larger than any design.
    #[error(
        "the text has {byte_count} bytes and a design has at most {limit}; is this the right file?"
    )]
    TooLong {
        /// Size of the text.
        byte_count: usize,
        /// Largest size that is read.
        limit: usize,
    },
    /// The text is not TOML.
    #[error("this is not TOML ({message}); mend the line, or compare it with a design that works")]
    Syntax {
        /// What the reader of TOML said, on one line.
        message: String,
    },
    /// The version line is missing.
    #[error("the version is missing; begin the document with the line lole = {VERSION}")]
    VersionMissing,
    /// The version is not a version.
    #[error("{found} is not a version; write lole = {VERSION}")]
    VersionUnreadable {
        /// What stands there.
        found: String,
    },
    /// The document was written by a newer program.
    #[error(
        "the document has version {found} and this program reads up to version {VERSION}; \
         install a newer Lole to open it"
    )]
    VersionNewer {
        /// Version of the document.
        found: u64,
    },
    /// No such key or table.
    #[error("there is no such {}; {remedy}", what.english)]
    Unknown {
        /// "key" or "table".
        what: Words,
        /// The nearest, or all there are.
        remedy: Sentence,
    },
    /// Something that cannot be left out.
    #[error("the {} is missing; {remedy}", what.english)]
    Missing {
        /// "kind of garment".
        what: Words,
        /// What to write.
        remedy: Sentence,
    },
    /// A value of another type.
    #[error("{found} is {}; write {wanted}", found_type.english)]
    WrongType {
        /// What stands there.
        found: String,
        /// Its type, in English with an article.
        found_type: Words,
        /// What should stand there.
        wanted: Sentence,
    },
    /// A number outside its range, or none at all.
    #[error("{found} is out of range; write {wanted}")]
    OutOfRange {
        /// What stands there.
        found: String,
        /// The range.
        wanted: Sentence,
    },
    /// A text that names no color.
    #[error("{found} is not a color; write {wanted}")]
    NotColor {
        /// What stands there.
        found: String,
        /// How colors are written.
        wanted: Sentence,
    },
    /// A name that is not on its list.
    #[error(
        "{found} is not a {}; did you mean \"{nearest}\"? (the choices are {choices})",
        what.english
    )]
    UnknownName {
        /// What stands there.
        found: String,
        /// What it should name.
        what: Words,
        /// The choice most like it.
        nearest: String,
        /// All choices.
        choices: String,
    },
    /// Values that do not go together.
    #[error("{sentence}")]
    Together {
        /// Which and why, and what to do.
        sentence: Sentence,
    },
}

impl Bilingual for DesignError {
    fn japanese(&self) -> String {
        let mut text = self.file_name.clone();
        if let Some(line) = self.line {
            text.push_str(&format!(":{line}"));
        }
        if !self.place.is_empty() {
            text.push_str(&format!(": {}", self.place));
        }
        format!("{text}: {}", self.problem.japanese())
    }
}

impl Bilingual for Problem {
    fn japanese(&self) -> String {
        match self {
            Self::NotUtf8 => {
                "文字コードが UTF-8 ではありません。UTF-8 で保存し直してください".to_owned()
            }
            Self::TooLong { byte_count, limit } => format!(
                "{byte_count} バイトあり、デザインの上限 {limit} バイトを超えています。ファイルが違っていませんか"
            ),
            Self::Syntax { message } => format!(
                "TOML として読めません（{message}）。この行を直すか、正しいデザインと見比べてください"
            ),
            Self::VersionMissing => {
                format!("バージョンがありません。最初の行に lole = {VERSION} と書いてください")
            }
            Self::VersionUnreadable { found } => {
                format!("{found} はバージョンではありません。lole = {VERSION} と書いてください")
            }
            Self::VersionNewer { found } => format!(
                "このデザインはバージョン {found} ですが、このプログラムが読めるのは {VERSION} までです。\
                 新しい Lole で開いてください"
            ),
            Self::Unknown { what, remedy } => {
                format!(
                    "このような{}はありません。{}",
                    what.japanese, remedy.japanese
                )
            }
            Self::Missing { what, remedy } => {
                format!("{}がありません。{}", what.japanese, remedy.japanese)
            }
            Self::WrongType {
                found,
                found_type,
                wanted,
            } => format!(
                "{found} は{}です。{}を書いてください",
                found_type.japanese, wanted.japanese
            ),
            Self::NotColor { found, wanted } => format!(
                "{found} は色ではありません。{}を書いてください",
                wanted.japanese
            ),
            Self::OutOfRange { found, wanted } => {
                format!(
                    "{found} は範囲の外です。{}を書いてください",
                    wanted.japanese
                )
            }
            Self::UnknownName {
                found,
                what,
                nearest,
                choices,
            } => format!(
                "{found} という{}はありません。\"{nearest}\" のことですか（選べるのは {choices}）",
                what.japanese
            ),
            Self::Together { sentence } => sentence.japanese(),
        }
    }
}
