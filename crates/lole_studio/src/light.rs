//! The light of the room on what is drawn, worked out beside the window: the picture never waits for it.

use std::sync::Arc;

use lole_picture::Scenery;
use lole_render::{AmbientLight, Camera};

use crate::Snapshot;
use crate::companion::Companion;

/// It rests this many times as long as it works, so that it takes little from cloth and picture.
pub(crate) const REST: f64 = 8.0;
/// And at least this long [s]: folds move slowly.
pub(crate) const SHORTEST_REST: f64 = 0.25;

/// What is to be lit.
pub(crate) struct Job {
    /// The moment.
    pub(crate) snapshot: Arc<Snapshot>,
    /// Where it is seen from.
    pub(crate) camera: Camera,
    /// What is around her.
    pub(crate) scenery: Scenery,
    /// Whether the skirt is drawn in coarse triangles.
    pub(crate) is_coarse: bool,
    /// Who dances beside her.
    pub(crate) beside: Option<Companion>,
}

/// The light of a moment and the wardrobe that it is for; `None` where the moment cannot be drawn.
pub(crate) fn lit(job: &Job) -> Option<(u64, AmbientLight)> {
    let wardrobe = &job.snapshot.wardrobe;
    let dancer = job.snapshot.moment.dancer();
    let beside = job.beside.as_ref();
    let mut scene = Companion::scene(beside, (wardrobe, dancer), (job.scenery, job.camera));
    if job.is_coarse {
        wardrobe.coarsen(&mut scene);
    }
    let light = AmbientLight::of(&scene).ok()?;
    Some((Companion::together(beside, wardrobe), light))
}
