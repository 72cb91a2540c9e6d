//! The shelf of fabrics: presets in the units a textile laboratory writes, with their provenance.
//!
//! In a pāʻū skirt the bolt's length runs around the body: warp is the grid's `u`, weft its `v`.
//!
//! `twist` is `B_t` in `½ (B_u κ_uu² + B_v κ_vv² + 2 B_t κ_uv²)`.
//! A strip cut on the bias bends with `κ_uu = κ_vv = κ_uv = κ/2`, so its rigidity is
//! `B_45 = (B_u + B_v + 2 B_t) / 4` and `B_t = 2 B_45 - (B_u + B_v) / 2`: derived wherever `B_45`
//! was measured. Over the ten fabrics of Wang, O'Brien and Ramamoorthi 2011 that value is
//! `√(B_u B_v)` on the mean ([`PUBLISHED`]), so that is the estimate for the others.

pub mod measure;
mod published;
mod shelf;
pub mod touch;

use lole_cloth::{Fabric, Hysteresis};
use lole_geom::narrow;

pub use measure::{MeasureError, Measured, Overhang, Swatch};
pub use published::{PUBLISHED, Published};
pub use shelf::PRESETS;
pub use touch::Touch;

/// How a figure came about. An estimate is never shown as measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Provenance {
    /// Measured in a cited public source, on this fabric or one of the same make.
    Measured,
    /// Computed from measured or listed figures.
    Derived,
    /// A guess by comparison, to be replaced by a test of the user's own cloth.
    Estimated,
}

/// One figure with its provenance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FabricFigure<T> {
    /// The figure, in the unit of its field.
    pub value: T,
    /// How it came about.
    pub provenance: Provenance,
}

/// One fabric on the shelf.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Preset {
    /// Name in documents and on the command line.
    pub id: &'static str,
    /// English name.
    pub name: &'static str,
    /// Japanese name.
    pub name_ja: &'static str,
    /// Mass per area [g/m²].
    pub areal_density: FabricFigure<f64>,
    /// Thickness [mm].
    pub thickness: FabricFigure<f64>,
    /// Membrane stiffness along warp and weft [N/m].
    pub stretch: FabricFigure<[f64; 2]>,
    /// Membrane shear stiffness [N/m per rad].
    pub shear: FabricFigure<f64>,
    /// Bending rigidity along warp and weft [µN·m].
    pub bend: FabricFigure<[f64; 2]>,
    /// Twist rigidity [µN·m].
    pub twist: FabricFigure<f64>,
    /// Bending hysteresis `2HB` along warp and weft [mN·m/m]: how far apart the moments of bending
    /// and of bending back lie.
    pub bend_hysteresis: FabricFigure<[f64; 2]>,
    /// Shear hysteresis `2HG` [N/m].
    pub shear_hysteresis: FabricFigure<f64>,
    /// Coulomb friction coefficient on skin.
    pub friction: FabricFigure<f64>,
    /// Coulomb friction coefficient of the cloth on itself.
    pub cloth_friction: FabricFigure<f64>,
    /// Where the measured figures come from.
    pub source: &'static str,
}

/// Air drag of a hanging fold as a force per area and speed [kg/(m²·s)]: `½ ρ_air c_d v` with
/// `c_d = 1.2` for a plate at the 0.3 m/s of a swaying hem is 0.22; three quarters of a gathered
/// skirt's cloth move along themselves or in the lee of the next fold. Estimated.
const DRAG_PER_AREA: f64 = 0.055;

impl Preset {
    /// The preset of this `id`.
    #[must_use]
    pub fn from_id(id: &str) -> Option<&'static Self> {
        PRESETS.iter().find(|preset| preset.id == id)
    }

    /// The fabric of this mass per area [g/m²] and bending rigidity [µN·m] that comes nearest, by
    /// the ratios of weight and of bending length: what was not measured is taken from it.
    #[must_use]
    pub fn nearest(areal_density: f64, bend: [f64; 2]) -> &'static Self {
        let own = touch::bending_length_cm((bend[0] * bend[1]).sqrt(), areal_density);
        let distance = |preset: &Self| {
            let [warp, weft] = preset.bend.value;
            let weight = preset.areal_density.value;
            let length = touch::bending_length_cm((warp * weft).sqrt(), weight);
            let [weight, length] =
                [areal_density / weight, own / length].map(lole_geom::trig64::ln);
            weight * weight + 4.0 * length * length
        };
        let mut nearest = &PRESETS[0];
        for preset in PRESETS {
            if distance(preset) < distance(nearest) {
                nearest = preset;
            }
        }
        nearest
    }

    /// Air drag as a rate [1/s], `force / (mass · speed)`: light cloth is slowed more. Estimated.
    #[must_use]
    pub fn drag_rate(&self) -> f64 {
        DRAG_PER_AREA / (self.areal_density.value * 1.0e-3)
    }

    /// The fabric in the engine's SI units, warp along `u`.
    #[must_use]
    pub fn fabric(&self) -> Fabric {
        si_fabric(&self.figures())
    }

    /// How it feels, by its figures.
    #[must_use]
    pub fn touch(&self) -> Touch {
        Touch::of(&self.figures())
    }

    /// The figures without their provenance.
    #[must_use]
    pub fn figures(&self) -> FabricFigures {
        FabricFigures {
            areal_density: self.areal_density.value,
            thickness: self.thickness.value,
            stretch: self.stretch.value,
            shear: self.shear.value,
            bend: self.bend.value,
            twist: self.twist.value,
            bend_hysteresis: self.bend_hysteresis.value,
            shear_hysteresis: self.shear_hysteresis.value,
            friction: self.friction.value,
            cloth_friction: self.cloth_friction.value,
            drag_rate: self.drag_rate(),
        }
    }
}

/// Figures of one fabric in the units of [`Preset`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FabricFigures {
    /// Mass per area [g/m²].
    pub areal_density: f64,
    /// Thickness [mm].
    pub thickness: f64,
    /// Membrane stiffness along warp and weft [N/m].
    pub stretch: [f64; 2],
    /// Membrane shear stiffness [N/m per rad].
    pub shear: f64,
    /// Bending rigidity along warp and weft [µN·m].
    pub bend: [f64; 2],
    /// Twist rigidity [µN·m].
    pub twist: f64,
    /// Bending hysteresis `2HB` along warp and weft [mN·m/m].
    pub bend_hysteresis: [f64; 2],
    /// Shear hysteresis `2HG` [N/m].
    pub shear_hysteresis: f64,
    /// Friction coefficient on skin.
    pub friction: f64,
    /// Friction coefficient of the cloth on itself.
    pub cloth_friction: f64,
    /// Air drag as a rate [1/s].
    pub drag_rate: f64,
}

/// From laboratory units to SI.
pub(crate) fn si_fabric(figures: &FabricFigures) -> Fabric {
    Fabric {
        areal_density: narrow(figures.areal_density * 1.0e-3),
        thickness: narrow(figures.thickness * 1.0e-3),
        stretch: figures.stretch.map(narrow),
        shear: narrow(figures.shear),
        bend: figures.bend.map(|rigidity| narrow(rigidity * 1.0e-6)),
        twist: narrow(figures.twist * 1.0e-6),
        hysteresis: Hysteresis {
            bend: figures
                .bend_hysteresis
                .map(|moment| narrow(moment * 1.0e-3)),
            shear: narrow(figures.shear_hysteresis),
        },
        friction: narrow(figures.friction),
        cloth_friction: narrow(figures.cloth_friction),
        drag_rate: narrow(figures.drag_rate),
    }
}

/// Twist rigidity of a fabric by its bending rigidities at 0, 45 and 90 degrees, in their unit.
#[must_use]
pub fn twist_from_bias([warp, bias, weft]: [f64; 3]) -> f64 {
    2.0 * bias - (warp + weft) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measured_twist_is_the_geometric_mean_of_the_bending_rigidities() {
        let ratio = |bend: [f64; 3]| twist_from_bias(bend) / (bend[0] * bend[2]).sqrt();
        let ratios = PUBLISHED.map(|fabric| ratio(fabric.bend));
        let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
        assert!((mean - 1.0).abs() < 0.05, "mean ratio {mean}");
    }

    #[test]
    fn every_preset_is_a_fabric_that_can_exist() {
        for preset in PRESETS {
            let fabric = preset.fabric();
            let positive = [
                fabric.areal_density,
                fabric.thickness,
                fabric.stretch[0],
                fabric.stretch[1],
                fabric.shear,
                fabric.bend[0],
                fabric.bend[1],
                fabric.twist,
                fabric.hysteresis.bend[0],
                fabric.hysteresis.bend[1],
                fabric.hysteresis.shear,
                fabric.friction,
                fabric.cloth_friction,
                fabric.drag_rate,
            ];
            assert!(positive.iter().all(|figure| 0.0 < *figure), "{}", preset.id);
            // Fiber weighs 1 to 1.6 t/m³ and cloth is between a tenth and nine tenths fiber.
            let density = fabric.areal_density / fabric.thickness;
            assert!(
                (150.0..1500.0).contains(&density),
                "{}: {density} kg/m³",
                preset.id
            );
            // Curvature energy must not be negative for any bending: |twist| has no upper bound
            // in this form, but ten measured fabrics stay within a factor two of the mean.
            let ratio = fabric.twist / (fabric.bend[0] * fabric.bend[1]).sqrt();
            assert!((0.5..2.0).contains(&ratio), "{}: {ratio}", preset.id);
            assert_eq!(Preset::from_id(preset.id), Some(preset));
        }
    }

    #[test]
    fn yarns_hold_the_bend_that_was_measured_of_their_kind() {
        // `2HB / B` of cotton broadcloth and polyester faille [1/cm]: gf·cm/cm over gf·cm²/cm.
        let (cotton, polyester) = (0.124 / 0.118, 0.007 / 0.019);
        for (id, ratio) in [
            ("polycotton-broadcloth", cotton),
            ("cotton-lawn", cotton),
            ("polyester-satin", polyester),
            ("light-polyester", polyester),
        ] {
            let preset = Preset::from_id(id).unwrap();
            for (moment, rigidity) in preset.bend_hysteresis.value.iter().zip(preset.bend.value) {
                // mN over µN·m is 1000/m, or 10/cm.
                let found = 10.0 * moment / rigidity;
                assert!(
                    (found / ratio - 1.0).abs() < 0.02,
                    "{id}: {found} of {ratio}"
                );
            }
        }
        // The residual angle of any woven cloth is a few degrees.
        for preset in PRESETS {
            let residual = 0.5 * preset.shear_hysteresis.value / preset.shear.value;
            assert!(
                (0.005..0.04).contains(&residual),
                "{}: {residual}",
                preset.id
            );
        }
    }

    #[test]
    fn derived_twists_follow_from_the_bias_strip() {
        for (id, rigidity) in [
            ("barkcloth", PUBLISHED[4].bend),
            ("light-polyester", PUBLISHED[0].bend),
            ("jersey", PUBLISHED[2].bend),
            ("spandex", PUBLISHED[3].bend),
        ] {
            let preset = Preset::from_id(id).unwrap();
            assert_eq!(preset.twist.provenance, Provenance::Derived, "{id}");
            assert!(
                (preset.twist.value - twist_from_bias(rigidity)).abs() < 0.51,
                "{id}"
            );
        }
    }

    #[test]
    fn softer_fabrics_drape_in_the_order_a_costume_maker_expects() {
        // A strip bends under its own weight over a length whose cube is B / (ρ g).
        let bending_length_cubed = |id: &str| {
            let fabric = Preset::from_id(id).unwrap().fabric();
            fabric.bend[1] / (fabric.areal_density * 9.81)
        };
        let cubes =
            ["rayon-challis", "polycotton-broadcloth", "barkcloth"].map(bending_length_cubed);
        assert!(cubes.is_sorted(), "{cubes:?}");
    }

    #[test]
    fn default_skirt_bends_as_far_as_its_cantilever() {
        // c³ = B / (ρ g): 2.0 cm along the warp, 1.8 cm along the weft.
        let preset = Preset::from_id("polycotton-broadcloth").unwrap();
        for (rigidity, length) in preset.bend.value.into_iter().zip([0.020_f64, 0.018]) {
            let expected = preset.areal_density.value * 1.0e-3 * 9.81 * length.powi(3) * 1.0e6;
            assert!(
                (rigidity / expected - 1.0).abs() < 0.06,
                "{rigidity} for {expected}"
            );
        }
    }
}
