//! For whom and of what a garment is drafted.

use lole_body::Dancer;
use lole_geom::Length;
use lole_pattern::{Alteration, Alterations, Measures};

use crate::template::GarmentLayer;

/// Points of the tape that measures a girth.
const TAPE_POINTS: usize = 360;
/// Distance between the tapes along which a way up the trunk is measured [m].
const WAY_STEP: f32 = 0.005;

/// For whom a garment is drafted, of what cloth, and what it is worn with.
#[derive(Debug, Clone, Copy)]
pub struct Fitting<'a> {
    /// What was measured of her.
    pub measures: &'a Measures,
    /// How fitted garments are altered for her.
    pub alterations: Alterations,
    /// She herself, where there is more of her than measures: a tape is put around her at any height.
    pub dancer: Option<&'a Dancer>,
    /// Width of its cloth, where that is known.
    pub cloth_width: Option<Length>,
    /// Upper edge above the floor of the skirt that it is worn with.
    pub skirt_edge: Option<Length>,
    /// Whether it is worn under or over a skirt; `None` of the skirt itself.
    pub layer: Option<GarmentLayer>,
}

impl<'a> Fitting<'a> {
    /// By measures alone.
    #[must_use]
    pub const fn by(measures: &'a Measures) -> Self {
        Self {
            measures,
            alterations: Alterations::NONE,
            dancer: None,
            cloth_width: None,
            skirt_edge: None,
            layer: None,
        }
    }

    /// The upper arm as fitted garments take it [m].
    pub(crate) fn arm(&self) -> f64 {
        self.measures.upper_arm_girth.to_m() + self.widened_sleeve()
    }

    /// What sleeves are wider by than the arm asks [m].
    pub(crate) const fn widened_sleeve(&self) -> f64 {
        self.alterations.of(Alteration::FullArm).to_m()
    }

    /// What a tape says around the trunk at `height` [m] above the floor: measured on the dancer where she is
    /// there, else between the girths that are known; `None` where none is known near it.
    #[must_use]
    pub fn girth_at(&self, height: f32) -> Option<Length> {
        let Some(dancer) = self.dancer else {
            return self.measures.girth_at(Length::from_m(f64::from(height)));
        };
        let ring = dancer.tape_ring(height, TAPE_POINTS);
        let next = ring.iter().cycle().skip(1);
        let girth: f32 = ring
            .iter()
            .zip(next)
            .map(|(a, b)| a.bind_position.distance(b.bind_position))
            .sum();
        Some(Length::from_m(f64::from(girth)))
    }

    /// Mean way along the trunk from one height [m] above the floor up to another.
    #[must_use]
    pub fn way_up(&self, from: f32, to: f32) -> Length {
        let Some(dancer) = self.dancer else {
            return self.measures.way_up(f64::from(from), f64::from(to));
        };
        let mut way = 0.0;
        let mut height = from;
        let mut below = dancer.tape_ring(height, TAPE_POINTS);
        while height < to {
            height = (height + WAY_STEP).min(to);
            let above = dancer.tape_ring(height, TAPE_POINTS);
            let rises = below.iter().zip(&above);
            let rise: f32 = rises
                .map(|(low, high)| low.bind_position.distance(high.bind_position))
                .sum();
            way += rise / TAPE_POINTS as f32;
            below = above;
        }
        Length::from_m(f64::from(way))
    }
}
