//! Where the rows of a band lie on a body: on the skin of a built dancer, and over the borders of
//! whatever somebody else wears.

use std::ops::Range;

use glam::{Vec2, Vec3};
use lole_body::{Dancer, TapePoint};
use lole_geom::trig;

use super::SewError;
use super::ring::Ring;

/// Distance between tapes [m].
pub(super) const STEP: f32 = 0.005;
/// Tapes above and below over which a band is straight where clothes end: 2 cm.
const OVER_BORDERS: usize = 4;

/// Tapes around a dancer, at any height where a band may lie.
pub(super) enum Profile<'a> {
    /// The skin's own.
    Skin(&'a Dancer),
    /// One shape of a ring that goes evenly from height to height, outside of all that it passes: every
    /// ring has its points in the same directions, so that cloth between two of them does not slant.
    Even {
        /// A ring below all others.
        low: Box<Ring>,
        axis: Vec2,
        /// By level from [`Self::Even::low`] up, how far each of its points is from the axis [m].
        radii: Vec<Vec<f32>>,
    },
}

impl<'a> Profile<'a> {
    /// The tapes of a dancer that are asked for between two heights of the bind pose [m].
    pub(super) fn new(dancer: &'a Dancer, heights: Range<f32>) -> Result<Self, SewError> {
        if !dancer.skin.is_given() {
            return Ok(Self::Skin(dancer));
        }
        let low = Ring::at(dancer, heights.start)?;
        let middle: Vec3 = low.points().iter().map(|point| point.bind_position).sum();
        let middle = middle / low.points().len() as f32;
        let axis = Vec2::new(middle.x, middle.z);
        let first = heights.start - OVER_BORDERS as f32 * STEP;
        let mut measured = Vec::new();
        let mut height = first;
        while height < heights.end + 2.0 * OVER_BORDERS as f32 * STEP {
            measured.push(radii_of(&Ring::at(dancer, height).ok(), (&low, axis)));
            height += STEP;
        }
        let fallback = radii_of(&Some(low.clone()), (&low, axis)).unwrap_or_default();
        let level = |at: usize| {
            let near = at.saturating_sub(OVER_BORDERS)..(at + OVER_BORDERS + 1);
            let near = &measured[near.start..near.end.min(measured.len())];
            let largest = |place: usize| {
                let known = near.iter().flatten().map(|radii| radii[place]);
                known.reduce(f32::max).unwrap_or(fallback[place])
            };
            (0..fallback.len()).map(largest).collect::<Vec<f32>>()
        };
        let largest: Vec<Vec<f32>> = (0..measured.len()).map(level).collect();
        let radii = (OVER_BORDERS..largest.len()).map(|at| {
            let near = &largest[at - OVER_BORDERS..(at + OVER_BORDERS + 1).min(largest.len())];
            let mean = |place: usize| {
                near.iter().map(|radii| radii[place]).sum::<f32>() / near.len() as f32
            };
            (0..fallback.len()).map(mean).collect()
        });
        Ok(Self::Even {
            axis,
            radii: radii.collect(),
            low: Box::new(low),
        })
    }

    /// The ring at a height of the bind pose [m].
    pub(super) fn at(&self, height: f32) -> Result<Ring, SewError> {
        let (low, axis, radii) = match self {
            Self::Skin(dancer) => return Ring::at(dancer, height),
            Self::Even { low, axis, radii } => (low, axis, radii),
        };
        let start = low.points()[0].bind_position.y;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "levels are some hundreds at most"
        )]
        let level = ((height - start) / STEP).round().max(0.0) as usize;
        let Some(radii) = radii.get(level).or(radii.last()) else {
            return Err(SewError::NoSection {
                height_cm: f64::from(height) * 100.0,
            });
        };
        let points = low.points().iter().zip(radii).map(|(point, radius)| {
            let arm = Vec2::new(point.bind_position.x, point.bind_position.z) - *axis;
            let place = *axis + arm.normalize_or_zero() * *radius;
            TapePoint {
                bind_position: Vec3::new(place.x, height, place.y),
                ..*point
            }
        });
        Ok(Ring::of(points.collect()))
    }
}

/// How far a ring is from an axis [m] in the directions of the points of another; `None` where there is
/// no ring around it.
fn radii_of(ring: &Option<Ring>, (directions, axis): (&Ring, Vec2)) -> Option<Vec<f32>> {
    let arm = |point: &TapePoint| Vec2::new(point.bind_position.x, point.bind_position.z) - axis;
    let turn = |arm: Vec2| trig::atan2(arm.y, arm.x);
    let mut polar: Vec<(f32, f32)> = (ring.as_ref()?.points().iter())
        .map(|point| (turn(arm(point)), arm(point).length()))
        .collect();
    polar.sort_by(|a, b| a.0.total_cmp(&b.0));
    let radius = |at: f32| {
        let next = polar.partition_point(|&(turn, _)| turn < at);
        let [before, after] =
            [next + polar.len() - 1, next].map(|place| polar[place % polar.len()]);
        let whole = std::f32::consts::TAU;
        let gap = (after.0 - before.0).rem_euclid(whole);
        let share = (at - before.0).rem_euclid(whole) / gap.max(f32::MIN_POSITIVE);
        before.1 + (after.1 - before.1) * share.clamp(0.0, 1.0)
    };
    let points = directions.points().iter();
    Some(points.map(|point| radius(turn(arm(point)))).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circle(radius: f32) -> Ring {
        let points = (0_u16..720).map(|index| {
            let (sin, cos) = trig::sin_cos(f32::from(index) / 720.0 * std::f32::consts::TAU);
            let outward = Vec3::new(cos, 0.0, sin);
            TapePoint {
                bind_position: outward * radius + Vec3::new(0.01, 1.0, -0.02),
                outward,
                joints: [0; 4],
                weights: [1.0, 0.0, 0.0, 0.0],
            }
        });
        Ring::of(points.collect())
    }

    #[test]
    fn radii_of_a_circle_are_its_radius_in_any_direction() {
        let axis = Vec2::new(0.01, -0.02);
        let radii = radii_of(&Some(circle(0.2)), (&circle(0.1), axis)).unwrap();
        assert_eq!(radii.len(), 720);
        assert!(radii.iter().all(|radius| (radius - 0.2).abs() < 1.0e-4));
        assert_eq!(radii_of(&None, (&circle(0.1), axis)), None);
    }
}
