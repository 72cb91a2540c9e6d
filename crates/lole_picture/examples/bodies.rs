//! Six bodies side by side, and their faces, each from its tape: the pictures of `docs/body.md`.
//!
//! `cargo run --release -p lole_picture --example bodies -- docs` writes `bodies.png`, `faces.png`,
//! `backs.png` and `people.png` there.

use std::error::Error;
use std::path::{Path, PathBuf};

use glam::{Affine3A, Mat3A, Quat, Vec3};
use lole_body::appearance::hair_srgb_at;
use lole_body::{Appearance, Bone, Dancer, Face, Figure, HairStyle, PartKind, Pose};
use lole_picture::{Strands, dancer_materials};
use lole_render::{Backend, Camera, Material, Renderer, Scene, SceneMesh, Size};

use people::{Measures, all};

mod people;

/// How far the dancers stand apart [m].
const APART: f32 = 0.74;
/// Size of the pictures [pixel].
const BODIES: Size = Size::new(1200, 600);
const FACES: Size = Size::new(1200, 310);

/// Who stands there: figure, stature, bust, waist and hip [cm] as far as they are given, and hair.
type Who = (Figure, Measures, HairStyle);

const SIX: [Who; 6] = [
    (Figure::Woman, [None; 4], HairStyle::OfFigure),
    (
        Figure::Woman,
        all([150.0, 80.0, 62.0, 86.0]),
        HairStyle::Long,
    ),
    (
        Figure::Woman,
        all([163.0, 102.0, 90.0, 106.0]),
        HairStyle::OfFigure,
    ),
    (Figure::Man, [None; 4], HairStyle::OfFigure),
    (
        Figure::Child,
        [Some(128.0), None, None, None],
        HairStyle::OfFigure,
    ),
    (
        Figure::Child,
        [Some(100.0), None, None, None],
        HairStyle::OfFigure,
    ),
];

/// Figure, age [years] and face by chance of those who show how faces differ, in rows of six.
const PEOPLE: [(Figure, f32, u64); 12] = [
    (Figure::Woman, 24.0, 11),
    (Figure::Woman, 38.0, 12),
    (Figure::Woman, 52.0, 13),
    (Figure::Woman, 60.0, 14),
    (Figure::Woman, 68.0, 15),
    (Figure::Woman, 79.0, 16),
    (Figure::Child, 8.0, 17),
    (Figure::Child, 8.0, 18),
    (Figure::Woman, 24.0, 19),
    (Figure::Woman, 24.0, 20),
    (Figure::Man, 34.0, 21),
    (Figure::Man, 66.0, 22),
];

/// Positions and normals of body and hair's strands where a dancer stands.
type Placed = [(Vec<Vec3>, Vec<Vec3>); 2];

/// One dancer as she is drawn: posed vertices and the materials of her parts.
struct Drawn {
    dancer: Dancer,
    posed: Placed,
    materials: Vec<(PartKind, Material)>,
    /// Middle of the head [m].
    head: Vec3,
}

impl Drawn {
    fn new(
        (figure, measures, hair): Who,
        change: impl FnOnce(&mut Appearance),
    ) -> Result<Self, Box<dyn Error>> {
        let dancer = people::dancer(figure, measures, (hair, change))?;
        let world_from_bind = dancer.skeleton.world_from_bind(&standing());
        let drawn = dancer.drawn_body.as_ref().ok_or("she is not drawn")?;
        let posed = [dancer.drawn(), &drawn.strands].map(|mesh| {
            let (mut positions, mut normals) = (Vec::new(), Vec::new());
            mesh.pose(&world_from_bind, &mut positions, &mut normals);
            (positions, normals)
        });
        let head = dancer.skeleton.joint(Bone::Head);
        let crown = dancer.landmarks.crown_height;
        Ok(Self {
            materials: dancer_materials(&dancer)?,
            head: world_from_bind[Bone::Head.index()].transform_point3(Vec3::new(
                0.0,
                0.5 * (head.y + crown),
                head.z,
            )),
            dancer,
            posed,
        })
    }

    /// Turned about the vertical by an angle [rad] and moved.
    fn placed(&self, turn: f32, to: Vec3) -> Placed {
        let place = Affine3A {
            matrix3: Mat3A::from_quat(Quat::from_rotation_y(turn)),
            translation: to.into(),
        };
        self.posed.each_ref().map(|(positions, normals)| {
            let positions = positions.iter().map(|&p| place.transform_point3(p));
            let normals = normals.iter().map(|&n| place.transform_vector3(n));
            (positions.collect(), normals.collect())
        })
    }
}

/// Arms lowered a little from the bind pose, so that six fit side by side.
fn standing() -> Pose {
    let mut pose = Pose::default();
    for (bone, side) in [(Bone::LeftUpperArm, 1.0), (Bone::RightUpperArm, -1.0)] {
        let down = -side * 20.0_f32.to_radians();
        pose.rotate(bone, Quat::from_rotation_z(down));
    }
    pose
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "docs".into()));
    let six =
        (SIX.into_iter().map(|who| Drawn::new(who, |_| ()))).collect::<Result<Vec<_>, _>>()?;
    let middle = 0.5 * APART * (six.len() - 1) as f32;
    let place = |index: usize| Vec3::X * (APART * index as f32 - middle);
    let bodies: Vec<_> = (six.iter().enumerate())
        .map(|(index, drawn)| (drawn, drawn.placed(0.0, place(index))))
        .collect();
    let camera = |height: f32, opening: f32, distance: f32| Camera {
        eye: Vec3::new(0.0, height, distance),
        target: Vec3::new(0.0, height, 0.0),
        // Far away an angle is its tangent.
        vertical_fov: opening / distance,
    };
    let whole = camera(0.84, 2.36, 14.0);
    draw(&folder.join("bodies.png"), BODIES, whole, &bodies)?;
    let backs: Vec<_> = (six.iter().enumerate())
        .map(|(index, drawn)| (drawn, drawn.placed(2.5, place(index))))
        .collect();
    draw(&folder.join("backs.png"), BODIES, whole, &backs)?;
    let heads = heads_of(&six);
    draw(&folder.join("faces.png"), FACES, faces(), &heads)?;
    let people = PEOPLE.into_iter().map(|(figure, age, seed)| {
        let stature = (figure == Figure::Child).then_some(128.0);
        let who = (figure, [stature, None, None, None], HairStyle::OfFigure);
        Drawn::new(who, |look| {
            look.face = Face::of_seed(seed);
            look.age_years = Some(age);
            look.hair_srgb = hair_srgb_at(age, look.hair_srgb);
        })
    });
    let people = people.collect::<Result<Vec<_>, _>>()?;
    let (above, below) = people.split_at(people.len() / 2);
    let rows = [above, below].map(|row| drawn(FACES, faces(), &heads_of(row)));
    let [above, below] = rows;
    save(
        &folder.join("people.png"),
        FACES,
        &[above?, below?].concat(),
    )
}

/// How far apart heads stand [m].
const HEADS_APART: f32 = 0.27;

/// Where faces are looked at from: all of a picture's width is six of them.
fn faces() -> Camera {
    let height = -0.015;
    Camera {
        eye: Vec3::new(0.0, height, 4.0),
        target: Vec3::new(0.0, height, 0.0),
        vertical_fov: 0.1,
    }
}

/// Six heads at one height, as near as they fill the picture, every other one turned.
fn heads_of(six: &[Drawn]) -> Vec<(&Drawn, Placed)> {
    (six.iter().enumerate())
        .map(|(index, drawn)| {
            let turn = if index % 2 == 0 { 0.0 } else { -0.55 };
            let to = Vec3::X * (HEADS_APART * (index as f32 - 2.5)) - Vec3::Y * drawn.head.y;
            (drawn, drawn.placed(turn, to))
        })
        .collect()
}

fn draw(
    path: &Path,
    size: Size,
    camera: Camera,
    bodies: &[(&Drawn, Placed)],
) -> Result<(), Box<dyn Error>> {
    save(path, size, &drawn(size, camera, bodies)?)
}

/// Pixels of a picture, RGB.
fn drawn(
    size: Size,
    camera: Camera,
    bodies: &[(&Drawn, Placed)],
) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut scene = Scene::studio(camera);
    let strands: Vec<Option<Strands>> = (bodies.iter())
        .map(|(drawn, _)| Strands::of(&drawn.dancer, &drawn.materials))
        .collect();
    for ((_, [_, (positions, normals)]), strands) in bodies.iter().zip(&strands) {
        let strands = strands.as_ref();
        (scene.meshes).extend(strands.map(|strands| strands.mesh([positions, normals])));
    }
    for (drawn, [(positions, normals), _]) in bodies {
        let skin = drawn.dancer.drawn();
        for (part, (_, material)) in skin.parts.iter().zip(&drawn.materials) {
            scene.meshes.push(SceneMesh {
                positions,
                normals,
                uvs: &skin.uvs,
                colors: &skin.colors,
                triangles: &part.triangles,
                material,
            });
        }
    }
    let image = Renderer::new(Backend::Cpu, size)?.render(&scene)?;
    let pixels = (image.pixels.chunks_exact(4)).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]);
    Ok(pixels.collect())
}

/// Writes pictures of one size below each other.
fn save(path: &Path, size: Size, pixels: &[u8]) -> Result<(), Box<dyn Error>> {
    let height = u32::try_from(pixels.len())? / (3 * size.width);
    let mut encoder = png::Encoder::new(std::fs::File::create(path)?, size.width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    encoder.write_header()?.write_image_data(pixels)?;
    Ok(())
}
