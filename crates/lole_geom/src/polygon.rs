//! A polygon divided into triangles: a lattice of equal triangles inside, the border's own points around it.

use glam::DVec2;
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Point2, Triangulation as _};

/// Points of the lattice keep this share of the spacing from the border.
const FROM_BORDER: f64 = 0.62;
/// Height of a triangle of the lattice over its side: √3 / 2.
const ROW: f64 = 0.866_025_403_784_438_6;
/// A triangle flatter than this share of the spacing is none.
const FLATTEST: f64 = 0.02;

/// A polygon in triangles.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DividedPolygon {
    /// The points of the border as they were given, then those inside [m].
    pub points: Vec<DVec2>,
    /// Their numbers, counterclockwise, ascending.
    pub triangles: Vec<[u32; 3]>,
}

/// A point of the triangulation that knows its number.
#[derive(Debug, Clone, Copy)]
struct Numbered {
    at: DVec2,
    number: u32,
}

impl HasPosition for Numbered {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        Point2::new(self.at.x, self.at.y)
    }
}

/// Divides the polygon within a closed `border` [m] into triangles whose edges inside are about `spacing` long
/// [m]; `None` where the border crosses or touches itself, or a number is not one, or no spacing.
#[must_use]
pub fn divide(border: &[DVec2], spacing: f64) -> Option<DividedPolygon> {
    let is_spacing = spacing.is_finite() && 0.0 < spacing;
    if !is_spacing || !border.iter().all(|point| point.is_finite()) {
        return None;
    }
    let inner = lattice(border, spacing);
    let points: Vec<DVec2> = border.iter().copied().chain(inner).collect();
    let triangles = triangulate(&points, border.len(), spacing)?;
    Some(DividedPolygon { points, triangles })
}

/// Corners of equal triangles within a border.
fn lattice(border: &[DVec2], spacing: f64) -> Vec<DVec2> {
    let low = border.iter().fold(DVec2::INFINITY, |low, p| low.min(*p));
    let high = border
        .iter()
        .fold(DVec2::NEG_INFINITY, |high, p| high.max(*p));
    let mut points = Vec::new();
    let mut row = 0_u32;
    loop {
        let y = low.y + f64::from(row) * ROW * spacing;
        if high.y < y {
            return points;
        }
        let mut column = 0_u32;
        loop {
            let half = if row.is_multiple_of(2) { 0.0 } else { 0.5 };
            let x = low.x + (f64::from(column) + half) * spacing;
            if high.x < x {
                break;
            }
            let point = DVec2::new(x, y);
            if is_inside(border, point) && FROM_BORDER * spacing < distance(border, point) {
                points.push(point);
            }
            column += 1;
        }
        row += 1;
    }
}

fn sides(border: &[DVec2]) -> impl Iterator<Item = [DVec2; 2]> {
    let next = border.iter().cycle().skip(1);
    border.iter().zip(next).map(|(&a, &b)| [a, b])
}

/// By the number of sides that are crossed on the way to the right.
fn is_inside(border: &[DVec2], point: DVec2) -> bool {
    let crossed = sides(border).filter(|[a, b]| {
        (a.y <= point.y) != (b.y <= point.y)
            && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)
    });
    crossed.count() % 2 == 1
}

fn distance(border: &[DVec2], point: DVec2) -> f64 {
    let to_side = sides(border).map(|[a, b]| {
        let along = b - a;
        let share = (point - a).dot(along) / along.length_squared().max(1.0e-18);
        (a + along * share.clamp(0.0, 1.0)).distance(point)
    });
    to_side.fold(f64::INFINITY, f64::min)
}

/// Triangles between points of which the first ones are a border; `None` where that crosses itself.
fn triangulate(points: &[DVec2], border_count: usize, spacing: f64) -> Option<Vec<[u32; 3]>> {
    let numbered: Vec<Numbered> = (0_u32..)
        .zip(points)
        .map(|(number, &at)| Numbered { at, number })
        .collect();
    let sides: Vec<[usize; 2]> = (0..border_count)
        .map(|from| [from, (from + 1) % border_count])
        .collect();
    let mut crosses = false;
    let found =
        ConstrainedDelaunayTriangulation::<Numbered>::try_bulk_load_cdt(numbered, sides, |_| {
            crosses = true;
        });
    let found = found.ok()?;
    if crosses || found.num_vertices() != points.len() {
        return None;
    }
    let border = &points[..border_count];
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for face in found.inner_faces() {
        let corners = face.vertices().map(|vertex| vertex.data().number);
        let [a, b, c] = corners.map(|corner| points[corner as usize]);
        let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
        let height = (b - a).perp_dot(c - a) / longest;
        if is_inside(border, (a + b + c) / 3.0) && FLATTEST * spacing < height {
            triangles.push(corners);
        }
    }
    triangles.sort_unstable();
    Some(triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(points: &[DVec2], [a, b, c]: [u32; 3]) -> f64 {
        let [a, b, c] = [a, b, c].map(|corner| points[corner as usize]);
        0.5 * (b - a).perp_dot(c - a)
    }

    #[test]
    fn triangles_fill_a_polygon_with_a_bay_and_nothing_else() {
        let corners = [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (1.5, 0.5), (0.0, 2.0)];
        let border = corners.map(|(x, y)| DVec2::new(x, y));
        let divided = divide(&border, 0.2).expect("a polygon");
        assert_eq!(divided.points[..5], border);
        assert!(100 < divided.triangles.len());
        let areas = (divided.triangles.iter()).map(|&it| area(&divided.points, it));
        let areas: Vec<f64> = areas.collect();
        assert!(areas.iter().all(|&it| 0.0 < it));
        let whole: f64 = areas.iter().sum();
        assert!((whole - 3.75).abs() < 1.0e-9, "{whole}");
    }

    #[test]
    fn what_is_no_polygon_is_refused() {
        let bow = [(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)];
        let bow = bow.map(|(x, y)| DVec2::new(x, y));
        assert_eq!(divide(&bow, 0.1), None);
        let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        for spacing in [0.0, -0.1, f64::NAN, f64::INFINITY] {
            assert_eq!(divide(&square, spacing), None, "{spacing}");
        }
        assert_eq!(divide(&[DVec2::ZERO, DVec2::NAN, DVec2::Y], 0.1), None);
    }
}
