//! The cloth engine: particles joined by springs that move under gravity, drag, wind and contact.
//!
//! It knows no garment and no dancer, and has no file, clock, log or picture in it.

pub mod collision;
pub mod config;
mod constraint;
pub mod diagnose;
pub mod fabric;
pub mod grid;
mod lanes;
pub mod method;
pub mod model;
pub mod scenes;
pub mod snapshot;
pub mod spec;
pub mod state;
pub mod step;
pub mod wind;

pub use config::{InstructionSet, SelfCollision, SolverConfig};
pub use fabric::Fabric;
pub use grid::{Grid, Topology};
pub use model::{BuildError, ClothModel};
pub use snapshot::{reference_state_hash, state_hash};
pub use spec::{ClothSpec, MassLaw};
pub use state::ClothState;
pub use step::{StepInput, step};
