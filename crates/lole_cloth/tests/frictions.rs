//! Friction on skin and friction of cloth on cloth are two.

mod xpbd_support;

use std::num::NonZeroU32;

use glam::Vec3;
use lole_cloth::{Crossings, Fabric, SelfCollision, state_hash};
use lole_geom::Capsule;
use xpbd_support::{FABRIC, World, mean, sheet_spec};

/// How far [m] the upper half of a sheet folded double slides sideways over the lower half, which
/// is held, when it is pushed once.
fn slide_over_itself(friction: f32, cloth_friction: f32) -> (f32, u64) {
    const COLUMNS: u32 = 16;
    const HALF: u32 = 16;
    const SPACING: f32 = 0.01;
    let fabric = Fabric {
        shear: 0.5,
        bend: [1.0e-7; 2],
        twist: 1.0e-7,
        friction,
        cloth_friction,
        ..FABRIC
    };
    let mut spec = sheet_spec(COLUMNS, 2 * HALF, SPACING, fabric);
    let particles = (0..2 * HALF).flat_map(|row| (0..COLUMNS).map(move |column| (row, column)));
    let is_upper = |row: u32| HALF <= row;
    spec.pinned = particles.clone().map(|(row, _)| !is_upper(row)).collect();
    let start: Vec<Vec3> = (particles.clone())
        .map(|(row, column)| {
            let (height, along) = if is_upper(row) {
                (0.0062, 2 * HALF - 1 - row)
            } else {
                (0.0, row)
            };
            Vec3::new(column as f32 * SPACING, height, along as f32 * SPACING)
        })
        .collect();
    let mut world = World::new(&spec, &start);
    world.config.self_collision = Some(SelfCollision {
        radius: 0.003,
        substep_interval: NonZeroU32::MIN,
        crossings: Crossings::Leave,
    });
    let pushed: Vec<Vec3> = particles
        .map(|(row, _)| {
            if is_upper(row) {
                Vec3::X * 0.4
            } else {
                Vec3::ZERO
            }
        })
        .collect();
    world.state.set_velocities(&world.model, &pushed);
    for _ in 0..6 {
        world.step(&[]);
    }
    let upper = (HALF * COLUMNS) as usize;
    let moved = mean(&world.positions()[upper..]) - mean(&start[upper..]);
    (moved.x, state_hash(&world.state))
}

#[test]
fn cloth_that_slides_over_cloth_is_held_by_the_friction_of_cloth_on_cloth_alone() {
    let (free, _) = slide_over_itself(0.3, 0.0);
    let (held, hash) = slide_over_itself(0.3, 0.8);
    assert!(
        0.008 < free && held < 0.7 * free,
        "{held} m, {free} m without"
    );
    assert_eq!(hash, slide_over_itself(0.0, 0.8).1);
}

#[test]
fn cloth_that_slides_over_skin_is_held_by_the_friction_on_skin_alone() {
    let capsule = Capsule::uniform(Vec3::new(-1.0, -0.1, 0.1), Vec3::new(1.0, -0.1, 0.1), 0.098);
    let slide = |friction: f32, cloth_friction: f32| {
        let fabric = Fabric {
            friction,
            cloth_friction,
            ..FABRIC
        };
        let start: Vec<Vec3> = xpbd_support::flat_positions(21, 21, 0.01);
        let mut world = World::new(&sheet_spec(21, 21, 0.01, fabric), &start);
        let pushed = vec![Vec3::X * 0.3; start.len()];
        world.state.set_velocities(&world.model, &pushed);
        for _ in 0..15 {
            world.step(&[capsule]);
        }
        (mean(&world.positions()).x, state_hash(&world.state))
    };
    let (free, _) = slide(0.0, 0.3);
    let (held, hash) = slide(0.6, 0.3);
    assert!(held < free - 0.005, "{held} m, {free} m without");
    assert_eq!(hash, slide(0.6, 0.9).1);
}
