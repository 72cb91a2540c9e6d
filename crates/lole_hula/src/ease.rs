//! Smooth curves that movements are made of; all have continuous second derivatives.

use std::f32::consts::TAU;

use lole_geom::trig;

/// Minimum-jerk ramp: 0 up to `0`, 1 from `1`, at rest at both ends (`10u³ − 15u⁴ + 6u⁵`).
pub(super) fn ramp(u: f32) -> f32 {
    let u = u.clamp(0.0, 1.0);
    u * u * u * (10.0 + u * (6.0 * u - 15.0))
}

/// [`ramp`] from count `from` to count `to`.
pub(super) fn ramp_between(count: f32, from: f32, to: f32) -> f32 {
    ramp((count - from) / (to - from))
}

/// Hump of height 1 over `0..=1`, at rest at both ends (`64u³(1 − u)³`).
pub(super) fn hump(u: f32) -> f32 {
    let u = u.clamp(0.0, 1.0);
    let v = u * (1.0 - u);
    64.0 * v * v * v
}

/// `|x|` with its corner rounded between −1 and 1 (`3/8 + 3x²/4 − x⁴/8` there).
pub(super) fn rounded_abs(x: f32) -> f32 {
    let a = x.abs();
    if a >= 1.0 {
        return a;
    }
    let square = x * x;
    0.375 + square * (0.75 - 0.125 * square)
}

/// 0 up to about `0` and `x` from there, with its corner rounded between −`width` and `width`.
pub(super) fn hinge(x: f32, width: f32) -> f32 {
    0.5 * (x + width * rounded_abs(x / width))
}

/// Integral over −1 to `x` of the raised-cosine dip `(1 + cos πu)/2`, whose whole area is 1.
pub(super) fn dip_area(x: f32) -> f32 {
    let u = x.clamp(-1.0, 1.0);
    0.5 * (u + 1.0 + trig::sin(u * TAU / 2.0) * 2.0 / TAU)
}

/// The smaller of two lengths, rounded where they differ by less than `width`; never larger than
/// either. The cubic keeps the second derivative continuous.
pub(super) fn soft_min(a: f32, b: f32, width: f32) -> f32 {
    let overlap = ((width - (a - b).abs()) / width).max(0.0);
    a.min(b) - overlap * overlap * overlap * width / 6.0
}

/// The larger of two lengths, rounded like [`soft_min`]; never smaller than either.
pub(super) fn soft_max(a: f32, b: f32, width: f32) -> f32 {
    -soft_min(-a, -b, width)
}

/// Straight-line mixture: `a` at weight 0, `b` at weight 1.
pub(super) fn mix(a: f32, b: f32, weight: f32) -> f32 {
    a + (b - a) * weight
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ramps_start_and_end_at_rest() {
        assert_eq!(
            (ramp(-1.0), ramp(0.0), ramp(1.0), ramp(2.0)),
            (0.0, 0.0, 1.0, 1.0)
        );
        assert!(ramp(0.01) < 1e-5 && 1.0 - ramp(0.99) < 1e-5);
        assert!((hump(0.5) - 1.0).abs() < 1e-6 && hump(0.01) < 1e-4);
    }

    #[test]
    fn the_rounded_corner_meets_the_lines_with_equal_slope() {
        let step = 1e-3;
        let inner = (rounded_abs(1.0) - rounded_abs(1.0 - step)) / step;
        assert!((inner - 1.0).abs() < 1e-3, "{inner}");
        assert_eq!(rounded_abs(-3.0), 3.0);
    }

    #[test]
    fn the_hinge_opens_with_slope_one() {
        assert_eq!((hinge(-3.0, 0.5), hinge(3.0, 0.5)), (0.0, 3.0));
        assert!((hinge(0.0, 0.5) - 0.09375).abs() < 1e-6);
    }

    #[test]
    fn the_soft_minimum_is_below_both_and_exact_far_away() {
        assert_eq!(soft_min(1.0, 2.0, 0.1), 1.0);
        let near = soft_min(1.0, 1.01, 0.1);
        assert!(near < 1.0 && near > 0.98, "{near}");
    }

    #[test]
    fn the_dip_has_unit_area() {
        assert!(dip_area(-1.0).abs() < 1e-6 && (dip_area(1.0) - 1.0).abs() < 1e-6);
        assert!((dip_area(0.0) - 0.5).abs() < 1e-6);
    }
}
