//! Tethers: no particle may be farther from a pinned one than the cloth between them is long.
//!
//! Long-range attachments after Kim, Chentanez and Müller 2012: one-sided, so a slack tether does
//! nothing, and the flat distance is a bound for every fold the cloth can take.

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::Vec3;

use crate::lanes::{Layout, Points, Scalars, Vectors, larger};
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
    /// Flat distance of every particle from it [m].
    pub(crate) rest_lengths: Vec<Scalars>,
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

/// Farthest-point choice: each next anchor is the pin farthest from those already chosen.
fn spread_anchors(grid: &Grid, layout: &Layout, pin_indices: &[u32]) -> Vec<Anchor> {
    let mut gaps = vec![f32::INFINITY; pin_indices.len()];
    let mut anchors = Vec::new();
    let mut pin = 0;
    while anchors.len() < ANCHOR_COUNT_MAX.min(pin_indices.len()) {
        let lengths: Vec<f32> = (0..grid.particle_count())
            .map(|particle| flat_distance(grid, pin_indices[pin] as usize, particle))
            .collect();
        for (gap, &other) in gaps.iter_mut().zip(pin_indices) {
            *gap = gap.min(lengths[other as usize]);
        }
        anchors.push(Anchor {
            pin,
            rest_lengths: layout.scatter(&lengths),
        });
        let farthest = (0..gaps.len()).max_by(|&a, &b| gaps[a].total_cmp(&gaps[b]).then(b.cmp(&a)));
        pin = farthest.unwrap_or(0);
    }
    anchors
}

/// Distance [m] of two particles on the flat cloth; around a tube, the shorter way.
fn flat_distance(grid: &Grid, first: usize, second: usize) -> f32 {
    let columns = grid.column_count as usize;
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
    let (u, v) = (
        across as f32 * grid.spacing[0],
        down as f32 * grid.spacing[1],
    );
    (u * u + v * v).sqrt()
}

/// Pulls back what is farther from its row's anchors than `limit` [m], particle by particle.
#[inline(always)]
pub(crate) fn solve_row<S: Simd>(
    simd: S,
    row: &mut [Points],
    inv_masses: &[Scalars],
    anchors: &[Points],
    limit: f32,
) {
    let zero = f32x16::splat(simd, 0.0);
    for ((points, inv_mass), anchor) in row.iter_mut().zip(inv_masses).zip(anchors) {
        let point = Vectors::load(simd, points);
        let offset = point.sub(Vectors::load(simd, anchor));
        let squared = offset.dot(offset);
        if !f32x16::splat(simd, limit * limit)
            .simd_lt(squared)
            .any_true()
        {
            continue;
        }
        let free = zero.simd_lt(f32x16::load_array_ref(simd, &inv_mass.0));
        let excess = larger(
            zero,
            f32x16::splat(simd, 1.0) - f32x16::splat(simd, limit) / squared.sqrt(),
        );
        point
            .sub(offset.scale(free.select(excess, zero)))
            .store(points);
    }
}

/// Pulls back what is farther from `anchor` than its rest length times `scale`.
#[inline(always)]
pub(crate) fn solve_anchor<S: Simd>(
    simd: S,
    positions: &mut [Points],
    inv_masses: &[Scalars],
    rest_lengths: &[Scalars],
    (anchor, scale): (Vec3, f32),
) {
    let zero = f32x16::splat(simd, 0.0);
    let anchor = Vectors::splat(simd, anchor);
    let columns = positions.iter_mut().zip(inv_masses).zip(rest_lengths);
    for ((points, inv_mass), rest_length) in columns {
        let point = Vectors::load(simd, points);
        let offset = point.sub(anchor);
        let squared = offset.dot(offset);
        let limit = f32x16::load_array_ref(simd, &rest_length.0) * scale;
        let taut = (limit * limit).simd_lt(squared)
            & zero.simd_lt(f32x16::load_array_ref(simd, &inv_mass.0));
        if !taut.any_true() {
            continue;
        }
        let excess = f32x16::splat(simd, 1.0) - limit / squared.sqrt();
        point
            .sub(offset.scale(taut.select(excess, zero)))
            .store(points);
    }
}
