//! Prints cost and quality of every scene: `cargo run --release -p lole_cloth --example
//! bench_scenes -- [scene …]`.
//!
//! Milliseconds are process CPU, median over the frames. Penetration, strain and finiteness are
//! measured after every frame, outside the timed part. The start pose has strain of its own, so
//! the worst strain counts from the seventh frame.
#![allow(clippy::print_stdout, reason = "a command-line tool")]

use lole_cloth::diagnose::{self, StrainSummary};
use lole_cloth::scenes::{FRAME_DT, SCENES, Scene};
use lole_cloth::{ClothModel, ClothState, InstructionSet, StepInput, state_hash, step};

/// Frames whose strain still is the start pose's.
const START_FRAMES: u32 = 6;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let names: Vec<String> = std::env::args().skip(1).collect();
    println!(
        "{:14} {:9} {:>8} {:>24} {:>17} {:>6} {:>9}  hash",
        "scene",
        "vectors",
        "cpu ms",
        "end strain mean p99 max %",
        "worst p99 max %",
        "pen mm",
        "rms m/s"
    );
    for scene in SCENES {
        if !names.is_empty() && !names.iter().any(|name| name == scene.name) {
            continue;
        }
        for instruction_set in [
            InstructionSet::Detected,
            InstructionSet::Wide,
            InstructionSet::Baseline,
        ] {
            run(scene, instruction_set)?;
        }
    }
    Ok(())
}

fn run(scene: &Scene, instruction_set: InstructionSet) -> Result<(), Box<dyn std::error::Error>> {
    let mut setup = (scene.build)();
    setup.config.instruction_set = instruction_set;
    let model = ClothModel::new(&setup.spec)?;
    let mut state = ClothState::new(&model, &setup.positions);
    let pins: Vec<_> = model
        .pin_indices()
        .iter()
        .map(|&pin| setup.positions[pin as usize])
        .collect();
    let mut milliseconds = Vec::new();
    let (mut end, mut worst) = (StrainSummary::default(), StrainSummary::default());
    let mut penetration = 0.0_f32;
    let (mut positions, mut velocities) = (Vec::new(), Vec::new());
    // The capsules start where they are at time 0.
    for frame in 0..scene.frame_count {
        let capsules = (scene.capsules)(f64::from(frame + 1) * f64::from(FRAME_DT));
        let input = StepInput {
            pin_targets: &pins,
            capsules: &capsules,
            air_velocity: glam::Vec3::ZERO,
        };
        let before = cpu_milliseconds();
        step(&model, &setup.config, &input, &mut state, FRAME_DT);
        milliseconds.push(cpu_milliseconds() - before);
        state.copy_positions(&model, &mut positions);
        end = diagnose::strain(model.spec(), &positions);
        if START_FRAMES <= frame {
            worst.p99 = worst.p99.max(end.p99);
            worst.max = worst.max.max(end.max);
        }
        penetration = penetration.max(diagnose::worst_capsule_penetration(
            model.spec(),
            &positions,
            &capsules,
        ));
        if let Some(particle) = diagnose::first_non_finite(&positions) {
            println!(
                "{:14} diverged at frame {frame}, particle {particle}",
                scene.name
            );
            return Ok(());
        }
    }
    state.copy_velocities(&model, &mut velocities);
    milliseconds.sort_by(f64::total_cmp);
    println!(
        "{:14} {:9} {:8.3} {:10.3} {:6.2} {:6.2} {:10.2} {:6.2} {:6.2} {:9.3}  {:016x}",
        scene.name,
        format!("{instruction_set:?}"),
        milliseconds[milliseconds.len() / 2],
        100.0 * end.mean,
        100.0 * end.p99,
        100.0 * end.max,
        100.0 * worst.p99,
        100.0 * worst.max,
        1000.0 * penetration,
        diagnose::rms_speed(&velocities),
        state_hash(&state),
    );
    Ok(())
}

/// Process CPU time [ms]; wall time where the platform does not tell.
fn cpu_milliseconds() -> f64 {
    cpu_time::ProcessTime::try_now().map_or(0.0, |now| now.as_duration().as_secs_f64() * 1.0e3)
}
