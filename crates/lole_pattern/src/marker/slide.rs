//! Pushes pieces together until their cut lines touch.

use kurbo::{Affine, Point, Vec2};

use crate::polygon::{Polygon, SAME_POINT};

/// A moving outline is taken this much smaller, so that it slides along what it touches.
const SHRINK: f64 = 1.0e-6;

/// Outlines that lie over each other by less than this touch [m].
const TOUCHING: f64 = 5.0e-6;

/// How far an outline can move along a unit direction before it meets one of the others, at most
/// `limit` [m].
///
/// The smaller outline of a scooped piece may begin across a side that it touches and not see it: what
/// would come to lie over another does not move.
pub(super) fn free_way(moving: &Polygon, others: &[&Polygon], direction: Vec2, limit: f64) -> f64 {
    let way = seen_way(moving, others, direction, limit);
    let moved = moving.transformed(Affine::translate(direction * way));
    if others.iter().any(|other| lie_over(&moved, other)) {
        0.0
    } else {
        way
    }
}

/// Whether sides of two outlines cross with all ends farther than [`TOUCHING`] from the other's line.
fn lie_over(one: &Polygon, other: &Polygon) -> bool {
    let (bounds, reach) = (one.bounds(), other.bounds());
    if bounds.x1 < reach.x0 || reach.x1 < bounds.x0 || bounds.y1 < reach.y0 || reach.y1 < bounds.y0
    {
        return false;
    }
    let parts = |[a, b]: [Point; 2], ends: [Point; 2]| {
        let heights = ends.map(|end| (b - a).cross(end - a) / a.distance(b));
        heights[0] * heights[1] < 0.0 && heights.iter().all(|height| TOUCHING < height.abs())
    };
    one.sides().any(|first| {
        other
            .sides()
            .any(|second| parts(first, second) && parts(second, first))
    })
}

/// The way until the smaller outline meets a side that lies before it.
fn seen_way(moving: &Polygon, others: &[&Polygon], direction: Vec2, limit: f64) -> f64 {
    let center = moving.bounds().center().to_vec2();
    let smaller =
        Affine::translate(center) * Affine::scale(1.0 - SHRINK) * Affine::translate(-center);
    // Seen so that the way leads along x.
    let turn = Affine::new([
        direction.x,
        -direction.y,
        direction.y,
        direction.x,
        0.0,
        0.0,
    ]);
    let moving = moving.transformed(turn * smaller);
    let bounds = moving.bounds();
    let mut way = limit;
    for other in others {
        let other = other.transformed(turn);
        let reach = other.bounds();
        let is_beside = reach.y1 < bounds.y0 || bounds.y1 < reach.y0;
        if is_beside || reach.x1 < bounds.x0 || bounds.x1 + way < reach.x0 {
            continue;
        }
        for corner in &moving.points {
            way = way.min(first_hit(*corner, &other, 1.0));
        }
        for corner in &other.points {
            way = way.min(first_hit(*corner, &moving, -1.0));
        }
    }
    way.max(0.0)
}

/// Way from a point along `±x` to the first side of a polygon.
fn first_hit(from: Point, polygon: &Polygon, sign: f64) -> f64 {
    let mut nearest = f64::INFINITY;
    for [a, b] in polygon.sides() {
        let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
        let rise = high.y - low.y;
        if from.y < low.y || high.y < from.y || rise <= 0.0 {
            continue;
        }
        let x = low.x + (high.x - low.x) * (from.y - low.y) / rise;
        let way = sign * (x - from.x);
        if -SAME_POINT <= way {
            nearest = nearest.min(way);
        }
    }
    nearest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64, y: f64) -> Polygon {
        let corners = [(x, y), (x + 1.0, y), (x + 1.0, y + 1.0), (x, y + 1.0)];
        Polygon::new(corners.map(Point::from))
    }

    #[test]
    fn a_square_slides_to_the_next_one_and_along_it() {
        let fixed = square(0.0, 0.0);
        let left = Vec2::new(-1.0, 0.0);
        let way = |moving: &Polygon| free_way(moving, &[&fixed], left, 9.0);
        assert!((way(&square(3.0, 0.0)) - 2.0).abs() < 1e-5);
        assert!((way(&square(3.0, 0.5)) - 2.0).abs() < 1e-5);
        assert!((way(&square(3.0, 1.0)) - 9.0).abs() < 1e-12);
        let up = free_way(&square(0.2, -2.0), &[&fixed], Vec2::new(0.0, 1.0), 9.0);
        assert!((up - 1.0).abs() < 1e-5);
    }
}
