//! A copy of the work beside the user's data, so that a crash loses nothing.
//!
//! Every window has a slot, `window-N.work`, and holds the lock on `window-N.lock` as long as it
//! lives: the system lets go of a lock however a process ends. A copy whose lock is free was left by
//! a window that ended without saving. Locks are files of no length that are never deleted, because
//! another window may be about to take them.

use std::ffi::OsString;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread::{self, JoinHandle};

use lole_files as files;
use lole_language::Sentence;

use crate::work::Work;

/// Windows at one time.
const MOST_WINDOWS: u32 = 64;

/// A place for one window's work.
#[derive(Debug)]
struct Slot {
    path: PathBuf,
    /// Held as long as it is open.
    _lock: File,
}

impl Slot {
    /// The slot of this number, if no living window has it.
    fn take(folder: &Path, number: u32) -> Option<Self> {
        let lock = File::create(folder.join(format!("window-{number}.lock"))).ok()?;
        lock.try_lock().ok()?;
        Some(Self {
            path: folder.join(format!("window-{number}.work")),
            _lock: lock,
        })
    }

    fn is_empty(&self) -> bool {
        !self.path.exists()
    }

    fn clear(&self) {
        // It may never have been filled.
        drop(fs::remove_file(&self.path));
    }
}

/// Work that another window left behind.
#[derive(Debug)]
pub(crate) struct Leftover {
    slot: Slot,
    pub(crate) work: Work,
}

impl Leftover {
    /// Throws it away: it was taken over, or is not wanted.
    pub(crate) fn discard(self) {
        self.slot.clear();
    }
}

/// The running thread that writes. Dropped, it ends when all is written.
pub(crate) struct Journal {
    jobs: Option<Sender<Option<Box<Work>>>>,
    trouble: Receiver<Sentence>,
    thread: Option<JoinHandle<()>>,
}

impl Journal {
    /// Takes a slot in `folder`; with it the newest work that was left there, if there is any.
    /// `None` where nothing can be written.
    pub(crate) fn open(folder: &Path) -> Option<(Self, Option<Leftover>)> {
        fs::create_dir_all(folder).ok()?;
        let leftover = newest_leftover(folder);
        let slot = (1..=MOST_WINDOWS)
            .filter_map(|number| Slot::take(folder, number))
            .find(Slot::is_empty)?;
        let (jobs, received) = mpsc::channel();
        let (complaints, trouble) = mpsc::channel();
        let thread = thread::Builder::new()
            .name("journal".to_owned())
            .spawn(move || write_all(&slot, &received, &complaints))
            .ok()?;
        let journal = Self {
            jobs: Some(jobs),
            trouble,
            thread: Some(thread),
        };
        Some((journal, leftover))
    }

    /// Keeps the work, soon.
    pub(crate) fn keep(&self, work: Work) {
        self.send(Some(Box::new(work)));
    }

    /// There is nothing more to be kept.
    pub(crate) fn clear(&self) {
        self.send(None);
    }

    fn send(&self, job: Option<Box<Work>>) {
        if let Some(jobs) = &self.jobs {
            // The thread lives until the sender goes.
            drop(jobs.send(job));
        }
    }

    /// Why the work could not be kept.
    pub(crate) fn trouble(&self) -> Option<Sentence> {
        self.trouble.try_iter().last()
    }
}

impl Drop for Journal {
    fn drop(&mut self) {
        self.jobs = None;
        if let Some(thread) = self.thread.take() {
            drop(thread.join());
        }
    }
}

/// Writes what comes; of many only the last counts.
fn write_all(slot: &Slot, jobs: &Receiver<Option<Box<Work>>>, complaints: &Sender<Sentence>) {
    while let Ok(first) = jobs.recv() {
        match jobs.try_iter().last().unwrap_or(first) {
            Some(work) => {
                if let Err(sentence) = files::write_whole(&slot.path, &work.to_bytes()) {
                    // Nobody listens only while the window closes.
                    drop(complaints.send(sentence));
                }
            }
            None => slot.clear(),
        }
    }
}

/// The newest work in a slot without a window.
fn newest_leftover(folder: &Path) -> Option<Leftover> {
    let left = (1..=MOST_WINDOWS).filter(|number| {
        let path = folder.join(format!("window-{number}.work"));
        path.exists()
    });
    let mut slots: Vec<Slot> = left.filter_map(|n| Slot::take(folder, n)).collect();
    slots.sort_by_key(|slot| {
        let written = fs::metadata(&slot.path).and_then(|data| data.modified());
        written.ok()
    });
    while let Some(slot) = slots.pop() {
        let bytes = fs::read(&slot.path).unwrap_or_default();
        let read = |path: &Path| files::read_linked(path, "[motion] file").ok();
        match Work::parse(&bytes, read) {
            Some(work) => return Some(Leftover { slot, work }),
            // Nobody can read it, and its slot is wanted.
            None => slot.clear(),
        }
    }
    None
}

/// Where a user's data of this program lies, by the variables of the environment.
pub(crate) fn folder(variable: impl Fn(&str) -> Option<OsString>) -> Option<PathBuf> {
    let at = |name: &str| {
        let path = variable(name).map(PathBuf::from);
        path.filter(|path| path.is_absolute())
    };
    let data = if cfg!(windows) {
        at("LOCALAPPDATA").map(|path| path.join("Lole"))
    } else if cfg!(target_os = "macos") {
        at("HOME").map(|home| home.join("Library/Application Support/Lole"))
    } else {
        let usual = || Some(at("HOME")?.join(".local/share"));
        at("XDG_DATA_HOME")
            .or_else(usual)
            .map(|path| path.join("lole"))
    };
    Some(data?.join("work"))
}

#[cfg(test)]
mod tests;
