//! Contact of the cloth with itself.
//!
//! Every particle carries a sphere drawn out along its column to half-way to the next row: in a
//! gathered skirt rows lie farther apart than columns, and spheres alone would let one fold slip
//! between two rows of another. Candidates are found with the side on which they lie, so that what
//! has gone through within the step is pushed back to where it came from.
//!
//! Particles are sorted by cells into slabs. A pair reaches from its slab into the next at most:
//! every other slab can be solved at the same time, and the order never depends on threads.

use std::ops::Range;

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::Vec3;
use rayon::prelude::*;

use crate::collision::grid::{CellGrid, Entry, each_hit};
use crate::collision::parting::{DEGENERATE_SQUARED, Touching};
use crate::collision::pinned_rows::PinnedRows;
use crate::lanes::{LANES, Layout, Points, Scalars, Vectors, narrow, smaller};
use crate::{Grid, Topology};

/// How far beyond touching candidates are kept [diameters]: folds move together, so what one
/// gains on another in a step is far less than its speed.
const MARGIN: f32 = 0.6;

/// Columns and rows within which particles are held apart by their springs alone; of fine rows as many as flat
/// cloth has within reach: it would push itself apart.
const NEIGHBOR_COLUMNS: f32 = 1.0;
const NEIGHBOR_ROWS: f32 = 2.0;

/// Where pins hold strands nearer together than a diameter, contact keeps this share of their gap,
/// and what lies this much farther apart for every meter of cloth from the pins.
const PINNED_SHARE: f32 = 0.9;
const PINNED_OPENING: f32 = 0.06;

/// Slabs at most. They do not depend on threads, so that the order of pairs does not either.
const SLAB_COUNT_MAX: usize = 16;

/// Below this many pairs a solution, 27 ns a pair, is over before a second thread gains anything on it.
const PARALLEL_PAIRS_MIN: usize = 1 << 12;

/// A pair that may touch, by entries of the cell grid.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Pair {
    first: u32,
    second: u32,
    /// Kept between the first and the thread of the second [m].
    diameter: f32,
    /// Unit vector from the first to the thread of the second when the pair was found.
    side: Vec3,
}

/// A particle as the pair loop wants it: near its neighbors in memory.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Strand {
    position: Vec3,
    inv_mass: f32,
    /// Unit vector along the column; zero where it has no direction.
    thread: Vec3,
    /// Its place among those that are in a pair; [`UNPAIRED`] of others.
    touch: u32,
}

/// Place of what is in no pair.
const UNPAIRED: u32 = u32::MAX;

/// What else is known of a particle in a pair.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Touch {
    /// Whether this solution has moved it; the rest is known from then on.
    is_touched: bool,
    /// Where it was at the start of the substep [m].
    before: Vec3,
    /// What contacts moved it without a push [m].
    quiet: Vec3,
}

/// Vector and lane of a particle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Slot(u32);

impl Slot {
    fn new(vector: usize, lane: usize) -> Self {
        Self(narrow(vector * LANES + lane))
    }

    #[inline(always)]
    const fn get(self) -> (usize, usize) {
        let place = self.0 as usize;
        (place / LANES, place % LANES)
    }
}

/// Candidates and room to solve them.
#[derive(Debug, Clone, Default)]
pub(crate) struct ClothContacts {
    grid: CellGrid,
    positions: Vec<Vec3>,
    /// First entry of every slab, and one more.
    slabs: Vec<usize>,
    /// Pairs whose first entry lies in a slab, slab by slab.
    pairs: Vec<Vec<Pair>>,
    /// In the order of the entries.
    strands: Vec<Strand>,
    /// Entries that are in a pair, ascending.
    paired: Vec<u32>,
    /// In their order.
    touches: Vec<Touch>,
    /// Vector and lane of every entry.
    slots: Vec<Slot>,
    /// Column and row of every entry, and a vector beyond the last.
    places: [Vec<f32>; 2],
}

/// Particles in the engine's layout, as a substep has them.
pub(crate) struct Columns<'a> {
    pub(crate) positions: &'a mut [Points],
    pub(crate) predicted: &'a mut [Points],
    pub(crate) velocities: &'a [Points],
}

/// Distances of one contact law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ClothContactLaw {
    /// Kept between particles and threads [m].
    diameter: f32,
    /// Half of the part of a column that a particle stands for [m].
    half_thread: f32,
    /// Coulomb friction coefficient of cloth on cloth.
    friction: f32,
    /// Duration of a substep [s].
    h: f32,
}

impl ClothContactLaw {
    /// Spheres of `radius` that never reach farther than the cloth's own columns.
    pub(crate) fn new(grid: &Grid, radius: f32, friction: f32, h: f32) -> Self {
        let diameter = (2.0 * radius).min(grid.spacing[0]);
        Self {
            diameter,
            half_thread: (0.5 * grid.spacing[1]).max(diameter) - 0.5 * diameter,
            friction,
            h,
        }
    }
}

/// What never changes of the cloth.
#[derive(Clone, Copy)]
pub(crate) struct Shape<'a> {
    pub(crate) grid: &'a Grid,
    pub(crate) layout: &'a Layout,
    pub(crate) pinned_rows: &'a PinnedRows,
    pub(crate) inv_masses: &'a [Scalars],
    /// Particles where the cloth has gone through itself, row-major: they do not know on which side
    /// they belong, and do not touch each other. Empty where there are none.
    pub(crate) is_tangled: &'a [bool],
}

impl ClothContacts {
    pub(crate) fn start_positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// Memory that it holds [byte].
    pub(crate) fn byte_count(&self) -> usize {
        let pairs: usize = self.pairs.iter().map(Vec::capacity).sum();
        self.grid.byte_count()
            + size_of_val(&self.positions[..])
            + size_of_val(&self.strands[..])
            + size_of_val(&self.touches[..])
            + size_of_val(&self.paired[..])
            + size_of_val(&self.slots[..])
            + 2 * size_of_val(&self.places[0][..])
            + pairs * size_of::<Pair>()
    }

    /// Finds the candidates of a step. Where the cloth has blown up there are none.
    #[inline(always)]
    pub(crate) fn find<S: Simd>(
        &mut self,
        simd: S,
        shape: Shape<'_>,
        positions: &[Points],
        law: ClothContactLaw,
    ) {
        shape.layout.gather_points(positions, &mut self.positions);
        if !self.positions.iter().all(|position| position.is_finite()) {
            self.pairs.clear();
            self.slabs.clear();
            return;
        }
        let across = law.diameter * (1.0 + MARGIN);
        let reach = (law.half_thread * law.half_thread + across * across).sqrt();
        self.grid.sort(&self.positions, reach);
        self.cut_slabs();
        self.find_strands(shape);
        self.find_places(shape.grid);
        let (slabs, finder) = (
            &self.slabs,
            PairFinder {
                shape,
                law,
                reach_squared: reach * reach,
                across_squared: across * across,
                cells: &self.grid,
                columns_around: match shape.grid.topology {
                    Topology::Sheet => f32::INFINITY,
                    Topology::Tube => shape.grid.column_count as f32,
                },
                rows_beside: (reach / shape.grid.spacing[1]).floor().max(NEIGHBOR_ROWS),
                strands: &self.strands,
                places: &self.places,
                positions: &self.positions,
            },
        );
        let find_slab = |(slab, pairs): (usize, &mut Vec<Pair>)| {
            pairs.clear();
            let range = slabs[slab]..slabs[slab + 1];
            simd.vectorize(
                #[inline(always)]
                || finder.collect(simd, range, pairs),
            );
        };
        if rayon::current_num_threads() == 1 {
            self.pairs.iter_mut().enumerate().for_each(find_slab);
        } else {
            self.pairs.par_iter_mut().enumerate().for_each(find_slab);
        }
        for pairs in &mut self.pairs {
            release_room(pairs);
        }
        self.list_paired();
    }

    fn list_paired(&mut self) {
        for pair in self.pairs.iter().flatten() {
            for entry in [pair.first, pair.second] {
                self.strands[entry as usize].touch = 0;
            }
        }
        self.paired.clear();
        for (entry, strand) in (0u32..).zip(&mut self.strands) {
            if strand.touch != UNPAIRED {
                strand.touch = narrow(self.paired.len());
                self.paired.push(entry);
            }
        }
        self.touches.clear();
        self.touches.resize(self.paired.len(), Touch::default());
    }

    /// Slabs of whole layers of cells, about equally full.
    fn cut_slabs(&mut self) {
        let count = self.grid.entries.len();
        let share = count.div_ceil(SLAB_COUNT_MAX);
        self.slabs.clear();
        self.slabs.push(0);
        for start in self.grid.layer_starts() {
            let last = self.slabs[self.slabs.len() - 1];
            if share <= start - last {
                self.slabs.push(start);
            }
        }
        if self.slabs[self.slabs.len() - 1] < count {
            self.slabs.push(count);
        }
        self.pairs.resize_with(self.slabs.len() - 1, Vec::new);
    }

    fn find_strands(&mut self, shape: Shape<'_>) {
        let columns = shape.grid.column_count as usize;
        self.strands.clear();
        self.slots.clear();
        for entry in &self.grid.entries {
            let particle = entry.particle as usize;
            let (vector, lane) = shape.layout.slot(particle);
            self.slots.push(Slot::new(vector, lane));
            self.strands.push(Strand {
                position: self.positions[particle],
                inv_mass: shape.inv_masses[vector].0[lane],
                thread: thread(columns, &self.positions, particle),
                touch: UNPAIRED,
            });
        }
    }

    fn find_places(&mut self, grid: &Grid) {
        let [columns, rows] = &mut self.places;
        columns.clear();
        rows.clear();
        for entry in &self.grid.entries {
            let [row, column] = place_of(grid, entry);
            columns.push(column as f32);
            rows.push(row as f32);
        }
        for places in [columns, rows] {
            places.resize(self.grid.entries.len() + LANES, 0.0);
        }
    }

    /// Moves apart what is nearer than the law allows. What undoes an approach in this substep
    /// becomes velocity; the rest moves `predicted` too, so that overlapping folds part without a
    /// push and nothing bounces.
    pub(crate) fn solve(&mut self, mut columns: Columns<'_>, law: ClothContactLaw) {
        if self.pairs.is_empty() {
            return;
        }
        for (&entry, touch) in self.paired.iter().zip(&mut self.touches) {
            let (vector, lane) = self.slots[entry as usize].get();
            self.strands[entry as usize].position = columns.positions[vector].get(lane);
            touch.is_touched = false;
        }
        for parity in [0, 1] {
            self.solve_slabs(parity, &columns, law);
        }
        self.store(&mut columns);
    }

    /// Solves every other slab, from `parity` on.
    fn solve_slabs(&mut self, parity: usize, columns: &Columns<'_>, law: ClothContactLaw) {
        let mut tasks = Vec::with_capacity(self.pairs.len().div_ceil(2));
        let (mut strands, mut touches) = (&mut self.strands[..], &mut self.touches[..]);
        let (mut start, mut touch_start) = (0, 0);
        let paired = &self.paired;
        let touches_before = |entry: usize| paired.partition_point(|&it| (it as usize) < entry);
        for slab in (parity..self.pairs.len()).step_by(2) {
            let [first, end] = [slab, slab + 2].map(|s| self.slabs[s.min(self.slabs.len() - 1)]);
            let (strand_part, strands_after) = strands.split_at_mut(end - start);
            let [first_touch, touch_end] = [first, end].map(touches_before);
            let (touch_part, touches_after) = touches.split_at_mut(touch_end - touch_start);
            let slab_part = Slab {
                strands: &mut strand_part[first - start..],
                touches: &mut touch_part[first_touch - touch_start..],
                slots: &self.slots[first..end],
                first,
                first_touch,
            };
            tasks.push((slab_part, &self.pairs[slab][..]));
            (strands, touches) = (strands_after, touches_after);
            (start, touch_start) = (end, touch_end);
        }
        let solve = |(mut slab, pairs): (Slab<'_>, &[Pair])| {
            for pair in pairs {
                slab.solve_pair(pair, columns, law);
            }
        };
        let count: usize = self.pairs.iter().map(Vec::len).sum();
        if rayon::current_num_threads() == 1 || count < PARALLEL_PAIRS_MIN {
            tasks.into_iter().for_each(solve);
        } else {
            tasks.into_par_iter().for_each(solve);
        }
    }

    fn store(&self, columns: &mut Columns<'_>) {
        let touched = self.paired.iter().zip(&self.touches);
        for (&entry, touch) in touched.filter(|(_, touch)| touch.is_touched) {
            let (vector, lane) = self.slots[entry as usize].get();
            columns.positions[vector].set(lane, self.strands[entry as usize].position);
            let start = columns.predicted[vector].get(lane);
            columns.predicted[vector].set(lane, start + touch.quiet);
        }
    }
}

/// Unit vector along the column of a particle.
fn thread(columns: usize, positions: &[Vec3], particle: usize) -> Vec3 {
    let above = particle.checked_sub(columns).unwrap_or(particle);
    let below = particle + columns;
    let below = if below < positions.len() {
        below
    } else {
        particle
    };
    (positions[below] - positions[above]).normalize_or_zero()
}

/// What a search for pairs looks at.
struct PairFinder<'a> {
    shape: Shape<'a>,
    law: ClothContactLaw,
    reach_squared: f32,
    across_squared: f32,
    cells: &'a CellGrid,
    /// Columns around a tube; infinite of a sheet.
    columns_around: f32,
    /// Rows within which particles of columns beside one another are neighbors.
    rows_beside: f32,
    strands: &'a [Strand],
    /// Column and row of every entry.
    places: &'a [Vec<f32>; 2],
    /// Row-major.
    positions: &'a [Vec3],
}

/// Adds a pair to room that grows by less than a vector does by itself: pairs are most of the memory.
#[inline(always)]
fn push_sparingly(pairs: &mut Vec<Pair>, pair: Option<Pair>) {
    let Some(pair) = pair else {
        return;
    };
    if pairs.len() == pairs.capacity() {
        pairs.reserve_exact((pairs.len() / 8).max(64));
    }
    pairs.push(pair);
}

/// Gives back room that more pairs once took.
fn release_room(pairs: &mut Vec<Pair>) {
    if pairs.len() + pairs.len() / 2 < pairs.capacity() {
        pairs.shrink_to(pairs.len() + pairs.len() / 4);
    }
}

impl PairFinder<'_> {
    /// Adds the pairs of the entries of a range with those that follow them.
    #[inline(always)]
    fn collect<S: Simd>(&self, simd: S, range: Range<usize>, pairs: &mut Vec<Pair>) {
        let entries = &self.cells.entries[range.clone()];
        let mut start = range.start;
        for own in entries.chunk_by(|one, next| one.cell == next.cell) {
            let end = start + own.len();
            let [mut rest, below @ ..] = self.cells.following_runs(own[0].cell);
            for index in start..end {
                rest.start = index + 1;
                self.collect_run(simd, index, rest.clone(), pairs);
                for run in &below {
                    self.collect_run(simd, index, run.clone(), pairs);
                }
            }
            start = end;
        }
    }

    /// Adds the pairs of an entry with those of a run.
    #[inline(always)]
    fn collect_run<S: Simd>(
        &self,
        simd: S,
        index: usize,
        run: Range<usize>,
        pairs: &mut Vec<Pair>,
    ) {
        let [x, y, z] = &self.cells.coordinates;
        let position = Vectors::splat(simd, self.cells.position(index));
        let reach = f32x16::splat(simd, self.reach_squared);
        for from in run.clone().step_by(LANES) {
            let lanes = from..from + LANES;
            let offset = Vectors {
                x: f32x16::from_slice(simd, &x[lanes.clone()]),
                y: f32x16::from_slice(simd, &y[lanes.clone()]),
                z: f32x16::from_slice(simd, &z[lanes.clone()]),
            }
            .sub(position);
            let near = offset.dot(offset).simd_lt(reach).to_bitmask();
            let hits = near & !self.neighbors(simd, index, lanes);
            for place in each_hit(hits, run.end - from) {
                push_sparingly(pairs, self.distant_pair([index, from + place]));
            }
        }
    }

    /// Which of sixteen entries are neighbors of one in the cloth, by bits.
    #[inline(always)]
    fn neighbors<S: Simd>(&self, simd: S, index: usize, lanes: Range<usize>) -> u64 {
        let [columns, rows] = self.places;
        let apart = |places: &[f32]| {
            let own = f32x16::splat(simd, places[index]);
            (f32x16::from_slice(simd, &places[lanes.clone()]) - own).abs()
        };
        let across = apart(columns);
        let around = f32x16::splat(simd, self.columns_around) - across;
        let is_beside = smaller(across, around).simd_le(f32x16::splat(simd, NEIGHBOR_COLUMNS));
        let is_along = apart(rows).simd_le(f32x16::splat(simd, self.rows_beside));
        is_beside.to_bitmask() & is_along.to_bitmask()
    }

    #[inline(never)]
    fn distant_pair(&self, [first, second]: [usize; 2]) -> Option<Pair> {
        if !self.shape.is_tangled.is_empty()
            && [first, second]
                .into_iter()
                .all(|entry| self.shape.is_tangled[self.cells.entries[entry].particle as usize])
        {
            return None;
        }
        let (one, other) = (&self.strands[first], &self.strands[second]);
        if one.inv_mass + other.inv_mass <= 0.0 {
            return None;
        }
        let gap = gap(one, other, self.law.half_thread);
        let squared = gap.length_squared();
        if self.across_squared < squared || squared < DEGENERATE_SQUARED {
            return None;
        }
        let places =
            [first, second].map(|index| place_of(self.shape.grid, &self.cells.entries[index]));
        let pinned_gap = self
            .shape
            .pinned_rows
            .gap(self.shape.grid, self.positions, places);
        let diameter = pinned_gap.map_or(self.law.diameter, |(gap, cloth)| {
            (PINNED_SHARE * gap + PINNED_OPENING * cloth).min(self.law.diameter)
        });
        Some(Pair {
            first: narrow(first),
            second: narrow(second),
            diameter,
            side: gap / squared.sqrt(),
        })
    }
}

/// Row and column of an entry.
#[inline(always)]
fn place_of(grid: &Grid, entry: &Entry) -> [u32; 2] {
    [
        entry.particle / grid.column_count,
        entry.particle % grid.column_count,
    ]
}

/// From `one` to the nearest point of the part of a column that `other` stands for.
#[inline(always)]
fn gap(one: &Strand, other: &Strand, half_thread: f32) -> Vec3 {
    let offset = other.position - one.position;
    let foot = offset.dot(other.thread).max(-half_thread).min(half_thread);
    offset - other.thread * foot
}

/// Entries of a slab and the next, while they are being solved.
struct Slab<'a> {
    strands: &'a mut [Strand],
    touches: &'a mut [Touch],
    /// Vector and lane of each.
    slots: &'a [Slot],
    /// The first entry, and the first in a pair.
    first: usize,
    first_touch: usize,
}

impl Slab<'_> {
    /// Where both of a pair are among the entries.
    #[inline(always)]
    fn ends(&self, pair: &Pair) -> [usize; 2] {
        [pair.first, pair.second].map(|entry| entry as usize - self.first)
    }

    #[inline(always)]
    fn solve_pair(&mut self, pair: &Pair, columns: &Columns<'_>, law: ClothContactLaw) {
        let ends = self.ends(pair);
        let (one, other) = (&self.strands[ends[0]], &self.strands[ends[1]]);
        let gap = gap(one, other, law.half_thread);
        let squared = gap.length_squared();
        if squared < pair.diameter * pair.diameter {
            self.part(pair, gap, columns, law);
        }
    }

    /// Parts a pair that is nearer than its diameter, `gap` apart.
    fn part(&mut self, pair: &Pair, gap: Vec3, columns: &Columns<'_>, law: ClothContactLaw) {
        let ends = self.ends(pair);
        let touches = ends.map(|end| self.touch(end, columns, law.h));
        let travel =
            [0, 1].map(|end| self.strands[ends[end]].position - self.touches[touches[end]].before);
        let slip = travel[1] - travel[0];
        let touching = Touching {
            gap,
            slip,
            side: pair.side,
            diameter: pair.diameter,
        };
        let Some(parting) = touching.part(law.friction, law.h) else {
            return;
        };
        let inv_masses = ends.map(|end| self.strands[end].inv_mass);
        let inv_mass_sum = inv_masses[0] + inv_masses[1];
        let change = parting.change / inv_mass_sum;
        let quiet = parting.normal * (parting.quiet / inv_mass_sum);
        self.strands[ends[0]].position -= change * inv_masses[0];
        self.touches[touches[0]].quiet -= quiet * inv_masses[0];
        self.strands[ends[1]].position += change * inv_masses[1];
        self.touches[touches[1]].quiet += quiet * inv_masses[1];
    }

    /// Fetches what only touched particles need; where it is.
    #[inline(always)]
    fn touch(&mut self, end: usize, columns: &Columns<'_>, h: f32) -> usize {
        let place = self.strands[end].touch as usize - self.first_touch;
        let touch = &mut self.touches[place];
        if !touch.is_touched {
            let (vector, lane) = self.slots[end].get();
            let flown = columns.velocities[vector].get(lane) * h;
            *touch = Touch {
                is_touched: true,
                before: columns.predicted[vector].get(lane) - flown,
                quiet: Vec3::ZERO,
            };
        }
        place
    }
}
