//! What lies in a folder, for a question for a file. Folders are read on a thread of their own: one
//! that lies on a network may take its time.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver};
use std::thread;

use lole_language::Sentence;

/// Entries of one folder that are shown; more can be typed.
const MOST_ENTRIES: usize = 2000;

/// A folder with what can be chosen in it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Listing {
    /// The folder.
    pub folder: PathBuf,
    /// Folders first, then files that are asked for, by name.
    pub entries: Vec<Entry>,
    /// Places that people keep files in.
    pub places: Vec<PathBuf>,
    /// Why the folder could not be read.
    pub trouble: Option<Sentence>,
}

/// A folder or a file.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Entry {
    /// Whether it is a file.
    pub is_file: bool,
    /// What it is called.
    pub name: String,
}

/// Reads a folder; files whose names end otherwise are left out. All folders are kept.
pub(crate) fn list(folder: &Path, endings: &[&str]) -> Listing {
    let listing = Listing {
        folder: folder.to_owned(),
        places: places(|name| std::env::var_os(name)),
        ..Listing::default()
    };
    let read = match std::fs::read_dir(folder) {
        Ok(read) => read,
        Err(error) => {
            let name = folder.display();
            return Listing {
                trouble: Some(Sentence::new(
                    format!("{name}: このフォルダーは開けません（{error}）。"),
                    format!("{name}: the folder cannot be opened ({error})."),
                )),
                ..listing
            };
        }
    };
    let mut entries: Vec<Entry> = (read.flatten())
        .filter_map(|found| {
            let name = found.file_name().to_string_lossy().into_owned();
            // Links are followed: a link to a folder is one to whoever looks for a file.
            let is_file = !std::fs::metadata(found.path()).ok()?.is_dir();
            let is_hidden = name.starts_with('.');
            let is_asked_for = !is_file || ends_with_one_of(Path::new(&name), endings);
            (is_asked_for && !is_hidden).then_some(Entry { is_file, name })
        })
        .collect();
    entries.sort();
    entries.truncate(MOST_ENTRIES);
    Listing { entries, ..listing }
}

/// Whether the name of a file ends in one of these ways, in small or in capital letters.
pub(crate) fn ends_with_one_of(path: &Path, endings: &[&str]) -> bool {
    let ending = path.extension();
    ending.is_some_and(|ending| (endings.iter()).any(|known| ending.eq_ignore_ascii_case(known)))
}

/// Reads a folder on a thread of its own; `wake` is called when it is read.
pub(crate) fn begin(
    folder: PathBuf,
    endings: &'static [&'static str],
    wake: impl Fn() + Send + 'static,
) -> Receiver<Listing> {
    let (sender, listings) = mpsc::channel();
    let read = move || {
        // The question may have been given up meanwhile.
        drop(sender.send(list(&folder, endings)));
        wake();
    };
    let thread = thread::Builder::new().name("folder".to_owned());
    // Where no thread can be had, the path can still be typed.
    drop(thread.spawn(read));
    listings
}

/// Folders under the user's own one that systems make, in the words of the two languages.
const USUAL: [&str; 8] = [
    "Desktop",
    "デスクトップ",
    "Documents",
    "ドキュメント",
    "Downloads",
    "ダウンロード",
    "Pictures",
    "画像",
];

/// The user's own folder and the usual ones in it, as far as they are there.
fn places(variable: impl Fn(&str) -> Option<OsString>) -> Vec<PathBuf> {
    let own = ["HOME", "USERPROFILE"].into_iter().find_map(variable);
    let Some(own) = own.map(PathBuf::from).filter(|own| own.is_dir()) else {
        return Vec::new();
    };
    let usual = USUAL.map(|name| own.join(name));
    let there = usual.into_iter().filter(|place| place.is_dir());
    let there: Vec<PathBuf> = there.collect();
    std::iter::once(own).chain(there).collect()
}

/// The nearest folder to a path that is there: the one a question begins in.
pub(crate) fn folder_of(path: &Path) -> PathBuf {
    let near = path.ancestors().skip(1).find(|folder| folder.is_dir());
    let here = || std::env::current_dir().unwrap_or_default();
    near.map_or_else(here, Path::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_come_first_and_of_files_those_that_are_asked_for() {
        let folder = std::env::temp_dir().join(format!("lole-chooser-{}", std::process::id()));
        std::fs::create_dir_all(folder.join("z-folder")).unwrap();
        for name in ["b.lole", "a.LOLE", "c.txt", ".hidden.lole"] {
            std::fs::write(folder.join(name), "").unwrap();
        }
        let listing = list(&folder, &["lole"]);
        let names: Vec<&str> = listing.entries.iter().map(|it| it.name.as_str()).collect();
        assert_eq!(names, ["z-folder", "a.LOLE", "b.lole"]);
        assert!(listing.trouble.is_none());
        assert_eq!(folder_of(&folder.join("none/new.lole")), folder);
        std::fs::remove_dir_all(&folder).unwrap();
        assert!(list(&folder, &["lole"]).trouble.is_some());
    }

    #[test]
    fn places_are_those_that_are_there() {
        let own = std::env::temp_dir().join(format!("lole-places-{}", std::process::id()));
        std::fs::create_dir_all(own.join("デスクトップ")).unwrap();
        let of = |name: &str| (name == "HOME").then(|| own.clone().into_os_string());
        assert_eq!(places(of), [own.clone(), own.join("デスクトップ")]);
        std::fs::remove_dir_all(&own).unwrap();
        assert!(places(|_| None).is_empty());
    }
}
