//! `lole bench`: what a frame costs on this machine, scene by scene, with the quality it buys.

use lole_cloth::diagnose::{self, StrainSummary};
use lole_cloth::scenes::{FRAME_DT, SCENES, Scene};
use lole_cloth::{ClothModel, ClothState, InstructionSet, StepInput, state_hash, step};
use lole_language::{Language, words};
use serde::Serialize;

use crate::args::{BenchArgs, Vectors};
use crate::figures::median_and_p99;
use crate::stopwatch::Stopwatch;
use crate::{Failure, summary};

/// Frames whose worst strain does not count: the start pose of some scenes is stretched.
const START_FRAMES: u32 = 6;

/// One scene on this machine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct BenchRow {
    pub(crate) scene: &'static str,
    pub(crate) particles: usize,
    pub(crate) substeps: u32,
    /// Processor time of a frame, all threads [ms].
    pub(crate) frame_ms_median: f64,
    pub(crate) frame_ms_p99: f64,
    /// Wall time of a frame [ms].
    pub(crate) frame_wall_ms_median: f64,
    /// Absolute structural strain at the end [%].
    pub(crate) strain_end_pct: StrainPercent,
    /// Its worst from the seventh frame on [%].
    pub(crate) strain_worst_pct: StrainPercent,
    /// Deepest free particle in a capsule over the run [mm].
    pub(crate) capsule_penetration_mm: f64,
    /// Root mean square of the particles' speeds at the end [m/s].
    pub(crate) rms_speed_m_per_s: f64,
    /// All bits of the state at the end.
    pub(crate) state_hash: String,
}

/// A strain's figures [%].
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct StrainPercent {
    pub(crate) mean: f64,
    pub(crate) p99: f64,
    pub(crate) max: f64,
}

impl From<StrainSummary> for StrainPercent {
    fn from(strain: StrainSummary) -> Self {
        let percent = |value: f32| 100.0 * f64::from(value);
        Self {
            mean: percent(strain.mean),
            p99: percent(strain.p99),
            max: percent(strain.max),
        }
    }
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
    }
    let process = median_and_p99(&process);
    let mut velocities = Vec::new();
    state.copy_velocities(&model, &mut velocities);
    Ok(BenchRow {
        scene: scene.name,
        particles: setup.spec.grid.particle_count(),
        substeps: setup.config.substep_count.get(),
        frame_ms_median: process.median,
        frame_ms_p99: process.p99,
        frame_wall_ms_median: median_and_p99(&wall).median,
        strain_end_pct: end.into(),
        strain_worst_pct: worst.into(),
        capsule_penetration_mm: 1e3 * f64::from(deepest),
        rms_speed_m_per_s: f64::from(diagnose::rms_speed(&velocities)),
        state_hash: format!("{:016x}", state_hash(&state)),
    })
}
