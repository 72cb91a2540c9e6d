//! Rows that are pinned all along: contact may not fight the shape in which they are held.

use glam::Vec3;

use crate::lanes::narrow;
use crate::{ClothSpec, Grid};

/// Share of the cloth between a pin and a particle by which the particle has come out of a capsule
/// that reaches beyond the skin: far below 1, because folds turn within millimeters and stretch
/// when they are pushed along the cloth.
const HELD_SLOPE: f32 = 0.3;

/// Length of the cloth [m] from a pinned row on within which the folds lie as it gathers them.
const GATHERED: f32 = 0.15;

/// For every row the nearest row that is pinned all along; empty where none is.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct PinnedRows {
    pub(crate) nearest: Vec<u32>,
    /// The nearest one on the other side; the same one where there is none.
    opposite: Vec<u32>,
    /// Whether cloth is gathered there: rows near one of these, not the pins themselves.
    is_gathered: Vec<bool>,
}

impl PinnedRows {
    pub(crate) fn new(spec: &ClothSpec) -> Self {
        let columns = spec.grid.column_count as usize;
        let pinned: Vec<u32> = (0u32..)
            .zip(spec.pinned.chunks_exact(columns))
            .filter(|(_, row)| row.iter().all(|&pinned| pinned))
            .map(|(row, _)| row)
            .collect();
        if pinned.is_empty() {
            return Self::default();
        }
        let nearest = (0..spec.grid.row_count).map(|row| {
            let by_distance = |pin: &u32| pin.abs_diff(row);
            pinned
                .iter()
                .copied()
                .min_by_key(by_distance)
                .unwrap_or(row)
        });
        let nearest: Vec<u32> = nearest.collect();
        #[expect(clippy::cast_precision_loss, reason = "rows are fewer than 2^24")]
        let away = |(row, pin): (u32, &u32)| row.abs_diff(*pin) as f32 * spec.grid.spacing[1];
        let is_gathered = (0u32..).zip(&nearest).map(away);
        let opposite = (0_u32..).zip(&nearest).map(|(row, &nearest)| {
            let beyond = |pin: &&u32| (row < **pin) != (row < nearest) && row != nearest;
            let by_distance = |pin: &&u32| pin.abs_diff(row);
            let other = pinned.iter().filter(beyond).min_by_key(by_distance);
            other.copied().unwrap_or(nearest)
        });
        Self {
            opposite: opposite.collect(),
            is_gathered: is_gathered
                .map(|away| 0.0 < away && away <= GATHERED)
                .collect(),
            nearest,
        }
    }

    /// Whether a row lies where the cloth is still gathered into a pinned one.
    pub(crate) fn is_gathered(&self, row: usize) -> bool {
        self.is_gathered.get(row) == Some(&true)
    }

    /// From what a row hangs: pinned rows above and below, or one of them twice, the share of the way from
    /// the first to the second, and the rows to the first.
    pub(crate) fn between(&self, row: usize) -> Option<([u32; 2], f32, u32)> {
        let pins = [*self.nearest.get(row)?, *self.opposite.get(row)?];
        let far = pins[0].abs_diff(narrow(row));
        #[expect(clippy::cast_precision_loss, reason = "rows are fewer than 2^24")]
        let share = match pins[0].abs_diff(pins[1]) {
            0 => 0.0,
            apart => far as f32 / apart as f32,
        };
        Some((pins, share, far))
    }

    /// How far every row may stay inside the capsules [m]: `limit` where pins hold it, less with
    /// the cloth between, nothing where no row is pinned.
    pub(crate) fn held_depths(
        &self,
        (limit, row_count, spacing): (f32, u32, f32),
        depths: &mut Vec<f32>,
    ) {
        depths.clear();
        #[expect(clippy::cast_precision_loss, reason = "rows are fewer than 2^24")]
        depths.extend(
            (0u32..).zip(&self.nearest).map(|(row, &pin)| {
                (limit - HELD_SLOPE * row.abs_diff(pin) as f32 * spacing).max(0.0)
            }),
        );
        depths.resize(row_count as usize, 0.0);
    }

    /// Distance of the pins from which two particles, by row and column, hang, and the cloth between
    /// the particles and their pins [m].
    pub(crate) fn gap(
        &self,
        grid: &Grid,
        positions: &[Vec3],
        places: [[u32; 2]; 2],
    ) -> Option<(f32, f32)> {
        let mut cloth = 0.0;
        let mut pins = [Vec3::ZERO; 2];
        for (pin, [own_row, column]) in pins.iter_mut().zip(places) {
            let row = *self.nearest.get(own_row as usize)?;
            #[expect(clippy::cast_precision_loss, reason = "rows are fewer than 2^24")]
            let rows = row.abs_diff(own_row) as f32;
            cloth += rows * grid.spacing[1];
            *pin = positions[grid.index(row, column)];
        }
        Some((pins[0].distance(pins[1]), cloth))
    }
}
