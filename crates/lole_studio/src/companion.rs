//! Who dances beside the one on stage: a take that was kept, to be compared.

use std::sync::Arc;

use lole_picture::{DrawnDancer, Lamps, Looks, Moment, Scenery};
use lole_render::{Camera, Scene};

use crate::snapshot::Wardrobe;

/// A dancer beside the one on stage.
#[derive(Clone)]
pub(crate) struct Companion {
    /// What she wears.
    pub(crate) wardrobe: Arc<Wardrobe>,
    /// How she stands there.
    pub(crate) moment: Arc<Moment>,
}

impl Companion {
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
