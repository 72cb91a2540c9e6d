//! What a key of the design document is: name, range, meaning, and the field it fills. The keys
//! themselves are one row each in [`TABLES`].
//!
//! Reading, checking, writing and the messages all walk this table, so a key that is added here is
//! read, refused, written and explained.

#[macro_use]
mod rows;
#[macro_use]
mod print_rows;
mod alterations;
mod cost;
mod face;
mod garments;
mod motion;
mod tables;

use lole_language::{Sentence, Words};

use super::{Design, Problem, nearest};

pub use garments::{FINENESS, GARMENT, LIST, kind_ids};
pub use motion::{MOTION_PARTS, PART_KEYS};
pub use tables::TABLES;

/// Longest text of a key, in letters.
const MOST_LETTERS: usize = 1000;

/// One table of the document, filling a `T`.
#[derive(Debug)]
pub struct Table<T: 'static = Design> {
    /// Name between the brackets.
    pub name: &'static str,
    /// What it holds, in a few words, written as a comment above it.
    pub about: Words,
    /// Its keys, in the order they are written.
    pub keys: &'static [Key<T>],
}

/// One key of a table, or of the parts of a list: it fills a field of `D`.
#[derive(Debug)]
pub struct Key<T: 'static = Design> {
    /// Name, ending in its unit where it has one.
    pub name: &'static str,
    /// What it means, in a few words.
    pub about: Words,
    /// What it takes and where it goes.
    pub kind: Kind<T>,
}

/// What a key takes, with its way into and out of a `T`. A `get` that returns `None` leaves
/// the key out of the document.
#[derive(Debug)]
pub enum Kind<T: 'static = Design> {
    /// A finite number from `min` to `max`.
    Number {
        /// Smallest accepted number.
        min: f64,
        /// Largest accepted number.
        max: f64,
        /// Reads the field.
        get: fn(&T) -> Option<f64>,
        /// Fills the field.
        set: fn(&mut T, f64),
    },
    /// A whole number from `min` to `max`.
    Count {
        /// Smallest accepted number.
        min: u64,
        /// Largest accepted number.
        max: u64,
        /// Reads the field.
        get: fn(&T) -> Option<u64>,
        /// Fills the field.
        set: fn(&mut T, u64),
    },
    /// A name from a list.
    Name {
        /// What the list holds, as in "is not a dance step".
        what: Words,
        /// The list.
        choices: fn() -> Vec<&'static str>,
        /// Reads the field.
        get: fn(&T) -> &'static str,
        /// Fills the field; names that are not on the list change nothing.
        set: fn(&mut T, &str),
    },
    /// A text on one line, such as the name of a file.
    Text {
        /// What it is.
        what: Words,
        /// Reads the field.
        get: fn(&T) -> Option<&str>,
        /// Fills the field.
        set: fn(&mut T, &str),
    },
    /// A color as `"#rrggbb"` in sRGB.
    Color {
        /// Reads the field.
        get: fn(&T) -> Option<[u8; 3]>,
        /// Fills the field.
        set: fn(&mut T, [u8; 3]),
    },
}

impl<T> Kind<T> {
    /// What should be written, with its range: "a number from 0 to 100".
    #[must_use]
    pub fn wanted(&self) -> Sentence {
        match self {
            Self::Number { min, max, .. } => Sentence::new(
                format!("{min} から {max} までの数"),
                format!("a number from {min} to {max}"),
            ),
            Self::Count { min, max, .. } => Sentence::new(
                format!("{min} から {max} までの整数"),
                format!("a whole number from {min} to {max}"),
            ),
            Self::Name { what, choices, .. } => {
                let choices = choices().join(", ");
                Sentence::new(
                    format!("{}の名前を引用符で囲んだもの（{choices}）", what.japanese),
                    format!("the name of a {} in quotes: {choices}", what.english),
                )
            }
            Self::Text { what, .. } => Sentence::new(
                format!(
                    "{}を引用符で囲んだもの（一行、{MOST_LETTERS} 文字まで）",
                    what.japanese
                ),
                format!(
                    "{} in quotes, on one line and of at most {MOST_LETTERS} letters",
                    what.english
                ),
            ),
            Self::Color { .. } => {
                Sentence::new("\"#9e1026\" のような色", "a color such as \"#9e1026\"")
            }
        }
    }

    /// Whether a number written as `found` fits.
    pub(super) fn check_number(&self, value: f64, found: &str) -> Result<(), Problem> {
        let inside = match self {
            Self::Number { min, max, .. } => (*min..=*max).contains(&value),
            _ => true,
        };
        if inside {
            Ok(())
        } else {
            Err(self.out_of_range(found))
        }
    }

    /// Whether a whole number written as `found` fits.
    pub(super) fn check_count(&self, value: u64, found: &str) -> Result<(), Problem> {
        let inside = match self {
            Self::Count { min, max, .. } => (*min..=*max).contains(&value),
            _ => true,
        };
        if inside {
            Ok(())
        } else {
            Err(self.out_of_range(found))
        }
    }

    /// Whether a name is on the list.
    pub(super) fn check_name(&self, name: &str) -> Result<(), Problem> {
        let Self::Name { what, choices, .. } = self else {
            return Ok(());
        };
        let choices = choices();
        if choices.contains(&name) {
            return Ok(());
        }
        Err(Problem::UnknownName {
            found: format!("\"{}\"", shortened(name)),
            what: *what,
            nearest: nearest(name, &choices).unwrap_or_default().to_owned(),
            choices: choices.join(", "),
        })
    }

    /// Whether a text is one, and on one line.
    pub(super) fn check_text(&self, text: &str) -> Result<(), Problem> {
        let short = text.chars().nth(MOST_LETTERS).is_none();
        if short && !text.trim().is_empty() && !text.chars().any(char::is_control) {
            Ok(())
        } else {
            Err(self.out_of_range(text))
        }
    }

    /// Whether what a design holds fits.
    pub(super) fn check(&self, design: &T) -> Result<(), Problem> {
        match self {
            Self::Number { get, .. } => {
                get(design).map_or(Ok(()), |value| self.check_number(value, &value.to_string()))
            }
            Self::Count { get, .. } => {
                get(design).map_or(Ok(()), |value| self.check_count(value, &value.to_string()))
            }
            Self::Name { get, .. } => self.check_name(get(design)),
            Self::Text { get, .. } => get(design).map_or(Ok(()), |text| self.check_text(text)),
            Self::Color { .. } => Ok(()),
        }
    }

    pub(super) fn out_of_range(&self, found: &str) -> Problem {
        Problem::OutOfRange {
            found: shortened(found),
            wanted: self.wanted(),
        }
    }
}

/// What the user typed, short enough for a sentence and on one line.
pub(super) fn shortened(text: &str) -> String {
    const LIMIT: usize = 40;
    let visible = |letter: char| if letter.is_control() { ' ' } else { letter };
    let line: String = text.chars().take(LIMIT).map(visible).collect();
    if text.chars().nth(LIMIT).is_some() {
        line + "…"
    } else {
        line
    }
}

/// The key of this name in the table of this name.
#[must_use]
pub fn key(table: &str, name: &str) -> Option<&'static Key> {
    TABLES
        .iter()
        .find(|row| row.name == table)?
        .keys
        .iter()
        .find(|row| row.name == name)
}
