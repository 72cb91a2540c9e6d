//! Results appear whole or not at all: everything is written beside its place and moved there last.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use lole_language::Sentence;

/// Name of the folder for files that are not finished.
const UNFINISHED: &str = ".lole-unfinished";

/// A results folder that is being filled. Dropped without [`OutputFolder::finish`], it removes
/// what it wrote.
pub(crate) struct OutputFolder {
    folder: PathBuf,
    created: bool,
    unfinished: PathBuf,
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
        let output = Self {
            folder: folder.to_owned(),
            created,
            unfinished,
            files: Vec::new(),
        };
        fs::write(output.unfinished.join("probe"), b"lole").with_context(cannot)?;
        fs::remove_file(output.unfinished.join("probe")).with_context(cannot)?;
        Ok(output)
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
