//! `lole bench`: what a frame costs on this machine, scene by scene, with the quality it buys.

use lole_cloth::diagnose;
use lole_cloth::scenes::{FRAME_DT, SCENES, Scene};
use lole_cloth::{ClothModel, ClothState, StepInput, step};
use serde::Serialize;

use crate::args::BenchArgs;
use crate::figures::median_and_p99;
use crate::language::Language;
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
    /// Absolute structural strain at the end, 99th percentile [%].
    pub(crate) strain_end_p99_pct: f64,
    /// Its worst from the sixth frame on [%].
    pub(crate) strain_worst_p99_pct: f64,
    /// Deepest free particle in a capsule over the run [mm].
    pub(crate) capsule_penetration_mm: f64,
}

/// Runs every scene, or the one that was named.
pub(crate) fn run(args: &BenchArgs, language: Language) -> Result<(), Failure> {
    let names: Vec<&str> = SCENES.iter().map(|scene| scene.name).collect();
    let chosen: Vec<&Scene> = match &args.scene {
        Some(name) => vec![
            SCENES
                .iter()
                .find(|scene| scene.name == name)
                .ok_or_else(|| crate::dance::unknown("--scene", name, "scene", &names))?,
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
        let row = pool.install(|| measure(scene)).map_err(Failure::error)?;
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

fn measure(scene: &Scene) -> Result<BenchRow, lole_cloth::BuildError> {
    let setup = (scene.build)();
    let model = ClothModel::new(&setup.spec)?;
    let mut state = ClothState::new(&model, &setup.positions);
    let pins: Vec<glam::Vec3> = model
        .pin_indices()
        .iter()
        .map(|&index| setup.positions[index as usize])
        .collect();
    let (mut process, mut wall) = (Vec::new(), Vec::new());
    let mut positions = Vec::new();
    let (mut worst_strain, mut deepest) = (0.0_f32, 0.0_f32);
    let mut end_strain = 0.0;
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
        end_strain = diagnose::strain(&setup.spec, &positions).p99;
        if START_FRAMES <= frame {
            worst_strain = worst_strain.max(end_strain);
        }
        let depth = diagnose::worst_capsule_penetration(&setup.spec, &positions, &capsules);
        deepest = deepest.max(depth);
    }
    let process = median_and_p99(&process);
    Ok(BenchRow {
        scene: scene.name,
        particles: setup.spec.grid.particle_count(),
        substeps: setup.config.substep_count.get(),
        frame_ms_median: process.median,
        frame_ms_p99: process.p99,
        frame_wall_ms_median: median_and_p99(&wall).median,
        strain_end_p99_pct: 100.0 * f64::from(end_strain),
        strain_worst_p99_pct: 100.0 * f64::from(worst_strain),
        capsule_penetration_mm: 1e3 * f64::from(deepest),
    })
}
