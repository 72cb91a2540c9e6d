//! A handkerchief, held by two corners, swings down and hangs: `cargo run --release --example hang -p
//! lole_cloth`.

#![allow(clippy::print_stdout, reason = "an example says what it found")]

use std::error::Error;

use glam::Vec3;
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Fabric, Grid, SolverConfig, StepInput, diagnose, step,
};

/// Particles a side, and how far apart they lie [m].
const SIDE: u32 = 48;
const SPACING: f32 = 0.008;

fn main() -> Result<(), Box<dyn Error>> {
    let grid = Grid::sheet(SIDE, SIDE, [SPACING; 2]);
    let is_corner = |row: u32, column: u32| row == 0 && (column == 0 || column == SIDE - 1);
    let spec = ClothSpec::new(grid, Fabric::COTTON).pinned_where(is_corner);
    let place = |row: u32, column: u32| Vec3::new(column as f32, 0.0, row as f32) * SPACING;
    let start = (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| place(row, column)));
    let start: Vec<Vec3> = start.collect();
    let model = ClothModel::new(&spec)?;
    let mut state = ClothState::new(&model, &start);
    let (config, world) = (SolverConfig::default(), StepInput::default());
    for frame in 1..=180 {
        step(&model, &config, &world, &mut state, 1.0 / 60.0)?;
        if frame % 60 == 0 {
            let now = state.positions(&model);
            let lowest = now.iter().map(|at| at.y).fold(0.0, f32::min);
            let strain = diagnose::strain(&spec, &now);
            println!(
                "{} s: hangs down {:.0} mm, stretched by {:.1} % at the 99th percentile",
                frame / 60,
                -1000.0 * lowest,
                100.0 * strain.p99
            );
        }
    }
    Ok(())
}
