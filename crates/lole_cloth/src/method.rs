//! The ways to move a cloth on: the paper's, for truth, and the real-time one, for dancing.

pub mod fb_euler;
pub mod paper;
pub mod reference;
pub mod xpbd;
