//! What lives in the sea, and the sea.

use glam::{Vec2, vec2};
use lole_geom::trig;

use super::path::{at_angle, both_sides, circle, closed, count, hump};
use super::{Ink, Layer};

/// A green turtle (honu) from above, swimming along +x.
pub(super) fn turtle(whim: f32) -> Vec<Layer> {
    let stroke = 0.22 * trig::sin(std::f32::consts::TAU * whim);
    let mut layers = Vec::new();
    for side in [-1.0_f32, 1.0] {
        // A front flipper sweeps out and back, a rear one is short.
        for (base, turn, length, width, sweep) in [
            (vec2(0.30, 0.26), 1.02 + stroke * side, 0.80, 0.150, 0.52),
            (
                vec2(-0.36, 0.20),
                2.25 - 0.5 * stroke * side,
                0.46,
                0.115,
                0.16,
            ),
        ] {
            let flipper = both_sides(30, |t, edge| {
                let bowed = vec2(length * t, sweep * t * t * length);
                let local = bowed + vec2(0.0, edge * width * hump(0.10 + 0.90 * t, 0.70, 0.75));
                let placed = base + at_angle(turn).rotate(local);
                vec2(placed.x, side * placed.y)
            });
            layers.push((Ink::Halo, flipper.clone()));
            layers.push((Ink::Motif, flipper));
            for dot in 0..4 {
                let t = 0.30 + 0.15 * count(dot);
                let local = vec2(length * t, sweep * t * t * length);
                let placed = base + at_angle(turn).rotate(local);
                let at = vec2(placed.x, side * placed.y);
                layers.push((Ink::Ground, circle(at, 0.034 - 0.004 * count(dot))));
            }
        }
    }
    let head = both_sides(24, |t, side| {
        vec2(0.42 + 0.46 * t, side * 0.125 * hump(t, 1.15, 0.55))
    });
    layers.push((Ink::Halo, head.clone()));
    layers.push((Ink::Motif, head));
    layers.extend([-1.0, 1.0].map(|side| (Ink::Ground, circle(vec2(0.74, side * 0.062), 0.026))));
    layers.extend(shell());
    layers
}

/// The shell, with its plates.
fn shell() -> Vec<Layer> {
    let round = |grow: f32| {
        both_sides(50, |t, side| {
            let along = -trig::cos(std::f32::consts::PI * t);
            // Blunt in front, drawn out behind.
            let broad = trig::powf((1.0 - along * along).max(0.0), 0.5) * (1.0 + 0.16 * along);
            vec2(0.56 * grow * along, side * 0.455 * grow * broad)
        })
    };
    let mut layers = vec![
        (Ink::Halo, round(1.0)),
        (Ink::Motif, round(1.0)),
        (Ink::Ground, round(0.86)),
    ];
    let plate = |corners: &[(f32, f32)], side: f32| {
        let middle = corners
            .iter()
            .fold(Vec2::ZERO, |sum, corner| sum + Vec2::from(*corner))
            / count(corners.len());
        let shrunk = corners.iter().map(|corner| {
            let point = middle + (Vec2::from(*corner) - middle) * 0.90;
            vec2(point.x, side * point.y)
        });
        closed(shrunk)
    };
    for x in [-0.40_f32, -0.20, 0.02, 0.24] {
        let broad = 0.135 - 0.10 * (x - 0.02).abs();
        let middle = [
            (x - 0.02, -broad * 0.55),
            (x + 0.09, -broad),
            (x + 0.20, -broad * 0.55),
            (x + 0.20, broad * 0.55),
            (x + 0.09, broad),
            (x - 0.02, broad * 0.55),
        ];
        layers.push((Ink::Accent, plate(&middle, 1.0)));
    }
    for side in [-1.0, 1.0] {
        for corners in [
            [
                (-0.42, 0.06),
                (-0.31, 0.12),
                (-0.22, 0.11),
                (-0.20, 0.26),
                (-0.32, 0.21),
            ],
            [
                (-0.20, 0.11),
                (-0.11, 0.145),
                (-0.02, 0.12),
                (0.00, 0.34),
                (-0.18, 0.29),
            ],
            [
                (0.02, 0.12),
                (0.11, 0.145),
                (0.22, 0.11),
                (0.24, 0.33),
                (0.02, 0.35),
            ],
            [
                (0.24, 0.10),
                (0.33, 0.115),
                (0.43, 0.07),
                (0.42, 0.19),
                (0.26, 0.32),
            ],
        ] {
            layers.push((Ink::Motif, plate(&corners, side)));
        }
    }
    layers
}

/// A wave that curls over, with its foam.
pub(super) fn wave(whim: f32) -> Vec<Layer> {
    let flip = if whim < 0.5 { -1.0 } else { 1.0 };
    let place = |point: Vec2| vec2(point.x, flip * point.y);
    // A spiral that thins towards its eye.
    let spiral = |t: f32, reach: f32| {
        let turn = -2.5 + 7.4 * t;
        at_angle(turn) * reach * trig::powf(1.0 - 0.93 * t, 1.1)
    };
    let arm = |reach: f32, width: f32| {
        both_sides(60, |t, side| {
            let across = (spiral(t + 0.01, reach) - spiral(t - 0.01, reach))
                .perp()
                .normalize_or_zero();
            let wide = width * hump(t, 0.42, 0.9) * (1.0 - 0.70 * t);
            place(spiral(t, reach) + across * side * wide)
        })
    };
    let mut layers = vec![
        (Ink::Motif, arm(0.76, 0.21)),
        (Ink::Ground, arm(0.80, 0.030)),
    ];
    for index in 0..6 {
        let t = 0.10 + 0.058 * count(index);
        let outside = spiral(t, 0.76).normalize_or_zero();
        let at = spiral(t, 0.76) + outside * (0.25 + 0.03 * trig::sin(4.0 * count(index)));
        layers.push((Ink::Accent, circle(place(at), 0.050 - 0.005 * count(index))));
    }
    layers
}
