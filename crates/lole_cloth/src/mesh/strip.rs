//! Strips: narrow cloth such as raffia and ti leaf, as pieces of two columns.
//!
//! A strand is known by its stiffness as a whole, `EA` [N] and `EI` [N·m²]; over its width they
//! are the moduli of a cloth.

use glam::Vec2;

use crate::Fabric;
use crate::mesh::spec::MeshSpec;

/// A narrow strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip {
    /// Length [m].
    pub length: f32,
    /// Width [m].
    pub width: f32,
    /// Cells along the length; three to a bending length `(EI / weight per length)^(1/3)` bend well.
    pub segment_count: u32,
    /// Mass per length [kg/m].
    pub linear_density: f32,
    /// Tension at twice the length, `EA` [N].
    pub stretch_stiffness: f32,
    /// Bending stiffness over its flat side `EI` [N·m²].
    pub bend_stiffness: f32,
    /// Torsional stiffness `GJ` [N·m²].
    pub twist_stiffness: f32,
    /// Coulomb friction coefficient on the body.
    pub friction: f32,
    /// Air drag as a rate [1/s].
    pub drag_rate: f32,
}

impl Strip {
    /// The piece: particles `2 k` and `2 k + 1` lie side by side at `k` segments from the root,
    /// warp along the length. Nothing is pinned.
    #[must_use]
    pub fn spec(&self) -> MeshSpec {
        let count = self.segment_count.max(1);
        #[expect(clippy::cast_precision_loss, reason = "segments are far below 2^24")]
        let segment = self.length / count as f32;
        #[expect(clippy::cast_precision_loss, reason = "segments are far below 2^24")]
        let flat = (0..=count).flat_map(|k| {
            let along = k as f32 * segment;
            [Vec2::new(along, 0.0), Vec2::new(along, self.width)]
        });
        // Diagonals in turn, so that the strand favors no side.
        let triangles = (0..count).flat_map(|k| {
            let [a, b, c, d] = [0, 1, 2, 3].map(|corner| 2 * k + corner);
            if k % 2 == 0 {
                [[a, c, d], [a, d, b]]
            } else {
                [[a, c, b], [b, c, d]]
            }
        });
        MeshSpec::new(flat.collect(), triangles.collect(), self.fabric())
    }

    /// The fabric of a cloth that is as wide as the strip and pulls, bends and weighs as it does. It keeps its
    /// width, so weft and shear are as stiff as warp.
    fn fabric(&self) -> Fabric {
        let stretch = self.stretch_stiffness / self.width;
        Fabric {
            areal_density: self.linear_density / self.width,
            thickness: 0.0,
            stretch: [stretch; 2],
            shear: stretch,
            bend: [self.bend_stiffness / self.width; 2],
            // `GJ = 2 B_t width`.
            twist: 0.5 * self.twist_stiffness / self.width,
            hysteresis: crate::Hysteresis::NONE,
            friction: self.friction,
            cloth_friction: self.friction,
            drag_rate: self.drag_rate,
        }
    }
}
