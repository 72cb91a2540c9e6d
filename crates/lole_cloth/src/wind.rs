//! The paper's wind: one force on every particle, turning and swelling with time.

use glam::DVec3;

use crate::method::paper;

/// The wind of equations (4) and (5).
///
/// The same force acts on every particle whatever its area and velocity, so a finer grid of the
/// same cloth feels more of it; [`Wind::from_pressure`] takes that out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wind {
    /// `α` [N]: the largest force on one particle.
    pub amplitude: f64,
}

impl Wind {
    /// The wind whose largest force equals `pressure` [Pa] on the mean area of a particle:
    /// `area` [m²] is the whole cloth's, shared by `particle_count` particles.
    #[must_use]
    pub fn from_pressure(pressure: f64, area: f64, particle_count: u32) -> Self {
        Self {
            amplitude: pressure * area / f64::from(particle_count.max(1)),
        }
    }

    /// Force [N] on each particle at `time` [s]; zero at time zero, never longer than `amplitude`.
    #[must_use]
    pub fn force(&self, time: f64) -> DVec3 {
        paper::wind_force(self.amplitude, paper::wind_phases(time))
    }
}
