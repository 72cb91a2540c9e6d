//! FB Euler on vectors is the reference's FB Euler, but for the last bits of `f32`.

mod reference_support;

use std::num::NonZeroU32;

use glam::{DVec3, Vec3};
use lole_cloth::collision::penalty::Penalty;
use lole_cloth::method::explicit::{self, ExplicitConfig, Substeps};
use lole_cloth::method::explicit_rows::{self, ExplicitModel};
use lole_cloth::method::reference::{ReferenceModel, ReferenceState};
use lole_cloth::scenes::{ClothScene, FRAME_DT, SCENES};
use lole_cloth::{
    ClothSpec, ClothState, Fabric, InstructionSet, MassLaw, SolverConfig, StepInput, Topology,
    diagnose, state_hash,
};
use lole_geom::{Capsule, trig};
use reference_support::{Lcg, held_pins, spec};

const FABRIC: Fabric = Fabric {
    areal_density: 0.15,
    thickness: 0.4e-3,
    stretch: [900.0, 700.0],
    shear: 60.0,
    bend: [4.0e-5, 3.0e-5],
    twist: 2.0e-5,
    hysteresis: lole_cloth::Hysteresis::NONE,
    friction: 0.3,
    cloth_friction: 0.3,
    drag_rate: 1.0,
};

/// A cloth of the fabric with its top row pinned.
fn hanging(columns: u32, rows: u32, topology: Topology, spacing: [f32; 2]) -> ClothSpec {
    let mut spec = spec(columns, rows, topology, spacing);
    spec.mass = MassLaw::AreaWeighted;
    spec.fabric = FABRIC;
    spec.pinned[..columns as usize].fill(true);
    spec
}

/// The cloth at rest, every particle moved by up to `noise` [m].
fn start(spec: &ClothSpec, noise: f64) -> Vec<Vec3> {
    let mut dice = Lcg(7);
    let rest = reference_support::rest_positions(&spec.grid);
    (rest.iter())
        .map(|&position| (position + dice.vector() * noise).as_vec3())
        .collect()
}

/// Positions by both methods after so many frames, each step cut alike.
fn both(spec: &ClothSpec, start: &[Vec3], frame_count: u32) -> [Vec<DVec3>; 2] {
    let config = SolverConfig::default();
    let rows = ExplicitModel::new(spec).expect("the cloth is valid");
    let reference = ReferenceModel::new(spec).expect("the cloth is valid");
    let mut truth = ExplicitConfig {
        penalty: Penalty::new(0.0, 0.0),
        ..ExplicitConfig::for_model(&reference, f64::from(FRAME_DT))
    };
    let mut exact = ReferenceState::at_rest(start.iter().map(|p| p.as_dvec3()).collect());
    let targets = held_pins(&reference, &exact);
    let pins: Vec<Vec3> = targets.iter().map(|p| p.as_vec3()).collect();
    let mut state = ClothState::new(rows.cloth(), start);
    for _ in 0..frame_count {
        let input = StepInput {
            pin_targets: &pins,
            capsules: &[],
            ..StepInput::default()
        };
        let count = explicit_rows::step(&rows, &config, &input, &mut state, FRAME_DT);
        let count = count.expect("a target for every pin");
        truth.substeps = Substeps::Fixed(NonZeroU32::new(count).expect("at least one"));
        let input = explicit::ReferenceInput {
            time: 0.0,
            pin_targets: &targets,
            capsules: &[],
        };
        explicit::step(&reference, &truth, &input, &mut exact, f64::from(FRAME_DT))
            .expect("a target for every pin");
    }
    let mut positions = Vec::new();
    state.copy_positions(rows.cloth(), &mut positions);
    [
        exact.positions,
        positions.iter().map(|p| p.as_dvec3()).collect(),
    ]
}

fn farthest(left: &[DVec3], right: &[DVec3]) -> f64 {
    (left.iter().zip(right))
        .map(|(a, b)| a.distance(*b))
        .fold(0.0, f64::max)
}

#[test]
fn every_width_and_topology_feels_the_reference_s_forces() {
    for topology in [Topology::Sheet, Topology::Tube] {
        for columns in [3, 7, 16, 17, 33, 50, 64] {
            let mut spec = hanging(columns, 6, topology, [0.02, 0.013]);
            // A clamp, a heavy row and a lone pin.
            spec.pinned[columns as usize..2 * columns as usize].fill(true);
            spec.row_layers[4] = 2.0;
            spec.pinned[5 * columns as usize + 1] = true;
            let start = start(&spec, 2e-4);
            let [truth, found] = both(&spec, &start, 2);
            let apart = farthest(&truth, &found);
            assert!(apart < 5e-6, "{topology:?} of {columns}: {apart} m");
            let moved = farthest(
                &truth,
                &start.iter().map(|p| p.as_dvec3()).collect::<Vec<_>>(),
            );
            assert!(1e-4 < moved, "{topology:?} of {columns} does not move");
        }
    }
}

/// The sheet of 64 by 64 particles, lifted a little to one side and let go: half a second of swing,
/// and no more than a hair between the methods.
#[test]
fn a_hanging_sheet_swings_as_the_reference_does() {
    let spacing = 1.0 / 63.0;
    let spec = hanging(64, 64, Topology::Sheet, [spacing; 2]);
    let start: Vec<Vec3> = (reference_support::rest_positions(&spec.grid).iter())
        .map(|p| DVec3::new(p.x, 0.97 * p.y, -0.243 * p.y).as_vec3())
        .collect();
    let [truth, found] = both(&spec, &start, 30);
    let apart = farthest(&truth, &found);
    assert!(apart < 2e-5, "{apart} m");
    let moved = truth[64 * 64 - 1].distance(start[64 * 64 - 1].as_dvec3());
    assert!(0.2 < moved, "it swings by {moved} m");
}

/// A square of 0.3 m, its columns along a direction, that falls on `capsules` for a second.
fn fallen(friction: f32, along: Vec3, capsules: &[Capsule]) -> (ClothSpec, Vec<Vec3>) {
    let mut spec = hanging(16, 16, Topology::Sheet, [0.02; 2]);
    spec.pinned.fill(false);
    spec.fabric.friction = friction;
    let model = ExplicitModel::new(&spec).expect("the cloth is valid");
    let level: Vec<Vec3> = (reference_support::rest_positions(&spec.grid).iter())
        .map(|p| p.as_vec3())
        .map(|p| Vec3::X * (p.x - 0.15) + along * (-0.15 - p.y) + Vec3::Y * 0.002)
        .collect();
    let mut state = ClothState::new(model.cloth(), &level);
    let mut positions = Vec::new();
    for _ in 0..60 {
        let input = StepInput {
            pin_targets: &[],
            capsules,
            ..StepInput::default()
        };
        explicit_rows::step(
            &model,
            &SolverConfig::default(),
            &input,
            &mut state,
            FRAME_DT,
        )
        .expect("a target for every pin");
        state.copy_positions(model.cloth(), &mut positions);
        assert_eq!(diagnose::first_non_finite(&positions), None);
        let depth = diagnose::worst_capsule_penetration(&spec, &positions, capsules);
        assert!(depth < 2e-4, "{depth} m inside");
    }
    (spec, positions)
}

#[test]
fn a_sheet_on_a_capsule_stays_outside_and_lies_there() {
    let center = Vec3::new(0.0, -0.1, 0.0);
    let tapered = Capsule {
        ends: [center - Vec3::X * 0.3, center + Vec3::X * 0.3],
        radii: [0.1, 0.08],
    };
    let (_, positions) = fallen(0.6, Vec3::Z, &[tapered]);
    let mean = positions.iter().sum::<Vec3>() / positions.len() as f32;
    assert!(-0.15 < mean.y, "the capsule holds the sheet: {mean}");
}

#[test]
fn a_sheet_slides_down_a_slope_by_gravity_less_friction() {
    // A cylinder of 20 m is level to 1 mm over the sheet; its axis falls by a slope of 0.4.
    let radius = 20.0;
    let (down, up) = (
        Vec3::new(0.0, -0.4, 1.0).normalize_or_zero(),
        Vec3::new(0.0, 1.0, 0.4).normalize_or_zero(),
    );
    let center = -up * radius;
    let slope = Capsule::uniform(center - down * 40.0, center + down * 40.0, radius);
    let [with, without] = [0.3, 0.0].map(|friction| {
        let (_, positions) = fallen(friction, down, &[slope]);
        let mean = positions.iter().sum::<Vec3>() / positions.len() as f32;
        mean.dot(down)
    });
    let (sine, cosine) = (-down.y, up.y);
    // Drag of 1/s leaves `e^-1` of `½ t²` in the first second: (t - 1 + e^-t) a.
    let falls = |acceleration: f32| acceleration * trig::exp(-1.0);
    let start = Vec3::Y.dot(down) * 0.002;
    for (found, friction) in [(with - start, 0.3), (without - start, 0.0)] {
        let truth = falls(9.81 * (sine - friction * cosine));
        assert!(
            (found / truth - 1.0).abs() < 0.03,
            "{found} and not {truth} with {friction}"
        );
    }
    let (_, held) = fallen(0.5, down, &[slope]);
    let mean = held.iter().sum::<Vec3>() / held.len() as f32;
    assert!(
        (mean.dot(down) - start).abs() < 0.01,
        "it creeps by {}",
        mean.dot(down)
    );
}

fn hash_after(scene: &ClothScene, instruction_set: InstructionSet, thread_count: usize) -> u64 {
    let mut setup = (scene.build)();
    setup.config.instruction_set = instruction_set;
    let model = ExplicitModel::new(&setup.spec).expect("the scene is valid");
    let pins: Vec<_> = (model.cloth().pin_indices().iter())
        .map(|&pin| setup.positions[pin as usize])
        .collect();
    let mut state = ClothState::new(model.cloth(), &setup.positions);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(thread_count)
        .build()
        .expect("threads");
    pool.install(|| {
        for frame in 1..=2_u8 {
            let capsules = (scene.capsules)(f64::from(frame) * f64::from(FRAME_DT));
            let input = StepInput {
                pin_targets: &pins,
                capsules: &capsules,
                air_velocity: Vec3::X,
                ..StepInput::default()
            };
            explicit_rows::step(&model, &setup.config, &input, &mut state, FRAME_DT)
                .expect("a target for every pin");
        }
    });
    state_hash(&state)
}

#[test]
fn every_scene_has_the_same_bits_with_all_vector_instructions_and_threads() {
    let small = |scene: &&ClothScene| ["hang-64", "skirt"].contains(&scene.name);
    for scene in SCENES.iter().filter(small) {
        let detected = hash_after(scene, InstructionSet::Detected, 1);
        for (instruction_set, threads) in [
            (InstructionSet::Wide, 1),
            (InstructionSet::Baseline, 1),
            (InstructionSet::Detected, 3),
        ] {
            let other = hash_after(scene, instruction_set, threads);
            assert_eq!(detected, other, "{} with {instruction_set:?}", scene.name);
        }
    }
}
