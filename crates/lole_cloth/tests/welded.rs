//! Laws of pieces that are welded to one surface, each triangle of which is laid flat by itself.

mod mesh_support;

use std::f32::consts::{FRAC_PI_4, TAU};

use glam::{Mat2, Quat, Vec2, Vec3, Vec3Swizzles as _};
use lole_cloth::mesh::{MeshModel, MeshSpec, diagnose};
use lole_cloth::{InstructionSet, SolverConfig, mesh_state_hash};
use lole_geom::{Capsule, trig};
use proptest::prelude::*;

use mesh_support::{Dice, FABRIC, World, rectangle, turned};

/// A flat piece as if it were welded of its triangles: each is moved somewhere, and turned by half a turn,
/// mirrored across its warp, or left.
fn scattered(flat: &[Vec2], triangles: &[[u32; 3]]) -> Vec<[Vec2; 3]> {
    let mut dice = Dice::new(11);
    let corners = triangles.iter().enumerate();
    let scatter = |(index, triangle): (usize, &[u32; 3])| {
        let by = Vec2::new(dice.throw(), dice.throw());
        let turn = [Vec2::ONE, Vec2::NEG_ONE, Vec2::new(1.0, -1.0)][index % 3];
        triangle.map(|corner| flat[corner as usize] * turn + by)
    };
    corners.map(scatter).collect()
}

/// The same piece given flat, and given triangle by triangle.
fn both(flat: &[Vec2], triangles: &[[u32; 3]]) -> [MeshSpec; 2] {
    let corners = scattered(flat, triangles);
    [
        MeshSpec::new(flat.to_vec(), triangles.to_vec(), FABRIC),
        MeshSpec::welded(flat.len(), triangles.to_vec(), corners, FABRIC),
    ]
}

/// A tube around the upright axis, wider below: places, triangles and how many stand in a ring.
fn tube(
    around: u16,
    along: u16,
    [top, bottom]: [f32; 2],
    height: f32,
) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let mut positions = Vec::new();
    for row in 0..=along {
        let share = f32::from(row) / f32::from(along);
        let radius = top + (bottom - top) * share;
        positions.extend((0..around).map(|column| {
            let (sin, cos) = trig::sin_cos(TAU * f32::from(column) / f32::from(around));
            Vec3::new(radius * cos, -height * share, radius * sin)
        }));
    }
    let at = |row: u16, column: u16| u32::from(row * around + column % around);
    let mut triangles = Vec::new();
    for (row, column) in (0..along).flat_map(|row| (0..around).map(move |it| (row, it))) {
        let [a, b] = [at(row, column), at(row, column + 1)];
        let [c, d] = [at(row + 1, column), at(row + 1, column + 1)];
        if (row + column) % 2 == 0 {
            triangles.extend([[a, b, d], [a, d, c]]);
        } else {
            triangles.extend([[a, b, c], [b, d, c]]);
        }
    }
    (positions, triangles)
}

/// The strip of `mesh_laws.rs`, welded: how much longer it gets [1].
fn stretch_of_strip(turn: f32, jitter: f32, [stretch, shear]: [f32; 2]) -> f32 {
    let (flat, triangles) = rectangle(6, 16, 0.02, jitter);
    let positions: Vec<Vec3> = (flat.iter())
        .map(|flat| Vec3::new(flat.x, -flat.y, 0.0))
        .collect();
    let [_, mut spec] = both(&turned(&flat, turn), &triangles);
    spec.fabric.stretch = [stretch; 2];
    spec.fabric.shear = shear;
    spec.fabric.drag_rate = 4.0;
    spec.pinned[..6].fill(true);
    let mut world = World::new(&spec, &positions).untethered().with_substeps(60);
    for _ in 0..180 {
        world.step(&[]);
    }
    let sunk: Vec<f32> = (world.positions().iter().zip(&positions))
        .map(|(now, start)| start.y - now.y)
        .collect();
    let depth = |row: usize| sunk[6 * row..][..6].iter().sum::<f32>() / 6.0;
    (depth(15) - depth(5)) / 0.2
}

#[test]
fn a_welded_strip_stretches_by_its_moduli_along_its_yarns_and_across_them() {
    // ρ g L / 2 Y, and on the bias 4 / Y_45 = 2 / Y + 1 / G.
    for jitter in [0.0, 0.5] {
        let along = stretch_of_strip(0.0, jitter, [15.0, 5.0]) / (0.15 * 9.81 * 0.2 / 30.0) - 1.0;
        assert!(along.abs() < 0.025, "jitter {jitter}: {along}");
        let modulus = 4.0 / (2.0 / 60.0 + 1.0 / 6.0);
        let expected = 0.15 * 9.81 * 0.2 / (2.0 * modulus);
        let bias = stretch_of_strip(FRAC_PI_4, jitter, [60.0, 6.0]) / expected - 1.0;
        assert!(bias.abs() < 0.05, "jitter {jitter}: {bias}");
    }
}

/// Height over width of the strip of `mesh_laws.rs`, given flat and welded.
fn heights_over_widths(jitter: f32, turn: f32, stiffness: [f32; 2]) -> [f32; 2] {
    let (length, spacing) = (0.2, 0.02);
    let (flat, triangles) = rectangle(5, 12, spacing, jitter);
    let positions: Vec<Vec3> = (flat.iter())
        .map(|flat| Vec3::new(flat.y - spacing, 0.0, flat.x))
        .collect();
    both(&turned(&flat, turn), &triangles).map(|mut spec| {
        let weight = spec.fabric.areal_density * 9.81;
        let rigidity = weight * length * length * length / 8.0;
        spec.fabric.bend = stiffness.map(|share| share * rigidity);
        spec.fabric.twist = rigidity;
        spec.fabric.stretch = [4e3 * weight * length; 2];
        spec.fabric.drag_rate = 17.0;
        spec.pinned[..10].fill(true);
        let mut world = World::new(&spec, &positions).untethered().with_substeps(40);
        for _ in 0..180 {
            world.step(&[]);
        }
        let tip = world.positions()[world.model.particle_count() - 3];
        -tip.y / tip.x
    })
}

#[test]
fn a_welded_strip_bends_as_it_does_given_flat() {
    // With either yarn the stiffer one: warp must lie where it lay.
    let cases = [0.0, 0.5]
        .into_iter()
        .flat_map(|jitter| [0.0, 0.4, 2.0 * FRAC_PI_4].map(|turn| (jitter, turn)));
    for (jitter, turn) in cases {
        for stiffness in [[1.0, 1.0], [3.0, 0.5]] {
            let [flat, welded] = heights_over_widths(jitter, turn, stiffness);
            let error = welded / flat - 1.0;
            assert!(
                error.abs() < 0.005,
                "{jitter} {turn} {stiffness:?}: {flat} {welded}"
            );
        }
    }
}

#[test]
fn a_welded_sheet_hangs_like_the_flat_one_with_strides_and_tethers() {
    let (flat, triangles) = rectangle(40, 40, 0.02, 0.5);
    let positions: Vec<Vec3> = (flat.iter()).map(|it| Vec3::new(it.x, 0.0, it.y)).collect();
    let found = both(&flat, &triangles).map(|mut spec| {
        spec.fabric.stretch = [4500.0, 2800.0];
        spec.pinned[0] = true;
        spec.pinned[39] = true;
        let mut world = World::new(&spec, &positions);
        world.config.row_strides = vec![8, 4];
        world.config.column_strides = vec![8, 4];
        for _ in 0..120 {
            world.step(&[]);
        }
        let strain = diagnose::strain(&world.model, &world.positions());
        (world.positions(), strain)
    });
    let [(_, flat), (_, welded)] = &found;
    assert!(welded.p99 < 1.3 * flat.p99 + 0.002, "{flat:?} {welded:?}");
    let ends = found.each_ref().map(|(positions, _)| positions[1599]);
    assert!(ends[0].distance(ends[1]) < 0.03, "{ends:?}");
}

#[test]
fn lengths_on_a_welded_piece_are_those_of_the_flat_one() {
    let (flat, triangles) = rectangle(12, 9, 0.02, 0.4);
    let models = both(&flat, &triangles).map(|spec| MeshModel::new(&spec).expect("a surface"));
    let [plane, welded] = &models;
    let masses = models.each_ref().map(MeshModel::particle_masses);
    for (one, other) in masses[0].iter().zip(&masses[1]) {
        assert!((one / other - 1.0).abs() < 1e-4);
    }
    for (first, second) in
        (0..108_u32).flat_map(|it| [(it, (it + 1) % 108), (it, (7 * it + 50) % 108)])
    {
        let [straight, way] = [plane, welded].map(|model| model.flat_distance([first, second]));
        // Along edges and across them a way is a little longer than straight.
        assert!(
            straight * 0.999 <= way && way <= straight * 1.12 + 1e-6,
            "{straight} {way}"
        );
    }
    let moved: Vec<Vec3> = flat
        .iter()
        .map(|it| Vec3::new(it.x * 1.1, it.x * it.y, it.y))
        .collect();
    for triangle in 0..plane.triangles().len() {
        let [one, other] =
            [plane, welded].map(|model| diagnose::deformation_of(model, triangle, &moved));
        for (one, other) in one.into_iter().zip(other) {
            let apart = one.distance(other).min(one.distance(-other));
            assert!(apart < 1e-3, "{one} {other}");
        }
    }
}

/// Cloth that bends by nothing, in the shape in which it was made.
fn unbent(fabric: lole_cloth::Fabric) -> lole_cloth::Fabric {
    lole_cloth::Fabric {
        bend: [0.0; 2],
        twist: 0.0,
        ..fabric
    }
}

#[test]
fn a_surface_that_moves_rigidly_is_strained_by_nothing_and_feels_no_force() {
    let (rest, triangles) = tube(40, 20, [0.1, 0.25], 0.5);
    let warps = [Vec3::Y, Vec3::X, Vec3::ZERO, Vec3::new(1.0, 2.0, 3.0)];
    for warp in warps {
        let spec = MeshSpec::of_surface(&rest, triangles.clone(), |_| warp, unbent(FABRIC));
        let turn = Quat::from_rotation_x(0.7) * Quat::from_rotation_y(2.0);
        let placed: Vec<Vec3> = rest.iter().map(|&at| turn * at).collect();
        let mut world = World::new(&spec, &placed);
        world.config.gravity = Vec3::ZERO;
        world.config.row_strides = vec![8, 3];
        let start = diagnose::strain(&world.model, &placed);
        assert!(start.max < 1e-4, "{start:?}");
        world
            .state
            .set_velocities(&world.model, &vec![Vec3::new(0.3, 0.2, -0.1); rest.len()]);
        for _ in 0..60 {
            world.step(&[]);
        }
        for (now, start) in world.positions().iter().zip(&placed) {
            let gone = *now - *start - Vec3::new(0.3, 0.2, -0.1);
            assert!(gone.length() < 5e-3, "{warp}: {gone}");
        }
    }
}

#[test]
fn what_is_bent_at_rest_keeps_its_shape_and_springs_back_to_it() {
    let (rest, triangles) = tube(40, 20, [0.08, 0.12], 0.3);
    let fabric = lole_cloth::Fabric {
        bend: [2e-3; 2],
        twist: 2e-3,
        drag_rate: 6.0,
        ..FABRIC
    };
    let flat = MeshSpec::of_surface(&rest, triangles, |_| Vec3::Y, fabric);
    let bent = flat.clone().bent_at(rest.clone());
    let turn = Quat::from_rotation_x(0.7) * Quat::from_rotation_y(2.0);
    let placed: Vec<Vec3> = rest.iter().map(|&at| turn * at).collect();
    let pressed: Vec<Vec3> = (rest.iter())
        .map(|&at| turn * Vec3::new(at.x * 0.8, at.y, at.z * 1.18))
        .collect();
    // How far it is at the end from its own shape, as a share of its radius.
    let away = |spec: &MeshSpec, start: &[Vec3]| {
        let mut world = World::new(spec, start).with_substeps(30);
        world.config.gravity = Vec3::ZERO;
        world.config.column_strides.clear();
        for _ in 0..90 {
            world.step(&[]);
        }
        let radius = |at: Vec3| at.with_y(0.0).length();
        let now = world.positions();
        let gaps = (now.iter().zip(&rest))
            .map(|(&now, &rest)| (radius(turn.inverse() * now) / radius(rest) - 1.0).abs());
        gaps.fold(0.0, f32::max)
    };
    let kept = away(&bent, &placed);
    assert!(kept < 0.002, "{kept}");
    // Pressed flatter by a third it is round again; what is flat at rest is no tube by itself.
    let [sprung, limp] = [&bent, &flat].map(|spec| away(spec, &pressed));
    assert!(sprung < 0.02 && 2.0 * sprung < limp, "{sprung} {limp}");
}

#[test]
fn a_piece_that_is_bent_flat_at_rest_bends_like_any() {
    let (flat, triangles) = rectangle(5, 12, 0.02, 0.5);
    let positions: Vec<Vec3> = flat.iter().map(|it| Vec3::new(it.y, 0.0, it.x)).collect();
    let tips = [false, true].map(|is_bent| {
        let mut spec = MeshSpec::new(flat.clone(), triangles.clone(), FABRIC);
        if is_bent {
            spec = spec.bent_at(positions.iter().map(|at| at.yzx() * 1.0).collect());
        }
        spec.fabric.bend = [1e-3, 3e-4];
        spec.fabric.drag_rate = 10.0;
        spec.pinned[..10].fill(true);
        let mut world = World::new(&spec, &positions).untethered().with_substeps(40);
        for _ in 0..120 {
            world.step(&[]);
        }
        world.positions()[57]
    });
    assert!(tips[0].y < -0.01, "{tips:?}");
    assert!(tips[0].distance(tips[1]) < 1e-3, "{tips:?}");
}

#[test]
fn a_welded_tube_hangs_whole() {
    let (rest, triangles) = tube(60, 50, [0.1, 0.3], 0.8);
    let mut spec = MeshSpec::of_surface(&rest, triangles, |_| Vec3::Y, FABRIC);
    spec.fabric.stretch = [4500.0, 2800.0];
    spec.pinned[..60].fill(true);
    let mut world = World::new(&spec, &rest);
    for frame in 0..120 {
        world.step(&[]);
        let strain = diagnose::strain(&world.model, &world.positions());
        assert!(strain.p99 < 0.04 && strain.max < 0.1, "{frame}: {strain:?}");
    }
    let lowest = world.positions().iter().map(|at| at.y).fold(0.0, f32::min);
    assert!(-0.84 < lowest && lowest < -0.75, "{lowest}");
}

#[test]
fn a_welded_tube_falls_on_a_thigh_and_meets_itself_without_being_torn() {
    let (rest, triangles) = tube(80, 30, [0.12, 0.2], 0.3);
    let spec = MeshSpec::of_surface(&rest, triangles, |_| Vec3::Y, FABRIC);
    let mut world = World::new(&spec, &rest);
    world.config = world.model.settings();
    let thigh = [Capsule::uniform(
        Vec3::new(-0.3, -0.5, 0.0),
        Vec3::new(0.3, -0.5, 0.0),
        0.08,
    )];
    for frame in 0..100 {
        world.step(&thigh);
        let positions = world.positions();
        assert_eq!(
            diagnose::self_crossings(&world.model, &positions),
            Some(0),
            "{frame}"
        );
        let strain = diagnose::strain(&world.model, &positions);
        // It falls on its hem at 1.5 m/s, and crumples as finely as its cells.
        let most = if frame < 60 { 0.6 } else { 0.12 };
        assert!(strain.p99 < most, "{frame}: {strain:?}");
    }
}

#[test]
fn the_bits_of_a_welded_piece_are_the_same_on_any_threads_and_vector_instructions() {
    let run = |set: InstructionSet| {
        let (rest, triangles) = tube(60, 40, [0.1, 0.3], 0.6);
        let spec = MeshSpec::of_surface(&rest, triangles, |_| Vec3::Y, FABRIC);
        let mut spec = spec.bent_at(rest.clone());
        spec.pinned[..60].fill(true);
        let mut world = World::new(&spec, &rest);
        world.config = SolverConfig {
            instruction_set: set,
            row_strides: vec![3],
            self_collision: Some(lole_cloth::SelfCollision {
                radius: 0.002,
                substep_interval: std::num::NonZeroU32::MIN,
                crossings: lole_cloth::Crossings::Repair,
            }),
            ..SolverConfig::default()
        };
        for _ in 0..20 {
            world.step(&[Capsule::uniform(Vec3::NEG_Y, Vec3::Y, 0.12)]);
        }
        mesh_state_hash(&world.state)
    };
    let sets = InstructionSet::ALL;
    let mut hashes = Vec::new();
    for thread_count in [1, 2, 5] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(thread_count);
        let pool = pool.build().expect("threads");
        hashes.extend(sets.map(|set| pool.install(|| run(set))));
    }
    assert!(hashes.iter().all(|&hash| hash == hashes[0]), "{hashes:?}");
}

fn complaint(change: impl FnOnce(&mut MeshSpec)) -> String {
    let (flat, triangles) = rectangle(4, 4, 0.1, 0.0);
    let [_, mut spec] = both(&flat, &triangles);
    change(&mut spec);
    MeshModel::new(&spec).expect_err("a mistake").to_string()
}

#[test]
fn every_mistake_in_a_welded_mesh_has_its_sentence() {
    let cases: Vec<(String, &str)> = vec![
        (
            complaint(|spec| spec.flat_corners.truncate(3)),
            "`flat_corners` has 3 entries; the mesh needs 18",
        ),
        (
            complaint(|spec| spec.flat_positions = vec![Vec2::ZERO; 16]),
            "`flat_positions` has 16 entries; the mesh needs 0",
        ),
        (
            complaint(|spec| spec.flat_corners[2][1].y = f32::INFINITY),
            "corner 1 of triangle 2 lies at",
        ),
        (
            complaint(|spec| spec.bent_positions = vec![Vec3::ZERO; 3]),
            "`bent_positions` has 3 entries; the mesh needs 16",
        ),
        (
            complaint(|spec| spec.bent_positions = vec![Vec3::NAN; 16]),
            "particle 0 lies at [NaN, NaN, NaN] in the bent piece; give it a finite place",
        ),
        (
            complaint(|spec| spec.triangles[2] = [0, 1, 99]),
            "triangle 2 names particle 99, and there are 16",
        ),
        (
            complaint(|spec| spec.triangles[2] = [1, 5, 1]),
            "triangle 2 names particle 1 twice; remove it",
        ),
        (
            complaint(|spec| spec.flat_corners[4] = [Vec2::ZERO, Vec2::X, Vec2::X * 2.0]),
            "triangle 4 is 0 m high over a side of 2 m; remove it or move a corner",
        ),
        (
            complaint(|spec| {
                spec.layers.push(1.0);
                spec.pinned.push(false);
            }),
            "particle 16 belongs to no triangle and would weigh nothing; remove it",
        ),
        (
            complaint(|spec| {
                spec.triangles.push(spec.triangles[0]);
                spec.flat_corners.push(spec.flat_corners[0]);
            }),
            "3 triangles share the edge of particles 0 and 5; cloth has at most two there",
        ),
        (
            moebius(),
            "the surface has no two sides: around the edge of particles",
        ),
        (
            touching_tetrahedra(),
            "parts of the mesh hang together by particle 0 alone; give each part its own and sew them",
        ),
    ];
    for (found, expected) in cases {
        assert!(found.starts_with(expected), "{found}");
    }
}

fn refused(particle_count: usize, triangles: Vec<[u32; 3]>) -> String {
    let corners = vec![[Vec2::ZERO, Vec2::X, Vec2::Y]; triangles.len()];
    let spec = MeshSpec::welded(particle_count, triangles, corners, FABRIC);
    MeshModel::new(&spec).expect_err("a mistake").to_string()
}

/// A band of eleven triangles that is turned over once.
fn moebius() -> String {
    refused(
        11,
        (0..11)
            .map(|it| [it, (it + 1) % 11, (it + 2) % 11])
            .collect(),
    )
}

/// Two closed surfaces that share a corner.
fn touching_tetrahedra() -> String {
    let sides = [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]];
    let beyond = sides.map(|side| side.map(|it| if it == 0 { 0 } else { it + 3 }));
    refused(7, sides.into_iter().chain(beyond).collect())
}

/// The corners of a triangle of a number of kinds: whole, of no area, of one place, infinite, huge.
fn corners_of(kind: u8) -> [Vec2; 3] {
    let whole = [Vec2::ZERO, Vec2::X * 0.02, Vec2::new(0.01, 0.02)];
    match kind {
        0 => [Vec2::ZERO, Vec2::X, Vec2::X * 2.0],
        1 => [Vec2::ONE; 3],
        2 => [Vec2::NAN, Vec2::X, Vec2::Y],
        3 => whole.map(|it| it * 1e20),
        4 => whole.map(|it| it * 1e-30),
        5 => whole.map(|it| Vec2::new(it.x, -it.y)),
        _ => whole.map(|it| Mat2::from_angle(f32::from(kind)) * it + Vec2::splat(f32::from(kind))),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_list_of_triangles_is_built_or_refused_with_a_sentence(
        particle_count in 0_usize..14,
        triangles in prop::collection::vec([0_u32..14, 0..14, 0..14], 0..24),
        kinds in prop::collection::vec(0_u8..60, 24),
    ) {
        let corners = (0..triangles.len()).map(|it| corners_of(kinds[it])).collect();
        let spec = MeshSpec::welded(particle_count, triangles, corners, FABRIC);
        if let Err(error) = MeshModel::new(&spec) {
            let sentence = error.to_string();
            prop_assert!(!sentence.contains('\n') && 20 < sentence.len(), "{}", sentence);
        }
    }

    #[test]
    fn any_welded_surface_steps_without_a_number_that_is_none(
        around in 3_u16..12,
        along in 1_u16..8,
        bulge in 0.02_f32..0.5,
        kinds in prop::collection::vec(5_u8..60, 200),
        is_of_surface in any::<bool>(),
    ) {
        let (rest, triangles) = tube(around, along, [0.05, bulge], 0.2);
        let corners = (0..triangles.len()).map(|it| corners_of(kinds[it % 200])).collect();
        let spec = if is_of_surface {
            MeshSpec::of_surface(&rest, triangles, |_| Vec3::X, FABRIC)
        } else {
            MeshSpec::welded(rest.len(), triangles, corners, FABRIC)
        };
        let mut world = World::new(&spec, &rest);
        world.config.row_strides = vec![4];
        for _ in 0..4 {
            let outcome = world.try_step(&[]);
            prop_assert_eq!(outcome, Ok(()));
        }
        prop_assert!(world.positions().iter().all(|it| it.is_finite()));
    }
}
