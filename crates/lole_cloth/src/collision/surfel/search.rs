//! Which surfels the particles may touch: rows of them, shared among threads.

use std::num::NonZeroU32;
use std::ops::Range;

use fearless_simd::{Level, Simd, dispatch};
use rayon::prelude::*;

use super::cells::{Facings, Seeker, SurfelCells};
use super::{CLOSE, Cloth, Encounter, PINCH_REACH};
use crate::lanes::{LANES, narrow};

/// Parts into which the rows are cut where several threads share them.
const PART_COUNT: usize = 8;

/// A place among the sorted surfels, counted from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Place(Option<NonZeroU32>);

impl Place {
    fn new(place: Option<usize>) -> Self {
        Self(place.and_then(|place| NonZeroU32::new(narrow(place + 1))))
    }

    fn get(self) -> Option<usize> {
        self.0.map(|place| place.get() as usize - 1)
    }
}

/// The surfels that a particle may touch: the nearest, and the nearest that faces against it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Near {
    nearest: Place,
    opposite: Place,
}

/// Rows that one thread looks at.
#[derive(Debug, Clone, Default, PartialEq)]
struct Part {
    rows: Range<usize>,
    /// In the order of the rows.
    near: Vec<Near>,
    /// In the same order, the surfel that was the nearest in the search before, counted from 1, or 0.
    last: Vec<u32>,
    facings: Facings,
    slots: Vec<(usize, usize)>,
    seekers: Vec<Seeker>,
}

/// The surfels near all particles.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct SurfelSearch {
    parts: Vec<Part>,
}

impl SurfelSearch {
    /// Memory that it holds [byte].
    pub(super) fn byte_count(&self) -> usize {
        let parts = self.parts.iter();
        let sizes = parts.map(|part| {
            size_of_val(&part.near[..]) + size_of_val(&part.last[..]) + part.facings.byte_count()
        });
        sizes.sum()
    }

    /// Looks for the surfels near every particle: the same for any number of threads.
    pub(super) fn find(&mut self, level: Level, cells: &SurfelCells, encounter: Encounter<'_>) {
        let row_count = encounter.cloth.layout.row_count();
        let is_alone = rayon::current_num_threads() == 1;
        let count = if is_alone { 1 } else { PART_COUNT };
        self.parts.resize_with(count, Part::default);
        for (index, part) in self.parts.iter_mut().enumerate() {
            part.rows = row_count * index / count..row_count * (index + 1) / count;
        }
        let find = |part: &mut Part| {
            dispatch!(level, simd => part.find(simd, cells, encounter));
        };
        if is_alone {
            self.parts.iter_mut().for_each(find);
        } else {
            self.parts.par_iter_mut().for_each(find);
        }
    }

    /// Calls with vector and lane of every particle that may touch the skin, its row, and the places
    /// of its surfels.
    pub(super) fn each(
        &mut self,
        cloth: Cloth<'_>,
        mut visit: impl FnMut((usize, usize), usize, usize, Option<usize>),
    ) {
        for part in &mut self.parts {
            let mut near = part.near.iter();
            for row in part.rows.clone() {
                part.slots.clear();
                cloth.layout.add_row_slots(row, &mut part.slots);
                let touching = part.slots.iter().zip(near.by_ref());
                let touching = touching
                    .filter_map(|(&slot, near)| Some((slot, near.nearest.get()?, near.opposite)));
                touching.for_each(|(slot, nearest, opposite)| {
                    visit(slot, row, nearest, opposite.get());
                });
            }
        }
    }
}

impl Part {
    #[inline(always)]
    fn find<S: Simd>(&mut self, simd: S, cells: &SurfelCells, encounter: Encounter<'_>) {
        self.near.clear();
        self.facings.clear();
        for row in self.rows.clone() {
            self.slots.clear();
            encounter.cloth.layout.add_row_slots(row, &mut self.slots);
            let start = self.near.len();
            self.near.resize(start + self.slots.len(), Near::default());
            self.find_nearest(simd, start, cells, encounter);
            self.find_opposite(start, cells, encounter);
        }
        self.last.clear();
        let surfel = |near: &Near| {
            let place = near.nearest.get();
            place.map_or(0, |place| narrow(cells.surfel(place) + 1))
        };
        self.last.extend(self.near.iter().map(surfel));
    }

    /// Searches for every particle of a row, or, where they lie close together, for every second one:
    /// the others take the nearer one of their neighbors' surfels.
    #[inline(always)]
    fn find_nearest<S: Simd>(
        &mut self,
        simd: S,
        start: usize,
        cells: &SurfelCells,
        encounter: Encounter<'_>,
    ) {
        let is_dense = encounter.cloth.spacing < CLOSE;
        let row = &mut self.near[start..];
        let step = if is_dense { 2 } else { 1 };
        // Its own surfel of the search before is near, if not the nearest, and so is a neighbor's.
        let mut hint = None;
        let mut seekers = std::mem::take(&mut self.seekers);
        for first in (0..row.len()).step_by(step * LANES) {
            let asked = (first..row.len()).step_by(step).take(LANES);
            seekers.clear();
            seekers.extend(asked.map(|index| {
                let (point, reach) = encounter.flight(self.slots[index], cells);
                let last = self.last.get(start + index);
                let last = last.and_then(|it| it.checked_sub(1));
                let last = last.and_then(|surfel| cells.place_of(surfel));
                Seeker {
                    point,
                    reach,
                    hint: last.or(hint),
                }
            }));
            cells.nearest_of_each(simd, &seekers, |lane, place| {
                row[first + step * lane].nearest = Place::new(place);
                hint = place.or(hint);
            });
        }
        self.seekers = seekers;
        if !is_dense {
            return;
        }
        for left in (0..row.len().saturating_sub(1)).step_by(2) {
            let right = (left + 2) % row.len();
            let candidates = [row[left].nearest.get(), row[right].nearest.get()];
            let (middle, reach) = encounter.flight(self.slots[left + 1], cells);
            row[left + 1].nearest = Place::new(cells.nearer(middle, reach, candidates));
        }
    }

    /// Searches for those of the row that have a surfel near enough.
    fn find_opposite(&mut self, start: usize, cells: &SurfelCells, encounter: Encounter<'_>) {
        let mut hint = None;
        for (&slot, near) in self.slots.iter().zip(&mut self.near[start..]) {
            let Some(place) = near.nearest.get() else {
                continue;
            };
            let (middle, _) = encounter.flight(slot, cells);
            if PINCH_REACH < middle.distance(cells.position(place)) {
                continue;
            }
            hint = cells.opposite(
                middle,
                (place, hint),
                encounter.skin.after,
                &mut self.facings,
            );
            near.opposite = Place::new(hint);
        }
    }
}
