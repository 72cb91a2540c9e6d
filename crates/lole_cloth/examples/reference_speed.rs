//! Milliseconds of `fb-euler` per frame on a skirt-sized tube: `cargo run --release --example
//! reference_speed -p lole_cloth`.

#![allow(
    clippy::disallowed_methods,
    clippy::print_stdout,
    reason = "a measurement reads the clock and prints"
)]

use std::time::Instant;

use glam::{DVec3, Vec3};
use lole_cloth::method::explicit::{self, ExplicitConfig, ReferenceInput};
use lole_cloth::method::reference::{ReferenceModel, ReferenceState};
use lole_cloth::{ClothSpec, Fabric, Grid, MassLaw, Topology};
use lole_geom::{Capsule, trig64};

const FRAME_DT: f64 = 1.0 / 60.0;
const FRAME_COUNT: u32 = 5;

fn main() -> Result<(), lole_cloth::BuildError> {
    let grid = Grid {
        column_count: 512,
        row_count: 50,
        topology: Topology::Tube,
        spacing: [0.0075, 0.015],
        flounce: None,
        crimp: None,
    };
    let mut pinned = vec![false; grid.particle_count()];
    pinned[..512].fill(true);
    let spec = ClothSpec {
        grid,
        fabric: Fabric {
            areal_density: 0.11,
            thickness: 0.0002,
            stretch: [1000.0, 1000.0],
            shear: 60.0,
            bend: [9e-6, 6e-6],
            twist: 5e-6,
            hysteresis: lole_cloth::Hysteresis::NONE,
            friction: 0.4,
            cloth_friction: 0.4,
            drag_rate: 1.0,
        },
        row_layers: vec![1.0; 50],
        mass: MassLaw::AreaWeighted,
        pinned,
    };
    let model = ReferenceModel::new(&spec)?;
    let config = ExplicitConfig::for_model(&model, FRAME_DT);
    let radius = 0.0075 * 512.0 / std::f64::consts::TAU;
    let positions: Vec<DVec3> = (0..grid.row_count)
        .flat_map(|row| (0..grid.column_count).map(move |column| (row, column)))
        .map(|(row, column)| {
            let (sin, cos) = trig64::sin_cos(std::f64::consts::TAU * f64::from(column) / 512.0);
            DVec3::new(radius * cos, -0.015 * f64::from(row), radius * sin)
        })
        .collect();
    let pin_targets = positions[..512].to_vec();
    let mut state = ReferenceState::at_rest(positions);
    let capsules: Vec<Capsule> = (0u8..13)
        .map(|index| {
            let (sin, cos) = trig64::sin_cos(f64::from(index));
            let foot = DVec3::new(0.5 * cos, -0.4, 0.5 * sin).as_vec3();
            Capsule::uniform(foot, foot + Vec3::Y * 0.3, 0.13)
        })
        .collect();
    for frame in 0..FRAME_COUNT {
        let input = ReferenceInput {
            time: f64::from(frame) * FRAME_DT,
            pin_targets: &pin_targets,
            capsules: &capsules,
        };
        let start = Instant::now();
        let substeps = explicit::step(&model, &config, &input, &mut state, FRAME_DT);
        let milliseconds = start.elapsed().as_secs_f64() * 1e3;
        let substeps = substeps.expect("a target for every pin");
        let nanoseconds = milliseconds * 1e6 / (25_600.0 * f64::from(substeps));
        println!("{substeps} substeps {milliseconds:.0} ms, {nanoseconds:.1} ns per particle");
    }
    Ok(())
}
