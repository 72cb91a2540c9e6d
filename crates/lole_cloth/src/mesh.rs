//! Cloth of any triangle mesh: pieces that are no rectangles.
//!
//! The method is that of the grid, small substeps with one projection of every constraint each,
//! and the same fabric, pins, capsules, skin and friction. Constraints differ: a triangle stretches along
//! warp and weft and shears, wherever the yarns lie across it, and a particle and its neighbors
//! bend as a plate. Sixteen constraints that share no particle are solved at a time.
//!
//! A piece lies in one plane, or is welded of several whose triangles each lie flat by themselves:
//! `MeshSpec::new`, `MeshSpec::welded` and `MeshSpec::of_surface`. Somebody else's garment on
//! somebody else's moving body takes [`MeshModel::settings`] and a [`MeshBody`].

mod bend;
mod body;
mod build;
pub(crate) mod contact;
pub mod diagnose;
pub(crate) mod finite;
pub(crate) mod model;
mod order;
pub(crate) mod particles;
mod resistance;
mod rest;
pub(crate) mod self_contact;
mod settings;
pub(crate) mod spec;
pub(crate) mod state;
pub(crate) mod step;
mod strain;
mod stride;
mod strip;
mod surface_order;
mod tether;
mod topology;
mod yarn;

pub use body::{BodyMeshError, Depths, MeshBody};
pub use model::MeshModel;
pub use spec::{MeshError, MeshSpec};
pub use state::MeshState;
pub use step::step;
pub use strip::Strip;
