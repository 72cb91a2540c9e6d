//! Crossings counted with exact predicates (Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic
//! and Fast Robust Geometric Predicates").
#![allow(dead_code, reason = "every test file uses some of it")]

use glam::Vec3;
use robust::{Coord3D, orient3d};

/// Edges that go through triangles with which they share no corner: through the inside, exactly.
pub(crate) fn crossing_count(triangles: &[[u32; 3]], positions: &[Vec3]) -> usize {
    let mut edges: Vec<[u32; 2]> = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    edges.sort_unstable();
    edges.dedup();
    let at = |particle: u32| positions[particle as usize];
    let mut boxes: Vec<([Vec3; 2], [u32; 3])> = triangles
        .iter()
        .map(|&triangle| {
            let [a, b, c] = triangle.map(at);
            ([a.min(b).min(c), a.max(b).max(c)], triangle)
        })
        .collect();
    boxes.sort_by(|one, other| one.0[0].x.total_cmp(&other.0[0].x));
    let widest = boxes
        .iter()
        .map(|(it, _)| it[1].x - it[0].x)
        .fold(0.0, f32::max);
    let mut count = 0;
    for edge in edges {
        let [p, q] = edge.map(at);
        let (low, high) = (p.min(q), p.max(q));
        let first = boxes.partition_point(|(it, _)| it[0].x < low.x - 1.001 * widest - 1.0e-6);
        for (bounds, triangle) in &boxes[first..] {
            if high.x < bounds[0].x {
                break;
            }
            let meets = bounds[0].cmple(high).all() && low.cmple(bounds[1]).all();
            let is_apart = edge.iter().all(|end| !triangle.contains(end));
            if meets && is_apart && crosses([p, q], triangle.map(at)) {
                count += 1;
            }
        }
    }
    count
}

fn side([a, b, c]: [Vec3; 3], p: Vec3) -> f64 {
    let point = |at: Vec3| Coord3D {
        x: f64::from(at.x),
        y: f64::from(at.y),
        z: f64::from(at.z),
    };
    orient3d(point(a), point(b), point(c), point(p))
}

/// Whether a segment goes through the inside of a triangle.
pub(crate) fn crosses([p, q]: [Vec3; 2], [a, b, c]: [Vec3; 3]) -> bool {
    let ends = [p, q].map(|end| side([a, b, c], end));
    if 0.0 <= ends[0] * ends[1].signum() {
        return false;
    }
    let around = [[a, b], [b, c], [c, a]].map(|[from, to]| side([from, to, p], q));
    around.iter().all(|&it| 0.0 < it) || around.iter().all(|&it| it < 0.0)
}
