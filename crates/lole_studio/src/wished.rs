//! What is wished at one moment of the work: the design, whose fabric may be stiffer than it was
//! opened, and the file that it belongs to.

use lole_costume::document::{Design, FabricDesign};

use crate::studio::range;

/// Factors of the stiffness slider.
pub(crate) const STIFFNESSES: [f64; 2] = [0.1, 10.0];

/// One state of the work.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Wished {
    /// The design.
    pub(crate) design: Design,
    /// The fabric as it was chosen: the stiffness is a factor on it.
    base_fabric: FabricDesign,
    stiffness: f64,
    /// Which of the window's files it belongs to.
    pub(crate) file: usize,
}

impl Wished {
    /// A design of a file.
    pub(crate) fn new(design: Design, file: usize) -> Self {
        Self {
            base_fabric: design.fabric.clone(),
            stiffness: 1.0,
            design,
            file,
        }
    }

    /// Factor on the fabric's stiffness.
    pub(crate) const fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// Makes the fabric as many times as stiff as it was chosen: in stretch, shear and bending.
    pub(crate) fn stiffen(&mut self, factor: f64) {
        self.stiffness = factor.clamp(STIFFNESSES[0], STIFFNESSES[1]);
        let fabric = self.design.fabric.clone();
        // What has nothing to do with stiffness stays as it is now.
        self.design.fabric = FabricDesign {
            name: fabric.name,
            width_cm: fabric.width_cm,
            drag_per_s: fabric.drag_per_s,
            price_per_m: fabric.price_per_m,
            price_per_yd: fabric.price_per_yd,
            beside_width_cm: fabric.beside_width_cm,
            beside_price_per_m: fabric.beside_price_per_m,
            ..stiffened(&self.base_fabric, self.stiffness)
        };
    }

    /// Chooses another fabric, as stiff as it is.
    pub(crate) fn choose_fabric(&mut self, fabric: FabricDesign) {
        self.design.fabric = fabric.clone();
        self.base_fabric = fabric;
        self.stiffness = 1.0;
    }
}

/// A fabric whose every stiffness is multiplied, within what the document takes.
fn stiffened(base: &FabricDesign, factor: f64) -> FabricDesign {
    #[expect(clippy::float_cmp, reason = "the slider's middle is exactly 1")]
    if factor == 1.0 {
        return base.clone();
    }
    let preset = base.preset;
    let times = |name: &str, value: f64| {
        let scaled = value * factor;
        let (low, high) = range("fabric", name);
        Some(scaled.clamp(low, high))
    };
    let [stretch_warp, stretch_weft] = preset.stretch.value;
    let [bend_warp, bend_weft] = preset.bend.value;
    let twist = base.twist_un_m;
    FabricDesign {
        stretch_warp_n_per_m: times(
            "stretch_warp_n_per_m",
            base.stretch_warp_n_per_m.unwrap_or(stretch_warp),
        ),
        stretch_weft_n_per_m: times(
            "stretch_weft_n_per_m",
            base.stretch_weft_n_per_m.unwrap_or(stretch_weft),
        ),
        shear_n_per_m: times(
            "shear_n_per_m",
            base.shear_n_per_m.unwrap_or(preset.shear.value),
        ),
        bend_warp_un_m: times("bend_warp_un_m", base.bend_warp_un_m.unwrap_or(bend_warp)),
        bend_weft_un_m: times("bend_weft_un_m", base.bend_weft_un_m.unwrap_or(bend_weft)),
        // Left out, it follows the bending.
        twist_un_m: twist.and_then(|twist| times("twist_un_m", twist)),
        ..base.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twice_the_stiffness_is_twice_every_modulus_and_once_is_the_document_as_it_was() {
        let mut wished = Wished::new(Design::default(), 0);
        let before = wished.design.fabric.fabric();
        wished.stiffen(2.0);
        let after = wished.design.fabric.fabric();
        let close = |a: f32, b: f32| (a - 2.0 * b).abs() < 1e-5 * a.abs();
        assert!(close(after.stretch[0], before.stretch[0]));
        assert!(close(after.stretch[1], before.stretch[1]));
        assert!(close(after.shear, before.shear) && close(after.twist, before.twist));
        assert!(close(after.bend[0], before.bend[0]) && close(after.bend[1], before.bend[1]));
        wished.stiffen(1.0);
        assert_eq!(wished.design, Design::default());
    }
}
