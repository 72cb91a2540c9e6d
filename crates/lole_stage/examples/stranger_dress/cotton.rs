//! What garments of others are made of here.

use lole_cloth::{Fabric, Hysteresis};

/// A light cotton.
pub(crate) const FABRIC: Fabric = Fabric {
    areal_density: 0.12,
    thickness: 0.3e-3,
    stretch: [4500.0, 2800.0],
    shear: 90.0,
    bend: [6.0e-6, 4.0e-6],
    twist: 3.0e-6,
    hysteresis: Hysteresis::NONE,
    friction: 0.3,
    cloth_friction: 0.3,
    drag_rate: 1.0,
};
