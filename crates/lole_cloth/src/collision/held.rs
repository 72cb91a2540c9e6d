//! Cloth that pins hold inside a capsule.
//!
//! Pins are carried by the skin, which capsules only approximate: where a capsule reaches beyond
//! the skin it encloses pins, and would push what hangs from them farther than the cloth is long.

use fearless_simd::{Simd, f32x16, prelude::*};
use lole_geom::Capsule;

use crate::collision::capsule::MovingCapsule;
use crate::collision::pinned_rows::PinnedRows;
use crate::lanes::{Layout, Points, Scalars, Vectors, larger, smaller};

/// Share of the cloth between a pin and a particle by which the particle has come out: below 1,
/// so that the cloth need not be stretched straight. Folds
/// turn within millimeters and stretch when pushed much harder: 0.5 strains them by 6 %.
const SLOPE: f32 = 0.1;

/// How far every particle may stay inside the capsules [m], vector by vector.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct HeldDepths {
    depths: Vec<Scalars>,
}

impl HeldDepths {
    /// Depths of some vectors.
    pub(crate) fn depths(&self) -> &[Scalars] {
        &self.depths
    }

    /// Finds them anew: `ends` are positions and capsules at the start and the end of the step,
    /// `limit` [m] the deepest that is granted, `spacing` [m] the cloth between two rows.
    pub(crate) fn find<S: Simd>(
        &mut self,
        simd: S,
        (layout, pinned_rows): (&Layout, &PinnedRows),
        ends: [(&[Points], &[Capsule]); 2],
        (limit, contact_offset, spacing): (f32, f32, f32),
    ) {
        self.depths.clear();
        self.depths
            .resize(layout.vector_count(), Scalars::default());
        if limit <= 0.0 {
            return;
        }
        let width = layout.group_count;
        for row in pinned_rows.rows() {
            for group in 0..width {
                let pins = ends.map(|(positions, capsules)| {
                    let pin = Vectors::load(simd, &positions[row * width + group]);
                    deepest(simd, pin, (capsules, contact_offset))
                });
                let depth = larger(pins[0], pins[1]);
                let depth = smaller(depth, f32x16::splat(simd, limit));
                self.spread(simd, (row, group, width), depth, spacing);
            }
        }
    }

    /// Grants the rows around a pinned one what remains of its depth.
    #[inline(always)]
    fn spread<S: Simd>(
        &mut self,
        simd: S,
        (pin_row, group, width): (usize, usize, usize),
        depth: f32x16<S>,
        spacing: f32,
    ) {
        let deepest = depth.to_array().into_iter().fold(0.0, f32::max);
        for (row, depths) in self.depths.chunks_exact_mut(width).enumerate() {
            #[expect(clippy::cast_precision_loss, reason = "rows are fewer than 2^24")]
            let out = row.abs_diff(pin_row) as f32 * spacing * SLOPE;
            if out < deepest {
                let before = f32x16::load_array_ref(simd, &depths[group].0);
                larger(before, depth - f32x16::splat(simd, out)).store_array(&mut depths[group].0);
            }
        }
    }
}

/// Depth in the capsule in which each lane is deepest [m]; 0 outside all.
#[inline(always)]
fn deepest<S: Simd>(
    simd: S,
    pin: Vectors<S>,
    (capsules, contact_offset): (&[Capsule], f32),
) -> f32x16<S> {
    let mut depth = f32x16::splat(simd, 0.0);
    for capsule in capsules {
        let capsule = MovingCapsule::new([capsule; 2], 1.0, 0.0, contact_offset);
        depth = larger(depth, capsule.depth(simd, pin));
    }
    depth
}
