//! An order worked out by the page itself, between two pictures.

use std::cell::RefCell;
use std::sync::atomic::AtomicBool;

use lole_language::Sentence;

use crate::ordering::{Job, Line, OrderNews, run};

/// One order.
pub(crate) struct OrderWork {
    job: RefCell<Option<Job>>,
    is_called_off: AtomicBool,
}

impl OrderWork {
    /// Begins; `wake` is called when there is news.
    pub(crate) fn begin(job: Job, wake: impl Fn() + Send + 'static) -> Self {
        wake();
        Self {
            job: RefCell::new(Some(job)),
            is_called_off: AtomicBool::new(false),
        }
    }

    /// Calls it off, where it has not begun.
    pub(crate) fn call_off(&self) {
        self.job.take();
    }

    /// What was told since the last time.
    pub(crate) fn news(&self) -> impl Iterator<Item = OrderNews> + '_ {
        self.job.take().into_iter().map(|job| {
            if job.folder.is_some() {
                return OrderNews::Failed(Sentence::new(
                    "ブラウザーでは注文書をまだ書けません。合計はここで見られます。注文書はパソコンの lole で作ってください。",
                    "A page cannot write orders yet; the totals are shown here. Make the order with lole on a computer.",
                ));
            }
            let line = Line {
                called_off: &self.is_called_off,
                tell: &|_| {},
            };
            run(&job, &line).unwrap_or_else(OrderNews::Failed)
        })
    }
}
