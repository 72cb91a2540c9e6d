//! Flowers.

use glam::{Vec2, vec2};
use lole_geom::trig;

use super::path::{
    at_angle, both_sides, circle, closed, count, curve_spine, hump, lens_bent, smooth,
};
use super::{Ink, Layer};

/// A hibiscus: five overlapping ruffled petals, a dark eye, and the column that stands out of it.
pub(super) fn hibiscus(whim: f32) -> Vec<Layer> {
    let mut layers = Vec::new();
    for petal in 0..5 {
        let wobble = trig::sin(7.0 * whim + 2.1 * count(petal));
        let turn = std::f32::consts::TAU * count(petal) / 5.0 + 0.06 * wobble;
        let reach = 0.98 + 0.035 * wobble;
        let place = |point: Vec2| at_angle(turn).rotate(point * reach);
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
        at_angle(angle) * (0.10 + 0.24 * trig::powf(point, 2.2))
    });
    layers.push((Ink::Ground, closed(eye)));
    layers.extend(column(0.62 + 0.4 * whim));
    layers
}

/// The staminal column of a hibiscus, bent, with anthers and five stigmas.
fn column(turn: f32) -> Vec<Layer> {
    let bent = |t: f32| at_angle(turn).rotate(vec2(0.80 * t, 0.16 * t * t));
    let mut layers = vec![
        (Ink::Ground, curve_spine(bent, 0.062)),
        (Ink::Accent, curve_spine(bent, 0.040)),
    ];
    for index in 0..11 {
        let t = 0.46 + 0.047 * count(index);
        let side = if index % 2 == 0 { 1.0 } else { -1.0 };
        let across = (bent(t + 0.01) - bent(t)).perp().normalize_or_zero();
        let at = bent(t) + across * side * (0.075 - 0.018 * count(index % 3));
        layers.push((Ink::Accent, circle(at, 0.026)));
    }
    for index in 0..5 {
        let at = bent(1.02) + at_angle(turn + 0.55 * (count(index) - 2.0)) * 0.075;
        layers.push((Ink::Accent, circle(at, 0.024)));
    }
    layers
}

/// A plumeria blossom: five petals, each tucked under the next.
pub(super) fn blossom(whim: f32) -> Vec<Layer> {
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
        at_angle(angle) * (0.10 + 0.26 * point * point)
    });
    layers.push((Ink::Accent, closed(star)));
    layers
}

/// A plumeria seen close: broad petals that overlap like a pinwheel, glowing from the middle.
pub(super) fn plumeria(whim: f32) -> Vec<Layer> {
    let mut layers = Vec::new();
    let petal = |turn: f32, point: Vec2| at_angle(turn).rotate(point);
    for index in 0..5 {
        let turn = std::f32::consts::TAU * (count(index) / 5.0 + whim)
            + 0.05 * trig::sin(8.0 * whim + 2.2 * count(index));
        let edge = |t: f32, side: f32| {
            let full = if 0.0 < side { 0.40 } else { 0.27 };
            petal(turn, vec2(0.97 * t, side * full * hump(t, 1.55, 0.62)))
        };
        let outline = both_sides(40, edge);
        layers.push((Ink::Halo, outline.clone()));
        layers.push((Ink::Motif, outline));
        // The glow at the throat, and the turned edge.
        let glow = both_sides(24, |t, side| {
            petal(
                turn,
                vec2(0.60 * t, 0.02 + side * 0.115 * hump(t, 0.8, 0.9)),
            )
        });
        layers.push((Ink::Accent, glow));
        let fold = |t: f32| {
            petal(
                turn,
                vec2(
                    0.30 + 0.58 * t,
                    0.06 + 0.22 * hump(0.25 + 0.6 * t, 1.4, 0.7),
                ),
            )
        };
        layers.push((Ink::Vein, curve_spine(fold, 0.011)));
    }
    layers.push((Ink::Ground, circle(Vec2::ZERO, 0.035)));
    layers
}

/// A blossom of ʻōhiʻa lehua: nothing but stamens, each with its anther.
pub(super) fn lehua(whim: f32) -> Vec<Layer> {
    const STAMENS: usize = 84;
    let mut layers = vec![(Ink::Halo, circle(Vec2::ZERO, 0.62))];
    let mut tips = Vec::new();
    for index in 0..STAMENS {
        // The golden angle: even all around, without rows.
        let turn = 2.399_963 * count(index) + std::f32::consts::TAU * whim;
        let reach = 0.58
            + 0.38 * (count(index) / count(STAMENS)).sqrt()
            + 0.03 * trig::sin(5.0 * turn + 9.0 * whim);
        let bow = 0.16 * trig::sin(3.1 * count(index));
        let stamen = |t: f32| at_angle(turn + bow * t * t) * (reach * t);
        layers.push((Ink::Motif, curve_spine(stamen, 0.021)));
        tips.push(stamen(1.0));
    }
    layers.push((Ink::Motif, circle(Vec2::ZERO, 0.40)));
    for index in 0..26 {
        let turn = 2.399_963 * count(index);
        let reach = 0.10 + 0.44 * (count(index) / 26.0).sqrt();
        let line = |t: f32| at_angle(turn + 0.1 * t) * (reach * (0.35 + 0.65 * t));
        layers.push((Ink::Ground, curve_spine(line, 0.010)));
    }
    let anthers = tips.iter().map(|tip| (Ink::Accent, circle(*tip, 0.031)));
    layers.extend(anthers);
    layers
}

/// A bird-of-paradise in profile: stalk, beak, the crest of sepals and the tongue.
pub(super) fn bird_of_paradise(whim: f32) -> Vec<Layer> {
    let sway = 0.06 * (whim - 0.5);
    let stalk = |t: f32| vec2(-0.02 + 0.56 * t, sway * t * (1.0 - t) * 4.0);
    let mut layers = vec![(Ink::Accent, curve_spine(stalk, 0.026))];
    let base = vec2(0.535, 0.0);
    for (lean, length, width) in [
        (-0.86, 0.36, 0.058),
        (0.42, 0.44, 0.056),
        (-0.46, 0.45, 0.064),
        (0.02, 0.47, 0.062),
    ] {
        let lean = lean + 0.10 * (whim - 0.5);
        let sepal = both_sides(24, |t, side| {
            let bow = 0.08 * lean * t * t;
            base + at_angle(lean).rotate(vec2(length * t, bow + side * width * hump(t, 0.72, 0.9)))
        });
        layers.push((Ink::Halo, sepal.clone()));
        layers.push((Ink::Motif, sepal));
        let line = |t: f32| {
            base + at_angle(lean).rotate(vec2(length * (0.10 + 0.72 * t), 0.08 * lean * t * t))
        };
        layers.push((Ink::Vein, curve_spine(line, 0.008)));
    }
    // The tongue, an arrow.
    let tongue = |point: Vec2| base + at_angle(0.24).rotate(point);
    let arrow = closed(
        [
            (0.02, 0.010),
            (0.24, 0.014),
            (0.21, 0.042),
            (0.40, 0.0),
            (0.21, -0.042),
            (0.24, -0.014),
            (0.02, -0.010),
        ]
        .map(|(x, y)| tongue(vec2(x, y))),
    );
    layers.push((Ink::Halo, arrow.clone()));
    layers.push((Ink::Accent, arrow));
    // The beak points sideways and a little up.
    let beak = |t: f32, side: f32| {
        let width = if 0.0 < side { 0.052 } else { 0.040 };
        let middle = vec2(0.50 + 0.115 * t * t, -0.055 + 0.50 * t);
        middle + vec2(-side * width * hump(0.16 + 0.84 * t, 0.62, 0.8), 0.0)
    };
    let outline = both_sides(30, beak);
    layers.push((Ink::Halo, outline.clone()));
    layers.push((Ink::Accent, outline));
    let seam = |t: f32| beak(0.06 + 0.80 * t, -0.35);
    layers.push((Ink::Ground, curve_spine(seam, 0.008)));
    layers
}
