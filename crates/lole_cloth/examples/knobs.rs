//! What every setting of the real-time method costs, and what it changes: each is turned alone on the skirt that
//! does not pass through itself. `cargo run --release --example knobs -p lole_cloth`.

#![allow(clippy::print_stdout, reason = "an example says what it found")]

use std::error::Error;
use std::num::NonZeroU32;

use cpu_time::ProcessTime;
use glam::Vec3;
use lole_cloth::scenes::{ClothScene, FRAME_DT, SCENES};
use lole_cloth::{
    ClothModel, ClothState, Crossings, InstructionSet, SelfCollision, SolverConfig, StepInput,
    diagnose, step,
};

/// A setting turned from where the scene has it.
type Knob = (&'static str, fn(&mut SolverConfig));

const KNOBS: &[Knob] = &[
    ("as the scene has it", |_| {}),
    ("half the substeps", |config| {
        config.substep_count = times(config.substep_count, 1, 2);
    }),
    ("twice the substeps", |config| {
        config.substep_count = times(config.substep_count, 2, 1);
    }),
    ("three times the substeps where it is strained", |config| {
        config.strained_substep_count = times(config.substep_count, 3, 1);
    }),
    ("half the sweeps over the springs", |config| {
        config.structural_sweep_count = times(config.structural_sweep_count, 1, 2);
    }),
    ("twice the sweeps over the springs", |config| {
        config.structural_sweep_count = times(config.structural_sweep_count, 2, 1);
    }),
    ("two more sweeps where it is gathered", |config| {
        config.gathered_sweep_count += 2;
    }),
    ("no tethers", |config| config.tether_scale = None),
    ("no strides down the columns", |config| {
        config.column_strides.clear();
    }),
    ("a stride of 4 along the rows", |config| {
        config.row_strides = vec![4];
    }),
    ("crossings are left", |config| {
        change(config, |it| it.crossings = Crossings::Leave);
    }),
    ("folds meet in every substep", |config| {
        change(config, |it| it.substep_interval = NonZeroU32::MIN);
    }),
    ("folds pass through each other", |config| {
        config.self_collision = None;
    }),
    ("AVX2 at most", |config| {
        config.instruction_set = InstructionSet::Wide;
    }),
    ("what every processor has", |config| {
        config.instruction_set = InstructionSet::Baseline;
    }),
];

/// Runs of each setting, in turn; the median counts.
const ROUNDS: usize = 3;
/// Frames whose strain does not count: the start of the scene is stretched.
const START_FRAMES: u32 = 6;

/// What a run came to.
#[derive(Clone, Copy)]
struct Outcome {
    /// CPU time of a step [ms].
    step_ms: f64,
    /// Worst strain of the 99th percentile of the springs [%].
    strain_pct: f32,
    /// Edges through triangles at the end.
    crossings: usize,
}

fn main() -> Result<(), Box<dyn Error>> {
    let scene = SCENES.iter().find(|scene| scene.name == "skirt-self");
    let scene = scene.ok_or("there is no such scene")?;
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let mut outcomes = vec![Vec::new(); KNOBS.len()];
    for _ in 0..ROUNDS {
        for ((_, turn), outcomes) in KNOBS.iter().zip(&mut outcomes) {
            let outcome = alone.install(|| run(scene, *turn).map_err(|error| error.to_string()));
            outcomes.push(outcome?);
        }
    }
    let medians = outcomes.iter_mut().map(|runs| {
        runs.sort_by(|one, other| one.step_ms.total_cmp(&other.step_ms));
        runs[ROUNDS / 2]
    });
    let medians: Vec<Outcome> = medians.collect();
    println!("| Setting | CPU of a step | | strain p99, worst | crossings at the end |");
    println!("|---|---|---|---|---|");
    for ((name, _), outcome) in KNOBS.iter().zip(&medians) {
        println!(
            "| {name} | {:.2} ms | {:.2} x | {:.1} % | {} |",
            outcome.step_ms,
            outcome.step_ms / medians[0].step_ms,
            outcome.strain_pct,
            outcome.crossings
        );
    }
    Ok(())
}

fn run(scene: &ClothScene, turn: fn(&mut SolverConfig)) -> Result<Outcome, Box<dyn Error>> {
    let mut setup = (scene.build)();
    turn(&mut setup.config);
    let model = ClothModel::new(&setup.spec)?;
    let mut state = ClothState::new(&model, &setup.positions);
    let pins = model.pin_indices().iter();
    let pins: Vec<Vec3> = pins.map(|&pin| setup.positions[pin as usize]).collect();
    let (mut milliseconds, mut worst) = (0.0, 0.0_f32);
    for frame in 1..=scene.frame_count {
        let capsules = (scene.capsules)(f64::from(frame) * f64::from(FRAME_DT));
        let input = StepInput {
            pin_targets: &pins,
            capsules: &capsules,
            ..StepInput::default()
        };
        let began = ProcessTime::now();
        step(&model, &setup.config, &input, &mut state, FRAME_DT)?;
        milliseconds += began.elapsed().as_secs_f64() * 1e3;
        if START_FRAMES < frame {
            let positions = state.positions(&model);
            worst = worst.max(diagnose::strain(&setup.spec, &positions).p99);
        }
    }
    let crossings = diagnose::self_crossings(&setup.spec.grid, &state.positions(&model));
    Ok(Outcome {
        step_ms: milliseconds / f64::from(scene.frame_count),
        strain_pct: 100.0 * worst,
        crossings: crossings.unwrap_or(0),
    })
}

/// A share of a count, at least one.
fn times(count: NonZeroU32, by: u32, over: u32) -> NonZeroU32 {
    NonZeroU32::new(count.get() * by / over).unwrap_or(NonZeroU32::MIN)
}

fn change(config: &mut SolverConfig, how: fn(&mut SelfCollision)) {
    config.self_collision.iter_mut().for_each(how);
}
