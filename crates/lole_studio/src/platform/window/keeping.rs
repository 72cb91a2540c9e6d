//! What outlives a window: a copy of the work, and what is remembered for the next one.

use lole_language::Sentence;

use super::journal::{self, Journal, Leftover};
use super::memory::{self, MemoryKeeper};
use crate::Work;
use crate::memory::Memory;

/// The copy of the work that outlives a crash, and the one that another window left.
#[derive(Default)]
pub(crate) struct Keeping {
    journal: Option<Journal>,
    leftover: Option<Leftover>,
    memory: Option<MemoryKeeper>,
}

impl Keeping {
    /// Takes a place among the windows that are open.
    pub(crate) fn begin() -> Self {
        let folder = journal::folder(|name| std::env::var_os(name));
        let memory = folder.clone().map(|folder| {
            let kept = memory::read(&folder);
            MemoryKeeper::start(folder, kept)
        });
        let (journal, leftover) = folder
            .and_then(|folder| Journal::open(&folder))
            .map_or((None, None), |(journal, left)| (Some(journal), left));
        Self {
            journal,
            leftover,
            memory,
        }
    }

    /// What the last window left for this one.
    pub(crate) fn memory(&self) -> Memory {
        let keeper = self.memory.as_ref();
        keeper.map_or_else(Memory::default, |keeper| keeper.kept().clone())
    }

    /// Work that a window left without saving.
    pub(crate) fn found(&self) -> Option<Work> {
        self.leftover.as_ref().map(|leftover| leftover.work.clone())
    }

    /// Takes that work over.
    pub(crate) fn take_found(&mut self) -> Option<Work> {
        let leftover = self.leftover.take()?;
        let work = leftover.work.clone();
        leftover.discard();
        Some(work)
    }

    /// Keeps a copy of the work, soon, as long as it is in no file.
    pub(crate) fn keep(&self, work: Work) {
        let Some(journal) = &self.journal else {
            return;
        };
        if work.is_unsaved() {
            journal.keep(work);
        } else {
            journal.clear();
        }
    }

    /// Keeps what is remembered, soon.
    pub(crate) fn remember(&mut self, memory: &Memory) {
        if let Some(keeper) = &mut self.memory {
            keeper.keep(memory);
        }
    }

    /// Why the work could not be kept.
    pub(crate) fn trouble(&self) -> Option<Sentence> {
        self.journal.as_ref()?.trouble()
    }
}
