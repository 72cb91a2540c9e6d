//! One face for the engine's methods, so that a performance does not ask which one moves its cloth.

mod velocities;

use std::num::NonZeroU32;

use glam::{DVec3, Vec3};
use lole_cloth::collision::penalty::Penalty;
use lole_cloth::method::explicit::{self, ExplicitConfig, Integrator, Substeps};
use lole_cloth::method::reference::{ReferenceModel, ReferenceState};
use lole_cloth::wind::{self, Aerodynamics, AirPush, GustyWind, Wind, WindLaw};
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Crossings, GridStep, InstructionSet, Lost, Phase,
    SelfCollision, SolverConfig, StepInput, diagnose,
};
use lole_costume::document::{Design, WindModel};
use lole_geom::{Capsule, Surfel, trig64};

use crate::production::Rows;
use crate::{FRAME_SECONDS, StageError};

/// Gap kept between capsules and cloth [m]: half the thickness of a gathered double layer.
pub(crate) const CONTACT_OFFSET: f32 = 0.004;

/// Fastest that cloth inside a capsule is pushed out [m/s]: what two moving capsules pinch between
/// them slips out instead of being shot through the next fold.
const DEPENETRATION_SPEED: f32 = 1.0;

/// Deepest that the elastic rows hold cloth inside a capsule [m]: capsules reach this far beyond
/// the skin that carries the rows, at most.
const HELD_DEPTH: f32 = 0.012;

/// Deepest that they hold it inside the gap kept from the skin itself [m]: there they lie close.
const HELD_DEPTH_ON_SKIN: f32 = 0.006;

/// Parts of a row across which it may not stretch. Where a skirt flies in a whirl its hem is a ring that
/// holds itself together, and around one of hundreds of columns springs from each to the next carry no
/// tension; chords over a sixteenth do, and are 0.6 % shorter than their arcs.
const RING_PARTS: u32 = 16;

/// Substeps of a frame: with two fewer the worst of the strain's 99th percentile rises from 3.3 to
/// 4.4 %.
const SUBSTEP_COUNT: NonZeroU32 = NonZeroU32::MIN.saturating_add(13);

/// The same where rows have no chords, which are worn over others or under them: a row that lies alone
/// between two elastics is compressed. In the first 90 frames of a double pāʻū the worst of the 99th
/// percentiles is 4.0 % with 14, 3.4 % with 16; of 300 frames 7.2 % with 16, 3.8 with 18, and with 20 two
/// particles lose their order.
const LAYERED_SUBSTEP_COUNT: NonZeroU32 = NonZeroU32::MIN.saturating_add(17);

/// Times as many substeps at most where cloth is strained: skirts that are whirled by 8 rad/s need three.
const STRAINED_PARTS: NonZeroU32 = NonZeroU32::MIN.saturating_add(2);

/// A prepared cloth and its moving state, by method.
#[derive(Clone)]
pub(crate) enum Solver {
    /// Real time, `f32`.
    Xpbd(Box<Xpbd>),
    /// The paper's integrators, `f64`.
    Explicit(Box<Explicit>),
}

#[derive(Clone)]
pub(crate) struct Xpbd {
    model: ClothModel,
    state: ClothState,
    config: SolverConfig,
    /// The air's velocity [m/s] as (4) has its force.
    wind: Wind,
    /// The gusts in it, where it acts on triangles; `None` where it acts on particles.
    gusts: Option<GustyWind>,
}

impl Xpbd {
    /// Moves the cloth on by `dt` [s] in the wind of `time` [s].
    fn step(
        &mut self,
        surroundings: &Surroundings<'_>,
        dt: f32,
        observer: Observer<'_>,
    ) -> Result<(), Lost> {
        let time = f64::from(surroundings.time);
        let velocity = self.wind.force(time).as_vec3();
        if let Some(gusts) = &self.gusts {
            let now = gusts.at(time).with_mean(velocity);
            let set = self.config.instruction_set;
            let air = AirPush {
                law: Aerodynamics::default(),
                wind: &now,
                dt,
            };
            wind::blow(&self.model, air, set, &mut self.state);
        }
        if let Some(contact) = &mut self.config.self_collision {
            contact.crossings = surroundings.crossings;
        }
        self.config.held_depth = if surroundings.capsules.is_empty() {
            HELD_DEPTH_ON_SKIN
        } else {
            HELD_DEPTH
        };
        let input = StepInput {
            pin_targets: surroundings.pin_targets,
            capsules: surroundings.capsules,
            surfels: surroundings.surfels,
            air_velocity: if self.gusts.is_some() {
                Vec3::ZERO
            } else {
                velocity
            },
        };
        let (model, config, state) = (&self.model, &self.config, &mut self.state);
        let input = &input;
        let step = GridStep {
            model,
            config,
            input,
            dt,
        };
        match observer {
            None => lole_cloth::step(model, config, input, state, dt),
            Some(passed) => lole_cloth::step_observed(step, state, passed),
        }
    }
}

#[derive(Clone)]
pub(crate) struct Explicit {
    pub(crate) model: ReferenceModel,
    pub(crate) state: ReferenceState,
    pub(crate) config: ExplicitConfig,
}

/// Told of every phase of the real-time method that has just ended.
pub(crate) type Observer<'a> = Option<&'a mut dyn FnMut(Phase)>;

/// Where everything that touches the cloth is at the end of a step.
pub(crate) struct Surroundings<'a> {
    pub(crate) pin_targets: &'a [Vec3],
    pub(crate) capsules: &'a [Capsule],
    pub(crate) surfels: &'a [Surfel],
    pub(crate) crossings: Crossings,
    /// Time at the start of the step [s].
    pub(crate) time: f32,
}

impl Solver {
    /// Prepares the cloth for the design's method, at rest at `start` [m].
    pub(crate) fn new(
        design: &Design,
        (spec, rows): (&ClothSpec, Rows),
        start: &[Vec3],
    ) -> Result<Self, StageError> {
        let usual = match rows {
            Rows::ByChords => SUBSTEP_COUNT,
            Rows::BySprings => LAYERED_SUBSTEP_COUNT,
        };
        let substeps = design.method.substep_count.and_then(NonZeroU32::new);
        let Some(integrator) = design.method.name.integrator() else {
            let gusts = gusts(design);
            let mut spec = spec.clone();
            if gusts.is_some() {
                // What drags at particles alike stands for the air that acts on triangles now.
                spec.fabric.drag_rate = 0.0;
            }
            let model = ClothModel::new(&spec)?;
            let chord = (spec.grid.column_count / RING_PARTS).max(1);
            let chord = (rows == Rows::ByChords).then_some(chord);
            let config = SolverConfig {
                row_strides: chord.into_iter().collect(),
                ..xpbd_config(
                    &spec,
                    substeps.map_or((usual, usual.saturating_mul(STRAINED_PARTS)), |exactly| {
                        (exactly, exactly)
                    }),
                )
            };
            return Ok(Self::Xpbd(Box::new(Xpbd {
                state: ClothState::new(&model, start),
                config,
                gusts,
                wind: design.wind.velocity(),
                model,
            })));
        };
        let model = ReferenceModel::new(spec)?;
        let config = explicit_config(design, spec, &model, integrator);
        Ok(Self::Explicit(Box::new(Explicit {
            state: ReferenceState::at_rest(start.iter().map(|p| p.as_dvec3()).collect()),
            model,
            config,
        })))
    }

    /// Model and settings of the paper's methods; `None` for `xpbd`.
    pub(crate) const fn explicit(&self) -> Option<&Explicit> {
        match self {
            Self::Xpbd(_) => None,
            Self::Explicit(explicit) => Some(explicit),
        }
    }

    /// Like [`Self::explicit`], to change the settings.
    pub(crate) const fn explicit_mut(&mut self) -> Option<&mut Explicit> {
        match self {
            Self::Xpbd(_) => None,
            Self::Explicit(explicit) => Some(explicit),
        }
    }

    /// Moves the cloth on by `dt` [s].
    pub(crate) fn step(
        &mut self,
        surroundings: &Surroundings<'_>,
        dt: f32,
        observer: Observer<'_>,
    ) -> Result<(), Lost> {
        match self {
            Self::Xpbd(xpbd) => xpbd.step(surroundings, dt, observer),
            Self::Explicit(reference) => {
                let pin_targets: Vec<DVec3> = surroundings
                    .pin_targets
                    .iter()
                    .map(|p| p.as_dvec3())
                    .collect();
                let input = explicit::ReferenceInput {
                    time: f64::from(surroundings.time),
                    pin_targets: &pin_targets,
                    capsules: surroundings.capsules,
                };
                let Explicit {
                    model,
                    state,
                    config,
                } = &mut **reference;
                explicit::step(model, config, &input, state, f64::from(dt)).map(|_| ())
            }
        }
    }

    /// Moves cloth of `xpbd`, and where its body was left, by as much [m], and makes it `faster` [m/s].
    pub(crate) fn carry(&mut self, by: Vec3, faster: Vec3) {
        if let Self::Xpbd(xpbd) = self {
            xpbd.state.carry(by, faster);
        }
    }

    /// Multiplies every velocity.
    pub(crate) fn scale_velocities(&mut self, factor: f32) {
        match self {
            Self::Xpbd(xpbd) => xpbd.state.scale_velocities(factor),
            Self::Explicit(reference) => {
                let factor = f64::from(factor);
                reference
                    .state
                    .velocities
                    .iter_mut()
                    .for_each(|velocity| *velocity *= factor);
            }
        }
    }

    /// Positions of the particles [m], row-major.
    pub(crate) fn add_positions(&self, out: &mut Vec<Vec3>) {
        match self {
            Self::Xpbd(xpbd) => xpbd.state.add_positions(&xpbd.model, out),
            Self::Explicit(reference) => {
                out.extend(reference.state.positions.iter().map(|p| p.as_vec3()));
            }
        }
    }

    /// All bits of positions and velocities as one number.
    pub(crate) fn state_hash(&self) -> u64 {
        match self {
            Self::Xpbd(xpbd) => lole_cloth::state_hash(&xpbd.state),
            Self::Explicit(reference) => lole_cloth::reference_state_hash(&reference.state),
        }
    }

    /// Vector instructions of `xpbd`.
    pub(crate) const fn set_instruction_set(&mut self, set: InstructionSet) {
        if let Self::Xpbd(xpbd) = self {
            xpbd.config.instruction_set = set;
        }
    }

    /// Places where cloth of `xpbd` presses on itself.
    pub(crate) const fn pressed_count(&self) -> usize {
        match self {
            Self::Xpbd(xpbd) => xpbd.state.pressed_count(),
            Self::Explicit(_) => 0,
        }
    }

    /// Particles of `xpbd` for which the last step found no place outside of the skin, or no way there.
    pub(crate) fn without_room(&self) -> Vec<u32> {
        match self {
            Self::Xpbd(xpbd) => xpbd.state.without_room(&xpbd.model),
            Self::Explicit(_) => Vec::new(),
        }
    }

    /// Memory of the prepared cloth and its state [byte].
    pub(crate) fn byte_count(&self) -> usize {
        match self {
            Self::Xpbd(xpbd) => xpbd.model.byte_count() + xpbd.state.byte_count(),
            Self::Explicit(explicit) => {
                let state = &explicit.state;
                size_of_val(&state.positions[..])
                    + size_of_val(&state.velocities[..])
                    + size_of_val(explicit.model.masses())
            }
        }
    }

    /// Root mean square of the particles' speeds [m/s].
    pub(crate) fn rms_speed(&self) -> f32 {
        match self {
            Self::Xpbd(xpbd) => {
                let mut velocities = Vec::new();
                xpbd.state.copy_velocities(&xpbd.model, &mut velocities);
                diagnose::rms_speed(&velocities)
            }
            Self::Explicit(explicit) => {
                let velocities = explicit.state.velocities.iter();
                let velocities: Vec<Vec3> = velocities.map(|v| v.as_vec3()).collect();
                diagnose::rms_speed(&velocities)
            }
        }
    }

    /// Acceleration of free fall [m/s²].
    pub(crate) fn gravity(&self) -> Vec3 {
        match self {
            Self::Xpbd(xpbd) => xpbd.config.gravity,
            Self::Explicit(explicit) => explicit.config.gravity.as_vec3(),
        }
    }

    /// Springs of all families.
    pub(crate) fn spring_count(&self) -> usize {
        match self {
            Self::Xpbd(xpbd) => xpbd.model.spring_count(),
            Self::Explicit(reference) => reference.model.spring_count(),
        }
    }

    /// Substeps of the next frame, of the cloth as it lies.
    pub(crate) fn substep_count(&self) -> u32 {
        match self {
            Self::Xpbd(xpbd) => xpbd.state.substep_count(&xpbd.config),
            Self::Explicit(reference) => match reference.config.substeps {
                Substeps::Fixed(count) => count.get(),
                Substeps::Automatic => reference.model.stable_substeps_at(
                    &reference.state.positions,
                    f64::from(FRAME_SECONDS),
                    &reference.config.penalty,
                ),
            },
        }
    }
}

/// The gusts of the design's wind where it acts on triangles: they drift with a steady wind, and to the
/// dancer's left where the wind turns.
pub(crate) fn gusts(design: &Design) -> Option<GustyWind> {
    let wind = &design.wind;
    #[expect(
        clippy::cast_possible_truncation,
        reason = "documents are f64, air is f32"
    )]
    let (speed, intensity) = (wind.speed_m_per_s as f32, wind.gust_ratio as f32);
    let toward = match wind.law {
        WindLaw::Steady => {
            let (sin, cos) = trig64::sin_cos(wind.heading());
            DVec3::new(sin, 0.0, cos).as_vec3()
        }
        WindLaw::Spherical | WindLaw::LiteralScalar => Vec3::X,
    };
    (wind.model == WindModel::Triangles)
        .then(|| GustyWind::new(toward * speed, intensity, wind.seed))
}

/// Settings of the paper's methods for this cloth.
fn explicit_config(
    design: &Design,
    spec: &ClothSpec,
    model: &ReferenceModel,
    integrator: Integrator,
) -> ExplicitConfig {
    let method = &design.method;
    let mut config = ExplicitConfig::for_model(model, f64::from(FRAME_SECONDS));
    if let Some(bounce) = method.bounce_ratio {
        let mass = model.lightest_mass();
        config.penalty =
            Penalty::with_bounce(config.penalty.stiffness, mass, bounce, method.penalty);
    }
    config.penalty.contact_offset = f64::from(CONTACT_OFFSET);
    config.penalty.response = method.penalty;
    config.penalty.shape = method.capsule_shape;
    config.wind = wind_per_particle(design, spec);
    config.integrator = integrator;
    config.contact_evaluation = method.contact_evaluation;
    if let Some(count) = method.substep_count.and_then(NonZeroU32::new) {
        config.substeps = Substeps::Fixed(count);
    }
    config
}

/// The wind of (4) and (5) as a force on every particle, `None` in still air.
fn wind_per_particle(design: &Design, spec: &ClothSpec) -> Option<Wind> {
    let [width, height] = spec.grid.spacing.map(f64::from);
    let cells = f64::from(spec.grid.cell_columns()) * f64::from(spec.grid.row_count - 1);
    let count = spec.grid.column_count * spec.grid.row_count;
    let pressure = design.wind.pressure();
    (0.0 < pressure).then(|| Wind {
        law: design.wind.law,
        heading: design.wind.heading(),
        ..Wind::from_pressure(pressure, width * height * cells, count)
    })
}

/// Settings of the film's skirt.
fn xpbd_config(
    spec: &ClothSpec,
    (substep_count, strained_substep_count): (NonZeroU32, NonZeroU32),
) -> SolverConfig {
    SolverConfig {
        substep_count,
        strained_substep_count,
        gathered_sweep_count: 1,
        contact_offset: CONTACT_OFFSET,
        depenetration_speed: DEPENETRATION_SPEED,
        held_depth: HELD_DEPTH,
        self_collision: Some(SelfCollision {
            // Strands of the gathers lie about a column's width apart: thinner than that, they
            // meet without fighting the band.
            radius: 0.45 * spec.grid.spacing[0],
            substep_interval: NonZeroU32::MIN.saturating_add(1),
            crossings: Crossings::Repair,
        }),
        ..SolverConfig::default()
    }
}
