//! Scenes of the engine alone.

use lole_cloth::diagnose::{self, StrainSummary};
use lole_cloth::method::explicit_rows::{self, ExplicitModel};
use lole_cloth::scenes::{FRAME_DT, Scene};
use lole_cloth::{
    BuildError, ClothModel, ClothSpec, ClothState, InstructionSet, SolverConfig, StepInput,
    state_hash, step,
};
use lole_export::report::Worst;

use super::{BenchRow, CROSSINGS_FROM};
use crate::figures::{median_and_p99, percent};
use crate::stopwatch::Stopwatch;

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
    pub(super) fn of(scene: &Scene) -> Vec<Self> {
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
        match self {
            Self::Xpbd(model) => {
                step(model, config, input, state, FRAME_DT);
                config.substep_count.get()
            }
            Self::ExplicitRows(model) => explicit_rows::step(model, config, input, state, FRAME_DT),
        }
    }
}

/// Runs a scene of the engine.
pub(super) fn measure(
    scene: &Scene,
    method: Method,
    set: InstructionSet,
) -> Result<BenchRow, BuildError> {
    let mut setup = (scene.build)();
    setup.config.instruction_set = set;
    let prepared = method.prepare(&setup.spec)?;
    let model = prepared.cloth();
    let mut state = ClothState::new(model, &setup.positions);
    let pins = pins(model, &setup.positions);
    let (mut process, mut wall) = (Vec::new(), Vec::new());
    let (mut positions, mut substeps) = (Vec::new(), Vec::new());
    let mut deepest = 0.0_f32;
    let mut crossings = setup.config.self_collision.is_some().then_some(0);
    let (mut end, mut worst) = (StrainSummary::default(), StrainSummary::default());
    for frame in 0..scene.frame_count {
        let time = f64::from(frame + 1) * f64::from(FRAME_DT);
        let capsules = (scene.capsules)(time);
        let input = StepInput {
            pin_targets: &pins,
            capsules: &capsules,
            ..StepInput::default()
        };
        let watch = Stopwatch::start();
        substeps.push(prepared.step(&setup.config, &input, &mut state));
        let timing = watch.read();
        process.push(1e3 * timing.process_seconds);
        wall.push(1e3 * timing.wall_seconds);
        state.copy_positions(model, &mut positions);
        end = diagnose::strain(&setup.spec, &positions);
        if START_FRAMES <= frame {
            worst.mean = worst.mean.max(end.mean);
            worst.p99 = worst.p99.max(end.p99);
            worst.max = worst.max.max(end.max);
        }
        let depth = diagnose::worst_capsule_penetration(&setup.spec, &positions, &capsules);
        deepest = deepest.max(depth);
        if let Some(most) = &mut crossings
            && CROSSINGS_FROM <= frame
        {
            *most = diagnose::self_crossings(&setup.spec.grid, &positions)
                .map_or(usize::MAX, |count| count.max(*most));
        }
    }
    let frame_ms = median_and_p99(&process);
    let particles = setup.spec.grid.particle_count();
    substeps.sort_unstable();
    let substeps = substeps.get(substeps.len() / 2).copied().unwrap_or(0);
    #[expect(clippy::cast_precision_loss, reason = "counts are far below 2^52")]
    let (count, bytes) = (
        particles as f64,
        (prepared.byte_count() + state.byte_count()) as f64,
    );
    let mut velocities = Vec::new();
    state.copy_velocities(model, &mut velocities);
    Ok(BenchRow {
        scene: scene.name,
        method: method.id(),
        particles,
        substeps,
        threads: rayon::current_num_threads(),
        frame_ms,
        frame_wall_ms: median_and_p99(&wall),
        particle_substep_ns: 1e6 * frame_ms.median / (count * f64::from(substeps)),
        strain_end_pct: percent(end),
        strain_worst_pct: percent(worst),
        penetration_mm: Worst {
            worst: 1e3 * f64::from(deepest),
        },
        skin_penetration_mm: None,
        self_crossings: crossings,
        layer_inversions: None,
        rms_speed_m_per_s: f64::from(diagnose::rms_speed(&velocities)),
        bytes_per_particle: bytes / count,
        state_hash: format!("{:016x}", state_hash(&state)),
    })
}

/// Where the pinned particles are held [m].
fn pins(model: &ClothModel, positions: &[glam::Vec3]) -> Vec<glam::Vec3> {
    let pins = model.pin_indices().iter();
    pins.map(|&index| positions[index as usize]).collect()
}
