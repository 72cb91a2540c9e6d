//! One cloth under any of the methods.

use std::num::NonZeroU32;

use glam::{DVec3, Vec3};
use lole_cloth::collision::penalty::Penalty;
use lole_cloth::method::explicit::{self, ExplicitConfig};
use lole_cloth::method::reference::{ReferenceModel, ReferenceState};
use lole_cloth::{BuildError, ClothModel, ClothSpec, ClothState, SolverConfig, StepInput, step};

/// Acceleration of gravity in every protocol [m/s²].
pub(super) const GRAVITY: f64 = 9.81;

/// Duration of a frame [s].
pub(super) const FRAME: f64 = 1.0 / 60.0;

/// A method that is validated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subject {
    /// The reference.
    FbEuler,
    /// The real-time method.
    Xpbd,
}

impl Subject {
    /// All of them, the reference first.
    pub const ALL: [Self; 2] = [Self::FbEuler, Self::Xpbd];

    /// Name in documents and on the command line.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::FbEuler => "fb-euler",
            Self::Xpbd => "xpbd",
        }
    }

    /// The first gate for the reference, the second for the real-time method [%].
    pub(super) const fn gate(self, [reference, real_time]: [f64; 2]) -> f64 {
        match self {
            Self::FbEuler => reference,
            Self::Xpbd => real_time,
        }
    }
}

/// One cloth that moves, its pins held where they are.
pub(super) struct Rig(Kind);

enum Kind {
    Reference(Box<Reference>),
    RealTime(Box<RealTime>),
}

struct Reference {
    model: ReferenceModel,
    state: ReferenceState,
    config: ExplicitConfig,
    pins: Vec<DVec3>,
}

struct RealTime {
    model: ClothModel,
    state: ClothState,
    config: SolverConfig,
    pins: Vec<Vec3>,
}

/// Substeps of the real-time method: more than it dances with, so that what is left is the
/// method's and not the step's.
const SUBSTEPS: NonZeroU32 = NonZeroU32::MIN.saturating_add(39);

impl Rig {
    /// The cloth of `spec` at rest at `start` [m] under gravity.
    pub(super) fn new(
        subject: Subject,
        spec: &ClothSpec,
        start: &[DVec3],
    ) -> Result<Self, BuildError> {
        Ok(Self(match subject {
            Subject::FbEuler => {
                let model = ReferenceModel::new(spec)?;
                let config = ExplicitConfig {
                    gravity: DVec3::NEG_Y * GRAVITY,
                    penalty: Penalty::new(0.0, 0.0),
                    ..ExplicitConfig::for_model(&model, FRAME)
                };
                let pins = model.pin_indices().iter().map(|&pin| start[pin as usize]);
                Kind::Reference(Box::new(Reference {
                    pins: pins.collect(),
                    state: ReferenceState::at_rest(start.to_vec()),
                    model,
                    config,
                }))
            }
            Subject::Xpbd => {
                let model = ClothModel::new(spec)?;
                let single: Vec<Vec3> = start.iter().map(|position| position.as_vec3()).collect();
                let pins = model.pin_indices().iter().map(|&pin| single[pin as usize]);
                Kind::RealTime(Box::new(RealTime {
                    pins: pins.collect(),
                    state: ClothState::new(&model, &single),
                    config: SolverConfig {
                        substep_count: SUBSTEPS,
                        column_strides: Vec::new(),
                        tether_scale: None,
                        ..SolverConfig::default()
                    },
                    model,
                }))
            }
        }))
    }

    /// Moves on by one frame.
    pub(super) fn advance(&mut self) {
        match &mut self.0 {
            Kind::Reference(rig) => {
                let input = explicit::StepInput {
                    time: 0.0,
                    pin_targets: &rig.pins,
                    capsules: &[],
                };
                explicit::step(&rig.model, &rig.config, &input, &mut rig.state, FRAME);
            }
            Kind::RealTime(rig) => {
                let input = StepInput {
                    pin_targets: &rig.pins,
                    capsules: &[],
                    ..StepInput::default()
                };
                #[expect(clippy::cast_possible_truncation, reason = "the engine counts in f32")]
                let dt = FRAME as f32;
                step(&rig.model, &rig.config, &input, &mut rig.state, dt);
            }
        }
    }

    /// Advances so many frames.
    ///
    /// What swings is calmed by the cloth's own drag. Scaling velocities between frames would do
    /// it, too, but moves stiff modes of the explicit method outward: near `ω Δt = 2` position and
    /// velocity only together make its conserved energy.
    pub(super) fn settle(&mut self, frame_count: u32) {
        for _ in 0..frame_count {
            self.advance();
        }
    }

    /// Where the particles are [m], row-major.
    pub(super) fn positions(&self) -> Vec<DVec3> {
        match &self.0 {
            Kind::Reference(rig) => rig.state.positions.clone(),
            Kind::RealTime(rig) => {
                let mut positions = Vec::new();
                rig.state.copy_positions(&rig.model, &mut positions);
                positions
                    .iter()
                    .map(|position| position.as_dvec3())
                    .collect()
            }
        }
    }
}
