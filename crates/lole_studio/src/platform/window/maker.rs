//! Products made one after the other on a thread of their own.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread::{self, JoinHandle};

use crate::making::{Line, Piece, Stage, Unmade, Wish, make, stopped_unexpectedly};

/// A piece on its way to the thread, with what calls it off.
struct Job {
    number: u64,
    wish: Wish,
    is_called_off: Arc<AtomicBool>,
}

/// The thread that makes one thing after the other. Dropped, it is called off and waited for.
pub(crate) struct Maker {
    jobs: Option<Sender<Job>>,
    news: Receiver<(u64, Stage)>,
    stops: Vec<(u64, Arc<AtomicBool>)>,
    count: u64,
    thread: Option<JoinHandle<()>>,
}

impl Maker {
    /// Starts the thread; `wake` is called when there is news. Pieces are numbered from the one after
    /// `last_number`.
    pub(crate) fn start(last_number: u64, wake: impl Fn() + Send + 'static) -> Self {
        Self::start_with(make, last_number, wake)
    }

    fn start_with(make: Make, last_number: u64, wake: impl Fn() + Send + 'static) -> Self {
        let (jobs, received) = mpsc::channel();
        let (sender, news) = mpsc::channel();
        let thread = thread::Builder::new()
            .name("making".to_owned())
            .spawn(move || work(make, &received, &sender, &wake))
            .ok();
        Self {
            jobs: Some(jobs),
            news,
            stops: Vec::new(),
            count: last_number,
            thread,
        }
    }

    /// Asks for a product; it is made when those before it are.
    pub(crate) fn ask(&mut self, wish: Wish) -> Piece {
        self.count += 1;
        let number = self.count;
        let mut piece = Piece {
            number,
            product: wish.product,
            path: wish.path.clone(),
            stage: Stage::Waiting,
        };
        let is_called_off = Arc::new(AtomicBool::new(false));
        self.stops.push((number, Arc::clone(&is_called_off)));
        let job = Job {
            number,
            wish,
            is_called_off,
        };
        let jobs = self.jobs.as_ref().filter(|_| self.thread.is_some());
        if jobs.is_none_or(|jobs| jobs.send(job).is_err()) {
            piece.stage = Stage::Failed(stopped_unexpectedly());
        }
        piece
    }

    /// Calls a product off, whether it waits or is being made.
    pub(crate) fn call_off(&self, number: u64) {
        for (_, stop) in self.stops.iter().filter(|(of, _)| *of == number) {
            stop.store(true, Ordering::Relaxed);
        }
    }

    /// What was told since the last time.
    pub(crate) fn news(&mut self) -> Vec<(u64, Stage)> {
        let news: Vec<_> = self.news.try_iter().collect();
        let is_over =
            |number: &u64| (news.iter()).any(|(of, stage)| of == number && stage.is_end());
        self.stops.retain(|(number, _)| !is_over(number));
        news
    }
}

impl Drop for Maker {
    fn drop(&mut self) {
        for (_, stop) in &self.stops {
            stop.store(true, Ordering::Relaxed);
        }
        self.jobs = None;
        if let Some(thread) = self.thread.take() {
            drop(thread.join());
        }
    }
}

/// Makes one product.
type Make = fn(&Wish, &Line<'_>) -> Result<(), Unmade>;

fn work(make: Make, jobs: &Receiver<Job>, news: &Sender<(u64, Stage)>, wake: &dyn Fn()) {
    while let Ok(job) = jobs.recv() {
        let tell = |stage| {
            // Nobody listens only while the window closes.
            drop(news.send((job.number, stage)));
            wake();
        };
        let line = Line {
            is_called_off: &job.is_called_off,
            tell: &|share| tell(Stage::Working(share)),
        };
        // What goes wrong with one product is told, and leaves the others as they are.
        let made = catch_unwind(AssertUnwindSafe(|| make(&job.wish, &line)));
        tell(match made {
            Ok(Ok(())) => Stage::Done,
            Ok(Err(Unmade::CalledOff)) => Stage::CalledOff,
            Ok(Err(Unmade::Failed(sentence))) => Stage::Failed(sentence),
            Err(_) => Stage::Failed(stopped_unexpectedly()),
        });
    }
}

#[cfg(test)]
mod tests;
