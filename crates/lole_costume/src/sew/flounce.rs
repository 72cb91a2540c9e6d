//! The gathers of a flounce before it hangs.

use std::f32::consts::TAU;

use glam::Vec3;
use lole_body::TapePoint;
use lole_cloth::{Flounce, Grid};
use lole_geom::trig;

use lole_garment::wave;

/// Particles of a gather: with fewer it is a cog.
const GATHER_COLUMNS: u32 = 8;

/// Cloth below the seam over which gathers open [m].
const OPENING: f32 = 0.03;

/// Gathers are laid this much less deep than they will be: what is pressed together opens by itself,
/// and what would lie in a fold of the cloth above does not start inside of it.
const LAID: f32 = 0.8;

/// Deepest wave that finds room within the folds of the cloth above [m].
const DEEPEST: f32 = 0.009;

/// Lays what a flounce is longer than the cloth above it in waves to both sides of where that would go
/// on; `start` has every particle of the grid where cloth without flounce would be.
pub(super) fn gather(grid: &Grid, start: &mut [TapePoint]) {
    let Some(Flounce { seam_row, fullness }) = grid.flounce else {
        return;
    };
    let columns = grid.column_count;
    let count = (columns / GATHER_COLUMNS).max(1);
    let length = columns as f32 * grid.spacing[0] / count as f32;
    let depth = (LAID * wave::depth(length, fullness)).min(DEEPEST);
    for row in seam_row + 1..grid.row_count {
        let below = (row - seam_row) as f32 * grid.spacing[1];
        let depth = depth * (below / OPENING).min(1.0);
        let at = |column: u32| start[grid.index(row, column % columns)].bind_position;
        let shifts: Vec<Vec3> = (0..columns)
            .map(|column| {
                let along = (at(column + 1) - at(column + columns - 1)).with_y(0.0);
                let outward = along.cross(Vec3::Y).normalize_or_zero();
                let phase = TAU * count as f32 * column as f32 / columns as f32;
                outward * depth * trig::sin(phase)
            })
            .collect();
        for (column, shift) in (0..columns).zip(shifts) {
            start[grid.index(row, column)].bind_position += shift;
        }
    }
}
