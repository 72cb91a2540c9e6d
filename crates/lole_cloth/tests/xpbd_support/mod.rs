//! Small cloths for the laws of the real-time method.
#![allow(dead_code, reason = "every test file uses some of it")]

use std::num::NonZeroU32;

use glam::Vec3;
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Fabric, Grid, MassLaw, SolverConfig, StepInput, Topology,
    step,
};
use lole_geom::{Capsule, Surfel};

pub(crate) const DT: f32 = 1.0 / 60.0;

pub(crate) const FABRIC: Fabric = Fabric {
    areal_density: 0.15,
    thickness: 0.4e-3,
    stretch: [1000.0, 1000.0],
    shear: 50.0,
    bend: [5.0e-5, 5.0e-5],
    twist: 5.0e-5,
    hysteresis: lole_cloth::Hysteresis::NONE,
    friction: 0.3,
    cloth_friction: 0.3,
    drag_rate: 0.0,
};

/// One cloth and what it needs to move.
pub(crate) struct World {
    pub(crate) model: ClothModel,
    pub(crate) config: SolverConfig,
    pub(crate) state: ClothState,
    pub(crate) pins: Vec<Vec3>,
}

/// A level sheet of `columns` by `rows` with its first corner at the origin, `+X` and `+Z`.
pub(crate) fn flat_positions(columns: u32, rows: u32, spacing: f32) -> Vec<Vec3> {
    let rows = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
    rows.map(|(row, column)| Vec3::new(column as f32, 0.0, row as f32) * spacing)
        .collect()
}

/// The same, bulged a little so that it can buckle.
pub(crate) fn bulged_positions(columns: u32, rows: u32, spacing: f32) -> Vec<Vec3> {
    let mut positions = flat_positions(columns, rows, spacing);
    for (index, position) in positions.iter_mut().enumerate() {
        position.y = 0.001 * lole_geom::trig::sin(index as f32 * 0.7);
    }
    positions
}

/// Length of every row of a sheet over that of its first row's cloth.
pub(crate) fn row_lengths(grid: &Grid, positions: &[Vec3]) -> Vec<f32> {
    let columns = grid.column_count as usize;
    let lengths = positions.chunks_exact(columns).map(|row| {
        let edges = row.windows(2).map(|ends| ends[0].distance(ends[1]));
        edges.sum::<f32>() / ((columns - 1) as f32 * grid.spacing[0])
    });
    lengths.collect()
}

pub(crate) fn sheet_spec(columns: u32, rows: u32, spacing: f32, fabric: Fabric) -> ClothSpec {
    let grid = Grid {
        column_count: columns,
        row_count: rows,
        topology: Topology::Sheet,
        spacing: [spacing; 2],
        flounce: None,
        crimp: None,
    };
    ClothSpec {
        grid,
        fabric,
        row_layers: vec![1.0; rows as usize],
        mass: MassLaw::Uniform,
        pinned: vec![false; grid.particle_count()],
    }
}

impl World {
    pub(crate) fn new(spec: &ClothSpec, positions: &[Vec3]) -> Self {
        let model = ClothModel::new(spec).expect("the cloth is valid");
        let pins = model
            .pin_indices()
            .iter()
            .map(|&pin| positions[pin as usize])
            .collect();
        let state = ClothState::new(&model, positions);
        Self {
            config: SolverConfig::default(),
            state,
            pins,
            model,
        }
    }

    /// Moves the cloth on for some frames.
    pub(crate) fn run(mut self, frames: u32) -> Self {
        (0..frames).for_each(|_| self.step(&[]));
        self
    }

    pub(crate) fn with_substeps(mut self, count: u32) -> Self {
        self.config.substep_count = NonZeroU32::new(count).expect("a count");
        self
    }

    pub(crate) fn step(&mut self, capsules: &[Capsule]) {
        self.step_over(capsules, &[]);
    }

    /// Moves the cloth on over capsules and a surface.
    pub(crate) fn step_over(&mut self, capsules: &[Capsule], surfels: &[Surfel]) {
        let input = StepInput {
            pin_targets: &self.pins,
            capsules,
            surfels,
            ..StepInput::default()
        };
        step(&self.model, &self.config, &input, &mut self.state, DT)
            .expect("a target for every pin");
    }

    pub(crate) fn positions(&self) -> Vec<Vec3> {
        let mut positions = Vec::new();
        self.state.copy_positions(&self.model, &mut positions);
        positions
    }

    pub(crate) fn velocities(&self) -> Vec<Vec3> {
        let mut velocities = Vec::new();
        self.state.copy_velocities(&self.model, &mut velocities);
        velocities
    }
}

/// Mean of points, summed in f64.
pub(crate) fn mean(points: &[Vec3]) -> Vec3 {
    let sum = points
        .iter()
        .fold(glam::DVec3::ZERO, |sum, point| sum + point.as_dvec3());
    (sum / points.len() as f64).as_vec3()
}
