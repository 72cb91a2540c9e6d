//! The painted face: brows, eyes, nose, lips and a little blush, calm and natural.
//!
//! The picture is the square of [`crate::surface::regions::Regions::face_uv`] seen from the front.
//! All places are in pixels of a 1024² picture, 5.8 pixels a millimeter on the default woman;
//! `x` counts from the middle, so that one side is drawn and mirrored.

use tiny_skia::{
    Color, FillRule, GradientStop, LineCap, Mask, Paint, Path, PathBuilder, Pixmap, Point,
    RadialGradient, SpreadMode, Stroke, Transform,
};

use super::{FaceTexture, SKIN_SRGB};

/// Side of the picture [pixel].
const SIDE: u32 = 1024;
const MIDDLE: f32 = 512.0;
/// Pupil: distance from the middle and row.
const EYE: [f32; 2] = [170.0, 428.0];
/// Row where the lips meet.
const MOUTH: f32 = 795.0;

const LASH: [u8; 3] = [36, 25, 22];
const BROW: [u8; 3] = [66, 48, 40];
const SCLERA: [u8; 3] = [244, 238, 232];
const IRIS: [u8; 3] = [74, 46, 32];
const IRIS_RIM: [u8; 3] = [40, 25, 20];
const PUPIL: [u8; 3] = [16, 11, 11];
const LIP_UPPER: [u8; 3] = [190, 98, 92];
const LIP_LOWER: [u8; 3] = [206, 112, 104];
const LIP_LINE: [u8; 3] = [128, 56, 56];
const BLUSH: [u8; 3] = [226, 120, 104];
const SHADE: [u8; 3] = [150, 98, 78];
const LIGHT: [u8; 3] = [255, 246, 236];

/// The face on a ground of exactly [`SKIN_SRGB`].
#[must_use]
pub fn face_texture() -> FaceTexture {
    let ground: Vec<u8> = {
        let [r, g, b] = SKIN_SRGB;
        [r, g, b, 255].repeat((SIDE * SIDE) as usize)
    };
    let Some(mut canvas) = Pixmap::new(SIDE, SIDE) else {
        return FaceTexture {
            side: SIDE,
            pixels: ground,
        };
    };
    canvas.data_mut().copy_from_slice(&ground);
    for side in [-1.0, 1.0] {
        let mut half = Half {
            canvas: &mut canvas,
            transform: Transform::from_row(side, 0.0, 0.0, 1.0, MIDDLE, 0.0),
        };
        half.cheek();
        half.nose();
        half.eye();
        half.brow();
        half.lips();
    }
    FaceTexture {
        side: SIDE,
        // Opaque pixels are the same premultiplied or not.
        pixels: canvas.take(),
    }
}

/// One side of the face, `x` outwards from the middle.
struct Half<'a> {
    canvas: &'a mut Pixmap,
    transform: Transform,
}

/// A place in the half face.
type At = [f32; 2];

fn color([r, g, b]: [u8; 3], alpha: u8) -> Color {
    Color::from_rgba8(r, g, b, alpha)
}

fn paint(rgb: [u8; 3], alpha: u8) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color(color(rgb, alpha));
    paint.anti_alias = true;
    paint
}

/// A path of cubic curves: a start, then two handles and an end for each.
fn curve(start: At, cubics: &[[At; 3]]) -> Option<Path> {
    let mut builder = PathBuilder::new();
    builder.move_to(start[0], start[1]);
    for [a, b, end] in cubics {
        builder.cubic_to(a[0], a[1], b[0], b[1], end[0], end[1]);
    }
    builder.finish()
}

impl Half<'_> {
    fn fill(&mut self, path: Option<Path>, paint: &Paint<'_>, mask: Option<&Mask>) {
        if let Some(path) = path {
            self.canvas
                .fill_path(&path, paint, FillRule::Winding, self.transform, mask);
        }
    }

    fn line(&mut self, path: Option<Path>, paint: &Paint<'_>, width: f32) {
        let stroke = Stroke {
            width,
            line_cap: LineCap::Round,
            ..Stroke::default()
        };
        if let Some(path) = path {
            self.canvas
                .stroke_path(&path, paint, &stroke, self.transform, None);
        }
    }

    /// A soft spot: full at the center, nothing at the radius.
    fn spot(&mut self, center: At, radii: At, rgb: [u8; 3], alpha: u8) {
        let faint = |share: f32| {
            let mut color = color(rgb, alpha);
            color.apply_opacity(share);
            color
        };
        // Stops of a bell, so that no rim shows.
        let stops = [
            (0.0, 1.0),
            (0.25, 0.85),
            (0.5, 0.5),
            (0.75, 0.15),
            (1.0, 0.0),
        ]
        .map(|(place, share)| GradientStop::new(place, faint(share)));
        let squash = Transform::from_row(1.0, 0.0, 0.0, radii[1] / radii[0], center[0], center[1]);
        let origin = Point::from_xy(0.0, 0.0);
        let shader = RadialGradient::new(
            origin,
            0.0,
            origin,
            radii[0],
            stops.to_vec(),
            SpreadMode::Pad,
            squash,
        );
        if let Some(shader) = shader {
            let paint = Paint {
                shader,
                ..Paint::default()
            };
            let circle = PathBuilder::from_circle(0.0, 0.0, radii[0])
                .and_then(|circle| circle.transform(squash));
            self.fill(circle, &paint, None);
        }
    }

    fn cheek(&mut self) {
        self.spot([218.0, 610.0], [150.0, 105.0], BLUSH, 62);
    }

    fn nose(&mut self) {
        // Shade beside the bridge and under the tip, nostrils, light on the tip.
        self.spot([62.0, 470.0], [34.0, 90.0], SHADE, 34);
        self.spot([0.0, 668.0], [86.0, 26.0], SHADE, 60);
        self.spot([34.0, 656.0], [17.0, 9.0], [96, 48, 40], 150);
        self.spot([66.0, 640.0], [14.0, 30.0], SHADE, 46);
        self.spot([0.0, 612.0], [34.0, 30.0], LIGHT, 50);
        self.spot([0.0, 500.0], [20.0, 110.0], LIGHT, 40);
    }

    fn eye(&mut self) {
        let [x, y] = EYE;
        let at = |dx: f32, dy: f32| [x + dx, y + dy];
        self.spot(at(0.0, -22.0), [128.0, 62.0], SHADE, 66);
        self.spot(at(4.0, 44.0), [96.0, 22.0], SHADE, 30);
        let inner = at(-84.0, 15.0);
        let outer = at(88.0, -7.0);
        let almond = curve(
            inner,
            &[
                [at(-58.0, -26.0), at(-26.0, -40.0), at(8.0, -39.0)],
                [at(44.0, -37.0), at(70.0, -24.0), outer],
                [at(66.0, 22.0), at(28.0, 33.0), at(-4.0, 33.0)],
                [at(-38.0, 32.0), at(-62.0, 25.0), inner],
            ],
        );
        let Some(almond) = almond else { return };
        self.fill(Some(almond.clone()), &paint(SCLERA, 255), None);
        if let Some(mut inside) = Mask::new(SIDE, SIDE) {
            inside.fill_path(&almond, FillRule::Winding, true, self.transform);
            let circle = |dx: f32, dy: f32, r: f32| PathBuilder::from_circle(x + dx, y + dy, r);
            self.fill(
                circle(0.0, -5.0, 41.0),
                &paint(IRIS_RIM, 255),
                Some(&inside),
            );
            self.fill(circle(0.0, -5.0, 36.0), &paint(IRIS, 255), Some(&inside));
            self.fill(
                circle(0.0, 5.0, 25.0),
                &paint([106, 68, 46], 120),
                Some(&inside),
            );
            self.fill(circle(0.0, -5.0, 18.0), &paint(PUPIL, 255), Some(&inside));
            // The upper lid's shadow on the ball.
            let shadow = curve(
                at(-90.0, -50.0),
                &[
                    [at(-40.0, -62.0), at(50.0, -62.0), at(95.0, -50.0)],
                    [at(92.0, -20.0), at(60.0, -22.0), at(8.0, -25.0)],
                    [at(-40.0, -24.0), at(-70.0, 4.0), at(-90.0, -50.0)],
                ],
            );
            self.fill(shadow, &paint([70, 50, 46], 90), Some(&inside));
        }
        self.lids();
        // The window's reflection, on the same side of both eyes.
        let reflection = Transform::from_translate(MIDDLE, 0.0);
        let side = self.transform.sx;
        if let Some(glint) = PathBuilder::from_circle(x * side - 13.0, y - 18.0, 8.5) {
            let white = paint([255, 255, 255], 235);
            self.canvas
                .fill_path(&glint, &white, FillRule::Winding, reflection, None);
        }
    }

    /// Lash line above with a small wing, crease, and a faint line below.
    fn lids(&mut self) {
        let [x, y] = EYE;
        let at = |dx: f32, dy: f32| [x + dx, y + dy];
        let lash = curve(
            at(-88.0, 18.0),
            &[
                [at(-60.0, -28.0), at(-26.0, -48.0), at(10.0, -50.0)],
                [at(52.0, -49.0), at(80.0, -34.0), at(108.0, -20.0)],
                [at(96.0, -12.0), at(92.0, -8.0), at(86.0, -7.0)],
                [at(68.0, -24.0), at(42.0, -34.0), at(8.0, -36.0)],
                [at(-26.0, -37.0), at(-58.0, -23.0), at(-88.0, 18.0)],
            ],
        );
        self.fill(lash, &paint(LASH, 245), None);
        let crease = curve(
            at(-78.0, -10.0),
            &[
                [at(-54.0, -44.0), at(-20.0, -64.0), at(14.0, -64.0)],
                [at(50.0, -63.0), at(78.0, -48.0), at(98.0, -34.0)],
            ],
        );
        self.line(crease, &paint([112, 70, 58], 150), 4.0);
        let below = curve(
            at(90.0, -4.0),
            &[[at(66.0, 25.0), at(28.0, 36.0), at(-4.0, 36.0)]],
        );
        self.line(below, &paint([96, 62, 52], 150), 4.0);
    }

    fn brow(&mut self) {
        let brow = curve(
            [84.0, 338.0],
            &[
                [[124.0, 326.0], [190.0, 312.0], [230.0, 310.0]],
                [[258.0, 310.0], [284.0, 326.0], [304.0, 348.0]],
                [[280.0, 335.0], [256.0, 328.0], [230.0, 329.0]],
                [[188.0, 331.0], [126.0, 346.0], [92.0, 357.0]],
                [[84.0, 354.0], [82.0, 346.0], [84.0, 338.0]],
            ],
        );
        self.fill(brow.clone(), &paint(BROW, 160), None);
        // A soft edge, as hair has.
        self.line(brow, &paint(BROW, 40), 8.0);
    }

    fn lips(&mut self) {
        let y = MOUTH;
        let corner = [112.0, y - 12.0];
        self.spot([0.0, y + 74.0], [90.0, 22.0], SHADE, 60);
        self.spot([126.0, y - 6.0], [22.0, 18.0], SHADE, 60);
        let upper = curve(
            [-0.6, y - 32.0],
            &[
                [[10.0, y - 34.0], [18.0, y - 40.0], [30.0, y - 40.0]],
                [[58.0, y - 40.0], [92.0, y - 18.0], corner],
                [[80.0, y + 2.0], [40.0, y + 6.0], [-0.6, y + 5.0]],
            ],
        );
        self.fill(upper, &paint(LIP_UPPER, 200), None);
        let lower = curve(
            [-0.6, y + 3.0],
            &[
                [[40.0, y + 4.0], [80.0, y + 2.0], corner],
                [[96.0, y + 28.0], [60.0, y + 52.0], [-0.6, y + 52.0]],
            ],
        );
        self.fill(lower, &paint(LIP_LOWER, 200), None);
        let between = curve(
            [0.0, y + 4.0],
            &[[[36.0, y + 6.0], [76.0, y + 1.0], [117.0, y - 15.0]]],
        );
        self.line(between, &paint(LIP_LINE, 170), 4.5);
        self.spot([14.0, y + 30.0], [42.0, 14.0], LIGHT, 56);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_border_of_the_face_is_exactly_skin() {
        let face = face_texture();
        let middle = f64::from(SIDE) / 2.0;
        for (index, pixel) in face.pixels.chunks_exact(4).enumerate() {
            let index = u32::try_from(index).unwrap();
            let x = f64::from(index % SIDE) + 0.5 - middle;
            let y = f64::from(index / SIDE) + 0.5 - middle;
            if (x * x + y * y).sqrt() > 0.96 * middle {
                assert_eq!(pixel[..3], SKIN_SRGB, "at {x} {y}");
            }
        }
    }
}
