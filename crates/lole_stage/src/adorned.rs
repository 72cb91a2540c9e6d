//! What a dancer wears or holds beside the cloth: lei, wreaths, flowers, skirts of strands, instruments.

use std::ops::Range;
use std::sync::Arc;

use glam::{Affine3A, Vec3};
use lole_body::{Dancer, DrawnBody, MeshPart, PartKind};
use lole_cloth::strands::Ring;
use lole_costume::document::{Design, GarmentDesign};
use lole_costume::tailoring::numbered;
use lole_garment::adorn::{Grip, HangingStrands, OnStrand, Surface, Wearer, adorn};
use lole_garment::template::Wear;

use crate::StageError;

/// Something worn or held, as it is drawn and moved.
#[derive(Debug, Clone, PartialEq)]
pub struct Adornment {
    /// Name in files; no two of a dancer share one.
    pub name: String,
    /// Place in the design's list of garments.
    pub place: usize,
    /// What is drawn, by what it is made of.
    pub surfaces: Vec<Surface>,
    /// What moves by itself; `None` where bones carry all of it.
    pub strands: Option<HangingStrands>,
    /// Hands that hold it.
    pub grips: Vec<Grip>,
    /// Its particles, those of its strands, among those of everything that moves by itself; they come after all
    /// cloth.
    pub particles: Range<usize>,
}

impl Adornment {
    /// Mass of every particle [kg]: half a spacing of a strand belongs to each of its ends.
    pub(crate) fn masses(&self) -> impl Iterator<Item = f32> + '_ {
        let strands = self.strands.iter().flat_map(|hung| &hung.strands);
        strands.flat_map(|strand| {
            let mass = strand.linear_density * strand.spacing;
            let last = strand.positions.len() - 1;
            (0..=last).map(move |particle| {
                let is_end = strand.ring == Ring::Open && (particle == 0 || particle == last);
                if is_end { 0.5 * mass } else { mass }
            })
        })
    }

    /// Whether each particle is carried by the body.
    pub(crate) fn pinned(&self) -> impl Iterator<Item = bool> + '_ {
        let strands = self.strands.iter().flat_map(|hung| &hung.strands);
        strands.flat_map(|strand| {
            (0..)
                .zip(&strand.positions)
                .map(|(particle, _)| strand.pinned.contains(&particle))
        })
    }

    /// How much longer or shorter than laid out each strand is about each particle, whose places are `positions`
    /// [m]: the mean of `length / spacing - 1` to its neighbors.
    pub(crate) fn strain(&self, positions: &[Vec3]) -> Vec<f32> {
        let mut strains = Vec::with_capacity(positions.len());
        let mut first = 0;
        for strand in self.strands.iter().flat_map(|hung| &hung.strands) {
            let count = strand.positions.len();
            let own = &positions[first..first + count];
            first += count;
            let to_next = |particle: usize| {
                let next = match strand.ring {
                    Ring::Open => particle + 1,
                    Ring::Closed => (particle + 1) % count,
                };
                let next = own.get(next)?;
                Some(own[particle].distance(*next) / strand.spacing - 1.0)
            };
            strains.extend((0..count).map(|particle| {
                let before = match strand.ring {
                    Ring::Open => particle.checked_sub(1),
                    Ring::Closed => Some((particle + count - 1) % count),
                };
                let beside = [before.and_then(to_next), to_next(particle)];
                let beside = beside.into_iter().flatten();
                let (sum, number) = beside.fold((0.0, 0.0), |(sum, number), strain| {
                    (sum + strain, number + 1.0)
                });
                sum / f32::max(number, 1.0)
            }));
        }
        strains
    }

    /// The particle nearest to a vertex on a strand, among those of the adornment; `None` where there is no such
    /// strand.
    pub(crate) fn nearest(&self, vertex: &OnStrand) -> Option<usize> {
        let strands = &self.strands.as_ref()?.strands;
        let place = vertex.strand as usize;
        let count = strands.get(place)?.positions.len();
        let before = strands[..place].iter().map(|strand| strand.positions.len());
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a place along a strand of tens of particles"
        )]
        let along = vertex.along.max(0.0).round() as usize;
        let own = match strands[place].ring {
            Ring::Open => along.min(count - 1),
            Ring::Closed => along % count,
        };
        Some(before.sum::<usize>() + own)
    }
}

/// Makes everything of a design that is worn beside the cloth, in the order of its list, for a dancer who
/// stands with these bones and wears cloth of so many particles.
///
/// # Errors
/// An adornment that does not fit her.
pub(crate) fn adorned(
    design: &Design,
    dancer: &Dancer,
    stance: &[Affine3A],
    cloth_count: usize,
) -> Result<Vec<Adornment>, StageError> {
    let mut adornments: Vec<Adornment> = Vec::new();
    if !design.garments.iter().any(GarmentDesign::is_adornment) {
        return Ok(adornments);
    }
    let wearer = Wearer {
        dancer,
        measures: &lole_garment::measures(dancer),
        stance,
    };
    for (place, garment) in design.garments.iter().enumerate() {
        let made = adorn(&garment.spec(), &wearer).map_err(|error| StageError::Garment {
            place: place + 1,
            error: Box::new(error.into()),
        })?;
        let Some(made) = made else { continue };
        let names = adornments.iter().map(|adornment| adornment.name.as_str());
        let first = adornments
            .last()
            .map_or(cloth_count, |last| last.particles.end);
        let strands = made.strands.iter().flat_map(|hung| &hung.strands);
        let count: usize = strands.map(|strand| strand.positions.len()).sum();
        adornments.push(Adornment {
            particles: first..first + count,
            name: numbered(&garment.file_name(), names),
            place,
            surfaces: made.surfaces,
            strands: made.strands,
            grips: made.grips,
        });
    }
    Ok(adornments)
}

/// Parts of the skin that no adornment of a design stands for: the flower of her hair gives way to what is
/// put there.
pub(crate) fn parts_shown(parts: &[MeshPart], design: &Design) -> Vec<MeshPart> {
    let is_replaced = (design.garments.iter()).any(|garment| match &garment.template.worn {
        Wear::Beside(row) => (row.replaces_flower)(&garment.options),
        _ => false,
    });
    let is_flower = |kind: PartKind| matches!(kind, PartKind::Flower | PartKind::FlowerHeart);
    let shown = parts.iter();
    let shown = shown.filter(|part| !(is_replaced && is_flower(part.kind)));
    shown.cloned().collect()
}

/// The drawn body without what an adornment of a design stands for.
pub(crate) fn drawn_shown(
    drawn: Option<&Arc<DrawnBody>>,
    design: &Design,
) -> Option<Arc<DrawnBody>> {
    let drawn = drawn?;
    let parts = parts_shown(&drawn.mesh.parts, design);
    if parts.len() == drawn.mesh.parts.len() {
        return Some(Arc::clone(drawn));
    }
    let mut shown = DrawnBody::clone(drawn);
    shown.mesh.parts = parts;
    Some(Arc::new(shown))
}
