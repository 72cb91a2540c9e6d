//! Bands of kapa, as bamboo stamps (ʻohe kāpala) print them.

use glam::{Vec2, vec2};
use lole_geom::trig;
use tiny_skia::Path;

use super::{Part, Tint, bar, diamond, filled, polygon, shuffle};
use crate::layout::Dice;
use crate::shape::{circle, closed, count};

/// Units of kapa in a repeat.
const KAPA_UNITS: f32 = 48.0;

pub(super) fn parts(dice: &mut Dice) -> Vec<Part> {
    let unit = 1.0 / KAPA_UNITS;
    let mut parts = Vec::new();
    // The ribs that the carved beater leaves.
    for rib in 0..96 {
        let left = (count(rib) + 0.5) / 96.0;
        let corners = [0.0, 0.0028, 0.0028, 0.0].map(|wide| left + wide);
        let [a, b, c, d] = corners;
        parts.push(polygon(
            Tint::Shadow,
            [vec2(a, 0.0), vec2(b, 0.0), vec2(c, 1.0), vec2(d, 1.0)],
        ));
    }
    let mut wide = [Band::Diamonds, Band::Chevrons, Band::Crosses, Band::Fans];
    shuffle(&mut wide, dice);
    let first = dice.unit() < 0.5;
    let mut top = dice.unit();
    for (place, (band, units)) in wide.into_iter().zip([7.4, 4.8, 6.4, 5.0]).enumerate() {
        let dark = (place % 2 == 0) == first;
        let (field, ink) = if dark {
            (Tint::Leaf, Tint::Ground)
        } else {
            (Tint::Flower, Tint::Leaf)
        };
        // Lines, teeth, the field with its figures, teeth, lines, open ground: 6.1 units beside it.
        parts.push(bar(field, top + 0.2 * unit, 0.32 * unit));
        parts.push(bar(field, top + 0.8 * unit, 0.18 * unit));
        teeth(&mut parts, field, [top + 2.6 * unit, top + 1.2 * unit], 32);
        let low = top + (2.6 + units) * unit;
        parts.push(bar(field, top + 2.6 * unit, units * unit));
        let strip = Strip {
            top: top + 2.6 * unit,
            low,
        };
        band.stamp(&mut parts, strip, ink);
        teeth(&mut parts, field, [low, low + 1.4 * unit], 32);
        parts.push(bar(field, low + 1.6 * unit, 0.18 * unit));
        parts.push(bar(field, low + 2.05 * unit, 0.32 * unit));
        top = low + 3.5 * unit;
    }
    parts
}

/// Figures in a band of kapa.
#[derive(Debug, Clone, Copy)]
enum Band {
    Diamonds,
    Chevrons,
    Crosses,
    Fans,
}

impl Band {
    fn stamp(self, parts: &mut Vec<Part>, strip: Strip, ink: Tint) {
        let (middle, half) = (strip.middle(), strip.half());
        match self {
            Self::Diamonds => {
                let wide = 1.0 / 10.0;
                for place in 0..10 {
                    let at = vec2((count(place) + 0.5) * wide, middle);
                    for (share, tint) in [(0.90, ink), (0.66, Tint::Flower), (0.40, Tint::Ground)] {
                        parts.push(diamond(tint, at, vec2(0.5 * wide, half) * share));
                    }
                    let between = vec2(count(place) * wide, middle);
                    for side in [-1.0, 1.0] {
                        let at = between + vec2(0.0, side * 0.62 * half);
                        parts.push(filled(ink, circle(at, 0.15 * half)));
                    }
                }
            }
            Self::Chevrons => {
                for (line, tint) in [ink, Tint::Ground, ink].into_iter().enumerate() {
                    zigzag(parts, tint, strip, count(line));
                }
            }
            Self::Crosses => {
                for place in 0..12 {
                    cross(parts, ink, strip, place);
                }
            }
            Self::Fans => {
                for place in 0..12 {
                    let at = vec2((count(place) + 0.5) / 12.0, strip.low - 0.16 * half);
                    for (share, tint) in [
                        (0.96, ink),
                        (0.76, Tint::Flower),
                        (0.56, ink),
                        (0.34, Tint::Ground),
                    ] {
                        parts.push(filled(tint, fan(at, share * vec2(0.5 / 12.0, 1.62 * half))));
                    }
                }
            }
        }
    }
}

/// What a band takes of the repeat, all across.
#[derive(Debug, Clone, Copy)]
struct Strip {
    /// Its edges, y down.
    top: f32,
    low: f32,
}

impl Strip {
    fn middle(self) -> f32 {
        0.5 * (self.top + self.low)
    }

    fn half(self) -> f32 {
        0.5 * (self.low - self.top)
    }
}

/// One of twelve crosses, or the diamonds between two, and the slit beside it.
fn cross(parts: &mut Vec<Part>, ink: Tint, strip: Strip, place: usize) {
    let (middle, half) = (strip.middle(), strip.half());
    let wide = 1.0 / 12.0;
    let at = vec2((count(place) + 0.5) * wide, middle);
    if place.is_multiple_of(2) {
        for side in [-1.0, 1.0] {
            let reach = vec2(0.36 * wide, side * 0.66 * half);
            let across = vec2(0.085 * wide, 0.0);
            parts.push(polygon(
                ink,
                [
                    at - reach - across,
                    at - reach + across,
                    at + reach + across,
                    at + reach - across,
                ],
            ));
        }
    } else {
        for level in [-0.5, 0.0, 0.5] {
            let at = at + vec2(0.0, level * half);
            parts.push(diamond(ink, at, vec2(0.25 * wide, 0.22 * half)));
        }
    }
    let edge = vec2(count(place) * wide, middle);
    parts.push(diamond(Tint::Ground, edge, vec2(0.045 * wide, 0.78 * half)));
}

/// Half an oval that stands on `base`.
fn fan(base: Vec2, reach: Vec2) -> Option<Path> {
    closed((0..=24).map(|step| {
        let (sin, cos) = trig::sin_cos(std::f32::consts::PI * count(step) / 24.0);
        base + vec2(cos, -sin) * reach
    }))
}

/// Shark's teeth (niho manō) from a base to where they point, side by side all across.
fn teeth(parts: &mut Vec<Part>, tint: Tint, [base, tip]: [f32; 2], tooth_count: usize) {
    let wide = 1.0 / count(tooth_count);
    for tooth in 0..tooth_count {
        let left = count(tooth) * wide;
        // Over the base by a hair, so that no gap shows.
        let under = base - 0.05 * (tip - base);
        parts.push(polygon(
            tint,
            [
                vec2(left, under),
                vec2(left + 0.5 * wide, tip),
                vec2(left + wide, under),
            ],
        ));
    }
}

/// A zigzag line in a strip, the first of them uppermost.
fn zigzag(parts: &mut Vec<Part>, tint: Tint, strip: Strip, line: f32) {
    let half = strip.half();
    let wide = 1.0 / 12.0;
    let thick = 0.22 * half;
    let level = strip.top + (0.20 + 0.42 * line) * half;
    for place in 0..24 {
        let up = place % 2 == 0;
        let left = 0.5 * wide * count(place);
        let [from, to] =
            if up { [0.62, 0.0] } else { [0.0, 0.62] }.map(|share| level + share * half);
        let right = left + 0.5 * wide;
        parts.push(polygon(
            tint,
            [
                vec2(left, from),
                vec2(right, to),
                vec2(right, to + thick),
                vec2(left, from + thick),
            ],
        ));
    }
}
