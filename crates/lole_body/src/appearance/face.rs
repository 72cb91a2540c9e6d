//! The painted face: brows, eyes, nose, lips and a little blush, calm and natural.
//!
//! The picture is the square of [`crate::surface::regions::Regions::face_uv`] seen from the front.
//! All places are in pixels of a 1024² picture, 5.8 pixels a millimeter on the default woman;
//! `x` counts from the middle, so that one side is drawn and mirrored.

use tiny_skia::{
    Color, FillRule, GradientStop, LineCap, Mask, Paint, Path, PathBuilder, Pixmap, Point,
    RadialGradient, SpreadMode, Stroke, Transform,
};

use super::{Appearance, BodyPicture, HAIR_SRGB, SKIN_SRGB};
use crate::Figure;

/// Side of the picture [pixel].
const SIDE: u32 = 1024;
const MIDDLE: f32 = 512.0;
/// Pupil: distance from the middle and row.
const EYE: [f32; 2] = [168.0, 430.0];
/// Row where the lips meet in the middle; their corners are higher.
const MOUTH: f32 = 797.0;

const LASH: [u8; 3] = [38, 27, 24];
const BROW: [u8; 3] = [62, 45, 38];
const SCLERA: [u8; 3] = [232, 222, 214];
const IRIS: [u8; 3] = [70, 44, 32];
const IRIS_LIGHT: [u8; 3] = [112, 72, 48];
const IRIS_RIM: [u8; 3] = [38, 25, 20];
const PUPIL: [u8; 3] = [16, 11, 11];
const LID: [u8; 3] = [126, 76, 60];
const LIP_UPPER: [u8; 3] = [186, 92, 88];
const LIP_LOWER: [u8; 3] = [204, 108, 102];
const LIP_LINE: [u8; 3] = [126, 56, 56];
const BLUSH: [u8; 3] = [226, 116, 98];
const SHADE: [u8; 3] = [150, 98, 78];
const LIGHT: [u8; 3] = [255, 240, 224];

/// What is painted on a face besides its features.
#[derive(Debug, Clone, Copy)]
struct MakeUp {
    /// Whether lashes are long, with a small wing.
    has_lashes: bool,
    /// Opacity of the blush.
    blush: u8,
    /// Opacity of the lips' color.
    lips: u8,
    /// How much thicker the brows are [pixel].
    brow: f32,
    /// How much higher nose and mouth lie [pixel].
    nose_up: f32,
    mouth_up: f32,
}

impl MakeUp {
    const fn of(figure: Figure) -> Self {
        match figure {
            Figure::OfStature | Figure::Woman => Self {
                has_lashes: true,
                blush: 64,
                lips: 190,
                brow: 0.0,
                nose_up: 0.0,
                mouth_up: 0.0,
            },
            Figure::Man => Self {
                has_lashes: false,
                blush: 16,
                lips: 84,
                brow: 9.0,
                nose_up: 42.0,
                mouth_up: 22.0,
            },
            Figure::Child => Self {
                has_lashes: false,
                blush: 44,
                lips: 104,
                brow: 0.0,
                nose_up: 0.0,
                mouth_up: 0.0,
            },
        }
    }
}

/// The face of a figure on a ground of exactly its skin.
pub(super) fn face_texture(appearance: &Appearance, figure: Figure) -> BodyPicture {
    let ground: Vec<u8> = {
        let [r, g, b] = appearance.skin_srgb;
        [r, g, b, 255].repeat((SIDE * SIDE) as usize)
    };
    let Some(mut canvas) = Pixmap::new(SIDE, SIDE) else {
        return BodyPicture {
            side: SIDE,
            pixels: ground,
        };
    };
    canvas.data_mut().copy_from_slice(&ground);
    for side in [-1.0, 1.0] {
        let mut half = Half {
            canvas: &mut canvas,
            transform: Transform::from_row(side, 0.0, 0.0, 1.0, MIDDLE, 0.0),
            appearance,
            make_up: MakeUp::of(figure),
        };
        half.cheek();
        let MakeUp {
            nose_up, mouth_up, ..
        } = half.make_up;
        half.raised(nose_up).nose();
        half.eye();
        half.brow();
        half.raised(mouth_up).mouth_corner();
    }
    let mut whole = Half {
        canvas: &mut canvas,
        transform: Transform::from_translate(MIDDLE, 0.0),
        appearance,
        make_up: MakeUp::of(figure),
    };
    let MakeUp {
        nose_up, mouth_up, ..
    } = whole.make_up;
    whole.raised(nose_up).nose_ridge();
    whole.raised(mouth_up).lips();
    BodyPicture {
        side: SIDE,
        // Opaque pixels are the same premultiplied or not.
        pixels: canvas.take(),
    }
}

/// One side of the face, `x` outwards from the middle; or both, where shapes cross it.
struct Half<'a> {
    canvas: &'a mut Pixmap,
    transform: Transform,
    appearance: &'a Appearance,
    make_up: MakeUp,
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

/// A closed path that runs from the middle on one side and comes back on the other, as in a mirror.
fn mirrored(start: At, cubics: &[[At; 3]]) -> Option<Path> {
    let mut builder = PathBuilder::new();
    builder.move_to(start[0], start[1]);
    for [a, b, end] in cubics {
        builder.cubic_to(a[0], a[1], b[0], b[1], end[0], end[1]);
    }
    for (index, [a, b, _]) in cubics.iter().enumerate().rev() {
        let end = index
            .checked_sub(1)
            .map_or(start, |before| cubics[before][2]);
        builder.cubic_to(-b[0], b[1], -a[0], a[1], -end[0], end[1]);
    }
    builder.close();
    builder.finish()
}

/// A color that was chosen for `known`, carried over to `other`, channel by channel.
fn toned(rgb: [u8; 3], known: [u8; 3], other: [u8; 3]) -> [u8; 3] {
    std::array::from_fn(|k| {
        let scaled = u32::from(rgb[k]) * u32::from(other[k]) / u32::from(known[k]).max(1);
        u8::try_from(scaled.min(255)).unwrap_or(u8::MAX)
    })
}

impl Half<'_> {
    /// This half of the face, drawn with everything this much higher [pixel].
    fn raised(&mut self, up: f32) -> Half<'_> {
        Half {
            canvas: &mut *self.canvas,
            transform: self.transform.post_translate(0.0, -up),
            appearance: self.appearance,
            make_up: self.make_up,
        }
    }

    /// A color of the flesh on this skin.
    fn flesh(&self, rgb: [u8; 3]) -> [u8; 3] {
        toned(rgb, SKIN_SRGB, self.appearance.skin_srgb)
    }

    /// The brows: as dark as the hair is.
    fn brow_color(&self) -> [u8; 3] {
        toned(BROW, HAIR_SRGB, self.appearance.hair_srgb)
    }

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
        let rgb = self.flesh(rgb);
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
        self.spot([222.0, 596.0], [160.0, 112.0], BLUSH, self.make_up.blush);
        // A smile lifts the cheek: light on it, a breath of shade under it.
        self.spot([206.0, 560.0], [84.0, 44.0], LIGHT, 34);
    }

    fn nose(&mut self) {
        self.spot([60.0, 470.0], [34.0, 90.0], SHADE, 30);
        self.spot([34.0, 656.0], [16.0, 8.0], [104, 54, 44], 130);
        self.spot([66.0, 642.0], [14.0, 28.0], SHADE, 36);
    }

    fn nose_ridge(&mut self) {
        self.spot([0.0, 668.0], [84.0, 24.0], SHADE, 74);
        self.spot([0.0, 612.0], [36.0, 32.0], LIGHT, 74);
        self.spot([0.0, 500.0], [20.0, 110.0], LIGHT, 52);
    }

    fn eye(&mut self) {
        let [x, y] = EYE;
        let at = |dx: f32, dy: f32| [x + dx, y + dy];
        self.spot(at(2.0, -30.0), [122.0, 54.0], [158, 100, 78], 76);
        self.spot(at(4.0, 42.0), [92.0, 24.0], SHADE, 34);
        let inner = at(-80.0, 15.0);
        let outer = at(84.0, -4.0);
        // The lower lid is lifted a little, as in a smile.
        let almond = curve(
            inner,
            &[
                [at(-56.0, -20.0), at(-28.0, -33.0), at(6.0, -33.0)],
                [at(42.0, -32.0), at(66.0, -21.0), outer],
                [at(62.0, 18.0), at(30.0, 27.0), at(-2.0, 27.0)],
                [at(-36.0, 27.0), at(-60.0, 22.0), inner],
            ],
        );
        let Some(almond) = almond else { return };
        self.fill(Some(almond.clone()), &paint(SCLERA, 255), None);
        self.eyeball(&almond);
        self.lids();
        // The window's reflection, on the same side of both eyes, and a faint one of the floor.
        let reflection = Transform::from_translate(MIDDLE, 0.0);
        let side = self.transform.sx;
        for (dx, dy, radius, alpha) in [(14.0, -15.0, 9.5, 245), (-13.0, 11.0, 5.5, 90)] {
            if let Some(glint) = PathBuilder::from_circle(x * side + dx, y + dy, radius) {
                let white = paint([255, 253, 248], alpha);
                self.canvas
                    .fill_path(&glint, &white, FillRule::Winding, reflection, None);
            }
        }
    }

    /// Iris, pupil and the lids' shadow, within the almond.
    fn eyeball(&mut self, almond: &Path) {
        let [x, y] = EYE;
        let at = |dx: f32, dy: f32| [x + dx, y + dy];
        let Some(mut inside) = Mask::new(SIDE, SIDE) else {
            return;
        };
        inside.fill_path(almond, FillRule::Winding, true, self.transform);
        let circle = |dy: f32, r: f32| PathBuilder::from_circle(x, y + dy, r);
        self.fill(circle(-6.0, 42.0), &paint(IRIS_RIM, 120), Some(&inside));
        self.fill(circle(-6.0, 39.0), &paint(IRIS_RIM, 255), Some(&inside));
        self.fill(circle(-5.0, 34.0), &paint(IRIS, 255), Some(&inside));
        self.fill(circle(4.0, 25.0), &paint(IRIS_LIGHT, 130), Some(&inside));
        self.fill(circle(-6.0, 17.0), &paint(PUPIL, 255), Some(&inside));
        let shadow = curve(
            at(-90.0, -50.0),
            &[
                [at(-40.0, -62.0), at(50.0, -62.0), at(95.0, -50.0)],
                [at(92.0, -14.0), at(60.0, -17.0), at(8.0, -19.0)],
                [at(-40.0, -18.0), at(-70.0, 8.0), at(-90.0, -50.0)],
            ],
        );
        self.fill(shadow, &paint([70, 48, 44], 96), Some(&inside));
        for corner in [at(-86.0, 14.0), at(88.0, -4.0)] {
            let dusk = PathBuilder::from_circle(corner[0], corner[1], 30.0);
            self.fill(dusk, &paint([150, 96, 84], 70), Some(&inside));
        }
    }

    /// Lash line above with a small wing, lashes, crease, and a faint line below.
    fn lids(&mut self) {
        let [x, y] = EYE;
        let at = |dx: f32, dy: f32| [x + dx, y + dy];
        let lash = curve(
            at(-83.0, 17.0),
            &[
                [at(-58.0, -22.0), at(-28.0, -41.0), at(8.0, -42.0)],
                [at(48.0, -41.0), at(76.0, -29.0), at(100.0, -18.0)],
                [at(92.0, -8.0), at(88.0, -4.0), at(82.0, -4.0)],
                [at(64.0, -19.0), at(40.0, -29.0), at(6.0, -30.0)],
                [at(-28.0, -30.0), at(-56.0, -18.0), at(-83.0, 17.0)],
            ],
        );
        self.fill(lash.clone(), &paint(LASH, 235), None);
        self.line(lash, &paint(LASH, 50), 5.0);
        let lashes = if self.make_up.has_lashes { 3 } else { 0 };
        for (dx, dy, length) in [
            (40.0, -37.0, 12.0),
            (58.0, -32.0, 15.0),
            (76.0, -25.0, 17.0),
        ]
        .into_iter()
        .take(lashes)
        {
            let hair = curve(
                at(dx, dy),
                &[[
                    at(dx + 0.4 * length, dy - 0.1 * length),
                    at(dx + 0.8 * length, dy - 0.4 * length),
                    at(dx + length, dy - 0.8 * length),
                ]],
            );
            self.line(hair, &paint(LASH, 190), 3.0);
        }
        let crease = curve(
            at(-72.0, -10.0),
            &[
                [at(-50.0, -38.0), at(-20.0, -56.0), at(12.0, -57.0)],
                [at(48.0, -56.0), at(74.0, -43.0), at(94.0, -31.0)],
            ],
        );
        self.line(crease.clone(), &paint(self.flesh(LID), 50), 10.0);
        self.line(crease, &paint(self.flesh(LID), 150), 3.5);
        let below = curve(
            at(84.0, -2.0),
            &[[at(62.0, 20.0), at(30.0, 30.0), at(-10.0, 30.0)]],
        );
        self.line(below.clone(), &paint(self.flesh(LID), 46), 9.0);
        self.line(below, &paint(LASH, 110), 3.0);
    }

    /// A soft arch: a faint body, and hairs that lean outwards.
    fn brow(&mut self) {
        const HAIRS: u8 = 34;
        let more = self.make_up.brow;
        let brow = |thick: f32| {
            curve(
                [88.0, 352.0 - 0.5 * thick],
                &[
                    [[126.0, 334.0], [182.0, 318.0], [224.0, 316.0]],
                    [[256.0, 315.0], [284.0, 328.0], [306.0, 348.0]],
                    [
                        [282.0, 338.0],
                        [254.0, 324.0 + thick],
                        [222.0, 322.0 + thick],
                    ],
                    [
                        [182.0, 323.0 + thick],
                        [128.0, 340.0 + thick],
                        [94.0, 350.0 + thick],
                    ],
                    [
                        [86.0, 352.0 + thick],
                        [84.0, 352.0],
                        [88.0, 352.0 - 0.5 * thick],
                    ],
                ],
            )
        };
        self.line(brow(10.0 + more), &paint(self.brow_color(), 26), 12.0);
        self.fill(brow(12.0 + more), &paint(self.brow_color(), 104), None);
        for hair in 0..HAIRS {
            let along = f32::from(hair) / f32::from(HAIRS - 1);
            let x = 90.0 + 196.0 * along;
            let arch = 340.0 - 24.0 * along * (2.3 - 1.55 * along * along);
            let thick = (18.0 + more) * (1.0 - 0.55 * along) * (0.5 + 1.6 * along).min(1.0);
            let lean = 8.0 + 16.0 * along;
            let path = curve(
                [x, arch + 0.6 * thick + 6.0],
                &[[
                    [x + 0.2 * lean, arch + 0.2 * thick + 5.0],
                    [x + 0.6 * lean, arch - 0.2 * thick + 6.0],
                    [x + lean, arch - 0.3 * thick + 6.0 + 5.0 * along],
                ]],
            );
            let faint = if hair < 4 { 60 } else { 96 };
            self.line(path, &paint(self.brow_color(), faint), 3.2);
        }
    }

    /// The corner that a smile tucks in.
    fn mouth_corner(&mut self) {
        self.spot([134.0, MOUTH - 26.0], [20.0, 22.0], SHADE, 66);
        self.spot([150.0, MOUTH - 70.0], [20.0, 60.0], SHADE, 22);
    }

    /// Closed lips in a gentle smile: corners raised, the lower lip full.
    fn lips(&mut self) {
        let y = MOUTH;
        let corner = [124.0, y - 26.0];
        self.spot([0.0, y + 74.0], [84.0, 20.0], SHADE, 56);
        let upper = mirrored(
            [0.0, y - 34.0],
            &[
                [[10.0, y - 37.0], [18.0, y - 43.0], [30.0, y - 43.0]],
                [[58.0, y - 42.0], [92.0, y - 30.0], corner],
                [[86.0, y - 8.0], [44.0, y + 5.0], [0.0, y + 5.0]],
            ],
        );
        self.line(upper.clone(), &paint(self.flesh(LIP_UPPER), 60), 7.0);
        self.fill(
            upper,
            &paint(self.flesh(LIP_UPPER), self.make_up.lips),
            None,
        );
        let lower = mirrored(
            [0.0, y + 3.0],
            &[
                [[44.0, y + 3.0], [86.0, y - 10.0], corner],
                [[104.0, y + 18.0], [64.0, y + 55.0], [0.0, y + 55.0]],
            ],
        );
        self.line(lower.clone(), &paint(self.flesh(LIP_LOWER), 60), 7.0);
        self.fill(
            lower,
            &paint(self.flesh(LIP_LOWER), self.make_up.lips),
            None,
        );
        for side in [-1.0, 1.0] {
            let between = curve(
                [0.0, y + 4.0],
                &[[
                    [side * 44.0, y + 4.0],
                    [side * 88.0, y - 9.0],
                    [side * 130.0, y - 31.0],
                ]],
            );
            self.line(between.clone(), &paint(self.flesh(LIP_LINE), 60), 8.0);
            self.line(between, &paint(self.flesh(LIP_LINE), 150), 3.5);
        }
        self.spot([0.0, y + 30.0], [62.0, 14.0], LIGHT, 74);
        self.spot([0.0, y - 24.0], [40.0, 8.0], LIGHT, 36);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_border_of_the_face_is_exactly_skin() {
        let face = face_texture(&Appearance::default(), Figure::Woman);
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
