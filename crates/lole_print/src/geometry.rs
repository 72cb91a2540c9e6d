//! Ordered prints: bands of kapa, blocks of tapa, medallions of a quilt, lines of surf. All sizes
//! divide the repeat, so that it has no edge.

mod kapa;
mod quilt;
mod tapa;

use glam::{Vec2, vec2};
use lole_geom::trig;
use tiny_skia::Path;

use super::layout::Dice;
use super::shape::{closed, count};

/// An ordered print.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Geometry {
    /// Bands around the skirt, as bamboo stamps (ʻohe kāpala) print them on kapa.
    Kapa,
    /// Blocks, as rubbed and painted tapa has them.
    Tapa,
    /// Medallions cut from folded cloth, with the lines of echoed stitches around them.
    Quilt,
    /// Lines of surf, below other things.
    Surf,
}

/// One of the print's colors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Tint {
    /// The ground.
    Ground,
    /// The flowers.
    Flower,
    /// The leaves.
    Leaf,
    /// The quiet layer.
    Shadow,
}

/// Something to fill, or to go along with a round pen.
pub(super) struct Part {
    pub(super) tint: Tint,
    pub(super) path: Option<Path>,
    /// Width of the pen in repeat units; filled where `None`.
    pub(super) pen: Option<f32>,
}

impl Geometry {
    /// What is drawn, in order, in repeat units from 0 to 1, y down. What goes over an edge comes in on
    /// the other side.
    pub(super) fn parts(self, seed: u64) -> Vec<Part> {
        let mut dice = Dice::new(seed);
        match self {
            Self::Kapa => kapa::parts(&mut dice),
            Self::Tapa => tapa::parts(&mut dice),
            Self::Quilt => quilt::parts(&mut dice),
            Self::Surf => surf(&mut dice),
        }
    }
}

fn filled(tint: Tint, path: Option<Path>) -> Part {
    Part {
        tint,
        path,
        pen: None,
    }
}

fn polygon<const N: usize>(tint: Tint, corners: [Vec2; N]) -> Part {
    filled(tint, closed(corners))
}

fn diamond(tint: Tint, at: Vec2, half: Vec2) -> Part {
    polygon(
        tint,
        [
            at + vec2(-half.x, 0.0),
            at + vec2(0.0, -half.y),
            at + vec2(half.x, 0.0),
            at + vec2(0.0, half.y),
        ],
    )
}

/// A bar across the whole repeat and no further: where two lie over each other, their soft edges
/// would be printed twice.
fn bar(tint: Tint, top: f32, height: f32) -> Part {
    polygon(
        tint,
        [
            vec2(0.0, top),
            vec2(1.0, top),
            vec2(1.0, top + height),
            vec2(0.0, top + height),
        ],
    )
}

fn surf(dice: &mut Dice) -> Vec<Part> {
    let mut parts = Vec::new();
    for line in 0..10 {
        let level = (count(line) + 0.5) / 10.0;
        let (phase, lean) = (dice.turn(), dice.turn());
        for (below, thick) in [(0.0, 0.016), (0.030, 0.006)] {
            let wave = |x: f32| {
                let turn = std::f32::consts::TAU * x;
                let swell = trig::sin(2.0 * turn + phase) + 0.5 * trig::sin(3.0 * turn + lean);
                vec2(x, level + below + 0.017 * swell)
            };
            let xs = |step: usize| count(step) / 150.0;
            let upper = (0..=150).map(|step| wave(xs(step)));
            let lower = (0..=150).rev();
            let lower = lower.map(|step| wave(xs(step)) + vec2(0.0, thick));
            parts.push(filled(Tint::Shadow, closed(upper.chain(lower))));
        }
    }
    parts
}

/// Puts a short list into an order of chance.
fn shuffle<T>(list: &mut [T], dice: &mut Dice) {
    for last in (1..list.len()).rev() {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a share of a short list"
        )]
        let other = (dice.unit() * count(last + 1)) as usize;
        list.swap(last, other.min(last));
    }
}
