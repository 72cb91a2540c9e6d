//! What a dancer wears or holds beside the cloth: lei, wreaths, flowers, skirts of strands, instruments.

use glam::Affine3A;
use lole_body::{Dancer, MeshPart, PartKind};
use lole_costume::document::{Design, GarmentDesign};
use lole_costume::tailoring::numbered;
use lole_garment::adorn::{Grip, HangingStrands, Surface, Wearer, adorn};
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
}

/// Makes everything of a design that is worn beside the cloth, in the order of its list, for a dancer who
/// stands with these bones.
///
/// # Errors
/// An adornment that does not fit her.
pub(crate) fn adorned(
    design: &Design,
    dancer: &Dancer,
    stance: &[Affine3A],
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
        let GarmentDesign::Template(worn) = garment else {
            continue;
        };
        let made = adorn(&worn.spec(), &wearer).map_err(|error| StageError::Garment {
            place: place + 1,
            error: Box::new(error.into()),
        })?;
        let Some(made) = made else { continue };
        let names = adornments.iter().map(|adornment| adornment.name.as_str());
        adornments.push(Adornment {
            name: numbered(&worn.template.id.replace('-', "_"), names),
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
    let is_replaced = design.garments.iter().any(|garment| match garment {
        GarmentDesign::Template(worn) => match &worn.template.worn {
            Wear::Beside(row) => (row.replaces_flower)(&worn.options),
            _ => false,
        },
        GarmentDesign::PauSkirt(_) | GarmentDesign::PauTop(_) => false,
    });
    let is_flower = |kind: PartKind| matches!(kind, PartKind::Flower | PartKind::FlowerHeart);
    let shown = parts.iter();
    let shown = shown.filter(|part| !(is_replaced && is_flower(part.kind)));
    shown.cloned().collect()
}
