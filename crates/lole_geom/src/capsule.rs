//! The capsule: a segment with a radius at each end, the body's collision shape.

use glam::Vec3;

/// Below this squared axis length [m²] a capsule is a sphere (a thread is 1e-4 m thick).
const DEGENERATE_AXIS_SQUARED: f32 = 1.0e-12;

/// A segment with a radius that varies linearly along it.
///
/// With equal radii this is the paper's capsule, and [`Capsule::signed_distance`] is exact.
/// With unequal radii the distance is measured across the axis, which overstates the true distance
/// to the cone by at most the factor `1 / cos(taper angle)`: under 2 % for the tapers of limbs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Capsule {
    /// Both ends of the axis [m].
    pub ends: [Vec3; 2],
    /// Radius at each end [m], not negative.
    pub radii: [f32; 2],
}

impl Capsule {
    /// The paper's capsule: one radius [m] all along.
    #[must_use]
    pub const fn uniform(start: Vec3, end: Vec3, radius: f32) -> Self {
        Self {
            ends: [start, end],
            radii: [radius, radius],
        }
    }

    /// Equation (11), clamped: the parameter `s` in `0..=1` of the axis point nearest to `point`,
    /// `s = (x - a)·(b - a) / |b - a|²`. A capsule without length is a sphere, `s = 0`.
    #[must_use]
    pub fn axis_parameter(&self, point: Vec3) -> f32 {
        let axis = self.ends[1] - self.ends[0];
        let length_squared = axis.length_squared();
        if length_squared < DEGENERATE_AXIS_SQUARED {
            return 0.0;
        }
        ((point - self.ends[0]).dot(axis) / length_squared).clamp(0.0, 1.0)
    }

    /// Distance [m] from `point` to the surface; negative inside.
    #[must_use]
    pub fn signed_distance(&self, point: Vec3) -> f32 {
        let s = self.axis_parameter(point);
        let foot = self.ends[0] + (self.ends[1] - self.ends[0]) * s;
        let radius = self.radii[0] + (self.radii[1] - self.radii[0]) * s;
        (point - foot).length() - radius
    }

    /// The capsule a `fraction` of the way towards `end`, ends and radii moved linearly.
    #[must_use]
    pub fn lerp(&self, end: &Self, fraction: f32) -> Self {
        Self {
            ends: [
                self.ends[0].lerp(end.ends[0], fraction),
                self.ends[1].lerp(end.ends[1], fraction),
            ],
            radii: [
                self.radii[0] + (end.radii[0] - self.radii[0]) * fraction,
                self.radii[1] + (end.radii[1] - self.radii[1]) * fraction,
            ],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_beyond_the_ends_see_a_hemisphere() {
        let capsule = Capsule::uniform(Vec3::ZERO, Vec3::Y, 0.1);
        assert!((capsule.signed_distance(Vec3::new(0.0, 1.5, 0.0)) - 0.4).abs() < 1e-6);
        assert!((capsule.signed_distance(Vec3::new(0.3, 0.5, 0.0)) - 0.2).abs() < 1e-6);
    }

    #[test]
    fn a_capsule_without_length_is_a_sphere() {
        let sphere = Capsule::uniform(Vec3::X, Vec3::X, 0.25);
        assert!((sphere.signed_distance(Vec3::ZERO) - 0.75).abs() < 1e-6);
        assert!((sphere.signed_distance(Vec3::X) + 0.25).abs() < 1e-6);
    }
}
