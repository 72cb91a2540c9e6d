//! A beach at dusk: the sun stands low over the sea at her right; palms go along the shore at her left.

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

/// Towards the sun.
const SUN: [f32; 3] = [-0.88, 0.34, -0.62];
/// Sine of the elevation at which it is painted: the light that reaches her comes from the bright sky above it too.
const SUN_SINE: f32 = 0.055;
/// Direction to the sun [rad], 0 at `-Z`.
const SUN_AZIMUTH: f32 = -0.957;

const GREENS: Greens = [[26, 28, 26], [48, 47, 34], [88, 72, 42], [148, 104, 54]];
/// The same behind more air.
const FAR_GREENS: Greens = [[52, 46, 48], [66, 58, 52], [96, 78, 60], [134, 100, 72]];
const TRUNK: [[u8; 3]; 2] = [[44, 34, 32], [132, 88, 60]];

/// The low sun behind her, at the side; the sky in front of her lights face and cloth.
pub(super) fn lights() -> LightRig {
    LightRig {
        key: KeyLight {
            toward: Vec3::from(SUN),
            color: [2.0, 1.2, 0.62],
            angular_radius: 0.03,
        },
        boxes: vec![
            SoftBox {
                toward: Vec3::new(0.45, 0.40, 1.0),
                color: [0.74, 0.62, 0.56],
                focus: 2.0,
            },
            SoftBox {
                toward: Vec3::new(-0.7, 0.35, 0.7),
                color: [0.30, 0.22, 0.20],
                focus: 2.0,
            },
        ],
        zenith: [0.26, 0.28, 0.40],
        horizon: [0.42, 0.30, 0.28],
        nadir: [0.24, 0.18, 0.14],
        exposure: 1.0,
    }
}

/// Sea, sand and palms; painted once.
pub(super) fn landscape() -> Option<&'static Landscape> {
    static PAINTED: OnceLock<Option<Landscape>> = OnceLock::new();
    PAINTED.get_or_init(paint).as_ref()
}

fn paint() -> Option<Landscape> {
    Some(Landscape {
        far: panorama()?,
        near: Floor {
            paint: floors::sand([170, 140, 117])?,
            repeat: 2.6,
            mirror: 0.0,
            waves: 0.0,
        },
        beyond: Floor {
            paint: floors::water([48, 78, 102])?,
            repeat: 7.0,
            mirror: 0.80,
            waves: 1.8,
        },
        shore: Shore {
            toward: [-0.5, -0.866],
            distance: 7.6,
            foam: 0.42,
            foam_color: [0.62, 0.50, 0.46],
        },
        pool: 60.0,
        haze: [0.46, 0.31, 0.33],
        haze_distance: 700.0,
        glow: 0.14,
        turn: 0.0,
    })
}

fn panorama() -> Option<Panorama> {
    let veils = Fractal {
        period: [64, 64],
        octaves: 5,
        seed: 1,
    };
    let banks = Fractal {
        period: [36, 36],
        octaves: 5,
        seed: 2,
    };
    let mut canvas = Canvas::of_sky(
        |_| 0.0,
        |azimuth, sine| {
            let sky = clear_sky(azimuth, sine);
            let sky = veiled(&veils, sky, azimuth, sine);
            let sky = banked(&banks, sky, azimuth, sine);
            islands(&banks, sky, azimuth, sine)
        },
    )?;
    grove(&mut canvas);
    canvas.finish()
}

/// The sky without clouds: the colors of dusk, warmer toward the sun.
fn clear_sky(azimuth: f32, sine: f32) -> Vec3 {
    let toward_sun = 0.5 + 0.5 * trig::cos(azimuth - SUN_AZIMUTH);
    let warm = ramp(
        &[
            (0.0, Vec3::new(1.0, 0.58, 0.24)),
            (0.035, Vec3::new(0.95, 0.49, 0.25)),
            (0.085, Vec3::new(0.64, 0.37, 0.32)),
            (0.15, Vec3::new(0.33, 0.30, 0.43)),
            (0.26, Vec3::new(0.17, 0.23, 0.43)),
            (0.66, Vec3::new(0.08, 0.14, 0.33)),
        ],
        sine,
    );
    let cool = ramp(
        &[
            (0.0, Vec3::new(0.62, 0.36, 0.36)),
            (0.05, Vec3::new(0.50, 0.33, 0.40)),
            (0.13, Vec3::new(0.27, 0.27, 0.42)),
            (0.26, Vec3::new(0.15, 0.21, 0.41)),
            (0.66, Vec3::new(0.08, 0.14, 0.33)),
        ],
        sine,
    );
    let off = Vec2::new((azimuth - SUN_AZIMUTH) * 0.75, sine - SUN_SINE);
    let near = 1.0 / (1.0 + off.length_squared() / (0.16 * 0.16));
    let disk = 1.0 - smooth_between(0.011, 0.016, Vec2::new(off.x / 0.75, off.y).length());
    cool.lerp(warm, toward_sun * toward_sun)
        + Vec3::new(0.55, 0.30, 0.10) * (near * near + 0.25 * near)
        + Vec3::new(0.6, 0.6, 0.5) * disk
}

/// High thin clouds: a layer above the eye, seen ever more aslant toward the horizon.
fn veiled(noise: &Fractal, sky: Vec3, azimuth: f32, sine: f32) -> Vec3 {
    let shown = smooth_between(0.045, 0.13, sine);
    if shown <= 0.0 {
        return sky;
    }
    let (sin, cos) = trig::sin_cos(azimuth);
    let out = (1.0 - sine * sine).max(0.0).sqrt() / (sine + 0.02);
    let at = Vec2::new(sin, -cos) * out;
    let bent = Vec2::new(at.x * 0.62 + at.y * 0.25, at.y * 1.35);
    let density = noise.at(bent.x + 20.0, bent.y + 20.0);
    let thick = smooth_between(0.47, 0.74, density) * shown;
    let toward_sun = 0.5 + 0.5 * trig::cos(azimuth - SUN_AZIMUTH);
    let lit = Vec3::new(0.62, 0.34, 0.38).lerp(Vec3::new(1.0, 0.56, 0.30), toward_sun * toward_sun);
    let heart = Vec3::new(0.26, 0.22, 0.34);
    sky.lerp(
        lit.lerp(heart, smooth_between(0.60, 0.80, density)),
        0.78 * thick,
    )
}

/// Heaps of clouds over the horizon, lit at their rims.
fn banked(noise: &Fractal, sky: Vec3, azimuth: f32, sine: f32) -> Vec3 {
    let around = (azimuth / TAU + 0.5) * 36.0;
    let top = 0.035 + 0.085 * smooth_between(0.40, 0.75, noise.every(18).at(around * 0.5, 3.3));
    let fluff = noise.at(around, sine * 42.0) - 0.5;
    let depth = (top * (1.0 + 0.9 * fluff) - sine) / 0.035;
    let thick = smooth_between(0.0, 0.55, depth) * smooth_between(0.0, 0.012, sine);
    let toward_sun = 0.5 + 0.5 * trig::cos(azimuth - SUN_AZIMUTH);
    let rim = Vec3::new(0.74, 0.46, 0.44).lerp(Vec3::new(1.0, 0.66, 0.38), toward_sun);
    let heart = Vec3::new(0.30, 0.24, 0.35).lerp(Vec3::new(0.48, 0.29, 0.31), toward_sun);
    let inside = smooth_between(0.1, 1.6, depth + 1.4 * fluff);
    sky.lerp(rim.lerp(heart, inside), 0.82 * thick)
}

/// An island far out, and one farther.
fn islands(noise: &Fractal, sky: Vec3, azimuth: f32, sine: f32) -> Vec3 {
    let mut color = sky;
    for (middle, wide, high, ink, row) in [
        (0.10, 0.34, 0.034, Vec3::new(0.36, 0.26, 0.35), 11.0),
        (-0.42, 0.30, 0.052, Vec3::new(0.22, 0.17, 0.26), 19.0),
    ] {
        let off: f32 = (azimuth - middle) / wide;
        if off.abs() >= 1.0 {
            continue;
        }
        let ease = (1.0 - off * off) * (1.0 - 0.45 * off);
        let rough = noise.at((azimuth / TAU + 0.5) * 36.0 * 3.0, row) - 0.5;
        let ridge = high * ease * (0.72 + 0.9 * rough * ease);
        let covered = 1.0 - smooth_between(ridge - 0.0012, ridge + 0.0012, sine);
        let misty = ink.lerp(
            Vec3::new(0.62, 0.38, 0.35),
            0.45 * (1.0 - sine / high.max(1.0e-3)).clamp(0.0, 1.0),
        );
        color = color.lerp(misty, covered);
    }
    color
}

/// What grows on the land side: bushes in a row, palms before them.
fn grove(canvas: &mut Canvas) {
    // What the bushes grow out of.
    let place = Place {
        azimuth: 0.0,
        distance: 30.0,
    };
    for (ink, top) in [(FAR_GREENS[0], 1.15), (FAR_GREENS[1], 0.55)] {
        // From where the beach begins to behind her, and on to where it ends.
        for [from, to, rises, falls] in [[0.60, PI, 0.65, PI], [-PI, -2.28, -PI, -2.33]] {
            let corners = [[from, -0.15], [to, -0.15], [falls, top], [rises, top]];
            let corners = corners.map(|[azimuth, y]| Vec2::new(azimuth * place.distance, y));
            if let Some(path) = polygon(corners.into_iter()) {
                canvas.fill(&path, ink, place);
            }
        }
    }
    for index in 0..46_u8 {
        let share = f32::from(index) / 45.0;
        let azimuth = 0.62 + share * 2.49;
        let distance = 34.0 - 10.0 * share + 3.0 * trig::sin(f32::from(index) * 2.3);
        bush(canvas, azimuth, distance, u64::from(index));
    }
    for index in 0..16_u8 {
        let azimuth = -3.12 + f32::from(index) * 0.055;
        bush(canvas, azimuth, 24.0, 100 + u64::from(index));
    }
    // Direction, distance and height; the farther ones first.
    for (seed, [azimuth, distance, height, lean]) in (1_u64..).zip([
        [0.52, 27.0, 9.0, -0.6],
        [0.56, 30.0, 10.5, 0.8],
        [0.75, 25.0, 9.5, -1.2],
        [1.30, 24.0, 9.0, 1.0],
        [1.75, 22.0, 10.0, -1.4],
        [2.20, 26.0, 11.0, 1.2],
        [2.70, 24.0, 10.0, -0.6],
        [-2.85, 23.0, 9.0, 1.5],
        [0.66, 19.0, 9.5, -2.0],
        [1.02, 17.0, 8.5, -2.2],
        [1.52, 18.0, 9.0, 1.8],
        [0.395, 19.0, 7.2, -0.9],
    ]) {
        Palm {
            place: Place { azimuth, distance },
            height,
            lean,
            greens: GREENS,
            trunk: TRUNK,
            lit: -1.0,
            seed,
        }
        .paint(canvas);
    }
}

fn bush(canvas: &mut Canvas, azimuth: f32, distance: f32, seed: u64) {
    let tree = Tree {
        place: Place { azimuth, distance },
        size: [2.2, 1.9 + 0.6 * trig::sin(azimuth * 9.0)],
        bare: 0.0,
        greens: FAR_GREENS,
        trunk: TRUNK[0],
        lit: -1.0,
        seed: 900 + seed,
    };
    tree.paint(canvas);
}
