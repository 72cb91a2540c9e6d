//! What lies inside a closed triangle mesh that moves: how often the mesh winds around a place.

use glam::{DVec2, Vec2, Vec3};

use crate::index;

/// Most columns: a body in columns of a centimeter has ten thousand.
const MOST_COLUMNS: f32 = 4.0e6;

/// Where upright columns along `z` cross a mesh.
///
/// Made anew for every pose, in about the time of one look at every triangle. A place is judged in the
/// middle of its column, so near the outline of the mesh, seen along `z`, it may be judged half a column
/// beside where it is.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct InsideColumns {
    low: Vec2,
    /// Side of a column [m].
    size: f32,
    counts: [usize; 2],
    /// Start of each column's run in `crossings`, and one more.
    starts: Vec<u32>,
    /// Heights [m], ascending, and which way the mesh faces there: 1 up, -1 down.
    crossings: Vec<(f32, i32)>,
}

impl InsideColumns {
    /// Cuts a mesh into columns of `size` [m], larger ones where it has burst. Triangles that are not finite
    /// are left out.
    #[must_use]
    pub fn new(positions: &[Vec3], triangles: &[[u32; 3]], size: f32) -> Self {
        let places = triangles
            .iter()
            .map(|it| it.map(|corner| positions[corner as usize]));
        let whole: Vec<[Vec3; 3]> = places
            .filter(|corners| corners.iter().all(|corner| corner.is_finite()))
            .collect();
        let all = || whole.iter().flatten().map(|corner| corner.truncate());
        let low = all().fold(Vec2::INFINITY, Vec2::min);
        let high = all().fold(Vec2::NEG_INFINITY, Vec2::max);
        if whole.is_empty() {
            return Self::default();
        }
        let mut size = size.max(f32::MIN_POSITIVE);
        while MOST_COLUMNS < ((high - low) / size + 1.0).element_product() {
            size *= 2.0;
        }
        let counts = ((high - low) / size).as_uvec2();
        let mut columns = Self {
            low,
            size,
            counts: [counts.x as usize + 1, counts.y as usize + 1],
            starts: Vec::new(),
            crossings: Vec::new(),
        };
        let mut found: Vec<(u32, f32, i32)> = Vec::new();
        for corners in &whole {
            columns.cross(*corners, &mut found);
        }
        columns.sort(&found);
        columns
    }

    /// Takes over what was found, column by column, from below.
    fn sort(&mut self, found: &[(u32, f32, i32)]) {
        let mut starts = vec![0_u32; self.counts[0] * self.counts[1] + 1];
        for &(column, _, _) in found {
            starts[column as usize + 1] += 1;
        }
        for column in 1..starts.len() {
            starts[column] += starts[column - 1];
        }
        let mut next = starts.clone();
        self.crossings = vec![(0.0, 0); found.len()];
        for &(column, height, side) in found {
            let place = &mut next[column as usize];
            self.crossings[*place as usize] = (height, side);
            *place += 1;
        }
        for run in starts.windows(2).filter(|run| run[0] + 1 < run[1]) {
            let run = &mut self.crossings[run[0] as usize..run[1] as usize];
            run.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        }
        self.starts = starts;
    }

    /// Adds where the middles of columns cross a triangle: column, height and side.
    fn cross(&self, corners: [Vec3; 3], found: &mut Vec<(u32, f32, i32)>) {
        let [a, b, c] = corners.map(|corner| corner.truncate());
        let low = ((a.min(b).min(c) - self.low) / self.size).as_uvec2();
        let high = ((a.max(b).max(c) - self.low) / self.size).as_uvec2();
        let is_up = 0.0 < (b - a).as_dvec2().perp_dot((c - a).as_dvec2());
        let over = (low.y..=high.y).flat_map(|row| (low.x..=high.x).map(move |it| (row, it)));
        for (row, column) in over {
            #[expect(clippy::cast_precision_loss, reason = "columns are few")]
            let middle = self.low + (Vec2::new(column as f32, row as f32) + 0.5) * self.size;
            let sides = [[a, b], [b, c], [c, a]].map(|ends| side(ends, middle));
            if sides.iter().any(|&(is_left, _)| is_left != is_up) {
                continue;
            }
            let [on_ab, on_bc, on_ca] = sides.map(|(_, size)| size.abs());
            let [x, y, z] = corners.map(|corner| f64::from(corner.z));
            let height = (x * on_bc + y * on_ca + z * on_ab) / (on_ab + on_bc + on_ca);
            if height.is_finite() {
                let place = row as usize * self.counts[0] + column as usize;
                #[expect(clippy::cast_possible_truncation, reason = "a height in the mesh")]
                found.push((index(place), height as f32, if is_up { 1 } else { -1 }));
            }
        }
    }

    /// How often the mesh winds around a place: 0 outside, 1 inside, 2 where two limbs overlap, and 0 where the
    /// mesh has a hole in the place's column.
    #[must_use]
    pub fn winding(&self, place: Vec3) -> i32 {
        let from = (place.truncate() - self.low) / self.size;
        if !place.is_finite() || from.min_element() < 0.0 {
            return 0;
        }
        let [x, y] = from.as_uvec2().to_array().map(|it| it as usize);
        if self.counts[0] <= x || self.counts[1] <= y {
            return 0;
        }
        let column = y * self.counts[0] + x;
        let [start, end] = [0, 1].map(|next| self.starts[column + next] as usize);
        let crossings = &self.crossings[start..end];
        let total: i32 = crossings.iter().map(|it| it.1).sum();
        if total != 0 {
            return 0;
        }
        let above = crossings.iter().filter(|it| place.z < it.0);
        above.map(|it| it.1).sum()
    }
}

/// Whether a place lies left of the line from one end to another, and twice the area between; a place on it is
/// on the same side of it for both triangles that share it.
fn side([from, to]: [Vec2; 2], place: Vec2) -> (bool, f64) {
    let is_turned = (to.x, to.y) < (from.x, from.y);
    let [low, high] = if is_turned { [to, from] } else { [from, to] };
    let [low, high, place]: [DVec2; 3] = [low, high, place].map(Vec2::as_dvec2);
    let area = (high - low).perp_dot(place - low);
    (is_turned != (0.0 <= area), area)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trig;

    /// A ball of many sides around a place.
    fn ball(middle: Vec3, radius: f32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let (around, along) = (24_u16, 12_u16);
        let mut positions = Vec::new();
        for row in 0..=along {
            let (high, wide) =
                trig::sin_cos(std::f32::consts::PI * (f32::from(row) / f32::from(along) - 0.5));
            positions.extend((0..around).map(|column| {
                let (sin, cos) =
                    trig::sin_cos(std::f32::consts::TAU * f32::from(column) / f32::from(around));
                middle + Vec3::new(wide * cos, wide * sin, high) * radius
            }));
        }
        let at = |row: u16, column: u16| u32::from(row * around + column % around);
        let cells = (0..along).flat_map(|row| (0..around).map(move |column| (row, column)));
        let triangles = cells.flat_map(|(row, column)| {
            let [a, b] = [at(row, column), at(row, column + 1)];
            let [c, d] = [at(row + 1, column), at(row + 1, column + 1)];
            [[a, b, d], [a, d, c]]
        });
        (positions, triangles.collect())
    }

    #[test]
    fn a_mesh_winds_once_around_what_is_in_it_and_twice_where_two_overlap() {
        let (mut positions, mut triangles) = ball(Vec3::new(0.3, -0.2, 0.1), 0.1);
        let (more, others) = ball(Vec3::new(0.4, -0.2, 0.1), 0.1);
        let first = index(positions.len());
        positions.extend(more);
        triangles.extend(others.into_iter().map(|it| it.map(|corner| corner + first)));
        let columns = InsideColumns::new(&positions, &triangles, 0.004);
        for (x, expected) in [(0.18, 0), (0.22, 1), (0.35, 2), (0.45, 1), (0.52, 0)] {
            assert_eq!(columns.winding(Vec3::new(x, -0.2, 0.1)), expected, "{x}");
        }
        assert_eq!(columns.winding(Vec3::new(0.3, -0.2, 0.21)), 0);
        assert_eq!(columns.winding(Vec3::new(0.3, -0.2, -0.01)), 0);
        assert_eq!(columns.winding(Vec3::NAN), 0);
    }

    #[test]
    fn every_column_of_a_closed_mesh_is_entered_as_often_as_it_is_left() {
        // Corners and edges of a cube lie exactly in the middles of columns.
        let corners = (0..8_u8).map(|it| {
            let bit = |k: u8| f32::from(it >> k & 1);
            Vec3::new(bit(0), bit(1), bit(2))
        });
        let sides = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        let mut positions: Vec<Vec3> = corners.collect();
        // Half a column more on each side.
        positions.extend([Vec3::new(-0.125, -0.125, 0.5), Vec3::new(1.125, 1.125, 0.5)]);
        let mut triangles: Vec<[u32; 3]> = sides
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
            .collect();
        triangles.push([8, 9, 8]);
        let columns = InsideColumns::new(&positions, &triangles, 0.25);
        for column in 0..columns.starts.len() - 1 {
            let [start, end] = [0, 1].map(|next| columns.starts[column + next] as usize);
            let sum: i32 = columns.crossings[start..end].iter().map(|it| it.1).sum();
            assert_eq!(sum, 0, "{column}");
        }
        assert_eq!(columns.winding(Vec3::splat(0.5)), 1);
        assert_eq!(InsideColumns::new(&[], &[], 0.1).winding(Vec3::ZERO), 0);
    }
}
