//! What moves of a piece: positions and velocities in the engine's own order.

use glam::Vec3;
use lole_geom::{Capsule, Surfel};

use crate::collision::capsule::MovingCapsule;
use crate::collision::capsule::near::RowContacts;
use crate::collision::face_contact::FaceContacts;
use crate::collision::placement::{Placement as _, particles_of};
use crate::collision::repair::CrossingRepair;
use crate::collision::surfel::SurfelContacts;
use crate::lanes::Points;
use crate::mesh::model::MeshModel;
use crate::mesh::resistance::Resisting;
use crate::mesh::stride::Strides;
use crate::method::fineness::Fineness;
use crate::pins::PinGoals;
use crate::state::Carried;

/// Everything about one piece that changes from step to step.
#[derive(Debug, Clone)]
pub struct MeshState {
    pub(crate) positions: Vec<Points>,
    pub(crate) velocities: Vec<Points>,
    /// Where the pinned particles were left, in the order of the model's pins.
    pub(crate) pin_targets: Vec<Vec3>,
    /// Where the capsules were left; empty before the first step.
    pub(crate) capsules: Vec<Capsule>,
    /// Where the surfels were left; empty before the first step.
    pub(crate) surfels: Vec<Surfel>,
    pub(crate) fineness: Fineness,
    pub(crate) scratch: MeshScratch,
}

/// Room for one step, kept so that no step allocates. Of what it holds only where the piece is
/// tangled, and what was parted and is guarded, goes from step to step: that is what the end of the last
/// one has found.
#[derive(Debug, Clone, Default)]
pub(crate) struct MeshScratch {
    /// Positions predicted at the start of the substep.
    pub(crate) predicted: Vec<Points>,
    /// Particles while constraints are solved.
    pub(crate) particles: Vec<f32>,
    pub(crate) contacts: RowContacts,
    pub(crate) moving_capsules: Vec<MovingCapsule>,
    pub(crate) surfel_contacts: SurfelContacts,
    pub(crate) pin_goals: PinGoals,
    /// By patch, how far inside the body its particles may stay [m]: nowhere.
    pub(crate) held: Vec<f32>,
    pub(crate) face_contacts: FaceContacts,
    pub(crate) crossing_repair: CrossingRepair,
    pub(crate) strides: Strides,
    pub(crate) resisting: Resisting,
    /// Positions and velocities before the step.
    kept: [Vec<Points>; 2],
}

impl MeshState {
    /// Moves the cloth, and where pins and body were left, all by as much [m], and makes the cloth `faster`
    /// [m/s]: what a world that jumps carries along.
    pub fn carry(&mut self, by: Vec3, faster: Vec3) {
        Carried {
            positions: &mut self.positions,
            velocities: &mut self.velocities,
            pin_targets: &mut self.pin_targets,
            capsules: &mut self.capsules,
            surfels: &mut self.surfels,
        }
        .carry(by, faster);
    }

    /// A piece at rest at `positions` [m], shape `[particle_count]`.
    ///
    /// # Panics
    /// When `positions` has another length than the model has particles.
    #[must_use]
    pub fn new(model: &MeshModel, positions: &[Vec3]) -> Self {
        let count = model.vector_count();
        let mut state = Self {
            positions: vec![Points::default(); count],
            velocities: vec![Points::default(); count],
            pin_targets: Vec::new(),
            capsules: Vec::new(),
            surfels: Vec::new(),
            fineness: Fineness::default(),
            scratch: MeshScratch {
                predicted: vec![Points::default(); count],
                particles: vec![0.0; model.column_length()],
                held: vec![0.0; model.slots.row_count()],
                ..MeshScratch::default()
            },
        };
        state.set_positions(model, positions);
        state
    }

    /// Every position [m].
    #[must_use]
    pub fn positions(&self, model: &MeshModel) -> Vec<Vec3> {
        let mut positions = Vec::new();
        self.copy_positions(model, &mut positions);
        positions
    }

    /// Writes every position [m] over `out`.
    pub fn copy_positions(&self, model: &MeshModel, out: &mut Vec<Vec3>) {
        model.slots.gather_points(&self.positions, out);
    }

    /// Writes every velocity [m/s] over `out`.
    pub fn copy_velocities(&self, model: &MeshModel, out: &mut Vec<Vec3>) {
        model.slots.gather_points(&self.velocities, out);
    }

    /// Moves every particle, pinned ones too, to `positions` [m]; velocities stay.
    ///
    /// # Panics
    /// When `positions` has another length than the model has particles.
    pub fn set_positions(&mut self, model: &MeshModel, positions: &[Vec3]) {
        assert_eq!(
            positions.len(),
            model.particle_count(),
            "one position a particle"
        );
        let filler = positions.first().copied().unwrap_or_default();
        model.scatter_points(positions, filler, &mut self.positions);
        self.scratch.crossing_repair.forget();
        self.scratch.surfel_contacts.forget();
        self.pin_targets.clear();
        let pins = model.pin_indices().iter();
        self.pin_targets
            .extend(pins.map(|&pin| positions[pin as usize]));
    }

    /// Particles that the last step left in the skin or held back, because it found no place for them
    /// outside of it that their cloth reaches without crossing.
    #[must_use]
    pub fn without_room(&self, model: &MeshModel) -> Vec<u32> {
        let scratch = &self.scratch;
        let sets = [
            &scratch.crossing_repair.held_back,
            &scratch.surfel_contacts.without_room,
        ];
        particles_of(sets, &model.slots, model.particle_count())
    }

    /// Gives every particle its velocity [m/s].
    ///
    /// # Panics
    /// When `velocities` has another length than the model has particles.
    pub fn set_velocities(&mut self, model: &MeshModel, velocities: &[Vec3]) {
        assert_eq!(
            velocities.len(),
            model.particle_count(),
            "one velocity a particle"
        );
        model.scatter_points(velocities, Vec3::ZERO, &mut self.velocities);
    }

    /// Remembers where everything is.
    pub(crate) fn keep(&mut self) {
        let [positions, velocities] = &mut self.scratch.kept;
        positions.clone_from(&self.positions);
        velocities.clone_from(&self.velocities);
    }

    /// Puts everything back.
    pub(crate) fn restore(&mut self) {
        let [positions, velocities] = &self.scratch.kept;
        self.positions.clone_from(positions);
        self.velocities.clone_from(velocities);
    }
}
