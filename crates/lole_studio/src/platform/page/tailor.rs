//! Drafting between two pictures: it takes less than one.

use std::cell::RefCell;
use std::sync::Arc;

use lole_costume::document::Design;

use crate::paper::{Cutting, PaperDesign};
use crate::tailor::Bench;

/// Whoever drafts.
pub(crate) struct Tailor {
    bench: RefCell<Bench>,
    /// What was asked for last.
    asked: Option<(Design, Cutting)>,
    /// Whether its paper is still to be drawn.
    is_due: RefCell<bool>,
    wake: Box<dyn Fn()>,
}

impl Tailor {
    /// Begins with nothing to do; `wake` is called when there is.
    pub(crate) fn start(wake: impl Fn() + Send + 'static) -> Self {
        Self {
            bench: RefCell::default(),
            asked: None,
            is_due: RefCell::default(),
            wake: Box::new(wake),
        }
    }

    /// Asks for the paper of a design, unless it was asked for already.
    pub(crate) fn ask(&mut self, design: &Design, cutting: Cutting) {
        let is_asked =
            (self.asked.as_ref()).is_some_and(|(asked, how)| asked == design && *how == cutting);
        if !is_asked {
            self.asked = Some((design.clone(), cutting));
            self.is_due.replace(true);
            (self.wake)();
        }
    }

    /// The newest paper, if there is a new one.
    pub(crate) fn take(&self) -> Option<Arc<PaperDesign>> {
        if !self.is_due.replace(false) {
            return None;
        }
        let (design, cutting) = self.asked.as_ref()?;
        let paper = self.bench.borrow_mut().paper(design, *cutting)?;
        Some(Arc::new(paper))
    }
}
