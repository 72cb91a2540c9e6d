//! Which piece of a dressed garment lies outside where pieces overlap, through a dance.

use lole_garment::dress::{Layers, PieceOver};
use lole_language::Words;

use super::Performance;

/// Watches which cloth of each dressed garment lies outside.
#[derive(Debug, Clone)]
pub struct LayerWatch {
    garments: Vec<Watched>,
}

#[derive(Debug, Clone)]
struct Watched {
    first: Layers,
    worst: usize,
}

/// How a dressed garment covered itself in a dance.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GarmentLayers {
    /// Name in files, such as `blouse`.
    pub id: String,
    /// What it is called.
    pub name: Words,
    /// Which piece lies outside over which as it was put on, most places first.
    pub over: Vec<PieceOver>,
    /// Places where that was the other way around in the worst look.
    pub inverted: usize,
}

impl LayerWatch {
    /// Begins with the layers as they lie now; call [`Performance::pose_body`] first.
    #[must_use]
    pub fn new(performance: &Performance) -> Self {
        let places = 0..performance.production().dressed.len();
        let watched = places.map(|place| Watched {
            first: performance.dressed_layers(place),
            worst: 0,
        });
        Self {
            garments: watched.collect(),
        }
    }

    /// Looks whether any have changed sides; call [`Performance::pose_body`] first.
    pub fn look(&mut self, performance: &Performance) {
        for (place, watched) in self.garments.iter_mut().enumerate() {
            let now = performance.dressed_inversions(place, &watched.first);
            watched.worst = watched.worst.max(now);
        }
    }

    /// What was seen.
    #[must_use]
    pub fn seen(&self, performance: &Performance) -> Vec<GarmentLayers> {
        let production = performance.production();
        let pairs = self.garments.iter().zip(&production.dressed);
        let seen = pairs.filter_map(|(watched, garment)| {
            let design = production.design.garments.get(garment.listed)?;
            let mut over = watched.first.pieces(&garment.dressed);
            over.sort_by_key(|it| std::cmp::Reverse(it.places));
            Some(GarmentLayers {
                id: garment.name.clone(),
                name: design.template.name,
                over,
                inverted: watched.worst,
            })
        });
        seen.collect()
    }
}

impl GarmentLayers {
    /// Places where it covers itself.
    #[must_use]
    pub fn places(&self) -> usize {
        self.over.iter().map(|it| it.places).sum()
    }
}
