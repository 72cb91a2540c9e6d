//! Contact with the body and of the cloth with itself.
pub mod penalty;
