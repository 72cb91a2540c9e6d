//! What shapes are put together from.

use glam::{Vec2, vec2};
use lole_geom::trig;
use tiny_skia::{Path, PathBuilder};

/// Unit vector at an angle [rad].
pub(crate) fn at_angle(angle: f32) -> Vec2 {
    let (sin, cos) = trig::sin_cos(angle);
    Vec2::new(cos, sin)
}

/// A petal from the origin, fuller on one side.
pub(super) fn lens_bent(turn: f32, length: f32, width: f32) -> Option<Path> {
    let edge = |t: f32, side: f32| {
        let full = if 0.0 < side { 1.25 } else { 0.75 };
        let across = side
            * full
            * width
            * trig::powf(
                trig::sin(std::f32::consts::PI * trig::powf(t, 1.3)).max(0.0),
                0.7,
            );
        at_angle(turn).rotate(vec2(length * t, across))
    };
    both_sides(30, edge)
}

/// A pointed oval of half length and half width around `middle`.
pub(super) fn lens(middle: Vec2, turn: f32, half_length: f32, half_width: f32) -> Option<Path> {
    let edge = |t: f32, side: f32| {
        let along = 2.0 * t - 1.0;
        let across = side * half_width * (1.0 - along * along);
        middle + at_angle(turn).rotate(vec2(half_length * along, across))
    };
    both_sides(16, edge)
}

/// An outline that runs out along one side and back along the other: `edge` of a share of the way and
/// of the side, 1 or -1.
pub(super) fn both_sides(steps: usize, edge: impl Fn(f32, f32) -> Vec2) -> Option<Path> {
    let upper = (0..=steps).map(|step| edge(count(step) / count(steps), 1.0));
    let lower = (0..=steps).rev();
    let lower = lower.map(|step| edge(count(step) / count(steps), -1.0));
    closed(upper.chain(lower))
}

/// A disc.
pub(crate) fn circle(middle: Vec2, radius: f32) -> Option<Path> {
    PathBuilder::from_circle(middle.x, middle.y, radius)
}

/// A straight line that tapers from `width` to a point.
pub(super) fn spine(from: Vec2, to: Vec2, width: f32) -> Option<Path> {
    curve_spine(|t| from.lerp(to, t), width)
}

/// A curve over 0 to 1 that tapers from half width `width` to a fifth of it.
pub(super) fn curve_spine(curve: impl Fn(f32) -> Vec2, width: f32) -> Option<Path> {
    both_sides(20, |t, side| {
        let across = (curve(t + 0.01) - curve(t - 0.01))
            .perp()
            .normalize_or_zero();
        curve(t) + across * side * width * (1.0 - 0.8 * t)
    })
}

/// A closed polygon.
pub(crate) fn closed(points: impl IntoIterator<Item = Vec2>) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for point in points {
        if builder.is_empty() {
            builder.move_to(point.x, point.y);
        } else {
            builder.line_to(point.x, point.y);
        }
    }
    builder.close();
    builder.finish()
}

/// Smooth step from 0 to 1 over `0..=1`.
pub(crate) fn smooth(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// A hump over `0..=1` that is 0 at both ends: `sin(π t^lean)^round`. A lean above 1 moves its top
/// towards 1, a roundness below 1 makes it fuller.
pub(super) fn hump(t: f32, lean: f32, round: f32) -> f32 {
    let arch = trig::sin(std::f32::consts::PI * trig::powf(t.clamp(0.0, 1.0), lean));
    trig::powf(arch.max(0.0), round)
}

/// A small index as a number.
#[expect(clippy::cast_precision_loss, reason = "a few hundred points at most")]
pub(crate) fn count(index: usize) -> f32 {
    index as f32
}
