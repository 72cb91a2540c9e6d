//! The hanging square of a grid and of triangles, side by side, at equal settings: `cargo run
//! --release --example mesh_against_grid -p lole_cloth`.
//!
//! Strain and cost per particle and substep, with the scenes' own settings and with the default,
//! which has six sweeps for the grid; triangles take one.

#![allow(
    clippy::disallowed_methods,
    clippy::print_stdout,
    reason = "a measurement reads the clock and prints"
)]

use std::error::Error;
use std::num::NonZeroU32;
use std::time::Instant;

use glam::{Vec2, Vec3};
use lole_cloth::mesh::{self, MeshModel, MeshSpec, MeshState};
use lole_cloth::scenes::{FRAME_DT, SCENES, Setup};
use lole_cloth::{ClothModel, ClothState, SolverConfig, StepInput, diagnose, step};

const FRAME_COUNT: u32 = 300;

fn main() -> Result<(), Box<dyn Error>> {
    for name in ["hang-64", "hang-128"] {
        let Some(scene) = SCENES.iter().find(|scene| scene.name == name) else {
            continue;
        };
        let own = (scene.build)();
        let default = Setup {
            config: SolverConfig::default(),
            ..own.clone()
        };
        for (settings, setup) in [("its own", own), ("the default", default)] {
            for jitter in [0.0, 0.5] {
                println!("{name}, {settings} settings, particles thrown by {jitter} cells");
                compare(&setup, jitter)?;
            }
        }
    }
    Ok(())
}

/// The square of a setup as triangles, each particle inside thrown by up to half of so many cells.
fn triangulated(setup: &Setup, jitter: f32) -> MeshSpec {
    let grid = &setup.spec.grid;
    let mut seed = 1_u32;
    let mut throw = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f32::from((seed >> 16) as u16) / 65_536.0 - 0.5
    };
    let mut flat = Vec::new();
    let mut triangles = Vec::new();
    let (columns, rows) = (grid.column_count, grid.row_count);
    for row in 0..rows {
        for column in 0..columns {
            let is_inside = 0 < row && row + 1 < rows && 0 < column && column + 1 < columns;
            let thrown = Vec2::new(throw(), throw()) * if is_inside { jitter } else { 0.0 };
            let place = setup.positions[grid.index(row, column)];
            flat.push(Vec2::new(place.x, place.z) + thrown * grid.spacing[0]);
            if row + 1 < rows && column + 1 < columns {
                let a = row * columns + column;
                let (b, c, d) = (a + 1, a + columns, a + columns + 1);
                triangles.extend([[a, b, d], [a, d, c]]);
            }
        }
    }
    MeshSpec {
        pinned: setup.spec.pinned.clone(),
        ..MeshSpec::new(flat, triangles, setup.spec.fabric)
    }
}

fn compare(setup: &Setup, jitter: f32) -> Result<(), Box<dyn Error>> {
    let spec = triangulated(setup, jitter);
    let mesh_model = MeshModel::new(&spec)?;
    let model = ClothModel::new(&setup.spec)?;
    let flat = spec.flat_positions.iter();
    let positions: Vec<Vec3> = flat.map(|flat| Vec3::new(flat.x, 0.0, flat.y)).collect();
    let mut mesh_state = MeshState::new(&mesh_model, &positions);
    let mut state = ClothState::new(&model, &setup.positions);
    let pins = model.pin_indices().iter();
    let pins: Vec<Vec3> = pins.map(|&pin| setup.positions[pin as usize]).collect();
    let input = StepInput {
        pin_targets: &pins,
        capsules: &[],
        ..StepInput::default()
    };
    let mesh_config = SolverConfig {
        structural_sweep_count: NonZeroU32::MIN,
        ..setup.config.clone()
    };
    // The least of many frames: other programs only ever add.
    let mut least = [f64::INFINITY; 2];
    for _ in 0..FRAME_COUNT {
        let start = Instant::now();
        step(&model, &setup.config, &input, &mut state, FRAME_DT).expect("a target for every pin");
        least[0] = least[0].min(start.elapsed().as_secs_f64());
        let start = Instant::now();
        let outcome = mesh::step(&mesh_model, &mesh_config, &input, &mut mesh_state, FRAME_DT);
        least[1] = least[1].min(start.elapsed().as_secs_f64());
        if let Err(cause) = outcome {
            return Err(cause.into());
        }
    }
    let mut now = Vec::new();
    state.copy_positions(&model, &mut now);
    let of_grid = diagnose::strain(&setup.spec, &now);
    mesh_state.copy_positions(&mesh_model, &mut now);
    let of_mesh = mesh::diagnose::strain(&mesh_model, &now);
    let work = f64::from(setup.config.substep_count.get()) * 1e-9 * f64::from(grid_size(setup));
    for (what, strain, seconds) in [("grid", of_grid, least[0]), ("mesh", of_mesh, least[1])] {
        println!(
            "  {what}: {:.1} ns, strain {:.2} % on the mean, {:.1} % at the 99th percentile",
            seconds / work,
            100.0 * strain.mean,
            100.0 * strain.p99
        );
    }
    println!("  mesh / grid: {:.2}", least[1] / least[0]);
    Ok(())
}

fn grid_size(setup: &Setup) -> u32 {
    setup.spec.grid.column_count * setup.spec.grid.row_count
}
