//! Laws of contact of a piece of any mesh with itself: those of the grid.

mod mesh_support;

use std::num::NonZeroU32;

use glam::{Vec2, Vec3};
use lole_cloth::mesh::{MeshSpec, diagnose};
use lole_cloth::{Crossings, Fabric, InstructionSet, SelfCollision, mesh_state_hash};
use lole_geom::{Capsule, trig};
use mesh_support::{FABRIC, World, rectangle};

const RADIUS: f32 = 0.004;

fn with_self_contact(mut world: World, crossings: Crossings) -> World {
    world.config.self_collision = Some(SelfCollision {
        radius: RADIUS,
        substep_interval: NonZeroU32::MIN,
        crossings,
    });
    world
}

fn crossings(world: &World) -> usize {
    diagnose::self_crossings(&world.model, &world.positions()).expect("finite cloth")
}

/// A capsule so large that it is level under the cloth, with its highest point at the origin.
fn floor() -> Capsule {
    let radius = 20.0;
    Capsule::uniform(
        Vec3::new(-1.0, -radius, 0.0),
        Vec3::new(1.0, -radius, 0.0),
        radius,
    )
}

/// A limp square of particles thrown about that will fall on its lower edge and crumple.
fn falling(crossings: Crossings) -> World {
    falling_from(32, crossings)
}

/// A limp rectangle of so many rows thrown about that will fall on its lower edge and crumple.
fn falling_from(row_count: u32, crossings: Crossings) -> World {
    let (flat, triangles) = rectangle(32, row_count, 0.01, 0.4);
    let height = flat[flat.len() - 1].y + 0.02;
    let positions: Vec<_> = (flat.iter())
        .map(|p| Vec3::new(p.x, height - p.y, 0.02 * p.x + 0.05 * p.y * p.y))
        .collect();
    let fabric = Fabric {
        bend: [5.0e-6; 2],
        twist: 5.0e-6,
        ..FABRIC
    };
    let spec = MeshSpec::new(flat, triangles, fabric);
    with_self_contact(World::new(&spec, &positions), crossings)
}

#[test]
fn a_sheet_that_falls_in_a_heap_never_crosses_itself() {
    let mut world = falling(Crossings::Repair);
    for frame in 0..150 {
        world.step(&[floor()]);
        assert_eq!(crossings(&world), 0, "frame {frame}");
    }
    let positions = world.positions();
    let highest = positions.iter().map(|p| p.y).fold(0.0, f32::max);
    assert!(highest < 0.2, "it has come down: {highest} m");
    let strain = diagnose::strain(&world.model, &positions);
    assert!(strain.p99 < 0.1, "{strain:?}");
}

/// Without contact the same heap goes through itself in thousands of places.
#[test]
fn contact_alone_leaves_few_crossings() {
    let worst = |mut world: World| {
        let counts = (0..100).map(|_| {
            world.step(&[floor()]);
            crossings(&world)
        });
        counts.max().expect("frames")
    };
    let mut without = falling(Crossings::Leave);
    without.config.self_collision = None;
    let (with, without) = (worst(falling(Crossings::Leave)), worst(without));
    assert!(1000 < without, "{without}");
    assert!(with * 20 < without, "{with} of {without}");
}

/// A tall sheet tangles where crossings are left. Contact that took sides there would draw it
/// together.
#[test]
fn a_tangled_heap_keeps_its_width() {
    let mut world = falling_from(64, Crossings::Leave);
    for _ in 0..100 {
        world.step(&[floor()]);
    }
    let xs: Vec<f32> = world.positions().iter().map(|p| p.x).collect();
    let [low, high] = [
        xs.iter().copied().fold(f32::MAX, f32::min),
        xs.iter().copied().fold(f32::MIN, f32::max),
    ];
    assert!(0.28 < high - low, "{low} to {high} m");
}

/// A strip folded into two leaves 2 cm apart, whose upper leaf is pushed through the lower one
/// around its middle.
fn pushed_through() -> World {
    let (flat, triangles) = rectangle(48, 24, 0.01, 0.3);
    let place = |flat: &Vec2| {
        // Half a circle of 2 cm across takes three cells; leaves run out from both its ends.
        let along = flat.x - 0.235;
        let bend = 0.01_f32;
        let half_arc = 0.5 * std::f32::consts::PI * bend;
        if along.abs() < half_arc {
            let angle = along / bend;
            return Vec3::new(bend * trig::cos(angle), bend * trig::sin(angle), flat.y);
        }
        let out = along.abs() - half_arc;
        let mut height = bend * along.signum();
        let from_middle = Vec2::new(out - 0.11, flat.y - 0.115).length();
        if 0.0 < along && from_middle < 0.05 {
            height -= 0.03 * (1.0 - (from_middle / 0.05) * (from_middle / 0.05));
        }
        Vec3::new(-out, height, flat.y)
    };
    let positions: Vec<Vec3> = flat.iter().map(place).collect();
    let spec = MeshSpec::new(flat, triangles, FABRIC);
    let mut world = with_self_contact(World::new(&spec, &positions), Crossings::Repair);
    world.config.gravity = Vec3::ZERO;
    world
}

#[test]
fn a_fold_pushed_through_itself_comes_out_within_two_seconds_and_does_not_burst() {
    let mut world = pushed_through();
    assert!(
        20 < crossings(&world),
        "the start is tangled: {}",
        crossings(&world)
    );
    for _ in 0..120 {
        world.step(&[]);
        let speeds = world.velocities();
        let fastest = speeds.iter().map(|v| v.length()).fold(0.0, f32::max);
        assert!(fastest < 3.0, "{fastest} m/s");
    }
    for _ in 0..30 {
        world.step(&[]);
        assert_eq!(crossings(&world), 0);
    }
    let strain = diagnose::strain(&world.model, &world.positions());
    assert!(strain.max < 0.1, "{strain:?}");
}

/// Two leaves that fly at each other bounce off: what both do together does not change.
#[test]
fn contact_keeps_momentum_and_what_lies_flat_does_not_touch() {
    let flying = |contact: bool| {
        let mut world = pushed_through();
        let mut positions = world.positions();
        for p in &mut positions {
            // Leaves side by side again, 2 cm apart.
            p.y = if p.x < 0.0 { p.y.signum() * 0.01 } else { p.y };
        }
        let velocities: Vec<Vec3> = (positions.iter())
            .map(|p| Vec3::new(0.3, -20.0 * p.y, 0.1))
            .collect();
        world.state.set_positions(&world.model, &positions);
        world.state.set_velocities(&world.model, &velocities);
        world.config.substep_count = NonZeroU32::MIN.saturating_add(7);
        if let Some(collision) = &mut world.config.self_collision {
            collision.crossings = Crossings::Leave;
        }
        if !contact {
            world.config.self_collision = None;
        }
        let masses = world.model.particle_masses();
        let momentum = |world: &World| {
            let shares = world.velocities().into_iter().zip(&masses);
            shares.map(|(v, &mass)| v * mass).sum::<Vec3>()
        };
        let before = momentum(&world);
        for _ in 0..12 {
            world.step(&[]);
        }
        let after = momentum(&world);
        let mass: f32 = masses.iter().sum();
        ((after - before).length() / mass, crossings(&world))
    };
    let (gained, crossed) = flying(true);
    assert!(gained < 1.0e-3, "{gained} m/s");
    let (_, without) = flying(false);
    assert!(
        crossed == 0 && 50 < without,
        "{crossed} with contact, {without} without"
    );
    // Particles nearer together than the cloth is thick.
    let (flat, triangles) = rectangle(40, 40, 0.003, 0.4);
    let positions: Vec<Vec3> = flat.iter().map(|p| Vec3::new(p.x, 0.0, p.y)).collect();
    let spec = MeshSpec::new(flat, triangles, FABRIC);
    let mut world = with_self_contact(World::new(&spec, &positions), Crossings::Repair);
    let mut free = World::new(&spec, &positions);
    for _ in 0..10 {
        world.step(&[]);
        free.step(&[]);
    }
    assert_eq!(world.positions(), free.positions());
}

#[test]
fn every_instruction_set_gives_the_same_bits() {
    let hash = |set: InstructionSet| {
        let mut world = falling(Crossings::Repair);
        world.config.instruction_set = set;
        for _ in 0..40 {
            world.step(&[floor()]);
        }
        mesh_state_hash(&world.state)
    };
    let expected = hash(InstructionSet::Baseline);
    assert_eq!(hash(InstructionSet::Wide), expected);
    assert_eq!(hash(InstructionSet::Detected), expected);
}

/// Pleats pressed into one plane lie in each other without a crossing that could be counted, and cross by
/// rounding as soon as they turn.
#[test]
fn cloth_laid_into_one_plane_goes_with_its_pins() {
    let (flat, triangles) = rectangle(40, 24, 0.01, 0.4);
    let pleat = |x: f32| {
        let turned = (x / 0.05).rem_euclid(2.0);
        0.05 * (turned.min(2.0 - turned) + 0.3 * x / 0.4)
    };
    let positions: Vec<Vec3> = (flat.iter())
        .map(|p| Vec3::new(pleat(p.x), 1.0 - p.y, 0.180_034_07))
        .collect();
    let mut spec = MeshSpec::new(flat, triangles, FABRIC);
    for column in 0..40 {
        spec.pinned[column] = true;
    }
    let mut world = with_self_contact(World::new(&spec, &positions), Crossings::Repair);
    let starts = world.pins.clone();
    for frame in 1..=40 {
        let turn = glam::Quat::from_rotation_y(0.01 * frame as f32);
        for (pin, start) in world.pins.iter_mut().zip(&starts) {
            *pin = turn * *start + Vec3::X * (0.005 * frame as f32);
        }
        world.step(&[]);
    }
    let now = world.positions();
    let away = (world.pins.iter().zip(&now)).map(|(pin, place)| pin.distance(*place));
    let farthest = away.fold(0.0, f32::max);
    assert!(farthest < 0.005, "pins stay behind by {farthest} m");
    let middle = |places: &[Vec3]| places.iter().map(|p| p.x).sum::<f32>() / places.len() as f32;
    let way = middle(&now) - middle(&positions);
    assert!(0.15 < way, "the cloth went {way} m");
}
