//! A stage: a lit cloth at the back, ferns at its foot, lamps through haze, dark curtains at the sides and the house
//! before it.

use super::canvas::{Canvas, Place};
use super::floors;
use super::noise::{Fractal, ramp, smooth_between};
use super::plants::{Greens, ferns};
use glam::{Vec2, Vec3};
use lole_costume::document::StageMood;
use lole_geom::trig;
use lole_render::backdrop::{Floor, Panorama, Shore};
use lole_render::{KeyLight, Landscape, LightRig, SoftBox};
use std::f32::consts::TAU;
use std::sync::OnceLock;

/// Direction of the innermost folds of the curtains [rad], and of the outermost.
const CURTAINS: [f32; 2] = [0.37, 1.35];
/// How far away the cloth is [m], as the camera in front has it.
const BACK: f32 = 12.0;
const FERNS: Greens = [[12, 11, 18], [16, 17, 21], [21, 25, 25], [29, 31, 35]];

/// The colors of a mood, linear.
struct Colors {
    /// The cloth from its foot up: at sines of the elevation of -0.11, -0.05, 0.02, 0.10, 0.22 and 0.40.
    cloth: [[f32; 3]; 6],
    /// A pool of light on it.
    pool: [f32; 3],
    /// Lamps behind her, at her right and at her left.
    lamps: [[f32; 3]; 2],
    /// The lamp on her.
    key: [f32; 3],
}

impl Colors {
    const fn of(mood: StageMood) -> Self {
        match mood {
            StageMood::Tender => Self {
                cloth: [
                    [0.36, 0.10, 0.23],
                    [0.24, 0.075, 0.24],
                    [0.115, 0.052, 0.22],
                    [0.046, 0.034, 0.145],
                    [0.018, 0.018, 0.070],
                    [0.008, 0.009, 0.030],
                ],
                pool: [0.045, 0.026, 0.075],
                lamps: [[1.25, 0.70, 0.85], [0.45, 0.75, 1.35]],
                key: [1.62, 1.46, 1.20],
            },
            StageMood::Joyful => Self {
                cloth: [
                    [0.62, 0.27, 0.055],
                    [0.46, 0.17, 0.055],
                    [0.27, 0.085, 0.070],
                    [0.12, 0.040, 0.075],
                    [0.045, 0.018, 0.046],
                    [0.016, 0.008, 0.020],
                ],
                pool: [0.10, 0.045, 0.020],
                lamps: [[1.45, 0.85, 0.45], [1.20, 0.60, 0.75]],
                key: [1.70, 1.50, 1.20],
            },
            StageMood::Sea => Self {
                cloth: [
                    [0.050, 0.30, 0.32],
                    [0.028, 0.19, 0.28],
                    [0.020, 0.105, 0.22],
                    [0.014, 0.052, 0.145],
                    [0.009, 0.024, 0.075],
                    [0.005, 0.010, 0.032],
                ],
                pool: [0.015, 0.050, 0.070],
                lamps: [[0.45, 1.05, 1.10], [0.40, 0.70, 1.40]],
                key: [1.52, 1.46, 1.30],
            },
            StageMood::Solemn => Self {
                cloth: [
                    [0.050, 0.046, 0.075],
                    [0.034, 0.032, 0.060],
                    [0.020, 0.021, 0.045],
                    [0.012, 0.013, 0.030],
                    [0.007, 0.008, 0.018],
                    [0.004, 0.004, 0.010],
                ],
                pool: [0.020, 0.020, 0.030],
                lamps: [[0.60, 0.62, 0.75], [0.50, 0.58, 0.80]],
                key: [1.70, 1.52, 1.22],
            },
        }
    }
}

/// A lamp from the front, colored ones from behind.
pub(super) fn lights(mood: StageMood) -> LightRig {
    let colors = Colors::of(mood);
    LightRig {
        key: KeyLight {
            toward: Vec3::new(0.55, 1.15, 0.95),
            color: colors.key,
            angular_radius: 0.05,
        },
        boxes: vec![
            SoftBox {
                toward: Vec3::new(-0.9, 0.6, -0.8),
                color: colors.lamps[0],
                focus: 5.0,
            },
            SoftBox {
                toward: Vec3::new(0.9, 0.5, -0.9),
                color: colors.lamps[1],
                focus: 5.0,
            },
            SoftBox {
                toward: Vec3::new(-0.9, 0.35, 0.7),
                color: [0.12, 0.13, 0.18],
                focus: 2.0,
            },
        ],
        zenith: [0.05, 0.05, 0.08],
        horizon: [0.06, 0.055, 0.09],
        nadir: [0.10, 0.075, 0.055],
        exposure: 1.0,
    }
}

/// Boards, cloth and curtains; painted once.
pub(super) fn landscape(mood: StageMood) -> Option<&'static Landscape> {
    static PAINTED: [OnceLock<Option<Landscape>>; StageMood::ALL.len()] =
        [const { OnceLock::new() }; StageMood::ALL.len()];
    let place = StageMood::ALL.iter().position(|it| *it == mood)?;
    PAINTED[place]
        .get_or_init(|| paint(&Colors::of(mood)))
        .as_ref()
}

fn paint(colors: &Colors) -> Option<Landscape> {
    Some(Landscape {
        far: panorama(colors)?,
        near: Floor {
            paint: floors::boards([150, 108, 74], 18)?,
            repeat: 1.75,
            mirror: 0.34,
            waves: 0.0,
        },
        beyond: Floor {
            paint: floors::even(Vec3::new(0.006, 0.005, 0.008))?,
            repeat: 1.0,
            mirror: 0.0,
            waves: 0.0,
        },
        // The edge of the stage: the house lies before it.
        shore: Shore {
            toward: [0.0, 1.0],
            distance: 3.4,
            foam: 0.0,
            foam_color: [0.0; 3],
        },
        pool: 2.7,
        // The dark of the house.
        haze: [0.006, 0.005, 0.009],
        haze_distance: 60.0,
        glow: 0.22,
        turn: 0.0,
    })
}

fn panorama(colors: &Colors) -> Option<Panorama> {
    let noise = Fractal {
        period: [32, 32],
        octaves: 4,
        seed: 71,
    };
    let mut canvas = Canvas::of_sky(foot, |azimuth, sine| {
        if azimuth.abs() > CURTAINS[1] {
            return house(azimuth, sine);
        }
        let cloth = cloth(&noise, colors, [azimuth, sine]);
        let folds = curtain(colors, azimuth, sine);
        let inner = smooth_between(CURTAINS[0] - 0.004, CURTAINS[0] + 0.004, azimuth.abs());
        let behind = cloth.lerp(folds, inner);
        beams(&noise, colors, behind, [azimuth, sine])
    })?;
    for (seed, azimuth) in (1_u64..).zip([-0.37, -0.31, -0.25, -0.19, 0.19, 0.25, 0.31, 0.37]) {
        let far: f32 = azimuth;
        let place = Place {
            azimuth,
            distance: BACK * 0.97,
        };
        ferns(
            &mut canvas,
            place,
            [0.5, 0.1 + 3.4 * far.abs()],
            FERNS,
            seed,
        );
    }
    canvas.finish()
}

/// Where the cloth and the curtains touch the boards.
fn foot(azimuth: f32) -> f32 {
    let wall = -1.25 / BACK * trig::cos(azimuth);
    if azimuth.abs() < CURTAINS[0] {
        wall
    } else if azimuth.abs() < CURTAINS[1] {
        wall * 1.08
    } else {
        0.0
    }
}

/// The cloth at the back: lamps at its foot and above wash it with color.
fn cloth(noise: &Fractal, colors: &Colors, [azimuth, sine]: [f32; 2]) -> Vec3 {
    let heights = [-0.11, -0.05, 0.02, 0.10, 0.22, 0.40];
    let stops: [(f32, Vec3); 6] =
        std::array::from_fn(|stop| (heights[stop], Vec3::from(colors.cloth[stop])));
    let wash = ramp(&stops, sine);
    // Lamps on the floor stand side by side: their cones overlap.
    let lamps = 0.90 + 0.10 * trig::cos(azimuth * 41.0) * (1.0 - smooth_between(-0.10, 0.0, sine));
    let side = 1.0 - 0.5 * smooth_between(0.05, 0.42, azimuth.abs());
    // A moon of light, and leaves cut from a sheet before a lamp.
    let off = Vec2::new(azimuth, sine - 0.02);
    let pool = 1.0 / (1.0 + off.length_squared() / (0.12 * 0.12));
    let leaves = noise.at((azimuth / TAU + 0.5) * 32.0 * 3.0, sine * 36.0);
    let mottled = 1.0 + 0.20 * (leaves - 0.5) * smooth_between(0.08, 0.3, sine);
    wash * (lamps * side * mottled) + Vec3::from(colors.pool) * pool
}

/// Velvet in folds, with the color of the cloth on their edges.
fn curtain(colors: &Colors, azimuth: f32, sine: f32) -> Vec3 {
    let wave = trig::sin(azimuth.abs() * 105.0 + 1.2 * trig::sin(azimuth.abs() * 41.0));
    let toward = 0.5 + 0.5 * wave;
    let near = 1.0 - smooth_between(CURTAINS[0], CURTAINS[0] + 0.35, azimuth.abs());
    let low = 1.0 - 0.7 * smooth_between(0.0, 0.5, sine);
    Vec3::new(0.010, 0.007, 0.016)
        + Vec3::from(colors.cloth[0]) * 0.22 * (toward * toward * (0.25 + 0.75 * near) * low)
}

/// Light that haze shows on its way from lamps above to the boards.
fn beams(noise: &Fractal, colors: &Colors, behind: Vec3, [azimuth, sine]: [f32; 2]) -> Vec3 {
    let [right, left] = colors.lamps.map(|lamp| Vec3::from(lamp) * 0.085);
    let mut light = Vec3::ZERO;
    // Where a lamp hangs, where its beam goes, how wide it is there, its color.
    for (from, to, wide, color) in [
        (-0.38, -0.05, 0.075, right),
        (0.36, 0.06, 0.075, left),
        (-0.16, -0.24, 0.05, right * 0.7),
        (0.18, 0.27, 0.05, left * 0.8),
    ] {
        let down = ((0.34 - sine) / 0.42).clamp(0.0, 1.2);
        let middle = from + (to - from) * down;
        let half = 0.008 + wide * down;
        let across = (azimuth - middle) / half;
        let inside = (1.0 - across * across).max(0.0);
        light += color * (inside * inside * (1.0 - 0.72 * down));
    }
    let haze = noise.at((azimuth / TAU + 0.5) * 32.0, sine * 9.0 + 3.0);
    behind + light * (0.55 + 0.9 * haze)
}

/// The dark house: rows of seats are guessed, small lamps show the ways out.
fn house(azimuth: f32, sine: f32) -> Vec3 {
    let rows = 0.5 + 0.5 * trig::sin(sine * 130.0);
    let seats = 0.5 + 0.5 * trig::sin(azimuth * 170.0 + if rows > 0.5 { 1.6 } else { 0.0 });
    let shown = 1.0 - smooth_between(0.02, 0.20, sine);
    let lamp = |side: f32| {
        let off = Vec2::new(azimuth - side, sine - 0.11);
        1.0 / (1.0 + off.length_squared() / (0.006 * 0.006))
    };
    Vec3::new(0.006, 0.005, 0.008)
        + Vec3::new(0.006, 0.004, 0.005) * (rows * seats * shown)
        + Vec3::new(0.03, 0.16, 0.07) * (lamp(2.2) + lamp(-2.2))
}
