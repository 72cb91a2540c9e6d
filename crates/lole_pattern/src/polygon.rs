//! A closed polygon in the plane: area, bounds, crossings, places inside it.

use kurbo::{Affine, Point, Rect, Vec2};

/// A closed polygon: the last point is joined to the first. In meters, counterclockwise where it
/// bounds cloth.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Polygon {
    /// Its corners, none twice in a row.
    pub points: Vec<Point>,
}

/// Points nearer than this are one point [m]: a hundredth of the width of a thread.
pub(crate) const SAME_POINT: f64 = 1.0e-6;

impl Polygon {
    /// The polygon through these points; points that repeat the last one are left out.
    #[must_use]
    pub fn new(points: impl IntoIterator<Item = Point>) -> Self {
        let mut kept: Vec<Point> = Vec::new();
        for point in points {
            if kept
                .last()
                .is_none_or(|last| SAME_POINT < last.distance(point))
            {
                kept.push(point);
            }
        }
        while let [first, .., last] = kept.as_slice() {
            if SAME_POINT < first.distance(*last) {
                break;
            }
            kept.pop();
        }
        Self { points: kept }
    }

    /// The sides, each from a corner to the next one.
    pub fn sides(&self) -> impl Iterator<Item = [Point; 2]> + '_ {
        let next = self.points.iter().cycle().skip(1);
        self.points.iter().zip(next).map(|(a, b)| [*a, *b])
    }

    /// Area by Gauss's formula, `½ Σ (x₁y₂ - x₂y₁)` [m²]; negative where it runs clockwise.
    #[must_use]
    pub fn signed_area(&self) -> f64 {
        // Seen from its first corner, so that a small piece far from zero keeps its digits.
        let origin = self.points.first().copied().unwrap_or_default();
        let doubled: f64 = self
            .sides()
            .map(|[a, b]| (a - origin).cross(b - origin))
            .sum();
        0.5 * doubled
    }

    /// The smallest upright box around it; nothing at zero for a polygon without points.
    #[must_use]
    pub fn bounds(&self) -> Rect {
        let Some(first) = self.points.first() else {
            return Rect::ZERO;
        };
        let start = Rect::from_points(*first, *first);
        (self.points.iter()).fold(start, |bounds, point| bounds.union_pt(*point))
    }

    /// The polygon moved by `transform`. A reflection turns its direction, which is turned back.
    #[must_use]
    pub fn transformed(&self, transform: Affine) -> Self {
        let mut points: Vec<Point> = self.points.iter().map(|point| transform * *point).collect();
        if transform.determinant() < 0.0 {
            points.reverse();
        }
        Self { points }
    }

    /// Whether a point lies inside, by the winding of the sides around it.
    #[must_use]
    pub fn contains(&self, point: Point) -> bool {
        let mut winding = 0;
        for [a, b] in self.sides() {
            let is_left = 0.0 < (b - a).cross(point - a);
            if a.y <= point.y && point.y < b.y && is_left {
                winding += 1;
            } else if b.y <= point.y && point.y < a.y && !is_left {
                winding -= 1;
            }
        }
        winding != 0
    }

    /// Distance from a point to the nearest side [m].
    #[must_use]
    pub fn distance(&self, point: Point) -> f64 {
        self.sides()
            .map(|side| distance_to_side(side, point))
            .fold(f64::INFINITY, f64::min)
    }

    /// Two sides that cross or touch without being neighbors, the first such pair; `None` for a
    /// simple polygon.
    #[must_use]
    pub fn first_crossing(&self) -> Option<Crossing> {
        let sides: Vec<[Point; 2]> = self.sides().collect();
        for (first, side) in sides.iter().enumerate() {
            for (second, other) in sides.iter().enumerate().skip(first + 2) {
                let are_neighbors = first == 0 && second + 1 == sides.len();
                if are_neighbors {
                    continue;
                }
                if let Some(at) = crossing(*side, *other) {
                    return Some(Crossing {
                        sides: [first, second],
                        at,
                    });
                }
            }
        }
        None
    }

    /// The same shape without corners that lie on the straight line between their neighbors.
    #[must_use]
    pub fn without_straight_corners(&self) -> Self {
        let Some(last) = self.points.last() else {
            return self.clone();
        };
        let mut kept: Vec<Point> = Vec::new();
        let after = self.points.iter().cycle().skip(1);
        for (at, after) in self.points.iter().zip(after) {
            // Seen from the last corner that stays: seen from its neighbor, a bend of many small
            // corners would go corner by corner.
            let before = kept.last().unwrap_or(last);
            if STRAIGHT < distance_to_side([*before, *after], *at) {
                kept.push(*at);
            }
        }
        Self::new(kept)
    }

    /// The point inside that is farthest from all sides, to about a fiftieth of the smaller size: where a
    /// label has the most room. With its distance from the nearest side [m].
    #[must_use]
    pub fn roomiest_point(&self) -> (Point, f64) {
        let bounds = self.bounds();
        let middle = bounds.center();
        let is_inside = self.contains(middle);
        let mut best = (
            middle,
            if is_inside {
                self.distance(middle)
            } else {
                0.0
            },
        );
        let mut window = bounds;
        // A grid, then a finer one around its best point: labels need no more.
        for _ in 0..3 {
            let step = Vec2::new(window.width(), window.height()) / f64::from(GRID);
            for cell in 0..(GRID + 1) * (GRID + 1) {
                let (column, row) = (cell % (GRID + 1), cell / (GRID + 1));
                let away = Vec2::new(step.x * f64::from(column), step.y * f64::from(row));
                let point = window.origin() + away;
                let room = self.distance(point);
                // The middle of a strip is as good as its ends, and better to look at.
                if (1.0 + ROUNDING) * best.1 < room && self.contains(point) {
                    best = (point, room);
                }
            }
            let half = step * 1.5;
            window = Rect::from_points(best.0 - half, best.0 + half);
        }
        best
    }
}

/// A corner that sticks out less is rounding [m].
const STRAIGHT: f64 = 1.0e-9;

/// Room that is larger by less is no larger.
const ROUNDING: f64 = 1.0e-3;

/// Cells of the grid on which the roomiest point is looked for, along each side.
const GRID: u32 = 16;

/// Where two sides of a polygon meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// Indices of the sides.
    pub sides: [usize; 2],
    /// The place [m].
    pub at: Point,
}

/// Distance from a point to a line segment.
pub(crate) fn distance_to_side([a, b]: [Point; 2], point: Point) -> f64 {
    let along = b - a;
    let length_squared = along.hypot2();
    let part = if length_squared <= 0.0 {
        0.0
    } else {
        ((point - a).dot(along) / length_squared).clamp(0.0, 1.0)
    };
    (a + along * part).distance(point)
}

/// Where two line segments meet; `None` where they are parallel or apart.
pub(crate) fn crossing([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Option<Point> {
    let [s, t] = crossing_parts([a, b], [c, d])?;
    let meets = (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t);
    meets.then(|| a.lerp(b, s))
}

/// How far along each of two lines their crossing lies, over the length of the given stretch.
pub(crate) fn crossing_parts([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Option<[f64; 2]> {
    let (first, second) = (b - a, d - c);
    let cross = first.cross(second);
    // The sine of the angle between them: less than a millimeter aside in ten meters is parallel.
    if cross.abs() <= 1.0e-4 * first.hypot() * second.hypot() {
        return None;
    }
    let between = c - a;
    Some([between.cross(second) / cross, between.cross(first) / cross])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(size: f64) -> Polygon {
        let corners = [(0.0, 0.0), (size, 0.0), (size, size), (0.0, size)];
        Polygon::new(corners.map(Point::from))
    }

    #[test]
    fn a_square_has_its_area_and_a_mirrored_one_too() {
        let far = square(2.0).transformed(Affine::translate((1000.0, -500.0)));
        assert!((far.signed_area() - 4.0).abs() < 1e-9);
        assert!((far.transformed(Affine::FLIP_X).signed_area() - 4.0).abs() < 1e-9);
    }

    #[test]
    fn a_bow_tie_crosses_itself_and_a_square_does_not() {
        let bow = [(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)];
        let found = Polygon::new(bow.map(Point::from)).first_crossing();
        let found = found.unwrap_or_else(|| panic!("a bow tie crosses itself"));
        assert!(found.at.distance(Point::new(1.0, 1.0)) < 1e-12);
        assert_eq!(square(1.0).first_crossing(), None);
    }

    #[test]
    fn the_roomiest_point_of_a_square_is_its_middle() {
        let (point, room) = square(2.0).roomiest_point();
        assert!(point.distance(Point::new(1.0, 1.0)) < 0.02, "{point:?}");
        assert!((room - 1.0).abs() < 0.02);
    }

    #[test]
    fn inside_and_outside_are_told_apart() {
        let ell = [
            (0.0, 0.0),
            (3.0, 0.0),
            (3.0, 1.0),
            (1.0, 1.0),
            (1.0, 3.0),
            (0.0, 3.0),
        ];
        let ell = Polygon::new(ell.map(Point::from));
        assert!(ell.contains(Point::new(0.5, 2.0)));
        assert!(!ell.contains(Point::new(2.0, 2.0)));
        assert!(!ell.contains(Point::new(-1.0, 1.0)));
    }

    #[test]
    fn corners_on_a_straight_line_are_left_out() {
        let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)];
        let plain = Polygon::new(points.map(Point::from)).without_straight_corners();
        assert_eq!(plain.points.len(), 4);
    }
}
