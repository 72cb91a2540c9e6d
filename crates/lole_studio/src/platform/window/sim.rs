//! The simulation on a thread of its own.

use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use lole_costume::document::Design;

use crate::sim::sewing::Entrance;
use crate::sim::stagehand::{Rest, Stagehand};
use crate::sim::{Input, News, Outbox};
use crate::{Command, Snapshot};

/// Where the thread leaves what it has to show.
#[derive(Clone)]
struct Slot {
    slot: Arc<Mutex<Option<Arc<Snapshot>>>>,
    news: Sender<News>,
    wake: Arc<dyn Fn() + Send + Sync>,
}

impl Outbox for Slot {
    fn is_empty(&self) -> bool {
        lock(&self.slot).is_none()
    }

    fn post(&self, snapshot: Snapshot) {
        *lock(&self.slot) = Some(Arc::new(snapshot));
        (self.wake)();
    }

    fn say(&self, news: News) {
        // Nobody listens only while the window closes.
        drop(self.news.send(news));
        (self.wake)();
    }
}

/// The lock, also after a panic elsewhere: the slot holds a whole snapshot or none.
fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Works until it is told to quit.
fn work(mut hand: Stagehand, inputs: &Receiver<Input>) {
    loop {
        let input = match hand.turn(inputs) {
            Rest::Ended => return,
            Rest::None => continue,
            Rest::Until(seconds) => inputs.recv_timeout(Duration::from_secs_f64(seconds)).ok(),
            Rest::Called => inputs.recv().ok().or(Some(Input::Wanted(Command::Quit))),
        };
        if let Some(input) = input {
            hand.take_in(input);
        }
    }
}

/// The running thread. Dropped, it ends and is waited for.
pub(crate) struct Sim {
    inputs: Sender<Input>,
    slot: Arc<Mutex<Option<Arc<Snapshot>>>>,
    news: Receiver<News>,
    thread: Option<JoinHandle<()>>,
}

impl Sim {
    /// Starts the show of `design`; `wake` is called whenever there is something new.
    pub(crate) fn start(design: Design, wake: Arc<dyn Fn() + Send + Sync>) -> Self {
        let (inputs, received) = mpsc::channel();
        let (news_sender, news) = mpsc::channel();
        let slot = Arc::new(Mutex::new(None));
        let outbox = Box::new(Slot {
            slot: Arc::clone(&slot),
            news: news_sender,
            wake,
        });
        let back = inputs.clone();
        let thread = thread::Builder::new()
            .name("simulation".to_owned())
            .spawn(move || {
                let hand = Stagehand::new(design, Entrance::Settling, back, outbox);
                work(hand, &received);
            })
            .ok();
        Self {
            inputs,
            slot,
            news,
            thread,
        }
    }

    /// Sends a wish.
    pub(crate) fn send(&self, command: Command) {
        // A thread that has ended is noticed by `is_alive`.
        drop(self.inputs.send(Input::Wanted(command)));
    }

    /// The newest snapshot, if there is one that was not taken yet.
    pub(crate) fn take(&self) -> Option<Arc<Snapshot>> {
        lock(&self.slot).take()
    }

    /// What was said since the last time.
    pub(crate) fn news(&self) -> impl Iterator<Item = News> {
        self.news.try_iter()
    }

    /// Whether the thread runs.
    pub(crate) fn is_alive(&self) -> bool {
        (self.thread.as_ref()).is_some_and(|thread| !thread.is_finished())
    }
}

impl Drop for Sim {
    fn drop(&mut self) {
        self.send(Command::Quit);
        if let Some(thread) = self.thread.take() {
            // Its panic was said when it happened; there is nothing left to do about it.
            drop(thread.join());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::clock::Clock;

    fn coarse() -> Design {
        let mut design = Design::default();
        design.skirt.column_count = 96;
        design.skirt.row_count = 24;
        design
    }

    /// The first snapshot that fits, or nothing after a while.
    fn wait_for(sim: &Sim, fits: impl Fn(&Snapshot) -> bool) -> Option<Arc<Snapshot>> {
        let clock = Clock::start();
        while clock.seconds() < 20.0 {
            if let Some(snapshot) = sim.take().filter(|snapshot| fits(snapshot)) {
                return Some(snapshot);
            }
            thread::sleep(Duration::from_millis(5));
        }
        None
    }

    #[test]
    fn a_single_step_is_one_frame_and_pausing_stops() {
        let sim = Sim::start(coarse(), Arc::new(|| {}));
        sim.send(Command::Pause);
        let first = wait_for(&sim, |_| true).unwrap();
        sim.send(Command::Step);
        let second = wait_for(&sim, |_| true).unwrap();
        let frames = (second.time - first.time) * 60.0;
        assert!((frames - 1.0).abs() < 0.01, "{frames}");
        thread::sleep(Duration::from_millis(60));
        assert!(sim.take().is_none());
        sim.send(Command::Play);
        assert!(wait_for(&sim, |snapshot| second.time + 0.05 < snapshot.time).is_some());
    }

    #[test]
    fn a_new_cut_is_sewn_while_the_old_skirt_dances_on() {
        let sim = Sim::start(coarse(), Arc::new(|| {}));
        let first = wait_for(&sim, |_| true).unwrap();
        let mut design = coarse();
        design.skirt.gather_ratio = 3.0;
        sim.send(Command::Wish(Box::new(design)));
        let old = first.wardrobe.id;
        assert!(wait_for(&sim, |snapshot| snapshot.wardrobe.id == old).is_some());
        let new = wait_for(&sim, |snapshot| snapshot.wardrobe.id != old).unwrap();
        assert!(0.0 <= new.time, "the new skirt has settled");
        let said: Vec<News> = sim.news().collect();
        assert!(said.ends_with(&[News::Sewing, News::Sewn]), "{said:?}");
    }

    #[test]
    fn a_wish_that_cannot_be_granted_changes_nothing() {
        let sim = Sim::start(coarse(), Arc::new(|| {}));
        let first = wait_for(&sim, |_| true).unwrap();
        let mut design = coarse();
        design.skirt.gather_ratio = 1.0;
        design.skirt.hem_height_cm = 21.0;
        design.skirt.row_count = 12;
        design.skirt.elastic_row_count = 6;
        sim.send(Command::Wish(Box::new(design)));
        let clock = Clock::start();
        let mut refused = None;
        while refused.is_none() && clock.seconds() < 20.0 {
            refused = sim.news().find(|news| matches!(news, News::Refused(..)));
        }
        let Some(News::Refused(sentence, kept)) = refused else {
            panic!("it was granted");
        };
        assert!(!sentence.japanese.is_empty() && *kept == coarse());
        let later = wait_for(&sim, |_| true).unwrap();
        assert_eq!(later.wardrobe.id, first.wardrobe.id);
    }
}
