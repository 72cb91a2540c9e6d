//! Laws of bodies of triangles in which cloth starts deep, or is driven there.

mod mesh_support;

use std::f32::consts::{PI, TAU};

use glam::Vec3;
use lole_cloth::mesh::{self, Depths, MeshBody, MeshSpec};
use lole_cloth::{SKIN_REACH, StepInput, mesh_state_hash};
use lole_geom::{Surfel, trig};
use proptest::prelude::*;

use mesh_support::{DT, FABRIC, World, rectangle};

/// An egg with these half axes [m], long along `x`.
fn egg(axes: Vec3) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let (around, along) = (24_u16, 24_u16);
    let mut positions = Vec::new();
    for row in 0..=along {
        let (x, wide) = trig::sin_cos(PI * (f32::from(row) / f32::from(along) - 0.5));
        positions.extend((0..around).map(|column| {
            let (sin, cos) = trig::sin_cos(TAU * f32::from(column) / f32::from(around));
            Vec3::new(x, wide * cos, wide * sin) * axes
        }));
    }
    let at = |row: u16, column: u16| u32::from(row * around + column % around);
    let cells = (0..along).flat_map(|row| (0..around).map(move |column| (row, column)));
    let triangles = cells.flat_map(|(row, column)| {
        let [a, b] = [at(row, column), at(row, column + 1)];
        let [c, d] = [at(row + 1, column), at(row + 1, column + 1)];
        [[a, b, d], [a, d, c]]
    });
    (positions, triangles.collect())
}

/// How deep the deepest of some places is in an egg, roughly [m].
fn deepest(axes: Vec3, places: impl IntoIterator<Item = Vec3>) -> f32 {
    let depth = |at: Vec3| (1.0 - (at / axes).length()) * axes.min_element();
    places.into_iter().map(depth).fold(0.0, f32::max)
}

/// A level piece of cloth around a place.
fn patch([columns, rows]: [u32; 2], middle: Vec3) -> World {
    let (flat, triangles) = rectangle(columns, rows, 0.01, 0.3);
    let half = Vec3::new(columns as f32 - 1.0, 0.0, rows as f32 - 1.0) * 0.005;
    let positions: Vec<Vec3> = (flat.iter())
        .map(|it| middle - half + Vec3::new(it.x, 0.0, it.y))
        .collect();
    let mut world = World::new(&MeshSpec::new(flat, triangles, FABRIC), &positions);
    world.config.contact_offset = 0.004;
    world.config.depenetration_speed = 0.5;
    world.config.gravity = Vec3::ZERO;
    world
}

/// A step for which the body was looked into.
fn step(world: &mut World, body: &mut MeshBody) -> Depths {
    let depths = body.look(&world.model, &mut world.state);
    step_alone(world, body);
    depths
}

/// A step with the body's skin alone.
fn step_alone(world: &mut World, body: &MeshBody) {
    let input = StepInput {
        surfels: body.surfels(),
        ..StepInput::default()
    };
    let outcome = mesh::step(&world.model, &world.config, &input, &mut world.state, DT);
    assert_eq!(outcome, Ok(()));
}

#[test]
fn what_lies_four_centimeters_deep_in_a_ball_comes_out_where_it_is_nearest_and_no_faster_than_said()
{
    let axes = Vec3::splat(0.12);
    let (positions, triangles) = egg(axes);
    let mut body = MeshBody::new(&positions, &triangles, 0.01).expect("a body");
    let mut world = patch([9, 9], Vec3::Y * 0.08);
    let mut alone = patch([9, 9], Vec3::Y * 0.08);
    let mut first = None;
    for frame in 0..30 {
        let before = world.positions();
        first.get_or_insert(step(&mut world, &mut body));
        step_alone(&mut alone, &body);
        for (now, before) in world.positions().iter().zip(&before) {
            // The cloth pulls along what comes out last.
            let way = now.distance(*before) / (0.5 * DT);
            assert!(way < 3.0, "{frame}: {way}");
            assert!(0.0 < now.y, "{frame}: {now}");
        }
    }
    let (first, last) = (
        first.expect("a step"),
        body.look(&world.model, &mut world.state),
    );
    assert_eq!(
        (first.reach, first.deep, first.out_of_reach),
        (MeshBody::REACH, 81, 0)
    );
    assert!((first.deepest - 0.04).abs() < 0.005, "{first:?}");
    assert_eq!(last.deep, 0, "{last:?}");
    let left = deepest(axes, world.positions());
    assert!(left < 0.002, "{left}");
    // Surfels alone let it lie.
    let left_alone = deepest(axes, alone.positions());
    assert!(0.03 < left_alone, "{left_alone}");
}

#[test]
fn a_limb_that_moves_is_left_on_the_side_where_the_cloth_is() {
    let axes = Vec3::new(0.35, 0.04, 0.04);
    let (positions, triangles) = egg(axes);
    let mut body = MeshBody::new(&positions, &triangles, 0.01).expect("a body");
    // A strip along the limb, a centimeter above its middle: three deep, and five from the other side.
    let mut world = patch([21, 3], Vec3::Y * 0.01);
    for frame in 0..60_u16 {
        let away = Vec3::new(0.0, 0.0, 0.03 * trig::sin_cos(0.2 * f32::from(frame + 1)).0);
        let moved: Vec<Vec3> = positions.iter().map(|&at| at + away).collect();
        body.pose(&moved).expect("as many");
        step(&mut world, &mut body);
        let lowest = world
            .positions()
            .iter()
            .map(|at| at.y)
            .fold(f32::INFINITY, f32::min);
        assert!(0.0 < lowest, "{frame}: {lowest}");
        if 20 < frame {
            let left = deepest(axes, world.positions().iter().map(|&at| at - away));
            assert!(left < 0.002, "{frame}: {left}");
        }
    }
}

#[test]
fn a_body_says_what_is_out_of_its_reach() {
    let (positions, triangles) = egg(Vec3::splat(0.12));
    let mut body = MeshBody::new(&positions, &triangles, 0.01)
        .expect("a body")
        .with_reach(0.03);
    let mut world = patch([9, 9], Vec3::Y * 0.08);
    let depths = step(&mut world, &mut body);
    assert_eq!(depths.reach, 0.03);
    assert!(
        0 < depths.out_of_reach && depths.out_of_reach < depths.deep,
        "{depths:?}"
    );
    assert!(SKIN_REACH < depths.deepest && depths.deepest < 0.03);
}

#[test]
fn where_a_body_overlaps_itself_nothing_is_touched() {
    let (mut positions, mut triangles) = egg(Vec3::splat(0.12));
    let other = egg(Vec3::splat(0.12));
    let first = u32::try_from(positions.len()).expect("few");
    positions.extend(other.0.iter().map(|&at| at + Vec3::X * 0.1));
    triangles.extend(other.1.iter().map(|it| it.map(|corner| corner + first)));
    let body = MeshBody::new(&positions, &triangles, 0.01).expect("a body");
    for surfel in body.surfels() {
        let middles = [Vec3::ZERO, Vec3::X * 0.1];
        let depth = middles.map(|middle| 0.12 - surfel.position.distance(middle));
        let depth = depth[0].max(depth[1]);
        assert!(!surfel.is_withdrawn() || 0.0 < depth, "{surfel:?}");
        assert!(surfel.is_withdrawn() || depth < 0.02, "{surfel:?}");
    }
    assert!(body.surfels().iter().any(Surfel::is_withdrawn));
    // Where both are, no way leads out.
    let mut body = body;
    let mut world = patch([3, 3], Vec3::X * 0.05);
    let depths = step(&mut world, &mut body);
    assert_eq!((depths.covered, depths.deep), (9, 0));
}

#[test]
fn cloth_is_let_through_what_it_does_not_meet() {
    let (positions, triangles) = egg(Vec3::splat(0.12));
    let met = positions.iter().map(|at| at.y < 0.0).collect();
    let body = MeshBody::new(&positions, &triangles, 0.01).expect("a body");
    let mut body = body.with_met(met);
    let above = |surfel: &Surfel| 0.03 < surfel.position.y;
    assert!(
        body.surfels()
            .iter()
            .all(|it| !above(it) || it.is_withdrawn())
    );
    assert!(body.surfels().iter().any(|it| !it.is_withdrawn()));
    let mut world = patch([9, 9], Vec3::Y * 0.08);
    let before = world.positions();
    assert_eq!(step(&mut world, &mut body).deep, 0);
    for (now, before) in world.positions().iter().zip(&before) {
        assert!(now.distance(*before) < 1e-6, "{now} {before}");
    }
}

#[test]
fn cloth_beside_a_body_is_let_alone_to_the_last_bit() {
    let (positions, triangles) = egg(Vec3::splat(0.12));
    let mut body = MeshBody::new(&positions, &triangles, 0.01).expect("a body");
    let hashes = [2, 0].map(|looks| {
        let mut world = patch([25, 25], Vec3::Y * 0.14);
        world.config.gravity = Vec3::NEG_Y * 9.81;
        for _ in 0..40 {
            for _ in 0..looks {
                assert_eq!(body.look(&world.model, &mut world.state).deep, 0);
            }
            step_alone(&mut world, &body);
        }
        mesh_state_hash(&world.state)
    });
    assert_eq!(hashes[0], hashes[1]);
}

#[test]
fn a_mesh_that_is_turned_inside_out_is_the_same_body() {
    let (positions, mut triangles) = egg(Vec3::splat(0.12));
    triangles.iter_mut().for_each(|it| it.swap(0, 1));
    let turned = MeshBody::new(&positions, &triangles, 0.01).expect("a body");
    for surfel in turned.surfels() {
        assert!(0.9 < surfel.normal.dot(surfel.position) / 0.12);
    }
}

#[test]
fn every_mistake_in_a_body_has_its_sentence() {
    let (positions, triangles) = egg(Vec3::splat(0.12));
    let complaint = |positions: &[Vec3], triangles: &[[u32; 3]], spacing: f32| {
        let refused = MeshBody::new(positions, triangles, spacing);
        refused.expect_err("a mistake").to_string()
    };
    let mut nowhere = positions.clone();
    nowhere[7].y = f32::NAN;
    let mut body = MeshBody::new(&positions, &triangles, 0.01).expect("a body");
    let cases = [
        (
            complaint(&[], &triangles, 0.01),
            "the body has 0 vertices and 1152 triangles; give it some",
        ),
        (
            complaint(&positions, &[[0, 1, 999]], 0.01),
            "triangle 0 of the body names vertex 999, and there are 600",
        ),
        (
            complaint(&nowhere, &triangles, 0.01),
            "vertex 7 of the body is at",
        ),
        (
            complaint(&positions, &triangles, f32::NAN),
            "the points of the body are to be NaN m apart; make that more than 0",
        ),
        (
            body.pose(&positions[1..])
                .expect_err("one less")
                .to_string(),
            "the body has 599 vertices now and had 600; a body keeps its vertices",
        ),
        (
            body.pose(&nowhere).expect_err("nowhere").to_string(),
            "vertex 7 of the body is at",
        ),
    ];
    for (found, expected) in cases {
        assert!(found.starts_with(expected), "{found}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_body_is_built_or_refused_and_cloth_in_it_stays_a_number(
        places in prop::collection::vec([-0.2_f32..0.2, -0.2..0.2, -0.2..0.2], 1..24),
        triangles in prop::collection::vec([0_u32..24, 0..24, 0..24], 0..40),
        shift in -0.05_f32..0.05,
    ) {
        let places: Vec<Vec3> = places.into_iter().map(Vec3::from_array).collect();
        let Ok(mut body) = MeshBody::new(&places, &triangles, 0.02) else {
            return Ok(());
        };
        let mut world = patch([9, 9], Vec3::ZERO);
        for _ in 0..4 {
            let moved: Vec<Vec3> = places.iter().map(|&at| at + Vec3::splat(shift)).collect();
            prop_assert!(body.pose(&moved).is_ok());
            let depths = step(&mut world, &mut body);
            prop_assert!(depths.out_of_reach <= depths.deep && depths.deep <= 81);
        }
        prop_assert!(world.positions().iter().all(|it| it.is_finite()));
    }
}
