//! Small pieces of triangles for the laws of the mesh.
#![allow(dead_code, reason = "every test file uses some of it")]

use std::num::NonZeroU32;

use glam::{Mat2, Vec2, Vec3};
use lole_cloth::mesh::{self, MeshModel, MeshSpec, MeshState};
use lole_cloth::{Fabric, Lost, SolverConfig, StepInput};
use lole_geom::Capsule;

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

/// Numbers in -0.5..0.5, the same every time (Knuth's generator).
pub(crate) struct Dice(u32);

impl Dice {
    pub(crate) const fn new(seed: u32) -> Self {
        Self(seed)
    }

    pub(crate) fn throw(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 8) as f32 / 16_777_216.0 - 0.5
    }
}

/// A rectangle of `columns` by `rows` particles. With `jitter`, a share of the spacing, particles
/// inside are thrown about and diagonals point either way.
pub(crate) fn rectangle(
    columns: u32,
    rows: u32,
    spacing: f32,
    jitter: f32,
) -> (Vec<Vec2>, Vec<[u32; 3]>) {
    let mut dice = Dice::new(7);
    let mut flat = Vec::new();
    for row in 0..rows {
        for column in 0..columns {
            let inside = 0 < row && row + 1 < rows && 0 < column && column + 1 < columns;
            let thrown = Vec2::new(dice.throw(), dice.throw()) * if inside { jitter } else { 0.0 };
            flat.push((Vec2::new(column as f32, row as f32) + thrown) * spacing);
        }
    }
    let mut triangles = Vec::new();
    for row in 0..rows - 1 {
        for column in 0..columns - 1 {
            let a = row * columns + column;
            let (b, c, d) = (a + 1, a + columns, a + columns + 1);
            if 0.0 < jitter && 0.0 < dice.throw() {
                triangles.extend([[a, b, c], [b, d, c]]);
            } else {
                triangles.extend([[a, b, d], [a, d, c]]);
            }
        }
    }
    (flat, triangles)
}

/// The piece as if its warp lay `turn` [rad] off the first axis.
pub(crate) fn turned(flat: &[Vec2], turn: f32) -> Vec<Vec2> {
    let turn = Mat2::from_angle(turn);
    flat.iter().map(|&point| turn * point).collect()
}

/// One piece and what it needs to move.
pub(crate) struct World {
    pub(crate) model: MeshModel,
    pub(crate) config: SolverConfig,
    pub(crate) state: MeshState,
    pub(crate) pins: Vec<Vec3>,
}

impl World {
    pub(crate) fn new(spec: &MeshSpec, positions: &[Vec3]) -> Self {
        let model = MeshModel::new(spec).expect("the piece is valid");
        let pins = model.pin_indices().iter();
        Self {
            pins: pins.map(|&pin| positions[pin as usize]).collect(),
            config: SolverConfig {
                structural_sweep_count: NonZeroU32::MIN,
                ..SolverConfig::default()
            },
            state: MeshState::new(&model, positions),
            model,
        }
    }

    pub(crate) fn with_substeps(mut self, count: u32) -> Self {
        self.config.substep_count = NonZeroU32::new(count).expect("a count");
        self
    }

    /// Without tethers and strides, which say nothing of the modulus.
    pub(crate) fn untethered(mut self) -> Self {
        self.config.tether_scale = None;
        self.config.row_strides.clear();
        self.config.column_strides.clear();
        self
    }

    pub(crate) fn try_step(&mut self, capsules: &[Capsule]) -> Result<(), Lost> {
        let input = StepInput {
            pin_targets: &self.pins,
            capsules,
            ..StepInput::default()
        };
        mesh::step(&self.model, &self.config, &input, &mut self.state, DT)
    }

    pub(crate) fn step(&mut self, capsules: &[Capsule]) {
        assert_eq!(self.try_step(capsules), Ok(()));
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
