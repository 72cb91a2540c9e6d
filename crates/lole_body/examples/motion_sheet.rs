//! Draws contact sheets of the hula steps: every half count from front, side and back.
//!
//! `cargo run --release -p lole_body --example motion_sheet -- FOLDER` writes one PPM file for
//! each step. The first column is the ready stance; marks on the floor are 10 cm apart.

use std::fs;
use std::path::PathBuf;

use glam::Vec3;
use lole_body::{ArmStyle, Bone, Dance, DanceStep, Dancer, Measurements, MotionSettings, PartKind};

/// Pixels of one picture, width and height.
const CELL: [usize; 2] = [300, 340];
const PIXELS_PER_METER: f32 = 190.0;

/// An image with depth.
struct Sheet {
    width: usize,
    pixels: Vec<[u8; 3]>,
    depths: Vec<f32>,
}

/// One picture of the sheet: its corner and the axes of its camera.
struct View {
    corner: [usize; 2],
    right: Vec3,
    toward: Vec3,
    center: Vec3,
}

impl View {
    /// Pixel (within the picture) and depth of a point.
    fn project(&self, point: Vec3) -> Vec3 {
        let offset = point - self.center;
        Vec3::new(
            self.right.dot(offset) * PIXELS_PER_METER + 0.5 * CELL[0] as f32,
            CELL[1] as f32 - 12.0 - point.y * PIXELS_PER_METER,
            self.toward.dot(offset),
        )
    }
}

impl Sheet {
    fn new(columns: usize, rows: usize) -> Self {
        let count = columns * CELL[0] * rows * CELL[1];
        Self {
            width: columns * CELL[0],
            pixels: vec![[238, 236, 230]; count],
            depths: vec![f32::MIN; count],
        }
    }

    fn triangle(&mut self, view: &View, corners: [Vec3; 3], color: [f32; 3]) {
        let normal = (corners[1] - corners[0])
            .cross(corners[2] - corners[0])
            .normalize_or_zero();
        let light =
            (0.5 * view.right * -0.6 + 0.6 * Vec3::Y + 0.8 * view.toward).normalize_or_zero();
        let shade = 0.35 + 0.65 * normal.dot(light).max(0.0);
        let pixel = color.map(|c| byte(c * shade));
        let [a, b, c] = corners.map(|corner| view.project(corner));
        let area = (b - a).truncate().perp_dot((c - a).truncate());
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        for y in pixels_between(low.y, high.y, CELL[1]) {
            for x in pixels_between(low.x, high.x, CELL[0]) {
                let point = glam::Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                let u = (b.truncate() - point).perp_dot(c.truncate() - point) / area;
                let v = (c.truncate() - point).perp_dot(a.truncate() - point) / area;
                let depth = a.z * u + b.z * v + c.z * (1.0 - u - v);
                let at = (view.corner[1] + y) * self.width + view.corner[0] + x;
                if u >= 0.0 && v >= 0.0 && u + v <= 1.0 && depth > self.depths[at] {
                    self.depths[at] = depth;
                    self.pixels[at] = pixel;
                }
            }
        }
    }
}

#[expect(clippy::cast_possible_truncation, reason = "clamped before")]
fn byte(value: f32) -> u8 {
    (value * 255.0).clamp(0.0, 255.0) as u8
}

#[expect(clippy::cast_possible_truncation, reason = "clamped before")]
fn pixels_between(low: f32, high: f32, count: usize) -> std::ops::Range<usize> {
    let pixel = |value: f32| value.clamp(0.0, count as f32) as usize;
    pixel(low)..pixel(high + 1.0)
}

fn color_of(kind: PartKind) -> [f32; 3] {
    match kind {
        PartKind::Skin => [0.80, 0.58, 0.45],
        PartKind::Leotard => [0.35, 0.38, 0.45],
        PartKind::Face => [0.85, 0.62, 0.48],
        _ => [0.25, 0.18, 0.15],
    }
}

fn draw(sheet: &mut Sheet, view: &View, dancer: &Dancer, positions: &[Vec3]) {
    for part in &dancer.skin.parts {
        for &triangle in &part.triangles {
            let corners = triangle.map(|vertex| positions[vertex as usize]);
            sheet.triangle(view, corners, color_of(part.kind));
        }
    }
    for mark in -12..=7 {
        let middle = Vec3::new(0.1 * mark as f32, 0.0, 0.0);
        let corners = [[-0.01, 0.0], [0.01, 0.0], [0.0, 0.02]];
        let corners = corners.map(|[x, y]| middle + view.right * x + Vec3::NEG_Y * y);
        sheet.triangle(view, corners, [0.5, 0.5, 0.5]);
    }
}

/// The settings that are drawn, with the names of their files.
fn cases() -> Vec<(String, MotionSettings)> {
    let of = |dance_step, arms| MotionSettings {
        dance_step,
        arms,
        ..MotionSettings::default()
    };
    let mut cases: Vec<_> = DanceStep::ALL
        .map(|step| (step.id().to_owned(), of(step, ArmStyle::OfStep)))
        .to_vec();
    cases.push((
        "kao_hips".to_owned(),
        of(DanceStep::Kao, ArmStyle::HandsOnHips),
    ));
    cases
}

fn main() {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| ".".into()));
    let dancer = Dancer::new(&Measurements::woman()).expect("the default woman can be built");
    for (name, settings) in cases() {
        let dance = Dance::new(&dancer.skeleton, &settings).expect("the defaults can be danced");
        let columns = settings.dance_step.counts() as usize * 2 + 1;
        let views = [
            (Vec3::X, Vec3::Z),
            (Vec3::NEG_Z, Vec3::X),
            (Vec3::NEG_X, Vec3::NEG_Z),
        ];
        let mut sheet = Sheet::new(columns, views.len());
        let half_count = 30.0 / settings.beats_per_minute;
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        for column in 0..columns {
            let time = match column {
                0 => 0.0,
                _ => dance.lead_in() + (column - 1) as f32 * half_count,
            };
            let skin = dancer.skeleton.world_from_bind(&dance.pose_at(time));
            dancer.skin.pose(&skin, &mut positions, &mut normals);
            let hips = dancer.skeleton.joint(Bone::Hips);
            let hips = skin[Bone::Hips.index()].transform_point3(hips);
            for (row, &(right, toward)) in views.iter().enumerate() {
                let view = View {
                    corner: [column * CELL[0], row * CELL[1]],
                    right,
                    toward,
                    center: Vec3::new(hips.x, 0.0, 0.0),
                };
                draw(&mut sheet, &view, &dancer, &positions);
            }
        }
        let height = sheet.pixels.len() / sheet.width;
        let mut file = format!("P6\n{} {height}\n255\n", sheet.width).into_bytes();
        file.extend(sheet.pixels.iter().flatten());
        fs::write(folder.join(format!("{name}.ppm")), file).expect("the folder is writable");
    }
}
