//! Sand, grass, boards and water, seen from above.

use super::canvas::{Ink, Tile, light};
use super::noise::{Fractal, floor, hash};
use super::plants::polygon;
use glam::{Vec2, Vec3};
use lole_geom::chance::Chance;
use lole_geom::trig;
use lole_render::Texture;
use std::f32::consts::TAU;
use std::sync::Arc;

/// Dry sand: grains, and the dents of feet and wind in a light that comes from one side.
pub(super) fn sand(ink: Ink) -> Option<Arc<Texture>> {
    let dents = Fractal {
        period: [9, 9],
        octaves: 5,
        seed: 21,
    };
    let height = |at: Vec2| dents.at(at.x * 9.0, at.y * 9.0);
    let color = light(ink);
    Tile::of(1024, |at| {
        let step = 1.0 / 300.0;
        let toward =
            height(at + Vec2::new(-step, step * 0.6)) - height(at - Vec2::new(-step, step * 0.6));
        let cell = |scale: f32| at * scale;
        let grain = hash(floor(cell(1024.0).x), floor(cell(1024.0).y), 5) - 0.5;
        let coarse = hash(floor(cell(512.0).x), floor(cell(512.0).y), 6) - 0.5;
        let tone = 1.0 + 4.0 * toward + 0.20 * grain + 0.14 * coarse;
        color * tone.clamp(0.4, 1.6)
    })?
    .finish()
}

/// A lawn: blades over blades, those in the shadow of others first.
pub(super) fn grass(soil: Ink, blades: [Ink; 4]) -> Option<Arc<Texture>> {
    let patches = Fractal {
        period: [9, 9],
        octaves: 3,
        seed: 8,
    };
    let color = light(soil);
    let mut tile = Tile::of(1024, |at| {
        color * (0.7 + 0.6 * patches.at(at.x * 9.0, at.y * 9.0))
    })?;
    let mut chance = Chance::new(17);
    for ink in blades {
        for _ in 0..5200 {
            let foot = Vec2::new(chance.fine_share(), chance.fine_share());
            let (sin, cos) = trig::sin_cos(chance.between(0.0, TAU));
            let long = chance.between(0.018, 0.045);
            let way = Vec2::new(cos, sin) * long;
            let half = way.perp() * chance.between(0.030, 0.055);
            let bend = way.perp() * chance.between(-0.25, 0.25);
            let shape = [
                foot - half,
                foot + way * 0.5 + bend - half,
                foot + way + bend * 1.6,
                foot + way * 0.5 + bend + half,
                foot + half,
            ];
            if let Some(path) = polygon(shape.into_iter()) {
                tile.fill(&path, ink, 215);
            }
        }
    }
    tile.finish()
}

/// The boards of a stage, that run toward the house.
pub(super) fn boards(ink: Ink, count: u8) -> Option<Arc<Texture>> {
    let grain = Fractal {
        period: [40, 2],
        octaves: 4,
        seed: 31,
    };
    let color = light(ink);
    Tile::of(1024, |at| {
        let across = at.x * f32::from(count);
        let board = floor(across);
        let own = hash(board, 0, 77);
        let from_gap = (across - board as f32 - 0.5).abs();
        let gap = ((from_gap - 0.485) / 0.01).clamp(0.0, 1.0);
        let shifted = at.y + own;
        let end = ((shifted - floor(shifted) as f32 - 0.5).abs() * 1024.0 < 1.0) && own > 0.3;
        let lines = grain.at(at.x * 40.0, (at.y + own * 3.0) * 2.0);
        let tone = (0.80 + 0.30 * own) * (0.80 + 0.40 * lines);
        color * tone * (1.0 - 0.75 * gap) * if end { 0.45 } else { 1.0 }
    })?
    .finish()
}

/// A sea: crests along the shore, whose green says how high they tilt what is mirrored.
pub(super) fn water(ink: Ink) -> Option<Arc<Texture>> {
    let swell = Fractal {
        period: [3, 11],
        octaves: 5,
        seed: 41,
    };
    let bend = Fractal {
        period: [2, 2],
        octaves: 3,
        seed: 43,
    };
    let color = light(ink);
    Tile::of(512, |at| {
        let bent = bend.at(at.x * 2.0, at.y * 2.0) - 0.5;
        let crest = swell.at(at.x * 3.0, (at.y + 0.10 * bent) * 11.0);
        let ridge = 1.0 - (crest - 0.5).abs() * 4.0;
        let tone = 0.35 + 0.9 * ridge.clamp(0.0, 1.0) + 0.6 * (crest - 0.5);
        color * tone.max(0.05)
    })?
    .finish()
}

/// One color all over.
pub(super) fn even(color: Vec3) -> Option<Arc<Texture>> {
    Tile::of(4, |_| color)?.finish()
}
