//! The language the terminal speaks: the system's, Japanese or English.

/// A language of the product.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Language {
    /// 日本語
    Japanese,
    /// English, also for every system in another language.
    English,
}

impl Language {
    /// The system's language, from `LC_ALL`, `LC_MESSAGES`, `LANG` or the platform.
    pub(crate) fn of_system() -> Self {
        Self::of_locale(sys_locale::get_locale().as_deref())
    }

    fn of_locale(locale: Option<&str>) -> Self {
        match locale {
            Some(name) if name.to_ascii_lowercase().starts_with("ja") => Self::Japanese,
            _ => Self::English,
        }
    }

    /// The text in this language.
    pub(crate) const fn pick<'a>(self, japanese: &'a str, english: &'a str) -> &'a str {
        match self {
            Self::Japanese => japanese,
            Self::English => english,
        }
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
}
