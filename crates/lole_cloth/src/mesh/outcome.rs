//! What became of a step, and the first cause where a piece could not go on.

use glam::Vec3;
use lole_geom::Surfel;

use crate::lanes::{LANES, Points};
use crate::mesh::model::MeshModel;
use crate::{SolverConfig, StepInput};

/// What became of a step. A step cannot fail: where it would leave a particle at no place, the
/// piece stays as it was before.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub enum Outcome {
    /// The piece has moved on.
    Advanced,
    /// The piece is as it was, because of this.
    Held(Cause),
}

/// Why a piece could not move on: the first thing that was no finite number.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Cause {
    /// The duration of the step is no positive number.
    #[error("a step of {dt} s is none; give a positive duration")]
    Duration {
        /// The duration asked for [s].
        dt: f32,
    },
    /// A pin was sent nowhere.
    #[error("pinned particle {particle} was sent to {target}; give it a finite place")]
    PinTarget {
        /// The particle.
        particle: u32,
        /// Where it was sent [m].
        target: Vec3,
    },
    /// A capsule is nowhere or has no radius.
    #[error("capsule {index} has an end or a radius that is no finite number")]
    Capsule {
        /// Position in the list of capsules.
        index: usize,
    },
    /// A surfel is nowhere or faces nowhere.
    #[error("surfel {index} has a position or a normal that is no finite number")]
    Surfel {
        /// Position in the list of surfels.
        index: usize,
    },
    /// A number that holds for all particles.
    #[error("`{field}` is no finite number")]
    Setting {
        /// Its name.
        field: &'static str,
    },
    /// A particle was nowhere already when the step began.
    #[error("particle {particle} began the step at {position} with {velocity} m/s")]
    Start {
        /// The particle.
        particle: u32,
        /// Its position [m].
        position: Vec3,
        /// Its velocity [m/s].
        velocity: Vec3,
    },
    /// A particle went nowhere.
    #[error("particle {particle} went to {position} in substep {substep}, in {phase}")]
    Particle {
        /// The particle.
        particle: u32,
        /// Which substep, from 0.
        substep: u32,
        /// What was being solved.
        phase: Phase,
        /// Where it went [m].
        position: Vec3,
    },
}

/// Part of a substep.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Phase {
    /// Gravity, drag and a straight flight; tethers.
    Flight,
    /// Strides along the yarns.
    Strides,
    /// Bending, and the first sweep over the triangles.
    Bending,
    /// Further sweeps over the triangles.
    Strain,
    /// Contact of the piece with itself.
    Cloth,
    /// Contact with the body, and velocities.
    Contact,
}

impl std::fmt::Display for Phase {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::Flight => "flight",
            Self::Strides => "strides",
            Self::Bending => "bending",
            Self::Strain => "strain",
            Self::Cloth => "contact with itself",
            Self::Contact => "contact",
        })
    }
}

/// What of the input is no finite number.
pub(crate) fn cause_in_input(
    model: &MeshModel,
    config: &SolverConfig,
    input: &StepInput<'_>,
    dt: f32,
) -> Option<Cause> {
    if !(dt.is_finite() && 0.0 < dt) {
        return Some(Cause::Duration { dt });
    }
    let settings = [
        ("air_velocity", input.air_velocity.is_finite()),
        ("gravity", config.gravity.is_finite()),
        ("contact_offset", config.contact_offset.is_finite()),
        (
            "depenetration_speed",
            config.depenetration_speed.is_finite(),
        ),
        (
            "tether_scale",
            config.tether_scale.is_none_or(f32::is_finite),
        ),
    ];
    if let Some(&(field, _)) = settings.iter().find(|(_, is_finite)| !is_finite) {
        return Some(Cause::Setting { field });
    }
    let mut pins = model.pin_indices().iter().zip(input.pin_targets);
    if let Some((&particle, &target)) = pins.find(|(_, target)| !target.is_finite()) {
        return Some(Cause::PinTarget { particle, target });
    }
    let is_finite = |capsule: &lole_geom::Capsule| {
        capsule.ends.iter().all(|end| end.is_finite())
            && capsule.radii.iter().all(|radius| radius.is_finite())
    };
    let mut capsules = input.capsules.iter();
    if let Some(index) = capsules.position(|capsule| !is_finite(capsule)) {
        return Some(Cause::Capsule { index });
    }
    let is_nowhere = |surfel: &Surfel| !(surfel.position.is_finite() && surfel.normal.is_finite());
    let index = input.surfels.iter().position(is_nowhere)?;
    Some(Cause::Surfel { index })
}

/// The first particle with a place that is none, and that place.
pub(crate) fn first_lost(model: &MeshModel, at: impl Fn(usize) -> Vec3) -> Option<(u32, Vec3)> {
    let slots = (0_u32..).zip(&model.slots.of_particle);
    let mut places = slots.map(|(particle, &slot)| (particle, at(slot as usize)));
    places.find(|(_, place)| !place.is_finite())
}

/// Whether all of these are finite numbers.
pub(crate) fn all_finite(points: &[Points]) -> bool {
    // A number that is none, or infinite, times zero is none. Every lane has a sum of its own, so
    // that none waits for another.
    let mut sums = [0.0_f32; LANES];
    for points in points {
        for (lane, sum) in sums.iter_mut().enumerate() {
            let [x, y, z] = [points.x[lane], points.y[lane], points.z[lane]];
            *sum += (x * 0.0 + y * 0.0) + z * 0.0;
        }
    }
    sums.into_iter().all(|sum| sum == 0.0)
}

/// What a slot holds.
pub(crate) fn at(points: &[Points], slot: usize) -> Vec3 {
    points[slot / LANES].get(slot % LANES)
}
