//! How many cells away the nearest occupied cell is, up to a few.

use glam::IVec3;

/// Farthest that is told apart, in cells: as many empty cells must lie around the occupied ones.
pub(super) const FARTHEST: i32 = 4;

/// Levels of all cells, along x first: 0 where occupied, `n` where an occupied cell is `n` away in
/// the larger of the three directions, [`BEYOND`] farther away.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Nearness {
    levels: Vec<u8>,
    reached: Vec<u8>,
    before: Vec<u8>,
}

/// More than [`FARTHEST`].
const BEYOND: u8 = 255;

impl Nearness {
    /// Memory that it holds [byte].
    pub(super) const fn byte_count(&self) -> usize {
        self.levels.len() + self.reached.len() + self.before.len()
    }

    /// Works out the levels of `counts` cells of which those between which `starts` differ are
    /// occupied.
    pub(super) fn set(&mut self, counts: IVec3, starts: &[u32]) {
        self.reached.clear();
        let occupied = starts.windows(2).map(|pair| u8::from(pair[0] < pair[1]));
        self.reached.extend(occupied);
        self.levels.clear();
        let level = |&reached: &u8| if reached == 1 { 0 } else { BEYOND };
        self.levels.extend(self.reached.iter().map(level));
        let [width, height] = [counts.x, counts.y].map(|count| usize::try_from(count).unwrap_or(0));
        for level in 1..=FARTHEST {
            for stride in [1, width, width * height] {
                self.spread(stride);
            }
            let level = u8::try_from(level).unwrap_or(BEYOND);
            for (known, &reached) in self.levels.iter_mut().zip(&self.reached) {
                *known = (*known).min(if reached == 1 { level } else { BEYOND });
            }
        }
    }

    /// Reaches the neighbors at a stride. Around the ends of rows it may reach one too many, never
    /// one too few.
    fn spread(&mut self, stride: usize) {
        self.before.clear();
        self.before.extend_from_slice(&self.reached);
        let count = self.reached.len();
        if count <= stride {
            return;
        }
        for (reached, &next) in self.reached[..count - stride]
            .iter_mut()
            .zip(&self.before[stride..])
        {
            *reached |= next;
        }
        for (reached, &last) in self.reached[stride..]
            .iter_mut()
            .zip(&self.before[..count - stride])
        {
            *reached |= last;
        }
    }

    /// Whether an occupied cell may lie within `range` cells of a cell: `false` is certain.
    pub(super) fn may_reach(&self, cell: usize, range: i32) -> bool {
        i32::from(self.levels[cell]) <= range.min(FARTHEST)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_distances_to_the_nearest_occupied_cell() {
        let counts = IVec3::new(13, 12, 11);
        let index = |cell: IVec3| ((cell.z * counts.y + cell.y) * counts.x + cell.x) as usize;
        let occupied = [IVec3::new(4, 5, 6), IVec3::new(8, 4, 4)];
        let mut starts = vec![0_u32; counts.element_product() as usize + 1];
        for cell in occupied {
            for start in &mut starts[index(cell) + 1..] {
                *start += 1;
            }
        }
        let mut nearness = Nearness::default();
        nearness.set(counts, &starts);
        for place in 0..counts.element_product() {
            let (row, x) = (place / counts.x, place % counts.x);
            let cell = IVec3::new(x, row % counts.y, row / counts.y);
            let away = occupied.map(|other| (cell - other).abs().max_element());
            let nearest = away[0].min(away[1]);
            for range in 0..=FARTHEST {
                let found = nearness.may_reach(index(cell), range);
                assert_eq!(found, nearest <= range, "{cell} {range}");
            }
        }
    }
}
