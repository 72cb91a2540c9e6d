//! Drafting on a thread of its own.

use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread::{self, JoinHandle};

use lole_costume::document::Design;

use crate::paper::{Cutting, PaperDesign};
use crate::tailor::Bench;

/// The running thread. Dropped, it ends and is waited for.
pub(crate) struct Tailor {
    wishes: Option<Sender<(Box<Design>, Cutting)>>,
    papers: Receiver<Arc<PaperDesign>>,
    /// What was asked for last.
    asked: Option<(Design, Cutting)>,
    thread: Option<JoinHandle<()>>,
}

impl Tailor {
    /// Starts the thread; `wake` is called when a paper is ready.
    pub(crate) fn start(wake: impl Fn() + Send + 'static) -> Self {
        let (wishes, received) = mpsc::channel();
        let (done, papers) = mpsc::channel();
        let thread = thread::Builder::new()
            .name("tailor".to_owned())
            .spawn(move || work(&received, &done, wake))
            .ok();
        Self {
            wishes: Some(wishes),
            papers,
            asked: None,
            thread,
        }
    }

    /// Asks for the paper of a design, unless it was asked for already.
    pub(crate) fn ask(&mut self, design: &Design, cutting: Cutting) {
        let is_asked =
            (self.asked.as_ref()).is_some_and(|(asked, how)| asked == design && *how == cutting);
        if let (false, Some(wishes)) = (is_asked, &self.wishes) {
            self.asked = Some((design.clone(), cutting));
            // The thread lives until the sender goes.
            drop(wishes.send((Box::new(design.clone()), cutting)));
        }
    }

    /// The newest paper, if there is a new one.
    pub(crate) fn take(&self) -> Option<Arc<PaperDesign>> {
        self.papers.try_iter().last()
    }
}

impl Drop for Tailor {
    fn drop(&mut self) {
        self.wishes = None;
        if let Some(thread) = self.thread.take() {
            drop(thread.join());
        }
    }
}

fn work(
    wishes: &Receiver<(Box<Design>, Cutting)>,
    papers: &Sender<Arc<PaperDesign>>,
    wake: impl Fn(),
) {
    let mut bench = Bench::default();
    while let Ok(first) = wishes.recv() {
        // Of many only the last counts.
        let (design, cutting) = wishes.try_iter().last().unwrap_or(first);
        let Some(paper) = bench.paper(&design, cutting) else {
            continue;
        };
        if papers.send(Arc::new(paper)).is_err() {
            return;
        }
        wake();
    }
}
