//! Results appear whole or not at all: everything is written beside its place and moved there last.
//!
//! A run that fails leaves the results of the run before it as they were. One that was killed leaves a folder
//! for the next run to find: where all of its files were whole, that run moves the rest of them into their
//! place, so that two runs never stay mixed; else it removes them. It says which.

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use lole_language::Sentence;

use crate::{cannot_write, read_ordinary, sync_folder};

/// Name of the folder for files that are not finished.
const UNFINISHED: &str = ".lole-unfinished";
/// A file in it that is locked while the run lasts; the system unlocks what was killed.
const LOCK: &str = "lock";
/// A file in it that names the results, a line each, once all of them are whole: moving them has begun.
const WHOLE: &str = "whole";
/// The same while it is written.
const LISTED: &str = "whole.part";
/// A folder in it that keeps the results of the run before while they are replaced.
const EARLIER: &str = "earlier";
/// The longest list of results [byte].
const MOST_NAMES: u64 = 1 << 20;

/// A results folder that is being filled. Dropped without [`OutputFolder::finish`], it removes
/// what it wrote.
#[derive(Debug)]
pub struct OutputFolder {
    folder: PathBuf,
    created: bool,
    unfinished: PathBuf,
    /// Held while the run lasts.
    lock: Option<fs::File>,
    files: Vec<String>,
    /// Those of them that somebody else wrote.
    begun: BTreeSet<String>,
    found: Vec<Sentence>,
}

impl OutputFolder {
    /// Makes the folder and proves that it can be written.
    ///
    /// # Errors
    /// One sentence: it cannot be written, or another run writes into it.
    pub fn create(folder: &Path) -> Result<Self, Sentence> {
        let created = !folder.exists();
        let cannot = |error: io::Error| {
            let folder = folder.display();
            Sentence::new(
                format!(
                    "{folder}: このフォルダーには書けません（{error}）。別のフォルダーを選んでください"
                ),
                format!("{folder}: the folder cannot be written ({error}); choose another folder"),
            )
        };
        fs::create_dir_all(folder).map_err(cannot)?;
        let unfinished = folder.join(format!("{UNFINISHED}-{}", std::process::id()));
        let mut output = Self {
            folder: folder.to_owned(),
            created,
            unfinished,
            lock: None,
            files: Vec::new(),
            begun: BTreeSet::new(),
            found: Vec::new(),
        };
        fs::create_dir_all(&output.unfinished).map_err(cannot)?;
        fs::write(output.unfinished.join("probe"), b"lole").map_err(cannot)?;
        fs::remove_file(output.unfinished.join("probe")).map_err(cannot)?;
        let lock = fs::File::create(output.unfinished.join(LOCK)).map_err(cannot)?;
        // Where a file system knows no locks, runs are not kept apart.
        drop(lock.try_lock());
        output.lock = Some(lock);
        output.clear_others()?;
        Ok(output)
    }

    /// What was found of runs that were killed, and what became of it.
    #[must_use]
    pub fn found(&self) -> &[Sentence] {
        &self.found
    }

    /// Ends what runs that were killed have left; one that still goes on is left alone, and refuses this one.
    fn clear_others(&mut self) -> Result<(), Sentence> {
        let all = fs::read_dir(&self.folder).into_iter().flatten().flatten();
        let others = all.map(|entry| entry.path()).filter(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with(UNFINISHED) && *path != self.unfinished
        });
        let others: Vec<PathBuf> = others.collect();
        let folder = self.folder.display().to_string();
        if others.iter().any(|other| is_held(&other.join(LOCK))) {
            return Err(Sentence::new(
                format!(
                    "{folder}: 別の実行がこのフォルダーに書いています。終わるのを待つか、別のフォルダーを選んでください"
                ),
                format!(
                    "{folder}: another run is writing into this folder; wait for it or choose another folder"
                ),
            ));
        }
        for other in others {
            let count = self.end_moving(&other)?;
            drop(fs::remove_dir_all(&other));
            self.found.push(if 0 < count {
                Sentence::new(
                    format!("{folder}: 前の実行が、結果を置く途中で止まっていました。残りの {count} 個を置きました"),
                    format!("{folder}: an earlier run was stopped while it put its results in place; the {count} that were left are in place now"),
                )
            } else {
                Sentence::new(
                    format!("{folder}: 前の実行が途中で止まっていました。書きかけのファイルを消しました"),
                    format!("{folder}: an earlier run was stopped before it was done; what it left unfinished is removed"),
                )
            });
        }
        Ok(())
    }

    /// Moves what a killed run had made whole and not yet moved; how many files that were.
    fn end_moving(&self, other: &Path) -> Result<usize, Sentence> {
        let names = read_ordinary(&other.join(WHOLE), MOST_NAMES).unwrap_or_default();
        let names = String::from_utf8_lossy(&names);
        // Whoever wrote the list, no other folder is touched.
        let is_plain = |name: &&str| {
            Path::new(name)
                .file_name()
                .is_some_and(|file| file == *name)
        };
        let mut count = 0;
        for name in names.lines().filter(is_plain) {
            if other.join(name).is_file() {
                replace(&other.join(name), &self.folder.join(name))?;
                count += 1;
            }
        }
        Ok(count)
    }

    /// Writes one file, not yet in its place.
    ///
    /// # Errors
    /// One sentence that names the file.
    pub fn write(&mut self, name: &str, bytes: &[u8]) -> Result<(), Sentence> {
        self.write_whole(name, bytes)?;
        self.files.push(name.to_owned());
        Ok(())
    }

    /// Begins a file that is too large to be written at once, not yet in its place.
    ///
    /// # Errors
    /// A file that cannot be made.
    pub fn begin(&mut self, name: &str) -> io::Result<fs::File> {
        if !self.files.iter().any(|file| file == name) {
            self.files.push(name.to_owned());
        }
        self.begun.insert(name.to_owned());
        fs::File::create(self.unfinished.join(name))
    }

    /// An empty file for what a long run need not hold in memory: it is no result, and goes when the run ends.
    ///
    /// # Errors
    /// A file that cannot be made.
    pub fn scratch(&self, name: &str) -> io::Result<fs::File> {
        fs::OpenOptions::new()
            .read(true)
            .write(true)
            .create(true)
            .truncate(true)
            .open(self.unfinished.join(name))
    }

    /// Sees to it that what was begun is on the disk.
    fn sync_begun(&self) -> Result<(), Sentence> {
        for name in &self.begun {
            let file = fs::OpenOptions::new()
                .append(true)
                .open(self.unfinished.join(name));
            file.and_then(|file| file.sync_all())
                .map_err(|error| cannot_write(&self.folder.join(name), &error))?;
        }
        Ok(())
    }

    fn write_whole(&self, name: &str, bytes: &[u8]) -> Result<(), Sentence> {
        let written = fs::File::create(self.unfinished.join(name)).and_then(|mut file| {
            file.write_all(bytes)?;
            file.sync_all()
        });
        written.map_err(|error| cannot_write(&self.folder.join(name), &error))
    }

    /// Moves every file into its place, replacing those of an earlier run: all of them, or none.
    ///
    /// # Errors
    /// One sentence that names the file; those of the earlier run are as they were.
    pub fn finish(mut self) -> Result<Vec<PathBuf>, Sentence> {
        self.sync_begun()?;
        let names = std::mem::take(&mut self.files);
        self.keep_earlier(&names)?;
        // The list appears at once: half of one would have half of the results moved.
        self.write_whole(LISTED, names.join("\n").as_bytes())?;
        replace(&self.unfinished.join(LISTED), &self.unfinished.join(WHOLE))?;
        sync_folder(&self.unfinished);
        for (index, name) in names.iter().enumerate() {
            let moved = replace(&self.unfinished.join(name), &self.folder.join(name));
            if moved.is_err() {
                self.put_back(&names[..index]);
            }
            moved?;
        }
        sync_folder(&self.folder);
        self.created = false;
        Ok(names.iter().map(|name| self.folder.join(name)).collect())
    }

    /// Keeps the results of an earlier run that these will replace.
    fn keep_earlier(&self, names: &[String]) -> Result<(), Sentence> {
        let earlier = self.unfinished.join(EARLIER);
        for name in names {
            let place = self.folder.join(name);
            if !place.is_file() {
                continue;
            }
            // Where a file system has no second names, a copy serves as well.
            let kept = fs::create_dir_all(&earlier)
                .and_then(|()| fs::hard_link(&place, earlier.join(name)))
                .or_else(|_| fs::copy(&place, earlier.join(name)).map(|_| ()));
            kept.map_err(|error| cannot_write(&place, &error))?;
        }
        Ok(())
    }

    /// Makes the folder as it was before these were moved into it.
    fn put_back(&self, moved: &[String]) {
        // From now on the rest is not to be moved, whatever happens.
        drop(fs::remove_file(self.unfinished.join(WHOLE)));
        for name in moved {
            let place = self.folder.join(name);
            let earlier = self.unfinished.join(EARLIER).join(name);
            // Nothing more can be done about a failure: the run fails with the first one.
            drop(if earlier.is_file() {
                fs::rename(&earlier, &place)
            } else {
                fs::remove_file(&place)
            });
        }
    }
}

/// Whether a run that still goes on holds a lock. Only an ordinary file is one: opening a pipe might never end.
fn is_held(lock: &Path) -> bool {
    if !fs::symlink_metadata(lock).is_ok_and(|data| data.is_file()) {
        return false;
    }
    let lock = fs::File::open(lock);
    lock.is_ok_and(|lock| matches!(lock.try_lock(), Err(fs::TryLockError::WouldBlock)))
}

/// Moves a file to a place, instead of what is there.
fn replace(file: &Path, place: &Path) -> Result<(), Sentence> {
    fs::rename(file, place).map_err(|error| {
        let place = place.display();
        Sentence::new(
            format!("{place}: ファイルを置き換えられません（{error}）。開いているプログラムを閉じてください"),
            format!("{place}: the file cannot be replaced ({error}); close the program that shows it"),
        )
    })
}

impl Drop for OutputFolder {
    fn drop(&mut self) {
        // Some systems remove no file that is open.
        self.lock = None;
        // Nothing can be done about a failure here, and nothing of value is lost by one.
        drop(fs::remove_dir_all(&self.unfinished));
        if self.created {
            drop(fs::remove_dir(&self.folder));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scratch(name: &str) -> PathBuf {
        let folder =
            std::env::temp_dir().join(format!("lole-output-{name}-{}", std::process::id()));
        drop(fs::remove_dir_all(&folder));
        folder
    }

    #[test]
    fn an_abandoned_folder_leaves_nothing() {
        let folder = scratch("abandoned");
        let mut output = OutputFolder::create(&folder).unwrap();
        output.write("half.mp4", b"half").unwrap();
        drop(output);
        assert!(!folder.exists());
    }

    #[test]
    fn what_a_killed_run_left_is_removed_and_a_running_one_is_not_disturbed() {
        let folder = scratch("others");
        let killed = folder.join(format!("{UNFINISHED}-1"));
        let running = folder.join(format!("{UNFINISHED}-2"));
        for other in [&killed, &running] {
            fs::create_dir_all(other).unwrap();
            fs::write(other.join("half.mp4"), b"half").unwrap();
        }
        let lock = fs::File::create(running.join(LOCK)).unwrap();
        lock.lock().unwrap();
        let refused = OutputFolder::create(&folder).err().unwrap();
        assert!(refused.to_string().contains("another run"), "{refused}");
        assert!(running.join("half.mp4").exists());
        drop(lock);
        drop(OutputFolder::create(&folder).unwrap());
        assert!(!killed.exists() && !running.exists());
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn what_a_killed_run_was_moving_is_moved_to_the_end_and_nothing_else_is_touched() {
        let folder = scratch("moving");
        let killed = folder.join(format!("{UNFINISHED}-1"));
        fs::create_dir_all(&killed).unwrap();
        fs::write(folder.join("first.pdf"), b"new").unwrap();
        fs::write(folder.join("second.pdf"), b"old").unwrap();
        fs::write(killed.join("second.pdf"), b"new").unwrap();
        let outside = folder.with_extension("outside");
        fs::write(&outside, b"theirs").unwrap();
        let elsewhere = format!("../{}", outside.file_name().unwrap().to_string_lossy());
        let names = format!("first.pdf\nsecond.pdf\n{elsewhere}\n..\n");
        fs::write(killed.join(WHOLE), names).unwrap();
        drop(OutputFolder::create(&folder).unwrap());
        for name in ["first.pdf", "second.pdf"] {
            assert_eq!(fs::read(folder.join(name)).unwrap(), b"new");
        }
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 2);
        assert_eq!(fs::read(&outside).unwrap(), b"theirs");
        fs::remove_file(&outside).unwrap();
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn half_a_list_moves_nothing() {
        let folder = scratch("half-list");
        let killed = folder.join(format!("{UNFINISHED}-1"));
        fs::create_dir_all(&killed).unwrap();
        for name in ["first.pdf", "second.pdf"] {
            fs::write(folder.join(name), b"old").unwrap();
            fs::write(killed.join(name), b"new").unwrap();
        }
        // Killed after some letters of the list of both.
        fs::write(killed.join(LISTED), "first.pdf\nsec").unwrap();
        drop(OutputFolder::create(&folder).unwrap());
        for name in ["first.pdf", "second.pdf"] {
            assert_eq!(fs::read(folder.join(name)).unwrap(), b"old");
        }
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 2);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn a_file_that_cannot_be_replaced_leaves_all_of_the_earlier_results() {
        let folder = scratch("taken");
        // A folder of that name cannot be replaced by a file.
        fs::create_dir_all(folder.join("second.pdf").join("inside")).unwrap();
        fs::write(folder.join("first.pdf"), b"old").unwrap();
        let mut output = OutputFolder::create(&folder).unwrap();
        for name in ["new.pdf", "first.pdf", "second.pdf"] {
            output.write(name, b"new").unwrap();
        }
        let error = output.finish().unwrap_err();
        assert!(error.to_string().contains("second.pdf"), "{error}");
        assert_eq!(fs::read(folder.join("first.pdf")).unwrap(), b"old");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 2);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn an_earlier_result_survives_an_abandoned_run() {
        let folder = scratch("earlier");
        let mut first = OutputFolder::create(&folder).unwrap();
        first.write("dance.mp4", b"first").unwrap();
        first.finish().unwrap();
        let mut second = OutputFolder::create(&folder).unwrap();
        second.write("dance.mp4", b"second").unwrap();
        drop(second);
        assert_eq!(fs::read(folder.join("dance.mp4")).unwrap(), b"first");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn a_folder_that_cannot_be_written_is_refused_at_once() {
        let file = scratch("file");
        fs::write(&file, b"not a folder").unwrap();
        let error = OutputFolder::create(&file.join("inside")).err().unwrap();
        assert!(
            error.to_string().contains("choose another folder"),
            "{error}"
        );
        fs::remove_file(&file).unwrap();
    }
}
