//! The surfel: a point of a surface and the direction in which the surface faces there.

use glam::Vec3;

/// Surface element (Pfister and others 2000, "Surfels"): what stands for a small patch of a body's
/// surface where only nearness counts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Surfel {
    /// Where it lies [m].
    pub position: Vec3,
    /// Unit normal, out of the body; zero where nothing touches it.
    pub normal: Vec3,
}

impl Surfel {
    /// Whether nothing touches it.
    #[must_use]
    pub fn is_withdrawn(&self) -> bool {
        self.normal == Vec3::ZERO
    }

    /// The surfel a `fraction` of the way towards `end`, the normal's length left as it comes out;
    /// withdrawn if either is.
    #[must_use]
    pub fn lerp(&self, end: &Self, fraction: f32) -> Self {
        let normal = if self.is_withdrawn() || end.is_withdrawn() {
            Vec3::ZERO
        } else {
            self.normal.lerp(end.normal, fraction)
        };
        Self {
            position: self.position.lerp(end.position, fraction),
            normal,
        }
    }
}
