//! The blouse: front and back around the trunk, puffed sleeves around the arms.

use super::{Way, Worn};
use crate::dress::bodice::Part;

pub(super) const WORN: Worn = Worn {
    template: "blouse",
    way: Way::Fitted(&[
        ("front", Part::Front),
        ("back", Part::Back),
        ("sleeve", Part::Sleeve),
    ]),
    particle_count: 3000.0,
    chest_room_deg: 10.0,
    substep_counts: super::MANY_SUBSTEPS,
};
