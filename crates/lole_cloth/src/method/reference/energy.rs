//! Energy and momentum of the reference cloth, for the laws they obey.

use glam::DVec3;

use super::{ReferenceModel, ReferenceState};

/// Linear and angular momentum of the whole cloth.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Momentum {
    /// Linear momentum, `Σ m v` [kg·m/s].
    pub linear: DVec3,
    /// Angular momentum, `Σ m x × v` about the origin [kg·m²/s].
    pub angular: DVec3,
}

impl ReferenceModel {
    /// Energy [J] stored in the springs, `Σ ½ k (|P_ij| - L)²`.
    #[must_use]
    pub fn spring_energy(&self, positions: &[DVec3]) -> f64 {
        let mut energy = 0.0;
        for family in &self.springs {
            for &[a, b] in &family.ends {
                let length = (positions[b as usize] - positions[a as usize]).length();
                let extension = length - family.rest_length;
                energy += 0.5 * family.stiffness * extension * extension;
            }
        }
        energy
    }

    /// Energy [J] stored in bending and twist.
    #[must_use]
    pub fn plate_energy(&self, positions: &[DVec3]) -> f64 {
        self.plate.energy(positions)
    }

    /// Energy [J] of motion, `Σ ½ m v²`.
    #[must_use]
    pub fn kinetic_energy(&self, velocities: &[DVec3]) -> f64 {
        self.masses
            .iter()
            .zip(velocities)
            .map(|(mass, velocity)| 0.5 * mass * velocity.length_squared())
            .sum()
    }

    /// Linear and angular momentum.
    #[must_use]
    pub fn momentum(&self, state: &ReferenceState) -> Momentum {
        let mut momentum = Momentum::default();
        for ((&mass, &position), &velocity) in self
            .masses
            .iter()
            .zip(&state.positions)
            .zip(&state.velocities)
        {
            momentum.linear += velocity * mass;
            momentum.angular += position.cross(velocity) * mass;
        }
        momentum
    }
}
