//! Particles sorted into cubic cells, so that neighbors lie close together in memory.

use std::ops::Range;

use glam::Vec3;

use crate::lanes::LANES;

/// Cells at most; a cloth spread wider gets larger cells, which costs time and loses nothing.
const CELL_COUNT_MAX: f32 = 2_000_000.0;

/// A particle in the order of the cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Entry {
    /// Row-major index.
    pub(crate) particle: u32,
    pub(crate) cell: u32,
}

/// Particles sorted by cell, cells along x first.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct CellGrid {
    /// Cells along each axis, an empty one on every side included.
    dimensions: [u32; 3],
    /// Corner of the first cell that is not on the outside [m].
    origin: Vec3,
    /// Cells per meter.
    inv_size: f32,
    /// First entry of every cell, and one more.
    starts: Vec<u32>,
    pub(crate) entries: Vec<Entry>,
    /// Their positions by axis [m], and a vector beyond the last.
    pub(crate) coordinates: [Vec<f32>; 3],
}

impl CellGrid {
    /// Memory that it holds [byte].
    pub(crate) const fn byte_count(&self) -> usize {
        size_of_val(self.starts.as_slice())
            + size_of_val(self.entries.as_slice())
            + 3 * size_of_val(self.coordinates[0].as_slice())
    }

    /// Where the particle of an entry is [m].
    #[inline(always)]
    pub(crate) fn position(&self, entry: usize) -> Vec3 {
        let [x, y, z] = &self.coordinates;
        Vec3::new(x[entry], y[entry], z[entry])
    }

    /// Sorts `positions`, all finite, into cells of at least `cell_size` [m].
    pub(crate) fn sort(&mut self, positions: &[Vec3], cell_size: f32) {
        let low = positions.iter().copied().fold(Vec3::INFINITY, Vec3::min);
        let high = positions
            .iter()
            .copied()
            .fold(Vec3::NEG_INFINITY, Vec3::max);
        let extent = (high - low).max(Vec3::ZERO);
        let mut size = cell_size;
        let cell_count = |size: f32| {
            let cells = (extent / size).floor() + Vec3::splat(3.0);
            cells.x * cells.y * cells.z
        };
        while CELL_COUNT_MAX < cell_count(size) {
            size *= 1.25;
        }
        let inv_size = 1.0 / size;
        (self.origin, self.inv_size) = (low, inv_size);
        let cell_of = |position: Vec3| {
            let cell = (position - low) * inv_size;
            [cell.x, cell.y, cell.z].map(truncate)
        };
        self.dimensions = cell_of(high).map(|last| last + 3);
        let [width, height, depth] = self.dimensions;
        self.starts.clear();
        self.starts.resize((width * height * depth) as usize + 1, 0);
        let cell_of = |position: Vec3| {
            let [x, y, z] = cell_of(position);
            ((z + 1) * height + y + 1) * width + x + 1
        };
        for &position in positions {
            self.starts[cell_of(position) as usize + 1] += 1;
        }
        let mut sum = 0;
        for start in &mut self.starts {
            sum += *start;
            *start = sum;
        }
        self.fill(positions, cell_of);
    }

    /// Backwards, so that every start ends where its cell begins and equal cells keep their order.
    #[inline(always)]
    fn fill(&mut self, positions: &[Vec3], cell_of: impl Fn(Vec3) -> u32) {
        let blank = Entry {
            particle: 0,
            cell: 0,
        };
        self.entries.clear();
        self.entries.resize(positions.len(), blank);
        for column in &mut self.coordinates {
            column.clear();
            column.resize(positions.len() + LANES, f32::INFINITY);
        }
        // starts[c + 1] is the end of cell c; counting it down makes it the start of cell c.
        let count = u32::try_from(positions.len()).unwrap_or(u32::MAX);
        for (particle, &position) in (0..count).zip(positions).rev() {
            let cell = cell_of(position);
            let end = &mut self.starts[cell as usize + 1];
            *end -= 1;
            let place = *end as usize;
            self.entries[place] = Entry { particle, cell };
            for (axis, column) in self.coordinates.iter_mut().enumerate() {
                column[place] = position[axis];
            }
        }
        // Shift back: now starts[c + 1] begins cell c, and the last entry is the end of all.
        self.starts.remove(0);
        self.starts.push(count);
    }

    /// Calls `visit` with every run of entries in the cells that a box touches.
    #[inline(always)]
    pub(crate) fn runs_within(&self, [low, high]: [Vec3; 2], mut visit: impl FnMut(Range<usize>)) {
        let [width, height, depth] = self.dimensions;
        let cell_of = |position: Vec3| {
            let last = Vec3::new(width as f32, height as f32, depth as f32) - Vec3::splat(3.0);
            let cell = ((position - self.origin) * self.inv_size)
                .max(Vec3::ZERO)
                .min(last);
            [cell.x, cell.y, cell.z].map(truncate)
        };
        let (first, last) = (cell_of(low), cell_of(high));
        for z in first[2]..=last[2] {
            for y in first[1]..=last[1] {
                let row = ((z + 1) * height + y + 1) * width + 1;
                let start = self.starts[(row + first[0]) as usize] as usize;
                let end = self.starts[(row + last[0]) as usize + 1] as usize;
                visit(start..end);
            }
        }
    }

    /// First entry of every layer of cells; a neighbor lies in the same layer or the next.
    pub(crate) fn layer_starts(&self) -> impl Iterator<Item = usize> {
        let [width, height, _] = self.dimensions;
        let layer = (width * height) as usize;
        self.starts
            .iter()
            .step_by(layer)
            .map(|&start| start as usize)
    }

    /// The half neighborhood of a cell, five runs of entries: its own and the cell right of it, then
    /// four runs of three cells.
    #[inline(always)]
    pub(crate) fn following_runs(&self, cell: u32) -> [Range<usize>; 5] {
        let [width, height, _] = self.dimensions;
        let layer = width * height;
        let run = |first: u32, end: u32| {
            self.starts[first as usize] as usize..self.starts[end as usize] as usize
        };
        let three = |middle: u32| run(middle - 1, middle + 2);
        [
            run(cell, cell + 2),
            three(cell + width),
            three(cell + layer - width),
            three(cell + layer),
            three(cell + layer + width),
        ]
    }
}

/// Places of the first `count` bits of a word that are set, ascending.
#[inline(always)]
pub(crate) fn each_hit(word: u64, count: usize) -> impl Iterator<Item = usize> {
    let mut hits = if count < LANES {
        word & ((1 << count) - 1)
    } else {
        word
    };
    std::iter::from_fn(
        #[inline(always)]
        move || {
            let place = hits.trailing_zeros() as usize;
            hits &= hits.wrapping_sub(1);
            (place < LANES).then_some(place)
        },
    )
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a cell coordinate lies between 0 and the cube root of the largest cell count"
)]
const fn truncate(value: f32) -> u32 {
    value as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_neighborhoods_name_every_near_pair_once() {
        let positions: Vec<Vec3> = (0..400u32)
            .map(|i| {
                let digit = |k: u32| (i.wrapping_mul(2_654_435_761).rotate_left(k) % 97) as f32;
                Vec3::new(digit(3), digit(11), digit(19)) * 0.001
            })
            .collect();
        let reach = 0.012;
        let mut grid = CellGrid::default();
        grid.sort(&positions, reach);
        let mut found = Vec::new();
        for index in 0..positions.len() {
            let first = grid.entries[index];
            let [own, others @ ..] = grid.following_runs(first.cell);
            for run in std::iter::once(index + 1..own.end).chain(others) {
                let own = grid.position(index);
                let near = run.filter(|&other| own.distance(grid.position(other)) < reach);
                found.extend(near.map(|other| {
                    let other = grid.entries[other];
                    (
                        first.particle.min(other.particle),
                        first.particle.max(other.particle),
                    )
                }));
            }
        }
        found.sort_unstable();
        let mut expected = Vec::new();
        for a in 0..400u32 {
            for b in a + 1..400 {
                if positions[a as usize].distance(positions[b as usize]) < reach {
                    expected.push((a, b));
                }
            }
        }
        assert_eq!(found, expected);
    }
}
