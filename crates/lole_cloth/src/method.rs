//! The ways to move a cloth on: the paper's, for truth, and the real-time one, for dancing.

pub mod explicit;
pub mod explicit_rows;
pub(crate) mod fineness;
pub mod paper;
pub mod reference;
pub mod settle;
pub mod xpbd;
