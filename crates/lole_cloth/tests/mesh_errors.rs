//! What a mesh may not be, and what a step does when it is sent nowhere.

mod mesh_support;

use glam::{Vec2, Vec3};
use lole_cloth::Lost;
use lole_cloth::mesh::{MeshModel, MeshSpec};
use lole_cloth::mesh_state_hash;
use lole_geom::Capsule;
use mesh_support::{DT, FABRIC, World, rectangle};

fn square() -> MeshSpec {
    let (flat, triangles) = rectangle(4, 4, 0.1, 0.0);
    MeshSpec::new(flat, triangles, FABRIC)
}

/// What the maker is told of `square` after a change.
fn complaint(change: impl FnOnce(&mut MeshSpec)) -> String {
    let mut spec = square();
    change(&mut spec);
    MeshModel::new(&spec).expect_err("a mistake").to_string()
}

#[test]
fn every_mistake_in_a_mesh_has_its_sentence() {
    let cases: Vec<(String, &str)> = vec![
        (
            complaint(|spec| *spec = MeshSpec::new(Vec::new(), Vec::new(), FABRIC)),
            "the mesh has 0 particles and 0 triangles; give it some",
        ),
        (
            complaint(|spec| spec.triangles.clear()),
            "the mesh has 16 particles and 0 triangles; give it some",
        ),
        (
            complaint(|spec| spec.layers.truncate(3)),
            "`layers` has 3 entries; the mesh needs 16",
        ),
        (
            complaint(|spec| spec.triangles[2] = [0, 1, 99]),
            "triangle 2 names particle 99, and there are 16",
        ),
        (
            complaint(|spec| spec.flat_positions[5].x = f32::NAN),
            "particle 5 lies at (NaN, 0.1) in the flat piece; give it a finite place",
        ),
        (
            complaint(|spec| spec.triangles[0] = [0, 1, 2]),
            "triangle 0 is 0 m high over a side of 0.2 m; remove it or move a corner",
        ),
        (
            complaint(|spec| spec.triangles[0] = [4, 4, 4]),
            "triangle 0 is 0 m high over a side of 0 m; remove it or move a corner",
        ),
        (
            complaint(|spec| {
                spec.flat_positions.push(Vec2::ONE);
                spec.layers.push(1.0);
                spec.pinned.push(false);
            }),
            "particle 16 belongs to no triangle and would weigh nothing; remove it",
        ),
        (
            complaint(|spec| {
                let again = spec.triangles[0];
                spec.triangles.extend([again; 2]);
            }),
            "3 triangles share the edge of particles 0 and 1; cloth has at most two there",
        ),
        (
            complaint(|spec| {
                spec.flat_positions
                    .extend([Vec2::new(-0.1, 0.0), Vec2::new(0.0, -0.1)]);
                spec.layers.extend([1.0; 2]);
                spec.pinned.extend([false; 2]);
                spec.triangles.push([0, 16, 17]);
            }),
            "parts of the mesh hang together by particle 0 alone; give each part its own and sew them",
        ),
        (
            complaint(|spec| spec.flat_positions[0] = Vec2::new(0.25, 0.15)),
            "the flat piece folds over at the edge of particles 1 and 5; lay it out flat",
        ),
    ];
    for (found, expected) in cases {
        assert_eq!(found, expected);
    }
}

#[test]
fn a_number_that_no_fabric_has_is_refused() {
    let cases: Vec<(String, &str)> = vec![
        (
            complaint(|spec| spec.fabric.stretch[1] = 1e12),
            "`fabric.stretch` is 1000000000000; it must be between 1 and 1e9 N/m",
        ),
        (
            complaint(|spec| spec.fabric.shear = -1.0),
            "`fabric.shear` is -1; it must be between 0 and 1e9 N/m",
        ),
        (
            complaint(|spec| spec.fabric.areal_density = 0.0),
            "`fabric.areal_density` is 0; it must be between 1e-4 and 100 kg/m²",
        ),
        (
            complaint(|spec| spec.fabric.twist = f32::NAN),
            "`fabric.twist` is NaN; it must be between 0 and 100 N·m",
        ),
        (
            complaint(|spec| spec.layers[7] = 0.0),
            "`layers` is 0; it must be between 0.001 and 1000",
        ),
    ];
    for (found, expected) in cases {
        assert_eq!(found, expected);
    }
}

#[test]
fn triangles_may_turn_either_way() {
    let spec = square();
    let mut mixed = spec.clone();
    for triangle in mixed.triangles.iter_mut().step_by(3) {
        triangle.swap(0, 1);
    }
    let models = [spec, mixed].map(|spec| MeshModel::new(&spec).expect("a surface"));
    let turned = |model: &MeshModel| {
        (model.triangles().iter()).all(|&[a, b, c]| {
            let [a, b, c] = [a, b, c].map(|p| model.spec().flat_positions[p as usize]);
            0.0 < (b - a).perp_dot(c - a)
        })
    };
    assert!(models.iter().all(turned));
}

#[test]
fn the_mass_is_the_area_times_the_density() {
    let mut spec = square();
    let masses = |spec: &MeshSpec| -> f32 {
        MeshModel::new(spec)
            .expect("a surface")
            .particle_masses()
            .iter()
            .sum()
    };
    assert!((masses(&spec) - 0.15 * 0.09).abs() < 1e-7);
    spec.layers = vec![2.0; 16];
    assert!((masses(&spec) - 2.0 * 0.15 * 0.09).abs() < 1e-7);
}

fn hanging() -> World {
    let mut spec = square();
    spec.pinned[..2].fill(true);
    let positions: Vec<Vec3> = (spec.flat_positions.iter())
        .map(|flat| Vec3::new(flat.x, -flat.y, 0.0))
        .collect();
    World::new(&spec, &positions)
}

/// A step that is held leaves everything as it was, and says why.
fn held(world: &mut World, capsules: &[Capsule]) -> Lost {
    let before = mesh_state_hash(&world.state);
    let positions = world.positions();
    let outcome = world.try_step(capsules);
    assert_eq!(mesh_state_hash(&world.state), before);
    if positions.iter().all(|position| position.is_finite()) {
        assert_eq!(world.positions(), positions);
    }
    match outcome {
        Err(lost) => lost,
        Ok(()) => panic!("the step went on"),
    }
}

#[test]
fn a_step_to_nowhere_is_held_with_its_first_cause() {
    let mut world = hanging();
    world.step(&[]);
    let pin = world.pins[1];
    world.pins[1].y = f32::NAN;
    assert!(matches!(
        held(&mut world, &[]),
        Lost::PinTarget { particle: 1, .. }
    ));
    world.pins[1] = pin;

    let nowhere = Capsule::uniform(Vec3::ZERO, Vec3::INFINITY, 0.1);
    assert_eq!(held(&mut world, &[nowhere]), Lost::Capsule { index: 0 });

    let gravity = std::mem::replace(&mut world.config.gravity, Vec3::NAN);
    assert_eq!(held(&mut world, &[]), Lost::Setting { field: "gravity" });
    world.config.gravity = gravity;

    // A speed beyond all numbers overflows in the first flight.
    let velocities = world.velocities();
    let mut wild = velocities.clone();
    wild[9] = Vec3::new(0.0, 3e38, 0.0);
    world.state.set_velocities(&world.model, &wild);
    let cause = held(&mut world, &[]);
    assert!(
        matches!(cause, Lost::Particle { substep: 0, .. }),
        "{cause}"
    );

    wild[9] = Vec3::NAN;
    world.state.set_velocities(&world.model, &wild);
    assert!(matches!(
        held(&mut world, &[]),
        Lost::Start { particle: 9, .. }
    ));

    // And it goes on when the cause is gone.
    world.state.set_velocities(&world.model, &velocities);
    world.step(&[]);
}

#[test]
fn a_step_of_no_time_is_held() {
    let mut world = hanging();
    for dt in [0.0, -DT, f32::NAN] {
        let input = lole_cloth::StepInput {
            pin_targets: &world.pins,
            capsules: &[],
            ..lole_cloth::StepInput::default()
        };
        let outcome =
            lole_cloth::mesh::step(&world.model, &world.config, &input, &mut world.state, dt);
        assert!(matches!(outcome, Err(Lost::Duration { .. })));
    }
}
