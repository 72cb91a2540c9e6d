//! The cloth engine: particles joined by springs that move under gravity, drag, wind and contact.
//!
//! It knows no garment and no dancer, and has no file, clock, log or picture in it.

pub mod fabric;
pub mod grid;
pub mod spec;

pub use fabric::Fabric;
pub use grid::{Grid, Topology};
pub use spec::{ClothSpec, MassLaw};
