//! One sentence for each way a document can be wrong: file, line, place, what, and what to do.

use std::fmt;

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
    #[error("there is no such {what}; {remedy}")]
    Unknown {
        /// "key" or "table".
        what: &'static str,
        /// The nearest, or all there are.
        remedy: String,
    },
    /// A value of another type.
    #[error("{found} is {found_type}; write {wanted}")]
    WrongType {
        /// What stands there.
        found: String,
        /// Its type with an article.
        found_type: &'static str,
        /// What should stand there.
        wanted: String,
    },
    /// A number outside its range, or none at all.
    #[error("{found} is out of range; write {wanted}")]
    OutOfRange {
        /// What stands there.
        found: String,
        /// The range.
        wanted: String,
    },
    /// A name that is not on its list.
    #[error("{found} is not a {what}; did you mean \"{nearest}\"? (the choices are {choices})")]
    UnknownName {
        /// What stands there.
        found: String,
        /// What it should name.
        what: &'static str,
        /// The choice most like it.
        nearest: String,
        /// All choices.
        choices: String,
    },
    /// Values that do not go together.
    #[error("{sentence}")]
    Together {
        /// Which and why, and what to do.
        sentence: String,
    },
}
