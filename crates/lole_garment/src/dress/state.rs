//! What moves of a dressed garment.

use glam::Vec3;
use lole_cloth::assembly::{Assembly, AssemblyInput, AssemblyState, PieceState, step_observed};
use lole_cloth::{Lost, Phase};
use lole_geom::Capsule;

use super::{Dressed, FLOOR, World};

/// What moves of a dressed garment.
#[derive(Debug, Clone)]
pub struct DressedState {
    pub(super) state: AssemblyState,
}

impl DressedState {
    /// Moves the garment on by `dt` [s] in a world.
    ///
    /// # Errors
    /// Where a particle would go nowhere; nothing has moved then.
    pub fn step(&mut self, garment: &Dressed, world: &World<'_>, dt: f32) -> Result<(), Lost> {
        self.step_observed(garment, (world, dt), &mut |_| {})
    }

    /// The same, bit for bit, and `passed` is called whenever a [`Phase`] has ended, first of all for what the
    /// caller did before.
    ///
    /// # Errors
    /// As [`Self::step`].
    pub fn step_observed(
        &mut self,
        garment: &Dressed,
        (world, dt): (&World<'_>, f32),
        passed: &mut dyn FnMut(Phase),
    ) -> Result<(), Lost> {
        let targets = garment.pin_targets(world);
        self.step_to((targets, passed), &garment.assembly, (world, dt))
    }

    /// Substeps of its next step.
    #[must_use]
    pub fn substep_count(&self, garment: &Dressed) -> u32 {
        self.state.substep_count(&garment.assembly)
    }

    pub(super) fn step_as(
        &mut self,
        garment: &Dressed,
        assembly: &Assembly,
        (world, dt): (&World<'_>, f32),
    ) -> Result<(), Lost> {
        let targets = garment.pin_targets(world);
        self.step_to((targets, &mut |_| {}), assembly, (world, dt))
    }

    /// The same with what is pinned at these places [m] at the end of the step.
    pub(super) fn step_to(
        &mut self,
        (pin_targets, passed): (Vec<Vec3>, &mut dyn FnMut(Phase)),
        assembly: &Assembly,
        (world, dt): (&World<'_>, f32),
    ) -> Result<(), Lost> {
        let input = AssemblyInput {
            pin_targets: &[pin_targets],
            surfels: world.surfels,
            capsules: &[Capsule {
                ends: FLOOR.ends.map(|end| end + world.floor),
                ..FLOOR
            }],
            air_velocity: world.air_velocity,
            ..AssemblyInput::default()
        };
        step_observed(assembly, (&input, dt), &mut self.state, passed)
    }

    /// The same cloth as it hangs and moves, as a garment of the same cut that is held otherwise.
    #[must_use]
    pub fn passed_on(&self, from: &Dressed, to: &Dressed) -> Self {
        let mut positions = Vec::new();
        self.copy_positions(from, &mut positions);
        let mut state = AssemblyState::new(&to.assembly, &[positions]);
        let moving = self.state.pieces.iter().zip(&mut state.pieces);
        for pair in moving {
            if let ((PieceState::Mesh(before), PieceState::Mesh(after)), Some(from), Some(to)) =
                (pair, from.model(), to.model())
            {
                let mut velocities = Vec::new();
                before.copy_velocities(from, &mut velocities);
                after.set_velocities(to, &velocities);
            }
        }
        Self { state }
    }

    /// Writes every position [m] over `out`.
    pub fn copy_positions(&self, garment: &Dressed, out: &mut Vec<Vec3>) {
        for (state, piece) in self.state.pieces.iter().zip(garment.assembly.pieces()) {
            state.copy_positions(piece, out);
        }
    }

    /// Lays all of it at these places [m], at rest.
    pub(super) fn lay(&mut self, assembly: &Assembly, places: &[Vec3]) {
        self.state = AssemblyState::new(assembly, &[places.to_vec()]);
    }

    /// Multiplies every velocity.
    pub fn scale_velocities(&mut self, garment: &Dressed, factor: f32) {
        let Some(model) = garment.model() else {
            return;
        };
        for state in &mut self.state.pieces {
            if let PieceState::Mesh(state) = state {
                let mut velocities = Vec::new();
                state.copy_velocities(model, &mut velocities);
                velocities
                    .iter_mut()
                    .for_each(|velocity| *velocity *= factor);
                state.set_velocities(model, &velocities);
            }
        }
    }

    /// Particles that the last step left in the skin or held back, because it found no place for them
    /// outside of it that their cloth reaches without crossing.
    #[must_use]
    pub fn without_room(&self, garment: &Dressed) -> Vec<u32> {
        match (&self.state.pieces[..], garment.model()) {
            ([PieceState::Mesh(state)], Some(model)) => state.without_room(model),
            _ => Vec::new(),
        }
    }

    /// Moves it, and where its body was left, by as much [m], and makes it `faster` [m/s]: what a world that
    /// jumps carries along.
    pub fn carry(&mut self, by: Vec3, faster: Vec3) {
        self.state.carry(by, faster);
    }

    /// All bits of positions and velocities as one number.
    #[must_use]
    pub fn hash(&self) -> u64 {
        self.state.hash()
    }
}
