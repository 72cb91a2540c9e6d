//! Surfels sorted into cubic cells, and the nearest of those around a point.

use std::ops::Range;

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::{IVec3, Vec3};
use lole_geom::Surfel;

use super::nearness::{FARTHEST, Nearness};
use super::{PINCH_REACH, REACH_MAX, Skin};
use crate::collision::grid::each_hit;
use crate::lanes::{LANES, Vectors, narrow};

/// Edge of a cell [m]: a few surfels' spacing.
const CELL: f32 = 0.02;

/// Cells at most along an axis: a body is at most so many times 2 cm, and what has flown farther
/// away touches no skin.
const CELLS_ALONG: i32 = 160;

const _: () = assert!(
    REACH_MAX <= (FARTHEST - 1) as f32 * CELL,
    "empty cells around the surfels reach far enough"
);

/// Surfels with normals whose product is less face against each other.
const FACING_AGAINST: f32 = -0.3;

/// Cells counted to at most: points farther away than this have no surfel near.
const FAR: f32 = 1024.0;
const FAR_CELL: IVec3 = IVec3::splat(1024);

/// Cosine of the angle with their mean within which surfels lie of which no two face against each
/// other: twice the angle is less than [`FACING_AGAINST`] asks for.
const ONE_WAY: f32 = 0.6;

/// How the surfels around a cell face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Facing {
    Unknown,
    OneWay,
    Several,
}

/// How the surfels around the cells face, as far as it was asked for.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Facings(Vec<Facing>);

impl Facings {
    /// Memory that it holds [byte].
    pub(super) const fn byte_count(&self) -> usize {
        size_of_val(self.0.as_slice())
    }

    /// Forgets all.
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }
}

/// The surfels near the cloth in the middle of a step.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct SurfelCells {
    low: Vec3,
    counts: IVec3,
    /// First entry of every cell, and one more; along x first.
    starts: Vec<u32>,
    /// Where each surfel is in the middle of the step, and which it is, by cell.
    entries: Vec<(Vec3, u32)>,
    unsorted: Vec<(Vec3, u32)>,
    cells: Vec<u32>,
    /// The same positions by axis [m], and a vector beyond the last.
    coordinates: [Vec<f32>; 3],
    nearness: Nearness,
    mean_motion: Vec3,
    spread: f32,
}

impl SurfelCells {
    /// Memory that it holds [byte].
    pub(crate) const fn byte_count(&self) -> usize {
        size_of_val(self.starts.as_slice())
            + size_of_val(self.entries.as_slice())
            + size_of_val(self.unsorted.as_slice())
            + size_of_val(self.cells.as_slice())
            + 3 * size_of_val(self.coordinates[0].as_slice())
            + self.nearness.byte_count()
    }

    /// What the surfels do in the step on the mean [m].
    pub(crate) const fn mean_motion(&self) -> Vec3 {
        self.mean_motion
    }

    /// Farthest that one of them moves besides [m].
    pub(crate) const fn spread(&self) -> f32 {
        self.spread
    }

    /// Sorts those that come within `reach` [m] of the box `bounds`. Not inlined into vector code:
    /// it would change kinds of instructions.
    #[inline(never)]
    pub(crate) fn sort(&mut self, skin: Skin<'_>, [low, high]: [Vec3; 2], reach: f32) {
        self.choose(skin, [low - reach, high + reach]);
        let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let (low, high) = (self.unsorted.iter()).fold(start, |(low, high), &(middle, _)| {
            (low.min(middle), high.max(middle))
        });
        // Empty cells all around, so that what may come near lies in one.
        self.low = low - FARTHEST as f32 * CELL;
        self.counts = if self.unsorted.is_empty() {
            IVec3::ZERO
        } else {
            (self.cell_of(high) + (FARTHEST + 1)).min(IVec3::splat(CELLS_ALONG))
        };
        let cell_count = self.counts.element_product();
        self.starts.clear();
        self.starts
            .resize(usize::try_from(cell_count).unwrap_or(0) + 1, 0);
        self.cells.clear();
        for &(middle, _) in &self.unsorted {
            let cell = self.cell_of(middle).min(self.counts - IVec3::ONE);
            let cell = self.index(cell);
            self.starts[cell + 1] += 1;
            self.cells.push(narrow(cell));
        }
        let mut sum = 0;
        for start in &mut self.starts {
            sum += *start;
            *start = sum;
        }
        self.entries.clear();
        self.entries.resize(self.unsorted.len(), (Vec3::ZERO, 0));
        // Backwards: the start of the next cell is counted down to the start of this one.
        for (&entry, &cell) in self.unsorted.iter().zip(&self.cells).rev() {
            let end = &mut self.starts[cell as usize + 1];
            *end -= 1;
            self.entries[*end as usize] = entry;
        }
        self.starts.remove(0);
        self.starts.push(narrow(self.unsorted.len()));
        self.nearness.set(self.counts, &self.starts);
        for (axis, column) in self.coordinates.iter_mut().enumerate() {
            column.clear();
            column.extend(self.entries.iter().map(|(middle, _)| middle[axis]));
            column.resize(self.entries.len() + LANES, f32::INFINITY);
        }
    }

    /// Takes those in the box, and how they move.
    fn choose(&mut self, skin: Skin<'_>, [low, high]: [Vec3; 2]) {
        self.unsorted.clear();
        let mut sum = Vec3::ZERO;
        for ((index, before), after) in (0u32..).zip(skin.before).zip(skin.after) {
            if before.is_withdrawn() || after.is_withdrawn() {
                continue;
            }
            let middle = (before.position + after.position) * 0.5;
            if middle.cmpge(low).all() && middle.cmple(high).all() {
                self.unsorted.push((middle, index));
                sum += after.position - before.position;
            }
        }
        #[expect(clippy::cast_precision_loss, reason = "surfels are fewer than 2^24")]
        let count = self.unsorted.len().max(1) as f32;
        self.mean_motion = sum / count;
        let spread = self.unsorted.iter().map(|&(_, index)| {
            let index = index as usize;
            let motion = skin.after[index].position - skin.before[index].position;
            (motion - self.mean_motion).length_squared()
        });
        self.spread = spread.fold(0.0, f32::max).sqrt();
    }

    /// Rounded down by cutting off, which is quick, and is the same from where it is positive on.
    fn cell_of(&self, point: Vec3) -> IVec3 {
        let far = Vec3::splat(FAR);
        let cell = (point - self.low) * (1.0 / CELL);
        (cell.clamp(-far, far) + far).as_ivec3() - FAR_CELL
    }

    fn index(&self, cell: IVec3) -> usize {
        let index = (cell.z * self.counts.y + cell.y) * self.counts.x + cell.x;
        usize::try_from(index).unwrap_or(0)
    }

    /// Whether a surfel may lie within `reach` [m] of `point`: `false` is certain.
    fn may_reach(&self, point: Vec3, reach: f32) -> bool {
        let cell = self.cell_of(point);
        let is_inside = cell.cmpge(IVec3::ZERO).all() && cell.cmplt(self.counts).all();
        #[expect(clippy::cast_possible_truncation, reason = "a reach is a few cells")]
        let range = (reach * (1.0 / CELL)) as i32 + 1;
        is_inside && self.nearness.may_reach(self.index(cell), range)
    }

    /// The surfel nearest to `point` within `reach` [m], by its place among the entries; of equals
    /// the first. `hint` is one that may be it: a near one saves work and changes nothing.
    #[inline(always)]
    pub(crate) fn nearest<S: Simd>(
        &self,
        simd: S,
        point: Vec3,
        reach: f32,
        hint: Option<usize>,
    ) -> Option<usize> {
        if !self.may_reach(point, reach) {
            return None;
        }
        let mut least = reach * reach;
        let mut best = self.nearer(point, reach, [hint, None]);
        if let Some(place) = best {
            least = point.distance_squared(self.entries[place].0);
        }
        self.for_each_run(point, least.sqrt(), |run| {
            (least, best) = self.nearest_of(simd, run, point, (least, best));
        });
        best
    }

    /// The surfel nearest to `point` of those within [`PINCH_REACH`] that face against the one at
    /// `place`; `hint` as for [`Self::nearest`].
    pub(crate) fn opposite(
        &self,
        point: Vec3,
        (place, hint): (usize, Option<usize>),
        surfels: &[Surfel],
        facings: &mut Facings,
    ) -> Option<usize> {
        if self.faces_one_way(point, surfels, facings) {
            return None;
        }
        let normal = surfels[self.surfel(place)].normal;
        let faces_against =
            |other: usize| surfels[self.surfel(other)].normal.dot(normal) < FACING_AGAINST;
        let hint = hint.filter(|&hint| faces_against(hint));
        let mut best = self.nearer(point, PINCH_REACH, [hint, None]);
        let mut least = best.map_or(PINCH_REACH * PINCH_REACH, |place| {
            point.distance_squared(self.entries[place].0)
        });
        self.for_each_run(point, least.sqrt(), |run| {
            for place in run {
                let squared = point.distance_squared(self.entries[place].0);
                let ties = squared <= least && best.is_some_and(|other| place < other);
                if (squared < least || ties) && faces_against(place) {
                    (least, best) = (squared, Some(place));
                }
            }
        });
        best
    }

    /// Whether all surfels within [`PINCH_REACH`] of the points of a cell face one way, so that none
    /// of them faces against another.
    fn faces_one_way(&self, point: Vec3, surfels: &[Surfel], facings: &mut Facings) -> bool {
        let cell = self.cell_of(point);
        if cell.cmplt(IVec3::ZERO).any() || cell.cmpge(self.counts).any() {
            return true;
        }
        let index = self.index(cell);
        let facings = &mut facings.0;
        if facings.is_empty() {
            facings.resize(self.starts.len() - 1, Facing::Unknown);
        }
        if facings[index] == Facing::Unknown {
            let middle = self.low + (cell.as_vec3() + 0.5) * CELL;
            let radius = PINCH_REACH + 0.5 * CELL;
            let mut sum = Vec3::ZERO;
            self.for_each_run(middle, radius, |run| {
                sum += run
                    .map(|place| surfels[self.surfel(place)].normal)
                    .sum::<Vec3>();
            });
            let mean = sum.normalize_or_zero();
            let mut is_one_way = true;
            self.for_each_run(middle, radius, |mut run| {
                is_one_way &=
                    run.all(|place| ONE_WAY < surfels[self.surfel(place)].normal.dot(mean));
            });
            facings[index] = if is_one_way {
                Facing::OneWay
            } else {
                Facing::Several
            };
        }
        facings[index] == Facing::OneWay
    }

    /// Calls with the places of all surfels in the cells within `radius` [m] of `point`, and of more.
    #[inline(always)]
    fn for_each_run(&self, point: Vec3, radius: f32, mut visit: impl FnMut(Range<usize>)) {
        let low = self.cell_of(point - radius).max(IVec3::ZERO);
        let high = self.cell_of(point + radius).min(self.counts - IVec3::ONE);
        if high.cmplt(low).any() {
            return;
        }
        for z in low.z..=high.z {
            for y in low.y..=high.y {
                let start = self.starts[self.index(IVec3::new(low.x, y, z))] as usize;
                let end = self.starts[self.index(IVec3::new(high.x, y, z)) + 1] as usize;
                visit(start..end);
            }
        }
    }

    /// The nearest to `point` of some places and the best so far, with its squared distance [m²]; of
    /// equals the first.
    #[inline(always)]
    fn nearest_of<S: Simd>(
        &self,
        simd: S,
        places: Range<usize>,
        point: Vec3,
        (mut least, mut best): (f32, Option<usize>),
    ) -> (f32, Option<usize>) {
        let [x, y, z] = &self.coordinates;
        let own = Vectors::splat(simd, point);
        for from in places.clone().step_by(LANES) {
            let lanes = from..from + LANES;
            let offset = own.sub(Vectors {
                x: f32x16::from_slice(simd, &x[lanes.clone()]),
                y: f32x16::from_slice(simd, &y[lanes.clone()]),
                z: f32x16::from_slice(simd, &z[lanes]),
            });
            let near = offset.dot(offset).simd_le(f32x16::splat(simd, least));
            for lane in each_hit(near.to_bitmask(), places.end - from) {
                let place = from + lane;
                let squared = point.distance_squared(self.entries[place].0);
                let ties = squared <= least && best.is_some_and(|other| place < other);
                if squared < least || ties {
                    (least, best) = (squared, Some(place));
                }
            }
        }
        (least, best)
    }

    /// The nearer to `point` of two places, if it is within `reach` [m].
    pub(crate) fn nearer(
        &self,
        point: Vec3,
        reach: f32,
        places: [Option<usize>; 2],
    ) -> Option<usize> {
        let mut least = reach * reach;
        let mut best = None;
        for place in places.into_iter().flatten() {
            let squared = point.distance_squared(self.entries[place].0);
            if squared < least {
                (least, best) = (squared, Some(place));
            }
        }
        best
    }

    /// Where the surfel at a place is in the middle of the step [m].
    pub(crate) fn position(&self, place: usize) -> Vec3 {
        self.entries[place].0
    }

    /// Which surfel is at a place among the entries.
    pub(crate) fn surfel(&self, place: usize) -> usize {
        self.entries[place].1 as usize
    }
}
