//! Scenes of the engine alone.

use lole_cloth::diagnose::{self, StrainSummary};
use lole_cloth::method::explicit_rows::{self, ExplicitModel};
use lole_cloth::scenes::{ClothScene, FRAME_DT, Setup};
use lole_cloth::{
    BuildError, ClothModel, ClothSpec, ClothState, GridStep, Phase, SolverConfig, StepInput,
    state_hash, step, step_observed,
};

use super::BenchSettings;
use super::phases::PhaseClock;
use super::roofline::SpringRoofline;
use super::row::{BenchRow, Crossings, Run};
use crate::{Clock, Timing};

/// Frames whose worst strain does not count: the start pose of some scenes is stretched.
const START_FRAMES: u32 = 6;

/// A method of the engine that the scenes are run by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Method {
    /// The real-time method.
    Xpbd,
    /// FB Euler on vectors.
    ExplicitRows,
}

/// A cloth prepared for its method.
enum Prepared {
    Xpbd(ClothModel),
    ExplicitRows(ExplicitModel),
}

impl Method {
    /// Every one that can run a scene: FB Euler knows no contact of the cloth with itself.
    pub(super) fn of(scene: &ClothScene) -> Vec<Self> {
        let meets_itself = (scene.build)().config.self_collision.is_some();
        let methods = [Self::Xpbd, Self::ExplicitRows].into_iter();
        methods
            .filter(|&method| !meets_itself || method == Self::Xpbd)
            .collect()
    }

    /// The name in the table.
    pub(super) const fn id(self) -> &'static str {
        match self {
            Self::Xpbd => "xpbd",
            Self::ExplicitRows => "explicit-rows",
        }
    }

    fn prepare(self, spec: &ClothSpec) -> Result<Prepared, BuildError> {
        Ok(match self {
            Self::Xpbd => Prepared::Xpbd(ClothModel::new(spec)?),
            Self::ExplicitRows => Prepared::ExplicitRows(ExplicitModel::new(spec)?),
        })
    }
}

impl Prepared {
    const fn cloth(&self) -> &ClothModel {
        match self {
            Self::Xpbd(model) => model,
            Self::ExplicitRows(model) => model.cloth(),
        }
    }

    fn byte_count(&self) -> usize {
        match self {
            Self::Xpbd(model) => model.byte_count(),
            Self::ExplicitRows(model) => model.byte_count(),
        }
    }

    /// Moves the cloth on by a frame; the number of substeps it took.
    fn step(&self, config: &SolverConfig, input: &StepInput<'_>, state: &mut ClothState) -> u32 {
        let taken = match self {
            Self::Xpbd(model) => {
                step(model, config, input, state, FRAME_DT).map(|()| config.substep_count.get())
            }
            Self::ExplicitRows(model) => explicit_rows::step(model, config, input, state, FRAME_DT),
        };
        taken.expect("a target for every pin")
    }
}

/// A scene while it runs.
struct Running<'a> {
    scene: &'a ClothScene,
    setup: &'a Setup,
    prepared: Prepared,
    state: ClothState,
    pins: Vec<glam::Vec3>,
    clock: PhaseClock<'a>,
}

/// What the frames of a scene show.
struct Seen {
    is_finite: bool,
    strain_end: StrainSummary,
    strain_worst: StrainSummary,
    /// [m]
    penetration: f32,
    crossings: Option<Crossings>,
}

impl<'a> Running<'a> {
    fn start(
        (scene, method): (&'a ClothScene, Method),
        setup: &'a Setup,
        clock: &'a dyn Clock,
    ) -> Result<Self, BuildError> {
        let prepared = method.prepare(&setup.spec)?;
        Ok(Self {
            scene,
            setup,
            state: ClothState::new(prepared.cloth(), &setup.positions),
            pins: pins(prepared.cloth(), &setup.positions),
            prepared,
            clock: PhaseClock::new(clock),
        })
    }

    /// Runs the scene and looks at every frame.
    fn seen(&mut self) -> Seen {
        let spec = &self.setup.spec;
        let contact = self.setup.config.self_collision;
        let mut seen = Seen {
            is_finite: true,
            strain_end: StrainSummary::default(),
            strain_worst: StrainSummary::default(),
            penetration: 0.0,
            crossings: contact.is_some().then_some(Crossings::none()),
        };
        let mut positions = Vec::new();
        for frame in 0..self.scene.frame_count {
            self.advance(frame, &mut Vec::new());
            (self.state).copy_positions(self.prepared.cloth(), &mut positions);
            let strain = diagnose::strain(spec, &positions);
            if START_FRAMES <= frame {
                let worst = &mut seen.strain_worst;
                worst.mean = worst.mean.max(strain.mean);
                worst.p99 = worst.p99.max(strain.p99);
                worst.max = worst.max.max(strain.max);
            }
            seen.strain_end = strain;
            let capsules = self.capsules(frame);
            let depth = diagnose::worst_capsule_penetration(spec, &positions, &capsules);
            seen.penetration = seen.penetration.max(depth);
            if let Some(crossings) = &mut seen.crossings {
                crossings.see(frame, || diagnose::self_crossings(&spec.grid, &positions));
            }
        }
        seen.is_finite = diagnose::first_non_finite(&positions).is_none();
        seen
    }

    /// The next frame, timed unless it is observed; the number of its substeps.
    fn advance(&mut self, frame: u32, timings: &mut Vec<Timing>) -> u32 {
        let capsules = self.capsules(frame);
        let (config, state) = (&self.setup.config, &mut self.state);
        let input = StepInput {
            pin_targets: &self.pins,
            capsules: &capsules,
            ..StepInput::default()
        };
        if let Prepared::Xpbd(model) = &self.prepared
            && PhaseClock::observes(frame)
        {
            let clock = &mut self.clock;
            clock.begin_frame();
            let mut passed = |phase| clock.passed(phase);
            let step = GridStep {
                model,
                config,
                input: &input,
                dt: FRAME_DT,
            };
            step_observed(step, state, &mut passed).expect("a target for every pin");
            return config.substep_count.get();
        }
        let watch = self.clock.stopwatch();
        let substeps = self.prepared.step(config, &input, state);
        timings.push(watch.read());
        substeps
    }

    /// Where the capsules are at the end of a frame.
    fn capsules(&self, frame: u32) -> Vec<lole_geom::Capsule> {
        (self.scene.capsules)(f64::from(frame + 1) * f64::from(FRAME_DT))
    }
}

/// Runs a scene of the engine from a start of the caller's, twice with the same bits: once for its
/// times, with nothing between the frames that would empty the caches, and once for what the cloth
/// does in every frame.
pub(super) fn measure(
    (scene, method): (&ClothScene, Method),
    mut setup: Setup,
    settings: BenchSettings<'_>,
) -> Result<BenchRow, BuildError> {
    setup.config.instruction_set = settings.instruction_set;
    let mut timed = Running::start((scene, method), &setup, settings.clock)?;
    let mut timings = Vec::new();
    let mut substeps: Vec<u32> = (0..scene.frame_count)
        .map(|frame| timed.advance(frame, &mut timings))
        .collect();
    substeps.sort_unstable();

    let mut judged = Running::start((scene, method), &setup, settings.clock)?;
    let seen = judged.seen();
    let state_hash = state_hash(&judged.state);
    debug_assert_eq!(state_hash, self::state_hash(&timed.state), "{}", scene.name);
    let mut velocities = Vec::new();
    (judged.state).copy_velocities(judged.prepared.cloth(), &mut velocities);
    let springs = timed.clock.median(Phase::Springs);
    let row = Run {
        scene: scene.name,
        method: method.id(),
        particles: setup.spec.grid.particle_count(),
        substeps: substeps.get(substeps.len() / 2).copied().unwrap_or(0),
        timings,
        phases: timed.clock.times(),
        spring_roofline: (settings.roofline && 0.0 < springs).then(|| {
            let cloth = (&setup.spec, &setup.config);
            SpringRoofline::measure(cloth, springs, settings)
        }),
        finite: seen.is_finite,
        strain_end: seen.strain_end,
        strain_worst: seen.strain_worst,
        penetration: seen.penetration,
        skin_penetration: None,
        crossings: seen.crossings,
        layer_inversions: None,
        rms_speed: Some(diagnose::rms_speed(&velocities)),
        byte_count: Some(timed.prepared.byte_count() + timed.state.byte_count()),
        state_hash,
    };
    Ok(row.row())
}

/// Where the pinned particles are held [m].
pub(crate) fn pins(model: &ClothModel, positions: &[glam::Vec3]) -> Vec<glam::Vec3> {
    let pins = model.pin_indices().iter();
    pins.map(|&index| positions[index as usize]).collect()
}
