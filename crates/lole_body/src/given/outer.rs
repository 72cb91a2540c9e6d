//! What of a given body cloth can come to.
//!
//! Characters of games are made of shells in each other: skin below trousers, the lining of a coat, a foot
//! in a shoe. Cloth that met all of it would be held by whatever face is nearest, the lining of a sleeve
//! included, which looks inward. So a ball a little larger than a fold is rolled over everything from
//! outside: what it touches is the body, facing where the ball is, and the rest is not met.

use glam::{IVec3, Vec3};
use lole_geom::TriangleGrid;

/// Radius of the ball [m].
const BALL: f32 = 0.012;

/// Edge of a cell of the room in which it rolls [m], where the room has no more than [`CELLS_MAX`].
const CELL: f32 = 0.006;

/// Cells at most: a tall man with outstretched arms has half as many.
const CELLS_MAX: f32 = 1.2e7;

/// A face is looked at from so many cells above it.
const ABOVE: f32 = 1.5;

/// A point looks at its own face from so far above it [m].
const OFF: f32 = 1.0e-4;

/// A face looks at the middle of what carries it if this is more than the cosine between its normal and
/// the way out from there: less than nothing, because no limb is a cylinder.
const FACING_IN: f32 = -0.4;

/// With less than this part of all faces left the body is taken as it is.
const LEAST_LEFT: f32 = 0.05;

/// Weights of the corners at the points of a face that are tried.
const POINTS: [[f32; 3]; 4] = [
    [1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0],
    [0.7, 0.15, 0.15],
    [0.15, 0.7, 0.15],
    [0.15, 0.15, 0.7],
];

/// The triangles that can be come to from outside, each counter-clockwise seen from there. Those that can
/// be come to from both sides stay as they are. What faces the middle of what carries it (`middle_of` a
/// corner) is the inside of a body with a hole, or of a stiff skirt, into which the ball rolls and cloth
/// does not: it is left away.
pub(super) fn outer_surface(
    positions: &[Vec3],
    triangles: &[[u32; 3]],
    middle_of: impl Fn(u32) -> Vec3,
) -> Vec<[u32; 3]> {
    let Some(room) = Room::around(positions, triangles) else {
        return triangles.to_vec();
    };
    let grid = TriangleGrid::new(positions, triangles, 2.0 * room.cell);
    let open_count = |[a, b, c]: [u32; 3]| {
        let [a, b, c] = [a, b, c].map(|corner| positions[corner as usize]);
        let Some(normal) = (b - a).cross(c - a).try_normalize() else {
            return 0;
        };
        let points = POINTS.iter().map(|[u, v, w]| a * *u + b * *v + c * *w);
        let open = points.filter(|&point| {
            let above = point + normal * (ABOVE * room.cell);
            room.is_outside(above) && grid.first_crossing(point + normal * OFF, above).is_none()
        });
        open.count()
    };
    // The cosine between the normal of a face and the way out from the middle of what carries it.
    let facing_out = |[a, b, c]: [u32; 3]| {
        let out = [a, b, c].map(|corner| positions[corner as usize] - middle_of(corner));
        let out = out.iter().sum::<Vec3>().normalize_or_zero();
        let [a, b, c] = [a, b, c].map(|corner| positions[corner as usize]);
        (b - a).cross(c - a).normalize_or_zero().dot(out)
    };
    let facing = |&[a, b, c]: &[u32; 3]| {
        if 0 < open_count([a, b, c]) {
            return (FACING_IN <= facing_out([a, b, c])).then_some([a, b, c]);
        }
        // A crease that the ball cannot come to is not turned around by a doubtful point, and the inside
        // of a body with a hole is none of its outside.
        let turned = [a, c, b];
        (0.0 < facing_out(turned) && open_count(turned) == POINTS.len()).then_some(turned)
    };
    let left: Vec<[u32; 3]> = triangles.iter().filter_map(facing).collect();
    if (left.len() as f32) < LEAST_LEFT * triangles.len() as f32 {
        return triangles.to_vec();
    }
    left
}

/// The room around a body, in cells.
struct Room {
    low: Vec3,
    cell: f32,
    size: IVec3,
    /// By cell, whether the ball comes there.
    is_outside: Vec<bool>,
}

impl Room {
    /// Rolls the ball around some triangles; `None` where there are none.
    fn around(positions: &[Vec3], triangles: &[[u32; 3]]) -> Option<Self> {
        let used = || triangles.iter().flatten().map(|&v| positions[v as usize]);
        let low = used().fold(Vec3::INFINITY, Vec3::min);
        let high = used().fold(Vec3::NEG_INFINITY, Vec3::max);
        if !(low.is_finite() && high.is_finite()) {
            return None;
        }
        // The ball has room on all sides.
        let margin = Vec3::splat(3.0 * BALL);
        let (low, extent) = (low - margin, high - low + 2.0 * margin);
        let mut cell = CELL;
        while CELLS_MAX < (extent / cell).element_product() {
            cell *= 1.1;
        }
        let size = (extent / cell).ceil().as_ivec3() + IVec3::ONE;
        let mut room = Self {
            low,
            cell,
            size,
            is_outside: Vec::new(),
        };
        let mut is_skin = vec![false; room.count()];
        for triangle in triangles {
            room.mark(triangle.map(|v| positions[v as usize]), &mut is_skin);
        }
        let radius = BALL / cell;
        let from_skin = room.squared_distances(&is_skin);
        let centers = room.flooded(|cell| radius * radius < from_skin[cell]);
        let from_centers = room.squared_distances(&centers);
        // A cell more, because distances are those of middles of cells.
        let reach = radius + 1.0;
        room.is_outside = (from_centers.iter())
            .map(|&it| it <= reach * reach)
            .collect();
        Some(room)
    }

    fn count(&self) -> usize {
        usize::try_from(self.size.element_product()).unwrap_or(0)
    }

    fn index(&self, cell: IVec3) -> usize {
        let place = (cell.z * self.size.y + cell.y) * self.size.x + cell.x;
        usize::try_from(place).unwrap_or(0)
    }

    fn cell_of(&self, point: Vec3) -> IVec3 {
        let cell = ((point - self.low) / self.cell).floor().as_ivec3();
        cell.clamp(IVec3::ZERO, self.size - IVec3::ONE)
    }

    fn is_outside(&self, point: Vec3) -> bool {
        self.is_outside[self.index(self.cell_of(point))]
    }

    /// Marks the cells that a triangle goes through.
    fn mark(&self, [a, b, c]: [Vec3; 3], is_skin: &mut [bool]) {
        let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a face is some hundred cells long at most"
        )]
        let parts = (2.0 * longest / self.cell).ceil().clamp(1.0, 4096.0) as u16;
        let share = |part: u16| f32::from(part) / f32::from(parts);
        for first in 0..=parts {
            for second in 0..=parts - first {
                let (u, v) = (share(first), share(second));
                let point = a * u + b * v + c * (1.0 - u - v);
                is_skin[self.index(self.cell_of(point))] = true;
            }
        }
    }

    /// The cells that can be come to from the border of the room through such that `is_free`.
    fn flooded(&self, is_free: impl Fn(usize) -> bool) -> Vec<bool> {
        let mut found = vec![false; self.count()];
        let mut open = vec![IVec3::ZERO];
        found[0] = true;
        while let Some(cell) = open.pop() {
            let around = IVec3::AXES.map(|axis| [cell - axis, cell + axis]);
            for next in around.as_flattened().iter().copied() {
                let is_inside = next.cmpge(IVec3::ZERO).all() && next.cmplt(self.size).all();
                let place = if is_inside { self.index(next) } else { 0 };
                if is_inside && !found[place] && is_free(place) {
                    found[place] = true;
                    open.push(next);
                }
            }
        }
        found
    }

    /// Squared distance of every cell to the nearest marked one, in cells: exact, an axis at a time
    /// (Felzenszwalb and Huttenlocher 2012, "Distance Transforms of Sampled Functions").
    fn squared_distances(&self, is_marked: &[bool]) -> Vec<f32> {
        let far = 1.0e9;
        let mut distances: Vec<f32> = (is_marked.iter())
            .map(|&it| if it { 0.0 } else { far })
            .collect();
        let sizes = self.size.as_uvec3().to_array().map(|size| size as usize);
        let strides = [1, sizes[0], sizes[0] * sizes[1]];
        let mut line = Line::default();
        for axis in 0..3 {
            let (count, stride) = (sizes[axis], strides[axis]);
            for start in 0..distances.len() {
                if (start / stride) % count == 0 {
                    line.transform(&mut distances, (start, stride, count));
                }
            }
        }
        distances
    }
}

/// Room for one line of a distance transform.
#[derive(Default)]
struct Line {
    values: Vec<f32>,
    /// Places of the parabolas of the lower envelope, and where each begins.
    places: Vec<usize>,
    begins: Vec<f32>,
}

impl Line {
    fn transform(&mut self, all: &mut [f32], (start, stride, count): (usize, usize, usize)) {
        self.values.clear();
        self.values
            .extend((0..count).map(|place| all[start + place * stride]));
        self.places.clear();
        self.begins.clear();
        let values = &self.values;
        for place in 0..count {
            let q = place as f32;
            let meet = |other: usize| {
                let p = other as f32;
                ((values[place] + q * q) - (values[other] + p * p)) / (2.0 * (q - p))
            };
            let mut begin = f32::NEG_INFINITY;
            while let Some(&last) = self.places.last() {
                begin = meet(last);
                if self.begins.last().is_some_and(|&from| begin <= from) {
                    self.places.pop();
                    self.begins.pop();
                    begin = f32::NEG_INFINITY;
                } else {
                    break;
                }
            }
            self.places.push(place);
            self.begins.push(begin);
        }
        let mut at = 0;
        for place in 0..count {
            let q = place as f32;
            while at + 1 < self.places.len() && self.begins[at + 1] < q {
                at += 1;
            }
            let off = q - self.places[at] as f32;
            all[start + place * stride] = values[self.places[at]] + off * off;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The box from `low` to `high`, facing outward.
    fn block(low: Vec3, high: Vec3) -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let corner = |index: u32| {
            let pick = |bit: u32, axis: usize| {
                if (index >> bit) & 1 == 0 {
                    low[axis]
                } else {
                    high[axis]
                }
            };
            Vec3::new(pick(0, 0), pick(1, 1), pick(2, 2))
        };
        let squares = [
            [0, 4, 6, 2],
            [1, 3, 7, 5],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 2, 3, 1],
            [4, 5, 7, 6],
        ];
        let triangles = squares
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
        ((0..8).map(corner).collect(), triangles.collect())
    }

    fn both(
        (mut positions, mut triangles): (Vec<Vec3>, Vec<[u32; 3]>),
        other: &(Vec<Vec3>, Vec<[u32; 3]>),
    ) -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let first = u32::try_from(positions.len()).unwrap();
        positions.extend(&other.0);
        triangles.extend(other.1.iter().map(|it| it.map(|corner| corner + first)));
        (positions, triangles)
    }

    #[test]
    fn what_lies_in_a_shell_is_not_met_and_the_shell_is() {
        let shell = block(Vec3::ZERO, Vec3::splat(0.3));
        let inner = block(Vec3::splat(0.01), Vec3::splat(0.29));
        let (positions, triangles) = both(shell.clone(), &inner);
        assert_eq!(
            outer_surface(&positions, &triangles, |_| Vec3::splat(0.15)),
            shell.1
        );
    }

    #[test]
    fn a_sheet_seen_from_both_sides_is_met_from_its_outer_one() {
        let positions = [Vec3::X, Vec3::X + Vec3::Y, Vec3::X + Vec3::Z];
        let both = [[0, 1, 2], [0, 2, 1]];
        assert_eq!(
            outer_surface(&positions, &both, |_| Vec3::ZERO),
            [[0, 1, 2]]
        );
        let middle = 2.0 * Vec3::X;
        assert_eq!(outer_surface(&positions, &both, |_| middle), [[0, 2, 1]]);
    }

    #[test]
    fn faces_that_look_inward_are_turned_around() {
        let (positions, triangles) = block(Vec3::ZERO, Vec3::new(0.2, 0.4, 0.3));
        let inward: Vec<[u32; 3]> = triangles.iter().map(|&[a, b, c]| [a, c, b]).collect();
        let outward: Vec<[u32; 3]> = inward.iter().map(|&[a, b, c]| [a, c, b]).collect();
        assert_eq!(
            outer_surface(&positions, &inward, |_| Vec3::splat(0.15)),
            outward
        );
        assert_eq!(
            outer_surface(&positions, &triangles, |_| Vec3::splat(0.15)),
            triangles
        );
    }

    #[test]
    fn limbs_beside_each_other_stay_both_and_nothing_is_nothing() {
        let one = block(Vec3::ZERO, Vec3::new(0.1, 0.5, 0.1));
        let other = block(Vec3::new(0.14, 0.0, 0.0), Vec3::new(0.24, 0.5, 0.1));
        let (positions, triangles) = both(one, &other);
        let middle_of = |vertex: u32| Vec3::new(if vertex < 8 { 0.05 } else { 0.19 }, 0.25, 0.05);
        assert_eq!(outer_surface(&positions, &triangles, middle_of), triangles);
        assert!(outer_surface(&[], &[], |_| Vec3::ZERO).is_empty());
    }

    #[test]
    fn distances_are_exact() {
        let room = Room {
            low: Vec3::ZERO,
            cell: 1.0,
            size: IVec3::new(7, 5, 6),
            is_outside: Vec::new(),
        };
        let marked = [
            IVec3::new(1, 4, 0),
            IVec3::new(5, 0, 3),
            IVec3::new(6, 2, 5),
        ];
        let mut is_marked = vec![false; room.count()];
        for cell in marked {
            is_marked[room.index(cell)] = true;
        }
        let distances = room.squared_distances(&is_marked);
        for x in 0..7 {
            for y in 0..5 {
                for z in 0..6 {
                    let cell = IVec3::new(x, y, z);
                    let squares = marked.map(|it| (it - cell).length_squared());
                    let nearest = squares.into_iter().min().unwrap();
                    assert_eq!(distances[room.index(cell)], nearest as f32, "{cell}");
                }
            }
        }
    }
}
