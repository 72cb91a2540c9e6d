//! Leaves and fronds.

use glam::{Vec2, vec2};
use lole_geom::trig;

use super::path::{at_angle, both_sides, closed, count, curve_spine, hump, lens, smooth, spine};
use super::{Ink, Layer};

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
        heart + at_angle(angle) * heart_radius(angle) * (1.0 - cut)
    });
    let outline = closed(outline);
    let mut layers = vec![(Ink::Halo, outline.clone()), (Ink::Motif, outline)];
    layers.push((Ink::Ground, spine(vec2(-0.05, 0.0), vec2(0.93, 0.0), 0.018)));
    for side in [-1.0, 1.0] {
        for (index, angle) in [0.30, 0.71, 1.14, 1.60, 2.08].into_iter().enumerate() {
            let from = vec2(0.58 - 0.11 * count(index), 0.0);
            let aim = heart + at_angle(side * angle) * heart_radius(angle) * 0.86;
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
pub(super) fn breadfruit(whim: f32) -> Vec<Layer> {
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
            let middle = stalk(t) + at_angle(turn) * length * 0.5;
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

/// A leaf of ti (lāʻī): long, pointed, with a pale midrib.
pub(super) fn ti(whim: f32) -> Vec<Layer> {
    let bend = 0.36 * (whim - 0.5);
    blade(Ink::Motif, |point| {
        vec2(point.x, point.y + bend * point.x * (1.0 - point.x))
    })
}

/// The leaves at the tip of a ti plant, fanned, in both colors.
pub(super) fn ti_spray(whim: f32) -> Vec<Layer> {
    let mut layers = Vec::new();
    // From the outermost to the middle one, which lies on top.
    for (order, place) in [3_i8, -3, 2, -2, 1, -1, 0].into_iter().enumerate() {
        let lean = f32::from(place) * 0.33 + 0.10 * trig::sin(9.0 * whim + 1.7 * count(order));
        let length = 1.0 - 0.075 * f32::from(place.abs());
        let droop = 0.26 * lean;
        let ink = if place % 2 == 0 {
            Ink::Motif
        } else {
            Ink::Accent
        };
        layers.extend(blade(ink, |point| {
            let drooped = vec2(point.x, 1.25 * point.y + droop * point.x * point.x);
            at_angle(lean).rotate(drooped * length)
        }));
    }
    layers
}

/// A long pointed leaf with midrib and veins, from the origin to (1, 0), then placed.
fn blade(ink: Ink, place: impl Fn(Vec2) -> Vec2) -> Vec<Layer> {
    let width = |t: f32| 0.016 + 0.098 * hump(t, 0.82, 0.85);
    let edge = |t: f32, side: f32| {
        let wave = 0.007 * trig::sin(21.0 * t + side);
        place(vec2(
            t,
            side * (width(t) * (1.0 - t * t * t * t) + wave * t * (1.0 - t)),
        ))
    };
    let outline = both_sides(60, edge);
    let mut layers = vec![(Ink::Halo, outline.clone()), (ink, outline)];
    let rib = |t: f32| place(vec2(0.02 + 0.94 * t, 0.0));
    layers.push((Ink::Ground, curve_spine(rib, 0.0095)));
    for side in [-1.0, 1.0] {
        for row in 0..6 {
            let from = 0.10 + 0.125 * count(row);
            let vein = |t: f32| {
                let along = from + 0.17 * t;
                let across = 0.72 * width(along) * smooth(t);
                place(vec2(along, side * across))
            };
            layers.push((Ink::Ground, curve_spine(vein, 0.0035)));
        }
    }
    layers
}

/// A leaf of plumeria: broadest beyond its middle, with even veins that meet near the edge.
pub(super) fn plumeria(whim: f32) -> Vec<Layer> {
    let bend = 0.4 * (whim - 0.5);
    let place = |point: Vec2| vec2(point.x, point.y + bend * point.x * (1.0 - point.x));
    let width = |t: f32| 0.185 * hump(t, 1.22, 0.80);
    let outline = both_sides(50, |t, side| place(vec2(t, side * width(t))));
    let mut layers = vec![(Ink::Halo, outline.clone()), (Ink::Motif, outline)];
    let rib = |t: f32| place(vec2(-0.06 + 1.0 * t, 0.0));
    layers.push((Ink::Ground, curve_spine(rib, 0.015)));
    for side in [-1.0, 1.0] {
        for row in 0..9 {
            let from = 0.13 + 0.086 * count(row);
            let vein = |t: f32| {
                let along = from + 0.055 * t;
                place(vec2(along, side * 0.84 * width(along) * t))
            };
            layers.push((Ink::Ground, curve_spine(vein, 0.0065)));
        }
    }
    layers
}

/// A twig of ʻōhiʻa: small round leaves in pairs.
pub(super) fn lehua_sprig(whim: f32) -> Vec<Layer> {
    let bend = 0.5 * (whim - 0.5);
    let stalk = |t: f32| vec2(0.92 * t, bend * t * (t - 1.0));
    let mut layers = vec![(Ink::Motif, curve_spine(stalk, 0.014))];
    let mut leaf = |base: Vec2, turn: f32, length: f32| {
        let outline = both_sides(24, |t, side| {
            base + at_angle(turn).rotate(vec2(length * t, side * 0.40 * length * hump(t, 1.1, 0.6)))
        });
        layers.push((Ink::Motif, outline));
        let (from, to) = (base, base + at_angle(turn) * length * 0.86);
        layers.push((Ink::Ground, spine(from, to, 0.008)));
    };
    for pair in 0..4 {
        let t = 0.14 + 0.22 * count(pair);
        let heading = stalk(t + 0.01) - stalk(t);
        let heading = trig::atan2(heading.y, heading.x);
        for side in [-1.0, 1.0] {
            leaf(stalk(t), heading + side * 1.0, 0.225 - 0.020 * count(pair));
        }
    }
    leaf(stalk(0.97), trig::atan2(bend, 1.0), 0.17);
    layers
}

/// A leaf of bird-of-paradise or banana: a broad blade that the wind has torn.
pub(super) fn paddle(whim: f32) -> Vec<Layer> {
    let bend = 0.42 * (whim - 0.5);
    let place = |point: Vec2| vec2(point.x, point.y + bend * point.x * (1.0 - point.x));
    let width = |t: f32| 0.205 * hump(((t - 0.14) / 0.86).max(0.0), 0.92, 0.62);
    let outline = both_sides(60, |t, side| {
        place(vec2(0.14 + 0.86 * t, side * width(0.14 + 0.86 * t)))
    });
    let stalk = |t: f32| place(vec2(-0.06 + 1.0 * t, 0.0));
    let mut layers = vec![
        (Ink::Halo, outline.clone()),
        (Ink::Motif, outline),
        (Ink::Motif, curve_spine(stalk, 0.020)),
        (Ink::Ground, curve_spine(stalk, 0.010)),
    ];
    for side in [-1.0_f32, 1.0] {
        for row in 0..10 {
            let shift = 0.02 * trig::sin(11.0 * whim + 2.9 * count(row) + side);
            let from = 0.20 + 0.072 * count(row) + shift;
            let torn = row % 3 == 1;
            let reach = if torn { 1.12 } else { 0.80 };
            let vein = |t: f32| {
                // From the edge inward: a tear is widest there.
                let t = if torn { 1.0 - t } else { t };
                let along = from + 0.085 * t;
                place(vec2(along, side * reach * width(along) * (0.16 + 0.84 * t)))
            };
            let wide = if torn { 0.017 } else { 0.006 };
            layers.push((Ink::Ground, curve_spine(vein, wide)));
        }
    }
    layers
}

/// A frond of palapalai as it grows: a lacy triangle, every leaflet lobed again.
pub(super) fn palapalai(whim: f32) -> Vec<Layer> {
    let bend = 0.44 * (whim - 0.5);
    let stalk = |t: f32| vec2(t, bend * t * (t - 1.0));
    let mut layers = vec![(Ink::Motif, curve_spine(stalk, 0.011))];
    for pair in 0..13 {
        let t = 0.07 + 0.070 * count(pair);
        let heading = stalk(t + 0.01) - stalk(t);
        let heading = trig::atan2(heading.y, heading.x);
        let length = 0.31 * trig::powf(1.0 - t, 0.85) * (0.80 + 0.20 * smooth(t / 0.2));
        for side in [-1.0, 1.0] {
            let turn = heading + side * (1.15 - 0.35 * t);
            let base = stalk(t);
            let rib = |s: f32| {
                base + at_angle(turn).rotate(vec2(length * s, -side * 0.10 * length * s * s))
            };
            layers.push((Ink::Motif, curve_spine(rib, 0.007)));
            for lobe in 0..6 {
                let s = 0.16 + 0.145 * count(lobe);
                let reach = 0.060 * trig::powf(1.0 - t, 0.6) * (1.12 - 0.85 * s);
                for edge in [-1.0, 1.0] {
                    let lean = turn + edge * 0.88;
                    let middle = rib(s) + at_angle(lean) * reach * 0.52;
                    layers.push((Ink::Motif, lens(middle, lean, reach * 0.62, reach * 0.30)));
                }
            }
            let tip = rib(1.0);
            layers.push((Ink::Motif, lens(tip, turn, 0.10 * length, 0.030 * length)));
        }
    }
    layers.push((
        Ink::Motif,
        lens(stalk(0.98), trig::atan2(bend, 1.0), 0.045, 0.012),
    ));
    layers
}
