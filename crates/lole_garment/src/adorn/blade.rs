//! Leaves: blades with a fold along the middle.

use glam::{Vec2, Vec3};
use lole_geom::trig;

use super::chosen::chance;
use super::shape::Shape;

/// A leaf in a space of its own: it grows along `+Z` from the origin, its face towards `+Y`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Blade {
    /// From stem to tip [m].
    pub(crate) length: f32,
    /// At its widest [m].
    pub(crate) width: f32,
    /// How far its halves are folded up, rise over half the width.
    pub(crate) fold: f32,
    /// How far its tip bends back, drop over length.
    pub(crate) droop: f32,
    pub(crate) color: Vec3,
}

/// Half the width of a leaf over its largest, by the share of its length: pointed at both ends, widest
/// before the middle.
pub(crate) fn half_width(share: f32) -> f32 {
    let rise = 1.0 - (1.0 - share / 0.42).clamp(0.0, 1.0).powi(2);
    let fall = ((share - 0.42) / 0.58).clamp(0.0, 1.0);
    rise * (1.0 - fall * fall)
}

impl Blade {
    /// Its shape, `rows` quads long.
    pub(crate) fn shape(&self, rows: usize) -> Shape {
        Shape::sheet([rows, 2], |along, across| {
            let side = 2.0 * across - 1.0;
            let half = 0.5 * self.width * half_width(along).max(0.02);
            let bend = along * along * self.droop;
            let place = Vec3::new(
                // Counter-clockwise from above.
                half * side,
                half * side.abs() * self.fold - self.length * bend,
                self.length * along * (1.0 - 0.3 * bend),
            );
            // Paler along the rib, deeper at the root.
            let shade = 0.82 + 0.22 * along + if side == 0.0 { 0.16 } else { 0.0 };
            (place, (self.color * shade).clamp(Vec3::ZERO, Vec3::ONE))
        })
    }

    /// The same, a little different from its siblings.
    pub(crate) fn varied(&self, one: usize) -> Self {
        let about = |salt: usize, spread: f32| 1.0 + spread * chance(one, salt);
        let light = about(3, 0.16);
        Self {
            length: self.length * about(1, 0.12),
            width: self.width * about(2, 0.12),
            droop: self.droop + 0.10 * chance(one, 4),
            color: self.color * Vec3::new(light * about(5, 0.10), light, light * about(6, 0.08)),
            ..*self
        }
    }
}

/// A petal in a space of its own: it grows along `+Z`, its face towards `+Y`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Petal {
    /// From the heart to the rim [m].
    pub(crate) length: f32,
    /// At its widest [m].
    pub(crate) width: f32,
    /// Rise of its rim over its length.
    pub(crate) cup: f32,
    /// How far one edge is turned over the next petal, rise over half the width.
    pub(crate) lean: f32,
    /// How much its rim waves, over its width.
    pub(crate) ruffle: f32,
    /// At the heart, in the middle and at the rim.
    pub(crate) colors: [Vec3; 3],
}

impl Petal {
    /// Its shape, so many quads long and wide.
    pub(crate) fn shape(&self, [rows, columns]: [usize; 2]) -> Shape {
        Shape::sheet([rows, columns], |along, across| {
            let side = 2.0 * across - 1.0;
            // Egg-shaped: broadest beyond the middle, round at the rim.
            let egg = trig::sin(std::f32::consts::PI * (0.08 + 0.80 * along)).max(0.0);
            let half = 0.5 * self.width * egg.sqrt() * (0.28 + 0.72 * along).min(1.0);
            let rim = 1.0 - 0.18 * side * side * along;
            let wave = self.ruffle
                * self.width
                * along
                * along
                * trig::sin(5.0 * std::f32::consts::PI * across);
            let flat = Vec2::new(half * side, self.length * along * rim);
            let rise = self.length * self.cup * along * along + half * side * self.lean + wave;
            let [heart, middle, edge] = self.colors;
            let color = if along < 0.5 {
                heart.lerp(middle, 2.0 * along)
            } else {
                middle.lerp(edge, 2.0 * along - 1.0)
            };
            (Vec3::new(flat.x, rise, flat.y), color)
        })
    }
}
