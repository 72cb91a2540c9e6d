//! The nearest of many points, through cells that are sorted anew in every frame.

use glam::{IVec3, Vec3};

/// Most cells: beyond, a cloth has burst and larger cells do.
const MOST_CELLS: f32 = 2.0e6;

/// Points sorted into cubic cells; its room is kept from frame to frame.
#[derive(Debug, Clone, Default)]
pub(super) struct PointGrid {
    origin: Vec3,
    cell: f32,
    counts: IVec3,
    /// Start of each cell's run in `members`, shape `[cell_count + 1]`.
    starts: Vec<u32>,
    /// Points and their numbers, ascending within a cell.
    members: Vec<(Vec3, u32)>,
}

impl PointGrid {
    /// Sorts the finite points of `numbered` that lie between `low` and `high` [m] into cells of
    /// `cell` [m].
    pub(super) fn sort(
        &mut self,
        numbered: impl Iterator<Item = (u32, Vec3)> + Clone,
        [low, high]: [Vec3; 2],
        cell: f32,
    ) {
        self.members.clear();
        self.starts.clear();
        (self.origin, self.cell) = (low, cell);
        let inside = |(_, point): &(u32, Vec3)| low.cmple(*point).all() && point.cmple(high).all();
        if !low.cmple(high).all() {
            self.counts = IVec3::ZERO;
            return;
        }
        while MOST_CELLS < ((high - low) / self.cell + 1.0).element_product() {
            self.cell *= 2.0;
        }
        self.counts = ((high - low) / self.cell).as_ivec3() + IVec3::ONE;
        let cell_count = self.counts.x as usize * self.counts.y as usize * self.counts.z as usize;
        self.starts.resize(cell_count + 2, 0);
        // Counted two places on, so that after the second pass every run starts where it should.
        for (_, point) in numbered.clone().filter(inside) {
            let cell = self.cell_at(self.place(point));
            self.starts[cell + 2] += 1;
        }
        for cell in 2..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        let count = self.starts[cell_count + 1] as usize;
        self.members.resize(count, (Vec3::ZERO, 0));
        for (number, point) in numbered.filter(inside) {
            let cell = self.cell_at(self.place(point));
            let slot = self.starts[cell + 1];
            self.members[slot as usize] = (point, number);
            self.starts[cell + 1] += 1;
        }
    }

    /// Cell of a point, which may lie beyond the cells.
    fn place(&self, point: Vec3) -> IVec3 {
        ((point - self.origin) / self.cell).floor().as_ivec3()
    }

    const fn cell_at(&self, place: IVec3) -> usize {
        let row = place.z as usize * self.counts.y as usize + place.y as usize;
        row * self.counts.x as usize + place.x as usize
    }

    /// The nearest point within `reach` [m], no farther than `hint`, a point and its number, and its
    /// distance [m]; the lowest number wins a tie.
    pub(super) fn nearest(
        &self,
        point: Vec3,
        reach: f32,
        hint: Option<(Vec3, u32)>,
    ) -> Option<(u32, f32)> {
        let hint = hint.map(|(place, number)| (place.distance_squared(point), number));
        let mut best = hint.filter(|hint| hint.0 < reach * reach);
        let limit = best.map_or(reach, |best| best.0.sqrt());
        let last = self.counts - IVec3::ONE;
        let from = self.place(point - limit).max(IVec3::ZERO);
        let to = self.place(point + limit).min(last);
        let rows = (from.z..=to.z).flat_map(|z| (from.y..=to.y).map(move |y| (y, z)));
        for (y, z) in rows.filter(|_| from.x <= to.x) {
            let first = self.cell_at(IVec3::new(from.x, y, z));
            let end = self.cell_at(IVec3::new(to.x, y, z)) + 1;
            let run = self.starts[first] as usize..self.starts[end] as usize;
            for &(place, number) in &self.members[run] {
                let square = place.distance_squared(point);
                let held = best.unwrap_or((reach * reach, u32::MAX));
                let ties = square.to_bits() == held.0.to_bits() && number < held.1;
                if square < held.0 || ties {
                    best = Some((square, number));
                }
            }
        }
        best.map(|(square, number)| (number, square.sqrt()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Repeatable numbers in `-1..1`.
    fn noise(state: &mut u64) -> f32 {
        *state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let top = u16::try_from(*state >> 48).unwrap();
        f32::from(top) / 32_768.0 - 1.0
    }

    #[test]
    fn the_cells_agree_with_trying_every_point() {
        let mut state = 3;
        let mut random = || Vec3::new(noise(&mut state), noise(&mut state), noise(&mut state));
        let points: Vec<Vec3> = (0..400).map(|_| random()).collect();
        let numbered = (0_u32..).zip(points.iter().copied());
        let mut grid = PointGrid::default();
        grid.sort(numbered.clone(), [Vec3::NEG_ONE, Vec3::ONE], 0.13);
        let mut hint = None;
        for _ in 0..400 {
            let point = random() * 1.2;
            let truth = numbered
                .clone()
                .map(|(number, place)| (place.distance(point), number))
                .filter(|found| found.0 < 0.2)
                .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let found = grid.nearest(point, 0.2, hint);
            assert_eq!(found.map(|found| found.0), truth.map(|truth| truth.1));
            hint = found.map(|(number, _)| (points[number as usize], number));
        }
    }

    #[test]
    fn no_points_and_a_burst_cloth_are_harmless() {
        let mut grid = PointGrid::default();
        grid.sort([].into_iter(), [Vec3::INFINITY, Vec3::NEG_INFINITY], 0.1);
        assert_eq!(grid.nearest(Vec3::ZERO, 1.0, None), None);
        let far = [(0, Vec3::ZERO), (1, Vec3::splat(90.0)), (2, Vec3::NAN)];
        grid.sort(far.into_iter(), [Vec3::ZERO, Vec3::splat(90.0)], 0.01);
        assert!(grid.starts.len() < 3_000_000);
        let found = grid.nearest(Vec3::splat(89.9), 0.5, None);
        assert_eq!(found.map(|found| found.0), Some(1));
    }
}
