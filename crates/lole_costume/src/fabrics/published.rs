//! Ten fabrics as they were measured and published: what the shelf and the engine are held against.

use lole_cloth::{Fabric, Hysteresis};
use lole_geom::narrow;

use super::twist_from_bias;

/// A fabric of Wang, O'Brien and Ramamoorthi 2011, "Data-Driven Elastic Models for Cloth": the samples nearest to
/// rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Published {
    /// What it is.
    pub name: &'static str,
    /// Mass per area [g/m²].
    pub areal_density: f64,
    /// Membrane stiffness along warp and weft [N/m].
    pub stretch: [f64; 2],
    /// Membrane shear stiffness [N/m per rad].
    pub shear: f64,
    /// Bending rigidity at 0, 45 and 90 degrees [µN·m].
    pub bend: [f64; 3],
}

const fn row(
    name: &'static str,
    areal_density: f64,
    stretch: [f64; 2],
    shear: f64,
    bend: [f64; 3],
) -> Published {
    Published {
        name,
        areal_density,
        stretch,
        shear,
        bend,
    }
}

/// All ten, by their weight.
#[rustfmt::skip]
pub const PUBLISHED: [Published; 10] = [
    row("polyester jacket", 113.0, [43.0, 171.0], 14.0, [14.0, 22.0, 20.0]),
    row("polyester tablecloth", 128.0, [2002.0, 2027.0], 19.0, [52.0, 41.0, 31.0]),
    row("cotton interlock", 187.0, [17.0, 34.0], 37.0, [23.0, 25.0, 14.0]),
    row("swimwear", 204.0, [48.0, 105.0], 61.0, [60.0, 59.0, 51.0]),
    row("woven trousers", 220.0, [2017.0, 2035.0], 105.0, [125.0, 108.0, 125.0]),
    row("polyester knit", 224.0, [12.0, 3.0], 18.0, [59.0, 40.0, 46.0]),
    row("polyester blanket", 228.0, [152.0, 245.0], 30.0, [117.0, 88.0, 60.0]),
    row("rib knit", 276.0, [43.0, 65.0], 83.0, [46.0, 30.0, 32.0]),
    row("ponte knit", 284.0, [31.0, 44.0], 32.0, [36.0, 33.0, 37.0]),
    row("denim", 324.0, [205.0, 1014.0], 53.0, [64.0, 73.0, 97.0]),
];

impl Published {
    /// The fabric for the engine: elastic, and touching nothing.
    #[must_use]
    pub fn fabric(&self) -> Fabric {
        let [warp, _, weft] = self.bend;
        Fabric {
            areal_density: narrow(1.0e-3 * self.areal_density),
            thickness: 3.0e-4,
            stretch: self.stretch.map(narrow),
            shear: narrow(self.shear),
            bend: [warp, weft].map(|bend| narrow(1.0e-6 * bend)),
            twist: narrow(1.0e-6 * twist_from_bias(self.bend)),
            hysteresis: Hysteresis::NONE,
            friction: 0.0,
            cloth_friction: 0.0,
            drag_rate: 0.0,
        }
    }
}
