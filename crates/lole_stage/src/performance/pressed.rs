//! Skirts and tops under what is worn over them: simulated as they hang, met and seen as they are pressed.

use std::borrow::Cow;

use glam::Vec3;
use lole_cloth::collision::layer::{OuterCloth, Press, Trunk};
use lole_costume::document::GarmentLayer;

use super::dressed::{self, Dressed};
use super::{Performance, order};
use crate::production::{DressedGarment, Garment, Production};

/// What presses skirts and tops; `None` where nothing is worn over them.
pub(super) fn press(production: &Production) -> Option<Press> {
    let mut dressed = production.dressed.iter();
    let is_pressed =
        !production.garments.is_empty() && dressed.any(|it| it.layer == GarmentLayer::Over);
    is_pressed.then(Press::default)
}

/// Where skirts and tops that are at `positions` [m] lie under what was worn over them a frame ago.
pub(super) fn flatten<'a>(
    (press, trunk): (Option<&mut Press>, Trunk),
    (garments, positions): (&[Garment], &'a [Vec3]),
) -> Cow<'a, [Vec3]> {
    let Some(press) = press else {
        return Cow::Borrowed(positions);
    };
    press.flatten(trunk, dressed::grids(garments, positions), order::GAP);
    let mut pressed = Vec::new();
    press.press(positions, &mut pressed);
    Cow::Owned(pressed)
}

/// Looks at what is worn over them, for the next frame.
pub(super) fn tighten(
    (press, trunk): (Option<&mut Press>, Trunk),
    (moving, garments): (&[Dressed], &[DressedGarment]),
) {
    let Some(press) = press else {
        return;
    };
    let pairs = moving.iter().zip(garments);
    let over = pairs.filter(|(_, garment)| garment.layer == GarmentLayer::Over);
    let over = over.map(|(moving, garment)| OuterCloth {
        triangles: &garment.dressed.trunk_triangles,
        on_cloth: &garment.dressed.on_cloth,
        positions: moving.positions(),
    });
    press.tighten(trunk, over);
}

impl Performance {
    /// Particles of one garment as they are seen [m], row-major: where something is worn over it, pressed
    /// by that; elsewhere as [`Self::garment_positions`].
    #[must_use]
    pub fn pressed_positions(&self, garment: &Garment) -> Cow<'_, [Vec3]> {
        self.pressed(self.garment_positions(garment))
    }

    /// The same for any particles of skirts and tops that are at `positions` [m].
    pub(crate) fn pressed<'a>(&self, positions: &'a [Vec3]) -> Cow<'a, [Vec3]> {
        self.press
            .as_ref()
            .map_or(Cow::Borrowed(positions), |press| {
                let mut pressed = Vec::new();
                press.press(positions, &mut pressed);
                Cow::Owned(pressed)
            })
    }
}
