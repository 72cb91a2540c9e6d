//! What lies in a folder, for a question for a file.

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

use lole_export::cutting::PATTERN_JSON;
use lole_export::order::ORDER_JSON;
use lole_language::Sentence;

/// Entries of one folder that are shown; more can be typed.
const MOST_ENTRIES: usize = 2000;
/// Names with numbers are tried up to this one; then the question says what is there.
const MOST_NUMBER: u32 = 999;

/// A folder with what can be chosen in it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Listing {
    /// The folder.
    pub folder: PathBuf,
    /// Folders first, then files that are asked for, by name.
    pub entries: Vec<Entry>,
    /// Places that people keep files in.
    pub places: Vec<PathBuf>,
    /// How many more entries there are that are not shown.
    pub left_out: usize,
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

/// What was found for a question.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Looked {
    /// The folder that was looked into.
    pub(crate) listing: Listing,
    /// A name that was proposed, and one that is free in its place.
    pub(crate) free: Option<[PathBuf; 2]>,
}

/// What lies where a question was answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Lies {
    Nothing,
    File,
    Folder,
    /// A folder with patterns or an order in it.
    Filled,
}

/// What lies at the path that was answered, or at the one that would be written.
pub(crate) fn what_lies(answer: &Path, target: &Path) -> Lies {
    if answer.is_dir() {
        let is_filled = [PATTERN_JSON, ORDER_JSON].map(|name| answer.join(name).exists());
        return if is_filled.contains(&true) {
            Lies::Filled
        } else {
            Lies::Folder
        };
    }
    if target.exists() {
        Lies::File
    } else {
        Lies::Nothing
    }
}

/// The path, or the same with a number where it is taken.
pub(crate) fn free_name(path: &Path, is_taken: impl Fn(&Path) -> bool) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let ending = path.extension().map(OsStr::to_string_lossy);
    let ending = ending.map_or_else(String::new, |ending| format!(".{ending}"));
    let numbered = (2..=MOST_NUMBER).map(|number| format!("{stem}-{number}{ending}"));
    std::iter::once(path.to_owned())
        .chain(numbered.map(|name| path.with_file_name(name)))
        .find(|path| !is_taken(path))
        .unwrap_or_else(|| path.to_owned())
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
    let left_out = entries.len().saturating_sub(MOST_ENTRIES);
    entries.truncate(MOST_ENTRIES);
    Listing {
        entries,
        left_out,
        ..listing
    }
}

/// Whether the name of a file ends in one of these ways, in small or in capital letters.
pub(crate) fn ends_with_one_of(path: &Path, endings: &[&str]) -> bool {
    let ending = path.extension();
    ending.is_some_and(|ending| (endings.iter()).any(|known| ending.eq_ignore_ascii_case(known)))
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
    let mut near = path.ancestors().skip(usize::from(!ends_as_folder(path)));
    let near = near.find(|folder| folder.is_dir());
    let here = || std::env::current_dir().unwrap_or_default();
    near.map_or_else(here, Path::to_owned)
}

/// Whether a path is written as that of a folder.
pub(crate) fn ends_as_folder(path: &Path) -> bool {
    let end = path.as_os_str().as_encoded_bytes().last();
    end.is_some_and(|&end| std::path::is_separator(char::from(end)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_that_is_written_as_a_folder_is_looked_into_and_no_other() {
        let folder = std::env::temp_dir().join(format!("lole-near-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let parent = folder.parent().map(Path::to_owned);
        assert_eq!(Some(folder_of(&folder)), parent);
        assert_eq!(folder_of(&folder.join("")), folder);
        assert_eq!(folder_of(&folder.join("not-there/")), folder);
        assert_eq!(folder_of(&folder.join("a.lole")), folder);
        std::fs::remove_dir_all(&folder).unwrap();
    }

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
        assert!(listing.trouble.is_none() && listing.left_out == 0);
        let lies = |name: &str| what_lies(&folder.join(name), &folder.join(format!("{name}.lole")));
        assert_eq!(
            ["b", "z-folder", "d"].map(lies),
            [Lies::File, Lies::Folder, Lies::Nothing]
        );
        std::fs::write(folder.join("z-folder").join(PATTERN_JSON), "").unwrap();
        assert_eq!(lies("z-folder"), Lies::Filled);
        assert_eq!(folder_of(&folder.join("none/new.lole")), folder);
        std::fs::remove_dir_all(&folder).unwrap();
        assert!(list(&folder, &["lole"]).trouble.is_some());
    }

    #[test]
    fn a_name_that_is_taken_is_given_a_number() {
        let taken = ["縫い方.pdf", "縫い方-2.pdf", "型紙"].map(Path::new);
        let free = |name: &str| free_name(Path::new(name), |path| taken.contains(&path));
        assert_eq!(free("縫い方.pdf"), Path::new("縫い方-3.pdf"));
        assert_eq!(free("型紙"), Path::new("型紙-2"));
        assert_eq!(free("踊り.mp4"), Path::new("踊り.mp4"));
        let all = free_name(Path::new("a.pdf"), |_| true);
        assert_eq!(all, Path::new("a.pdf"));
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
