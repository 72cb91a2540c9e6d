//! What a window remembers for the next one, in a file beside the user's data.

use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread::{self, JoinHandle};

use crate::memory::Memory;

/// Name of the file.
const FILE: &str = "window.memory";

/// What the last window left in a folder; nothing where there is none.
pub(crate) fn read(folder: &Path) -> Memory {
    let bytes = std::fs::read(folder.join(FILE)).unwrap_or_default();
    Memory::parse(&String::from_utf8_lossy(&bytes))
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
    use lole_language::Language;

    use super::*;
    use crate::memory::MOST_RECENT;

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
        assert_eq!(read(&folder), memory);
        let mut bytes = std::fs::read(folder.join(FILE)).unwrap();
        bytes.splice(0..0, *b"recent = \xff.lole\n");
        std::fs::write(folder.join(FILE), bytes).unwrap();
        let found = read(&folder);
        assert_eq!(found.recent, memory.recent);
        assert_eq!((found.roster, found.size), (memory.roster, memory.size));
        std::fs::remove_dir_all(&folder).unwrap();
        assert_eq!(read(&folder), Memory::default());
    }
}
