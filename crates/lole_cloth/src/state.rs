//! What moves: positions and velocities in the engine's own layout.

use glam::Vec3;
use lole_geom::{Capsule, Surfel};

use crate::collision::capsule::MovingCapsule;
use crate::collision::capsule::near::RowContacts;
use crate::collision::capsule::stop::TangentPlanes;
use crate::collision::cloth_cloth::ClothContacts;
use crate::collision::placement::particles_of;
use crate::collision::repair::CrossingRepair;
use crate::collision::surfel::SurfelContacts;
use crate::constraint::hysteresis::Sets;
use crate::lanes::Points;
use crate::method::explicit_rows::Form;
use crate::method::fineness::{Fineness, Substeps};
use crate::method::xpbd::{RowStrides, Schedules, WovenRows};
use crate::pins::PinGoals;
use crate::{ClothModel, SolverConfig};

/// Everything about one cloth that changes from step to step.
#[derive(Debug, Clone)]
pub struct ClothState {
    pub(crate) positions: Vec<Points>,
    pub(crate) velocities: Vec<Points>,
    /// How the yarns were left.
    pub(crate) yarn_sets: Sets,
    /// Where the pinned particles were left, in the order of the model's pins.
    pub(crate) pin_targets: Vec<Vec3>,
    /// Where the capsules were left; empty before the first step.
    pub(crate) capsules: Vec<Capsule>,
    /// Where the surfels were left; empty before the first step.
    pub(crate) surfels: Vec<Surfel>,
    /// Into how many substeps the next step is cut.
    pub(crate) fineness: Fineness,
    pub(crate) scratch: Scratch,
}

/// Room for one step, kept so that no step allocates. What it holds is found anew in every step, or
/// is worked out from model and settings alone.
/// Where the cloth is tangled, and what was parted and is guarded, is what the end of the last step has found.
#[derive(Debug, Clone, Default)]
pub(crate) struct Scratch {
    /// Positions predicted at the start of the substep.
    pub(crate) predicted: Vec<Points>,
    /// Forces on a row and those below it that it reaches [N].
    pub(crate) forces: Vec<Points>,
    /// Stiffness of a row's particles and of the next's.
    pub(crate) forms: Vec<Form>,
    pub(crate) tangent_planes: TangentPlanes,
    pub(crate) row_contacts: RowContacts,
    pub(crate) surfel_contacts: SurfelContacts,
    pub(crate) held_depths: Vec<f32>,
    pub(crate) pin_goals: PinGoals,
    pub(crate) cloth_contacts: ClothContacts,
    pub(crate) crossing_repair: CrossingRepair,
    pub(crate) moving_capsules: Vec<MovingCapsule>,
    pub(crate) woven: WovenRows,
    pub(crate) row_strides: RowStrides,
    pub(crate) schedules: Schedules,
}

/// All places and velocities that a state holds, for a world that jumps to carry along.
pub(crate) struct Carried<'a> {
    pub(crate) positions: &'a mut [Points],
    pub(crate) velocities: &'a mut [Points],
    /// Where pins, capsules and surfels were left.
    pub(crate) pin_targets: &'a mut [Vec3],
    pub(crate) capsules: &'a mut [Capsule],
    pub(crate) surfels: &'a mut [Surfel],
}

impl Carried<'_> {
    /// Moves all places by as much [m], and makes particles `faster` [m/s].
    pub(crate) fn carry(self, by: Vec3, faster: Vec3) {
        for points in self.positions {
            points.shift(by);
        }
        for points in self.velocities {
            points.shift(faster);
        }
        for target in self.pin_targets {
            *target += by;
        }
        for capsule in self.capsules {
            capsule.ends = capsule.ends.map(|end| end + by);
        }
        for surfel in self.surfels {
            surfel.position += by;
        }
    }
}

impl ClothState {
    /// A cloth at rest at `positions` [m], row-major, shape `[particle_count]`.
    ///
    /// # Panics
    /// When `positions` has another length than the model has particles.
    #[must_use]
    pub fn new(model: &ClothModel, positions: &[Vec3]) -> Self {
        let vector_count = model.layout.vector_count();
        let mut state = Self {
            positions: vec![Points::default(); vector_count],
            velocities: vec![Points::default(); vector_count],
            yarn_sets: Sets::default(),
            pin_targets: Vec::new(),
            capsules: Vec::new(),
            surfels: Vec::new(),
            fineness: Fineness::default(),
            scratch: Scratch {
                predicted: vec![Points::default(); vector_count],
                ..Scratch::default()
            },
        };
        state.set_positions(model, positions);
        state
    }

    /// Substeps of the next step: as many as usual, or more where the last one left the cloth strained.
    #[must_use]
    pub fn substep_count(&self, config: &SolverConfig) -> u32 {
        self.fineness.substep_count(Substeps::of(config))
    }

    /// Pairs of an edge and a triangle that are kept from crossing, because an earlier step had to part
    /// them: in how many places the cloth presses on itself.
    #[must_use]
    pub const fn pressed_count(&self) -> usize {
        self.scratch.crossing_repair.guards.count()
    }

    /// Particles that the last step left in the skin or held back, because it found no place for them
    /// outside of it that their cloth reaches without crossing.
    #[must_use]
    pub fn without_room(&self, model: &ClothModel) -> Vec<u32> {
        let count = model.spec().grid.particle_count();
        let scratch = &self.scratch;
        let sets = [
            &scratch.crossing_repair.held_back,
            &scratch.surfel_contacts.without_room,
        ];
        particles_of(sets, &model.layout, count)
    }

    /// Memory that it holds, room for a step included [byte].
    #[must_use]
    pub fn byte_count(&self) -> usize {
        size_of_val(&self.positions[..])
            + size_of_val(&self.velocities[..])
            + self.yarn_sets.byte_count()
            + size_of_val(&self.scratch.predicted[..])
            + size_of_val(&self.pin_targets[..])
            + size_of_val(&self.surfels[..])
            + size_of_val(&self.fineness.positions[..])
            + self.scratch.pin_goals.byte_count()
            + self.scratch.surfel_contacts.byte_count()
            + self.scratch.cloth_contacts.byte_count()
            + self.scratch.crossing_repair.byte_count()
            + self.scratch.tangent_planes.byte_count()
    }

    /// Every position [m], row-major.
    #[must_use]
    pub fn positions(&self, model: &ClothModel) -> Vec<Vec3> {
        let mut positions = Vec::new();
        self.copy_positions(model, &mut positions);
        positions
    }

    /// Writes every position [m], row-major, over `out`.
    pub fn copy_positions(&self, model: &ClothModel, out: &mut Vec<Vec3>) {
        model.layout.gather_points(&self.positions, out);
    }

    /// Writes every position [m], row-major, after what is in `out`: several cloths lie in one list then.
    pub fn add_positions(&self, model: &ClothModel, out: &mut Vec<Vec3>) {
        let slots = (0..model.spec().grid.particle_count()).map(|it| model.layout.slot(it));
        out.extend(slots.map(|(vector, lane)| self.positions[vector].get(lane)));
    }

    /// Writes every velocity [m/s], row-major, over `out`.
    pub fn copy_velocities(&self, model: &ClothModel, out: &mut Vec<Vec3>) {
        model.layout.gather_points(&self.velocities, out);
    }

    /// Moves every particle, pinned ones too, to `positions` [m], row-major; velocities stay, and
    /// the yarns forget how they were bent and sheared.
    ///
    /// # Panics
    /// When `positions` has another length than the model has particles.
    pub fn set_positions(&mut self, model: &ClothModel, positions: &[Vec3]) {
        assert_eq!(
            positions.len(),
            model.spec().grid.particle_count(),
            "one position a particle"
        );
        model.layout.scatter_points(positions, &mut self.positions);
        self.scratch.crossing_repair.forget();
        self.scratch.surfel_contacts.forget();
        self.yarn_sets.clear();
        self.pin_targets.clear();
        self.pin_targets.extend(
            model
                .pin_indices()
                .iter()
                .map(|&pin| positions[pin as usize]),
        );
    }

    /// Gives every particle its velocity [m/s], row-major.
    ///
    /// # Panics
    /// When `velocities` has another length than the model has particles.
    pub fn set_velocities(&mut self, model: &ClothModel, velocities: &[Vec3]) {
        assert_eq!(
            velocities.len(),
            model.spec().grid.particle_count(),
            "one velocity a particle"
        );
        self.velocities.fill(Points::default());
        for (particle, &velocity) in velocities.iter().enumerate() {
            let (vector, lane) = model.layout.slot(particle);
            self.velocities[vector].set(lane, velocity);
        }
    }

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

    /// Multiplies every velocity by `factor`.
    pub fn scale_velocities(&mut self, factor: f32) {
        for velocity in &mut self.velocities {
            for axis in [&mut velocity.x, &mut velocity.y, &mut velocity.z] {
                axis.iter_mut().for_each(|value| *value *= factor);
            }
        }
    }
}
