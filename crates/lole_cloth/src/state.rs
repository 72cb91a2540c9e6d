//! What moves: positions and velocities in the engine's own layout.
use glam::Vec3;
use lole_geom::Capsule;

use crate::ClothModel;

/// Everything about one cloth that changes from step to step.
#[derive(Debug, Clone, PartialEq)]
pub struct ClothState {
    pub(crate) positions: Vec<Vec3>,
    pub(crate) velocities: Vec<Vec3>,
    pub(crate) pin_targets: Vec<Vec3>,
    pub(crate) capsules: Vec<Capsule>,
}

impl ClothState {
    /// A cloth at rest at `positions` [m], row-major, shape `[particle_count]`.
    ///
    /// # Panics
    /// When `positions` has another length than the model has particles.
    #[must_use]
    pub fn new(model: &ClothModel, positions: &[Vec3]) -> Self {
        Self {
            positions: positions.to_vec(),
            velocities: vec![Vec3::ZERO; positions.len()],
            pin_targets: model
                .pin_indices()
                .iter()
                .map(|&i| positions[i as usize])
                .collect(),
            capsules: Vec::new(),
        }
    }

    /// Writes every position [m], row-major, over `out`.
    pub fn copy_positions(&self, model: &ClothModel, out: &mut Vec<Vec3>) {
        let _ = model;
        out.clone_from(&self.positions);
    }

    /// Writes every velocity [m/s], row-major, over `out`.
    pub fn copy_velocities(&self, model: &ClothModel, out: &mut Vec<Vec3>) {
        let _ = model;
        out.clone_from(&self.velocities);
    }

    /// Moves every particle to `positions` [m], row-major; velocities stay.
    pub fn set_positions(&mut self, model: &ClothModel, positions: &[Vec3]) {
        let _ = model;
        self.positions.copy_from_slice(positions);
    }

    /// Gives every particle its velocity [m/s], row-major.
    pub fn set_velocities(&mut self, model: &ClothModel, velocities: &[Vec3]) {
        let _ = model;
        self.velocities.copy_from_slice(velocities);
    }
}
