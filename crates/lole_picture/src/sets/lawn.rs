//! A lawn late in the morning: fluted green mountains under trade-wind clouds, trees and palms before them.

use super::canvas::{Canvas, Place};
use super::floors;
use super::noise::{Fractal, ramp, smooth_between};
use super::plants::{Greens, Palm, Tree, polygon};
use glam::{Vec2, Vec3};
use lole_geom::trig;
use lole_render::backdrop::{Floor, Panorama, Shore};
use lole_render::{KeyLight, Landscape, LightRig, SoftBox};
use std::f32::consts::{PI, TAU};
use std::sync::OnceLock;

const PALM: Greens = [[34, 52, 26], [58, 84, 36], [96, 124, 52], [156, 170, 88]];
const LEAVES: Greens = [[28, 48, 26], [46, 76, 36], [78, 110, 48], [122, 148, 66]];
const FAR_LEAVES: Greens = [[52, 78, 56], [68, 100, 66], [90, 124, 78], [122, 152, 96]];
const TRUNK: [[u8; 3]; 2] = [[86, 76, 64], [156, 142, 122]];

/// The sun in front of her, at her left; the sky.
pub(super) fn lights() -> LightRig {
    LightRig {
        key: KeyLight {
            toward: Vec3::new(0.75, 1.15, 0.60),
            color: [1.58, 1.46, 1.24],
            angular_radius: 0.025,
        },
        boxes: vec![
            SoftBox {
                toward: Vec3::new(-0.9, 0.5, 0.4),
                color: [0.20, 0.26, 0.34],
                focus: 2.0,
            },
            SoftBox {
                toward: Vec3::new(-0.3, 0.6, -1.0),
                color: [0.45, 0.50, 0.56],
                focus: 3.0,
            },
        ],
        zenith: [0.34, 0.42, 0.56],
        horizon: [0.28, 0.31, 0.34],
        nadir: [0.15, 0.19, 0.10],
        exposure: 1.0,
    }
}

/// Grass, trees, mountains and sky; painted once.
pub(super) fn landscape() -> Option<&'static Landscape> {
    static PAINTED: OnceLock<Option<Landscape>> = OnceLock::new();
    PAINTED.get_or_init(paint).as_ref()
}

fn paint() -> Option<Landscape> {
    let grass = Floor {
        paint: floors::grass(
            [70, 82, 36],
            [[62, 86, 34], [92, 118, 46], [122, 146, 60], [158, 172, 86]],
        )?,
        repeat: 1.7,
        mirror: 0.0,
        waves: 0.0,
    };
    Some(Landscape {
        far: panorama()?,
        beyond: grass.clone(),
        near: grass,
        shore: Shore::NONE,
        pool: 200.0,
        haze: [0.24, 0.33, 0.15],
        haze_distance: 45.0,
        glow: 0.10,
        turn: 0.0,
    })
}

fn panorama() -> Option<Panorama> {
    let heaps = Fractal {
        period: [30, 30],
        octaves: 6,
        seed: 51,
    };
    let rock = Fractal {
        period: [96, 96],
        octaves: 5,
        seed: 52,
    };
    let mut canvas = Canvas::of_sky(
        |_| 0.0,
        |azimuth, sine| {
            let sky = clouded(&heaps, clear_sky(sine), azimuth, sine);
            let far = mountains(&rock, sky, [azimuth, sine], FAR_RIDGE);
            mountains(&rock, far, [azimuth, sine], NEAR_RIDGE)
        },
    )?;
    plant(&mut canvas);
    canvas.finish()
}

fn clear_sky(sine: f32) -> Vec3 {
    ramp(
        &[
            (0.0, Vec3::new(0.66, 0.80, 0.90)),
            (0.06, Vec3::new(0.50, 0.70, 0.88)),
            (0.16, Vec3::new(0.30, 0.54, 0.82)),
            (0.30, Vec3::new(0.19, 0.42, 0.75)),
            (0.66, Vec3::new(0.11, 0.30, 0.64)),
        ],
        sine,
    )
}

/// Heaps of clouds with flat bases, lit from the upper right.
fn clouded(noise: &Fractal, sky: Vec3, azimuth: f32, sine: f32) -> Vec3 {
    let around = (azimuth / TAU + 0.5) * 30.0;
    let density = |around: f32, sine: f32| {
        let cover = noise.every(15).at(around * 0.5, sine * 11.0 + 7.0);
        let fluff = noise.at(around * 2.0, sine * 34.0);
        let below = smooth_between(0.03, 0.09, sine);
        0.62 * cover + 0.48 * fluff - 0.10 * (1.0 - below)
    };
    let here = density(around, sine);
    let thick = smooth_between(0.59, 0.675, here);
    if thick <= 0.0 {
        return sky;
    }
    let toward_light = density(around + 0.07, sine + 0.008);
    let shadow = smooth_between(-0.035, 0.075, toward_light - here + 0.5 * (here - 0.64));
    let white = Vec3::new(0.97, 0.97, 0.95).lerp(Vec3::new(0.62, 0.69, 0.76), 0.85 * shadow);
    let white = white.lerp(sky, 0.25 * (1.0 - smooth_between(0.0, 0.1, sine)));
    sky.lerp(white, thick)
}

/// A range of mountains.
#[derive(Debug, Clone, Copy)]
struct Range {
    /// How high it stands, as the sine of an elevation.
    high: f32,
    /// Row of the noise that it is cut from.
    row: f32,
    /// Ridges around the horizon.
    ridges: f32,
    /// In shadow and in light.
    colors: [Vec3; 2],
    /// What air adds.
    haze: Vec3,
    haze_share: f32,
}

const FAR_RIDGE: Range = Range {
    high: 0.115,
    row: 5.0,
    ridges: 48.0,
    colors: [Vec3::new(0.16, 0.27, 0.27), Vec3::new(0.34, 0.46, 0.36)],
    haze: Vec3::new(0.50, 0.65, 0.76),
    haze_share: 0.42,
};
const NEAR_RIDGE: Range = Range {
    high: 0.066,
    row: 29.0,
    ridges: 48.0,
    colors: [Vec3::new(0.07, 0.15, 0.09), Vec3::new(0.22, 0.36, 0.15)],
    haze: Vec3::new(0.46, 0.60, 0.66),
    haze_share: 0.16,
};

/// Steep slopes with flutes from crest to foot, as rain cuts them; mist lies at the foot.
fn mountains(noise: &Fractal, behind: Vec3, [azimuth, sine]: [f32; 2], range: Range) -> Vec3 {
    let around = (azimuth / TAU + 0.5) * range.ridges;
    let crest = |around: f32| {
        let broad = noise.every(24).at(around * 0.5, range.row);
        let sharp = 1.0 - (noise.at(around * 2.0, range.row + 9.0) - 0.5).abs() * 3.0;
        range.high * (0.25 + 0.85 * broad + 0.16 * sharp - 0.08)
    };
    let top = crest(around);
    if sine > top + 0.002 {
        return behind;
    }
    let down = ((top - sine) / range.high).clamp(0.0, 1.0);
    // A flute is a valley that widens downward: it bends with a noise of its own.
    let bend = noise.at(around * 2.0, range.row + 17.0 + down * 2.0) - 0.5;
    let flute = |at: f32| (noise.at(at * 4.0, range.row + 3.0 + down * 0.7) - 0.5).abs() * 2.0;
    let at = around + 0.35 * bend * down;
    let slope = (flute(at + 0.03) - flute(at - 0.03)) * 3.2
        + (crest(around + 0.05) - crest(around - 0.05)) * -9.0;
    let rough = noise.at(around * 8.0, sine * 160.0) - 0.5;
    let lit = (0.52 + slope + 0.55 * rough).clamp(0.0, 1.0);
    let rock = range.colors[0].lerp(range.colors[1], lit);
    let misty = range.haze_share + 0.45 * smooth_between(0.35, 1.0, down);
    let color = rock.lerp(range.haze, misty.min(0.88));
    let covered = 1.0 - smooth_between(top - 0.0012, top + 0.0012, sine);
    behind.lerp(color, covered)
}

/// A belt of trees all around, single ones before it, palms in groups.
fn plant(canvas: &mut Canvas) {
    hedge(canvas);
    for index in 0..84_u16 {
        let wave = trig::sin(f32::from(index) * 1.9);
        let azimuth = -3.105 + f32::from(index) * 0.0748;
        let tree = Tree {
            place: Place {
                azimuth,
                distance: 150.0 + 12.0 * wave,
            },
            size: [8.4 + wave, 6.4 + 1.6 * trig::sin(f32::from(index) * 2.7)],
            bare: 0.0,
            greens: FAR_LEAVES,
            trunk: TRUNK[0],
            lit: 1.0,
            seed: 300 + u64::from(index),
        };
        tree.paint(canvas);
    }
    for (seed, [azimuth, distance, height]) in (1_u64..).zip([
        [-0.20, 128.0, 13.5],
        [-0.155, 132.0, 11.5],
        [0.185, 126.0, 13.0],
        [0.235, 120.0, 12.0],
        [-1.05, 90.0, 13.0],
        [1.15, 88.0, 12.0],
        [2.10, 92.0, 13.0],
        [-2.30, 90.0, 12.0],
        [-0.255, 98.0, 11.5],
        [0.29, 92.0, 10.5],
        [-0.33, 84.0, 11.0],
        [0.365, 80.0, 11.5],
    ]) {
        Palm {
            place: Place { azimuth, distance },
            height,
            lean: if seed % 2 == 0 { 1.3 } else { -1.0 },
            greens: PALM,
            trunk: TRUNK,
            lit: 1.0,
            seed,
        }
        .paint(canvas);
    }
    for (seed, [azimuth, distance, wide, high]) in (1_u64..).zip([
        [-0.40, 104.0, 10.0, 8.0],
        [0.44, 108.0, 11.0, 8.0],
        [-0.75, 82.0, 11.0, 9.5],
        [0.80, 86.0, 11.0, 9.0],
        [-1.60, 75.0, 9.0, 8.5],
        [1.75, 80.0, 10.0, 9.0],
        [2.75, 78.0, 9.0, 9.0],
        [0.10, 134.0, 8.5, 6.6],
        [-0.07, 138.0, 8.0, 6.0],
    ]) {
        let tree = Tree {
            place: Place { azimuth, distance },
            size: [wide, high],
            bare: 0.25,
            greens: LEAVES,
            trunk: TRUNK[0],
            lit: 1.0,
            seed,
        };
        tree.paint(canvas);
    }
}

/// What closes the belt of trees below.
fn hedge(canvas: &mut Canvas) {
    let place = Place {
        azimuth: 0.0,
        distance: 150.0,
    };
    for (ink, top) in [(FAR_LEAVES[0], 2.6), (FAR_LEAVES[1], 1.6)] {
        let around = 150.0 * PI;
        let corners = [
            [-around, -0.6],
            [around, -0.6],
            [around, top],
            [-around, top],
        ];
        if let Some(path) = polygon(corners.into_iter().map(Vec2::from)) {
            canvas.fill(&path, ink, place);
        }
    }
}
