//! Palms, trees and ferns, as a painter of backdrops paints them: dark strokes first, light ones over them.

use super::canvas::{Canvas, Ink, Place};
use glam::Vec2;
use lole_geom::chance::Chance;
use lole_geom::trig;
use std::f32::consts::{FRAC_PI_2, PI, TAU};
use tiny_skia::{Path, PathBuilder, Rect};

/// From the darkest to the lightest leaf.
pub(super) type Greens = [Ink; 4];

/// How a coconut palm grows, and in what light.
#[derive(Debug, Clone, Copy)]
pub(super) struct Palm {
    /// Where its foot is.
    pub(super) place: Place,
    /// How high its crown is [m].
    pub(super) height: f32,
    /// How far its crown is to the right of its foot [m].
    pub(super) lean: f32,
    /// Its fronds.
    pub(super) greens: Greens,
    /// Its trunk, in shadow and in light.
    pub(super) trunk: [Ink; 2],
    /// The side that light comes from: -1 left, 1 right.
    pub(super) lit: f32,
    /// Another seed is another palm.
    pub(super) seed: u64,
}

impl Palm {
    /// Paints it.
    pub(super) fn paint(&self, canvas: &mut Canvas) {
        let mut chance = Chance::new(self.seed);
        self.trunk(canvas);
        let crown = Vec2::new(self.lean, self.height);
        let reach = 0.30 * self.height.min(13.0) + 0.9;
        // Fronds around the crown: those behind first and dark, the upright ones last and light.
        let count: u16 = 24;
        for index in 0..count {
            let share = f32::from(index) / f32::from(count - 1);
            let around = chance.between(0.0, TAU);
            let rise = -0.55 + 1.75 * share + chance.between(-0.25, 0.25);
            let length = reach * chance.between(0.8, 1.15) * (1.05 - 0.25 * share);
            let side = trig::cos(around);
            let toward_light = side * self.lit;
            let tone = share * 1.6 + toward_light * 0.9 + chance.between(-0.5, 0.5) + 0.8;
            let ink = self.greens[rounded(tone)];
            self.frond(canvas, (crown, [side, rise], length), ink, &mut chance);
        }
        for index in 0..7_u8 {
            let around = f32::from(index) * 0.9 + 0.4;
            let at = crown + Vec2::new(trig::cos(around) * 0.32, -0.32 - 0.1 * trig::sin(around));
            if let Some(path) = PathBuilder::from_circle(at.x, at.y, 0.15) {
                canvas.fill(&path, self.trunk[usize::from(index % 2)], self.place);
            }
        }
    }

    /// The trunk: thick at its foot, bent toward its crown.
    fn trunk(&self, canvas: &mut Canvas) {
        for (ink, left, right) in [(self.trunk[0], -1.0, 1.0), (self.trunk[1], 0.15, 0.85)] {
            let mut sides = [Vec::new(), Vec::new()];
            for step in 0..=24_u8 {
                let share = f32::from(step) / 24.0;
                let foot = 0.12 * (1.0 - share) * (1.0 - share) * (1.0 - share);
                let half = 0.15 + foot - 0.05 * share;
                let middle = Vec2::new(
                    self.lean * share * (0.45 + 0.55 * share),
                    self.height * share,
                );
                let ring = 0.008 * if step % 2 == 0 { 1.0 } else { -1.0 };
                let (a, b) = if self.lit > 0.0 {
                    (left, right)
                } else {
                    (-right, -left)
                };
                sides[0].push(middle + Vec2::new(a * half - ring, 0.0));
                sides[1].push(middle + Vec2::new(b * half + ring, 0.0));
            }
            let [first, second] = sides;
            let around = first.into_iter().chain(second.into_iter().rev());
            if let Some(path) = polygon(around) {
                canvas.fill(&path, ink, self.place);
            }
        }
    }

    /// A frond: a rib that bends down under its weight, and leaflets that hang from it.
    fn frond(
        &self,
        canvas: &mut Canvas,
        (from, [side, rise], length): (Vec2, [f32; 2], f32),
        ink: Ink,
        chance: &mut Chance,
    ) {
        let (sin, cos) = trig::sin_cos(rise);
        let droop = 0.42 + 0.30 * (1.0 - rise.max(0.0));
        let point = |share: f32| {
            let out = length * share * (0.35 + 0.65 * cos);
            let up = length * share * sin - length * droop * share * share;
            from + Vec2::new(side * out, up)
        };
        let mut leaflets = PathBuilder::new();
        let count: u16 = 46;
        for index in 2..count {
            let share = f32::from(index) / f32::from(count);
            let root = point(share);
            let ahead = (point(share + 0.02) - root).normalize_or(Vec2::X);
            let long = length * 0.24 * trig::sin(PI * (0.12 + 0.83 * share)).max(0.1);
            for wing in [-1.0_f32, 1.0] {
                let across = ahead.perp() * wing;
                // Seen from the side, one wing hangs and the other one stands up a little before it hangs.
                let out = (ahead * 0.62 + across * (0.55 + 0.2 * side.abs()))
                    * long
                    * chance.between(0.8, 1.1);
                let hang = Vec2::new(0.0, -long * chance.between(0.35, 0.65));
                let end = root + out + hang;
                let bend = root + out * 0.7 + hang * 0.25;
                leaflets.move_to(root.x, root.y);
                leaflets.quad_to(bend.x, bend.y, end.x, end.y);
            }
        }
        if let Some(path) = leaflets.finish() {
            canvas.stroke(&path, ink, 0.040, self.place);
        }
        let mut rib = PathBuilder::new();
        rib.move_to(from.x, from.y);
        for step in 1..=12_u8 {
            let at = point(f32::from(step) / 12.0);
            rib.line_to(at.x, at.y);
        }
        if let Some(path) = rib.finish() {
            canvas.stroke(&path, ink, 0.055, self.place);
        }
    }
}

/// A broad tree, or a bush.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tree {
    /// Where its foot is.
    pub(super) place: Place,
    /// Half its width and its height [m].
    pub(super) size: [f32; 2],
    /// Share of its height that is trunk.
    pub(super) bare: f32,
    /// Its leaves.
    pub(super) greens: Greens,
    /// Its trunk.
    pub(super) trunk: Ink,
    /// The side that light comes from: -1 left, 1 right.
    pub(super) lit: f32,
    /// Another seed is another tree.
    pub(super) seed: u64,
}

impl Tree {
    /// Paints it: trunk, then dabs of leaves in masses, dark ones below and light ones toward the light.
    pub(super) fn paint(&self, canvas: &mut Canvas) {
        let mut chance = Chance::new(self.seed);
        let [wide, high] = self.size;
        // A small tree needs few dabs to look full.
        let dabs = if self.place.distance > 14.0 * wide {
            34
        } else {
            90
        };
        let size = if dabs < 90 {
            [0.07, 0.16]
        } else {
            [0.04, 0.11]
        };
        if self.bare > 0.0 {
            let foot = [[-0.05, -0.1], [0.05, -0.1], [0.03, 0.7], [-0.03, 0.7]];
            let corners = foot.map(|[x, y]| Vec2::new(x * wide, y * high));
            if let Some(path) = polygon(corners.into_iter()) {
                canvas.fill(&path, self.trunk, self.place);
            }
        }
        let masses: Vec<(Vec2, f32)> = (0..11)
            .map(|_| {
                let around = chance.between(0.0, PI);
                let out = chance.share().sqrt();
                let x = trig::cos(around) * out * wide * 0.74;
                let room = 1.0 - self.bare;
                let y = high * (self.bare + room * (0.22 + 0.55 * trig::sin(around) * out));
                (Vec2::new(x, y), wide * chance.between(0.26, 0.42))
            })
            .collect();
        for (layer, ink) in (0_u16..).zip(self.greens) {
            let share = f32::from(layer) / 3.0;
            for &(middle, radius) in &masses {
                let toward = Vec2::new(self.lit * 0.45, 0.62) * radius * share;
                let spread = radius * (1.0 - 0.45 * share);
                for _ in 0..(dabs - dabs / 5 * layer) {
                    let around = chance.between(0.0, TAU);
                    let out = chance.share().sqrt() * spread;
                    let way = Vec2::new(trig::cos(around), 0.72 * trig::sin(around)) * out;
                    let size = radius * chance.between(size[0], size[1]);
                    self.dab(canvas, ink, middle + toward + way, size);
                }
            }
        }
    }

    /// A flat spot of leaves.
    fn dab(&self, canvas: &mut Canvas, ink: Ink, at: Vec2, size: f32) {
        let (left, low) = (at.x - size, at.y - size * 0.7);
        let leaf = Rect::from_xywh(left, low, size * 2.0, size * 1.4);
        if let Some(path) = leaf.and_then(PathBuilder::from_oval) {
            canvas.fill(&path, ink, self.place);
        }
    }
}

/// A bank of ferns: fronds that rise from a line and bend to both sides.
pub(super) fn ferns(
    canvas: &mut Canvas,
    place: Place,
    [wide, high]: [f32; 2],
    greens: Greens,
    seed: u64,
) {
    let mut chance = Chance::new(seed);
    for (layer, ink) in (0_u8..).zip(greens) {
        for _ in 0..5 {
            let foot = Vec2::new(chance.between(-wide, wide), -0.1);
            let bend = chance.between(-1.0, 1.0);
            let tall = high * chance.between(0.55, 1.0) * (1.0 - 0.15 * f32::from(layer));
            let point = |share: f32| {
                let up = tall * (share * 1.25 - 0.45 * share * share);
                foot + Vec2::new(bend * tall * 0.75 * share * share, up)
            };
            let mut leaflets = PathBuilder::new();
            for index in 1..14_u8 {
                let share = f32::from(index) / 14.0;
                let root = point(share);
                let ahead = (point(share + 0.02) - root).normalize_or(Vec2::Y);
                let long = tall * 0.26 * trig::sin(FRAC_PI_2 * (1.25 - share)).max(0.05);
                for wing in [-1.0_f32, 1.0] {
                    let end = root + (ahead.perp() * wing + ahead * 0.45) * long;
                    leaflets.move_to(root.x, root.y);
                    leaflets.line_to(end.x, end.y);
                }
            }
            if let Some(path) = leaflets.finish() {
                canvas.stroke(&path, ink, 0.020, place);
            }
        }
    }
}

/// A closed shape through points.
pub(super) fn polygon(mut points: impl Iterator<Item = Vec2>) -> Option<Path> {
    let first = points.next()?;
    let mut path = PathBuilder::new();
    path.move_to(first.x, first.y);
    for point in points {
        path.line_to(point.x, point.y);
    }
    path.close();
    path.finish()
}

/// The nearest of 0 to 3.
fn rounded(tone: f32) -> usize {
    [0.5, 1.5, 2.5].iter().filter(|edge| tone > **edge).count()
}
