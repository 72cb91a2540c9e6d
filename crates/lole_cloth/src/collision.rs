//! Contact with the body and of the cloth with itself.

pub(crate) mod capsule;
pub(crate) mod cloth_cloth;
pub(crate) mod grid;
pub mod penalty;
pub(crate) mod pinned_rows;
pub(crate) mod response;
pub(crate) mod surfel;
