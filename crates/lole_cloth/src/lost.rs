//! Why cloth could not move on: what every step of the engine answers where it was not taken.

use glam::Vec3;

/// Why cloth could not move on: the first thing that does not fit or is no finite number. It is as it was before
/// the step.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Lost {
    /// Not every pinned particle was told where it goes.
    #[error(
        "{found} targets for {expected} pinned particles; give one for each, or none where all of them stay"
    )]
    Pins {
        /// Pinned particles.
        expected: usize,
        /// Targets that were given.
        found: usize,
    },
    /// A state of another cloth.
    #[error("the state of piece {piece} is another cloth's; begin one from this model")]
    OtherCloth {
        /// The piece of an assembly; 0 of one that is alone.
        piece: usize,
    },
    /// A particle of a piece of an assembly would be at no place.
    #[error(
        "a particle of piece {piece} went nowhere in substep {substep}; the step was not taken"
    )]
    Piece {
        /// The first piece with such a particle.
        piece: usize,
        /// After which substep, from 0.
        substep: u32,
    },
    /// A particle of a strand would be at no place.
    #[error("particle {particle} of the strands went nowhere; the step was not taken")]
    Strand {
        /// The first of them.
        particle: usize,
    },
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
        /// Name of the setting.
        field: &'static str,
    },
    /// A particle was nowhere already when the step began.
    #[error("particle {particle} began the step at {position} with {velocity} m/s")]
    Start {
        /// The particle.
        particle: u32,
        /// Position of the particle [m].
        position: Vec3,
        /// Velocity of the particle [m/s].
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
        phase: SubstepPart,
        /// Where it went [m].
        position: Vec3,
    },
}

/// Part of a substep.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum SubstepPart {
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

impl std::fmt::Display for SubstepPart {
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

/// Whether a state has as many vectors as its model.
pub(crate) const fn check_cloth(piece: usize, [model, state]: [usize; 2]) -> Result<(), Lost> {
    if model == state {
        Ok(())
    } else {
        Err(Lost::OtherCloth { piece })
    }
}

/// Whether there is a target for every pin, or none at all.
pub(crate) const fn check_pins<T>(expected: usize, targets: &[T]) -> Result<(), Lost> {
    let found = targets.len();
    if found == 0 || found == expected {
        Ok(())
    } else {
        Err(Lost::Pins { expected, found })
    }
}
