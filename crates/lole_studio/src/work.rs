//! The work of a window as text: every state that can be gone back to, and the files it is from.
//!
//! ```text
//! lole-work 1
//! file 15            path of a file, empty where there is none yet
//! skirts/hau.lole
//! saved 812          what that file holds
//! …
//! past 0 812         a state, with the number of its file
//! …
//! now 0 815
//! …
//! future 0 812
//! …
//! ```
//!
//! The last number of a line is the length of what follows [byte].

use std::collections::BTreeMap;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use lole_costume::document::{self, Design};
use lole_print::Picture;

use crate::studio::OpenFile;
use crate::wished::Wished;

/// First line of the text.
const HEAD: &str = "lole-work 1";

/// The work done in a window.
#[derive(Debug, Clone, PartialEq)]
pub struct Work {
    pub(crate) files: Vec<OpenFile>,
    /// The oldest first.
    pub(crate) past: Vec<Wished>,
    pub(crate) present: Wished,
    /// What was taken back, the next one last.
    pub(crate) future: Vec<Wished>,
}

impl Work {
    /// Name of the design's file, if it has one.
    #[must_use]
    pub fn name(&self) -> Option<String> {
        let path = self.files.get(self.present.file)?.path.as_ref()?;
        Some(path.file_name()?.to_string_lossy().into_owned())
    }

    /// Whether something would be lost with it: a design that was left for another one, or is the
    /// present one, and is not what its file holds.
    pub(crate) fn is_unsaved(&self) -> bool {
        let states = || self.past.iter().chain([&self.present]);
        let after = states().skip(1).map(Some).chain([None]);
        states().zip(after).any(|(state, next)| {
            let is_last = next.is_none_or(|next| next.file != state.file);
            is_last && state.design != self.files[state.file].saved
        })
    }

    /// The text.
    pub(crate) fn to_bytes(&self) -> Vec<u8> {
        let mut text = format!("{HEAD}\n").into_bytes();
        let mut write = |head: String, body: &[u8]| {
            // Writing to memory cannot fail.
            drop(writeln!(text, "{head} {}", body.len()));
            text.extend_from_slice(body);
            text.push(b'\n');
        };
        for file in &self.files {
            let path = file.path.as_ref().map(|path| path.to_string_lossy());
            write("file".to_owned(), path.unwrap_or_default().as_bytes());
            let saved = document::to_toml(&file.saved);
            write("saved".to_owned(), saved.as_bytes());
        }
        let past = self.past.iter().map(|state| ("past", state));
        let future = self.future.iter().map(|state| ("future", state));
        for (kind, state) in past.chain([("now", &self.present)]).chain(future) {
            let design = document::to_toml(&state.design);
            write(format!("{kind} {}", state.file), design.as_bytes());
        }
        text
    }

    /// Reads the text; `read` gives the bytes of a recording. States that are no design, because a
    /// number was just being mended, are left out. `None` where nothing can be read.
    pub(crate) fn parse(
        bytes: &[u8],
        mut read: impl FnMut(&Path) -> Option<Arc<[u8]>>,
    ) -> Option<Self> {
        let mut rest = bytes.strip_prefix(HEAD.as_bytes())?.strip_prefix(b"\n")?;
        let mut files: Vec<OpenFile> = Vec::new();
        let (mut past, mut future, mut present) = (Vec::new(), Vec::new(), None);
        let (mut recordings, mut pictures) = (BTreeMap::new(), BTreeMap::new());
        while let Some((head, body, after)) = record(rest) {
            rest = after;
            let mut words = head.split(' ');
            let kind = words.next()?;
            if kind == "file" {
                let path = (!body.is_empty()).then(|| PathBuf::from(body));
                let saved = Design::default();
                files.push(OpenFile { path, saved });
                continue;
            }
            let Ok(mut design) = document::parse(body, "") else {
                continue;
            };
            let number = words.next().and_then(|word| word.parse().ok());
            let file = match kind {
                "saved" => files.len().checked_sub(1)?,
                _ => number?,
            };
            let path = files.get(file)?.path.clone();
            let from = path.unwrap_or_default();
            if let Some(recording) = &mut design.motion.file {
                let bytes = recordings.entry(from.with_file_name(&recording.name));
                let bytes = bytes.or_insert_with_key(|place| read(place));
                recording.bytes.clone_from(bytes);
            }
            for file in design.prints_mut().filter_map(|print| print.file.as_mut()) {
                let picture = pictures.entry(from.with_file_name(&file.name));
                let picture = picture.or_insert_with_key(|place| {
                    let picture = Picture::read(&read(place)?).ok()?;
                    Some(Arc::new(picture))
                });
                file.picture.clone_from(picture);
            }
            match kind {
                "saved" => files[file].saved = design,
                "past" => past.push(Wished::new(design, file)),
                "now" => present = Some(Wished::new(design, file)),
                "future" => future.push(Wished::new(design, file)),
                _ => {}
            }
        }
        Some(Self {
            present: present.or_else(|| past.pop())?,
            files,
            past,
            future,
        })
    }
}

/// The first record, without the number that ends its line, and what follows it.
fn record(text: &[u8]) -> Option<(&str, &str, &[u8])> {
    let end = text.iter().position(|&byte| byte == b'\n')?;
    let (head, length) = str::from_utf8(&text[..end]).ok()?.rsplit_once(' ')?;
    let (body, rest) = text[end + 1..].split_at_checked(length.parse().ok()?)?;
    Some((
        head,
        str::from_utf8(body).ok()?,
        rest.strip_prefix(b"\n").unwrap_or(rest),
    ))
}

#[cfg(test)]
mod tests {
    use lole_language::Language;

    use super::*;
    use crate::Studio;

    fn worked() -> Studio {
        let mut studio = Studio::new(Language::English, Design::default(), None);
        for height in [25.0, 30.0, 35.0] {
            studio.change(|design| design.skirt.hem_height_cm = height);
            studio.rest();
        }
        studio.opened(Design::default(), Some(PathBuf::from("/tmp/ハウ.lole")));
        studio.change(|design| design.motion.tempo_bpm = 92.5);
        studio.rest();
        studio.undo();
        studio
    }

    #[test]
    fn work_reads_back_as_it_was_written() {
        let work = worked().work();
        assert_eq!((work.past.len(), work.future.len()), (4, 1));
        let read = Work::parse(&work.to_bytes(), |_| None).unwrap();
        assert_eq!(read, work);
        assert_eq!(read.name().as_deref(), Some("ハウ.lole"));
    }

    #[test]
    fn what_was_left_unsaved_for_another_file_is_worth_keeping() {
        let mut studio = Studio::new(Language::English, Design::default(), None);
        assert!(!studio.work().is_unsaved());
        studio.change(|design| design.skirt.hem_height_cm = 30.0);
        studio.rest();
        assert!(studio.work().is_unsaved());
        studio.opened(Design::default(), None);
        assert!(!studio.is_changed() && studio.work().is_unsaved());
        studio.undo();
        studio.saved_at(PathBuf::from("a.lole"));
        studio.redo();
        assert!(!studio.work().is_unsaved());
    }

    #[test]
    fn work_that_is_cut_short_gives_what_can_be_read_and_never_panics() {
        let bytes = worked().work().to_bytes();
        for length in 0..bytes.len() {
            let read = Work::parse(&bytes[..length], |_| None);
            assert!(read.is_none_or(|work| work.past.len() <= 4), "{length}");
        }
    }

    #[test]
    fn a_state_that_is_no_design_gives_way_to_the_one_before() {
        let mut studio = Studio::new(Language::English, Design::default(), None);
        studio.change(|design| design.dancer.hip_cm = Some(92.0));
        studio.rest();
        studio.change(|design| design.dancer.waist_cm = Some(130.0));
        studio.rest();
        assert!(studio.hindrance.is_some());
        let read = Work::parse(&studio.work().to_bytes(), |_| None).unwrap();
        assert_eq!(read.present.design.dancer.hip_cm, Some(92.0));
        assert_eq!(read.present.design.dancer.waist_cm, None);
    }
}
