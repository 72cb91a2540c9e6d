//! One cloth under any of the methods.

use std::num::NonZeroU32;

use glam::{DVec3, Vec3};
use lole_cloth::collision::penalty::Penalty;
use lole_cloth::method::explicit::{self, ExplicitConfig};
use lole_cloth::method::reference::{ReferenceModel, ReferenceState};
use lole_cloth::{
    BuildError, ClothModel, ClothSpec, ClothState, SelfCollision, SolverConfig, StepInput, step,
};
use lole_geom::Capsule;

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

/// One cloth that moves, its pins and the capsules where they were put.
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
    capsules: Vec<Capsule>,
    friction: f64,
}

struct RealTime {
    model: ClothModel,
    state: ClothState,
    config: SolverConfig,
    pins: Vec<Vec3>,
    capsules: Vec<Capsule>,
}

/// Substeps of the real-time method: more than it dances with, so that what is left is the
/// method's and not the step's.
const SUBSTEPS: NonZeroU32 = NonZeroU32::MIN.saturating_add(39);

/// Times as stiff as the contact of the reference that the cloth's own substeps would bear: it
/// sinks in that much less.
const CONTACT_STIFFNESS: f64 = 4.0;

impl Rig {
    /// The cloth of `spec` at rest at `start` [m] under gravity.
    pub(super) fn new(
        subject: Subject,
        spec: &ClothSpec,
        start: &[DVec3],
    ) -> Result<Self, BuildError> {
        Ok(Self(match subject {
            Subject::FbEuler => Kind::Reference(Box::new(Reference::new(spec, start)?)),
            Subject::Xpbd => Kind::RealTime(Box::new(RealTime::new(spec, start)?)),
        }))
    }

    /// The same with this acceleration instead of gravity's [m/s²].
    pub(super) fn with_gravity(mut self, gravity: DVec3) -> Self {
        match &mut self.0 {
            Kind::Reference(rig) => rig.config.gravity = gravity,
            Kind::RealTime(rig) => rig.config.gravity = gravity.as_vec3(),
        }
        self
    }

    /// The same moving with these velocities [m/s], row-major.
    pub(super) fn with_velocities(mut self, velocities: &[DVec3]) -> Self {
        match &mut self.0 {
            Kind::Reference(rig) => rig.state.velocities.copy_from_slice(velocities),
            Kind::RealTime(rig) => {
                let single: Vec<Vec3> = velocities.iter().map(|v| v.as_vec3()).collect();
                rig.state.set_velocities(&rig.model, &single);
            }
        }
        self
    }

    /// The same touching these capsules, with the friction of its fabric.
    pub(super) fn with_capsules(mut self, capsules: &[Capsule]) -> Self {
        if let Kind::Reference(rig) = &mut self.0 {
            let soft = ExplicitConfig::for_model(&rig.model, FRAME).penalty;
            rig.config.penalty = Penalty {
                friction: rig.friction,
                // Critical damping grows with the root of the stiffness.
                ..Penalty::new(
                    CONTACT_STIFFNESS * soft.stiffness,
                    CONTACT_STIFFNESS.sqrt() * soft.damping,
                )
            };
        }
        self.set_capsules(capsules);
        self
    }

    /// The same with so many substeps a frame, where the method does not choose them itself.
    pub(super) fn with_substeps(mut self, count: NonZeroU32) -> Self {
        if let Kind::RealTime(rig) = &mut self.0 {
            rig.config.substep_count = count;
            rig.config.strained_substep_count = count;
        }
        self
    }

    /// The same meeting itself, where the method knows how.
    pub(super) fn with_self_collision(mut self, contact: SelfCollision) -> Self {
        if let Kind::RealTime(rig) = &mut self.0 {
            rig.config.self_collision = Some(contact);
        }
        self
    }

    /// Where the capsules are at the end of the next frame.
    pub(super) fn set_capsules(&mut self, capsules: &[Capsule]) {
        match &mut self.0 {
            Kind::Reference(rig) => rig.capsules = capsules.to_vec(),
            Kind::RealTime(rig) => rig.capsules = capsules.to_vec(),
        }
    }

    /// Moves the pins on by `shift(where they are)` [m] during the next frame.
    pub(super) fn move_pins(&mut self, shift: impl Fn(DVec3) -> DVec3) {
        match &mut self.0 {
            Kind::Reference(rig) => {
                for pin in &mut rig.pins {
                    *pin += shift(*pin);
                }
            }
            Kind::RealTime(rig) => {
                for pin in &mut rig.pins {
                    let place = pin.as_dvec3();
                    *pin = (place + shift(place)).as_vec3();
                }
            }
        }
    }

    /// Moves on by one frame.
    pub(super) fn advance(&mut self) {
        let moved = match &mut self.0 {
            Kind::Reference(rig) => {
                let input = explicit::ReferenceInput {
                    time: 0.0,
                    pin_targets: &rig.pins,
                    capsules: &rig.capsules,
                };
                explicit::step(&rig.model, &rig.config, &input, &mut rig.state, FRAME).map(|_| ())
            }
            Kind::RealTime(rig) => {
                let input = StepInput {
                    pin_targets: &rig.pins,
                    capsules: &rig.capsules,
                    ..StepInput::default()
                };
                #[expect(clippy::cast_possible_truncation, reason = "the engine counts in f32")]
                let dt = FRAME as f32;
                step(&rig.model, &rig.config, &input, &mut rig.state, dt)
            }
        };
        debug_assert!(moved.is_ok(), "a target for every pin");
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
                positions.iter().map(|p| p.as_dvec3()).collect()
            }
        }
    }

    /// How the particles move [m/s], row-major.
    pub(super) fn velocities(&self) -> Vec<DVec3> {
        match &self.0 {
            Kind::Reference(rig) => rig.state.velocities.clone(),
            Kind::RealTime(rig) => {
                let mut velocities = Vec::new();
                rig.state.copy_velocities(&rig.model, &mut velocities);
                velocities.iter().map(|v| v.as_dvec3()).collect()
            }
        }
    }
}

impl Reference {
    fn new(spec: &ClothSpec, start: &[DVec3]) -> Result<Self, BuildError> {
        let model = ReferenceModel::new(spec)?;
        let config = ExplicitConfig {
            gravity: DVec3::NEG_Y * GRAVITY,
            penalty: Penalty::new(0.0, 0.0),
            ..ExplicitConfig::for_model(&model, FRAME)
        };
        let pins = model.pin_indices().iter().map(|&pin| start[pin as usize]);
        Ok(Self {
            pins: pins.collect(),
            capsules: Vec::new(),
            state: ReferenceState::at_rest(start.to_vec()),
            friction: f64::from(spec.fabric.friction),
            model,
            config,
        })
    }
}

impl RealTime {
    fn new(spec: &ClothSpec, start: &[DVec3]) -> Result<Self, BuildError> {
        let model = ClothModel::new(spec)?;
        let single: Vec<Vec3> = start.iter().map(|position| position.as_vec3()).collect();
        let pins = model.pin_indices().iter().map(|&pin| single[pin as usize]);
        Ok(Self {
            pins: pins.collect(),
            capsules: Vec::new(),
            state: ClothState::new(&model, &single),
            config: SolverConfig {
                substep_count: SUBSTEPS,
                column_strides: Vec::new(),
                tether_scale: None,
                ..SolverConfig::default()
            },
            model,
        })
    }
}

/// Mean of points or vectors.
pub(super) fn mean(vectors: &[DVec3]) -> DVec3 {
    vectors.iter().sum::<DVec3>() / vectors.len().max(1) as f64
}
