//! Files: designs and what they name are read, results are written, and nothing half-written takes a file's
//! place.
//!
//! The crate knows no window and draws nothing; what goes wrong is one sentence that names the file.

mod output;
pub mod runs;
pub mod shelf;

use std::collections::BTreeMap;
use std::fs::{self, File, TryLockError};
use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use lole_costume::document::{self, Design, LinkedFile, LinkedPattern};
use lole_exchange::garmentcode;
use lole_exchange::measures::{self, BodyMeasures};
use lole_garment::Given;
use lole_language::{Sentence, Words, words};
use lole_print::Picture;

pub use output::OutputFolder;
pub use runs::RunFolder;

/// A design larger than this [byte] is some other file; it is not even read.
const LARGEST_FILE: u64 = 16 << 20;
/// A recording or an avatar larger than this [byte] is not read: half an hour of a hundred joints
/// has a third.
const LARGEST_LINKED: u64 = 512 << 20;
/// Pictures of one folder that are counted before giving up.
const MOST_PICTURES: u32 = 10_000;

/// Reads the bytes of a design, if the file is small enough to be one.
///
/// # Errors
/// One sentence that names the file.
pub fn read_document(path: &Path) -> Result<Vec<u8>, Sentence> {
    let name = path.display();
    let read = if is_piped(path) {
        read_piped(LARGEST_FILE)
    } else {
        read_ordinary(path, LARGEST_FILE)
    };
    read.map_err(|why| match why {
        Unread::Unreadable => Sentence::new(
            format!("{name}: ファイルが読めません。場所と名前を確かめてください"),
            format!("{name}: the file cannot be read; check the path"),
        ),
        Unread::NoFile => no_ordinary_file(path),
        Unread::TooLarge { megabytes } => Sentence::new(
            format!(
                "{name}: {megabytes} MB もあり、デザインではありません。.lole のファイルを選んでください"
            ),
            format!("{name}: the file has {megabytes} MB and is no design; choose a .lole file"),
        ),
    })
}

/// Whether a path stands for what is piped in or out: `-`.
#[must_use]
pub fn is_piped(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// Reads what is piped in, if it is small enough.
///
/// # Errors
/// Why it was not read.
pub fn read_piped(most: u64) -> Result<Vec<u8>, Unread> {
    let mut bytes = Vec::new();
    let read = io::stdin().lock().take(most + 1).read_to_end(&mut bytes);
    read.map_err(|_| Unread::Unreadable)?;
    if most < bytes.len() as u64 {
        // Nobody knows how much more there is.
        let megabytes = most.div_ceil(1_000_000);
        return Err(Unread::TooLarge { megabytes });
    }
    Ok(bytes)
}

/// Why a file was not read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unread {
    /// It is not there, or may not be read.
    Unreadable,
    /// It is a folder, a pipe or a device: reading it might never end.
    NoFile,
    /// It is larger than asked for.
    TooLarge {
        /// Its size, in MB.
        megabytes: u64,
    },
}

/// Reads all of an ordinary file of at most so many bytes: a pipe that nobody writes to, or a device without an
/// end, is not waited for.
///
/// # Errors
/// See [`Unread`].
pub fn read_ordinary(path: &Path, most: u64) -> Result<Vec<u8>, Unread> {
    let too_large = |size: u64| Unread::TooLarge {
        megabytes: size >> 20,
    };
    if let Some(bytes) = shelf::find(path) {
        return match bytes.len() as u64 {
            size if most < size => Err(too_large(size)),
            _ => Ok(bytes.to_vec()),
        };
    }
    let kind = fs::metadata(path).map_err(|_| Unread::Unreadable)?;
    if !kind.is_file() {
        return Err(Unread::NoFile);
    }
    if most < kind.len() {
        return Err(too_large(kind.len()));
    }
    let file = File::open(path).map_err(|_| Unread::Unreadable)?;
    let mut bytes = Vec::new();
    // It may have grown meanwhile, or be one of those that have no length.
    let limited = &mut file.take(most + 1);
    limited
        .read_to_end(&mut bytes)
        .map_err(|_| Unread::Unreadable)?;
    match bytes.len() as u64 {
        size if most < size => Err(too_large(size)),
        _ => Ok(bytes),
    }
}

/// What is said of a folder, a pipe or a device where a file is wanted.
#[must_use]
pub fn no_ordinary_file(path: &Path) -> Sentence {
    let name = path.display();
    Sentence::new(
        format!(
            "{name}: ふつうのファイルではありません（フォルダーや装置など）。ファイルを指定してください"
        ),
        format!("{name}: this is no ordinary file but a folder, a pipe or a device; name a file"),
    )
}

/// A sentence about what is in a file, with the file's name before it.
#[must_use]
pub fn in_file(path: &Path, sentence: &Sentence) -> Sentence {
    let name = path.display();
    Sentence::new(
        format!("{name}: {}", sentence.japanese),
        format!("{name}: {}", sentence.english),
    )
}

/// Reads a design.
///
/// # Errors
/// One sentence that names the file and, where there is one, the line.
pub fn read_design(path: &Path) -> Result<Design, Sentence> {
    let bytes = read_document(path)?;
    let name = path.display().to_string();
    if let Some(kind) = kind_of(&bytes) {
        return Err(Sentence::new(
            format!(
                "{name}: これは{}で、デザインではありません。.lole のファイルを選んでください",
                kind.japanese
            ),
            format!(
                "{name}: this is {} and no design; choose a .lole file",
                kind.english
            ),
        ));
    }
    let mut design = document::parse_bytes(&bytes, &name).map_err(|error| Sentence::of(&error))?;
    read_linked_files(&mut design, path)?;
    Ok(design)
}

/// What bytes are that are sometimes taken for a design, by how they begin.
fn kind_of(bytes: &[u8]) -> Option<Words> {
    let kinds: [(&[u8], Words); 7] = [
        (b"\xff\xd8\xff", words("写真（JPEG）", "a photo (JPEG)")),
        (b"\x89PNG", words("絵（PNG）", "a picture (PNG)")),
        (b"GIF8", words("絵（GIF）", "a picture (GIF)")),
        (
            b"RIFF",
            words("絵か音（WebP・WAV）", "a picture or sound (WebP, WAV)"),
        ),
        (
            b"%PDF",
            words("印刷用のページ（PDF）", "pages to print (PDF)"),
        ),
        (
            b"PK\x03\x04",
            words(
                "表計算か圧縮ファイル（ZIP）",
                "a spreadsheet or an archive (ZIP)",
            ),
        ),
        (
            b"glTF",
            words("3D ファイル（GLB・VRM）", "a 3D file (GLB, VRM)"),
        ),
    ];
    let found = kinds
        .into_iter()
        .find(|(start, _)| bytes.starts_with(start));
    found.map(|(_, kind)| kind)
}

/// Reads the avatar, the recording and the pictures of prints that a design names, if it names any;
/// their places are from `document` on.
///
/// # Errors
/// One sentence that names the file.
pub fn read_linked_files(design: &mut Design, document: &Path) -> Result<(), Sentence> {
    let avatar = (&mut design.dancer.file, "[dancer] file");
    let recording = (&mut design.motion.file, "[motion] file");
    for (file, key) in [avatar, recording] {
        if let Some(file) = file {
            file.bytes = Some(read_linked(&document.with_file_name(&file.name), key)?);
        }
    }
    for (number, print) in design.prints_mut().enumerate() {
        let key = if number == 0 {
            "[print] file"
        } else {
            "[garment.print] file"
        };
        if let Some(file) = &mut print.file {
            let path = document.with_file_name(&file.name);
            file.picture = Some(read_picture(&path, key)?);
        }
    }
    for garment in &mut design.garments {
        if let Some(file) = &mut garment.file {
            let path = document.with_file_name(&file.name);
            file.given = Some(read_pattern(&path, "[[garment]] file")?);
        }
    }
    Ok(())
}

/// Reads a pattern of another program that a design or a command names under `key`.
///
/// # Errors
/// One sentence that names the file.
pub fn read_pattern(path: &Path, key: &str) -> Result<Arc<Given>, Sentence> {
    let bytes = read_alone(path, key)?;
    let given = garmentcode::read(&bytes).map_err(|error| in_file(path, &Sentence::of(&error)))?;
    Ok(Arc::new(given))
}

/// Reads another program's measures of a body that a command names under `key`.
///
/// # Errors
/// One sentence that names the file.
pub fn read_measures(path: &Path, key: &str) -> Result<BodyMeasures, Sentence> {
    let bytes = read_alone(path, key)?;
    measures::read(&bytes).map_err(|error| in_file(path, &Sentence::of(&error)))
}

/// A pattern of another program for a garment of a design, named by its whole path.
///
/// # Errors
/// One sentence that names the file.
pub fn linked_pattern(path: &Path, key: &str) -> Result<LinkedPattern, Sentence> {
    Ok(LinkedPattern {
        given: Some(read_pattern(path, key)?),
        name: recording_name(path, None),
    })
}

/// Names the files of a design by their whole paths, so that a design that is written elsewhere than
/// at `document` finds them too.
pub fn name_linked_files(design: &mut Design, document: &Path) {
    let whole = |name: &mut String| {
        *name = recording_name(&document.with_file_name(&*name), None);
    };
    let files = [&mut design.dancer.file, &mut design.motion.file];
    for file in files.into_iter().flatten() {
        whole(&mut file.name);
    }
    for print in design.prints_mut() {
        if let Some(file) = &mut print.file {
            whole(&mut file.name);
        }
    }
    for garment in &mut design.garments {
        if let Some(file) = &mut garment.file {
            whole(&mut file.name);
        }
    }
}

/// A file for a design, named by its whole path, so that a design that is written elsewhere finds it
/// too; sentences say that `key` named it.
///
/// # Errors
/// One sentence that names the file.
pub fn linked_file(path: &Path, key: &str) -> Result<LinkedFile, Sentence> {
    Ok(LinkedFile {
        bytes: Some(read_linked(path, key)?),
        name: recording_name(path, None),
    })
}

/// Reads a picture that a design names under `key`.
///
/// # Errors
/// One sentence that names the file.
pub fn read_picture(path: &Path, key: &str) -> Result<Arc<Picture>, Sentence> {
    let bytes = read_linked(path, key)?;
    let picture = Picture::read(&bytes).map_err(|error| in_file(path, &Sentence::of(&error)))?;
    Ok(Arc::new(picture))
}

/// Reads the bytes of a file that a design names under `key`.
///
/// # Errors
/// One sentence that names the file.
pub fn read_linked(path: &Path, key: &str) -> Result<Arc<[u8]>, Sentence> {
    let bytes = read_alone(path, key)?;
    Ok(with_neighbors(bytes, path)?.into())
}

/// A `.gltf` with the data and pictures that lie in files beside it, as one file; any other file as it
/// is. A picture that is missing leaves its plain color; missing data is what the reader complains of.
///
/// # Errors
/// One sentence: an address outside the folder, or a file that is too large.
pub fn with_neighbors(bytes: Vec<u8>, path: &Path) -> Result<Vec<u8>, Sentence> {
    let names =
        lole_avatar::neighbors(&bytes).map_err(|error| in_file(path, &Sentence::of(&error)))?;
    let mut found = BTreeMap::new();
    for name in names {
        let beside = path.with_file_name(&name);
        if is_inside(&beside, path) {
            found.insert(name, read_alone(&beside, "uri")?);
        }
    }
    let gathered = lole_avatar::gathered(&bytes, |name| found.get(name).cloned());
    Ok(gathered.unwrap_or(bytes))
}

/// Whether a file is there, in the folder of another or below it: links that lead out of it count as
/// missing.
fn is_inside(file: &Path, other: &Path) -> bool {
    let whole = |path: &Path| fs::canonicalize(path).ok();
    let folder = whole(other).and_then(|path| path.parent().map(Path::to_owned));
    match (whole(file), folder) {
        (Some(file), Some(folder)) => file.starts_with(folder) && file.is_file(),
        _ => false,
    }
}

fn read_alone(path: &Path, key: &str) -> Result<Vec<u8>, Sentence> {
    let name = path.display();
    let limit = LARGEST_LINKED >> 20;
    read_ordinary(path, LARGEST_LINKED).map_err(|why| match why {
        Unread::Unreadable => Sentence::new(
            format!("{name}: ファイルが読めません。{key} の場所と名前を確かめてください"),
            format!("{name}: the file cannot be read; check the place in {key}"),
        ),
        Unread::NoFile => no_ordinary_file(path),
        Unread::TooLarge { megabytes } => Sentence::new(
            format!("{name}: {megabytes} MB あります。{limit} MB までにしてください"),
            format!("{name}: the file has {megabytes} MB; make it {limit} MB at most"),
        ),
    })
}

/// How a recording is named in a design at `document`: from there where it lies beside or below it,
/// else by its whole path.
pub fn recording_name(recording: &Path, document: Option<&Path>) -> String {
    let whole = fs::canonicalize(recording).unwrap_or_else(|_| recording.to_owned());
    let folder = document.and_then(|path| {
        let folder = path.parent()?;
        let here = folder.as_os_str().is_empty();
        fs::canonicalize(if here { Path::new(".") } else { folder }).ok()
    });
    let near = folder.and_then(|folder| whole.strip_prefix(folder).ok().map(Path::to_owned));
    near.unwrap_or(whole).to_string_lossy().into_owned()
}

/// Writes a design; until all of it is safe, the file stays as it was.
///
/// # Errors
/// One sentence that names the file.
pub fn write_design(path: &Path, design: &Design) -> Result<(), Sentence> {
    write_whole(path, document::to_toml(design).as_bytes())
}

/// The first free name of a picture in `folder`: `lole-1.png` and so on.
#[must_use]
pub fn free_picture(folder: &Path) -> PathBuf {
    let free = (1..MOST_PICTURES)
        .map(|number| folder.join(format!("lole-{number}.png")))
        .find(|path| !path.exists());
    free.unwrap_or_else(|| folder.join("lole.png"))
}

/// Writes beside the file, then takes its place in one move. What an earlier run left beside it is removed.
///
/// # Errors
/// One sentence that names the file.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), Sentence> {
    if shelf::IS_ALL {
        shelf::write(path, bytes);
        return Ok(());
    }
    clear_beside(path);
    let beside = beside(path);
    let written = write_and_move(&beside, path, bytes);
    if written.is_err() {
        // It may never have come to be.
        drop(fs::remove_file(&beside));
    }
    written.map_err(|error| cannot_write(path, &error))
}

/// Fills a folder, all of it or nothing; files of an earlier run are replaced.
///
/// # Errors
/// One sentence that names the file.
pub fn write_folder(folder: &Path, files: &[(String, Vec<u8>)]) -> Result<(), Sentence> {
    if shelf::IS_ALL {
        for (name, bytes) in files {
            shelf::write(&folder.join(name), bytes);
        }
        return Ok(());
    }
    let mut output = OutputFolder::create(folder)?;
    for (name, bytes) in files {
        output.write(name, bytes)?;
    }
    output.finish().map(|_| ())
}

fn cannot_write(path: &Path, error: &io::Error) -> Sentence {
    let name = path.display();
    Sentence::new(
        format!("{name}: 書き込めません（{error}）。場所と空きを確かめてください"),
        format!("{name}: cannot be written ({error}); check the folder and the free space"),
    )
}

fn write_and_move(beside: &Path, path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = File::create(beside)?;
    // Held while it is written, so that nobody takes it for one that was left; where a file system knows no
    // locks, none is.
    drop(file.try_lock());
    file.write_all(bytes)?;
    file.sync_all()?;
    fs::rename(beside, path)?;
    sync_folder(path.parent().unwrap_or(Path::new("")));
    Ok(())
}

/// Asks that what was moved in a folder stays moved when the power fails. Some systems cannot promise that, and what
/// is there is whole all the same.
pub fn sync_folder(folder: &Path) {
    let here = folder.as_os_str().is_empty();
    let folder = File::open(if here { Path::new(".") } else { folder });
    drop(folder.and_then(|folder| folder.sync_all()));
}

/// How the name of a file ends that is not finished.
const PART: &str = ".part";

/// A name in the same folder, so that moving is one step, and of this process alone.
fn beside(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.{}{PART}", std::process::id()))
}

/// Removes what was left beside a file by runs that were killed while they wrote it.
fn clear_beside(path: &Path) {
    let folder = path.parent().unwrap_or(Path::new(""));
    let here = folder.as_os_str().is_empty();
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let start = format!(".{name}.");
    let is_left = |found: &str| {
        let process = found.strip_prefix(&start);
        let process = process.and_then(|rest| rest.strip_suffix(PART));
        process.is_some_and(|number| number.parse::<u32>().is_ok())
    };
    let all = fs::read_dir(if here { Path::new(".") } else { folder });
    for entry in all.into_iter().flatten().flatten() {
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        if !is_file || !is_left(&entry.file_name().to_string_lossy()) {
            continue;
        }
        // Whoever still writes holds it.
        let is_held = File::open(entry.path())
            .is_ok_and(|file| matches!(file.try_lock(), Err(TryLockError::WouldBlock)));
        if !is_held {
            drop(fs::remove_file(entry.path()));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("lole-files-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    #[test]
    fn a_saved_design_opens_as_it_was_and_leaves_nothing_beside() {
        let folder = folder("save");
        let path = folder.join("ハウ.lole");
        let mut design = Design::default();
        design.motion.tempo_bpm = 92.5;
        write_design(&path, &design).unwrap();
        design.skirt.hem_height_cm = 30.0;
        write_design(&path, &design).unwrap();
        assert_eq!(read_design(&path).unwrap(), design);
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn pictures_of_prints_are_read_from_beside_the_design_or_refused_by_name() {
        let folder = folder("print");
        let path = folder.join("mine.lole");
        let text = "lole = 1\n[print]\nfile = \"cloth.svg\"\n[[garment]]\nkind = \"pau-top\"\n\
                    [garment.print]\nfile = \"top.svg\"\n";
        fs::write(&path, text).unwrap();
        let sentence = read_design(&path).unwrap_err();
        assert!(sentence.english.contains("cloth.svg"), "{sentence}");
        assert!(sentence.english.contains("[print] file"), "{sentence}");
        let svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"4\" height=\"2\"/>";
        fs::write(folder.join("cloth.svg"), svg).unwrap();
        fs::write(folder.join("top.svg"), "GIF89a").unwrap();
        let sentence = read_design(&path).unwrap_err();
        assert!(
            sentence.english.contains("top.svg: this is GIF"),
            "{sentence}"
        );
        fs::write(folder.join("top.svg"), svg).unwrap();
        let mut design = read_design(&path).unwrap();
        let read = design.prints_mut().filter_map(|print| print.file.as_ref());
        assert_eq!(read.filter(|file| file.picture.is_some()).count(), 2);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn what_cannot_be_written_leaves_what_was_there() {
        let folder = folder("keep");
        // A folder of that name cannot be replaced by a file.
        let path = folder.join("taken.lole");
        fs::create_dir_all(path.join("inside")).unwrap();
        let sentence = write_design(&path, &Design::default()).unwrap_err();
        assert!(sentence.english.contains("taken.lole"));
        assert!(path.join("inside").exists());
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_bad_document_is_one_sentence_with_its_line() {
        let folder = folder("bad");
        let path = folder.join("bad.lole");
        fs::write(&path, "lole = 1\n[skirt]\nhem_hight_cm = 20\n").unwrap();
        let sentence = read_design(&path).unwrap_err();
        assert!(sentence.english.contains("bad.lole:3"), "{sentence}");
        assert!(read_design(&folder.join("none.lole")).is_err());
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_photo_that_is_opened_as_a_design_is_called_a_photo() {
        let folder = folder("photo");
        let path = folder.join("IMG_1.lole");
        fs::write(&path, b"\xff\xd8\xff\xe0\0\x10JFIF").unwrap();
        let sentence = read_design(&path).unwrap_err();
        assert!(sentence.japanese.contains("写真（JPEG）"), "{sentence}");
        assert!(!sentence.english.contains("UTF-8"), "{sentence}");
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn pictures_do_not_overwrite_each_other() {
        let folder = folder("pictures");
        let first = free_picture(&folder);
        write_whole(&first, &[1]).unwrap();
        assert_ne!(free_picture(&folder), first);
        fs::remove_dir_all(folder).unwrap();
    }
}
