//! The double pāʻū: what layers are measured and watched on.

use lole_costume::document::{Design, GarmentDesign};
use lole_garment::template::{PAU_SKIRT, PAU_TOP};

/// A double pāʻū and a top, of 40,000 particles: a plain underskirt, the print skirt over it, shorter,
/// and the top over its band.
#[must_use]
pub fn double_pau() -> Design {
    let mut design = Design::default();
    design.skirt.hem_height_cm = 34.0;
    design.skirt.gather_ratio = 3.0;
    (design.skirt.column_count, design.skirt.row_count) = (480, 36);
    design.garments = [&PAU_SKIRT, &PAU_TOP].map(GarmentDesign::new).into();
    design
}
