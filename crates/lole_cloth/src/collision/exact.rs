//! Whether an edge goes through a triangle, whatever rounding says: by predicates whose sign is exact
//! (Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates").

use glam::Vec3;
use robust::{Coord3D, orient3d};

/// Whether a segment goes through the inside of a triangle; what touches it does not.
pub(crate) fn goes_through([start, end]: [Vec3; 2], [a, b, c]: [Vec3; 3]) -> bool {
    let side = |[a, b, c]: [Vec3; 3], at: Vec3| {
        let [a, b, c, at] = [a, b, c, at].map(|place| {
            let [x, y, z] = place.to_array().map(f64::from);
            Coord3D { x, y, z }
        });
        orient3d(a, b, c, at)
    };
    let ends = [start, end].map(|end| side([a, b, c], end));
    if 0.0 <= ends[0] * ends[1].signum() {
        return false;
    }
    let around = [[a, b], [b, c], [c, a]].map(|[from, to]| side([from, to, start], end));
    around.iter().all(|&it| 0.0 < it) || around.iter().all(|&it| it < 0.0)
}
