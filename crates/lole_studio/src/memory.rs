//! What a window remembers for the next one: recent designs, the group's list, the size of type, the
//! language that was chosen. A line each in a file beside the user's data.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread::{self, JoinHandle};

use lole_language::Language;

/// Designs that are remembered.
const MOST_RECENT: usize = 8;
/// Name of the file.
const FILE: &str = "window.memory";
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
    fn parse(text: &str) -> Self {
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

    fn to_text(&self) -> String {
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

    /// What the last window left in a folder; nothing where there is none.
    pub(crate) fn read(folder: &Path) -> Self {
        let bytes = std::fs::read(folder.join(FILE)).unwrap_or_default();
        Self::parse(&String::from_utf8_lossy(&bytes))
    }
}

/// The thread that writes it. Dropped, it ends and is waited for.
pub(crate) struct MemoryKeeper {
    jobs: Option<Sender<Memory>>,
    thread: Option<JoinHandle<()>>,
    kept: Memory,
}

impl MemoryKeeper {
    /// Starts the thread for a folder in which `kept` lies.
    pub(crate) fn start(folder: PathBuf, kept: Memory) -> Self {
        let (jobs, received) = mpsc::channel();
        let thread = thread::Builder::new()
            .name("memory".to_owned())
            .spawn(move || write_all(&folder, &received))
            .ok();
        Self {
            jobs: Some(jobs),
            thread,
            kept,
        }
    }

    /// What is kept.
    pub(crate) const fn kept(&self) -> &Memory {
        &self.kept
    }

    /// Keeps it, soon, if it is another than the one that is kept.
    pub(crate) fn keep(&mut self, memory: &Memory) {
        if *memory == self.kept {
            return;
        }
        self.kept = memory.clone();
        if let Some(jobs) = &self.jobs {
            // The thread lives until the sender goes.
            drop(jobs.send(memory.clone()));
        }
    }
}

impl Drop for MemoryKeeper {
    fn drop(&mut self) {
        self.jobs = None;
        if let Some(thread) = self.thread.take() {
            drop(thread.join());
        }
    }
}

fn write_all(folder: &Path, jobs: &Receiver<Memory>) {
    while let Ok(first) = jobs.recv() {
        // Of many only the last counts.
        let memory = jobs.try_iter().last().unwrap_or(first);
        // What cannot be remembered is asked for again, which is no loss of work.
        drop(std::fs::create_dir_all(folder));
        drop(lole_files::write_whole(
            &folder.join(FILE),
            memory.to_text().as_bytes(),
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_kept_is_there_for_the_next_window() {
        let folder = std::env::temp_dir().join(format!("lole-memory-{}", std::process::id()));
        let mut memory = Memory {
            roster: Some("組/名簿.csv".into()),
            size: Some(1.5),
            language: Some(Language::Japanese),
            ..Memory::default()
        };
        for number in 0..12 {
            memory.note_design(Path::new(&format!("{number}.lole")));
        }
        memory.note_design(Path::new("7.lole"));
        assert_eq!(memory.recent.len(), MOST_RECENT);
        assert_eq!(memory.recent[0], Path::new("7.lole"));
        let mut keeper = MemoryKeeper::start(folder.clone(), Memory::default());
        keeper.keep(&memory);
        drop(keeper);
        assert_eq!(Memory::read(&folder), memory);
        let mut bytes = std::fs::read(folder.join(FILE)).unwrap();
        bytes.splice(0..0, *b"recent = \xff.lole\n");
        std::fs::write(folder.join(FILE), bytes).unwrap();
        let read = Memory::read(&folder);
        assert_eq!(read.recent, memory.recent);
        assert_eq!((read.roster, read.size), (memory.roster, memory.size));
        std::fs::remove_dir_all(&folder).unwrap();
        assert_eq!(Memory::read(&folder), Memory::default());
    }

    #[test]
    fn a_damaged_memory_gives_what_can_be_read() {
        let memory = Memory::parse("size = 99\nrecent = a.lole\n\u{0}\nlanguage = xx\nsize=");
        assert_eq!(memory.recent, [Path::new("a.lole")]);
        assert_eq!((memory.size, memory.language), (None, None));
    }
}
