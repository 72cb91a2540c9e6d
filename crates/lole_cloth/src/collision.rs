//! Contact with the body and of the cloth with itself.

pub(crate) mod capsule;
pub mod penalty;
