//! A flag in a wind that swings, and how much of it flies: `cargo run --release --example flag -p
//! lole_cloth`.

#![allow(clippy::print_stdout, reason = "an example says what it found")]

use glam::Vec3;
use lole_cloth::wind::{Wind, WindLaw};
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Fabric, Grid, MassLaw, SolverConfig, StepInput, Topology,
    step,
};

const FRAME_DT: f32 = 1.0 / 60.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let grid = Grid {
        column_count: 48,
        row_count: 33,
        topology: Topology::Sheet,
        spacing: [0.02, 0.02],
        flounce: None,
        crimp: None,
    };
    // The hoist, the first column, is tied to the pole.
    let pinned = (0..grid.particle_count()).map(|particle| particle % 48 == 0);
    let spec = ClothSpec {
        fabric: Fabric {
            areal_density: 0.11,
            thickness: 0.2e-3,
            stretch: [4000.0, 3000.0],
            shear: 80.0,
            bend: [5.0e-6, 4.0e-6],
            twist: 3.0e-6,
            hysteresis: lole_cloth::Hysteresis::NONE,
            friction: 0.3,
            cloth_friction: 0.3,
            // A flag is dragged along by the air more than a skirt that hangs in its lee.
            drag_rate: 3.0,
        },
        row_layers: vec![1.0; grid.row_count as usize],
        mass: MassLaw::AreaWeighted,
        pinned: pinned.collect(),
        grid,
    };
    let at = |row: u32, column: u32| Vec3::new(0.02 * column as f32, 2.0 - 0.02 * row as f32, 0.0);
    let places = (0..33).flat_map(|row| (0..48).map(move |column| at(row, column)));
    let positions: Vec<Vec3> = places.collect();
    let model = ClothModel::new(&spec)?;
    let mut state = ClothState::new(&model, &positions);
    let pins: Vec<Vec3> = (model.pin_indices().iter())
        .map(|&pin| positions[pin as usize])
        .collect();
    let wind = Wind {
        amplitude: 6.0,
        law: WindLaw::Spherical,
        heading: 0.0,
    };
    let mut now = Vec::new();
    for frame in 1..=600_u16 {
        let time = f64::from(frame) * f64::from(FRAME_DT);
        let input = StepInput {
            pin_targets: &pins,
            capsules: &[],
            air_velocity: wind.force(time).as_vec3(),
            ..StepInput::default()
        };
        step(
            &model,
            &SolverConfig::default(),
            &input,
            &mut state,
            FRAME_DT,
        )?;
        if frame % 60 == 0 {
            state.copy_positions(&model, &mut now);
            let fly = now[spec.grid.index(0, 47)];
            println!("{time:.0} s: the upper corner of the fly is at {fly:.2} m");
        }
    }
    Ok(())
}
