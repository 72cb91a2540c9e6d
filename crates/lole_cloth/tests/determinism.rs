//! The same scene gives the same bits, whatever runs it.
#![allow(clippy::print_stdout, reason = "what is not tested is said")]

use glam::Vec3;
use lole_cloth::method::explicit_rows::{self, ExplicitModel};
use lole_cloth::scenes::{FRAME_DT, SCENES, Scene};
use lole_cloth::{ClothModel, ClothState, InstructionSet, StepInput, state_hash, step};
use lole_cloth::{Phase, SolverConfig, step_observed};

/// Frames of a scene: its cloth has met the body and itself. FB Euler has hundreds of substeps in
/// each.
const FRAME_COUNT: u32 = 6;
const FRAME_COUNT_OF_FB_EULER: u32 = 2;

const THREAD_COUNTS: [usize; 4] = [1, 2, 3, 8];

/// The vector instructions of x86 that have code of their own.
#[cfg(target_arch = "x86_64")]
const NAMES: [&str; 3] = ["AVX-512", "AVX2", "SSE2"];

/// Instruction sets of this host, each once; of the others it is said that they are left out.
fn instruction_sets() -> Vec<InstructionSet> {
    let mut sets: Vec<InstructionSet> = Vec::new();
    for set in InstructionSet::ALL {
        if sets.iter().all(|known| known.name() != set.name()) {
            sets.push(set);
        }
    }
    #[cfg(target_arch = "x86_64")]
    for name in NAMES {
        if sets.iter().all(|set| set.name() != name) {
            println!("{name}: left out, this processor does not have it");
        }
    }
    sets
}

/// Moves a cloth on by a frame.
type Advance<'a> = dyn Fn(&SolverConfig, &StepInput<'_>, &mut ClothState) + Sync + 'a;

/// Hash after some frames of a scene, moved by `advance`.
fn hash_after(
    (scene, frame_count): (&Scene, u32),
    model: &ClothModel,
    set: InstructionSet,
    advance: &Advance<'_>,
) -> u64 {
    let mut setup = (scene.build)();
    setup.config.instruction_set = set;
    let pins = model.pin_indices().iter();
    let pins: Vec<Vec3> = pins.map(|&pin| setup.positions[pin as usize]).collect();
    let mut state = ClothState::new(model, &setup.positions);
    for frame in 0..frame_count {
        let capsules = (scene.capsules)(f64::from(frame + 1) * f64::from(FRAME_DT));
        let input = StepInput {
            pin_targets: &pins,
            capsules: &capsules,
            ..StepInput::default()
        };
        advance(&setup.config, &input, &mut state);
    }
    state_hash(&state)
}

/// One hash for every number of threads and every instruction set of this host.
fn assert_one_hash((scene, frame_count): (&Scene, u32), model: &ClothModel, advance: &Advance<'_>) {
    let mut first = None;
    for thread_count in THREAD_COUNTS {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(thread_count)
            .build()
            .expect("threads");
        for set in instruction_sets() {
            let hash = pool.install(|| hash_after((scene, frame_count), model, set, advance));
            let (name, set) = (scene.name, set.name());
            let expected = *first.get_or_insert(hash);
            assert_eq!(
                hash, expected,
                "{name} on {thread_count} threads with {set}"
            );
        }
    }
}

#[test]
fn every_scene_has_the_same_bits_on_any_threads_and_vector_instructions() {
    for scene in SCENES {
        let model = ClothModel::new(&(scene.build)().spec).expect("the scene is valid");
        assert_one_hash((scene, FRAME_COUNT), &model, &|config, input, state| {
            step(&model, config, input, state, FRAME_DT);
        });
    }
}

#[test]
fn fb_euler_on_vectors_has_the_same_bits_on_any_threads_and_vector_instructions() {
    for scene in SCENES.iter().filter(|scene| scene.name != "hang-256") {
        let model = ExplicitModel::new(&(scene.build)().spec).expect("the scene is valid");
        assert_one_hash(
            (scene, FRAME_COUNT_OF_FB_EULER),
            model.cloth(),
            &|config, input, state| {
                explicit_rows::step(&model, config, input, state, FRAME_DT);
            },
        );
    }
}

#[test]
fn a_step_that_is_observed_has_the_bits_of_one_that_is_not() {
    for scene in SCENES.iter().filter(|scene| scene.name != "hang-256") {
        let meets_itself = (scene.build)().config.self_collision.is_some();
        let model = ClothModel::new(&(scene.build)().spec).expect("the scene is valid");
        let set = InstructionSet::Detected;
        let alone = hash_after(
            (scene, FRAME_COUNT),
            &model,
            set,
            &|config, input, state| {
                step(&model, config, input, state, FRAME_DT);
            },
        );
        let observed = hash_after(
            (scene, FRAME_COUNT),
            &model,
            set,
            &|config, input, state| {
                let mut phases = Vec::new();
                let mut passed = |phase| phases.push(phase);
                step_observed((&model, config), (input, FRAME_DT), state, &mut passed);
                assert_eq!(phases.first(), Some(&Phase::Outside));
                for phase in Phase::ALL {
                    let is_of_self = matches!(phase, Phase::FindSelf | Phase::SelfContact);
                    let is_due = meets_itself || !is_of_self;
                    assert_eq!(phases.contains(&phase), is_due, "{} {phase:?}", scene.name);
                }
            },
        );
        assert_eq!(alone, observed, "{}", scene.name);
    }
}
