//! A limp square that falls in a heap, as a grid and as triangles: time of a frame and crossings,
//! without contact of the cloth with itself, with it, and with the repair of crossings besides:
//! `cargo run --release --example heap -p lole_cloth`.

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
use lole_cloth::scenes::FRAME_DT;
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Crossings, Fabric, Grid, Hysteresis, MassLaw, SelfCollision,
    SolverConfig, StepInput, Topology, diagnose, step,
};
use lole_geom::Capsule;

const SIDE: u32 = 64;
const SPACING: f32 = 0.01;
const FRAME_COUNT: usize = 100;

const FABRIC: Fabric = Fabric {
    areal_density: 0.15,
    thickness: 0.4e-3,
    stretch: [1000.0, 1000.0],
    shear: 50.0,
    bend: [5.0e-6, 5.0e-6],
    twist: 5.0e-6,
    friction: 0.3,
    cloth_friction: 0.3,
    hysteresis: Hysteresis::NONE,
    drag_rate: 0.0,
};

fn main() -> Result<(), Box<dyn Error>> {
    let grid = Grid {
        column_count: SIDE,
        row_count: SIDE,
        topology: Topology::Sheet,
        spacing: [SPACING; 2],
        flounce: None,
        crimp: None,
    };
    let flat: Vec<Vec2> = (0..grid.particle_count())
        .map(|k| {
            let (row, column) = (k / SIDE as usize, k % SIDE as usize);
            #[expect(clippy::cast_precision_loss, reason = "rows and columns are few")]
            let place = Vec2::new(column as f32, row as f32);
            place * SPACING
        })
        .collect();
    let positions: Vec<Vec3> = flat
        .iter()
        .map(|p| Vec3::new(p.x, 0.65 - p.y, 0.02 * p.x + 0.05 * p.y * p.y))
        .collect();
    let model = ClothModel::new(&ClothSpec {
        grid,
        fabric: FABRIC,
        row_layers: vec![1.0; SIDE as usize],
        mass: MassLaw::AreaWeighted,
        pinned: vec![false; grid.particle_count()],
    })?;
    let mesh_model = MeshModel::new(&MeshSpec::new(flat, grid.triangles(), FABRIC))?;
    let contact = |crossings: Crossings| {
        Some(SelfCollision {
            radius: 0.004,
            substep_interval: NonZeroU32::MIN,
            crossings,
        })
    };
    for (what, self_collision) in [
        ("without contact", None),
        ("with contact", contact(Crossings::Leave)),
        ("with repair", contact(Crossings::Repair)),
    ] {
        let config = SolverConfig {
            self_collision,
            structural_sweep_count: NonZeroU32::MIN,
            ..SolverConfig::default()
        };
        println!("{what}");
        fall((&model, &mesh_model), &config, &positions)?;
    }
    Ok(())
}

fn fall(
    (model, mesh_model): (&ClothModel, &MeshModel),
    config: &SolverConfig,
    positions: &[Vec3],
) -> Result<(), Box<dyn Error>> {
    // So large that it is level under the cloth.
    let ends = [-1.0, 1.0].map(|x| Vec3::new(x, -20.0, 0.0));
    let floor = [Capsule::uniform(ends[0], ends[1], 20.0)];
    let input = StepInput {
        capsules: &floor,
        ..StepInput::default()
    };
    let mut state = ClothState::new(model, positions);
    let mut mesh_state = MeshState::new(mesh_model, positions);
    let (mut seconds, mut worst) = ([0.0; 2], [0; 2]);
    let mut now = Vec::new();
    for _ in 0..FRAME_COUNT {
        let start = Instant::now();
        step(model, config, &input, &mut state, FRAME_DT).expect("a target for every pin");
        seconds[0] += start.elapsed().as_secs_f64();
        let start = Instant::now();
        let outcome = mesh::step(mesh_model, config, &input, &mut mesh_state, FRAME_DT);
        seconds[1] += start.elapsed().as_secs_f64();
        if let Err(cause) = outcome {
            return Err(cause.into());
        }
        state.copy_positions(model, &mut now);
        let count = diagnose::self_crossings(&model.spec().grid, &now).unwrap_or(usize::MAX);
        worst[0] = worst[0].max(count);
        mesh_state.copy_positions(mesh_model, &mut now);
        let count = mesh::diagnose::self_crossings(mesh_model, &now).unwrap_or(usize::MAX);
        worst[1] = worst[1].max(count);
    }
    state.copy_positions(model, &mut now);
    let of_grid = diagnose::strain(model.spec(), &now);
    mesh_state.copy_positions(mesh_model, &mut now);
    let of_mesh = mesh::diagnose::strain(mesh_model, &now);
    for (index, (what, strain)) in [("grid", of_grid), ("mesh", of_mesh)]
        .into_iter()
        .enumerate()
    {
        println!(
            "  {what}: {:.2} ms a frame, {} crossings at most, strain {:.2} % on the mean, {:.1} % at the 99th percentile",
            1.0e3 * seconds[index] / FRAME_COUNT as f64,
            worst[index],
            100.0 * strain.mean,
            100.0 * strain.p99
        );
    }
    Ok(())
}
