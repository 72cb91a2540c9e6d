//! Heads, hands and feet of dancers, large: what one looks at to judge them.
//!
//! `cargo run --release -p lole_picture --example likeness -- OUT` writes a picture for each of ten dancers: her
//! face from the front, from the side and from between, her hand from both sides, her foot, and how she blinks and
//! looks aside.

use std::error::Error;
use std::path::{Path, PathBuf};

use glam::{Affine3A, Quat, Vec3};
use lole_body::{Appearance, Bone, Dancer, Expression, Figure, HairStyle, Pose, Swing};
use lole_picture::{dancer_materials, drawn_body};
use lole_render::{Backend, Camera, Renderer, Scene, SceneMesh, Size};

use people::{Measures, all};

mod people;

/// Size of a view [pixel], and how many stand side by side.
const VIEW: Size = Size::new(520, 520);
const COLUMNS: usize = 3;

/// Name, figure, stature, bust, waist and hip [cm] as far as they are given, hair, and color of the skin.
type Who = (&'static str, Figure, Measures, HairStyle, [u8; 3]);

const FAIR: [u8; 3] = [222, 178, 148];
const TAN: [u8; 3] = [190, 136, 100];
const BROWN: [u8; 3] = [132, 88, 62];
const ANY: HairStyle = HairStyle::OfFigure;

const TEN: [Who; 10] = [
    ("woman", Figure::Woman, [None; 4], ANY, FAIR),
    (
        "small",
        Figure::Woman,
        all([150.0, 80.0, 62.0, 86.0]),
        HairStyle::Long,
        FAIR,
    ),
    (
        "large",
        Figure::Woman,
        all([163.0, 118.0, 108.0, 124.0]),
        ANY,
        TAN,
    ),
    (
        "tall",
        Figure::Woman,
        all([178.0, 88.0, 68.0, 94.0]),
        HairStyle::Short,
        BROWN,
    ),
    (
        "elder",
        Figure::Woman,
        all([152.0, 92.0, 82.0, 95.0]),
        ANY,
        FAIR,
    ),
    ("man", Figure::Man, [None; 4], ANY, TAN),
    (
        "stout_man",
        Figure::Man,
        all([178.0, 118.0, 112.0, 116.0]),
        ANY,
        BROWN,
    ),
    (
        "child_150",
        Figure::Child,
        [Some(150.0), None, None, None],
        ANY,
        FAIR,
    ),
    (
        "child_128",
        Figure::Child,
        [Some(128.0), None, None, None],
        HairStyle::Bun,
        TAN,
    ),
    (
        "child_100",
        Figure::Child,
        [Some(100.0), None, None, None],
        ANY,
        FAIR,
    ),
];

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("name a folder")?);
    std::fs::create_dir_all(&folder)?;
    for who in TEN {
        portrait(&folder.join(format!("{}.png", who.0)), who)?;
    }
    Ok(())
}

/// A dancer with one arm lowered a little.
struct Posed {
    dancer: Dancer,
    world_from_bind: Vec<Affine3A>,
}

/// What is looked at, from where, how much of it is seen [m], and what the face does.
type View = (Vec3, Vec3, f32, Expression);

impl Posed {
    fn new((_, figure, measures, hair, skin): Who) -> Result<Self, Box<dyn Error>> {
        let looks = (hair, |look: &mut Appearance| look.skin_srgb = skin);
        let dancer = people::dancer(figure, measures, looks)?;
        let mut pose = Pose::default();
        pose.rotate(
            Bone::LeftUpperArm,
            Quat::from_rotation_z(-20.0_f32.to_radians()),
        );
        Ok(Self {
            world_from_bind: dancer.skeleton.world_from_bind(&pose),
            dancer,
        })
    }

    fn views(&self) -> [View; 12] {
        let dancer = &self.dancer;
        let joint = |bone: Bone| {
            self.world_from_bind[bone.index()].transform_point3(dancer.skeleton.joint(bone))
        };
        let crown = dancer.landmarks.crown_height;
        let head = joint(Bone::Head);
        let face = Vec3::new(0.0, 0.42 * crown + 0.58 * head.y, head.z + 0.02);
        let hand = joint(Bone::LeftMiddleProximal);
        let foot = joint(Bone::LeftToes) - Vec3::Z * 0.03;
        let size = crown - head.y;
        let (ahead, half_aside) = (Vec3::Z, Vec3::new(0.75, 0.05, 0.8));
        let open = Expression::default();
        let closed = |closed: f32| Expression { closed, ..open };
        let looking = |way: Vec3| Expression {
            looks_at: Some(face + way),
            ..open
        };
        [
            (face, ahead, 1.25 * size, open),
            (face, half_aside, 1.25 * size, open),
            (face, Vec3::X, 1.25 * size, open),
            (hand, Vec3::new(1.0, 0.2, 0.3), 1.1 * size, open),
            (hand, Vec3::new(-1.0, 0.1, 0.6), 1.1 * size, open),
            (foot, Vec3::new(0.5, 0.9, 1.0), 1.3 * size, open),
            (face, ahead, 0.7 * size, closed(0.35)),
            (face, ahead, 0.7 * size, closed(0.7)),
            (face, ahead, 0.7 * size, closed(1.0)),
            (face, ahead, 0.7 * size, looking(Vec3::new(0.6, 0.5, 0.6))),
            (face, ahead, 0.7 * size, looking(Vec3::new(-0.4, -0.6, 0.5))),
            (face, half_aside, 0.7 * size, closed(1.0)),
        ]
    }

    fn draw(
        &self,
        (target, from, opening, expression): View,
        renderer: &mut Renderer,
    ) -> Result<Vec<u8>, Box<dyn Error>> {
        const DISTANCE: f32 = 2.2;
        let [positions, normals] = drawn_body(
            &self.dancer,
            &self.world_from_bind,
            (expression, &Swing::default()),
        );
        let mut scene = Scene::studio(Camera {
            eye: target + from.normalize_or(Vec3::Z) * DISTANCE,
            target,
            vertical_fov: opening / DISTANCE,
        });
        let skin = self.dancer.drawn();
        let materials = dancer_materials(&self.dancer)?;
        for (part, (_, material)) in skin.parts.iter().zip(&materials) {
            scene.meshes.push(SceneMesh {
                positions: &positions,
                normals: &normals,
                uvs: &skin.uvs,
                colors: &skin.colors,
                triangles: &part.triangles,
                material,
            });
        }
        Ok(renderer.render(&scene)?.pixels)
    }
}

fn portrait(path: &Path, who: Who) -> Result<(), Box<dyn Error>> {
    let posed = Posed::new(who)?;
    let views = posed.views();
    let mut renderer = Renderer::new(Backend::Cpu, VIEW)?;
    let [width, height] = [VIEW.width as usize, VIEW.height as usize];
    let rows = views.len() / COLUMNS;
    let mut sheet = vec![0_u8; COLUMNS * width * rows * height * 4];
    for (index, view) in views.into_iter().enumerate() {
        let pixels = posed.draw(view, &mut renderer)?;
        let [column, row] = [index % COLUMNS, index / COLUMNS];
        for (line, pixels) in pixels.chunks_exact(width * 4).enumerate() {
            let start = ((row * height + line) * COLUMNS + column) * width * 4;
            sheet[start..start + pixels.len()].copy_from_slice(pixels);
        }
    }
    let [wide, high] =
        [COLUMNS * width, rows * height].map(|side| u32::try_from(side).unwrap_or(0));
    let mut encoder = png::Encoder::new(std::fs::File::create(path)?, wide, high);
    encoder.set_color(png::ColorType::Rgba);
    encoder.write_header()?.write_image_data(&sheet)?;
    Ok(())
}
