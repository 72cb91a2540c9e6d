//! Laws of contact of a piece of any mesh with a skinned body: those of the grid.

mod mesh_support;
mod skin_support;

use std::num::NonZeroU32;

use glam::{Quat, Vec3};
use lole_cloth::Lost;
use lole_cloth::mesh::{self, MeshSpec};
use lole_cloth::{Fabric, InstructionSet, StepInput, diagnose, mesh_state_hash};
use lole_geom::Surfel;
use mesh_support::{DT, FABRIC, World, rectangle};
use skin_support::sphere;

/// A level square of 62 cm around the upright axis, particles thrown about.
fn sheet_at(height: f32, friction: f32) -> World {
    let (flat, triangles) = rectangle(63, 63, 0.01, 0.4);
    let positions: Vec<_> = (flat.iter())
        .map(|p| Vec3::new(p.x - 0.31, height, p.y - 0.31))
        .collect();
    let spec = MeshSpec::new(flat, triangles, Fabric { friction, ..FABRIC });
    let mut world = World::new(&spec, &positions);
    world.config.contact_offset = 0.003;
    world
}

fn step_on(world: &mut World, surfels: &[Surfel]) -> Result<(), Lost> {
    let input = StepInput {
        pin_targets: &world.pins,
        surfels,
        ..StepInput::default()
    };
    mesh::step(&world.model, &world.config, &input, &mut world.state, DT)
}

fn deepest(world: &World, center: Vec3, radius: f32) -> f32 {
    let positions = world.positions();
    assert_eq!(diagnose::first_non_finite(&positions), None);
    let depths = positions
        .iter()
        .map(|point| radius - point.distance(center));
    depths.fold(0.0, f32::max)
}

#[test]
fn a_sheet_dropped_on_a_head_lies_on_it_and_stays() {
    let (center, radius) = (Vec3::ZERO, 0.1);
    let surfels = sphere(center, radius);
    let mut world = sheet_at(0.13, 0.6);
    for _ in 0..150 {
        assert_eq!(step_on(&mut world, &surfels), Ok(()));
        let depth = deepest(&world, center, radius);
        assert!(depth < 0.001, "{depth} m inside");
    }
    let positions = world.positions();
    let highest = positions.iter().map(|p| p.y).fold(f32::MIN, f32::max);
    // The gap is kept, and no more than the planes of surfels stand off the sphere.
    assert!(
        (radius + 0.002..radius + 0.005).contains(&highest),
        "{highest}"
    );
    let sum: Vec3 = positions.iter().sum();
    assert!(
        -0.1 < sum.y / positions.len() as f32,
        "the head holds the sheet"
    );
}

/// A ball flies through the place of a hanging curtain: the curtain stays before it.
#[test]
fn nothing_passes_through_a_fast_limb() {
    for speed in [1.0_f32, 3.0, 6.0, 10.0] {
        let radius = 0.05;
        let mut world = sheet_at(0.0, 0.3);
        world.config.gravity = Vec3::ZERO;
        // With one sweep the blow crumples the sheet so much that it whips round the ball faster
        // than any search foresees.
        world.config.structural_sweep_count = NonZeroU32::MIN.saturating_add(2);
        let mut center = Vec3::new(0.0, -0.1, 0.0);
        assert_eq!(step_on(&mut world, &sphere(center, radius)), Ok(()));
        while center.y < 0.15 {
            center.y += speed * DT;
            assert_eq!(step_on(&mut world, &sphere(center, radius)), Ok(()));
            let depth = deepest(&world, center, radius);
            assert!(depth < 0.002, "{speed} m/s: {depth} m");
        }
        // What was above the ball's path was carried along.
        let middle = world.positions()[31 * 63 + 31];
        assert!(
            center.y + radius < middle.y + 0.002,
            "{speed} m/s: {middle} at {center}"
        );
    }
}

/// A head turns under the cloth that lies on it. Without friction nothing can turn the cloth about
/// the upright axis.
#[test]
fn a_turning_head_takes_the_cloth_with_it_by_friction_alone() {
    let turn_rate = |friction: f32, above: f32| {
        let speed = 0.6_f32;
        let mut world = sheet_at(0.105, friction);
        let head = sphere(Vec3::ZERO, 0.1);
        for frame in 0..100_u16 {
            let angle = speed * DT * f32::from(frame.saturating_sub(40));
            let turn = Quat::from_rotation_y(angle);
            let turned = head.iter().map(|surfel| Surfel {
                position: turn * surfel.position,
                normal: turn * surfel.normal,
            });
            let surfels: Vec<Surfel> = turned.collect();
            assert_eq!(step_on(&mut world, &surfels), Ok(()));
        }
        let particles = world.positions().into_iter().zip(world.velocities());
        let particles = particles.filter(|(p, _)| above < p.y);
        let (momentum, inertia) = particles.fold((0.0, 0.0), |(momentum, inertia), (p, v)| {
            let about = p.z * v.x - p.x * v.z;
            (momentum + about, inertia + p.x * p.x + p.z * p.z)
        });
        momentum / inertia / speed
    };
    // What hangs down swings to and fro; what lies on the head tells.
    let (held, free) = (turn_rate(1.0, 0.05), turn_rate(0.0, f32::MIN));
    assert!((0.75..1.25).contains(&held), "{held}");
    assert!(free.abs() < 0.05, "{free}");
}

#[test]
fn every_instruction_set_gives_the_same_bits() {
    let hash = |set: InstructionSet| {
        let mut world = sheet_at(0.11, 0.4);
        world.config.instruction_set = set;
        for frame in 0..20_u16 {
            let center = Vec3::new(0.002 * f32::from(frame), 0.0, 0.0);
            assert_eq!(step_on(&mut world, &sphere(center, 0.1)), Ok(()));
        }
        mesh_state_hash(&world.state)
    };
    let expected = hash(InstructionSet::Baseline);
    assert_eq!(hash(InstructionSet::Wide), expected);
    assert_eq!(hash(InstructionSet::Detected), expected);
}

#[test]
fn a_body_far_away_touches_nothing() {
    let far = sphere(Vec3::new(0.0, 500.0, 0.0), 0.1);
    let mut with = sheet_at(0.105, 0.3);
    let mut without = sheet_at(0.105, 0.3);
    for _ in 0..5 {
        assert_eq!(step_on(&mut with, &far), Ok(()));
        without.step(&[]);
    }
    assert_eq!(with.positions(), without.positions());
}

#[test]
fn a_surfel_that_is_nowhere_is_named_and_the_piece_held() {
    let mut broken = sphere(Vec3::ZERO, 0.1);
    broken[17].position.x = f32::NAN;
    let mut world = sheet_at(0.105, 0.3);
    let before = world.positions();
    let Err(cause) = step_on(&mut world, &broken) else {
        panic!("the step was taken");
    };
    assert_eq!(
        cause.to_string(),
        "surfel 17 has a position or a normal that is no finite number"
    );
    assert_eq!(world.positions(), before);
}
