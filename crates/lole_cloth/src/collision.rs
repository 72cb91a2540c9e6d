//! Contact with the body and of the cloth with itself.

pub(crate) mod capsule;
pub(crate) mod cloth_cloth;
pub(crate) mod crossing;
pub(crate) mod drift;
pub(crate) mod exact;
pub(crate) mod face_contact;
pub(crate) mod grid;
pub(crate) mod guards;
pub(crate) mod impact_zone;
pub mod layer;
pub(crate) mod outside;
pub(crate) mod parting;
pub(crate) mod patch_tree;
pub mod penalty;
pub(crate) mod pinned_rows;
pub(crate) mod placement;
pub(crate) mod repair;
pub(crate) mod response;
pub(crate) mod separation;
pub(crate) mod surface;
pub(crate) mod surfel;
