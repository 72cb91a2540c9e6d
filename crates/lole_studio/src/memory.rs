//! What a window remembers for the next one: recent designs, the group's list, the size of type, the
//! language that was chosen. A line each.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use lole_language::Language;

/// Designs that are remembered.
pub(crate) const MOST_RECENT: usize = 8;
/// Sizes of type that are taken, over the usual one.
const SIZES: std::ops::RangeInclusive<f32> = 0.5..=3.0;

/// What is remembered.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Memory {
    /// Designs that were opened or saved, the last first.
    pub recent: Vec<PathBuf>,
    /// The list of a group's dancers.
    pub roster: Option<PathBuf>,
    /// Size of everything over the usual one, where it was chosen.
    pub size: Option<f32>,
    /// The language that was chosen.
    pub language: Option<Language>,
}

impl Memory {
    /// Remembers a design as the last one.
    pub(crate) fn note_design(&mut self, path: &Path) {
        self.recent.retain(|known| known != path);
        self.recent.insert(0, path.to_owned());
        self.recent.truncate(MOST_RECENT);
    }

    /// What a text says; lines that nobody knows are passed over.
    pub(crate) fn parse(text: &str) -> Self {
        let mut memory = Self::default();
        // A damaged letter costs its own line, not all of them.
        let lines = (text.lines()).filter(|line| !line.contains(char::REPLACEMENT_CHARACTER));
        for (key, value) in lines.filter_map(|line| line.split_once(" = ")) {
            match key {
                "recent" if memory.recent.len() < MOST_RECENT => memory.recent.push(value.into()),
                "roster" => memory.roster = Some(value.into()),
                "size" => {
                    let size = value.parse().ok();
                    memory.size = size.filter(|size| SIZES.contains(size));
                }
                "language" => {
                    memory.language = match value {
                        "ja" => Some(Language::Japanese),
                        "en" => Some(Language::English),
                        _ => None,
                    };
                }
                _ => {}
            }
        }
        memory
    }

    /// The text that says it.
    pub(crate) fn to_text(&self) -> String {
        let mut text = String::new();
        let mut line = |key: &str, value: &str| {
            // A name with a line's end in it would be read as two.
            if !value.contains(['\n', '\r']) {
                writeln!(text, "{key} = {value}").unwrap_or_default();
            }
        };
        for path in &self.recent {
            line("recent", &path.to_string_lossy());
        }
        if let Some(path) = &self.roster {
            line("roster", &path.to_string_lossy());
        }
        if let Some(size) = self.size {
            line("size", &size.to_string());
        }
        if let Some(language) = self.language {
            line("language", language.pick("ja", "en"));
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_damaged_memory_gives_what_can_be_read() {
        let memory = Memory::parse("size = 99\nrecent = a.lole\n\u{0}\nlanguage = xx\nsize=");
        assert_eq!(memory.recent, [Path::new("a.lole")]);
        assert_eq!((memory.size, memory.language), (None, None));
    }
}
