//! Contact with a body of capsules: projection out of them as they move.

pub(crate) mod near;
pub(crate) mod stop;

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::Vec3;
use lole_geom::Capsule;

use crate::collision::response::{Contact, ContactRow};
use crate::lanes::{Vectors, larger, smaller};
use crate::step::Progress;

/// Below this squared axis length [m²] a capsule is a sphere (a thread is 1e-4 m thick).
const DEGENERATE_AXIS_SQUARED: f32 = 1.0e-12;

/// Below this distance [m] from the axis a contact has no direction.
const DEGENERATE_DISTANCE: f32 = 1.0e-7;

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
    /// The capsule so far on its way from `before` to `after`, with a skin of `contact_offset` [m].
    pub(crate) fn new(
        [before, after]: [&Capsule; 2],
        progress: Progress,
        contact_offset: f32,
    ) -> Self {
        let capsule = before.lerp(after, progress.fraction);
        let axis = capsule.ends[1] - capsule.ends[0];
        let length_squared = axis.length_squared();
        let moved = [0, 1].map(|end| (after.ends[end] - before.ends[end]) * progress.share);
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

/// Vectors that are projected together: as many as a word has bits.
const TOGETHER: usize = 64;

impl ContactRow<'_> {
    /// Projects the row out of the capsules with these `indices`.
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
    ) {
        for first in (0..self.positions.len()).step_by(TOGETHER) {
            self.project_block(simd, first, capsules, indices);
        }
    }

    #[inline(always)]
    fn project_block<S: Simd>(
        &mut self,
        simd: S,
        first: usize,
        capsules: &[MovingCapsule],
        indices: &[u32],
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
                if self.project_out(simd, first + place, capsule) {
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
    fn project_out<S: Simd>(&mut self, simd: S, index: usize, capsule: &MovingCapsule) -> bool {
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
        let contact = Contact {
            touching,
            normal,
            overlap: radius - distance,
            surface: Vectors::splat(simd, capsule.displacement)
                .add(Vectors::splat(simd, capsule.stretch).scale(s)),
        };
        self.push_out::<S, false>(simd, index, position, &contact)
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
