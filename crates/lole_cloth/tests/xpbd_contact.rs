//! Laws of contact with the body: outside, friction, degenerate capsules.

mod xpbd_support;

use glam::Vec3;
use lole_cloth::{Fabric, diagnose};
use lole_geom::Capsule;
use xpbd_support::{DT, FABRIC, World, flat_positions, mean, sheet_spec};

fn sheet_over(center: Vec3, friction: f32) -> World {
    let offset = Vec3::new(-0.31, 0.0, -0.31) + center;
    let positions: Vec<_> = flat_positions(32, 32, 0.02)
        .iter()
        .map(|&p| p + offset)
        .collect();
    World::new(
        &sheet_spec(32, 32, 0.02, Fabric { friction, ..FABRIC }),
        &positions,
    )
}

#[test]
fn a_sheet_dropped_on_capsules_ends_outside_them() {
    let tapered = Capsule {
        ends: [Vec3::new(-0.2, 0.0, 0.0), Vec3::new(0.2, 0.0, 0.0)],
        radii: [0.12, 0.08],
    };
    let point = Capsule::uniform(Vec3::ZERO, Vec3::ZERO, 0.12);
    let uniform = Capsule::uniform(Vec3::new(-0.2, 0.0, 0.0), Vec3::new(0.2, 0.02, 0.0), 0.1);
    for capsules in [vec![tapered], vec![point], vec![uniform, point]] {
        let mut world = sheet_over(Vec3::new(0.0, 0.2, 0.0), 0.5);
        for _ in 0..60 {
            world.step(&capsules);
            let positions = world.positions();
            assert_eq!(diagnose::first_non_finite(&positions), None);
            let depth =
                diagnose::worst_capsule_penetration(world.model.spec(), &positions, &capsules);
            assert!(depth < 1.0e-4, "{depth} m");
        }
        assert!(
            -0.3 < mean(&world.positions()).y,
            "the capsule holds the sheet"
        );
    }
}

#[test]
fn cloth_deep_inside_leaves_at_the_depenetration_speed_whatever_the_passes() {
    let capsule = Capsule::uniform(Vec3::new(-2.0, -0.4, 0.0), Vec3::new(2.0, -0.4, 0.0), 0.8);
    for capsules in [vec![capsule], vec![capsule, capsule]] {
        let mut world = sheet_over(Vec3::ZERO, 0.0);
        world.config.gravity = Vec3::ZERO;
        world.config.depenetration_speed = 0.3;
        let before = mean(&world.positions());
        world.step(&capsules);
        let speed = (mean(&world.positions()) - before).length() / DT;
        // Springs hurry what is not pushed itself; a push repeated in every pass would reach 3 m/s.
        assert!((0.25..0.4).contains(&speed), "{speed} m/s");
    }
}

#[test]
fn a_point_on_the_axis_stays_finite() {
    let capsule = Capsule::uniform(Vec3::new(-0.2, 0.0, 0.01), Vec3::new(0.2, 0.0, 0.01), 0.05);
    let mut world = sheet_over(Vec3::ZERO, 0.3);
    for _ in 0..5 {
        world.step(&[capsule]);
        assert_eq!(diagnose::first_non_finite(&world.positions()), None);
    }
}

/// How far a small sheet on a broad table is carried while the table gains speed evenly [m], and
/// how far the table went.
fn carried(acceleration: f32, friction: f32) -> (f32, f32) {
    // A cylinder of 20 m is level to 1 mm over the sheet.
    let radius = 20.0;
    let table = |x: f32| {
        let center = Vec3::new(x, -radius, 0.0);
        Capsule::uniform(center - Vec3::Z * 5.0, center + Vec3::Z * 5.0, radius)
    };
    let offset = Vec3::new(-0.15, 0.002, -0.15);
    let positions: Vec<_> = flat_positions(16, 16, 0.02)
        .iter()
        .map(|&p| p + offset)
        .collect();
    let spec = sheet_spec(16, 16, 0.02, Fabric { friction, ..FABRIC });
    let mut world = World::new(&spec, &positions);
    for _ in 0..20 {
        world.step(&[table(0.0)]);
    }
    let start = mean(&world.positions()).x;
    let mut x = 0.0;
    for frame in 1..=30 {
        let time = frame as f32 * DT;
        x = 0.5 * acceleration * time * time;
        world.step(&[table(x)]);
    }
    (mean(&world.positions()).x - start, x)
}

#[test]
fn friction_carries_the_sheet_along_below_mu_g() {
    let (acceleration, grip) = (0.8 * 0.5 * 9.81, 0.5 * 9.81);
    let (sheet, table) = carried(acceleration, 0.5);
    // The table gains `a dt` at the start of every frame, and the sheet needs `a dt / (mu g)` to
    // follow: it slips `(a dt)² / (2 mu g)` a frame and no more.
    let slip = 30.0 * (acceleration * DT) * (acceleration * DT) / (2.0 * grip);
    assert!(
        (sheet - (table - slip)).abs() < 0.005 * table,
        "{sheet} of {table} less {slip}"
    );
}

#[test]
fn the_sheet_slips_above_mu_g_with_the_force_of_friction() {
    let (sheet, table) = carried(2.0 * 0.3 * 9.81, 0.3);
    assert!(
        (sheet / (0.5 * table) - 1.0).abs() < 0.05,
        "{sheet} of half of {table}"
    );
}

#[test]
fn without_friction_the_sheet_stays_where_it_is() {
    let (sheet, table) = carried(3.0, 0.0);
    assert!(
        sheet.abs() < 0.02 * table,
        "{sheet} while the table went {table}"
    );
}
