//! The law of finer steps: cloth that is pulled at is strained less with them, and calm cloth keeps its bits.

mod mesh_support;

use std::num::NonZeroU32;

use glam::Vec3;
use lole_cloth::assembly::{self, Assembly, AssemblyInput, AssemblyState, ClothPiece, PieceState};
use lole_cloth::mesh::{self, MeshModel, MeshSpec, MeshState};
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Fabric, Grid, Hysteresis, MassLaw, SolverConfig, StepInput,
    Topology, diagnose, mesh_state_hash, state_hash, step,
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
        crimp: None,
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

/// Settings with so many substeps, up to so many times as many, and gravity so many times as strong.
fn settings(usual: u32, weights: f32, times: u32) -> SolverConfig {
    let usual = NonZeroU32::new(usual).expect("a count");
    SolverConfig {
        substep_count: usual,
        strained_substep_count: usual.saturating_mul(NonZeroU32::MIN.saturating_add(times - 1)),
        gravity: weights * SolverConfig::default().gravity,
        structural_sweep_count: NonZeroU32::MIN,
        tether_scale: None,
        column_strides: Vec::new(),
        ..SolverConfig::default()
    }
}

/// Strain (p99) after two seconds of hanging with so many times its weight, as a whirl pulls at a skirt, and all bits.
fn hung(weights: f32, times: u32) -> (f32, u64) {
    let spec = spec();
    let Ok(model) = ClothModel::new(&spec) else {
        panic!("a tube of cloth is a model");
    };
    let config = settings(6, weights, times);
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
        step(&model, &config, &input, &mut state, DT).expect("a target for every pin");
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

/// A curtain of triangles that is held along its upper edge, and where it begins.
fn curtain() -> (MeshModel, Vec<Vec3>) {
    let (columns, rows) = (20, 30);
    let (flat, triangles) = mesh_support::rectangle(columns, rows, 0.02, 0.3);
    let start = flat.iter().map(|at| Vec3::new(at.x, 1.0 - at.y, 0.0));
    let start = start.collect();
    let mut spec = MeshSpec::new(flat, triangles, mesh_support::FABRIC);
    spec.pinned[..columns as usize].fill(true);
    (MeshModel::new(&spec).expect("a surface"), start)
}

/// Strain (p99) of the curtain after two seconds with so many times its weight, and all bits: alone, and as
/// the piece of an assembly.
fn hung_of_triangles(weights: f32, times: u32) -> [(f32, u64); 2] {
    let (model, start) = curtain();
    let config = settings(12, weights, times);
    let pins: Vec<Vec3> = (model.pin_indices().iter())
        .map(|&pin| start[pin as usize])
        .collect();
    let input = StepInput {
        pin_targets: &pins,
        ..StepInput::default()
    };
    let mut alone = MeshState::new(&model, &start);
    let piece = ClothPiece::Mesh(Box::new(model.clone()), Box::new(config.clone()));
    let assembly = Assembly::new(vec![piece], &[], config.substep_count)
        .expect("nothing is joined")
        .with_strained_substep_count(config.strained_substep_count);
    let mut joined = AssemblyState::new(&assembly, std::slice::from_ref(&start));
    let together = AssemblyInput {
        pin_targets: std::slice::from_ref(&pins),
        ..AssemblyInput::default()
    };
    for _ in 0..120 {
        assert_eq!(mesh::step(&model, &config, &input, &mut alone, DT), Ok(()));
        assembly::step(&assembly, &together, &mut joined, DT).expect("nothing is lost");
    }
    let looked_at = |state: &MeshState| {
        let mut positions = Vec::new();
        state.copy_positions(&model, &mut positions);
        let strain = mesh::diagnose::strain(&model, &positions).p99;
        (strain, mesh_state_hash(state))
    };
    let [PieceState::Mesh(joined)] = &joined.pieces[..] else {
        panic!("it is one mesh");
    };
    [looked_at(&alone), looked_at(joined)]
}

#[test]
fn triangles_and_what_is_joined_are_strained_less_too() {
    let [coarse, fine] = [1, 3].map(|times| hung_of_triangles(8.0, times));
    for ((coarse, _), (fine, _)) in coarse.into_iter().zip(fine) {
        assert!(0.1 < coarse, "not strained enough to tell: {coarse}");
        assert!(fine < 0.6 * coarse, "{fine} instead of {coarse}");
    }
}

#[test]
fn calm_triangles_keep_their_bits() {
    let [coarse, fine] = [1, 3].map(|times| hung_of_triangles(0.25, times));
    for ((strain, coarse), (_, fine)) in coarse.into_iter().zip(fine) {
        assert!(strain < 0.04, "not calm: {strain}");
        assert_eq!(coarse, fine);
    }
}
