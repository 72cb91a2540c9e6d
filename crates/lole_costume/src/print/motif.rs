//! The motifs as paths: silhouettes as scissors cut them, and the lines drawn into them.
//!
//! A leaf starts at the origin and points along +x with length 1; a flower is centered on the
//! origin with radius 1.

use glam::{Vec2, vec2};
use lole_geom::trig;
use tiny_skia::{Path, PathBuilder};

use super::layout::direction;

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

/// A leaf of monstera: a heart with fingers, cut between the veins.
pub(super) fn monstera(whim: f32) -> Vec<Layer> {
    // Seen from this point on the midrib the slits run straight outwards.
    let heart = vec2(0.34, 0.0);
    let slits: Vec<(f32, f32)> = [0.50, 0.92, 1.36, 1.84, 2.32]
        .iter()
        .enumerate()
        .flat_map(|(index, angle)| {
            let shift = 0.06 * (trig::sin(9.0 * whim + 2.3 * count(index)));
            let depth = [0.42, 0.56, 0.58, 0.52, 0.42][index];
            [(angle + shift, depth), (-angle + shift, depth - 0.05)]
        })
        .collect();
    let outline = (0..720).map(|step| {
        let angle = (count(step) / 720.0 - 0.5) * std::f32::consts::TAU;
        let cut = slits.iter().fold(0.0_f32, |cut, (middle, depth)| {
            let off = ((angle - middle) / 0.066).abs();
            cut.max(depth * smooth(1.25 - off))
        });
        heart + direction(angle) * heart_radius(angle) * (1.0 - cut)
    });
    let mut layers = vec![(Ink::Motif, closed(outline))];
    layers.push((Ink::Ground, spine(vec2(-0.05, 0.0), vec2(0.93, 0.0), 0.018)));
    for side in [-1.0, 1.0] {
        for (index, angle) in [0.30, 0.71, 1.14, 1.60, 2.08].into_iter().enumerate() {
            let from = vec2(0.58 - 0.11 * count(index), 0.0);
            let aim = heart + direction(side * angle) * heart_radius(angle) * 0.86;
            layers.push((Ink::Vein, spine(from, aim, 0.009)));
            if 0 < index && index < 4 {
                let hole = from.lerp(aim, 0.36) + vec2(0.045, 0.0);
                let turn = trig::atan2(aim.y - from.y, aim.x - from.x);
                layers.push((Ink::Ground, lens(hole, turn, 0.085, 0.019)));
            }
        }
    }
    layers
}

/// Distance of a heart's edge from its inner point at an angle from the tip [rad].
fn heart_radius(angle: f32) -> f32 {
    let turn = angle.abs();
    // A pointed tip, broad shoulders, and the notch where the stalk enters.
    let tip = 0.66 - 0.27 * trig::powf((turn / 0.70).min(1.0), 0.62);
    let side = 0.09 * smooth((turn - 0.60) / 0.9);
    let notch = 0.27 * smooth((turn - 2.55) / 0.6);
    tip + side - notch
}

/// A leaf of breadfruit: broad, with rounded lobes that sweep forward.
pub(super) fn breadfruit_leaf(whim: f32) -> Vec<Layer> {
    let edge = |t: f32, side: f32| {
        let lobe =
            0.5 + 0.5 * trig::cos((t * 4.6 + 0.35 + 0.12 * whim * side) * std::f32::consts::TAU);
        let broad = 0.40
            * trig::powf(
                trig::sin(std::f32::consts::PI * trig::powf(t, 0.85)).max(0.0),
                0.8,
            );
        let width = broad * (0.34 + 0.66 * trig::powf(lobe, 0.6));
        vec2(t + 0.30 * (width - 0.1).max(0.0) * (1.0 - t), side * width)
    };
    let upper = (0..=180).map(|step| edge(count(step) / 180.0, 1.0));
    let lower = (0..=180).rev().map(|step| edge(count(step) / 180.0, -1.0));
    let mut layers = vec![(Ink::Motif, closed(upper.chain(lower)))];
    layers.push((Ink::Ground, spine(vec2(-0.06, 0.0), vec2(0.96, 0.0), 0.017)));
    for side in [-1.0, 1.0] {
        for index in 0..4 {
            let t = 0.142 + 0.2174 * count(index);
            let aim = edge(t, side) * vec2(1.0, 0.80);
            layers.push((
                Ink::Ground,
                spine(vec2((t - 0.10).max(0.03), 0.0), aim, 0.010),
            ));
        }
    }
    layers
}

/// A frond of palapalai: a bent stalk with tapering leaflets.
pub(super) fn fern(whim: f32) -> Vec<Layer> {
    let bend = 0.5 * (whim - 0.5);
    let stalk = |t: f32| vec2(t, bend * t * (t - 1.0) * 0.9);
    let mut layers = vec![(Ink::Motif, curve_spine(stalk, 0.012))];
    let pair_count = 15;
    for index in 0..pair_count {
        let t = 0.10 + 0.87 * count(index) / count(pair_count - 1);
        let heading = stalk(t + 0.01) - stalk(t);
        let heading = trig::atan2(heading.y, heading.x);
        let length = 0.235
            * trig::powf(
                trig::sin(std::f32::consts::PI * (0.20 + 0.76 * t)).max(0.0),
                0.75,
            );
        let lean = 1.12 - 0.52 * t;
        for side in [-1.0, 1.0] {
            let turn = heading + side * lean;
            let middle = stalk(t) + direction(turn) * length * 0.5;
            layers.push((
                Ink::Motif,
                lens(middle, turn, length * 0.52, 0.030 * (1.1 - 0.55 * t)),
            ));
        }
    }
    layers.push((
        Ink::Motif,
        lens(stalk(0.98), trig::atan2(-bend * 0.9, 1.0), 0.05, 0.014),
    ));
    layers
}

/// A hibiscus: five overlapping ruffled petals, a dark eye, and the column that stands out of it.
pub(super) fn hibiscus(whim: f32) -> Vec<Layer> {
    let mut layers = Vec::new();
    for petal in 0..5 {
        let wobble = trig::sin(7.0 * whim + 2.1 * count(petal));
        let turn = std::f32::consts::TAU * count(petal) / 5.0 + 0.06 * wobble;
        let reach = 0.98 + 0.035 * wobble;
        let place = |point: Vec2| direction(turn).rotate(point * reach);
        let edge = |t: f32, side: f32| {
            // Narrow at the throat, broad and ruffled near the rim, fuller on one side.
            let full = if 0.0 < side { 0.50 } else { 0.40 };
            let width = full
                * trig::powf(
                    trig::sin(std::f32::consts::PI * 0.93 * trig::powf(t, 1.15)).max(0.0),
                    0.72,
                );
            let ruffle = 0.016 * trig::sin(t * 26.0 + 5.0 * whim + side) * smooth((t - 0.35) / 0.3);
            vec2(0.06 + 0.94 * t, side * (width + ruffle))
        };
        let rim = |s: f32| {
            let corner = edge(1.0, s.signum()) * vec2(1.0, s.abs());
            corner
                + vec2(
                    0.030 * trig::sin(s * 7.5 + 4.0 * whim + count(petal)) - 0.02 * s * s,
                    0.0,
                )
        };
        let outline = (0..=70)
            .map(|step| edge(count(step) / 70.0, 1.0))
            .chain((1..40).map(|step| rim(1.0 - count(step) / 20.0)))
            .chain((0..=70).rev().map(|step| edge(count(step) / 70.0, -1.0)))
            .map(place);
        let path = closed(outline);
        layers.push((Ink::Halo, path.clone()));
        layers.push((Ink::Motif, path));
        for (fan, length) in [
            (-0.34, 0.74),
            (-0.17, 0.86),
            (0.0, 0.90),
            (0.18, 0.87),
            (0.37, 0.76),
        ] {
            let bow = |t: f32| {
                place(vec2(
                    0.24 + (length - 0.24) * t,
                    fan * 1.08 * trig::powf(t, 1.25),
                ))
            };
            layers.push((Ink::Vein, curve_spine(bow, 0.013)));
        }
    }
    let eye = (0..100).map(|step| {
        let angle = std::f32::consts::TAU * count(step) / 100.0;
        let point = 0.5 + 0.5 * trig::cos(5.0 * angle);
        direction(angle) * (0.10 + 0.24 * trig::powf(point, 2.2))
    });
    layers.push((Ink::Ground, closed(eye)));
    layers.extend(column(0.62 + 0.4 * whim));
    layers
}

/// The staminal column of a hibiscus, bent, with anthers and five stigmas.
fn column(turn: f32) -> Vec<Layer> {
    let bent = |t: f32| direction(turn).rotate(vec2(0.80 * t, 0.16 * t * t));
    let mut layers = vec![
        (Ink::Ground, curve_spine(bent, 0.062)),
        (Ink::Accent, curve_spine(bent, 0.040)),
    ];
    for index in 0..11 {
        let t = 0.46 + 0.047 * count(index);
        let side = if index % 2 == 0 { 1.0 } else { -1.0 };
        let across = (bent(t + 0.01) - bent(t)).perp().normalize_or_zero();
        let at = bent(t) + across * side * (0.075 - 0.018 * count(index % 3));
        layers.push((Ink::Accent, disc(at, 0.026)));
    }
    for index in 0..5 {
        let at = bent(1.02) + direction(turn + 0.55 * (count(index) - 2.0)) * 0.075;
        layers.push((Ink::Accent, disc(at, 0.024)));
    }
    layers
}

/// A breadfruit: round, with the pattern of its rind, on a short stalk.
pub(super) fn breadfruit(whim: f32) -> Vec<Layer> {
    let outline = (0..120).map(|step| {
        let angle = std::f32::consts::TAU * count(step) / 120.0;
        direction(angle) * (0.64 + 0.02 * trig::sin(3.0 * angle + 6.0 * whim))
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
        let at = direction(2.399_963 * count(index)) * radius;
        layers.push((
            Ink::Ground,
            lens(at, 2.399_963 * count(index), 0.034, 0.021),
        ));
    }
    layers
}

/// A plumeria blossom: five petals, each tucked under the next.
pub(super) fn plumeria(whim: f32) -> Vec<Layer> {
    let mut layers = Vec::new();
    for petal in 0..5 {
        let turn = std::f32::consts::TAU * (count(petal) / 5.0 + whim);
        let path = lens_bent(turn, 0.94, 0.30);
        layers.push((Ink::Halo, path.clone()));
        layers.push((Ink::Motif, path));
    }
    let star = (0..60).map(|step| {
        let angle = std::f32::consts::TAU * count(step) / 60.0;
        let point = 0.5 + 0.5 * trig::cos(5.0 * (angle - std::f32::consts::TAU * whim));
        direction(angle) * (0.10 + 0.26 * point * point)
    });
    layers.push((Ink::Accent, closed(star)));
    layers
}

/// A petal from the origin, fuller on one side.
fn lens_bent(turn: f32, length: f32, width: f32) -> Option<Path> {
    let edge = |t: f32, side: f32| {
        let full = if 0.0 < side { 1.25 } else { 0.75 };
        let across = side
            * full
            * width
            * trig::powf(
                trig::sin(std::f32::consts::PI * trig::powf(t, 1.3)).max(0.0),
                0.7,
            );
        direction(turn).rotate(vec2(length * t, across))
    };
    let upper = (0..=30).map(|step| edge(count(step) / 30.0, 1.0));
    let lower = (0..=30).rev().map(|step| edge(count(step) / 30.0, -1.0));
    closed(upper.chain(lower))
}

/// A pointed oval of half length and half width around `middle`.
fn lens(middle: Vec2, turn: f32, half_length: f32, half_width: f32) -> Option<Path> {
    let edge = |t: f32, side: f32| {
        let across = side * half_width * (1.0 - t * t);
        middle + direction(turn).rotate(vec2(half_length * t, across))
    };
    let upper = (-8..=8_i16).map(|step| edge(f32::from(step) / 8.0, 1.0));
    let lower = (-8..=8_i16)
        .rev()
        .map(|step| edge(f32::from(step) / 8.0, -1.0));
    closed(upper.chain(lower))
}

/// A disc.
fn disc(middle: Vec2, radius: f32) -> Option<Path> {
    PathBuilder::from_circle(middle.x, middle.y, radius)
}

/// A straight line that tapers from `width` to a point.
fn spine(from: Vec2, to: Vec2, width: f32) -> Option<Path> {
    curve_spine(|t| from.lerp(to, t), width)
}

/// A curve over 0 to 1 that tapers from half width `width` to a fifth of it.
fn curve_spine(curve: impl Fn(f32) -> Vec2, width: f32) -> Option<Path> {
    let edge = |t: f32, side: f32| {
        let across = (curve(t + 0.01) - curve(t - 0.01))
            .perp()
            .normalize_or_zero();
        curve(t) + across * side * width * (1.0 - 0.8 * t)
    };
    let left = (0..=20).map(|step| edge(count(step) / 20.0, 1.0));
    let right = (0..=20).rev().map(|step| edge(count(step) / 20.0, -1.0));
    closed(left.chain(right))
}

/// A closed polygon.
fn closed(points: impl Iterator<Item = Vec2>) -> Option<Path> {
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
fn smooth(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// A small index as a number.
#[expect(clippy::cast_precision_loss, reason = "a few hundred points at most")]
fn count(index: usize) -> f32 {
    index as f32
}
