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

mod shown;

use std::fmt;

pub use shown::{MOST_REPEATED, is_unseen, repeated, shown, visible, visible_json};

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
