//! The law of finer steps: cloth that is pulled at is strained less with them, and calm cloth keeps its bits.

use std::num::NonZeroU32;

use glam::Vec3;
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Fabric, Grid, Hysteresis, MassLaw, SolverConfig, StepInput,
    Topology, diagnose, state_hash, step,
};
use lole_geom::trig;

const DT: f32 = 1.0 / 60.0;
const COLUMNS: u32 = 64;
const ROWS: u32 = 32;
const RADIUS: f32 = 0.2;
const LENGTH: f32 = 0.7;

/// A plain tube of cotton around a waist.
fn spec() -> ClothSpec {
    let grid = Grid {
        column_count: COLUMNS,
        row_count: ROWS,
        topology: Topology::Tube,
        spacing: [
            std::f32::consts::TAU * RADIUS / COLUMNS as f32,
            LENGTH / (ROWS - 1) as f32,
        ],
        flounce: None,
    };
    let mut pinned = vec![false; grid.particle_count()];
    pinned[..COLUMNS as usize].fill(true);
    ClothSpec {
        grid,
        fabric: Fabric {
            areal_density: 0.15,
            thickness: 4.0e-4,
            stretch: [800.0, 700.0],
            shear: 90.0,
            bend: [9.0e-6, 6.0e-6],
            twist: 4.0e-6,
            hysteresis: Hysteresis::NONE,
            friction: 0.3,
            cloth_friction: 0.3,
            drag_rate: 1.0,
        },
        row_layers: vec![1.0; ROWS as usize],
        mass: MassLaw::Uniform,
        pinned,
    }
}

fn ring(height: f32) -> Vec<Vec3> {
    (0..COLUMNS)
        .map(|column| {
            let angle = std::f32::consts::TAU * column as f32 / COLUMNS as f32;
            let (sin, cos) = trig::sin_cos(angle);
            Vec3::new(RADIUS * cos, height, RADIUS * sin)
        })
        .collect()
}

/// Strain (p99) after two seconds of hanging with so many times its weight, as a whirl pulls at a skirt, and all bits.
fn hung(weights: f32, times: u32) -> (f32, u64) {
    let spec = spec();
    let Ok(model) = ClothModel::new(&spec) else {
        panic!("a tube of cloth is a model");
    };
    let usual = NonZeroU32::MIN.saturating_add(5);
    let config = SolverConfig {
        substep_count: usual,
        strained_substep_count: usual.saturating_mul(NonZeroU32::MIN.saturating_add(times - 1)),
        gravity: weights * SolverConfig::default().gravity,
        structural_sweep_count: NonZeroU32::MIN,
        tether_scale: None,
        column_strides: Vec::new(),
        ..SolverConfig::default()
    };
    let start: Vec<Vec3> = (0..ROWS)
        .flat_map(|row| ring(1.0 - LENGTH * row as f32 / (ROWS - 1) as f32))
        .collect();
    let mut state = ClothState::new(&model, &start);
    let pin_targets = ring(1.0);
    let input = StepInput {
        pin_targets: &pin_targets,
        ..StepInput::default()
    };
    for _ in 0..120 {
        step(&model, &config, &input, &mut state, DT);
    }
    let mut positions = Vec::new();
    state.copy_positions(&model, &mut positions);
    (diagnose::strain(&spec, &positions).p99, state_hash(&state))
}

#[test]
fn cloth_that_is_pulled_at_is_strained_less_when_steps_may_be_finer() {
    let [(coarse, _), (fine, _)] = [1, 3].map(|times| hung(8.0, times));
    assert!(0.1 < coarse, "not strained enough to tell: {coarse}");
    assert!(fine < 0.6 * coarse, "{fine} instead of {coarse}");
}

#[test]
fn calm_cloth_keeps_its_bits_however_fine_steps_may_be() {
    let [(strain, coarse), (_, fine)] = [1, 3].map(|times| hung(0.25, times));
    assert!(strain < 0.06, "not calm: {strain}");
    assert_eq!(coarse, fine);
}
