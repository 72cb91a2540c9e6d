//! One step as a strip of small pictures: from the front, and the floor from above.

use std::io;

use glam::{Vec2, Vec3};
use lole_body::{Bone, Dancer, PartKind};
use lole_hula::{Dance, MotionSettings};

/// Pixels of one picture of the dancer, of one of the floor below it, and of the line of counts.
const CELL: [usize; 2] = [112, 128];
const FLOOR: usize = 64;
const COUNTS: usize = 10;
/// Pixels of the drawing for each of the strip, each way.
const FINE: usize = 3;
const PIXELS_PER_METER: f32 = 68.0;
const FLOOR_PIXELS_PER_METER: f32 = 60.0;
/// Pictures of a strip, at most.
const MOST_PICTURES: u32 = 8;
/// Levels of each color: fewer make smaller files.
const LEVELS: f32 = 20.0;

const PAPER: [f32; 3] = [0.955, 0.945, 0.92];
const LINE: [f32; 3] = [0.84, 0.82, 0.78];
const STANDING: [f32; 3] = [0.45, 0.20, 0.16];
const FLYING: [f32; 3] = [0.86, 0.66, 0.58];
const INK: [f32; 3] = [0.25, 0.22, 0.20];

/// Digits of 3 × 5 pixels, rows from the top, bits from the left; the last is the half beat.
const DIGITS: [[u8; 5]; 10] = [
    [0b111, 0b101, 0b101, 0b101, 0b111],
    [0b010, 0b110, 0b010, 0b010, 0b111],
    [0b111, 0b001, 0b111, 0b100, 0b111],
    [0b111, 0b001, 0b111, 0b001, 0b111],
    [0b101, 0b101, 0b111, 0b001, 0b001],
    [0b111, 0b100, 0b111, 0b001, 0b111],
    [0b111, 0b100, 0b111, 0b101, 0b111],
    [0b111, 0b001, 0b010, 0b010, 0b010],
    [0b111, 0b101, 0b111, 0b101, 0b111],
    [0b000, 0b000, 0b000, 0b000, 0b010],
];

/// The half beat in [`DIGITS`].
const HALF: usize = 9;

/// An image with depth.
struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<[f32; 3]>,
    depths: Vec<f32>,
}

impl Canvas {
    fn new(width: usize, height: usize) -> Self {
        Self {
            width,
            height,
            pixels: vec![PAPER; width * height],
            depths: vec![f32::MIN; width * height],
        }
    }

    /// Colors the pixels within `[left, top]..[right, bottom]` that `inside` tells.
    fn fill(&mut self, [from, to]: [Vec2; 2], color: [f32; 3], inside: impl Fn(Vec2) -> bool) {
        for y in pixels_between(from.y, to.y, self.height) {
            for x in pixels_between(from.x, to.x, self.width) {
                if inside(Vec2::new(x as f32 + 0.5, y as f32 + 0.5)) {
                    self.pixels[y * self.width + x] = color;
                }
            }
        }
    }

    fn disk(&mut self, center: Vec2, radius: f32, color: [f32; 3]) {
        let box_ = [center - radius, center + radius];
        self.fill(box_, color, |point| point.distance(center) <= radius);
    }

    fn ring(&mut self, center: Vec2, radius: f32, width: f32, color: [f32; 3]) {
        let box_ = [center - radius, center + radius];
        self.fill(box_, color, |point| {
            (radius - width..=radius).contains(&point.distance(center))
        });
    }

    fn bar(&mut self, from: Vec2, to: Vec2, radius: f32, color: [f32; 3]) {
        let box_ = [from.min(to) - radius, from.max(to) + radius];
        let way = to - from;
        self.fill(box_, color, |point| {
            let share = (point - from).dot(way) / way.length_squared().max(1e-6);
            point.distance(from + way * share.clamp(0.0, 1.0)) <= radius
        });
    }

    fn triangle(&mut self, cell: Vec2, corners: [Vec3; 3], color: [f32; 3]) {
        let [a, b, c] = corners;
        let area = (b - a).truncate().perp_dot((c - a).truncate());
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let right = (cell.x + (CELL[0] * FINE) as f32).min(high.x + 1.0);
        for y in pixels_between(low.y, high.y, CELL[1] * FINE) {
            for x in pixels_between(low.x.max(cell.x), right, self.width) {
                let point = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                let u = (b.truncate() - point).perp_dot(c.truncate() - point) / area;
                let v = (c.truncate() - point).perp_dot(a.truncate() - point) / area;
                let depth = a.z * u + b.z * v + c.z * (1.0 - u - v);
                let at = y * self.width + x;
                if u >= 0.0 && v >= 0.0 && u + v <= 1.0 && depth > self.depths[at] {
                    self.depths[at] = depth;
                    self.pixels[at] = color;
                }
            }
        }
    }

    /// A PNG of the mean of every block of fine pixels, in few colors.
    fn png(&self) -> io::Result<Vec<u8>> {
        let (width, height) = (self.width / FINE, self.height / FINE);
        let mut bytes = Vec::with_capacity(3 * width * height);
        for y in 0..height {
            for x in 0..width {
                let mut sum = [0.0_f32; 3];
                for (dx, dy) in (0..FINE).flat_map(|dy| (0..FINE).map(move |dx| (dx, dy))) {
                    let pixel = self.pixels[(y * FINE + dy) * self.width + x * FINE + dx];
                    sum = [0, 1, 2].map(|i: usize| sum[i] + pixel[i]);
                }
                let mean = sum.map(|sum| sum / (FINE * FINE) as f32);
                bytes.extend(mean.map(|value| byte((value * LEVELS).round() / LEVELS)));
            }
        }
        let mut file = Vec::new();
        let size = |side: usize| u32::try_from(side).map_err(io::Error::other);
        let mut encoder = png::Encoder::new(&mut file, size(width)?, size(height)?);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_compression(png::Compression::High);
        let mut writer = encoder.write_header().map_err(io::Error::other)?;
        writer.write_image_data(&bytes).map_err(io::Error::other)?;
        writer.finish().map_err(io::Error::other)?;
        Ok(file)
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "clamped before"
)]
fn byte(value: f32) -> u8 {
    (value * 255.0).clamp(0.0, 255.0) as u8
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "clamped before"
)]
fn pixels_between(low: f32, high: f32, count: usize) -> std::ops::Range<usize> {
    let pixel = |value: f32| value.clamp(0.0, count as f32) as usize;
    pixel(low)..pixel(high + 1.0)
}

fn color_of(kind: PartKind) -> [f32; 3] {
    match kind {
        PartKind::Skin | PartKind::Given => [0.82, 0.60, 0.46],
        PartKind::Leotard => [0.62, 0.16, 0.20],
        PartKind::Face => [0.86, 0.63, 0.49],
        _ => [0.22, 0.16, 0.13],
    }
}

/// The strip of a repeated step as PNG.
pub(crate) fn of(dancer: &Dancer, settings: &MotionSettings) -> io::Result<Vec<u8>> {
    let step = settings.dance_step;
    let dance = Dance::new(&dancer.skeleton, settings).map_err(io::Error::other)?;
    // Half beats where there is room for them.
    let parts = if 2 * step.phrase() <= MOST_PICTURES {
        2
    } else {
        1
    };
    let pictures = parts * step.phrase();
    let columns = pictures as usize;
    let height = CELL[1] + FLOOR + COUNTS;
    let mut canvas = Canvas::new(columns * CELL[0] * FINE, height * FINE);
    let count = 60.0 / settings.beats_per_minute;
    let middle = middle_of_floor(dancer, &dance, settings);
    for picture in 0..pictures {
        let beat = step.first_count() as f32 + picture as f32 / parts as f32;
        let pose = dance.pose_at(dance.lead_in() + beat * count);
        let skin = dancer.skeleton.world_from_bind(&pose);
        let left = (picture as usize * CELL[0] * FINE) as f32;
        draw_dancer(&mut canvas, left, dancer, &skin);
        draw_floor(&mut canvas, left, (dancer, &skin), middle);
        let half_beat = picture % parts == 1;
        let number = (picture / parts + 1).min(8) as usize;
        draw_digit(&mut canvas, left, if half_beat { HALF } else { number });
    }
    canvas.png()
}

/// The middle of where the hips go, left and front [m].
fn middle_of_floor(dancer: &Dancer, dance: &Dance, settings: &MotionSettings) -> Vec2 {
    let step = settings.dance_step;
    let count = 60.0 / settings.beats_per_minute;
    let hips = (0..=8 * step.phrase()).map(|i| {
        let beat = step.first_count() as f32 + 0.125 * i as f32;
        let pose = dance.pose_at(dance.lead_in() + beat * count);
        let hips = dancer.skeleton.joint(Bone::Hips) + pose.hips_translation;
        Vec2::new(hips.x, hips.z)
    });
    let (mut low, mut high) = (Vec2::MAX, Vec2::MIN);
    for place in hips {
        (low, high) = (low.min(place), high.max(place));
    }
    0.5 * (low + high)
}

fn draw_dancer(canvas: &mut Canvas, left: f32, dancer: &Dancer, skin: &[glam::Affine3A]) {
    let (mut positions, mut normals) = (Vec::new(), Vec::new());
    dancer.skin.pose(skin, &mut positions, &mut normals);
    let hips = skin[Bone::Hips.index()].transform_point3(dancer.skeleton.joint(Bone::Hips));
    let scale = PIXELS_PER_METER * FINE as f32;
    let project = |point: Vec3| {
        Vec3::new(
            left + 0.5 * (CELL[0] * FINE) as f32 + (point.x - hips.x) * scale,
            (CELL[1] * FINE) as f32 - (point.y + 0.06) * scale,
            point.z,
        )
    };
    let light = Vec3::new(-0.35, 0.6, 0.75).normalize_or_zero();
    for part in &dancer.skin.parts {
        for &triangle in &part.triangles {
            let corners = triangle.map(|vertex| positions[vertex as usize]);
            let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
            let shade = 0.42 + 0.6 * normal.normalize_or_zero().dot(light).max(0.0);
            let color = color_of(part.kind).map(|channel| channel * shade);
            canvas.triangle(Vec2::new(left, 0.0), corners.map(project), color);
        }
    }
}

/// The floor as the dancer sees it from above: her left to the left, forward up.
fn draw_floor(
    canvas: &mut Canvas,
    left: f32,
    (dancer, skin): (&Dancer, &[glam::Affine3A]),
    middle: Vec2,
) {
    let fine = FINE as f32;
    let scale = FLOOR_PIXELS_PER_METER * fine;
    let corner = Vec2::new(left, (CELL[1] * FINE) as f32);
    let size = Vec2::new((CELL[0] * FINE) as f32, (FLOOR * FINE) as f32);
    let project = |point: Vec3| {
        let from_middle = Vec2::new(point.x, point.z) - middle;
        corner + 0.5 * size - from_middle * scale
    };
    let frame = [corner + 1.5 * fine, corner + size - 1.5 * fine];
    canvas.fill(frame, [0.975, 0.97, 0.955], |_| true);
    let line = 0.1 * scale;
    canvas.fill(frame, LINE, |point| {
        let place = (point - corner - 0.5 * size + middle * scale) / line;
        let off = (place - place.round()).abs() * line;
        off.min_element() < 0.25 * fine
    });
    for [foot, toes] in [
        [Bone::LeftFoot, Bone::LeftToes],
        [Bone::RightFoot, Bone::RightToes],
    ] {
        let joint = |bone: Bone| dancer.skeleton.joint(bone);
        let heel = joint(foot).with_y(0.0) - Vec3::Z * 0.035;
        let ball = joint(toes).with_y(0.0);
        let [heel, ball, tip] = [
            skin[foot.index()].transform_point3(heel),
            skin[toes.index()].transform_point3(ball),
            skin[toes.index()].transform_point3(ball + Vec3::Z * 0.05),
        ];
        let color = |height: f32| if height < 0.006 { STANDING } else { FLYING };
        canvas.bar(project(heel), project(ball), 1.6 * fine, FLYING);
        canvas.disk(project(heel), 2.1 * fine, color(heel.y));
        canvas.bar(project(ball), project(tip), 2.6 * fine, color(ball.y));
    }
    let hips = skin[Bone::Hips.index()].transform_point3(dancer.skeleton.joint(Bone::Hips));
    canvas.ring(project(hips), 3.4 * fine, 1.2 * fine, INK);
}

fn draw_digit(canvas: &mut Canvas, left: f32, digit: usize) {
    let scale = (2 * FINE) as f32;
    let corner = Vec2::new(
        left + 0.5 * (CELL[0] * FINE) as f32 - 1.5 * scale,
        ((CELL[1] + FLOOR) * FINE) as f32,
    );
    for (y, row) in DIGITS[digit].into_iter().enumerate() {
        for x in (0..3).filter(|x| row >> (2 - x) & 1 == 1) {
            let from = corner + Vec2::new(x as f32, y as f32) * scale;
            canvas.fill([from, from + scale - 1.0], INK, |_| true);
        }
    }
}
