//! Moving air: the paper's wind, one force on every particle that turns and swells with time, and
//! air that pushes every cell by its area and direction ([`blow`]), steady or in gusts.

mod gust;
mod plates;

pub use gust::{GustyWind, WindNow};
pub use plates::{Aerodynamics, AirPush, blow};

use glam::DVec3;
use lole_geom::trig64;

use crate::method::paper;

/// Time [s] in which a steady wind rises: at once, it would strike cloth that hangs at rest.
const RISE: f64 = 1.0;

/// The wind of equations (4) and (5), or a steady one.
///
/// The same force acts on every particle whatever its area and velocity, so a finer grid of the
/// same cloth feels more of it; [`Wind::from_pressure`] takes that out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wind {
    /// `α` [N]: the largest force on one particle, of [`WindLaw::Spherical`].
    pub amplitude: f64,
    /// How (4) is read.
    pub law: WindLaw,
    /// Where a steady wind blows to [rad]: 0 is `+Z`, a quarter turn `+X`. The paper's winds turn by
    /// themselves and have none.
    pub heading: f64,
}

/// How equation (4), printed as a scalar that acts "in the x-axis and z-axis directions", is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum WindLaw {
    /// Its two terms are the two components: the wind turns.
    #[default]
    Spherical,
    /// The sum acts along both axes: the wind goes to and fro along (1, 0, 1).
    LiteralScalar,
    /// Not the paper's: one force in one direction, which rises within a second.
    Steady,
}

impl Wind {
    /// The wind whose largest force equals `pressure` [Pa] on the mean area of a particle:
    /// `area` [m²] is the whole cloth's, shared by `particle_count` particles.
    #[must_use]
    pub fn from_pressure(pressure: f64, area: f64, particle_count: u32) -> Self {
        Self {
            amplitude: pressure * area / f64::from(particle_count.max(1)),
            law: WindLaw::Spherical,
            heading: 0.0,
        }
    }

    /// Force [N] on each particle at `time` [s]; zero at time zero, never longer than `amplitude`
    /// (twice as long by the literal law).
    #[must_use]
    pub fn force(&self, time: f64) -> DVec3 {
        let phases = paper::wind_phases(time);
        match self.law {
            WindLaw::Spherical => paper::wind_force(self.amplitude, phases),
            WindLaw::LiteralScalar => paper::wind_force_literal(self.amplitude, phases),
            WindLaw::Steady => {
                let risen = (time / RISE).clamp(0.0, 1.0);
                let (sin, cos) = trig64::sin_cos(self.heading);
                DVec3::new(sin, 0.0, cos) * (self.amplitude * risen * risen * (3.0 - 2.0 * risen))
            }
        }
    }
}
