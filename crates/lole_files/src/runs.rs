//! The folder of many runs: a record of every run that ended, whole, and the files that belong to it.
//!
//! Records are named by what was run, so that whoever runs it again finds it done, whatever was killed in between
//! and however many write into the folder at once.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use lole_costume::document::Design;
use lole_geom::fnv;
use lole_language::Sentence;

use crate::{cannot_write, read_linked, read_ordinary, write_whole};

/// Folder of the records in the folder of results.
const RUNS: &str = "runs";
/// Largest record [byte]: a document and its figures have a few thousand.
const LARGEST_RECORD: u64 = 2 << 20;

/// A folder of results that many may fill at once.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RunFolder {
    folder: PathBuf,
}

impl RunFolder {
    /// Makes the folder, where it is not there, and proves that it can be written.
    ///
    /// # Errors
    /// One sentence that names the folder.
    pub fn create(folder: &Path) -> Result<Self, Sentence> {
        let runs = folder.join(RUNS);
        fs::create_dir_all(&runs).map_err(|error| cannot_write(&runs, &error))?;
        Ok(Self {
            folder: folder.to_owned(),
        })
    }

    /// A folder that others have filled; nothing is made.
    #[must_use]
    pub fn at(folder: &Path) -> Self {
        Self {
            folder: folder.to_owned(),
        }
    }

    /// The bytes of a run's record; `None` where it has not ended.
    #[must_use]
    pub fn record(&self, id: &str) -> Option<Vec<u8>> {
        read_ordinary(&self.place(id, ".json"), LARGEST_RECORD).ok()
    }

    /// Keeps a run: its files first and its record last, so that a record stands for all of them.
    ///
    /// # Errors
    /// One sentence that names the file.
    pub fn keep(&self, id: &str, record: &[u8], files: &[(&str, Vec<u8>)]) -> Result<(), Sentence> {
        let place = self.place(id, ".json");
        let folder = place.parent().unwrap_or(&self.folder);
        fs::create_dir_all(folder).map_err(|error| cannot_write(folder, &error))?;
        for (ending, bytes) in files {
            write_whole(&self.place(id, ending), bytes)?;
        }
        write_whole(&place, record)
    }

    /// Takes a run over from another folder, with its files of these endings.
    ///
    /// # Errors
    /// One sentence: a file of it is missing there, or cannot be written here.
    pub fn take(&self, other: &Self, id: &str, endings: &[&str]) -> Result<(), Sentence> {
        let mut files = Vec::new();
        for &ending in endings {
            let place = other.place(id, ending);
            // What a run that failed could not leave is missing there, too.
            if place.exists() {
                files.push((ending, read_linked(&place, "--from")?.to_vec()));
            }
        }
        let record = read_linked(&other.place(id, ".json"), "--from")?;
        self.keep(id, &record, &files)
    }

    /// Two hundred and fifty-six folders, so that none of them has a million files.
    fn place(&self, id: &str, ending: &str) -> PathBuf {
        let first = id.get(..2).unwrap_or(id);
        self.folder
            .join(RUNS)
            .join(first)
            .join(format!("{id}{ending}"))
    }
}

/// A hash of the bytes of all files that any of these designs at `document` names: another where one of them
/// has changed.
///
/// # Errors
/// One sentence that names a file that cannot be read.
pub fn linked_hash(designs: &[Design], document: &Path) -> Result<u64, Sentence> {
    let mut names = BTreeSet::new();
    for design in designs {
        let mut design = design.clone();
        let alone = [
            (&design.dancer.file, "[dancer] file"),
            (&design.motion.file, "[motion] file"),
        ];
        for (file, key) in alone {
            names.extend(file.as_ref().map(|file| (file.name.clone(), key)));
        }
        for print in design.prints_mut() {
            names.extend(
                print
                    .file
                    .as_ref()
                    .map(|file| (file.name.clone(), "[print] file")),
            );
        }
        for garment in &design.garments {
            let file = garment.file.as_ref();
            names.extend(file.map(|file| (file.name.clone(), "[[garment]] file")));
        }
    }
    let mut hash = fnv::BASIS;
    for (name, key) in names {
        let bytes = read_linked(&document.with_file_name(&name), key)?;
        hash = hash.wrapping_mul(fnv::PRIME) ^ fnv::hash(bytes.iter().copied());
    }
    Ok(hash)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scratch(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("lole-runs-{name}-{}", std::process::id()));
        drop(fs::remove_dir_all(&folder));
        folder
    }

    #[test]
    fn a_run_is_there_with_all_of_its_files_or_not_at_all() {
        let folder = scratch("whole");
        let runs = RunFolder::create(&folder).unwrap();
        assert_eq!(runs.record("0123"), None);
        // A folder of that name cannot be replaced by a file.
        fs::create_dir_all(runs.place("0123", "-series.csv").join("inside")).unwrap();
        let files = [("-series.csv", b"time".to_vec())];
        assert!(runs.keep("0123", b"record", &files).is_err());
        assert_eq!(runs.record("0123"), None);
        fs::remove_dir_all(runs.place("0123", "-series.csv")).unwrap();
        runs.keep("0123", b"record", &files).unwrap();
        assert_eq!(runs.record("0123").unwrap(), b"record");
        let other = RunFolder::create(&scratch("taken")).unwrap();
        other
            .take(&runs, "0123", &["-series.csv", ".lole"])
            .unwrap();
        assert_eq!(other.record("0123").unwrap(), b"record");
        assert_eq!(
            fs::read(other.place("0123", "-series.csv")).unwrap(),
            b"time"
        );
        for folder in [folder, other.folder] {
            fs::remove_dir_all(folder).unwrap();
        }
    }

    #[test]
    fn a_file_that_changed_makes_another_hash_and_a_missing_one_is_named() {
        let folder = scratch("linked");
        fs::create_dir_all(&folder).unwrap();
        let document = folder.join("d.lole");
        let design = Design {
            motion: lole_costume::document::MotionDesign {
                file: Some(lole_costume::document::LinkedFile::named("d.bvh")),
                ..Default::default()
            },
            ..Design::default()
        };
        let hash = || linked_hash(std::slice::from_ref(&design), &document);
        let missing = hash().unwrap_err();
        assert!(missing.english.contains("d.bvh"), "{missing}");
        let of = |bytes: &[u8]| {
            fs::write(folder.join("d.bvh"), bytes).unwrap();
            hash().unwrap()
        };
        assert_eq!(of(b"one"), of(b"one"));
        assert_ne!(of(b"one"), of(b"two"));
        fs::remove_dir_all(folder).unwrap();
    }
}
