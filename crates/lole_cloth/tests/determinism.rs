//! The same scene gives the same bits, whatever runs it.

use lole_cloth::scenes::{FRAME_DT, SCENES, Scene};
use lole_cloth::{ClothModel, ClothState, InstructionSet, StepInput, state_hash, step};

const FRAME_COUNT: u32 = 3;

fn hash_after(scene: &Scene, instruction_set: InstructionSet, thread_count: usize) -> u64 {
    let mut setup = (scene.build)();
    setup.config.instruction_set = instruction_set;
    let model = ClothModel::new(&setup.spec).expect("the scene is valid");
    let pins: Vec<_> = model
        .pin_indices()
        .iter()
        .map(|&pin| setup.positions[pin as usize])
        .collect();
    let mut state = ClothState::new(&model, &setup.positions);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(thread_count)
        .build()
        .expect("threads");
    pool.install(|| {
        for frame in 0..FRAME_COUNT {
            let capsules = (scene.capsules)(f64::from(frame + 1) * f64::from(FRAME_DT));
            let input = StepInput {
                pin_targets: &pins,
                capsules: &capsules,
                ..StepInput::default()
            };
            step(&model, &setup.config, &input, &mut state, FRAME_DT);
        }
    });
    state_hash(&state)
}

#[test]
fn every_scene_has_the_same_bits_on_one_two_and_three_threads() {
    for scene in SCENES.iter().filter(|scene| scene.name != "hang-256") {
        let one = hash_after(scene, InstructionSet::Detected, 1);
        for thread_count in [2, 3] {
            let many = hash_after(scene, InstructionSet::Detected, thread_count);
            assert_eq!(one, many, "{} on {thread_count} threads", scene.name);
        }
    }
}

#[test]
fn every_scene_has_the_same_bits_with_all_vector_instructions() {
    for scene in SCENES.iter().filter(|scene| scene.name != "hang-256") {
        let detected = hash_after(scene, InstructionSet::Detected, 1);
        for instruction_set in [InstructionSet::Wide, InstructionSet::Baseline] {
            let other = hash_after(scene, instruction_set, 1);
            assert_eq!(detected, other, "{} with {instruction_set:?}", scene.name);
        }
    }
}
