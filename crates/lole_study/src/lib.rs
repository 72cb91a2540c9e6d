//! What is measured of cloth, and how it is judged.
//!
//! | Module | What it answers |
//! |---|---|
//! | [`figures`] | what a recorded dance comes to: the numbers of its report |
//! | [`paper`] | what the paper's integrators do, and whether its sentences hold |
//! | [`mod@bench`] | what a frame costs, scene by scene, with the quality it buys |
//! | [`soak`] | whether the laws hold however a body moves |
//! | [`validation`] | the engine against closed forms, as rows of a table |
//!
//! It reads no arguments, prints nothing, opens no file and has no clock of its own: the caller brings a
//! [`Clock`], is told how far a study is, and may call it off.

pub mod bench;
mod clock;
mod error;
pub mod figures;
pub mod paper;
pub mod soak;
pub mod validation;

pub use clock::{Clock, Stopwatch, Timing};
pub use error::StudyError;
