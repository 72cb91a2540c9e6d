//! Ink on cloth: draws motifs so that the repeat has no edge.

use glam::{Vec2, vec2};
use tiny_skia::{Color, FillRule, LineJoin, Paint, PixmapMut, Stroke, Transform};

use super::PrintDesign;
use super::geometry::{Part, Tint};
use super::layout::Placement;
use super::motif::Role;
use super::shape::{Ink, Layer};

/// Width of the gap of ground around a motif that lies on others. Repeat units.
const HALO: f32 = 0.0075;

/// The repeat while it is drawn.
pub(super) struct Canvas<'a> {
    design: &'a PrintDesign,
    size: u32,
    pixels: Vec<u8>,
}

impl<'a> Canvas<'a> {
    /// Bare ground of `size` × `size` pixels.
    pub(super) fn new(design: &'a PrintDesign, size: u32) -> Self {
        let [red, green, blue] = design.ground;
        let pixels = [red, green, blue, 255].repeat(size as usize * size as usize);
        Self {
            design,
            size,
            pixels,
        }
    }

    /// Draws one motif, and again wherever it crosses an edge of the repeat.
    pub(super) fn stamp(&mut self, placement: &Placement) {
        let layers = (placement.shape.draw)(placement.whim);
        let reach = 1.25 * placement.size;
        for shift in (-1..=1_i8).flat_map(|x| (-1..=1_i8).map(move |y| (x, y))) {
            let shift = vec2(f32::from(shift.0), f32::from(shift.1));
            let origin = placement.origin + shift;
            let low = origin - reach;
            let high = origin + reach;
            if low.max_element() < 1.0 && 0.0 < high.min_element() {
                self.stamp_once(placement, origin, &layers);
            }
        }
    }

    fn stamp_once(&mut self, placement: &Placement, origin: Vec2, layers: &[Layer]) {
        let side = self.size;
        #[expect(clippy::cast_precision_loss, reason = "at most 8192")]
        let scale = side as f32;
        let at = origin * scale;
        let transform = Transform::from_translate(at.x, at.y)
            .pre_concat(Transform::from_rotate(placement.angle.to_degrees()))
            .pre_scale(placement.size * scale, placement.size * scale);
        let colors = self.colors(placement.role);
        let Some(mut pixmap) = PixmapMut::from_bytes(&mut self.pixels, side, side) else {
            return;
        };
        let stroke = Stroke {
            width: 2.0 * HALO / placement.size,
            line_join: LineJoin::Round,
            ..Stroke::default()
        };
        for (ink, path) in layers {
            let Some(path) = path else { continue };
            let mut paint = Paint {
                anti_alias: true,
                ..Paint::default()
            };
            paint.set_color(colors(*ink));
            if *ink == Ink::Halo {
                pixmap.stroke_path(path, &paint, &stroke, transform, None);
            } else {
                pixmap.fill_path(path, &paint, FillRule::Winding, transform, None);
            }
        }
    }

    /// Draws a part of an ordered print, and again wherever it crosses an edge of the repeat.
    pub(super) fn draw(&mut self, part: &Part) {
        let Some(path) = &part.path else { return };
        let side = self.size;
        #[expect(clippy::cast_precision_loss, reason = "at most 8192")]
        let scale = side as f32;
        let PrintDesign {
            ground,
            flower,
            leaf,
            shadow,
            ..
        } = *self.design;
        let mut paint = Paint {
            anti_alias: true,
            ..Paint::default()
        };
        paint.set_color(opaque(match part.tint {
            Tint::Ground => ground,
            Tint::Flower => flower,
            Tint::Leaf => leaf,
            Tint::Shadow => shadow,
        }));
        let Some(mut pixmap) = PixmapMut::from_bytes(&mut self.pixels, side, side) else {
            return;
        };
        let reach = part.pen.unwrap_or(0.0);
        let bounds = path.bounds();
        for shift in (-1..=1_i8).flat_map(|x| (-1..=1_i8).map(move |y| (x, y))) {
            let (x, y) = (f32::from(shift.0), f32::from(shift.1));
            let inside = bounds.left() + x - reach < 1.0
                && 0.0 < bounds.right() + x + reach
                && bounds.top() + y - reach < 1.0
                && 0.0 < bounds.bottom() + y + reach;
            if !inside {
                continue;
            }
            let transform = Transform::from_scale(scale, scale).pre_translate(x, y);
            if let Some(width) = part.pen {
                let stroke = Stroke {
                    width,
                    line_join: LineJoin::Round,
                    ..Stroke::default()
                };
                pixmap.stroke_path(path, &paint, &stroke, transform, None);
            } else {
                pixmap.fill_path(path, &paint, FillRule::Winding, transform, None);
            }
        }
    }

    /// Which color each ink is for a motif.
    fn colors(&self, role: Role) -> impl Fn(Ink) -> Color + use<> {
        let PrintDesign {
            ground,
            flower,
            leaf,
            shadow,
            ..
        } = *self.design;
        let (own, other) = match role {
            Role::Shadow => (shadow, shadow),
            Role::Leaf => (leaf, flower),
            Role::Flower => (flower, leaf),
        };
        move |ink| match ink {
            Ink::Motif => opaque(own),
            Ink::Accent => opaque(other),
            Ink::Ground | Ink::Halo => opaque(ground),
            Ink::Vein => match role {
                Role::Flower => opaque(mix(own, other, 0.62)),
                _ => opaque(mix(own, ground, 0.55)),
            },
        }
    }

    /// The pixels, opaque.
    pub(super) fn into_pixels(self) -> Vec<u8> {
        self.pixels
    }
}

fn opaque([red, green, blue]: [u8; 3]) -> Color {
    Color::from_rgba8(red, green, blue, 255)
}

/// `share` of `b` in `a`.
fn mix(a: [u8; 3], b: [u8; 3], share: f32) -> [u8; 3] {
    [0, 1, 2].map(|channel| {
        let level = f32::from(a[channel]) * (1.0 - share) + f32::from(b[channel]) * share;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between two bytes"
        )]
        let level = level.round() as u8;
        level
    })
}
