//! What a costume is drafted by: which measures of her, and which alterations after a trial in basted cloth.

use lole_body::Dancer;
use lole_garment::{Fitting, measures};
use lole_geom::Length;
use lole_pattern::{Alteration, Measure, Measures, Pattern, Piece};

use super::fitting;
use crate::document::{Design, GarmentDesign, GarmentLayer};

/// What the garments of a design depend on.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DraftedBy {
    /// Her measures, in the order of [`Measure::ALL`].
    pub measures: Vec<UsedMeasure>,
    /// Alterations, in the order of [`Alteration::ALL`]; none where nothing is fitted.
    pub alterations: Vec<UsedAlteration>,
}

/// A measure that a costume is drafted by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UsedMeasure {
    /// Which.
    pub measure: Measure,
    /// Its value.
    pub length: Length,
    /// Whether it was taken of her for drafting; else her body has it.
    pub is_taken: bool,
}

/// An alteration that changes a garment of a costume.
#[derive(Debug, Clone, PartialEq)]
pub struct UsedAlteration {
    /// Which.
    pub alteration: Alteration,
    /// How much of it the design has [cm].
    pub cm: f64,
    /// The piece that it changes most, as it is without it and with [`SHOWN_CM`] of it.
    pub shown: [Piece; 2],
}

/// Measures are made so much larger and smaller to see what depends on them.
const NUDGE: f64 = 0.01;
/// How much of an alteration is shown [cm]; where that cannot be drafted, half of it is.
pub const SHOWN_CM: f64 = 2.0;

/// What the costume of a design depends on: measures that draft another pattern where they are a little larger
/// or smaller, and alterations that draft another one where there is some of them.
#[must_use]
pub fn drafted_by(design: &Design, dancer: &Dancer) -> DraftedBy {
    let body = measures(dancer);
    let trial = Trial {
        design,
        dancer,
        // What is too far from her body is refused where it is drafted.
        own: (design.dancer.tailor_tape.over(body.clone())).unwrap_or(body),
        garments: (design.cut())
            .map(|place| match place {
                Some(index) => {
                    let garment = design.garments[index].clone();
                    (Some(garment.layer), garment)
                }
                None => (None, design.skirt.garment(&design.fabric, &design.print)),
            })
            .collect(),
    };
    let used = |&alteration: &Alteration| trial.alteration(alteration);
    DraftedBy {
        measures: trial.measures(),
        alterations: Alteration::ALL.iter().filter_map(used).collect(),
    }
}

/// The garments of a design, to be drafted again and again.
struct Trial<'a> {
    design: &'a Design,
    dancer: &'a Dancer,
    own: Measures,
    garments: Vec<(Option<GarmentLayer>, GarmentDesign)>,
}

impl Trial<'_> {
    fn drafts(
        &self,
        measures: &Measures,
        altered: Option<(Alteration, f64)>,
    ) -> Vec<Option<Pattern>> {
        let garments = self.garments.iter();
        let draft = |(layer, garment): &(Option<GarmentLayer>, GarmentDesign)| {
            let fitting = fitting(self.design, (self.dancer, measures), (*layer, garment));
            let alterations = altered.map_or(fitting.alterations, |(one, cm)| {
                fitting.alterations.with_cm(one, cm)
            });
            garment
                .pattern(&Fitting {
                    // The dancer herself would be measured again, whatever the measures say.
                    dancer: None,
                    alterations,
                    ..fitting
                })
                .ok()
        };
        garments.map(draft).collect()
    }

    fn measures(&self) -> Vec<UsedMeasure> {
        let drafted = self.drafts(&self.own, None);
        let is_used = |measure: &Measure| {
            [1.0 - NUDGE, 1.0 + NUDGE].into_iter().any(|ratio| {
                let mut nudged = self.own.clone();
                *measure.of_mut(&mut nudged) = measure.of(&self.own) * ratio;
                self.drafts(&nudged, None) != drafted
            })
        };
        let used = Measure::ALL.iter().copied().filter(is_used);
        used.map(|measure| UsedMeasure {
            measure,
            length: measure.of(&self.own),
            is_taken: self.design.dancer.tailor_tape.has(measure),
        })
        .collect()
    }

    fn alteration(&self, alteration: Alteration) -> Option<UsedAlteration> {
        let plain = self.drafts(&self.own, Some((alteration, 0.0)));
        let shown = [SHOWN_CM, 0.5 * SHOWN_CM].into_iter().find_map(|cm| {
            let altered = self.drafts(&self.own, Some((alteration, cm)));
            let pairs = plain.iter().zip(&altered);
            let pairs = pairs.filter_map(|(one, other)| one.as_ref().zip(other.as_ref()));
            let pieces = pairs.flat_map(|(one, other)| one.pieces.iter().zip(&other.pieces));
            // A strip that is longer for it shows nothing of the body.
            let changed = pieces.map(|(one, other)| {
                let is_shaped = one.rectangle(LEAST_CHANGE).is_none();
                (is_shaped, change(one, other), [one, other])
            });
            let changed = changed.filter(|(_, by, _)| LEAST_CHANGE < *by);
            let most = changed.max_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
            most.map(|(_, _, pieces)| pieces.map(Piece::clone))
        });
        Some(UsedAlteration {
            alteration,
            cm: self.design.alterations.cm(alteration),
            shown: shown?,
        })
    }
}

/// A piece that changes by less is not changed [m].
const LEAST_CHANGE: f64 = 1.0e-4;

/// How much the edge of a piece that changes most is longer or shorter [m].
fn change(one: &Piece, other: &Piece) -> f64 {
    let edges = one.edges.iter().zip(&other.edges);
    edges
        .map(|(one, other)| (one.length() - other.length()).abs())
        .fold(0.0, f64::max)
}
