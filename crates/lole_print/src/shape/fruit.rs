//! Fruit.

use glam::{Vec2, vec2};
use lole_geom::trig;

use super::path::{at_angle, both_sides, closed, count, hump, lens, spine};
use super::{Ink, Layer};

/// A breadfruit: round, with the pattern of its rind, on a short stalk.
pub(super) fn breadfruit(whim: f32) -> Vec<Layer> {
    let outline = (0..120).map(|step| {
        let angle = std::f32::consts::TAU * count(step) / 120.0;
        at_angle(angle) * (0.64 + 0.02 * trig::sin(3.0 * angle + 6.0 * whim))
    });
    let path = closed(outline);
    let mut layers = vec![
        (Ink::Halo, path.clone()),
        (
            Ink::Accent,
            spine(vec2(-0.84, 0.07), vec2(-0.45, 0.0), 0.06),
        ),
        (Ink::Motif, path),
    ];
    // Sunflower spacing: even, without rows.
    for index in 1..70 {
        let radius = 0.071 * count(index).sqrt();
        let at = at_angle(2.399_963 * count(index)) * radius;
        layers.push((
            Ink::Ground,
            lens(at, 2.399_963 * count(index), 0.034, 0.021),
        ));
    }
    layers
}

/// A pineapple: a body of eyes between crossing spirals, under its crown.
pub(super) fn pineapple(whim: f32) -> Vec<Layer> {
    const MIDDLE: f32 = 0.33;
    const HALF: f32 = 0.31;
    const GIRTH: f32 = 0.215;
    let mut layers = Vec::new();
    // The crown: from the back and the sides to the front.
    for (lean, length) in [
        (0.95, 0.25),
        (-0.95, 0.25),
        (0.62, 0.34),
        (-0.62, 0.34),
        (0.30, 0.39),
        (-0.30, 0.39),
        (0.02, 0.42),
        (0.46, 0.24),
        (-0.46, 0.24),
        (0.0, 0.26),
    ] {
        let lean = lean + 0.12 * (whim - 0.5);
        let base = vec2(MIDDLE + 0.88 * HALF, 0.09 * lean);
        let leaf = both_sides(20, |t, side| {
            let droop = 0.14 * lean * t * t;
            base + at_angle(0.72 * lean).rotate(vec2(
                length * t,
                droop + side * 0.046 * hump(0.12 + 0.88 * t, 0.55, 0.9),
            ))
        });
        layers.push((Ink::Halo, leaf.clone()));
        layers.push((Ink::Accent, leaf));
    }
    for lean in [-2.45, 2.45, -2.85, 2.85, 3.1] {
        let base = vec2(MIDDLE - 0.86 * HALF, 0.0);
        let leaf = both_sides(12, |t, side| {
            base + at_angle(lean).rotate(vec2(0.15 * t, side * 0.034 * hump(t, 0.6, 0.9)))
        });
        layers.push((Ink::Accent, leaf));
    }
    let body = |t: f32, side: f32| {
        let along = -trig::cos(std::f32::consts::PI * t);
        let broad = GIRTH * trig::powf((1.0 - along * along).max(0.0), 0.40);
        vec2(MIDDLE + HALF * along, side * broad)
    };
    let outline = both_sides(50, body);
    layers.push((Ink::Halo, outline.clone()));
    layers.push((Ink::Motif, outline));
    // Places on the round body: rows up it, and turns around it from edge to edge.
    let place = |row: f32, turn: f32| {
        let along = -1.0 + row / 4.5;
        let broad = GIRTH * trig::powf((1.0 - along * along).max(0.0), 0.40);
        vec2(MIDDLE + HALF * along, broad * trig::sin(turn))
    };
    let step = 0.52;
    for row in 0..9_i8 {
        for turn in -3..=3_i8 {
            let half = if row % 2 == 0 { 0.0 } else { 0.5 };
            let (row, turn) = (f32::from(row), (f32::from(turn) + half) * step);
            if 1.50 < turn.abs() {
                continue;
            }
            for side in [-0.5, 0.5] {
                let next = (turn + side * step).clamp(-1.55, 1.55);
                let line = |t: f32| place(row + t, turn + (next - turn) * t);
                layers.push((Ink::Ground, even_line(line, 0.0062)));
            }
            if 0.5 < row && turn.abs() < 1.2 {
                let eye = place(row + 0.95, turn);
                layers.push((Ink::Accent, lens(eye, 0.0, 0.021, 0.015)));
            }
        }
    }
    layers
}

/// A line of one width.
fn even_line(line: impl Fn(f32) -> Vec2, half_width: f32) -> Option<tiny_skia::Path> {
    both_sides(4, |t, side| {
        let across = (line(t + 0.02) - line(t - 0.02)).perp().normalize_or_zero();
        line(t) + across * side * half_width
    })
}
