//! Scenes of the engine alone.

use lole_cloth::diagnose::{self, StrainSummary};
use lole_cloth::scenes::{FRAME_DT, Scene};
use lole_cloth::{ClothModel, ClothState, InstructionSet, StepInput, state_hash, step};
use lole_export::report::Worst;

use super::{BenchRow, CROSSINGS_FROM};
use crate::figures::{median_and_p99, percent};
use crate::stopwatch::Stopwatch;

/// Frames whose worst strain does not count: the start pose of some scenes is stretched.
const START_FRAMES: u32 = 6;

/// Runs a scene of the engine.
pub(super) fn measure(
    scene: &Scene,
    set: InstructionSet,
) -> Result<BenchRow, lole_cloth::BuildError> {
    let mut setup = (scene.build)();
    setup.config.instruction_set = set;
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
            ..StepInput::default()
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
        skin_penetration_mm: None,
        self_crossings: crossings,
        rms_speed_m_per_s: f64::from(diagnose::rms_speed(&velocities)),
        bytes_per_particle: bytes / count,
        state_hash: format!("{:016x}", state_hash(&state)),
    })
}
