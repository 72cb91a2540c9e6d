//! Drops a flat piece from an OBJ file onto a capsule and writes how it lies: `cargo run --release
//! --example from_obj -p lole_cloth -- [piece.obj] [draped.obj]`.
//!
//! The piece lies in the plane of its first two coordinates, in meters, with the warp along the
//! first. Without a file a round one of 60 cm is made.

#![allow(clippy::print_stdout, reason = "an example says what it found")]

use std::error::Error;
use std::fmt::Write as _;
use std::io::Cursor;
use std::num::NonZeroU32;
use std::path::Path;

use glam::{Vec2, Vec3};
use lole_cloth::mesh::{self, MeshModel, MeshSpec, MeshState, diagnose};
use lole_cloth::{Fabric, SolverConfig, StepInput};
use lole_geom::{Capsule, trig};

const FRAME_DT: f32 = 1.0 / 60.0;
const FRAME_COUNT: u32 = 180;

/// A cotton for dresses.
const FABRIC: Fabric = Fabric {
    areal_density: 0.15,
    thickness: 0.4e-3,
    stretch: [4500.0, 2800.0],
    shear: 90.0,
    bend: [9.0e-6, 6.0e-6],
    twist: 4.0e-6,
    hysteresis: lole_cloth::Hysteresis::NONE,
    friction: 0.3,
    cloth_friction: 0.3,
    drag_rate: 1.0,
};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let text = match arguments.next() {
        Some(path) => std::fs::read_to_string(path)?,
        None => round_piece(24, 0.0125),
    };
    let out = arguments.next().unwrap_or_else(|| "draped.obj".to_owned());
    let (flat, triangles) = parse(&text)?;
    let model = MeshModel::new(&MeshSpec::new(flat, triangles, FABRIC))?;
    let flat = &model.spec().flat_positions;
    // Laid level, its middle 5 cm above the thigh that it falls on.
    let low = flat.iter().copied().fold(Vec2::INFINITY, Vec2::min);
    let high = flat.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max);
    let middle = 0.5 * (low + high);
    let positions: Vec<Vec3> = (flat.iter())
        .map(|&place| place - middle)
        .map(|place| Vec3::new(place.x, 0.14, place.y))
        .collect();
    let thigh = [Capsule::uniform(Vec3::NEG_X * 0.15, Vec3::X * 0.15, 0.09)];
    let mut state = MeshState::new(&model, &positions);
    let config = SolverConfig {
        structural_sweep_count: NonZeroU32::MIN,
        ..SolverConfig::default()
    };
    let input = StepInput {
        pin_targets: &[],
        capsules: &thigh,
        ..StepInput::default()
    };
    for _ in 0..FRAME_COUNT {
        if let Err(cause) = mesh::step(&model, &config, &input, &mut state, FRAME_DT) {
            return Err(cause.into());
        }
    }
    let mut now = Vec::new();
    state.copy_positions(&model, &mut now);
    let strain = diagnose::strain(&model, &now);
    let deepest = (now.iter()).map(|&place| -thigh[0].signed_distance(place));
    println!(
        "{} particles: strain {:.2} % on the mean, {:.3} mm in the capsule; written to {out}",
        now.len(),
        100.0 * strain.mean,
        1e3 * deepest.fold(0.0, f32::max)
    );
    std::fs::write(&out, obj(&now, model.triangles()))?;
    Ok(())
}

/// Flat positions [m] and triangles.
type Flat = (Vec<Vec2>, Vec<[u32; 3]>);

/// All objects of a file.
fn parse(text: &str) -> Result<Flat, Box<dyn Error>> {
    let options = tobj::LoadOptions {
        triangulate: true,
        ..tobj::LoadOptions::default()
    };
    // Materials say nothing of the fabric.
    let none = |_: &Path| tobj::load_mtl_buf(&mut Cursor::new(""));
    let (models, _) = tobj::load_obj_buf(&mut Cursor::new(text), &options, none)?;
    let mut flat = Vec::new();
    let mut triangles = Vec::new();
    for model in models {
        let first = u32::try_from(flat.len())?;
        for place in model.mesh.positions.chunks_exact(3) {
            if 1e-4 < place[2].abs() {
                return Err(format!("the piece is not flat: a vertex at {place:?}").into());
            }
            flat.push(Vec2::new(place[0], place[1]));
        }
        let corners = model.mesh.indices.chunks_exact(3);
        triangles.extend(corners.map(|corner| [0, 1, 2].map(|k| first + corner[k])));
    }
    Ok((flat, triangles))
}

/// A round piece of so many rings, as OBJ: each ring has six particles more than the one inside.
fn round_piece(ring_count: u16, spacing: f32) -> String {
    let mut text = String::from("o round\nv 0 0 0\n");
    // Particles of the ring inside, counted from 1 as OBJ does.
    let mut inner: Vec<u32> = vec![1];
    for ring in 1..=ring_count {
        let count = 6 * ring;
        let first = inner[inner.len() - 1] + 1;
        for step in 0..count {
            let turn = std::f32::consts::TAU * f32::from(step) / f32::from(count);
            let (sin, cos) = trig::sin_cos(turn);
            let radius = f32::from(ring) * spacing;
            line(
                &mut text,
                format_args!("v {} {} 0", radius * cos, radius * sin),
            );
        }
        let outer: Vec<u32> = (first..first + u32::from(count)).collect();
        // A sixth of the outer ring has one particle more than a sixth of the inner.
        let width = usize::from(ring);
        for (place, &here) in outer.iter().enumerate() {
            let next = outer[(place + 1) % outer.len()];
            let (sixth, within) = (place / width, place % width);
            let inside = |k: usize| inner[(sixth * (width - 1) + k) % inner.len()];
            line(
                &mut text,
                format_args!("f {here} {next} {}", inside(within)),
            );
            if 0 < within {
                let (before, after) = (inside(within - 1), inside(within));
                line(&mut text, format_args!("f {here} {after} {before}"));
            }
        }
        inner = outer;
    }
    text
}

/// Positions and triangles as OBJ.
fn obj(positions: &[Vec3], triangles: &[[u32; 3]]) -> String {
    let mut text = String::from("o draped\n");
    for place in positions {
        line(
            &mut text,
            format_args!("v {} {} {}", place.x, place.y, place.z),
        );
    }
    for [a, b, c] in triangles {
        line(&mut text, format_args!("f {} {} {}", a + 1, b + 1, c + 1));
    }
    text
}

/// One line more.
fn line(text: &mut String, words: std::fmt::Arguments<'_>) {
    // A string takes whatever is written.
    writeln!(text, "{words}").unwrap_or_default();
}
