//! The holokū: a close dress from yokes, with long sleeves and a train.

use super::{Way, Worn};
use crate::dress::bodice::Part;

pub(super) const WORN: Worn = Worn {
    template: "holoku",
    way: Way::Fitted(&[
        ("front", Part::Front),
        ("back", Part::Back),
        ("front_yoke", Part::Front),
        ("back_yoke", Part::Back),
        ("sleeve", Part::Sleeve),
    ]),
    particle_count: 5000.0,
    chest_room_deg: 10.0,
    substep_counts: super::MANY_SUBSTEPS,
};
