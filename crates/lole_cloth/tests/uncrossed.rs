//! The promise: what did not cross does not come to cross, whatever is done to it, and a tangle
//! grows by no more than drawing it out takes. Judged by exact predicates that share nothing with the engine.

mod exact_support;
mod mesh_support;
mod xpbd_support;

use std::num::NonZeroU32;

use exact_support::crossing_count;
use glam::{Vec2, Vec3};
use lole_cloth::mesh::MeshSpec;
use lole_cloth::{Crossings, Fabric, SelfCollision, SolverConfig};
use lole_geom::{Capsule, Chance, trig};
use xpbd_support::{FABRIC, World, flat_positions, sheet_spec};

const COLUMNS: u32 = 26;
const ROWS: u32 = 22;
const SPACING: f32 = 0.01;

fn limp() -> Fabric {
    Fabric {
        bend: [5.0e-6; 2],
        twist: 5.0e-6,
        ..FABRIC
    }
}

fn keeping(config: &mut SolverConfig) {
    config.self_collision = Some(SelfCollision {
        radius: 0.004,
        substep_interval: NonZeroU32::MIN,
        crossings: Crossings::Repair,
    });
}

/// Waves of velocity that throw folds against each other, up to some meters a second.
fn gust(chance: &mut Chance, positions: &[Vec3]) -> Vec<Vec3> {
    let mut draw =
        |low: f32, high: f32| Vec3::from_array([(); 3].map(|()| chance.between(low, high)));
    let waves = [(); 3].map(|()| (draw(-60.0, 60.0), draw(-2.5, 2.5), draw(0.0, 6.0).x));
    let velocity = |place: &Vec3| {
        let each = waves
            .iter()
            .map(|(number, reach, phase)| *reach * trig::sin(number.dot(*place) + *phase));
        each.sum::<Vec3>()
    };
    positions.iter().map(velocity).collect()
}

/// A bar that sweeps through where the cloth is.
fn bar(frame: u16) -> Capsule {
    let x = 0.12 + 0.12 * trig::sin(0.11 * f32::from(frame));
    Capsule::uniform(Vec3::new(x, 0.02, -0.1), Vec3::new(x, 0.02, 0.4), 0.015)
}

#[test]
fn a_grid_that_does_not_cross_never_comes_to_cross() {
    for seed in 0..5 {
        let mut chance = Chance::new(seed);
        let mut spec = sheet_spec(COLUMNS, ROWS, SPACING, limp());
        let last = COLUMNS as usize - 1;
        (spec.pinned[0], spec.pinned[last]) = (true, true);
        let mut world = World::new(&spec, &flat_positions(COLUMNS, ROWS, SPACING));
        keeping(&mut world.config);
        let triangles = spec.grid.triangles();
        for frame in 0..90_u16 {
            if frame % 9 == 0 {
                let velocities = gust(&mut chance, &world.positions());
                world.state.set_velocities(&world.model, &velocities);
            }
            // The corners come together and go apart.
            let by = 0.12 * (1.0 - trig::cos(0.07 * f32::from(frame)));
            world.pins = vec![
                Vec3::X * by,
                Vec3::X * ((COLUMNS - 1) as f32 * SPACING - by),
            ];
            world.step(&[bar(frame)]);
            let positions = world.positions();
            assert!(
                positions.iter().all(|it| it.is_finite()),
                "{seed}: frame {frame}"
            );
            assert_eq!(
                crossing_count(&triangles, &positions),
                0,
                "{seed}: frame {frame}"
            );
        }
    }
}

#[test]
fn a_mesh_that_does_not_cross_never_comes_to_cross() {
    for seed in 0..5 {
        let mut chance = Chance::new(100 + seed);
        let (flat, triangles) = mesh_support::rectangle(COLUMNS, ROWS, SPACING, 0.4);
        let positions: Vec<Vec3> = flat
            .iter()
            .map(|it: &Vec2| Vec3::new(it.x, 0.0, it.y))
            .collect();
        let spec = MeshSpec::new(flat, triangles.clone(), limp());
        let mut world = mesh_support::World::new(&spec, &positions);
        keeping(&mut world.config);
        let mut taken = 0;
        for frame in 0..90_u16 {
            if frame % 9 == 0 {
                let velocities = gust(&mut chance, &world.positions());
                world.state.set_velocities(&world.model, &velocities);
            }
            // A step that would lead nowhere is not taken, and that is a promise too.
            if world.try_step(&[bar(frame)]) == lole_cloth::mesh::Outcome::Advanced {
                taken += 1;
            }
            let positions = world.positions();
            assert_eq!(
                crossing_count(&triangles, &positions),
                0,
                "{seed}: frame {frame}"
            );
        }
        assert!(80 < taken, "{seed}: {taken} of 90 steps");
    }
}

#[test]
fn tangles_never_grow_beyond_what_drawing_them_out_takes() {
    for seed in 0..8 {
        let mut chance = Chance::new(200 + seed);
        let spec = sheet_spec(COLUMNS, ROWS, SPACING, limp());
        let reach = chance.between(0.004, 0.02);
        let thrown: Vec<Vec3> = flat_positions(COLUMNS, ROWS, SPACING)
            .into_iter()
            .map(|place| {
                let by = [(); 3].map(|()| chance.between(-reach, reach));
                place + Vec3::from_array(by)
            })
            .collect();
        let mut world = World::new(&spec, &thrown);
        keeping(&mut world.config);
        let triangles = spec.grid.triangles();
        let first = crossing_count(&triangles, &thrown);
        let mut known = first;
        // A contour that becomes shorter may meet more triangles for a while.
        let most = first + first / 4 + 8;
        for frame in 0..60 {
            world.step(&[]);
            let now = crossing_count(&triangles, &world.positions());
            assert!(now <= most, "{seed}: {first}, then {now} in frame {frame}");
            assert!(0 < known || now == 0, "{seed}: frame {frame}");
            known = now;
        }
        assert!(known < first, "{seed}: {first} stay {known}");
    }
}

/// A sheet folded in two whose ends, pinned all along, are drawn through each other and back.
#[test]
fn pins_that_would_cross_yield_and_come_back() {
    let mut spec = sheet_spec(16, 41, SPACING, limp());
    let columns = 16;
    for column in 0..columns {
        spec.pinned[column] = true;
        spec.pinned[40 * columns + column] = true;
    }
    // Up one side and down the other, 4 cm apart.
    let place = |(index, _): (usize, &Vec3)| {
        let (row, column) = (index / columns, index % columns);
        let (side, depth) = if row < 20 {
            (0.02, row)
        } else {
            (-0.02, 40 - row)
        };
        let side = if row == 20 { 0.0 } else { side };
        Vec3::new(column as f32 * SPACING, -(depth as f32) * SPACING, side)
    };
    let start: Vec<Vec3> = flat_positions(16, 41, SPACING)
        .iter()
        .enumerate()
        .map(place)
        .collect();
    let mut world = World::new(&spec, &start);
    keeping(&mut world.config);
    let triangles = spec.grid.triangles();
    let home = world.pins.clone();
    let mut most_off = 0.0_f32;
    for frame in 0..160_u16 {
        // To the other side and back within two seconds.
        let swing =
            0.0125 * (1.0 - trig::cos(std::f32::consts::TAU * f32::from(frame.min(120)) / 120.0));
        world.pins = (home.iter())
            .map(|pin| *pin - Vec3::Z * (swing * pin.z.signum()))
            .collect();
        world.step(&[]);
        let positions = world.positions();
        assert_eq!(crossing_count(&triangles, &positions), 0, "frame {frame}");
        let offs = world.model.pin_indices().iter().zip(&world.pins);
        let offs = offs.map(|(&pin, target)| positions[pin as usize].distance(*target));
        let off = offs.fold(0.0, f32::max);
        most_off = most_off.max(off);
        if 150 < frame {
            assert!(
                off < 1.0e-6,
                "they are home again: {off} m in frame {frame}"
            );
        }
    }
    assert!(0.002 < most_off, "they had to yield: {most_off} m");
}
