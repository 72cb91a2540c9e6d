//! Draws contact sheets of the hula steps: every half count from front, side and back.
//!
//! `cargo run -p lole_body --example motion_sheet -- FOLDER` writes one PPM file for each step.
//! The body is drawn as round limbs around the bones.

#[path = "../tests/motion_support/mod.rs"]
mod motion_support;

use std::fs;
use std::path::PathBuf;

use glam::{Affine3A, Vec3};
use lole_body::{ArmStyle, Bone, Dance, DanceStep, MotionSettings, Skeleton};

const CELL: [usize; 2] = [300, 340];
/// Pixels per meter.
const SCALE: f32 = 190.0;

/// An image with depth.
struct Sheet {
    width: usize,
    pixels: Vec<[u8; 3]>,
    depths: Vec<f32>,
}

/// One view of one moment: the cell it is drawn in and the turn of the camera.
struct View {
    corner: [usize; 2],
    right: Vec3,
    toward: Vec3,
    centre: Vec3,
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

    fn ball(&mut self, view: &View, centre: Vec3, radius: f32, color: [f32; 3]) {
        let offset = centre - view.centre;
        let x = view.right.dot(offset) * SCALE + 0.5 * CELL[0] as f32;
        let y = CELL[1] as f32 - 12.0 - centre.y * SCALE;
        let size = radius * SCALE;
        let depth = view.toward.dot(offset) * SCALE;
        let reach = size.ceil() as i32;
        for dy in -reach..=reach {
            for dx in -reach..=reach {
                let (px, py) = (x as i32 + dx, y as i32 + dy);
                let (u, v) = ((px as f32 + 0.5 - x) / size, (py as f32 + 0.5 - y) / size);
                let square = 1.0 - u * u - v * v;
                let inside = px >= 0 && py >= 0 && px < CELL[0] as i32 && py < CELL[1] as i32;
                if square < 0.0 || !inside {
                    continue;
                }
                let bulge = square.sqrt();
                let at = (view.corner[1] + py as usize) * self.width + view.corner[0] + px as usize;
                if depth + bulge * size > self.depths[at] {
                    self.depths[at] = depth + bulge * size;
                    let light = 0.35 + 0.65 * (0.3 * -u - 0.5 * v + 0.8 * bulge).max(0.0);
                    self.pixels[at] = color.map(|c| (c * light * 255.0).min(255.0) as u8);
                }
            }
        }
    }

    fn limb(&mut self, view: &View, ends: [Vec3; 2], radii: [f32; 2], color: [f32; 3]) {
        let steps = 24;
        for i in 0..=steps {
            let t = i as f32 / steps as f32;
            let radius = radii[0] + (radii[1] - radii[0]) * t;
            self.ball(view, ends[0].lerp(ends[1], t), radius, color);
        }
    }
}

/// Radius of the limb at a bone's joint [m].
fn radius(bone: Bone) -> f32 {
    let name = bone.name().to_lowercase();
    let table = [
        ("upperleg", 0.075),
        ("lowerleg", 0.05),
        ("foot", 0.032),
        ("toes", 0.022),
        ("upperarm", 0.04),
        ("lowerarm", 0.032),
        ("hand", 0.022),
        ("shoulder", 0.05),
        ("hips", 0.11),
        ("spine", 0.095),
        ("chest", 0.1),
        ("neck", 0.045),
        ("head", 0.05),
    ];
    (table.iter().find(|(part, _)| name.contains(part))).map_or(0.009, |&(_, radius)| radius)
}

fn draw(sheet: &mut Sheet, view: &View, skeleton: &Skeleton, skin: &[Affine3A]) {
    let place = |bone: Bone, point: Vec3| skin[bone.index()].transform_point3(point);
    let left = [0.80, 0.45, 0.33];
    let right = [0.42, 0.52, 0.72];
    let middle = [0.75, 0.66, 0.55];
    for &bone in Bone::ALL {
        let Some(parent) = bone.parent() else {
            continue;
        };
        let color = match bone.name() {
            name if name.starts_with("left") => left,
            name if name.starts_with("right") => right,
            _ => middle,
        };
        let ends = [parent, bone].map(|b| place(b, skeleton.joint(b)));
        let mut radii = [radius(parent), radius(bone)];
        if matches!(
            bone.name(),
            "leftShoulder" | "rightShoulder" | "leftUpperLeg" | "rightUpperLeg"
        ) {
            radii[0] = radii[1];
        }
        if bone.name().contains("Proximal") || bone.name().contains("Thumb") {
            radii = [0.014, 0.01];
        }
        sheet.limb(view, ends, radii, color);
    }
    for side in [-1.0_f32, 1.0] {
        let (toes, foot) = if side > 0.0 {
            (Bone::LeftToes, Bone::LeftFoot)
        } else {
            (Bone::RightToes, Bone::RightFoot)
        };
        let color = if side > 0.0 { left } else { right };
        let ball = skeleton.joint(toes);
        let tip = place(toes, ball + Vec3::new(0.0, -0.008, 0.045));
        sheet.limb(view, [place(toes, ball), tip], [0.022, 0.014], color);
        let ankle = skeleton.joint(foot);
        let heel = place(foot, Vec3::new(ankle.x, 0.025, ankle.z - 0.03));
        sheet.limb(view, [place(foot, ankle), heel], [0.03, 0.025], color);
    }
    let head = skeleton.joint(Bone::Head);
    sheet.ball(
        view,
        place(Bone::Head, head + Vec3::new(0.0, 0.09, 0.0)),
        0.095,
        middle,
    );
    sheet.ball(
        view,
        place(Bone::Head, head + Vec3::new(0.0, 0.07, 0.1)),
        0.015,
        [0.9, 0.2, 0.2],
    );
}

fn main() {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| ".".into()));
    let skeleton = motion_support::woman();
    let mut cases: Vec<(String, MotionSettings)> = DanceStep::ALL
        .map(|dance_step| {
            let settings = MotionSettings {
                dance_step,
                ..MotionSettings::default()
            };
            (dance_step.id().to_owned(), settings)
        })
        .to_vec();
    let on_hips = MotionSettings {
        dance_step: DanceStep::Kao,
        arms: ArmStyle::HandsOnHips,
        ..MotionSettings::default()
    };
    cases.push(("kao_hips".to_owned(), on_hips));
    for (name, settings) in cases {
        let dance = Dance::new(&skeleton, &settings).expect("the defaults can be danced");
        let columns = settings.dance_step.counts() as usize * 2 + 1;
        let views = [
            (Vec3::X, Vec3::Z),
            (Vec3::NEG_Z, Vec3::X),
            (Vec3::NEG_X, Vec3::NEG_Z),
        ];
        let mut sheet = Sheet::new(columns, views.len());
        let half_count = 30.0 / settings.beats_per_minute;
        for column in 0..columns {
            let time = match column {
                0 => 0.0,
                _ => dance.lead_in() + (column - 1) as f32 * half_count,
            };
            let skin = skeleton.world_from_bind(&dance.pose_at(time));
            for (row, &(right, toward)) in views.iter().enumerate() {
                let hips = skin[Bone::Hips.index()].transform_point3(skeleton.joint(Bone::Hips));
                let view = View {
                    corner: [column * CELL[0], row * CELL[1]],
                    right,
                    toward,
                    centre: Vec3::new(hips.x, 0.0, 0.0),
                };
                for mark in -12..=7 {
                    let place = Vec3::new(0.1 * mark as f32, 0.0, 0.0);
                    sheet.ball(&view, place, 0.012, [0.5, 0.5, 0.5]);
                }
                draw(&mut sheet, &view, &skeleton, &skin);
            }
        }
        let height = sheet.pixels.len() / sheet.width;
        let mut file = format!("P6\n{} {height}\n255\n", sheet.width).into_bytes();
        file.extend(sheet.pixels.iter().flatten());
        fs::write(folder.join(format!("{name}.ppm")), file).expect("the folder is writable");
    }
}
