//! The two languages of the product, and sentences that are written in both where they arise.
//!
//! A sentence stands beside what it is about, in both languages, so that neither can be forgotten:
//! an error that a person reads implements [`Bilingual`], and the compiler asks for its Japanese
//! when a case is added.
//!
//! ```
//! use lole_language::{Bilingual as _, Language, Sentence};
//!
//! let sentence = Sentence::new("布が足りません。", "there is too little cloth");
//! assert_eq!(sentence.text(Language::of_locale(Some("ja-JP"))), "布が足りません。");
//! assert_eq!(sentence.text(Language::of_locale(Some("en-US"))), "there is too little cloth");
//! ```

use std::fmt;

/// A language of the product.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Language {
    /// 日本語
    Japanese,
    /// English, also for every system in another language.
    English,
}

impl Language {
    /// The language of a locale such as `ja-JP`; English where there is none.
    #[must_use]
    pub fn of_locale(locale: Option<&str>) -> Self {
        match locale {
            Some(name) if name.to_ascii_lowercase().starts_with("ja") => Self::Japanese,
            _ => Self::English,
        }
    }

    /// The text in this language.
    #[must_use]
    pub const fn pick<'a>(self, japanese: &'a str, english: &'a str) -> &'a str {
        match self {
            Self::Japanese => japanese,
            Self::English => english,
        }
    }
}

/// A few words in both languages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Words {
    /// 日本語
    pub japanese: &'static str,
    /// English
    pub english: &'static str,
}

impl Words {
    /// The words in this language.
    #[must_use]
    pub const fn text(self, language: Language) -> &'static str {
        language.pick(self.japanese, self.english)
    }
}

/// Shorthand for [`Words`], Japanese first.
#[must_use]
pub const fn words(japanese: &'static str, english: &'static str) -> Words {
    Words { japanese, english }
}

/// Letters of what was given that a message repeats, at most.
pub const MOST_REPEATED: usize = 80;
/// Letters of a message, at most: a sentence or two with a path in it.
const LONGEST_MESSAGE: usize = 1200;

/// What was given, as a message repeats it: at most [`MOST_REPEATED`] letters, with `…` for the rest.
///
/// ```
/// assert_eq!(lole_language::repeated("hula"), "hula");
/// assert_eq!(lole_language::repeated(&"a".repeat(1000)).chars().count(), 81);
/// ```
#[must_use]
pub fn repeated(given: &str) -> String {
    shortened(given, MOST_REPEATED)
}

/// A message as it is shown: control characters of what it repeats are made visible, so that no terminal
/// follows them, and words longer than any in a language are cut.
///
/// ```
/// assert_eq!(lole_language::shown("no \u{1b}[2J here"), "no \\u{1b}[2J here");
/// ```
#[must_use]
pub fn shown(message: &str) -> String {
    let words = message.split(' ').map(|word| match word.rfind('/') {
        // Paths are cut in front of the name of their file.
        Some(end) if LONGEST_WORD < word.chars().count() => {
            let (folder, name) = word.split_at(end);
            shortened(folder, LONGEST_WORD / 2) + &shortened(name, LONGEST_WORD / 2)
        }
        _ => shortened(word, LONGEST_WORD),
    });
    let mut text = String::new();
    for letter in words
        .collect::<Vec<_>>()
        .join(" ")
        .chars()
        .take(LONGEST_MESSAGE + 1)
    {
        match letter {
            '\n' | '\t' => text.push(letter),
            _ if is_unseen(letter) => text.extend(letter.escape_unicode()),
            _ => text.push(letter),
        }
    }
    shortened(&text, LONGEST_MESSAGE)
}

/// Letters of a word, at most, a path included.
const LONGEST_WORD: usize = 400;

/// Whether a terminal would follow a letter instead of showing it, or it would turn what stands around it.
fn is_unseen(letter: char) -> bool {
    letter.is_control()
        || matches!(letter, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

fn shortened(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

/// The words with a capital letter: names stand in sentences, and a row of a table begins one.
#[must_use]
pub fn capitalized(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters
        .next()
        .map(|letter| letter.to_uppercase().to_string());
    first.unwrap_or_default() + letters.as_str()
}

/// What people read in either language; [`fmt::Display`] is English.
pub trait Bilingual: fmt::Display {
    /// The sentence in Japanese.
    fn japanese(&self) -> String;

    /// The sentence in this language.
    fn text(&self, language: Language) -> String {
        match language {
            Language::Japanese => self.japanese(),
            Language::English => self.to_string(),
        }
    }
}

/// A sentence in both languages.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sentence {
    /// 日本語
    pub japanese: String,
    /// English
    pub english: String,
}

impl Sentence {
    /// The sentence, Japanese first.
    pub fn new(japanese: impl Into<String>, english: impl Into<String>) -> Self {
        Self {
            japanese: japanese.into(),
            english: english.into(),
        }
    }

    /// Both texts of `said`.
    pub fn of(said: &impl Bilingual) -> Self {
        Self::new(said.japanese(), said.to_string())
    }
}

impl fmt::Display for Sentence {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.english)
    }
}

impl std::error::Error for Sentence {}

impl Bilingual for Sentence {
    fn japanese(&self) -> String {
        self.japanese.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn japanese_systems_get_japanese() {
        assert_eq!(Language::of_locale(Some("ja-JP")), Language::Japanese);
        assert_eq!(Language::of_locale(Some("en-US")), Language::English);
        assert_eq!(Language::of_locale(Some("de")), Language::English);
        assert_eq!(Language::of_locale(None), Language::English);
    }

    #[test]
    fn a_row_begins_with_a_capital_letter_where_its_script_has_one() {
        assert_eq!(capitalized("depth of it"), "Depth of it");
        assert_eq!(capitalized("深さ"), "深さ");
        assert_eq!(capitalized(""), "");
    }
}
