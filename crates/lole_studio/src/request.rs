//! What the panels ask of the program around them, and the question for a file.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use lole_language::Sentence;

use crate::chooser::{Lies, Listing};
use crate::making::{Product, with_ending};

/// What the program around the panels is asked for: it has files and dialogs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Request {
    /// Ask which design to open.
    AskOpen,
    /// Ask which recording to dance.
    AskRecording,
    /// Ask where to save.
    AskSave,
    /// Let the system's own dialog ask instead.
    Browse,
    /// Look into this folder for the question that is shown.
    ListFolder(PathBuf),
    /// Open this file.
    Open(PathBuf),
    /// Save there.
    Save(PathBuf),
    /// Dance this recording.
    OpenRecording(PathBuf),
    /// Ask which picture is printed on a garment of the list, from 0; `None` is the skirt.
    AskPicture(Option<usize>),
    /// Print it.
    OpenPicture(Option<usize>, PathBuf),
    /// Ask for the list of a group's dancers.
    AskRoster,
    /// Read it.
    OpenRoster(PathBuf),
    /// Work out what the group needs.
    WorkOutOrder,
    /// Ask where the order is to be written.
    AskOrderFolder,
    /// Write it there.
    MakeOrder(PathBuf),
    /// Stop working on it.
    CallOffOrder,
    /// Go on with the work that was found.
    Resume,
    /// Throw it away.
    Discard,
    /// Keep the picture as it is now and ask where to write it.
    Picture,
    /// Write the picture that was kept there.
    SavePicture(PathBuf),
    /// Ask where a product of the design is to be written.
    AskMake(Product),
    /// Make it there.
    Make(Product, PathBuf),
    /// Make no more of the product of this number.
    CallOff(u64),
    /// Show this file's folder with the system's own program.
    Reveal(PathBuf),
}

/// A question for a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Question {
    /// Whether a file is opened or saved.
    pub purpose: Purpose,
    /// What was typed.
    pub path: String,
    /// The folder in which a name without one is meant, until another is looked into.
    pub folder: PathBuf,
    /// The folder that is looked into, once it was read.
    pub listing: Option<Arc<Listing>>,
    /// What is to be said of it.
    pub note: Option<Sentence>,
    /// What is there already and is replaced if it is the answer once more.
    pub replaces: Option<PathBuf>,
}

/// What becomes of an answer.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// It is done.
    Goes(Request),
    /// The question is shown again.
    Again(Question),
    /// It is shown again, and looks into this folder.
    LooksInto(Question, PathBuf),
}

impl Question {
    /// A question before anything was read or said.
    #[must_use]
    pub fn new(purpose: Purpose, path: impl Into<String>) -> Self {
        let path = path.into();
        let whole = Path::new(&path);
        let folder = if crate::chooser::ends_as_folder(whole) {
            whole
        } else {
            whole.parent().unwrap_or(Path::new(""))
        };
        Self {
            purpose,
            folder: folder.to_owned(),
            path,
            listing: None,
            note: None,
            replaces: None,
        }
    }

    /// What was typed, as a whole path: a name alone is meant in the folder that is shown.
    pub(crate) fn answer(&self) -> Option<PathBuf> {
        let typed = self.path.trim();
        let shown = self.listing.as_ref().map(|listing| &listing.folder);
        let folder = shown.unwrap_or(&self.folder);
        // Joined to a folder, a whole path stays as it is.
        (!typed.is_empty()).then(|| folder.join(typed))
    }

    /// The file or folder that would be written.
    pub(crate) fn target(&self) -> Option<PathBuf> {
        let path = self.answer()?;
        Some(match self.purpose.ending() {
            Some(ending) => with_ending(&path, ending),
            None => path,
        })
    }

    /// Whether the answer is one that replaces something, which was told already.
    pub(crate) fn is_replacing(&self) -> bool {
        self.replaces.is_some() && self.replaces == self.target()
    }

    /// What is to be done with the answer.
    pub(crate) fn request(&self) -> Option<Request> {
        let path = self.answer()?;
        Some(match self.purpose {
            Purpose::Open => Request::Open(path),
            Purpose::Save => Request::Save(path),
            Purpose::Record => Request::OpenRecording(path),
            Purpose::Print(place) => Request::OpenPicture(place, path),
            Purpose::Roster => Request::OpenRoster(path),
            Purpose::Order => Request::MakeOrder(path),
            Purpose::Make(product) => Request::Make(product, path),
            Purpose::Picture => Request::SavePicture(path),
        })
    }

    /// Weighs the answer against what lies there: a folder is looked into unless one was asked for, and
    /// before something is replaced the question is asked once more. `None` where there is no answer.
    pub(crate) fn weigh(mut self, lies: Lies) -> Option<Verdict> {
        let (path, target) = (self.answer()?, self.target()?);
        if lies == Lies::Folder && !self.purpose.is_folder() {
            return Some(Verdict::LooksInto(self, path));
        }
        let is_there = matches!(lies, Lies::File | Lies::Filled);
        if !self.purpose.writes() || !is_there || self.is_replacing() {
            return Some(Verdict::Goes(self.request()?));
        }
        let name = target.file_name().unwrap_or(target.as_os_str());
        let name = name.to_string_lossy().into_owned();
        self.note = Some(if lies == Lies::Filled {
            Sentence::new(
                format!(
                    "{name} には、前に書いた型紙や注文書があります。よければ「上書きする」を押してください。別の名前にもできます。"
                ),
                format!(
                    "{name} holds patterns or an order already. Press “Replace it” to replace them, or give another name."
                ),
            )
        } else {
            Sentence::new(
                format!(
                    "{name} はもうあります。よければ「上書きする」を押してください。別の名前にもできます。"
                ),
                format!(
                    "{name} is there already. Press “Replace it” to replace it, or give another name."
                ),
            )
        });
        self.replaces = Some(target);
        Some(Verdict::Again(self))
    }

    /// Takes in what was chosen in the system's own dialog, if that was asked for the same.
    pub(crate) fn take_chosen(&mut self, asked_for: Purpose, path: Option<&Path>) {
        if asked_for != self.purpose {
            return;
        }
        match path {
            Some(path) => self.path = path.display().to_string(),
            None => {
                self.note = Some(Sentence::new(
                    "パソコンのファイル選択では選ばれませんでした（それがないパソコンもあります）。上の一覧から選べます。",
                    "Nothing was chosen in the system’s window (some systems have none). Choose from the list above.",
                ));
            }
        }
    }
}

/// What a file is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// To read a design.
    Open,
    /// To write the design.
    Save,
    /// To dance a recording.
    Record,
    /// To print a picture on a garment of the list, from 0; `None` is the skirt.
    Print(Option<usize>),
    /// To read a list of dancers.
    Roster,
    /// To write an order.
    Order,
    /// To write something that is made of the design.
    Make(Product),
    /// To write the picture.
    Picture,
}

impl Purpose {
    /// Whether a folder is asked for.
    #[must_use]
    pub const fn is_folder(self) -> bool {
        matches!(self, Self::Order | Self::Make(Product::Pattern))
    }

    /// Whether something is written there.
    #[must_use]
    pub const fn writes(self) -> bool {
        matches!(
            self,
            Self::Save | Self::Order | Self::Make(_) | Self::Picture
        )
    }

    /// How the name of a file that is written ends; a folder has no ending.
    const fn ending(self) -> Option<&'static str> {
        match self {
            Self::Save => Some("lole"),
            Self::Picture => Some("png"),
            Self::Make(product) => product.ending(),
            _ => None,
        }
    }

    /// How names of files that are asked for end.
    pub(crate) const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Open => &["lole", "png", "jpg", "jpeg", "svg"],
            Self::Save => &["lole"],
            Self::Record => &["bvh", "vrma", "glb", "gltf", "vrm"],
            Self::Print(_) => &["png", "jpg", "jpeg", "svg"],
            Self::Roster if cfg!(target_arch = "wasm32") => &["csv", "tsv", "txt"],
            Self::Roster => &["csv", "tsv", "txt", "xlsx", "ods"],
            Self::Order | Self::Make(Product::Pattern) => &[],
            Self::Make(Product::Booklet) => &["pdf"],
            Self::Make(Product::Film | Product::GroupFilm) => &["mp4"],
            Self::Make(Product::Model) => &["glb"],
            Self::Picture => &["png"],
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;

    fn question(purpose: Purpose, typed: &str) -> Question {
        Question {
            path: typed.to_owned(),
            ..Question::new(purpose, "/silk/design.lole")
        }
    }

    #[test]
    fn a_name_without_a_folder_is_meant_in_the_folder_that_is_shown() {
        let mut question = question(Purpose::Save, "hula");
        assert_eq!(question.answer(), Some("/silk/hula".into()));
        question.listing = Some(Arc::new(Listing {
            folder: "/silk/red".into(),
            ..Listing::default()
        }));
        assert_eq!(question.answer(), Some("/silk/red/hula".into()));
        assert_eq!(question.target(), Some("/silk/red/hula.lole".into()));
        question.path = "/cotton/hula 1.5".to_owned();
        assert_eq!(question.target(), Some("/cotton/hula 1.5.lole".into()));
        question.path = " ".to_owned();
        assert_eq!(question.request(), None);
    }

    #[test]
    fn what_is_there_is_replaced_only_when_it_was_asked_once_more() {
        let booklet = Purpose::Make(Product::Booklet);
        let make = |name: &str| Request::Make(Product::Booklet, Path::new("/silk").join(name));
        let free = question(booklet, "a.pdf").weigh(Lies::Nothing);
        assert_eq!(free, Some(Verdict::Goes(make("a.pdf"))));
        let Some(Verdict::Again(mut again)) = question(booklet, "a").weigh(Lies::File) else {
            panic!("a booklet was replaced without a word")
        };
        assert!(again.is_replacing());
        let note = again.note.clone().unwrap();
        assert!(note.english.starts_with("a.pdf is there already"), "{note}");
        let agreed = again.clone().weigh(Lies::File);
        assert_eq!(agreed, Some(Verdict::Goes(make("a"))));
        // What was agreed to is that one file.
        again.path = "b".to_owned();
        assert!(!again.is_replacing());
        assert!(matches!(again.weigh(Lies::File), Some(Verdict::Again(_))));
    }

    #[test]
    fn folders_are_looked_into_or_filled_and_files_that_are_read_are_no_hindrance() {
        let into = question(Purpose::Open, "red").weigh(Lies::Folder);
        let Some(Verdict::LooksInto(_, folder)) = into else {
            panic!("a folder was opened")
        };
        assert_eq!(folder, Path::new("/silk/red"));
        let pattern = |lies| question(Purpose::Make(Product::Pattern), "red").weigh(lies);
        assert!(matches!(pattern(Lies::Folder), Some(Verdict::Goes(_))));
        assert!(matches!(pattern(Lies::Filled), Some(Verdict::Again(_))));
        let opened = question(Purpose::Open, "a.lole").weigh(Lies::File);
        assert!(matches!(opened, Some(Verdict::Goes(Request::Open(_)))));
    }

    #[test]
    fn what_was_chosen_for_another_question_is_dropped() {
        let mut question = question(Purpose::Open, "a.lole");
        question.take_chosen(Purpose::Save, Some(Path::new("/silk/b.lole")));
        question.take_chosen(Purpose::Save, None);
        assert_eq!((question.path.as_str(), &question.note), ("a.lole", &None));
        question.take_chosen(Purpose::Open, None);
        assert!(question.note.is_some());
        question.take_chosen(Purpose::Open, Some(Path::new("/silk/b.lole")));
        assert_eq!(question.path, "/silk/b.lole");
    }
}
