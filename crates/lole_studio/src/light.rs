//! The light of the room on what is drawn, worked out beside the window: the picture never waits for it.

use std::sync::Arc;

use lole_picture::{DrawnDancer, Lamps, Looks, Moment, Scenery};
use lole_render::{AmbientLight, Camera, Scene};

use crate::Snapshot;
use crate::snapshot::Wardrobe;

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
    pub(crate) beside: Option<Neighbor>,
}

/// A dancer beside the one on stage.
#[derive(Clone)]
pub(crate) struct Neighbor {
    /// What she wears.
    pub(crate) wardrobe: Arc<Wardrobe>,
    /// How she stands there.
    pub(crate) moment: Arc<Moment>,
}

impl Neighbor {
    /// What is drawn of both.
    pub(crate) fn scene<'a>(
        beside: Option<&'a Self>,
        (wardrobe, dancer): (&'a Wardrobe, DrawnDancer<'a>),
        (scenery, camera): (Scenery, Camera),
    ) -> Scene<'a> {
        let mut dancers = vec![(&wardrobe.looks, dancer)];
        dancers.extend(beside.map(|it| (&it.wardrobe.looks, it.moment.dancer())));
        Looks::stage(&dancers, (scenery, Lamps::WithCamera), camera)
    }

    /// A number that tells who is on stage together.
    pub(crate) fn together(beside: Option<&Self>, wardrobe: &Wardrobe) -> u64 {
        let other = beside.map_or(0, |it| it.wardrobe.id);
        wardrobe.id ^ other.rotate_left(32)
    }
}

/// The light of a moment and the wardrobe that it is for; `None` where the moment cannot be drawn.
pub(crate) fn lit(job: &Job) -> Option<(u64, AmbientLight)> {
    let wardrobe = &job.snapshot.wardrobe;
    let dancer = job.snapshot.moment.dancer();
    let beside = job.beside.as_ref();
    let mut scene = Neighbor::scene(beside, (wardrobe, dancer), (job.scenery, job.camera));
    if job.is_coarse {
        wardrobe.coarsen(&mut scene);
    }
    let light = AmbientLight::of(&scene).ok()?;
    Some((Neighbor::together(beside, wardrobe), light))
}
