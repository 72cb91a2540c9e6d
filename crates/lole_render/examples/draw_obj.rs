//! Draws OBJ files: `cargo run --release -p lole_render --example draw_obj -- out.png body.obj dress.obj …` shows
//! the first as skin and the others as cloth, from the front, the side and the back.
//!
//! `v` and `f` of triangles are read; meters, `+Y` up.

use std::error::Error;

use glam::Vec3;
use lole_geom::mesh::vertex_normals;
use lole_render::{Backend, Camera, Material, Renderer, Scene, SceneMesh, Size, View};

/// Size of one view [pixel].
const VIEW: Size = Size::new(560, 900);

/// Colors of what is drawn, linear: skin, then cloth.
const SKIN: [f32; 3] = [0.55, 0.33, 0.22];
const CLOTH: [[f32; 3]; 2] = [[0.45, 0.05, 0.08], [0.05, 0.2, 0.45]];

struct Obj {
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

fn read(path: &str) -> Result<Obj, Box<dyn Error>> {
    let text = std::fs::read_to_string(path)?;
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for line in text.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            ["v", x, y, z] => positions.push(Vec3::new(x.parse()?, y.parse()?, z.parse()?)),
            ["f", a, b, c] => {
                triangles.push([a.parse()?, b.parse()?, c.parse()?].map(|it: u32| it - 1));
            }
            _ => {}
        }
    }
    Ok(Obj {
        normals: vertex_normals(&positions, &triangles),
        positions,
        triangles,
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [out, files @ ..] = &arguments[..] else {
        return Err("draw_obj out.png body.obj dress.obj …".into());
    };
    let meshes = files
        .iter()
        .map(|it| read(it))
        .collect::<Result<Vec<_>, _>>()?;
    let points: Vec<Vec3> = meshes
        .iter()
        .flat_map(|it| it.positions.iter().copied())
        .collect();
    let materials: Vec<Material> = (0..meshes.len()).map(material).collect();
    let mut renderer = Renderer::new(Backend::Cpu, VIEW)?;
    let mut views = Vec::new();
    for view in [View::Front, View::Side, View::Back] {
        let camera = Camera::framing_points(&points, view, VIEW.aspect());
        let mut scene = Scene::studio(camera);
        scene.meshes = meshes.iter().zip(&materials).map(drawn).collect();
        views.push(renderer.render(&scene)?.pixels);
    }
    write(out, &views)
}

/// Skin is the first, cloth the others.
fn material(index: usize) -> Material {
    match index.checked_sub(1) {
        None => Material::skin(SKIN),
        Some(cloth) => Material::cloth(CLOTH[cloth % CLOTH.len()]),
    }
}

fn drawn<'a>((obj, material): (&'a Obj, &'a Material)) -> SceneMesh<'a> {
    SceneMesh {
        positions: &obj.positions,
        normals: &obj.normals,
        uvs: &[],
        colors: &[],
        triangles: &obj.triangles,
        material,
    }
}

/// Views side by side.
fn write(path: &str, views: &[Vec<u8>]) -> Result<(), Box<dyn Error>> {
    let line = VIEW.width as usize * 4;
    let mut pixels = Vec::new();
    for row in 0..VIEW.height as usize {
        for view in views {
            pixels.extend_from_slice(&view[row * line..][..line]);
        }
    }
    let file = std::io::BufWriter::new(std::fs::File::create(path)?);
    let width = VIEW.width * u32::try_from(views.len())?;
    let mut encoder = png::Encoder::new(file, width, VIEW.height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(&pixels)?;
    Ok(())
}
