//! What a run is judged by: strain, penetration, the first number that is not one.

mod crossings;
mod layers;

pub use crossings::self_crossings;
pub use crossings::{crossing_count, crossings};
pub use layers::layer_inversions;

use glam::Vec3;
use lole_geom::Capsule;

use crate::ClothSpec;

/// Absolute strain of the structural springs, pairs of pinned particles left out.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StrainSummary {
    /// Mean of `|length / rest_length - 1|`.
    pub mean: f32,
    /// 99th percentile: entry `count · 99 / 100` of the sorted strains.
    pub p99: f32,
    /// Largest strain.
    pub max: f32,
}

/// Strain of `positions` [m], row-major.
#[must_use]
pub fn strain(spec: &ClothSpec, positions: &[Vec3]) -> StrainSummary {
    summarize(structural_strains(spec, positions))
}

/// Mean, 99th percentile and largest of these strains.
pub(crate) fn summarize(mut strains: Vec<f32>) -> StrainSummary {
    if strains.is_empty() {
        return StrainSummary::default();
    }
    strains.sort_by(f32::total_cmp);
    let sum: f64 = strains.iter().map(|&strain| f64::from(strain)).sum();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_precision_loss,
        reason = "a mean strain needs no more than f32 holds"
    )]
    let mean = (sum / strains.len() as f64) as f32;
    StrainSummary {
        mean,
        p99: strains[strains.len() * 99 / 100],
        max: strains[strains.len() - 1],
    }
}

fn structural_strains(spec: &ClothSpec, positions: &[Vec3]) -> Vec<f32> {
    let mut strains = Vec::with_capacity(2 * spec.grid.particle_count());
    each_structural_edge(spec, |[first, second], rest_length| {
        if !(spec.pinned[first] && spec.pinned[second]) {
            let length = positions[first].distance(positions[second]);
            strains.push((length / rest_length - 1.0).abs());
        }
    });
    strains
}

/// Mean strain of the structural springs at each particle of `positions` [m], row-major,
/// `length / rest_length - 1`: positive where the cloth is stretched.
#[must_use]
pub fn strain_by_particle(spec: &ClothSpec, positions: &[Vec3]) -> Vec<f32> {
    let mut sums = vec![(0.0_f32, 0.0_f32); positions.len()];
    each_structural_edge(spec, |[first, second], rest_length| {
        let length = positions[first].distance(positions[second]);
        for particle in [first, second] {
            sums[particle].0 += length / rest_length - 1.0;
            sums[particle].1 += 1.0;
        }
    });
    sums.into_iter()
        .map(|(sum, count)| sum / count.max(1.0))
        .collect()
}

/// Calls with both ends of every edge of the grid and the length it has at rest [m].
pub(crate) fn each_structural_edge(spec: &ClothSpec, mut edge: impl FnMut([usize; 2], f32)) {
    let grid = &spec.grid;
    for row in 0..grid.row_count {
        for column in 0..grid.column_count {
            let particle = grid.index(row, column);
            if let Some(right) = grid.column_right(column, 1) {
                edge([particle, grid.index(row, right)], grid.row_spacing(row));
            }
            if row + 1 < grid.row_count {
                edge([particle, grid.index(row + 1, column)], grid.spacing[1]);
            }
        }
    }
}

/// Index of the first position that is not finite.
#[must_use]
pub fn first_non_finite(positions: &[Vec3]) -> Option<usize> {
    positions.iter().position(|position| !position.is_finite())
}

/// Deepest penetration [m] of a free particle of `positions` in any of `capsules`, never negative.
#[must_use]
pub fn worst_capsule_penetration(
    spec: &ClothSpec,
    positions: &[Vec3],
    capsules: &[Capsule],
) -> f32 {
    let free = positions
        .iter()
        .zip(&spec.pinned)
        .filter(|(_, pinned)| !**pinned);
    free.flat_map(|(&position, _)| {
        capsules
            .iter()
            .map(move |capsule| -capsule.signed_distance(position))
    })
    .fold(0.0, f32::max)
}

/// Free particles of `positions` that are deeper than `depth` [m] in any of `capsules`.
#[must_use]
pub fn penetrating_count(
    spec: &ClothSpec,
    positions: &[Vec3],
    capsules: &[Capsule],
    depth: f32,
) -> usize {
    let free = positions
        .iter()
        .zip(&spec.pinned)
        .filter(|(_, pinned)| !**pinned);
    free.filter(|&(&position, _)| {
        let is_inside = |capsule: &Capsule| capsule.signed_distance(position) < -depth;
        capsules.iter().any(is_inside)
    })
    .count()
}

/// Root mean square of the speeds [m/s].
#[must_use]
pub fn rms_speed(velocities: &[Vec3]) -> f32 {
    if velocities.is_empty() {
        return 0.0;
    }
    let sum: f64 = velocities
        .iter()
        .map(|velocity| f64::from(velocity.length_squared()))
        .sum();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_precision_loss,
        reason = "a speed needs no more than f32 holds"
    )]
    let speed = (sum / velocities.len() as f64).sqrt() as f32;
    speed
}
