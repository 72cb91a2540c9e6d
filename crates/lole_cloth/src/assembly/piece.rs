//! One piece of an assembly: a grid or triangles.

use glam::Vec3;

use crate::lanes::{LANES, Points};
use crate::mesh::particles::WIDTH;
use crate::mesh::{MeshModel, MeshState};
use crate::method::fineness::Fineness;
use crate::{ClothModel, ClothState, SolverConfig};

/// A prepared piece and its settings.
#[derive(Debug, Clone, PartialEq)]
pub enum ClothPiece {
    /// A piece of rows and columns.
    Grid(Box<ClothModel>, Box<SolverConfig>),
    /// A piece of any triangles.
    Mesh(Box<MeshModel>, Box<SolverConfig>),
}

/// What moves of a piece.
#[derive(Debug, Clone)]
pub enum PieceState {
    /// Of a piece of rows and columns.
    Grid(Box<ClothState>),
    /// Of a piece of any triangles.
    Mesh(Box<MeshState>),
}

impl ClothPiece {
    /// Number of particles.
    #[must_use]
    pub fn particle_count(&self) -> usize {
        match self {
            Self::Grid(model, _) => model.spec().grid.particle_count(),
            Self::Mesh(model, _) => model.particle_count(),
        }
    }

    /// Particles that are pinned, ascending.
    #[must_use]
    pub fn pin_indices(&self) -> &[u32] {
        match self {
            Self::Grid(model, _) => model.pin_indices(),
            Self::Mesh(model, _) => model.pin_indices(),
        }
    }

    /// How far two particles lie apart in the flat piece [m]: of a tube, the shorter way around.
    #[must_use]
    pub fn flat_distance(&self, [first, second]: [u32; 2]) -> f32 {
        match self {
            Self::Grid(model, _) => {
                let [first, second] = [first, second].map(|particle| particle as usize);
                crate::constraint::tether::flat_distance(&model.spec().grid, first, second)
            }
            Self::Mesh(model, _) => model.flat_distance([first, second]),
        }
    }

    pub(crate) fn config_mut(&mut self) -> &mut SolverConfig {
        match self {
            Self::Grid(_, config) | Self::Mesh(_, config) => config,
        }
    }

    /// Where a particle stands in the engine's own order, and its inverse mass [1/kg].
    pub(crate) fn slot(&self, particle: u32) -> (usize, f32) {
        let (slot, inv_masses) = match self {
            Self::Grid(model, _) => {
                let (vector, lane) = model.layout.slot(particle as usize);
                (vector * LANES + lane, &model.inv_masses)
            }
            Self::Mesh(model, _) => {
                let slot = model.slots.of_particle[particle as usize];
                (slot as usize, &model.inv_masses)
            }
        };
        (slot, inv_masses[slot / LANES].0[slot % LANES])
    }
}

impl PieceState {
    /// The piece at rest at `positions` [m].
    ///
    /// # Panics
    /// When `positions` has another length than the piece has particles.
    #[must_use]
    pub fn new(piece: &ClothPiece, positions: &[Vec3]) -> Self {
        match piece {
            ClothPiece::Grid(model, _) => Self::Grid(Box::new(ClothState::new(model, positions))),
            ClothPiece::Mesh(model, _) => Self::Mesh(Box::new(MeshState::new(model, positions))),
        }
    }

    /// Writes every position [m] over `out`.
    ///
    /// # Panics
    /// When `piece` is not the one that this is the state of.
    pub fn copy_positions(&self, piece: &ClothPiece, out: &mut Vec<Vec3>) {
        match (self, piece) {
            (Self::Grid(state), ClothPiece::Grid(model, _)) => state.copy_positions(model, out),
            (Self::Mesh(state), ClothPiece::Mesh(model, _)) => state.copy_positions(model, out),
            _ => panic!("the state of another piece"),
        }
    }

    /// Writes every velocity [m/s] over `out`.
    ///
    /// # Panics
    /// When `piece` is not the one that this is the state of.
    pub fn copy_velocities(&self, piece: &ClothPiece, out: &mut Vec<Vec3>) {
        match (self, piece) {
            (Self::Grid(state), ClothPiece::Grid(model, _)) => state.copy_velocities(model, out),
            (Self::Mesh(state), ClothPiece::Mesh(model, _)) => state.copy_velocities(model, out),
            _ => panic!("the state of another piece"),
        }
    }

    /// Positions and velocities.
    pub(crate) fn columns(&self) -> [&Vec<Points>; 2] {
        match self {
            Self::Grid(state) => [&state.positions, &state.velocities],
            Self::Mesh(state) => [&state.positions, &state.velocities],
        }
    }

    /// Positions and velocities, to be written.
    pub(crate) fn columns_mut(&mut self) -> [&mut Vec<Points>; 2] {
        match self {
            Self::Grid(state) => [&mut state.positions, &mut state.velocities],
            Self::Mesh(state) => [&mut state.positions, &mut state.velocities],
        }
    }

    pub(crate) const fn fineness_mut(&mut self) -> &mut Fineness {
        match self {
            Self::Grid(state) => &mut state.fineness,
            Self::Mesh(state) => &mut state.fineness,
        }
    }

    /// Where a slot is between the springs of a substep and its contacts [m].
    pub(crate) fn place(&self, slot: usize) -> Vec3 {
        match self {
            Self::Grid(state) => state.positions[slot / LANES].get(slot % LANES),
            Self::Mesh(state) => Vec3::from_slice(&state.scratch.particles[slot * WIDTH..]),
        }
    }

    /// Moves a slot there.
    pub(crate) fn shift(&mut self, slot: usize, change: Vec3) {
        let place = self.place(slot) + change;
        match self {
            Self::Grid(state) => state.positions[slot / LANES].set(slot % LANES, place),
            Self::Mesh(state) => {
                place.write_to_slice(&mut state.scratch.particles[slot * WIDTH..]);
            }
        }
    }
}
