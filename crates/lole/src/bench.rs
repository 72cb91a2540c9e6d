//! `lole bench`: what a frame costs on this machine, scene by scene, with the quality it buys.

use lole_cloth::diagnose::{self, StrainSummary};
use lole_cloth::scenes::{FRAME_DT, SCENES, Scene};
use lole_cloth::{ClothModel, ClothState, InstructionSet, StepInput, state_hash, step};
use lole_export::report::{MeanPercentileMax, MedianPercentile, Worst};
use lole_language::{Language, words};
use serde::Serialize;

use crate::args::{BenchArgs, Vectors};
use crate::figures::{median_and_p99, percent};
use crate::stopwatch::Stopwatch;
use crate::{Failure, summary};

/// Frames whose worst strain does not count: the start pose of some scenes is stretched.
const START_FRAMES: u32 = 6;
/// Frame from which the cloth may not cross itself: some scenes start so tightly folded that it
/// does.
const CROSSINGS_FROM: u32 = 30;

/// One scene on this machine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct BenchRow {
    pub(crate) scene: &'static str,
    pub(crate) method: &'static str,
    pub(crate) particles: usize,
    pub(crate) substeps: u32,
    pub(crate) threads: usize,
    /// Processor time of a frame, all threads [ms].
    pub(crate) frame_ms: MedianPercentile,
    /// Wall time of a frame [ms].
    pub(crate) frame_wall_ms: MedianPercentile,
    /// Processor time for one particle in one substep [ns].
    pub(crate) particle_substep_ns: f64,
    /// Absolute structural strain at the end [%].
    pub(crate) strain_end_pct: MeanPercentileMax,
    /// Its worst from the seventh frame on [%].
    pub(crate) strain_worst_pct: MeanPercentileMax,
    /// Deepest free particle in a capsule over the run.
    pub(crate) penetration_mm: Worst<f64>,
    /// Edges of the cloth that cross one of its triangles, most of any frame from
    /// [`CROSSINGS_FROM`] on; left out where the cloth may pass through itself.
    pub(crate) self_crossings: Option<usize>,
    /// Root mean square of the particles' speeds at the end [m/s].
    pub(crate) rms_speed_m_per_s: f64,
    /// Memory of the prepared cloth and its state.
    pub(crate) bytes_per_particle: f64,
    /// All bits of the state at the end.
    pub(crate) state_hash: String,
}

/// Runs every scene, or the one that was named.
pub(crate) fn run(args: &BenchArgs, language: Language) -> Result<(), Failure> {
    let names: Vec<&str> = SCENES.iter().map(|scene| scene.name).collect();
    let chosen: Vec<&Scene> = match &args.scene {
        Some(name) => vec![
            SCENES
                .iter()
                .find(|scene| scene.name == name)
                .ok_or_else(|| {
                    crate::dance::unknown("--scene", name, words("場面", "scene"), &names)
                })?,
        ],
        None => SCENES.iter().collect(),
    };
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(usize::from(args.threads))
        .build()
        .map_err(Failure::error)?;
    let mut rows = Vec::new();
    if !args.json {
        summary::print_bench_head(language);
    }
    for scene in chosen {
        let row = pool
            .install(|| measure(scene, args.vectors))
            .map_err(Failure::error)?;
        if !args.json {
            summary::print_bench_row(&row);
        }
        rows.push(row);
    }
    if args.json {
        summary::print_json(&serde_json::to_string_pretty(&rows).map_err(Failure::error)?);
    }
    Ok(())
}

fn measure(scene: &Scene, vectors: Vectors) -> Result<BenchRow, lole_cloth::BuildError> {
    let mut setup = (scene.build)();
    setup.config.instruction_set = match vectors {
        Vectors::Detected => InstructionSet::Detected,
        Vectors::Wide => InstructionSet::Wide,
        Vectors::Baseline => InstructionSet::Baseline,
    };
    let model = ClothModel::new(&setup.spec)?;
    let mut state = ClothState::new(&model, &setup.positions);
    let pins: Vec<glam::Vec3> = model
        .pin_indices()
        .iter()
        .map(|&index| setup.positions[index as usize])
        .collect();
    let (mut process, mut wall) = (Vec::new(), Vec::new());
    let mut positions = Vec::new();
    let mut deepest = 0.0_f32;
    let mut crossings = setup.config.self_collision.is_some().then_some(0);
    let (mut end, mut worst) = (StrainSummary::default(), StrainSummary::default());
    for frame in 0..scene.frame_count {
        let time = f64::from(frame + 1) * f64::from(FRAME_DT);
        let capsules = (scene.capsules)(time);
        let input = StepInput {
            pin_targets: &pins,
            capsules: &capsules,
            air_velocity: glam::Vec3::ZERO,
        };
        let watch = Stopwatch::start();
        step(&model, &setup.config, &input, &mut state, FRAME_DT);
        let timing = watch.read();
        process.push(1e3 * timing.process_seconds);
        wall.push(1e3 * timing.wall_seconds);
        state.copy_positions(&model, &mut positions);
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
    let substeps = setup.config.substep_count.get();
    #[expect(clippy::cast_precision_loss, reason = "counts are far below 2^52")]
    let (count, bytes) = (
        particles as f64,
        (model.byte_count() + state.byte_count()) as f64,
    );
    let mut velocities = Vec::new();
    state.copy_velocities(&model, &mut velocities);
    Ok(BenchRow {
        scene: scene.name,
        method: "xpbd",
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
        self_crossings: crossings,
        rms_speed_m_per_s: f64::from(diagnose::rms_speed(&velocities)),
        bytes_per_particle: bytes / count,
        state_hash: format!("{:016x}", state_hash(&state)),
    })
}
