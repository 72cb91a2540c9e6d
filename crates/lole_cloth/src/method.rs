//! The ways to move a cloth on: the paper's, for truth, and the real-time one, for dancing.

pub mod xpbd;
