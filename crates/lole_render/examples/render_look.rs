//! A made-up dancer of simple shapes in a gathered, printed skirt, drawn by either backend, to
//! judge the look and to measure the time of a picture.
//!
//! `cargo run --release -p lole_render --example render_look -- cpu three-quarter out.png`

use glam::{Vec2, Vec3};
use lole_geom::{TriangleMesh, mesh::vertex_normals, trig};
use lole_render::{
    Backend, Camera, LightRig, Material, RenderError, Renderer, Scene, SceneMesh, Size, Texture,
    View,
};
use std::error::Error;
use std::f32::consts::TAU;
use std::io::Write;
use std::sync::Arc;

const COLUMNS: usize = 512;
const ROWS: usize = 50;
const TIMED_PICTURES: u32 = 5;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let argument = |index: usize, missing: &str| {
        arguments
            .get(index)
            .map_or_else(|| missing.to_owned(), Clone::clone)
    };
    let backend = match argument(0, "auto").as_str() {
        "cpu" => Backend::Cpu,
        "gpu" => Backend::Gpu,
        _ => Backend::Auto,
    };
    let view = match argument(1, "three-quarter").as_str() {
        "front" => View::Front,
        "side" => View::Side,
        "back" => View::Back,
        _ => View::ThreeQuarter,
    };
    let path = argument(2, "render_look.png");
    let (width, height) = match argument(3, "1280x720").split_once('x') {
        Some((width, height)) => (width.parse()?, height.parse()?),
        None => return Err("the size is written like 1280x720".into()),
    };
    let size = Size::new(width, height);

    let dancer = Dancer::new()?;
    let scene = dancer.scene(view, size);
    let mut renderer = Renderer::new(backend, size)?;
    let image = renderer.render(&scene)?;
    let milliseconds = time_pictures(&mut renderer, &scene)?;
    let mut out = std::io::stdout().lock();
    writeln!(
        out,
        "{path}: {width} x {height}, {}, {milliseconds:.1} ms a picture",
        renderer.description()
    )?;

    let mut encoder = png::Encoder::new(std::fs::File::create(&path)?, width, height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(&image.pixels)?;
    Ok(())
}

#[expect(clippy::disallowed_methods, reason = "an example that measures time")]
fn time_pictures(renderer: &mut Renderer, scene: &Scene<'_>) -> Result<f64, RenderError> {
    let start = std::time::Instant::now();
    for _ in 0..TIMED_PICTURES {
        renderer.render(scene)?;
    }
    Ok(start.elapsed().as_secs_f64() * 1000.0 / f64::from(TIMED_PICTURES))
}

struct Dancer {
    parts: Vec<(TriangleMesh, Material)>,
}

impl Dancer {
    fn new() -> Result<Self, RenderError> {
        let skin = || Material::skin([0.56, 0.34, 0.235]);
        let print = Arc::new(Texture::new(512, 512, flower_print(512))?);
        let leotard = Material {
            sheen: 0.2,
            ..Material::cloth([0.035, 0.03, 0.035])
        };
        let limb = |from: [f32; 3], to: [f32; 3], radii: [f32; 2]| {
            capsule(Vec3::from(from), Vec3::from(to), radii)
        };
        let parts = vec![
            (skirt(), Material::printed_cloth(print)),
            (
                limb([0.10, 0.80, 0.0], [0.10, 0.05, 0.02], [0.085, 0.045]),
                skin(),
            ),
            (
                limb([-0.10, 0.80, 0.0], [-0.10, 0.05, 0.02], [0.085, 0.045]),
                skin(),
            ),
            (
                limb([0.10, 0.035, 0.0], [0.12, 0.03, 0.14], [0.038, 0.028]),
                skin(),
            ),
            (
                limb([-0.10, 0.035, 0.0], [-0.12, 0.03, 0.14], [0.038, 0.028]),
                skin(),
            ),
            (
                limb([0.0, 0.90, 0.0], [0.0, 1.27, 0.0], [0.125, 0.12]),
                leotard,
            ),
            (
                limb([0.0, 1.25, 0.0], [0.0, 1.44, 0.0], [0.06, 0.05]),
                skin(),
            ),
            (
                limb([0.16, 1.30, 0.0], [0.42, 1.12, 0.12], [0.045, 0.035]),
                skin(),
            ),
            (
                limb([0.42, 1.12, 0.12], [0.62, 1.22, 0.28], [0.035, 0.025]),
                skin(),
            ),
            (
                limb([-0.16, 1.30, 0.0], [-0.30, 1.08, 0.10], [0.045, 0.035]),
                skin(),
            ),
            (
                limb([-0.30, 1.08, 0.10], [-0.24, 0.98, 0.24], [0.035, 0.025]),
                skin(),
            ),
            (
                limb([0.0, 1.50, 0.015], [0.0, 1.555, 0.01], [0.085, 0.092]),
                skin(),
            ),
            (
                limb([0.0, 1.57, -0.02], [0.0, 1.575, -0.035], [0.097, 0.095]),
                Material::hair([0.025, 0.016, 0.012]),
            ),
            (
                limb([0.0, 1.66, -0.07], [0.0, 1.68, -0.075], [0.045, 0.04]),
                Material::hair([0.025, 0.016, 0.012]),
            ),
        ];
        Ok(Self { parts })
    }

    fn scene(&self, view: View, size: Size) -> Scene<'_> {
        let meshes: Vec<_> = self
            .parts
            .iter()
            .map(|(mesh, material)| SceneMesh {
                positions: &mesh.positions,
                normals: &mesh.normals,
                uvs: &mesh.uvs,
                colors: &[],
                triangles: &mesh.triangles,
                material,
            })
            .collect();
        let camera = Camera {
            eye: Vec3::Z,
            target: Vec3::ZERO,
            vertical_fov: 0.4,
        };
        let mut scene = Scene::studio(camera);
        scene.meshes = meshes;
        if let Some(bounds) = scene.bounds() {
            scene.camera = Camera::framing(bounds, view, size.aspect());
            scene.lights = LightRig::seen_from(&scene.camera);
        }
        scene
    }
}

/// A gathered tube: small folds at the band that open into deep, uneven ones at the hem.
fn skirt() -> TriangleMesh {
    let mut mesh = TriangleMesh::default();
    for row in 0..=ROWS {
        let down = row as f32 / ROWS as f32;
        for column in 0..=COLUMNS {
            let around = column as f32 / COLUMNS as f32;
            mesh.positions.push(skirt_point(around, down));
            mesh.uvs.push(Vec2::new(around * 9.0, down * 1.6));
        }
    }
    let stride = COLUMNS + 1;
    for row in 0..ROWS {
        for column in 0..COLUMNS {
            let corner = index(row * stride + column);
            let below = corner + index(stride);
            mesh.triangles.push([corner, below, corner + 1]);
            mesh.triangles.push([corner + 1, below, below + 1]);
        }
    }
    mesh.normals = vertex_normals(&mesh.positions, &mesh.triangles);
    for row in 0..=ROWS {
        let (first, last) = (row * stride, row * stride + COLUMNS);
        let shared = (mesh.normals[first] + mesh.normals[last]).normalize_or_zero();
        mesh.normals[first] = shared;
        mesh.normals[last] = shared;
    }
    mesh
}

fn skirt_point(around: f32, down: f32) -> Vec3 {
    let angle = around * TAU;
    let small = trig::sin(angle * 44.0) * 0.007 * (1.0 - down);
    let uneven = trig::sin(angle * 3.0 + 1.0) * 1.4 + trig::sin(angle * 7.0) * 0.5;
    let large = trig::sin(angle * 16.0 + uneven) * 0.042 * down;
    let medium = trig::sin(angle * 31.0 + uneven * 2.0) * 0.012 * down;
    let hip = 0.155 + 0.19 * trig::powf(down, 0.75);
    let radius = hip + small + large + medium;
    let height = 0.98 - 0.74 * down + 0.012 * down * trig::sin(angle * 5.0);
    let sway = 0.05 * down * down;
    Vec3::new(
        radius * trig::sin(angle) + sway,
        height,
        radius * 0.86 * trig::cos(angle),
    )
}

fn capsule(from: Vec3, to: Vec3, radii: [f32; 2]) -> TriangleMesh {
    const AROUND: usize = 24;
    const CAP: usize = 6;
    const ALONG: usize = 16;
    let mut mesh = TriangleMesh::default();
    let axis = (to - from).normalize_or_zero();
    let (right, up) = axis.any_orthonormal_pair();
    let rings = 2 * CAP + ALONG + 1;
    for ring in 0..rings {
        let along = ring.clamp(CAP, CAP + ALONG) - CAP;
        let polar = (ring - along) as f32 / (2 * CAP) as f32 * TAU * 0.5;
        let share = along as f32 / ALONG as f32;
        let (center, radius) = (
            from.lerp(to, share),
            radii[0] + (radii[1] - radii[0]) * share,
        );
        for column in 0..=AROUND {
            let (sin, cos) = trig::sin_cos(column as f32 / AROUND as f32 * TAU);
            let outward = (right * cos + up * sin) * trig::sin(polar) - axis * trig::cos(polar);
            mesh.positions.push(center + outward * radius);
            mesh.normals.push(outward);
        }
    }
    let stride = index(AROUND + 1);
    for ring in 0..index(rings) - 1 {
        for column in 0..stride - 1 {
            let corner = ring * stride + column;
            mesh.triangles.push([corner, corner + 1, corner + stride]);
            mesh.triangles
                .push([corner + 1, corner + stride + 1, corner + stride]);
        }
    }
    mesh
}

#[expect(clippy::cast_possible_truncation, reason = "small meshes")]
const fn index(count: usize) -> u32 {
    count as u32
}

/// Five-petaled flowers with leaves on red ground.
#[expect(clippy::cast_possible_truncation, reason = "0 to 20")]
fn flower_print(side: usize) -> Vec<u8> {
    let mut pixels = Vec::with_capacity(side * side * 4);
    for y in 0..side {
        for x in 0..side {
            let at = Vec2::new(x as f32, y as f32) / side as f32;
            let mut color = [172, 24, 40];
            for (center, size, turn) in [
                (Vec2::new(0.30, 0.28), 0.23, 0.3),
                (Vec2::new(0.78, 0.72), 0.25, 1.1),
                (Vec2::new(0.82, 0.22), 0.12, 0.8),
                (Vec2::new(0.28, 0.80), 0.13, 0.0),
            ] {
                let mut away = at - center;
                away -= away.round();
                let angle = trig::atan2(away.y, away.x) + turn;
                let petal = trig::cos(angle * 2.5).abs();
                let edge = away.length() / (size * (0.55 + 0.45 * petal));
                let leaf =
                    away.length() / (size * (0.4 + 1.05 * trig::cos(angle * 1.5 + 1.0).abs()));
                if leaf < 0.95 && color[0] == 172 {
                    color = [28, 92, 62];
                }
                if edge < 1.0 {
                    let shade = (20.0 * (1.0 - edge)) as u8;
                    color = [252 - shade, 244 - shade, 226 - shade];
                }
                if away.length() < size * 0.16 {
                    color = [236, 178, 52];
                }
            }
            pixels.extend([color[0], color[1], color[2], 255]);
        }
    }
    pixels
}
