//! Questions for files: the folders that are looked into for them, the system's own dialog, and what
//! lies where they were answered. None of it keeps the window waiting.

use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, TryRecvError};
use std::thread;

use lole_costume::roster::Roster;
use lole_files as files;
use lole_language::Words;

use crate::app::App;
use crate::chooser::{self, Lies, Looked};
use crate::ordering;
use crate::request::Verdict;
use crate::studio::{Purpose, Question};

/// A list of dancers with its file.
type FoundList = (PathBuf, Arc<Roster>);

/// What is asked of other threads for the question that is shown.
#[derive(Default)]
pub(crate) struct Asking {
    /// A folder that is being read.
    looked: Option<Receiver<Looked>>,
    /// The system's own dialog, with what it asks for.
    chosen: Option<(Purpose, Receiver<Option<PathBuf>>)>,
    /// Questions that were answered, while it is found out what lies there.
    weighed: VecDeque<(Question, Receiver<Lies>)>,
    /// The list of dancers that the last window had, while it is read.
    roster: Option<Receiver<Option<FoundList>>>,
}

impl App {
    /// Begins to read the list that the last window had; one that is gone is chosen anew, without a
    /// word.
    pub(crate) fn find_roster(&mut self) {
        let known = self.studio.memory.roster.clone();
        if let Some(path) = known.filter(|_| self.studio.order.list.is_none()) {
            let context = self.context.clone();
            let read = move || {
                let list = ordering::read_list(&path).ok()?;
                Some((path, Arc::new(list)))
            };
            let roster = aside(read, move || context.request_repaint());
            self.asking.roster = Some(roster);
        }
    }

    pub(crate) fn ask(&mut self, purpose: Purpose) {
        let known = self.studio.path().map(whole);
        let folder = match known.as_deref().and_then(Path::parent) {
            Some(folder) => folder.to_owned(),
            None => std::env::current_dir().unwrap_or_default(),
        };
        let usual = |words: Words| words.text(self.studio.language);
        let path = match (known, purpose) {
            (Some(path), Purpose::Open | Purpose::Save) => path,
            (None, Purpose::Save) => folder.join("design.lole"),
            (_, Purpose::Order) => folder.join("order"),
            (_, Purpose::Make(product)) => folder.join(usual(product.usual_name())),
            (_, Purpose::Picture) => folder.join("lole-1.png"),
            _ => folder.join(""),
        };
        self.studio.question = Some(Question::new(purpose, path.display().to_string()));
        let awaited = self.studio.making.places();
        self.look(move || {
            let listing = chooser::list(&chooser::folder_of(&path), purpose.endings());
            let free = free_of(purpose, &path, &awaited).map(|free| [path, free]);
            Looked { listing, free }
        });
    }

    /// Begins to read a folder for the question.
    pub(crate) fn list_folder(&mut self, folder: PathBuf) {
        let purpose = self.studio.question.as_ref().map(|it| it.purpose);
        let endings = purpose.map_or(&[][..], Purpose::endings);
        self.look(move || Looked {
            listing: chooser::list(&folder, endings),
            free: None,
        });
    }

    /// Begins to read the folder that is nearest to a picture's path.
    pub(crate) fn look_near(&mut self, path: PathBuf) {
        self.look(move || Looked {
            listing: chooser::list(&chooser::folder_of(&path), Purpose::Picture.endings()),
            free: None,
        });
    }

    fn look(&mut self, look: impl FnOnce() -> Looked + Send + 'static) {
        let context = self.context.clone();
        let looked = aside(look, move || context.request_repaint());
        self.asking.looked = Some(looked);
    }

    /// Finds out what lies where a question was answered, before anything is done.
    pub(crate) fn find_out(&mut self, question: Question) {
        let (Some(answer), Some(target)) = (question.answer(), question.target()) else {
            return;
        };
        let is_own = question.purpose == Purpose::Save
            && self.studio.path().map(whole).as_ref() == Some(&target);
        let is_awaited = self.studio.making.places().contains(&target);
        let look = move || match chooser::what_lies(&answer, &target) {
            // The design's own file is there to be written.
            Lies::File if is_own => Lies::Nothing,
            // What is being made will be there.
            Lies::Nothing if is_awaited => Lies::File,
            lies => lies,
        };
        let context = self.context.clone();
        let lies = aside(look, move || context.request_repaint());
        self.asking.weighed.push_back((question, lies));
    }

    /// What was found for questions since the last picture.
    pub(crate) fn receive_answers(&mut self) {
        if let Some(looked) = news_of(&mut self.asking.looked, |looked| looked)
            && let Some(question) = &mut self.studio.question
        {
            if let Some([proposed, free]) = looked.free
                && Path::new(&question.path) == proposed
            {
                question.path = free.display().to_string();
            }
            question.listing = Some(Arc::new(looked.listing));
        }
        let purpose = self.asking.chosen.as_ref().map(|(purpose, _)| *purpose);
        if let Some(path) = news_of(&mut self.asking.chosen, |(_, chosen)| chosen)
            && let (Some(purpose), Some(question)) = (purpose, &mut self.studio.question)
        {
            question.take_chosen(purpose, path.as_deref());
        }
        if let Some(list) = news_of(&mut self.asking.roster, |roster| roster)
            && self.studio.order.list.is_none()
        {
            self.studio.order.list = list;
        }
        // One that may have to be asked once more waits for the question that is shown.
        if self.studio.question.is_none() {
            self.weigh_next();
        }
    }

    fn weigh_next(&mut self) {
        let told = self.asking.weighed.front().map(|(_, lies)| lies.try_recv());
        let lies = match told {
            None | Some(Err(TryRecvError::Empty)) => return,
            Some(Ok(lies)) => lies,
            // Without a thread nobody knows, and nothing is replaced without a word.
            Some(Err(TryRecvError::Disconnected)) => Lies::File,
        };
        let question = self
            .asking
            .weighed
            .pop_front()
            .map(|(question, _)| question);
        if let Some(verdict) = question.and_then(|question| question.weigh(lies)) {
            self.judge(verdict);
        }
    }

    fn judge(&mut self, verdict: Verdict) {
        match verdict {
            Verdict::Goes(request) => self.follow(request),
            Verdict::Again(question) => self.studio.question = Some(question),
            Verdict::LooksInto(question, folder) => {
                self.studio.question = Some(question);
                self.list_folder(folder);
            }
        }
    }

    /// The system's own dialog, on a thread of its own: the dance goes on behind it.
    pub(crate) fn browse(&mut self) {
        let Some(question) = &self.studio.question else {
            return;
        };
        if self.asking.chosen.is_some() {
            return;
        }
        let purpose = question.purpose;
        let name = Path::new(&question.path).file_name();
        let name = name.map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let (sender, answers) = mpsc::channel();
        let context = self.context.clone();
        let ask = move || {
            // The window may have been closed meanwhile.
            drop(sender.send(dialog(purpose, name)));
            context.request_repaint();
        };
        if cfg!(target_os = "macos") {
            // There, dialogs belong to the main thread.
            ask();
        } else {
            drop(thread::Builder::new().name("dialog".to_owned()).spawn(ask));
        }
        self.asking.chosen = Some((purpose, answers));
    }
}

/// A name that is free, for what is named by the window.
fn free_of(purpose: Purpose, path: &Path, awaited: &[PathBuf]) -> Option<PathBuf> {
    let is_taken = |path: &Path| path.exists() || awaited.iter().any(|it| it == path);
    match purpose {
        Purpose::Make(_) => Some(chooser::free_name(path, is_taken)),
        Purpose::Picture => Some(files::free_picture(path.parent()?)),
        _ => None,
    }
}

/// Asks in the system's own dialog and waits for the answer.
fn dialog(purpose: Purpose, name: String) -> Option<PathBuf> {
    let dialog = rfd::FileDialog::new();
    if purpose.is_folder() {
        return dialog.pick_folder();
    }
    let endings = purpose.endings();
    // Some systems tell capital letters from small ones.
    let capitals = endings.iter().map(|ending| ending.to_ascii_uppercase());
    let small = endings.iter().map(|ending| (*ending).to_owned());
    let both: Vec<String> = small.chain(capitals).collect();
    let dialog = dialog.add_filter(endings.join(", "), &both);
    if purpose.writes() {
        dialog.set_file_name(name).save_file()
    } else {
        dialog.pick_file()
    }
}

/// A path from the root, so that it means the same in every folder.
fn whole(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// What came from a thread; one that has told its news, or will never, is forgotten.
fn news_of<Kept, News>(
    kept: &mut Option<Kept>,
    line: impl FnOnce(&Kept) -> &Receiver<News>,
) -> Option<News> {
    let told = line(kept.as_ref()?).try_recv();
    if !matches!(told, Err(TryRecvError::Empty)) {
        *kept = None;
    }
    told.ok()
}

/// Looks at files on a thread of its own, because a folder on a network may take its time; `wake` is called when
/// it is done.
fn aside<Found: Send + 'static>(
    look: impl FnOnce() -> Found + Send + 'static,
    wake: impl Fn() + Send + 'static,
) -> Receiver<Found> {
    let (sender, found) = mpsc::channel();
    let read = move || {
        // The question may have been given up meanwhile.
        drop(sender.send(look()));
        wake();
    };
    let thread = thread::Builder::new().name("folder".to_owned());
    // Where no thread can be had, the path can still be typed.
    drop(thread.spawn(read));
    found
}
