//! Rows that are pinned all along: contact may not fight the shape in which they are held.

use glam::Vec3;

use crate::collision::grid::Entry;
use crate::{ClothSpec, Grid};

/// For every row the nearest row that is pinned all along; empty where none is.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct PinnedRows {
    pub(crate) nearest: Vec<u32>,
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
        Self {
            nearest: nearest.collect(),
        }
    }

    /// The rows that are pinned all along.
    pub(crate) fn rows(&self) -> impl Iterator<Item = usize> {
        let rows = self.nearest.iter().enumerate();
        rows.filter(|&(row, &nearest)| row == nearest as usize)
            .map(|(row, _)| row)
    }

    /// Distance of the pins from which two particles hang, and the cloth between the particles
    /// and their pins [m].
    pub(crate) fn gap(
        &self,
        grid: &Grid,
        positions: &[Vec3],
        entries: [&Entry; 2],
    ) -> Option<(f32, f32)> {
        let mut cloth = 0.0;
        let mut pins = [Vec3::ZERO; 2];
        for (pin, entry) in pins.iter_mut().zip(entries) {
            let row = *self.nearest.get(entry.row as usize)?;
            #[expect(clippy::cast_precision_loss, reason = "rows are fewer than 2^24")]
            let rows = row.abs_diff(entry.row) as f32;
            cloth += rows * grid.spacing[1];
            *pin = positions[grid.index(row, entry.column)];
        }
        Some((pins[0].distance(pins[1]), cloth))
    }
}
