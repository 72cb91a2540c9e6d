//! The phases of a step of the real-time method, for whoever wants to know where its time goes.
//!
//! The engine has no clock. [`step_observed`](crate::step_observed) says when a phase has ended,
//! and its caller looks at the clock. It does one phase after the other over the whole cloth,
//! which [`step`](crate::step()) does row by row, staggered; the bits are the same. So a cloth
//! that leaves the nearest cache takes a little longer observed, and a step that nobody observes
//! has neither a call nor a test more in it.

/// What a step does, in the order in which it is first done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Phase {
    /// What the caller did before the step.
    Outside,
    /// Where the cloth may touch capsules and skin.
    FindBody,
    /// Where the cloth may touch itself.
    FindSelf,
    /// Gravity, drag, and a straight flight.
    Predict,
    /// Tethers to the pins.
    Tethers,
    /// Strides: limits over several cells.
    Strides,
    /// Bending along rows and down columns.
    Bend,
    /// Shear and twist of the cells.
    Cells,
    /// Structural springs.
    Springs,
    /// Bending and strain of the triangles of a mesh, star by star.
    Stars,
    /// Seams, elastics and whatever else joins pieces of cloth.
    Joints,
    /// Contact of the cloth with itself.
    SelfContact,
    /// Contact with capsules and skin, friction, and velocities.
    BodyContact,
    /// Crossings of the cloth with itself are found and taken back.
    Crossings,
    /// Strands: what hangs and swings beside the cloth.
    Strands,
}

impl Phase {
    /// Every phase, in the order in which it is first done.
    pub const ALL: [Self; 15] = [
        Self::Outside,
        Self::FindBody,
        Self::FindSelf,
        Self::Predict,
        Self::Tethers,
        Self::Strides,
        Self::Bend,
        Self::Cells,
        Self::Springs,
        Self::Stars,
        Self::Joints,
        Self::SelfContact,
        Self::BodyContact,
        Self::Crossings,
        Self::Strands,
    ];

    /// Name of the phase for programs.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Outside => "outside",
            Self::FindBody => "find-body",
            Self::FindSelf => "find-self",
            Self::Predict => "predict",
            Self::Tethers => "tethers",
            Self::Strides => "strides",
            Self::Bend => "bend",
            Self::Cells => "cells",
            Self::Springs => "springs",
            Self::Stars => "stars",
            Self::Joints => "joints",
            Self::SelfContact => "self-contact",
            Self::BodyContact => "body-contact",
            Self::Crossings => "crossings",
            Self::Strands => "strands",
        }
    }
}

/// Told of every phase that has just ended; nobody, where the step is not observed.
pub(crate) type Observer<'a> = Option<&'a mut dyn FnMut(Phase)>;
