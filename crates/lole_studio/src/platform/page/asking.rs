//! Questions for files: what is read is chosen in the browser's own window, what is written is downloaded.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use lole_language::Words;

use super::browser::{choose, hand_out};
use crate::app::App;
use crate::studio::{Purpose, Question};

/// Files that were chosen, with what for.
#[derive(Default)]
pub(crate) struct Asking {
    chosen: Rc<RefCell<VecDeque<(Purpose, PathBuf)>>>,
}

impl App {
    /// Nothing: the list of the last visit lies in no folder.
    pub(crate) const fn find_roster(&mut self) {}

    /// Asks for a file to read, or writes what is to be written under its usual name.
    pub(crate) fn ask(&mut self, purpose: Purpose) {
        if !purpose.writes() {
            let (chosen, context) = (Rc::clone(&self.asking.chosen), self.context.clone());
            choose(purpose.endings(), move |path| {
                chosen.borrow_mut().push_back((purpose, path));
                context.request_repaint();
            });
            return;
        }
        let usual = |words: Words| PathBuf::from(words.text(self.studio.language));
        let known = self.studio.path().map(Path::to_owned);
        let path = match purpose {
            Purpose::Make(product) => usual(product.usual_name()),
            Purpose::Order => PathBuf::from("order"),
            Purpose::Picture => PathBuf::from("lole-1.png"),
            _ => known.unwrap_or_else(|| PathBuf::from("design.lole")),
        };
        self.answer(purpose, &path);
    }

    fn answer(&mut self, purpose: Purpose, path: &Path) {
        let question = Question::new(purpose, path.display().to_string());
        if let Some(request) = question.request() {
            self.follow(request);
        }
    }

    /// Nothing: a page has no folders.
    #[expect(clippy::needless_pass_by_value, reason = "as a window takes it")]
    pub(crate) fn list_folder(&self, _folder: PathBuf) {}

    /// Nothing: a page has no folders.
    #[expect(clippy::needless_pass_by_value, reason = "as a window takes it")]
    pub(crate) fn look_near(&self, _path: PathBuf) {}

    /// Follows an answer: a browser replaces nothing.
    pub(crate) fn find_out(&mut self, question: Question) {
        if let Some(request) = question.request() {
            self.follow(request);
        }
    }

    /// Takes in what was chosen since the last picture, and hands out what was written.
    pub(crate) fn receive_answers(&mut self) {
        let chosen: Vec<_> = self.asking.chosen.borrow_mut().drain(..).collect();
        for (purpose, path) in chosen {
            self.answer(purpose, &path);
        }
        hand_out();
    }

    /// Nothing: the browser's own window was asked first.
    pub(crate) const fn browse(&self) {}
}
