//! Contact with the body: projection out of moving capsules with Coulomb friction.

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::Vec3;
use lole_geom::Capsule;

use crate::lanes::{Points, Scalars, Vectors, larger, smaller};

/// A row nearer to a capsule than this [m] is tested against it in every substep of the step,
/// whatever its speed: 3 cm let cloth through in the first frames of the skirt scene.
const CULL_MARGIN: f32 = 0.06;

/// How much farther than its speed promises a particle may come in one step.
const SPEED_MARGIN: f32 = 1.5;

/// Below this squared axis length [m²] a capsule is a sphere (a thread is 1e-4 m thick).
const DEGENERATE_AXIS_SQUARED: f32 = 1.0e-12;

/// Below this distance [m] from the axis a contact has no direction.
const DEGENERATE_DISTANCE: f32 = 1.0e-7;

/// Below this slip [m] in a substep friction has no direction; it keeps the quotient finite.
const DEGENERATE_SLIP: f32 = 1.0e-12;

/// Passes over the capsules of a row where one pushes into another, at most.
const PASS_COUNT_MAX: usize = 12;

/// A capsule at the end of a substep, with what it did during it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MovingCapsule {
    start: Vec3,
    axis: Vec3,
    /// `|axis|²` [m²], and `axis / |axis|²` [1/m], which is zero for a sphere.
    length_squared: f32,
    axis_share: Vec3,
    /// Radius and contact offset at the start, and what the end has more [m].
    radii: [f32; 2],
    /// Displacement of the start during the substep, and what the end moved more [m].
    displacement: Vec3,
    stretch: Vec3,
}

impl MovingCapsule {
    /// The capsule a `fraction` of the way from `before` to `after`, having come there in
    /// `substep_fraction` of the way, with a skin of `contact_offset` [m].
    pub(crate) fn new(
        [before, after]: [&Capsule; 2],
        fraction: f32,
        substep_fraction: f32,
        contact_offset: f32,
    ) -> Self {
        let capsule = before.lerp(after, fraction);
        let axis = capsule.ends[1] - capsule.ends[0];
        let length_squared = axis.length_squared();
        let moved = [0, 1].map(|end| (after.ends[end] - before.ends[end]) * substep_fraction);
        let is_sphere = length_squared < DEGENERATE_AXIS_SQUARED;
        Self {
            start: capsule.ends[0],
            axis,
            length_squared,
            axis_share: if is_sphere {
                Vec3::ZERO
            } else {
                axis / length_squared
            },
            radii: [
                capsule.radii[0] + contact_offset,
                capsule.radii[1] - capsule.radii[0],
            ],
            displacement: moved[0],
            stretch: moved[1] - moved[0],
        }
    }
}

/// What a contact needs to know besides where things are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContactLaw {
    /// Coulomb friction coefficient.
    pub(crate) friction: f32,
    /// Farthest that a particle is pushed out in a substep beyond undoing its own approach [m].
    pub(crate) depenetration: f32,
}

/// Particles of one row in a substep.
pub(crate) struct ContactRow<'a> {
    pub(crate) positions: &'a mut [Points],
    /// Positions predicted at the start of the substep [m].
    pub(crate) predicted: &'a [Points],
    /// Velocities that led there [m/s].
    pub(crate) velocities: &'a [Points],
    pub(crate) inv_masses: &'a [Scalars],
    /// Duration of the substep [s].
    pub(crate) h: f32,
    /// How far inside the capsules particles may stay [m].
    pub(crate) held: f32,
}

/// Vectors that are projected together: as many as a word has bits.
const TOGETHER: usize = 64;

impl ContactRow<'_> {
    /// Projects the row out of the capsules with these `indices`.
    ///
    /// Friction acts on the part of what a particle did in this substep that is tangential to the
    /// surface, relative to the surface's own motion, and is at most `friction` times the depth
    /// projected.
    ///
    /// Every vector meets the capsules one after the other, and once more round, until it has met
    /// all others after the last that it touched: leaving one may enter another. Vectors take turns
    /// at each capsule, because a test of one need not wait for that of another.
    #[inline(always)]
    pub(crate) fn project<S: Simd>(
        &mut self,
        simd: S,
        capsules: &[MovingCapsule],
        indices: &[u32],
        law: ContactLaw,
    ) {
        for first in (0..self.positions.len()).step_by(TOGETHER) {
            self.project_block(simd, first, (capsules, indices), law);
        }
    }

    #[inline(always)]
    fn project_block<S: Simd>(
        &mut self,
        simd: S,
        first: usize,
        (capsules, indices): (&[MovingCapsule], &[u32]),
        law: ContactLaw,
    ) {
        let count = TOGETHER.min(self.positions.len() - first);
        // Round at which a vector has met all.
        let mut ends = [indices.len(); TOGETHER];
        let mut active = u64::MAX >> (TOGETHER - count);
        for round in 0..PASS_COUNT_MAX * indices.len() {
            let capsule = &capsules[indices[round % indices.len()] as usize];
            let mut touched = 0;
            for place in bits(active) {
                let position = Vectors::load(simd, &self.positions[first + place]);
                let touches = capsule.may_touch(simd, position, self.held);
                touched |= u64::from(touches) << place;
            }
            for place in bits(touched) {
                if self.project_out(simd, first + place, capsule, law) {
                    ends[place] = round + indices.len();
                }
            }
            if indices.len() <= round + 1 {
                active = bits(active)
                    .filter(|&place| round + 1 < ends[place])
                    .fold(0, |word, place| word | 1 << place);
            }
            if active == 0 {
                break;
            }
        }
    }

    /// Projects one vector out of one capsule; whether any of it was inside.
    #[inline(always)]
    fn project_out<S: Simd>(
        &mut self,
        simd: S,
        index: usize,
        capsule: &MovingCapsule,
        law: ContactLaw,
    ) -> bool {
        let zero = f32x16::splat(simd, 0.0);
        let one = f32x16::splat(simd, 1.0);
        let position = Vectors::load(simd, &self.positions[index]);
        let inv_mass = f32x16::load_array_ref(simd, &self.inv_masses[index].0);
        let from_start = position.sub(Vectors::splat(simd, capsule.start));
        let s = capsule.foot(simd, from_start);
        let normal = from_start.sub(Vectors::splat(simd, capsule.axis).scale(s));
        let squared = normal.dot(normal);
        let radius = larger(s * capsule.radii[1] + capsule.radii[0] - self.held, zero);
        let touching = squared.simd_lt(radius * radius) & zero.simd_lt(inv_mass);
        if !touching.any_true() {
            return false;
        }
        let distance = squared.sqrt();
        let on_axis = distance.simd_lt(f32x16::splat(simd, DEGENERATE_DISTANCE));
        let inv_distance = one / larger(distance, f32x16::splat(simd, DEGENERATE_DISTANCE));
        let mut normal = normal.scale(inv_distance);
        normal.z = on_axis.select(one, normal.z);
        let surface = Vectors::splat(simd, capsule.displacement)
            .add(Vectors::splat(simd, capsule.stretch).scale(s));
        let flown = Vectors::load(simd, &self.velocities[index]).scale(f32x16::splat(simd, self.h));
        let before = Vectors::load(simd, &self.predicted[index]).sub(flown);
        let slip = position.sub(before).sub(surface);
        let approach = slip.dot(normal);
        let depth = smaller(
            radius - distance,
            // What an earlier pass has pushed counts: the limit holds for all passes together.
            larger(f32x16::splat(simd, law.depenetration) - approach, zero),
        );
        let depth = touching.select(depth, zero);
        if !zero.simd_lt(depth).any_true() {
            return false;
        }
        let tangential = slip.sub(normal.scale(approach));
        let slip_length = tangential.dot(tangential).sqrt() + DEGENERATE_SLIP;
        let held = smaller(depth * law.friction / slip_length, one);
        position
            .add(normal.scale(depth))
            .sub(tangential.scale(held))
            .store(&mut self.positions[index]);
        true
    }
}

/// Places of the ones in a word, ascending.
#[inline(always)]
fn bits(mut word: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(
        #[inline(always)]
        move || {
            let place = word.trailing_zeros() as usize;
            word &= word.wrapping_sub(1);
            (place < TOGETHER).then_some(place)
        },
    )
}

/// Beyond what touches a capsule, what is looked at closely [m]: the quick test rounds by less than
/// a thousandth of this.
const QUICK_MARGIN: f32 = 1.0e-4;

impl MovingCapsule {
    /// Share of the axis, from the start, that is nearest to points at `from_start` [m] from it.
    #[inline(always)]
    fn foot<S: Simd>(&self, simd: S, from_start: Vectors<S>) -> f32x16<S> {
        let along = from_start.dot(Vectors::splat(simd, self.axis_share));
        smaller(
            larger(along, f32x16::splat(simd, 0.0)),
            f32x16::splat(simd, 1.0),
        )
    }

    /// Whether points may lie inside: `false` is certain. `d² = |p|² + s (s |a|² - 2 p·a)` needs no
    /// normal.
    #[inline(always)]
    fn may_touch<S: Simd>(&self, simd: S, position: Vectors<S>, held: f32) -> bool {
        let from_start = position.sub(Vectors::splat(simd, self.start));
        let s = self.foot(simd, from_start);
        let along = from_start.dot(Vectors::splat(simd, self.axis));
        let squared = from_start.dot(from_start) + s * (s * self.length_squared - (along + along));
        let radius = s * self.radii[1] + (self.radii[0] + (QUICK_MARGIN - held));
        squared.simd_lt(radius * radius).any_true()
    }
}

/// Which capsules each row may touch during a step: list of capsule indices for every row, the
/// near ones first, and of these the nearest: it is touched most often, and what is touched last is
/// what the others are tested after once more.
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
            capsule: MovingCapsule::new([&thickest, &thickest], 1.0, 0.0, 0.0),
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

impl RowContacts {
    /// Those of a row.
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

    /// Finds them anew for a step of `dt` [s] in which capsules go from `before` to `after`.
    #[inline(always)]
    pub(crate) fn find<S: Simd>(
        &mut self,
        simd: S,
        rows: (&[Points], &[Points], usize),
        [before, after]: [&[Capsule]; 2],
        (contact_offset, speed_gain, dt): (f32, f32, f32),
    ) {
        let (positions, velocities, width) = rows;
        self.starts.clear();
        self.near_counts.clear();
        self.capsule_indices.clear();
        self.starts.push(0);
        self.sweep(before, after);
        for (row, speeds) in positions
            .chunks_exact(width)
            .zip(velocities.chunks_exact(width))
        {
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

#[expect(clippy::cast_possible_truncation, reason = "rows and capsules are few")]
const fn narrow(value: usize) -> u32 {
    value as u32
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
