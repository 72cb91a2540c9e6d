//! Results appear whole or not at all: everything is written beside its place and moved there last.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use lole_language::Sentence;

/// Name of the folder for files that are not finished.
const UNFINISHED: &str = ".lole-unfinished";
/// A file in it that is locked while the run lasts; the system unlocks what was killed.
const LOCK: &str = "lock";

/// A results folder that is being filled. Dropped without [`OutputFolder::finish`], it removes
/// what it wrote.
pub(crate) struct OutputFolder {
    folder: PathBuf,
    created: bool,
    unfinished: PathBuf,
    /// Held while the run lasts.
    lock: Option<fs::File>,
    files: Vec<String>,
}

impl OutputFolder {
    /// Makes the folder and proves that it can be written.
    pub(crate) fn create(folder: &Path) -> Result<Self> {
        let created = !folder.exists();
        let cannot = || {
            let folder = folder.display();
            Sentence::new(
                format!(
                    "{folder}: このフォルダーには書けません。--out で別のフォルダーを選んでください"
                ),
                format!("{folder}: the folder cannot be written; choose another with --out"),
            )
        };
        fs::create_dir_all(folder).with_context(cannot)?;
        let unfinished = folder.join(format!("{UNFINISHED}-{}", std::process::id()));
        fs::create_dir_all(&unfinished).with_context(cannot)?;
        let mut output = Self {
            folder: folder.to_owned(),
            created,
            unfinished,
            lock: None,
            files: Vec::new(),
        };
        fs::write(output.unfinished.join("probe"), b"lole").with_context(cannot)?;
        fs::remove_file(output.unfinished.join("probe")).with_context(cannot)?;
        let lock = fs::File::create(output.unfinished.join(LOCK)).with_context(cannot)?;
        // Where a file system knows no locks, runs are not kept apart.
        drop(lock.try_lock());
        output.lock = Some(lock);
        output.clear_others()?;
        Ok(output)
    }

    /// Removes what runs that were killed have left; one that still goes on is left alone, and refuses this one.
    fn clear_others(&self) -> Result<()> {
        let all = fs::read_dir(&self.folder).into_iter().flatten().flatten();
        let others = all.map(|entry| entry.path()).filter(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with(UNFINISHED) && *path != self.unfinished
        });
        for other in others {
            let lock = fs::File::open(other.join(LOCK));
            let is_held =
                lock.is_ok_and(|lock| matches!(lock.try_lock(), Err(fs::TryLockError::WouldBlock)));
            if is_held {
                let folder = self.folder.display();
                return Err(Sentence::new(
                    format!("{folder}: 別の実行がこのフォルダーに書いています。終わるのを待つか、--out で別のフォルダーを選んでください"),
                    format!("{folder}: another run is writing into this folder; wait for it or choose another with --out"),
                )
                .into());
            }
            drop(fs::remove_dir_all(&other));
        }
        Ok(())
    }

    /// Writes one file, not yet in its place.
    pub(crate) fn write(&mut self, name: &str, bytes: &[u8]) -> Result<()> {
        let path = self.unfinished.join(name);
        let cannot = || {
            let file = self.folder.join(name);
            let file = file.display();
            Sentence::new(
                format!(
                    "{file}: ファイルが書けません。空きを作るか、--out で別のフォルダーを選んでください"
                ),
                format!(
                    "{file}: the file cannot be written; free space or choose another folder with --out"
                ),
            )
        };
        let mut file = fs::File::create(&path).with_context(cannot)?;
        file.write_all(bytes)
            .and_then(|()| file.sync_all())
            .with_context(cannot)?;
        self.files.push(name.to_owned());
        Ok(())
    }

    /// Moves every file into its place, replacing those of an earlier run.
    pub(crate) fn finish(mut self) -> Result<Vec<PathBuf>> {
        let names = std::mem::take(&mut self.files);
        let mut paths = Vec::new();
        for name in names {
            let path = self.folder.join(&name);
            fs::rename(self.unfinished.join(&name), &path).with_context(|| {
                let path = path.display();
                Sentence::new(
                    format!(
                        "{path}: ファイルを置き換えられません。開いているプログラムを閉じてください"
                    ),
                    format!("{path}: the file cannot be replaced; close the program that shows it"),
                )
            })?;
            paths.push(path);
        }
        self.created = false;
        Ok(paths)
    }
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
        assert!(error.to_string().contains("--out"), "{error}");
        fs::remove_file(&file).unwrap();
    }
}
