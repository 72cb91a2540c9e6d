//! The surfel: a point of a surface and the direction in which the surface faces there.

use glam::Vec3;

/// Surface element (Pfister and others 2000, "Surfels"): what stands for a small patch of a body's
/// surface where only nearness counts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Surfel {
    /// Where it lies [m].
    pub position: Vec3,
    /// Unit normal, out of the body.
    pub normal: Vec3,
}
