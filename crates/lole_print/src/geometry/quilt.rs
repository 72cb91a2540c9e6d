//! Medallions of a Hawaiian quilt, with the lines of echoed stitches around them.

use glam::{Vec2, vec2};
use lole_geom::trig;

use super::{Part, Tint, filled, shuffle};
use crate::layout::Dice;
use crate::shape::{self, Ink, Shape, at_angle, circle, closed, count};

/// Echoed lines around a medallion.
const ECHOES: usize = 9;
/// Distance of two echoes, in repeat units.
const ECHO: f32 = 0.0125;

pub(super) fn parts(dice: &mut Dice) -> Vec<Part> {
    let whim = dice.unit();
    let mut cuts = [
        [(shape::BREADFRUIT_LEAF, 0.90), (shape::TI_LEAF, 0.98)],
        [(shape::PLUMERIA_LEAF, 0.92), (shape::BREADFRUIT_LEAF, 0.80)],
    ];
    shuffle(&mut cuts, dice);
    let medallions = [
        ((vec2(0.5, 0.5), 0.455), Tint::Flower),
        ((Vec2::ZERO, 0.375), Tint::Leaf),
    ];
    let mut parts = Vec::new();
    let mut all = Vec::new();
    for ((place, tint), cut) in medallions.into_iter().zip(cuts) {
        all.push((medallion(place, cut, whim), tint));
    }
    for echo in (1..=ECHOES).rev() {
        let tint = if echo % 2 == 0 {
            Tint::Ground
        } else {
            Tint::Shadow
        };
        for (layers, _) in &all {
            let outlines = layers.iter().filter(|(ink, _)| *ink == Ink::Motif);
            parts.extend(outlines.map(|(_, path)| Part {
                tint,
                path: path.clone(),
                pen: Some(2.0 * ECHO * count(echo)),
            }));
        }
    }
    for (layers, tint) in all {
        parts.extend(layers.into_iter().filter_map(|(ink, path)| {
            let tint = match ink {
                Ink::Motif => tint,
                Ink::Ground => Tint::Ground,
                _ => return None,
            };
            Some(filled(tint, path))
        }));
    }
    parts
}

/// A figure of eight leaves of two kinds and lengths, as scissors cut it from cloth folded three
/// times, around a point and with a radius.
fn medallion(
    (middle, radius): (Vec2, f32),
    leaves: [(Shape, f32); 2],
    whim: f32,
) -> Vec<shape::Layer> {
    let mut layers = Vec::new();
    for eighth in 0..8 {
        let turn = std::f32::consts::TAU * count(eighth) / 8.0;
        let (shape, length) = leaves[eighth % 2];
        let at = middle + at_angle(turn) * 0.10 * radius;
        // One whim for all: folded cloth is cut once.
        let placed = tiny_skia::Transform::from_translate(at.x, at.y)
            .pre_concat(tiny_skia::Transform::from_rotate(turn.to_degrees()))
            .pre_scale(length * radius, length * radius);
        layers.extend(
            (shape.draw)(whim)
                .into_iter()
                .map(|(ink, path)| (ink, path.and_then(|path| path.transform(placed)))),
        );
    }
    // Cloth first, then what is cut out of it.
    layers.sort_by_key(|(ink, _)| *ink != Ink::Motif);
    layers.push((Ink::Motif, circle(middle, 0.36 * radius)));
    let star = closed((0..96).map(|step| {
        let angle = std::f32::consts::TAU * count(step) / 96.0;
        let point = 0.5 + 0.5 * trig::cos(8.0 * angle);
        middle + at_angle(angle) * radius * (0.11 + 0.16 * point)
    }));
    layers.push((Ink::Ground, star));
    layers.push((Ink::Motif, circle(middle, 0.07 * radius)));
    layers
}
