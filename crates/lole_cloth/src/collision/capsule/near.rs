//! Which capsules each row may touch during a step.

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::Vec3;
use lole_geom::Capsule;

use super::MovingCapsule;
use crate::lanes::{Points, Vectors, larger, narrow, smaller};
use crate::step::Progress;

/// A row nearer to a capsule than this [m] is tested against it in every substep of the step,
/// whatever its speed: 3 cm let cloth through in the first frames of the skirt scene.
const CULL_MARGIN: f32 = 0.06;

/// How much farther than its speed promises a particle may come in one step.
const SPEED_MARGIN: f32 = 1.5;

/// A capsule at its end that has not moved.
const STILL: Progress = Progress {
    fraction: 1.0,
    share: 0.0,
};

/// List of capsule indices for every row, the near ones first, and of these the nearest: it is touched most
/// often, and what is touched last is what the others are tested after once more.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct RowContacts {
    /// First entry of every row in `capsule_indices`, and one more.
    starts: Vec<u32>,
    /// How many of a row's are near.
    near_counts: Vec<u32>,
    capsule_indices: Vec<u32>,
    /// Room for the near ones of a row with their gaps [m], and for the far ones.
    near: Vec<(f32, u32)>,
    far: Vec<u32>,
    /// Room for the capsules as the search sees them.
    swept: Vec<Swept>,
}

/// Which of a row's capsules.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Range {
    /// Those that it may get to at its speed.
    Near,
    /// Those that it may get to when it is pulled besides.
    All,
}

/// A capsule during a step.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Swept {
    /// Where it is at the start, as thick as it ever is in the step.
    capsule: MovingCapsule,
    /// Box around it there.
    bounds: [Vec3; 2],
    /// How far any of it moves [m].
    moved: f32,
}

impl Swept {
    fn new(before: &Capsule, after: &Capsule) -> Self {
        let moved = [0, 1].map(|end| after.ends[end].distance(before.ends[end]));
        let thickest = Capsule {
            ends: before.ends,
            radii: [0, 1].map(|end| before.radii[end].max(after.radii[end])),
        };
        Self {
            capsule: MovingCapsule::new([&thickest, &thickest], STILL, 0.0),
            bounds: [
                Vec3::min(
                    before.ends[0] - thickest.radii[0],
                    before.ends[1] - thickest.radii[1],
                ),
                Vec3::max(
                    before.ends[0] + thickest.radii[0],
                    before.ends[1] + thickest.radii[1],
                ),
            ],
            moved: moved[0].max(moved[1]),
        }
    }

    /// Whether all that is in these bounds is farther away than `reach` [m].
    #[inline(always)]
    fn is_beyond(&self, [low, high]: [Vec3; 2], reach: f32) -> bool {
        let apart = (low - self.bounds[1]).max(self.bounds[0] - high);
        reach < apart.x.max(apart.y).max(apart.z)
    }
}

/// Rows of a cloth at the start of a step.
#[derive(Clone, Copy)]
pub(crate) struct Rows<'a> {
    pub(crate) positions: &'a [Points],
    pub(crate) velocities: &'a [Points],
    /// Vectors of a row.
    pub(crate) width: usize,
}

/// What capsules do in a step, and what it takes to get to them.
#[derive(Clone, Copy)]
pub(crate) struct CapsuleSweep<'a> {
    /// At the start, and at the end, in the same order.
    pub(crate) before: &'a [Capsule],
    pub(crate) after: &'a [Capsule],
    /// Distance kept from them [m].
    pub(crate) contact_offset: f32,
    /// What gravity adds to a speed in the step [m/s], and the step [s].
    pub(crate) speed_gain: f32,
    pub(crate) dt: f32,
}

impl RowContacts {
    /// Capsules that a row may touch.
    pub(crate) fn row(&self, row: usize, range: Range) -> &[u32] {
        let start = self.starts[row];
        let end = match range {
            Range::Near => start + self.near_counts[row],
            Range::All => self.starts[row + 1],
        };
        &self.capsule_indices[start as usize..end as usize]
    }

    /// Kept out of the vector code: glam's square roots are not of its kind, and changing kinds is
    /// dear.
    #[inline(never)]
    fn sweep(&mut self, before: &[Capsule], after: &[Capsule]) {
        self.swept.clear();
        let pairs = before.iter().zip(after);
        (self.swept).extend(pairs.map(|(before, after)| Swept::new(before, after)));
    }

    /// Finds anew which capsules each row may touch in a step.
    #[inline(always)]
    pub(crate) fn find<S: Simd>(&mut self, simd: S, rows: Rows<'_>, sweep: CapsuleSweep<'_>) {
        let CapsuleSweep {
            contact_offset,
            speed_gain,
            dt,
            ..
        } = sweep;
        self.starts.clear();
        self.near_counts.clear();
        self.capsule_indices.clear();
        self.starts.push(0);
        self.sweep(sweep.before, sweep.after);
        let all = rows.positions.chunks_exact(rows.width);
        for (row, speeds) in all.zip(rows.velocities.chunks_exact(rows.width)) {
            let travel = (fastest(simd, speeds) + speed_gain) * dt;
            let first = self.capsule_indices.len();
            self.near.clear();
            self.far.clear();
            let bounds = bounds(simd, row);
            for (index, swept) in (0u32..).zip(&self.swept) {
                let near = SPEED_MARGIN * (travel + swept.moved) + contact_offset;
                let far = near.max(CULL_MARGIN + contact_offset);
                if swept.is_beyond(bounds, far) {
                    continue;
                }
                let gap = gap(simd, row, &swept.capsule);
                if gap < near {
                    let place = self.near.partition_point(|&(other, _)| other <= gap);
                    self.near.insert(place, (gap, index));
                } else if gap < far {
                    self.far.push(index);
                }
            }
            let indices = self.near.iter().map(|&(_, index)| index);
            self.capsule_indices.extend(indices);
            let near_count = self.capsule_indices.len() - first;
            self.near_counts.push(narrow(near_count));
            self.capsule_indices.extend_from_slice(&self.far);
            self.starts.push(narrow(self.capsule_indices.len()));
        }
    }
}

/// Box around a row.
#[inline(always)]
fn bounds<S: Simd>(simd: S, row: &[Points]) -> [Vec3; 2] {
    let far = f32x16::splat(simd, f32::INFINITY);
    let mut low = [far; 3];
    let mut high = [far * -1.0; 3];
    for points in row {
        let point = Vectors::load(simd, points);
        for (axis, value) in [point.x, point.y, point.z].into_iter().enumerate() {
            low[axis] = smaller(low[axis], value);
            high[axis] = larger(high[axis], value);
        }
    }
    let least = |lanes: f32x16<S>| lanes.to_array().into_iter().fold(f32::INFINITY, f32::min);
    let most = |lanes: f32x16<S>| {
        let lanes = lanes.to_array().into_iter();
        lanes.fold(f32::NEG_INFINITY, f32::max)
    };
    [
        Vec3::new(least(low[0]), least(low[1]), least(low[2])),
        Vec3::new(most(high[0]), most(high[1]), most(high[2])),
    ]
}

/// Largest speed in a row.
#[inline(always)]
fn fastest<S: Simd>(simd: S, velocities: &[Points]) -> f32 {
    let mut squared = f32x16::splat(simd, 0.0);
    for velocity in velocities {
        let velocity = Vectors::load(simd, velocity);
        squared = larger(squared, velocity.dot(velocity));
    }
    squared.to_array().into_iter().fold(0.0, f32::max).sqrt()
}

/// Distance [m] of the nearest particle of a row from the surface of `capsule`, negative inside.
#[inline(always)]
fn gap<S: Simd>(simd: S, row: &[Points], capsule: &MovingCapsule) -> f32 {
    let axis = Vectors::splat(simd, capsule.axis);
    let start = Vectors::splat(simd, capsule.start);
    let mut nearest = f32x16::splat(simd, f32::INFINITY);
    for points in row {
        let from_start = Vectors::load(simd, points).sub(start);
        let s = capsule.foot(simd, from_start);
        let normal = from_start.sub(axis.scale(s));
        let radius = s * capsule.radii[1] + capsule.radii[0];
        nearest = smaller(nearest, normal.dot(normal).sqrt() - radius);
    }
    nearest.to_array().into_iter().fold(f32::INFINITY, f32::min)
}
