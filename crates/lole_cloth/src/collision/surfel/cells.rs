//! Surfels sorted into cubic cells, and the nearest of those around a point.

mod together;

use std::ops::Range;

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::{IVec3, Vec3};
use lole_geom::Surfel;

use super::facing::Sectors;
use super::nearness::{FARTHEST, Nearness};
use super::{PINCH_REACH, REACH_MAX, Skin};
use crate::collision::grid::each_hit;
use crate::lanes::{LANES, Vectors, narrow};
pub(super) use together::Seeker;

/// Edge of a cell [m]: a few surfels' spacing.
const CELL: f32 = 0.02;

/// Cells at most along an axis: a body is at most so many times 2 cm, and what has flown farther
/// away touches no skin.
const CELLS_ALONG: i32 = 160;

const _: () = assert!(
    REACH_MAX <= (FARTHEST - 1) as f32 * CELL,
    "empty cells around the surfels reach far enough"
);

const _: () = assert!(
    PINCH_REACH <= CELL,
    "a block and a cell around it hold what is pinched"
);

/// Surfels with normals whose product is less face against each other.
const FACING_AGAINST: f32 = -0.3;

/// Cells counted to at most: points farther away than this have no surfel near.
const FAR: f32 = 1024.0;
const FAR_CELL: IVec3 = IVec3::splat(1024);

/// Cells along the edge of a block, for all points of which it is asked together how the skin faces.
const BLOCK: i32 = 2;

/// How the surfels around the blocks of cells face, as far as it was asked for.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Facings(Vec<Sectors>);

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
    /// Which surfels there are, by cell and in their order.
    entries: Vec<u32>,
    /// By surfel, its place among the entries; [`NO_PLACE`] of what is far.
    places: Vec<u32>,
    unsorted: Vec<Unsorted>,
    /// Where each of the entries is in the middle of the step, by axis [m], and a vector beyond the
    /// last.
    coordinates: [Vec<f32>; 3],
    /// Where their normals at the end of the step lie.
    sectors: Vec<Sectors>,
    nearness: Nearness,
    mean_motion: Vec3,
    spread: f32,
}

/// Place of a surfel that is far from the cloth.
const NO_PLACE: u32 = u32::MAX;

/// A surfel near the cloth.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Unsorted {
    surfel: u32,
    cell: u32,
    /// Where it is in the middle of the step [m].
    middle: Vec3,
}

/// The nearest surfel so far.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Best {
    /// Its squared distance, or that within which one is looked for [m²].
    squared: f32,
    /// Among the entries; `None` where there is none yet.
    place: Option<usize>,
}

impl SurfelCells {
    /// Memory that it holds [byte].
    pub(crate) const fn byte_count(&self) -> usize {
        size_of_val(self.starts.as_slice())
            + size_of_val(self.entries.as_slice())
            + size_of_val(self.unsorted.as_slice())
            + size_of_val(self.places.as_slice())
            + 3 * size_of_val(self.coordinates[0].as_slice())
            + size_of_val(self.sectors.as_slice())
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
        let [low, high] = self.choose(skin, [low - reach, high + reach]);
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
        let mut unsorted = std::mem::take(&mut self.unsorted);
        for one in &mut unsorted {
            let cell = self.cell_index(one.middle);
            one.cell = narrow(cell);
            self.starts[cell + 1] += 1;
        }
        let mut sum = 0;
        for start in &mut self.starts {
            sum += *start;
            *start = sum;
        }
        self.entries.clear();
        self.entries.resize(unsorted.len(), 0);
        self.places.clear();
        self.places.resize(skin.after.len(), NO_PLACE);
        for column in &mut self.coordinates {
            column.clear();
            column.resize(unsorted.len() + LANES, f32::INFINITY);
        }
        // Backwards: the start of the next cell is counted down to the start of this one.
        for one in unsorted.iter().rev() {
            let end = &mut self.starts[one.cell as usize + 1];
            *end -= 1;
            let place = *end;
            self.places[one.surfel as usize] = place;
            let place = place as usize;
            self.entries[place] = one.surfel;
            for (axis, column) in self.coordinates.iter_mut().enumerate() {
                column[place] = one.middle[axis];
            }
        }
        self.unsorted = unsorted;
        self.starts.remove(0);
        self.starts.push(narrow(self.unsorted.len()));
        self.nearness.set(self.counts, &self.starts);
        self.sectors.clear();
        let normals = self
            .entries
            .iter()
            .map(|&surfel| skin.after[surfel as usize].normal);
        self.sectors.extend(normals.map(Sectors::of));
    }

    /// Takes those in the box, and how they move; the box around them in the middle of the step.
    fn choose(&mut self, skin: Skin<'_>, [low, high]: [Vec3; 2]) -> [Vec3; 2] {
        self.unsorted.clear();
        let mut sum = Vec3::ZERO;
        let mut around = [Vec3::INFINITY, Vec3::NEG_INFINITY];
        for ((surfel, before), after) in (0u32..).zip(skin.before).zip(skin.after) {
            if before.is_withdrawn() || after.is_withdrawn() {
                continue;
            }
            let middle = (before.position + after.position) * 0.5;
            if middle.cmpge(low).all() && middle.cmple(high).all() {
                self.unsorted.push(Unsorted {
                    surfel,
                    cell: 0,
                    middle,
                });
                sum += after.position - before.position;
                around = [around[0].min(middle), around[1].max(middle)];
            }
        }
        #[expect(clippy::cast_precision_loss, reason = "surfels are fewer than 2^24")]
        let count = self.unsorted.len().max(1) as f32;
        self.mean_motion = sum / count;
        let spread = self.unsorted.iter().map(|one| {
            let index = one.surfel as usize;
            let motion = skin.after[index].position - skin.before[index].position;
            (motion - self.mean_motion).length_squared()
        });
        self.spread = spread.fold(0.0, f32::max).sqrt();
        around
    }

    /// Rounded down by cutting off, which is quick, and is the same from where it is positive on.
    fn cell_of(&self, point: Vec3) -> IVec3 {
        let far = Vec3::splat(FAR);
        let cell = (point - self.low) * (1.0 / CELL);
        (cell.clamp(-far, far) + far).as_ivec3() - FAR_CELL
    }

    /// Index of the cell in which a surfel lies.
    fn cell_index(&self, middle: Vec3) -> usize {
        self.index(self.cell_of(middle).min(self.counts - IVec3::ONE))
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
    /// the first. `hint` may be it: a near one saves work and changes nothing.
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
        let mut best = self.begin(point, reach, hint);
        self.for_each_run(point, best.squared.sqrt(), |run| {
            best = self.nearest_of(simd, run, point, best);
        });
        best.place
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
        let normal = surfels[self.surfel(place)].normal;
        if !self
            .sectors_around(point, facings)
            .may_face(normal, FACING_AGAINST)
        {
            return None;
        }
        let faces_against =
            |other: usize| surfels[self.surfel(other)].normal.dot(normal) < FACING_AGAINST;
        let hint = hint.filter(|&hint| faces_against(hint));
        let mut best = self.nearer(point, PINCH_REACH, [hint, None]);
        let mut least = best.map_or(PINCH_REACH * PINCH_REACH, |place| {
            point.distance_squared(self.position(place))
        });
        self.for_each_run(point, least.sqrt(), |run| {
            for place in run {
                let squared = point.distance_squared(self.position(place));
                let ties = squared <= least && best.is_some_and(|other| place < other);
                if (squared < least || ties) && faces_against(place) {
                    (least, best) = (squared, Some(place));
                }
            }
        });
        best
    }

    /// How the surfels face that lie within [`PINCH_REACH`] of any point in the block of `point`, and
    /// some farther away.
    fn sectors_around(&self, point: Vec3, facings: &mut Facings) -> Sectors {
        let cell = self.cell_of(point);
        if cell.cmplt(IVec3::ZERO).any() || cell.cmpge(self.counts).any() {
            return Sectors::default();
        }
        let (block, counts) = (cell / BLOCK, self.counts / BLOCK + 1);
        let index = (block.z * counts.y + block.y) * counts.x + block.x;
        let index = usize::try_from(index).unwrap_or(0);
        if facings.0.is_empty() {
            let count = usize::try_from(counts.element_product()).unwrap_or(0);
            facings.0.resize(count, Sectors::default());
        }
        // What is asked for lies beside a surfel, so that no block is empty.
        let known = &mut facings.0[index];
        if *known == Sectors::default() {
            let first = block * BLOCK;
            self.for_each_run_of(first - 1, first + BLOCK, |run| {
                let own = self.sectors[run].iter().copied();
                *known = own.fold(*known, Sectors::and);
            });
        }
        *known
    }

    /// What a particle at `point` knows before it looks around.
    fn begin(&self, point: Vec3, reach: f32, hint: Option<usize>) -> Best {
        let place = self.nearer(point, reach, [hint, None]);
        let squared = place.map_or(reach * reach, |place| {
            point.distance_squared(self.position(place))
        });
        Best { squared, place }
    }

    /// The part of a box of cells that there is.
    fn within(&self, [low, high]: [IVec3; 2]) -> [IVec3; 2] {
        [low.max(IVec3::ZERO), high.min(self.counts - IVec3::ONE)]
    }

    /// Calls with the places of all surfels in the cells within `radius` [m] of `point`, and of more.
    #[inline(always)]
    fn for_each_run(&self, point: Vec3, radius: f32, visit: impl FnMut(Range<usize>)) {
        self.for_each_run_of(
            self.cell_of(point - radius),
            self.cell_of(point + radius),
            visit,
        );
    }

    /// Calls with the places of all surfels in the cells from one corner of a box to the other.
    #[inline(always)]
    fn for_each_run_of(&self, low: IVec3, high: IVec3, mut visit: impl FnMut(Range<usize>)) {
        let [low, high] = self.within([low, high]);
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

    /// The nearest to `point` of some places and the best so far; of equals the first.
    #[inline(always)]
    fn nearest_of<S: Simd>(
        &self,
        simd: S,
        places: Range<usize>,
        point: Vec3,
        mut best: Best,
    ) -> Best {
        let [x, y, z] = &self.coordinates;
        let own = Vectors::splat(simd, point);
        for from in places.clone().step_by(LANES) {
            let lanes = from..from + LANES;
            let offset = own.sub(Vectors {
                x: f32x16::from_slice(simd, &x[lanes.clone()]),
                y: f32x16::from_slice(simd, &y[lanes.clone()]),
                z: f32x16::from_slice(simd, &z[lanes]),
            });
            let near = offset
                .dot(offset)
                .simd_le(f32x16::splat(simd, best.squared));
            for lane in each_hit(near.to_bitmask(), places.end - from) {
                let place = from + lane;
                let squared = point.distance_squared(self.position(place));
                let ties = squared <= best.squared && best.place.is_some_and(|other| place < other);
                if squared < best.squared || ties {
                    best = Best {
                        squared,
                        place: Some(place),
                    };
                }
            }
        }
        best
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
            let squared = point.distance_squared(self.position(place));
            if squared < least {
                (least, best) = (squared, Some(place));
            }
        }
        best
    }

    /// Where the surfel at a place is in the middle of the step [m].
    pub(crate) fn position(&self, place: usize) -> Vec3 {
        let [x, y, z] = &self.coordinates;
        Vec3::new(x[place], y[place], z[place])
    }

    /// The place of a surfel among the entries; `None` of what is far from the cloth.
    pub(crate) fn place_of(&self, surfel: u32) -> Option<usize> {
        let place = self.places.get(surfel as usize).copied();
        Some(place.filter(|&place| place != NO_PLACE)? as usize)
    }

    /// Which surfel is at a place among the entries.
    pub(crate) fn surfel(&self, place: usize) -> usize {
        self.entries[place] as usize
    }
}
