//! The shapes that are scattered over a print: silhouettes as scissors cut them, and the lines drawn
//! into them.
//!
//! A shape that grows starts at the origin and points along +x with length 1; a round one is centered
//! on the origin with radius 1.

mod flower;
mod fruit;
mod leaf;
mod path;
mod sea;

use tiny_skia::Path;

pub(super) use path::{at_angle, circle, closed, count};

/// A filled path and which ink fills it.
pub(super) type Layer = (Ink, Option<Path>);

/// What a path is filled with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ink {
    /// The motif's own color.
    Motif,
    /// The ground, as if cut through.
    Ground,
    /// The other motif color.
    Accent,
    /// Between the motif's color and the ground, for veins.
    Vein,
    /// The ground in a line around the motif, which keeps it apart from what lies below.
    Halo,
}

/// A thing that is drawn.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shape {
    /// Its paths, in drawing order; the argument, 0 to 1, chooses its small irregularities.
    pub draw: fn(f32) -> Vec<Layer>,
    /// Discs that cover it: distance along +x and radius.
    pub discs: &'static [(f32, f32)],
}

const ROUND: &[(f32, f32)] = &[(0.0, 1.0)];
const BROAD: &[(f32, f32)] = &[(0.36, 0.36), (0.70, 0.27)];
const FROND: &[(f32, f32)] = &[
    (0.16, 0.14),
    (0.36, 0.19),
    (0.58, 0.16),
    (0.78, 0.11),
    (0.94, 0.05),
];
const NARROW: &[(f32, f32)] = &[
    (0.12, 0.07),
    (0.28, 0.11),
    (0.45, 0.12),
    (0.62, 0.10),
    (0.78, 0.08),
    (0.93, 0.05),
];

const fn shape(draw: fn(f32) -> Vec<Layer>, discs: &'static [(f32, f32)]) -> Shape {
    Shape { draw, discs }
}

pub(super) const HIBISCUS: Shape = shape(flower::hibiscus, ROUND);
pub(super) const BLOSSOM: Shape = shape(flower::blossom, ROUND);
pub(super) const PLUMERIA: Shape = shape(flower::plumeria, ROUND);
pub(super) const LEHUA: Shape = shape(flower::lehua, &[(0.0, 0.92)]);
pub(super) const BIRD: Shape = shape(
    flower::bird_of_paradise,
    &[(0.1, 0.07), (0.3, 0.08), (0.52, 0.14), (0.78, 0.26)],
);
pub(super) const MONSTERA: Shape = shape(leaf::monstera, BROAD);
pub(super) const BREADFRUIT_LEAF: Shape = shape(leaf::breadfruit, BROAD);
pub(super) const FERN: Shape = shape(leaf::fern, FROND);
pub(super) const PALAPALAI: Shape = shape(
    leaf::palapalai,
    &[
        (0.14, 0.20),
        (0.34, 0.27),
        (0.56, 0.21),
        (0.76, 0.13),
        (0.93, 0.06),
    ],
);
pub(super) const TI_LEAF: Shape = shape(leaf::ti, NARROW);
pub(super) const TI_SPRAY: Shape = shape(leaf::ti_spray, &[(0.34, 0.46), (0.74, 0.34)]);
pub(super) const PLUMERIA_LEAF: Shape = shape(leaf::plumeria, FROND);
pub(super) const LEHUA_SPRIG: Shape = shape(leaf::lehua_sprig, FROND);
pub(super) const PADDLE: Shape = shape(leaf::paddle, FROND);
pub(super) const BREADFRUIT: Shape = shape(fruit::breadfruit, &[(0.0, 0.85)]);
pub(super) const PINEAPPLE: Shape = shape(
    fruit::pineapple,
    &[(0.2, 0.19), (0.42, 0.23), (0.68, 0.22), (0.86, 0.17)],
);
pub(super) const TURTLE: Shape = shape(sea::turtle, ROUND);
pub(super) const WAVE: Shape = shape(sea::wave, &[(0.0, 0.95)]);
