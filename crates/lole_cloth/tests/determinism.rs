//! The same scene gives the same bits, whatever runs it.
#![allow(clippy::print_stdout, reason = "what is not tested is said")]

use std::fmt::Write as _;
use std::num::NonZeroU32;

use glam::{Vec2, Vec3};
use lole_cloth::assembly::{
    self, Assembly, AssemblyInput, AssemblyState, ClothJoint, ClothPiece, ClothSeam, PieceParticle,
};
use lole_cloth::mesh::{self, MeshModel, MeshSpec, MeshState};
use lole_cloth::method::explicit_rows::{self, ExplicitModel};
use lole_cloth::scenes::{ClothScene, FRAME_DT, SCENES};
use lole_cloth::{
    ClothModel, ClothState, Crossings, Fabric, GridStep, Hysteresis, InstructionSet, Phase,
    SelfCollision, SolverConfig, StepInput, mesh_state_hash, state_hash, step, step_observed,
};
use lole_geom::Capsule;

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
    (scene, frame_count): (&ClothScene, u32),
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

/// One hash for every number of threads and every instruction set of this host; the hash.
fn one_hash(
    (scene, frame_count): (&ClothScene, u32),
    model: &ClothModel,
    advance: &Advance<'_>,
) -> u64 {
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
    first.expect("this host has threads and instructions")
}

/// Hashes that every machine comes to, whatever threads and vector instructions it has, whether optimized or
/// not: by scene of the engine, and of cloth of triangles, pieces that are sewn, and strands.
#[test]
fn golden_hashes_of_every_scene_on_any_threads_and_vector_instructions() {
    let mut text = String::new();
    let mut write = |what: &str, hash: u64| {
        writeln!(text, "{what:16} {hash:016x}").expect("a string takes all");
    };
    for scene in SCENES {
        let model = ClothModel::new(&(scene.build)().spec).expect("the scene is valid");
        let hash = one_hash((scene, FRAME_COUNT), &model, &|config, input, state| {
            step(&model, config, input, state, FRAME_DT).expect("a target for every pin");
        });
        write(scene.name, hash);
    }
    for scene in SCENES.iter().filter(|scene| scene.name != "hang-256") {
        let model = ExplicitModel::new(&(scene.build)().spec).expect("the scene is valid");
        let frames = (scene, FRAME_COUNT_OF_FB_EULER);
        let hash = one_hash(frames, model.cloth(), &|config, input, state| {
            explicit_rows::step(&model, config, input, state, FRAME_DT)
                .expect("a target for every pin");
        });
        write(&format!("{} rows", scene.name), hash);
    }
    let of_sets = |hash_of: &dyn Fn(InstructionSet) -> u64| {
        let hashes: Vec<u64> = instruction_sets().into_iter().map(hash_of).collect();
        assert!(hashes.iter().all(|hash| *hash == hashes[0]), "{hashes:x?}");
        hashes[0]
    };
    write("triangles", of_sets(&dropped_triangles));
    write("sewn", of_sets(&sewn_triangles));
    lole_golden::check("state_hashes.txt", &text);
}

/// A cloth of triangles that has fallen onto a capsule, and folds on itself.
fn dropped_triangles(set: InstructionSet) -> u64 {
    let (model, mut state) = triangles(20, 0.14);
    let config = SolverConfig {
        instruction_set: set,
        self_collision: Some(SelfCollision {
            radius: 0.004,
            substep_interval: NonZeroU32::MIN,
            crossings: Crossings::Repair,
        }),
        ..SolverConfig::default()
    };
    let thigh = [Capsule::uniform(Vec3::NEG_X * 0.15, Vec3::X * 0.15, 0.06)];
    let input = StepInput {
        capsules: &thigh,
        ..StepInput::default()
    };
    for _ in 0..FRAMES_OF_TRIANGLES {
        let moved = mesh::step(&model, &config, &input, &mut state, FRAME_DT);
        assert_eq!(moved, Ok(()));
    }
    mesh_state_hash(&state)
}

/// Two cloths of triangles that a seam has drawn together.
fn sewn_triangles(set: InstructionSet) -> u64 {
    let (model, _) = triangles(12, 0.0);
    let config = || {
        Box::new(SolverConfig {
            instruction_set: set,
            ..SolverConfig::default()
        })
    };
    let pieces = vec![
        ClothPiece::Mesh(Box::new(model.clone()), config()),
        ClothPiece::Mesh(Box::new(model), config()),
    ];
    let line = |piece: usize, first: u32| -> Vec<PieceParticle> {
        let particles = (0..12).map(|along| first + along);
        particles
            .map(|particle| PieceParticle { piece, particle })
            .collect()
    };
    let seam = ClothSeam::along(&pieces, &line(0, 11 * 12), &line(1, 0)).expect("edges as long");
    let joints = [ClothJoint::Seam(seam)];
    let assembly = Assembly::new(pieces, &joints, NonZeroU32::MIN.saturating_add(7)).expect("fits");
    let (_, laid) = triangle_places(12, 0.0);
    let beside = laid.iter().map(|place| *place + Vec3::Z * 0.26).collect();
    let mut state = AssemblyState::new(&assembly, &[laid, beside]);
    let input = AssemblyInput::default();
    for _ in 0..FRAMES_OF_TRIANGLES {
        assembly::step(&assembly, &input, &mut state, FRAME_DT).expect("stays");
    }
    state.hash()
}

/// Frames after which it has met the capsule and itself.
const FRAMES_OF_TRIANGLES: u32 = 24;

/// A square of so many vertices a side, 2 cm apart and at a height [m]: flat, and where it lies.
fn triangle_places(count: u16, height: f32) -> (Vec<Vec2>, Vec<Vec3>) {
    let middle = 0.01 * f32::from(count - 1);
    let flat = (0..count).flat_map(|row| {
        (0..count).map(move |column| Vec2::new(f32::from(column), f32::from(row)) * 0.02)
    });
    let flat: Vec<Vec2> = flat.collect();
    let laid = flat.iter();
    let laid = laid.map(|at| Vec3::new(at.x - middle, height + 0.3 * at.y, at.y - middle));
    let laid = laid.collect();
    (flat, laid)
}

fn triangles(count: u16, height: f32) -> (MeshModel, MeshState) {
    let (flat, laid) = triangle_places(count, height);
    let side = u32::from(count);
    let cells = (0..side - 1).flat_map(|row| (0..side - 1).map(move |column| row * side + column));
    let triangles = cells.flat_map(|a| [[a, a + 1, a + side], [a + 1, a + side + 1, a + side]]);
    let spec = MeshSpec::new(flat, triangles.collect(), COTTON);
    let model = MeshModel::new(&spec).expect("a sheet");
    let state = MeshState::new(&model, &laid);
    (model, state)
}

const COTTON: Fabric = Fabric {
    areal_density: 0.15,
    thickness: 0.4e-3,
    stretch: [1000.0, 1000.0],
    shear: 50.0,
    bend: [5.0e-6, 5.0e-6],
    twist: 5.0e-6,
    hysteresis: Hysteresis::NONE,
    friction: 0.3,
    cloth_friction: 0.3,
    drag_rate: 0.5,
};

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
                step(&model, config, input, state, FRAME_DT).expect("a target for every pin");
            },
        );
        let observed = hash_after(
            (scene, FRAME_COUNT),
            &model,
            set,
            &|config, input, state| {
                let mut phases = Vec::new();
                let mut passed = |phase| phases.push(phase);
                let step = GridStep {
                    model: &model,
                    config,
                    input,
                    dt: FRAME_DT,
                };
                step_observed(step, state, &mut passed).expect("a target for every pin");
                assert_eq!(phases.first(), Some(&Phase::Outside));
                for phase in Phase::ALL {
                    let is_of_self = matches!(phase, Phase::FindSelf | Phase::SelfContact);
                    let is_of_others =
                        matches!(phase, Phase::Stars | Phase::Joints | Phase::Strands);
                    let is_due = !is_of_others && (meets_itself || !is_of_self);
                    assert_eq!(phases.contains(&phase), is_due, "{} {phase:?}", scene.name);
                }
            },
        );
        assert_eq!(alone, observed, "{}", scene.name);
    }
}
