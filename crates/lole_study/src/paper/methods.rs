//! The methods of the study and what theory and paper say of them.

use lole_cloth::method::explicit::Integrator;
use lole_costume::document::MethodName;

/// A method of the paper.
pub(crate) struct Method {
    pub(crate) name: MethodName,
    /// Order of accuracy, without and with damping.
    pub(crate) order: [u32; 2],
    /// The stable step in theory, for little damping.
    pub(crate) formula: &'static str,
    /// What the paper says of it.
    pub(crate) paper: &'static str,
}

/// All of them, the paper's three first.
pub(crate) const METHODS: [Method; 5] = [
    Method {
        name: MethodName::Euler,
        order: [1, 1],
        formula: "ω Δt < c / ω",
        paper: "the skirt flying away from the body, but the movement of the human model did not slow down",
    },
    Method {
        name: MethodName::FbEuler,
        order: [1, 1],
        formula: "ω Δt < (sqrt(c² + 4 ω²) - c) / ω",
        paper: "stable, but the movement of the human model slowed down due to the large number of calculation processes",
    },
    Method {
        name: MethodName::RkAsPrinted,
        order: [1, 1],
        formula: "ω Δt < 6 c / ω",
        paper: "the skirt penetrated the legs and the movement of the human model was the slowest among the three calculation methods",
    },
    Method {
        name: MethodName::Rk4,
        order: [4, 4],
        formula: "ω Δt < sqrt(8)",
        paper: "",
    },
    Method {
        name: MethodName::RkDoubleCounted,
        order: [1, 1],
        formula: "ω Δt < 11 c / ω",
        paper: "",
    },
];

impl Method {
    /// How it moves the particles.
    pub(crate) fn integrator(&self) -> Integrator {
        self.name.integrator().unwrap_or_default()
    }
}
