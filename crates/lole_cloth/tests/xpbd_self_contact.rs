//! Laws of contact of the cloth with itself: folds do not go through each other, and what has gone
//! through comes out again.

mod xpbd_support;

use std::num::NonZeroU32;

use glam::Vec3;
use lole_cloth::{Crossings, Fabric, SelfCollision, diagnose, state_hash};
use lole_geom::{Capsule, trig};
use xpbd_support::{FABRIC, World, flat_positions, sheet_spec};

fn with_self_contact(mut world: World) -> World {
    world.config.self_collision = Some(SelfCollision {
        radius: 0.004,
        substep_interval: NonZeroU32::MIN,
        crossings: Crossings::Repair,
    });
    world
}

fn crossings(world: &World) -> usize {
    diagnose::self_crossings(&world.model.spec().grid, &world.positions()).expect("finite cloth")
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

#[test]
fn a_sheet_that_falls_in_a_heap_never_crosses_itself() {
    // It falls on its lower edge and crumples.
    let positions: Vec<_> = flat_positions(32, 32, 0.01)
        .iter()
        .map(|p| Vec3::new(p.x, 0.33 - p.z, 0.02 * p.x + 0.05 * p.z * p.z))
        .collect();
    let fabric = Fabric {
        bend: [5.0e-6; 2],
        twist: 5.0e-6,
        ..FABRIC
    };
    let spec = sheet_spec(32, 32, 0.01, fabric);
    let mut world = with_self_contact(World::new(&spec, &positions));
    for frame in 0..150 {
        world.step(&[floor()]);
        assert_eq!(crossings(&world), 0, "frame {frame}");
    }
    let highest = world.positions().iter().map(|p| p.y).fold(0.0, f32::max);
    assert!(highest < 0.2, "it has come down: {highest} m");
}

/// Flat cloth has nothing to touch: it is the same with contact and without, whatever its cells are like.
#[test]
fn flat_cloth_does_not_push_itself_apart() {
    for row_spacing in [0.05, 0.01, 0.007, 0.005, 0.004, 0.003, 0.002, 0.001] {
        let mut spec = sheet_spec(16, 48, 0.01, FABRIC);
        spec.grid.spacing[1] = row_spacing;
        let flat: Vec<_> = flat_positions(16, 48, 0.01)
            .iter()
            .map(|p| Vec3::new(p.x, 0.0, p.z * row_spacing / 0.01))
            .collect();
        let run = |radius: Option<f32>| {
            let mut world = with_self_contact(World::new(&spec, &flat));
            world.config.gravity = Vec3::ZERO;
            let contact = world.config.self_collision.take();
            world.config.self_collision =
                radius.and_then(|radius| Some(SelfCollision { radius, ..contact? }));
            world.run(20).positions()
        };
        assert_eq!(run(Some(0.02)), run(None), "rows {row_spacing} m apart");
    }
}

/// A strip folded into two leaves 2 cm apart, whose upper leaf is pushed through the lower one
/// around its middle.
fn pushed_through() -> World {
    let (columns, rows, spacing) = (48, 24, 0.01);
    let spec = sheet_spec(columns, rows, spacing, FABRIC);
    let positions = (0..rows).flat_map(|row| {
        (0..columns).map(move |column| {
            // Half a circle of 2 cm across takes three cells; leaves run out from both its ends.
            let along = (column as f32 - 23.5) * spacing;
            let z = row as f32 * spacing;
            let bend = 0.01_f32;
            let half_arc = 0.5 * std::f32::consts::PI * bend;
            if along.abs() < half_arc {
                let angle = along / bend;
                return Vec3::new(bend * trig::cos(angle), bend * trig::sin(angle), z);
            }
            let out = along.abs() - half_arc;
            let mut height = bend * along.signum();
            let from_middle = Vec3::new(out - 0.11, 0.0, z - 0.115).length();
            if 0.0 < along && from_middle < 0.05 {
                height -= 0.03 * (1.0 - (from_middle / 0.05) * (from_middle / 0.05));
            }
            Vec3::new(-out, height, z)
        })
    });
    let mut world = with_self_contact(World::new(&spec, &positions.collect::<Vec<_>>()));
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
    assert!(diagnose::strain(world.model.spec(), &world.positions()).max < 0.1);
}

#[test]
fn once_crossings_are_left_no_cloth_stays_without_contact() {
    let mut world = pushed_through();
    world.step(&[]);
    assert!(0 < crossings(&world), "it is still tangled");
    let leave = |world: &mut World| {
        let contact = world.config.self_collision.as_mut();
        contact.expect("it meets itself").crossings = Crossings::Leave;
    };
    leave(&mut world);
    world.step(&[]);
    // The same cloth, and nothing known of what it did before.
    let mut fresh = pushed_through();
    leave(&mut fresh);
    fresh.state = world.state.clone();
    (fresh.state).set_positions(&fresh.model, &world.positions());
    world.step(&[]);
    fresh.step(&[]);
    assert_eq!(state_hash(&world.state), state_hash(&fresh.state));
}
