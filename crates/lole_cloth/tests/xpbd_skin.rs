//! Laws of contact with a skinned body, given as surfels.

mod skin_support;
mod xpbd_support;

use glam::{Quat, Vec3};
use lole_cloth::{Fabric, InstructionSet, StepInput, diagnose, state_hash, step};
use lole_geom::Surfel;
use skin_support::sphere;
use xpbd_support::{DT, FABRIC, World, flat_positions, mean, sheet_spec};

fn sheet_at(height: f32, friction: f32) -> World {
    let offset = Vec3::new(-0.31, height, -0.31);
    let positions: Vec<_> = flat_positions(63, 63, 0.01)
        .iter()
        .map(|&point| point + offset)
        .collect();
    let spec = sheet_spec(63, 63, 0.01, Fabric { friction, ..FABRIC });
    let mut world = World::new(&spec, &positions);
    world.config.contact_offset = 0.003;
    world
}

fn step_on(world: &mut World, surfels: &[Surfel]) {
    let input = StepInput {
        pin_targets: &world.pins,
        surfels,
        ..StepInput::default()
    };
    step(&world.model, &world.config, &input, &mut world.state, DT)
        .expect("a target for every pin");
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
        step_on(&mut world, &surfels);
        assert!(deepest(&world, center, radius) < 2.0e-4);
    }
    let highest = world
        .positions()
        .iter()
        .map(|p| p.y)
        .fold(f32::MIN, f32::max);
    // The gap is kept, and no more than the planes of surfels stand off the sphere.
    assert!(
        (radius + 0.002..radius + 0.005).contains(&highest),
        "{highest}"
    );
    assert!(
        -0.1 < mean(&world.positions()).y,
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
        let mut center = Vec3::new(0.0, -0.1, 0.0);
        step_on(&mut world, &sphere(center, radius));
        while center.y < 0.15 {
            center.y += speed * DT;
            step_on(&mut world, &sphere(center, radius));
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
            step_on(&mut world, &turned.collect::<Vec<_>>());
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
            step_on(&mut world, &sphere(center, 0.1));
        }
        state_hash(&world.state)
    };
    let expected = hash(InstructionSet::Baseline);
    assert_eq!(hash(InstructionSet::Wide), expected);
    assert_eq!(hash(InstructionSet::Detected), expected);
}

#[test]
fn a_body_that_is_not_finite_or_far_away_touches_nothing() {
    let far = sphere(Vec3::new(0.0, 500.0, 0.0), 0.1);
    let mut broken = sphere(Vec3::ZERO, 0.1);
    for surfel in &mut broken {
        surfel.position.x = f32::NAN;
    }
    for surfels in [far, broken] {
        let mut with = sheet_at(0.105, 0.3);
        let mut without = sheet_at(0.105, 0.3);
        for _ in 0..5 {
            step_on(&mut with, &surfels);
            without.step(&[]);
        }
        assert_eq!(with.positions(), without.positions());
    }
}
