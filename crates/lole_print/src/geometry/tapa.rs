//! Blocks of tapa, as they are rubbed over carved boards and painted.

use glam::{Vec2, vec2};
use lole_geom::trig;

use super::{Part, Tint, bar, diamond, filled, polygon, shuffle};
use crate::layout::Dice;
use crate::shape::{closed, count};

/// Blocks of tapa along a side of the repeat.
const BLOCKS: usize = 4;

pub(super) fn parts(dice: &mut Dice) -> Vec<Part> {
    let mut kinds = KINDS;
    shuffle(&mut kinds, dice);
    let mut parts = Vec::new();
    let side = 1.0 / count(BLOCKS);
    for row in 0..BLOCKS {
        for column in 0..BLOCKS {
            let middle = vec2(count(column) + 0.5, count(row) + 0.5) * side;
            // A step of three keeps equal blocks from touching.
            let kind = kinds[(column + 3 * row + usize::from(row % 2 == 1)) % kinds.len()];
            let mut block = Block {
                parts: &mut parts,
                middle,
                half: 0.5 * side,
                tints: TINTS[(row + column) % 2],
            };
            block.draw(
                block.tints.field,
                &[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)],
                0,
            );
            kind(&mut block);
        }
    }
    for line in 0..BLOCKS {
        let at = count(line) * side;
        for (tint, thick) in [(Tint::Ground, 0.020), (Tint::Flower, 0.008)] {
            parts.push(bar(tint, at - 0.5 * thick, thick));
            let corners = [(-0.5, 0.0), (0.5, 0.0), (0.5, 1.0), (-0.5, 1.0)];
            parts.push(polygon(
                tint,
                corners.map(|(across, y)| vec2(at + across * thick, y)),
            ));
        }
    }
    for row in 0..BLOCKS {
        for column in 0..BLOCKS {
            let corner = vec2(count(column), count(row)) * side;
            parts.push(diamond(Tint::Ground, corner, Vec2::splat(0.026)));
            parts.push(diamond(Tint::Flower, corner, Vec2::splat(0.018)));
        }
    }
    parts
}

/// What a block is printed in.
#[derive(Debug, Clone, Copy)]
struct Tints {
    field: Tint,
    ink: Tint,
    other: Tint,
}

/// Of the dark and of the light blocks, which alternate.
const TINTS: [Tints; 2] = [
    Tints {
        field: Tint::Leaf,
        ink: Tint::Ground,
        other: Tint::Flower,
    },
    Tints {
        field: Tint::Shadow,
        ink: Tint::Flower,
        other: Tint::Leaf,
    },
];

/// A block while it is drawn; its corners are at -1 and 1.
struct Block<'a> {
    parts: &'a mut Vec<Part>,
    middle: Vec2,
    half: f32,
    tints: Tints,
}

impl Block<'_> {
    /// A polygon, turned by so many quarters.
    fn draw(&mut self, tint: Tint, corners: &[(f32, f32)], quarters: usize) {
        let corners = corners.iter().map(|&(x, y)| {
            let (x, y) = match quarters % 4 {
                0 => (x, y),
                1 => (-y, x),
                2 => (-x, -y),
                _ => (y, -x),
            };
            self.middle + vec2(x, y) * self.half
        });
        self.parts.push(filled(tint, closed(corners)));
    }
}

/// What may stand in a block.
const KINDS: [fn(&mut Block<'_>); 8] = [
    four_leaves,
    nested_squares,
    pinwheel,
    stripes,
    facing_teeth,
    corner_fans,
    net,
    arrows,
];

/// A flower of four leaves towards the corners.
fn four_leaves(block: &mut Block<'_>) {
    let Tints { field, ink, .. } = block.tints;
    for quarters in 0..4 {
        for (tint, length, width) in [(ink, 0.84, 0.26), (field, 0.70, 0.045)] {
            let leaf: Vec<(f32, f32)> = lens_corners(length, width).collect();
            block.draw(tint, &leaf, quarters);
        }
    }
}

/// Squares within squares, on their corners.
fn nested_squares(block: &mut Block<'_>) {
    let Tints { field, ink, other } = block.tints;
    for (tint, share) in [
        (ink, 0.86),
        (field, 0.68),
        (other, 0.50),
        (field, 0.30),
        (ink, 0.16),
    ] {
        let corners = [(-share, 0.0), (0.0, -share), (share, 0.0), (0.0, share)];
        block.draw(tint, &corners, 0);
    }
}

fn pinwheel(block: &mut Block<'_>) {
    let Tints { field, ink, .. } = block.tints;
    for quarters in 0..4 {
        block.draw(ink, &[(0.0, 0.0), (0.86, 0.0), (0.86, 0.86)], quarters);
        block.draw(field, &[(0.46, 0.14), (0.74, 0.14), (0.74, 0.42)], quarters);
    }
}

/// Stripes that change their way in every quarter.
fn stripes(block: &mut Block<'_>) {
    for quarters in 0..4 {
        for line in 0..4 {
            let y = 0.08 + 0.20 * count(line);
            let stripe = [(0.08, y), (0.84, y), (0.84, y + 0.11), (0.08, y + 0.11)];
            block.draw(block.tints.ink, &stripe, quarters);
        }
    }
}

/// Teeth from two sides.
fn facing_teeth(block: &mut Block<'_>) {
    let Tints { field, ink, .. } = block.tints;
    for quarters in [0, 2] {
        for tooth in 0..4 {
            let left = -0.86 + 0.43 * count(tooth);
            for (tint, low, high) in [(ink, 0.86, 0.10), (field, 0.74, 0.40)] {
                let shrink = 0.473 * (0.86 - low);
                let corners = [
                    (left + shrink, low),
                    (left + 0.215, high),
                    (left + 0.43 - shrink, low),
                ];
                block.draw(tint, &corners, quarters);
            }
        }
    }
}

fn corner_fans(block: &mut Block<'_>) {
    let Tints { field, ink, other } = block.tints;
    for quarters in 0..4 {
        for (tint, share) in [(ink, 0.84), (field, 0.66), (other, 0.48), (field, 0.28)] {
            let fan: Vec<(f32, f32)> = quarter_disc(share).collect();
            block.draw(tint, &fan, quarters);
        }
    }
}

/// Small diamonds in two colors.
fn net(block: &mut Block<'_>) {
    let Tints { ink, other, .. } = block.tints;
    for place in 0..16 {
        let (row, column) = (place / 4, place % 4);
        let (x, y) = (-0.645 + 0.43 * count(column), -0.645 + 0.43 * count(row));
        let tint = if (row + column) % 2 == 0 { ink } else { other };
        let reach = 0.19;
        let corners = [
            (x - reach, y),
            (x, y - reach),
            (x + reach, y),
            (x, y + reach),
        ];
        block.draw(tint, &corners, 0);
    }
}

/// A cross of arrows.
fn arrows(block: &mut Block<'_>) {
    let Tints { ink, other, .. } = block.tints;
    for quarters in 0..4 {
        for step in 0..3 {
            let x = 0.14 + 0.25 * count(step);
            let arrow = [
                (x, -0.30),
                (x + 0.24, 0.0),
                (x, 0.30),
                (x, 0.12),
                (x + 0.10, 0.0),
                (x, -0.12),
            ];
            block.draw(ink, &arrow, quarters);
        }
        let dot = [(0.62, 0.74), (0.74, 0.62), (0.86, 0.74), (0.74, 0.86)];
        block.draw(other, &dot, quarters);
    }
}

/// A leaf from the middle towards a corner.
fn lens_corners(length: f32, width: f32) -> impl Iterator<Item = (f32, f32)> {
    let side = move |step: usize, across: f32| {
        let t = count(step) / 16.0;
        let wide = across * width * trig::sin(std::f32::consts::PI * t);
        let along = length * (0.06 + 0.94 * t);
        let point = vec2(along, along) + vec2(-wide, wide);
        (point.x, point.y)
    };
    let back = (0..=16).rev().map(move |step| side(step, -1.0));
    (0..=16).map(move |step| side(step, 1.0)).chain(back)
}

/// A quarter of a disc in a corner, open to the middle.
fn quarter_disc(radius: f32) -> impl Iterator<Item = (f32, f32)> {
    let arc = (0..=16).map(move |step| {
        let (sin, cos) = trig::sin_cos(std::f32::consts::FRAC_PI_2 * count(step) / 16.0);
        (0.90 - radius * cos, 0.90 - radius * sin)
    });
    arc.chain([(0.90, 0.90)])
}
