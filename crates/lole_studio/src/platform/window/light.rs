//! The light of the room, worked out on a thread of its own whenever it has rested.

use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use lole_render::AmbientLight;

use crate::clock::Clock;
use crate::light::{Job, REST, SHORTEST_REST, lit};

/// The running thread. Dropped, it ends and is waited for.
pub(crate) struct Light {
    jobs: Option<Sender<Job>>,
    done: Arc<Mutex<Option<(u64, AmbientLight)>>>,
    ready: Receiver<()>,
    is_free: bool,
    thread: Option<JoinHandle<()>>,
}

impl Light {
    /// Starts the thread.
    pub(crate) fn start() -> Self {
        let (jobs, received) = mpsc::channel::<Job>();
        let (free, ready) = mpsc::channel();
        let done = Arc::new(Mutex::new(None));
        let results = Arc::clone(&done);
        let thread = thread::Builder::new()
            .name("light".to_owned())
            .spawn(move || work(&received, &results, &free))
            .ok();
        Self {
            jobs: Some(jobs),
            done,
            ready,
            is_free: true,
            thread,
        }
    }

    /// Lights a snapshot, if the last one is done; lamps stand around the camera.
    pub(crate) fn offer(&mut self, job: Job) {
        self.is_free |= self.ready.try_recv().is_ok();
        if let (true, Some(jobs)) = (self.is_free, &self.jobs) {
            self.is_free = jobs.send(job).is_err();
        }
    }

    /// A new light and the wardrobe that it is for.
    pub(crate) fn take(&self) -> Option<(u64, AmbientLight)> {
        self.done
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .take()
    }
}

impl Drop for Light {
    fn drop(&mut self) {
        self.jobs = None;
        if let Some(thread) = self.thread.take() {
            drop(thread.join());
        }
    }
}

fn work(jobs: &Receiver<Job>, results: &Mutex<Option<(u64, AmbientLight)>>, free: &Sender<()>) {
    while let Ok(job) = jobs.recv() {
        let clock = Clock::start();
        if let Some(light) = lit(&job) {
            *results.lock().unwrap_or_else(PoisonError::into_inner) = Some(light);
        }
        drop(job);
        let rest = (REST * clock.seconds()).max(SHORTEST_REST);
        // No job comes while it rests; the end may.
        let ended = jobs.recv_timeout(Duration::from_secs_f64(rest));
        if matches!(ended, Err(RecvTimeoutError::Disconnected)) || free.send(()).is_err() {
            return;
        }
    }
}
