//! An order worked out on a thread of its own.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::thread::{self, JoinHandle};

use crate::ordering::{Job, Line, OrderNews, run};

/// The thread of one order. Dropped, it is called off and waited for.
pub(crate) struct OrderWork {
    stop: Arc<AtomicBool>,
    news: Receiver<OrderNews>,
    thread: Option<JoinHandle<()>>,
}

impl OrderWork {
    /// Begins; `wake` is called when there is news.
    pub(crate) fn begin(job: Job, wake: impl Fn() + Send + 'static) -> Self {
        let stop = Arc::new(AtomicBool::new(false));
        let (sender, news) = mpsc::channel();
        let called_off = Arc::clone(&stop);
        let thread = thread::Builder::new()
            .name("order".to_owned())
            .spawn(move || {
                let tell = |news| {
                    // Nobody listens only while the window closes.
                    drop(sender.send(news));
                    wake();
                };
                let line = Line {
                    called_off: &called_off,
                    tell: &tell,
                };
                let end = run(&job, &line);
                tell(end.unwrap_or_else(OrderNews::Failed));
            })
            .ok();
        Self { stop, news, thread }
    }

    /// Calls it off; what was written is taken away again.
    pub(crate) fn call_off(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }

    /// What was told since the last time.
    pub(crate) fn news(&self) -> impl Iterator<Item = OrderNews> + '_ {
        self.news.try_iter()
    }
}

impl Drop for OrderWork {
    fn drop(&mut self) {
        self.call_off();
        if let Some(thread) = self.thread.take() {
            drop(thread.join());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ordering::tests::job;

    fn end(work: &OrderWork) -> OrderNews {
        loop {
            match work.news.recv().unwrap() {
                OrderNews::Progress(progress) => assert!(progress.done < progress.of),
                end => return end,
            }
        }
    }

    const LIST: &str = "name,stature,hip\nKeola,171,101\nʻIolana,158,oops\nNani,150,85\n";

    #[test]
    fn an_order_is_written_whole_with_the_rows_that_cannot_be_used() {
        let folder = std::env::temp_dir().join(format!("lole-order-{}", std::process::id()));
        let work = OrderWork::begin(job(LIST, Some(folder.clone())), || {});
        let OrderNews::Done(totals, Some(written)) = end(&work) else {
            panic!("the order was not written")
        };
        assert_eq!(totals.group.plans.len(), 2);
        assert!(
            totals.group.problems[0]
                .english
                .contains("line 3, column 3")
        );
        let sum: f64 = totals.prints.iter().map(|print| print.needed.to_m()).sum();
        assert!((5.0..12.0).contains(&sum), "{sum} m");
        for name in ["order.pdf", "booklet.pdf", "order.json"] {
            assert!(written.join(name).exists(), "{name}");
        }
        assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 3);
        std::fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn an_order_that_is_called_off_leaves_nothing() {
        let folder = std::env::temp_dir().join(format!("lole-off-{}", std::process::id()));
        let work = OrderWork::begin(job(LIST, Some(folder.clone())), || {});
        work.call_off();
        assert!(matches!(end(&work), OrderNews::CalledOff));
        assert!(!folder.exists());
    }
}
