//! Rectangles that are gathered onto elastic: skirt and top.

pub mod pau_skirt;
pub mod pau_top;
mod rectangle;
mod steps;

pub use steps::Sewn;
