//! The muʻumuʻu: yokes over the shoulders, skirts gathered to them, a ruffle at the hem.

use super::{Way, Worn};
use crate::dress::bodice::Part;

pub(super) const WORN: Worn = Worn {
    template: "muumuu",
    way: Way::Fitted(&[
        ("front", Part::Front),
        ("back", Part::Back),
        ("front_yoke", Part::Front),
        ("back_yoke", Part::Back),
        ("sleeve", Part::Sleeve),
        ("ruffle", Part::Ruffle),
    ]),
    particle_count: 6000.0,
    chest_room_deg: 10.0,
    substep_counts: super::MANY_SUBSTEPS,
};
