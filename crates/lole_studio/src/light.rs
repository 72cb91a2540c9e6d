//! The light of the room, worked out on a thread of its own whenever it has rested: the picture
//! never waits for it.

use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use lole_render::{AmbientLight, Camera, LightRig};

use crate::Snapshot;
use crate::clock::Clock;

/// It rests this many times as long as it works, so that it takes little from cloth and picture.
const REST: f64 = 8.0;
/// And at least this long [s]: folds move slowly.
const SHORTEST_REST: f64 = 0.25;

/// What is to be lit.
pub(crate) struct Job {
    /// The moment.
    pub(crate) snapshot: Arc<Snapshot>,
    /// Where it is seen from.
    pub(crate) camera: Camera,
    /// Whether the skirt is drawn in coarse triangles.
    pub(crate) is_coarse: bool,
}

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
    while let Ok(Job {
        snapshot,
        camera,
        is_coarse,
    }) = jobs.recv()
    {
        let clock = Clock::start();
        let wardrobe = &snapshot.wardrobe;
        let lights = LightRig::seen_from(&camera);
        let mut scene = (wardrobe.looks).scene(
            &wardrobe.production,
            &snapshot.moment.dancer(),
            camera,
            lights,
        );
        if is_coarse {
            wardrobe.coarsen(&mut scene);
        }
        if let Ok(light) = AmbientLight::of(&scene) {
            *results.lock().unwrap_or_else(PoisonError::into_inner) = Some((wardrobe.id, light));
        }
        drop(snapshot);
        let rest = (REST * clock.seconds()).max(SHORTEST_REST);
        // No job comes while it rests; the end may.
        let ended = jobs.recv_timeout(Duration::from_secs_f64(rest));
        if matches!(ended, Err(RecvTimeoutError::Disconnected)) || free.send(()).is_err() {
            return;
        }
    }
}
