//! Tethers: no particle may be farther from a pinned one than the cloth between them is long.
//!
//! Long-range attachments after Kim, Chentanez and Müller 2012: one-sided, so a slack tether does
//! nothing, and the flat distance is a bound for every fold the cloth can take.

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::Vec3;

use crate::constraint::pull::Pull;
use crate::lanes::{Layout, Points, Scalars, Vectors};
use crate::{ClothSpec, Grid, Topology};

/// Pins that particles are tethered to where no whole row is pinned; each costs one pass.
const ANCHOR_COUNT_MAX: usize = 4;

/// What every particle is tethered to.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Tethers {
    /// Nothing is pinned.
    Loose,
    /// For every row, the nearest row that is pinned all along; itself when it is one.
    Rows(Vec<u32>),
    /// Single pins, spread over the cloth.
    Anchors(Vec<Anchor>),
}

/// One pin that every particle is tethered to.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Anchor {
    /// Position of the pin in the list of pins.
    pub(crate) pin: usize,
    /// Row of the pin.
    pub(crate) row: usize,
    /// Inverse square of every particle's flat distance from it [1/m²]; 0 for the pin itself.
    pub(crate) inv_squares: Vec<Scalars>,
}

impl Tethers {
    pub(crate) fn new(spec: &ClothSpec, layout: &Layout, pin_indices: &[u32]) -> Self {
        let columns = spec.grid.column_count as usize;
        let pinned_rows: Vec<u32> = (0u32..)
            .zip(spec.pinned.chunks_exact(columns))
            .filter(|(_, row)| row.iter().all(|&pinned| pinned))
            .map(|(row, _)| row)
            .collect();
        if pin_indices.is_empty() {
            Self::Loose
        } else if pinned_rows.is_empty() {
            Self::Anchors(spread_anchors(&spec.grid, layout, pin_indices))
        } else {
            let nearest = (0..spec.grid.row_count).map(|row| {
                pinned_rows
                    .iter()
                    .copied()
                    .min_by_key(|&pinned| pinned.abs_diff(row))
                    .unwrap_or(row)
            });
            Self::Rows(nearest.collect())
        }
    }
}

impl Tethers {
    /// Rows by which a tether's pin may lie below the row that hangs from it.
    pub(crate) fn reach(&self) -> usize {
        match self {
            Self::Loose => 0,
            Self::Rows(anchor_rows) => (anchor_rows.iter().enumerate())
                .map(|(row, &anchor)| (anchor as usize).saturating_sub(row))
                .max()
                .unwrap_or(0),
            Self::Anchors(anchors) => anchors.iter().map(|anchor| anchor.row).max().unwrap_or(0),
        }
    }
}

/// Farthest-point choice: each next anchor is the pin farthest from those already chosen.
fn spread_anchors(grid: &Grid, layout: &Layout, pin_indices: &[u32]) -> Vec<Anchor> {
    let mut gaps = vec![f32::INFINITY; pin_indices.len()];
    let mut anchors = Vec::new();
    let mut pin = 0;
    while anchors.len() < ANCHOR_COUNT_MAX.min(pin_indices.len()) {
        let lengths: Vec<f32> = (0..grid.particle_count())
            .map(|particle| flat_distance(grid, pin_indices[pin] as usize, particle))
            .collect();
        let inv_square = |&length: &f32| {
            if 0.0 < length {
                1.0 / (length * length)
            } else {
                0.0
            }
        };
        let inv_squares: Vec<f32> = lengths.iter().map(inv_square).collect();
        for (gap, &other) in gaps.iter_mut().zip(pin_indices) {
            *gap = gap.min(lengths[other as usize]);
        }
        anchors.push(Anchor {
            pin,
            row: pin_indices[pin] as usize / grid.column_count as usize,
            inv_squares: layout.scatter(&inv_squares),
        });
        let farthest = (0..gaps.len()).max_by(|&a, &b| gaps[a].total_cmp(&gaps[b]).then(b.cmp(&a)));
        pin = farthest.unwrap_or(0);
    }
    anchors
}

/// Distance [m] of two particles on the flat cloth; around a tube, the shorter way.
pub(crate) fn flat_distance(grid: &Grid, first: usize, second: usize) -> f32 {
    let columns = grid.column_count as usize;
    let row = |particle: usize| u32::try_from(particle / columns).unwrap_or(u32::MAX);
    // Of two rows that are not as full, the fuller: a bound for both.
    let spacing = grid.row_spacing(row(first).max(row(second)));
    let across = (first % columns).abs_diff(second % columns);
    let across = match grid.topology {
        Topology::Sheet => across,
        Topology::Tube => across.min(columns - across),
    };
    let down = (first / columns).abs_diff(second / columns);
    #[expect(
        clippy::cast_precision_loss,
        reason = "a grid has fewer than 2^24 rows and columns"
    )]
    let (u, v) = (across as f32 * spacing, down as f32 * grid.spacing[1]);
    (u * u + v * v).sqrt()
}

/// How far tethers pull by their length in units of the longest allowed.
const UNIT: Pull = Pull::new(1.0);

/// A row that hangs from tethers.
pub(crate) struct HangingRow<'a> {
    pub(crate) points: &'a mut [Points],
    pub(crate) inv_masses: &'a [Scalars],
}

impl HangingRow<'_> {
    /// Pulls back what is farther from its row's anchors than `limit` [m], particle by particle.
    #[inline(always)]
    pub(crate) fn pull_to_row<S: Simd>(self, simd: S, anchors: &[Points], limit: f32) {
        let zero = f32x16::splat(simd, 0.0);
        let one = f32x16::splat(simd, 1.0);
        let inv_limit = 1.0 / (limit * limit);
        for ((points, inv_mass), anchor) in self.points.iter_mut().zip(self.inv_masses).zip(anchors)
        {
            let point = Vectors::load(simd, points);
            let offset = point.sub(Vectors::load(simd, anchor));
            // Squared length in units of the longest allowed.
            let squared = offset.dot(offset) * inv_limit;
            let taut = one.simd_lt(squared);
            if !taut.any_true() {
                continue;
            }
            let free = zero.simd_lt(f32x16::load_array_ref(simd, &inv_mass.0));
            let factor = free.select(UNIT.taut_factor(simd, squared), zero);
            point.sub(offset.scale(factor)).store(points);
        }
    }

    /// Pulls back what of a row is farther from `anchor` than its rest length times `scale`; squared
    /// rest lengths come as their inverses [1/m²].
    #[inline(always)]
    pub(crate) fn pull_to_anchor<S: Simd>(
        self,
        simd: S,
        inv_squares: &[Scalars],
        anchor: Vec3,
        scale: f32,
    ) {
        let zero = f32x16::splat(simd, 0.0);
        let one = f32x16::splat(simd, 1.0);
        let anchor = Vectors::splat(simd, anchor);
        let inv_scale = 1.0 / (scale * scale);
        let columns = self.points.iter_mut().zip(self.inv_masses).zip(inv_squares);
        for ((points, inv_mass), inv_square) in columns {
            let point = Vectors::load(simd, points);
            let offset = point.sub(anchor);
            // Squared length in units of the longest allowed.
            let squared =
                offset.dot(offset) * (f32x16::load_array_ref(simd, &inv_square.0) * inv_scale);
            let taut =
                one.simd_lt(squared) & zero.simd_lt(f32x16::load_array_ref(simd, &inv_mass.0));
            if !taut.any_true() {
                continue;
            }
            let factor = taut.select(UNIT.taut_factor(simd, squared), zero);
            point.sub(offset.scale(factor)).store(points);
        }
    }
}
