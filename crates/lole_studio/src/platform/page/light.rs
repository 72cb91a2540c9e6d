//! The light of the room, worked out in a worker of its own.

use std::cell::Cell;
use std::rc::Rc;
use std::sync::Arc;

use lole_render::AmbientLight;

use super::worker::{Wake, Worker, answer, hear};
use crate::Snapshot;
use crate::clock::Clock;
use crate::light::{Job, REST, SHORTEST_REST, lit};
use crate::platform::letters::{
    get_camera, get_moment, get_scenery, get_wardrobe, put_camera, put_moment, put_scenery,
    put_wardrobe,
};
use crate::platform::parcel::{Packer, Unpacker};
use crate::snapshot::Wardrobe;

/// What the worker is called.
pub(super) const ROLE: &str = "light";

const WARDROBE: u8 = 0;
const MOMENT: u8 = 1;

/// The worker as the page sees it.
pub(crate) struct Light {
    worker: Option<Worker>,
    /// The wardrobe that it has.
    wardrobe: u64,
    clock: Clock,
    /// When the last job was sent, while it is at work.
    begun: Option<f64>,
    /// When it has rested.
    rested: Cell<f64>,
    is_back: Cell<bool>,
}

impl Light {
    /// Starts the worker.
    pub(crate) fn start() -> Self {
        let wake: Wake = Rc::new(|| {});
        Self {
            worker: Worker::start(ROLE, &wake),
            wardrobe: 0,
            clock: Clock::start(),
            begun: None,
            rested: Cell::new(0.0),
            is_back: Cell::new(true),
        }
    }

    /// Lights a snapshot, if the last one is done; lamps stand around the camera.
    pub(crate) fn offer(&mut self, job: Job) {
        if job.beside.is_some() {
            // The worker knows one wardrobe; two dancers have the even light of before.
            return;
        }
        let now = self.clock.seconds();
        let Some(worker) = &self.worker else { return };
        if !self.is_back.get() || now < self.rested.get() {
            return;
        }
        let wardrobe = &job.snapshot.wardrobe;
        if self.wardrobe != wardrobe.id {
            self.wardrobe = wardrobe.id;
            let mut parcel = Packer::default();
            parcel.put(WARDROBE);
            put_wardrobe(&mut parcel, wardrobe);
            worker.post(&parcel);
        }
        let mut parcel = Packer::default();
        parcel.put(MOMENT);
        put_camera(&mut parcel, &job.camera);
        put_scenery(&mut parcel, job.scenery);
        parcel.flag(job.is_coarse);
        put_moment(&mut parcel, &job.snapshot.moment);
        worker.post(&parcel);
        self.begun = Some(now);
        self.is_back.set(false);
    }

    /// A new light and the wardrobe that it is for.
    pub(crate) fn take(&self) -> Option<(u64, AmbientLight)> {
        let parcel = self.worker.as_ref()?.receive()?;
        let now = self.clock.seconds();
        let took = now - self.begun.unwrap_or(now);
        self.rested.set(now + (REST * took).max(SHORTEST_REST));
        self.is_back.set(true);
        let mut parcel = Unpacker(&parcel);
        let id = parcel.get()?;
        Some((id, AmbientLight::from_faces(parcel.list()?)))
    }
}

/// Works as the light until the page ends it.
pub(super) fn serve() {
    let mut wardrobe: Option<Arc<Wardrobe>> = None;
    hear(move |parcel| {
        let mut parcel = Unpacker(parcel);
        match parcel.get::<u8>() {
            Some(WARDROBE) => wardrobe = get_wardrobe(&mut parcel).map(Arc::new),
            Some(MOMENT) => {
                let light = (wardrobe.as_ref()).and_then(|wardrobe| work(wardrobe, &mut parcel));
                let mut answered = Packer::default();
                // Nothing is an answer too, so that the next one is asked for.
                if let Some((id, light)) = light {
                    answered.put(id);
                    answered.list(light.faces());
                }
                answer(&answered);
            }
            _ => {}
        }
    });
}

fn work(wardrobe: &Arc<Wardrobe>, parcel: &mut Unpacker<'_>) -> Option<(u64, AmbientLight)> {
    let camera = get_camera(parcel)?;
    let scenery = get_scenery(parcel)?;
    let is_coarse = parcel.flag()?;
    let moment = get_moment(parcel)?;
    lit(&Job {
        snapshot: Arc::new(Snapshot::showing(wardrobe, moment, 0.0)),
        camera,
        scenery,
        is_coarse,
        beside: None,
    })
}
