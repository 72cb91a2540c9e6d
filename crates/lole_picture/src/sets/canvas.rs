//! What sets are painted on: a panorama of all directions, and tiles of floors that repeat.

use super::noise::hash;
use glam::{Vec2, Vec3, Vec4};
use lole_geom::srgb::linear_from_srgb;
use lole_render::Texture;
use lole_render::backdrop::Panorama;
use lole_render::srgb::SrgbTable;
use rayon::prelude::*;
use std::f32::consts::TAU;
use std::sync::Arc;
use tiny_skia::{Color, FillRule, LineCap, Paint, Path, Pixmap, Stroke, Transform};

/// Columns of a panorama: eleven for a degree. A film shows each three times as wide: what is far away is as soft as
/// behind a portrait's depth of field.
const COLUMNS: u16 = 4096;
const ROWS: u16 = 512;
/// Sine of the elevation at its upper and its lower edge: even steps across and down.
const TOP: f32 = 0.66;
const BOTTOM: f32 = -0.12;
/// Height of the eye that a panorama is painted for [m].
const EYE: f32 = 1.25;

/// sRGB, as a painter mixes it.
pub(super) type Ink = [u8; 3];

/// What floors mirror is this many times as coarse.
const MIRROR_STEP: usize = 4;

/// A panorama while it is painted.
pub(super) struct Canvas {
    picture: Pixmap,
    /// What floors mirror: what was there before anything was painted on it.
    mirrored: Arc<Texture>,
}

/// Where something stands that is painted on a panorama.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// Direction [rad], 0 at `-Z`, growing to the right.
    pub(super) azimuth: f32,
    /// How far away it is [m].
    pub(super) distance: f32,
}

impl Canvas {
    /// A panorama of a color for each direction, by azimuth [rad] and sine of the elevation; linear. Nothing stands
    /// where that sine is below what `foot` says for an azimuth: the floor shows.
    pub(super) fn of_sky(
        foot: impl Fn(f32) -> f32 + Sync,
        color: impl Fn(f32, f32) -> Vec3 + Sync,
    ) -> Option<Self> {
        let srgb = SrgbTable::new();
        let mut picture = Pixmap::new(COLUMNS.into(), ROWS.into())?;
        let row_bytes = usize::from(COLUMNS) * 4;
        let rows = (picture.data_mut()).par_chunks_mut(row_bytes).zip(0..ROWS);
        rows.for_each(|(bytes, row)| {
            let sine = sine_of(f32::from(row) + 0.5);
            for (pixel, column) in bytes.chunks_exact_mut(4).zip(0..COLUMNS) {
                let azimuth = ((f32::from(column) + 0.5) / f32::from(COLUMNS) - 0.5) * TAU;
                let step = (TOP - BOTTOM) / f32::from(ROWS);
                let cover = ((sine - foot(azimuth)) / step + 0.5).clamp(0.0, 1.0);
                if cover <= 0.0 {
                    continue;
                }
                // Less than a step of eight bits, so that skies show no bands.
                let grain = (hash(column.into(), row.into(), 11) - 0.5) * (2.2 / 255.0);
                let color = color(azimuth, sine);
                let [r, g, b] = srgb.encode(color + color.map(|part| part.max(0.0).sqrt()) * grain);
                let parts = [r, g, b, 255].map(|part| byte(f32::from(part) * cover));
                pixel.copy_from_slice(&parts);
            }
        });
        let mirrored = Arc::new(coarser(&picture)?);
        Some(Self { picture, mirrored })
    }

    /// Fills a shape that is given in meters: to the right of a place, and up from the floor there.
    pub(super) fn fill(&mut self, path: &Path, ink: Ink, place: Place) {
        let paint = paint(ink, 255);
        for around in place.seen(path).into_iter().flatten() {
            (self.picture).fill_path(path, &paint, FillRule::Winding, around, None);
        }
    }

    /// Draws lines, given in the same way, of a width [m].
    pub(super) fn stroke(&mut self, path: &Path, ink: Ink, width: f32, place: Place) {
        let stroke = Stroke {
            width,
            line_cap: LineCap::Round,
            ..Stroke::default()
        };
        for around in place.seen(path).into_iter().flatten() {
            (self.picture).stroke_path(path, &paint(ink, 255), &stroke, around, None);
        }
    }

    /// The finished panorama, a little softer than its pixels.
    pub(super) fn finish(self) -> Option<Panorama> {
        let (width, height) = (usize::from(COLUMNS), usize::from(ROWS));
        let source = self.picture.data();
        let pixel = |x: usize, y: usize| {
            let start = (y * width + x) * 4;
            let parts: [f32; 4] = std::array::from_fn(|part| f32::from(source[start + part]));
            Vec4::from(parts)
        };
        let softened = |x: usize, y: usize| {
            let columns = [(x + width - 1) % width, x, (x + 1) % width];
            let row = |y: usize| {
                let [left, middle, right] = columns.map(|x| pixel(x, y));
                left + middle * 2.0 + right
            };
            let (above, below) = (y.saturating_sub(1), (y + 1).min(height - 1));
            (row(above) + row(y) * 2.0 + row(below)) / 16.0
        };
        let mut pixels = vec![0; source.len()];
        let rows = pixels.par_chunks_mut(width * 4).enumerate();
        rows.for_each(|(y, row)| {
            for (x, out) in row.chunks_exact_mut(4).enumerate() {
                out.copy_from_slice(&straight(softened(x, y).to_array()));
            }
        });
        let texture = Texture::new(COLUMNS.into(), ROWS.into(), pixels).ok()?;
        Some(Panorama {
            picture: Arc::new(texture),
            mirrored: self.mirrored,
            top: TOP,
            bottom: BOTTOM,
        })
    }
}

impl Place {
    /// Where a path that is given in meters lies on the picture: what leaves it at one side comes back at the other.
    fn seen(self, path: &Path) -> [Option<Transform>; 3] {
        let here = self.transform();
        let columns = f32::from(COLUMNS);
        let left = path.bounds().left() * here.sx + here.tx;
        let right = path.bounds().right() * here.sx + here.tx;
        // A line is a little wider than its path.
        let rim = here.sx;
        let shifted = |by: f32, is_seen: bool| is_seen.then(|| here.post_translate(by, 0.0));
        [
            Some(here),
            shifted(columns, left - rim < 0.0),
            shifted(-columns, right + rim > columns),
        ]
    }

    fn transform(self) -> Transform {
        let across = f32::from(COLUMNS) / TAU;
        let down = f32::from(ROWS) / (TOP - BOTTOM);
        Transform::from_row(
            across / self.distance,
            0.0,
            0.0,
            -down / self.distance,
            (self.azimuth / TAU + 0.5) * f32::from(COLUMNS),
            (TOP + EYE / self.distance) * down,
        )
    }
}

/// A picture with the mean of each square of pixels.
fn coarser(picture: &Pixmap) -> Option<Texture> {
    let [width, height] = [usize::from(COLUMNS), usize::from(ROWS)].map(|side| side / MIRROR_STEP);
    let mut pixels = Vec::with_capacity(width * height * 4);
    for y in 0..height {
        for x in 0..width {
            let mut sum = [0.0; 4];
            for inner in 0..MIRROR_STEP * MIRROR_STEP {
                let [right, below] = [inner % MIRROR_STEP, inner / MIRROR_STEP];
                let row = (y * MIRROR_STEP + below) * usize::from(COLUMNS);
                let start = (row + x * MIRROR_STEP + right) * 4;
                let parts = &picture.data()[start..start + 4];
                for (sum, part) in sum.iter_mut().zip(parts) {
                    *sum += f32::from(*part);
                }
            }
            let share = 1.0 / (MIRROR_STEP * MIRROR_STEP) as f32;
            pixels.extend(straight(sum.map(|sum| sum * share)));
        }
    }
    let [width, height] = [width, height].map(|side| u32::try_from(side).unwrap_or(0));
    Texture::new(width, height, pixels).ok()
}

/// Sine of the elevation at a row of a panorama.
fn sine_of(row: f32) -> f32 {
    TOP - row / f32::from(ROWS) * (TOP - BOTTOM)
}

/// A square tile of a floor while it is painted: what leaves it at one side comes back at the other.
pub(super) struct Tile {
    pixels: Pixmap,
    side: u16,
}

impl Tile {
    /// A tile of `side` pixels with a color for each place, given as shares of the side; linear.
    pub(super) fn of(side: u16, color: impl Fn(Vec2) -> Vec3 + Sync) -> Option<Self> {
        let srgb = SrgbTable::new();
        let mut pixels = Pixmap::new(side.into(), side.into())?;
        let rows = pixels.data_mut().par_chunks_mut(usize::from(side) * 4);
        rows.zip(0..side).for_each(|(bytes, row)| {
            for (pixel, column) in bytes.chunks_exact_mut(4).zip(0..side) {
                let place = Vec2::new(f32::from(column) + 0.5, f32::from(row) + 0.5);
                let [r, g, b] = srgb.encode(color(place / f32::from(side)));
                pixel.copy_from_slice(&[r, g, b, 255]);
            }
        });
        Some(Self { pixels, side })
    }

    /// Fills a shape that is given as shares of the side, wherever it comes back.
    pub(super) fn fill(&mut self, path: &Path, ink: Ink, alpha: u8) {
        let paint = paint(ink, alpha);
        let side = f32::from(self.side);
        let bounds = path.bounds();
        for (right, below) in [
            (0, 0),
            (1, 0),
            (0, 1),
            (1, 1),
            (-1, 0),
            (0, -1),
            (-1, -1),
            (1, -1),
            (-1, 1),
        ] {
            let (right, below) = (right as f32, below as f32);
            let seen = bounds.right() + right > 0.0
                && bounds.left() + right < 1.0
                && bounds.bottom() + below > 0.0
                && bounds.top() + below < 1.0;
            if seen {
                let place = Transform::from_row(side, 0.0, 0.0, side, right * side, below * side);
                (self.pixels).fill_path(path, &paint, FillRule::Winding, place, None);
            }
        }
    }

    /// The finished tile.
    pub(super) fn finish(self) -> Option<Arc<Texture>> {
        let side = u32::from(self.side);
        Texture::new(side, side, self.pixels.take())
            .ok()
            .map(Arc::new)
    }
}

fn paint(ink: Ink, alpha: u8) -> Paint<'static> {
    let [r, g, b] = ink;
    let mut paint = Paint {
        anti_alias: true,
        ..Paint::default()
    };
    paint.set_color(Color::from_rgba8(r, g, b, alpha));
    paint
}

/// From colors that are multiplied by their alpha to those that are not.
fn straight([r, g, b, alpha]: [f32; 4]) -> [u8; 4] {
    let by = if alpha > 0.5 { 255.0 / alpha } else { 0.0 };
    [r * by, g * by, b * by, alpha].map(byte)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "cut to 0..=255 before"
)]
fn byte(value: f32) -> u8 {
    (value + 0.5).clamp(0.0, 255.0) as u8
}

/// An ink as light.
pub(super) fn light(ink: Ink) -> Vec3 {
    Vec3::from(ink.map(|byte| linear_from_srgb(f32::from(byte) / 255.0)))
}
