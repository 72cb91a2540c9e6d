//! A gathered skirt over swaying capsules for five seconds: `cargo run --release --example skirt -p
//! lole_cloth`.

#![allow(clippy::print_stdout, reason = "an example says what it found")]

use glam::Vec3;
use lole_cloth::scenes::{FRAME_DT, SCENES};
use lole_cloth::{ClothModel, ClothState, StepInput, diagnose, step};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let Some(scene) = SCENES.iter().find(|scene| scene.name == "skirt") else {
        return Ok(());
    };
    let setup = (scene.build)();
    let model = ClothModel::new(&setup.spec)?;
    let mut state = ClothState::new(&model, &setup.positions);
    // The pins of this scene stand still; a dancer's would be carried by her skin.
    let pins = model.pin_indices().iter();
    let pins: Vec<Vec3> = pins.map(|&pin| setup.positions[pin as usize]).collect();
    let mut positions = Vec::new();
    for frame in 1..=scene.frame_count {
        let time = f64::from(frame) * f64::from(FRAME_DT);
        let capsules = (scene.capsules)(time);
        let input = StepInput {
            pin_targets: &pins,
            capsules: &capsules,
            ..StepInput::default()
        };
        step(&model, &setup.config, &input, &mut state, FRAME_DT)?;
        if frame % 60 != 0 {
            continue;
        }
        state.copy_positions(&model, &mut positions);
        let strain = diagnose::strain(&setup.spec, &positions);
        let depth = diagnose::worst_capsule_penetration(&setup.spec, &positions, &capsules);
        println!(
            "{time:.0} s: strain {:.2} % on the mean, {:.1} % at the 99th percentile, {:.3} mm in the body",
            100.0 * strain.mean,
            100.0 * strain.p99,
            1e3 * depth
        );
    }
    Ok(())
}
