//! Laws of a piece of triangles: its moduli, its bending, momentum, contact, and the same bits.

mod mesh_support;

use std::f32::consts::FRAC_PI_4;

use glam::{DVec3, Vec2, Vec3};
use lole_cloth::mesh::{MeshSpec, diagnose};
use lole_cloth::{InstructionSet, SolverConfig, mesh_state_hash};
use lole_geom::{Capsule, trig};
use mesh_support::{Dice, FABRIC, World, rectangle, turned};

/// How much longer [1] the lower two thirds of a strip of 6 by 16 particles get that hangs from its
/// first row, with its yarns `turn` off its sides. The upper third keeps the clamp's width.
fn stretch_of_strip(turn: f32, jitter: f32, [stretch, shear]: [f32; 2]) -> f32 {
    let (flat, triangles) = rectangle(6, 16, 0.02, jitter);
    let positions: Vec<Vec3> = flat
        .iter()
        .map(|flat| Vec3::new(flat.x, -flat.y, 0.0))
        .collect();
    let mut spec = MeshSpec::new(turned(&flat, turn), triangles, FABRIC);
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
fn a_hanging_strip_stretches_by_its_modulus_whatever_the_mesh() {
    // A strip under its own weight: ρ g L / 2 Y. So soft a cloth, because the
    // real-time method's stretch converges with the substep: by `Y h² / (ρ spacing²)`.
    let stretch = 15.0;
    let expected = 0.15 * 9.81 * 0.2 / (2.0 * stretch);
    for (turn, jitter) in [
        (0.0, 0.0),
        (2.0 * FRAC_PI_4, 0.0),
        (0.0, 0.5),
        (2.0 * FRAC_PI_4, 0.5),
    ] {
        let found = stretch_of_strip(turn, jitter, [stretch, 5.0]);
        let error = found / expected - 1.0;
        assert!(error.abs() < 0.025, "turn {turn}, jitter {jitter}: {error}");
    }
}

#[test]
fn a_strip_on_the_bias_stretches_by_its_shear_modulus() {
    // 4 / Y_45 = 1 / Y_u + 1 / Y_v + 1 / G, the rotation of the plane compliance with ν = 0.
    let (stretch, shear) = (60.0, 6.0);
    let modulus = 4.0 / (2.0 / stretch + 1.0 / shear);
    let expected = 0.15 * 9.81 * 0.2 / (2.0 * modulus);
    for jitter in [0.0, 0.5] {
        let found = stretch_of_strip(FRAC_PI_4, jitter, [stretch, shear]);
        let error = found / expected - 1.0;
        assert!(error.abs() < 0.05, "jitter {jitter}: {error}");
    }
}

/// Height over width of a clamped strip of this `Γ = w L³ / B` in so many segments, yarns along it
/// (`turn` 0) or across.
fn height_over_width(gamma: f32, segments: u16, (jitter, turn): (f32, f32), layers: f32) -> f32 {
    let length = 0.2;
    let spacing = length / f32::from(segments);
    let rows = u32::from(segments) + 2;
    let (flat, triangles) = rectangle(5, rows, spacing, jitter);
    let positions: Vec<Vec3> = (flat.iter())
        .map(|flat| Vec3::new(flat.y - spacing, 0.0, flat.x))
        .collect();
    let mut spec = MeshSpec::new(turned(&flat, turn), triangles, FABRIC);
    let weight = spec.fabric.areal_density * 9.81;
    let rigidity = weight * length * length * length / gamma;
    spec.fabric.bend = [rigidity; 2];
    spec.fabric.twist = rigidity;
    spec.fabric.stretch = [4e3 * weight * length; 2];
    spec.fabric.drag_rate = 17.0;
    spec.layers.fill(layers);
    spec.pinned[..10].fill(true);
    let mut world = World::new(&spec, &positions).untethered().with_substeps(40);
    for _ in 0..180 {
        world.step(&[]);
    }
    let tip = world.positions()[world.model.particle_count() - 3];
    -tip.y / tip.x
}

#[test]
fn a_clamped_strip_hangs_like_the_elastica_on_any_mesh() {
    // Γ = 8 hangs at 0.88433 (the heavy elastica).
    for (jitter, turn) in [
        (0.0, 0.0),
        (0.0, 2.0 * FRAC_PI_4),
        (0.0, FRAC_PI_4),
        (0.5, 0.0),
        (0.5, FRAC_PI_4),
    ] {
        let error = height_over_width(8.0, 10, (jitter, turn), 1.0) / 0.88433 - 1.0;
        assert!(error.abs() < 0.04, "jitter {jitter}, turn {turn}: {error}");
    }
}

/// Layers that slide on each other weigh and bend as many times as much as one.
#[test]
fn loose_layers_hang_as_one_does() {
    for layers in [2.0, 3.0] {
        let error = height_over_width(8.0, 10, (0.5, 0.0), layers) / 0.88433 - 1.0;
        assert!(error.abs() < 0.04, "{layers} layers: {error}");
    }
}

#[test]
fn momentum_is_kept_without_gravity() {
    let (flat, triangles) = rectangle(12, 12, 0.02, 0.5);
    let spec = MeshSpec::new(flat.clone(), triangles, FABRIC);
    let mut dice = Dice::new(3);
    let positions: Vec<Vec3> = (flat.iter())
        .map(|flat| Vec3::new(flat.x, 0.01 * dice.throw(), flat.y))
        .collect();
    let mut world = World::new(&spec, &positions);
    world.config.gravity = Vec3::ZERO;
    world.config.row_strides = vec![4];
    let velocities: Vec<Vec3> = (flat.iter())
        .map(|_| Vec3::new(dice.throw(), dice.throw(), dice.throw()) + Vec3::X)
        .collect();
    world.state.set_velocities(&world.model, &velocities);
    let masses = world.model.particle_masses();
    let momentum = |velocities: &[Vec3]| -> DVec3 {
        let terms = velocities.iter().zip(&masses);
        terms
            .map(|(velocity, &mass)| velocity.as_dvec3() * f64::from(mass))
            .sum()
    };
    let before = momentum(&world.velocities());
    for _ in 0..30 {
        world.step(&[]);
    }
    let change = (momentum(&world.velocities()) - before).length() / before.length();
    assert!(change < 1e-4, "{change}");
}

#[test]
fn turning_the_world_turns_the_cloth() {
    // Bending and strain know no direction in space.
    let (flat, triangles) = rectangle(10, 10, 0.02, 0.4);
    let mut spec = MeshSpec::new(flat.clone(), triangles, FABRIC);
    spec.pinned[..10].fill(true);
    let run = |turn: glam::Quat| {
        let positions: Vec<Vec3> = (flat.iter())
            .map(|flat| turn * Vec3::new(flat.x, 0.0, flat.y))
            .collect();
        let mut world = World::new(&spec, &positions);
        world.config.gravity = turn * world.config.gravity;
        for _ in 0..20 {
            world.step(&[]);
        }
        world.positions()
    };
    let turn = glam::Quat::from_xyzw(0.3, -0.2, 0.5, 0.78).normalize();
    let (straight, turned) = (run(glam::Quat::IDENTITY), run(turn));
    for (straight, turned) in straight.iter().zip(&turned) {
        assert!((turn * *straight).distance(*turned) < 2e-4);
    }
}

/// A disc of rings around a middle particle: valences from 4 to 8, no rows and no columns.
fn disc(ring_count: u32, spacing: f32) -> (Vec<Vec2>, Vec<[u32; 3]>) {
    let mut flat = vec![Vec2::ZERO];
    let mut triangles = Vec::new();
    let mut inner = vec![0_u32];
    for ring in 1..=ring_count {
        let count = 6 * ring;
        let first = 1 + 3 * ring * (ring - 1);
        let outer: Vec<u32> = (first..first + count).collect();
        flat.extend((0..count).map(|k| {
            let turn = std::f32::consts::TAU * k as f32 / count as f32;
            let (sin, cos) = trig::sin_cos(turn);
            Vec2::new(cos, sin) * (ring as f32 * spacing)
        }));
        // Walks both rings at once, always on where it is behind.
        let (mut i, mut o) = (0, 0);
        while i < inner.len() && 1 < inner.len() || o < outer.len() {
            let (at_i, at_o) = (inner[i % inner.len()], outer[o % outer.len()]);
            let inner_is_behind = (i + 1) * outer.len() <= (o + 1) * inner.len();
            if 1 < inner.len() && i < inner.len() && (inner_is_behind && o != 0 || outer.len() <= o)
            {
                triangles.push([at_i, inner[(i + 1) % inner.len()], at_o]);
                i += 1;
            } else {
                triangles.push([at_i, at_o, outer[(o + 1) % outer.len()]]);
                o += 1;
            }
        }
        inner = outer;
    }
    (flat, triangles)
}

fn disc_on_a_ball() -> (World, [Capsule; 1]) {
    let (flat, triangles) = disc(20, 0.012);
    let spec = MeshSpec::new(flat.clone(), triangles, FABRIC);
    let positions: Vec<Vec3> = flat
        .iter()
        .map(|flat| Vec3::new(flat.x, 0.12, flat.y))
        .collect();
    let ball = Capsule::uniform(Vec3::new(-0.02, 0.0, 0.0), Vec3::new(0.02, 0.0, 0.0), 0.1);
    (World::new(&spec, &positions), [ball])
}

#[test]
fn a_round_cloth_lies_on_a_ball_and_not_in_it() {
    let (mut world, ball) = disc_on_a_ball();
    for frame in 0..120 {
        world.step(&ball);
        let positions = world.positions();
        let deepest = positions
            .iter()
            .map(|&p| -ball[0].signed_distance(p))
            .fold(0.0, f32::max);
        assert!(deepest < 1e-5, "frame {frame}: {deepest} m deep");
    }
    // It hangs down around the ball, and is hardly stretched.
    let positions = world.positions();
    let lowest = positions.iter().map(|p| p.y).fold(f32::INFINITY, f32::min);
    assert!(
        lowest < -0.03 && positions[0].distance(Vec3::new(0.0, 0.1, 0.0)) < 0.02,
        "{lowest}"
    );
    let strain = diagnose::strain(&world.model, &positions);
    assert!(strain.mean < 0.02, "{strain:?}");
}

#[test]
fn all_vector_instructions_give_the_same_bits() {
    let hashes = [
        InstructionSet::Detected,
        InstructionSet::Wide,
        InstructionSet::Baseline,
    ]
    .map(|set| {
        let (mut world, ball) = disc_on_a_ball();
        world.config = SolverConfig {
            instruction_set: set,
            row_strides: vec![3],
            ..SolverConfig::default()
        };
        for _ in 0..20 {
            world.step(&ball);
        }
        mesh_state_hash(&world.state)
    });
    assert_eq!(hashes[0], hashes[1]);
    assert_eq!(hashes[0], hashes[2]);
}

#[test]
fn strides_and_tethers_hold_a_sheet_of_any_mesh_as_they_hold_the_grid() {
    // The scene `hang-64`: the grid's strain at the end is 0.13 % on the mean, 1.7 % at most.
    for (jitter, mean, p99) in [(0.0, 0.003, 0.015), (0.5, 0.006, 0.03)] {
        let (flat, triangles) = rectangle(64, 64, 1.2 / 63.0, jitter);
        let mut spec = MeshSpec::new(flat.clone(), triangles, FABRIC);
        spec.fabric.stretch = [4500.0, 2800.0];
        spec.fabric.shear = 90.0;
        spec.fabric.bend = [9e-6, 6e-6];
        spec.fabric.twist = 4e-6;
        spec.fabric.drag_rate = 1.0;
        spec.pinned[0] = true;
        spec.pinned[63] = true;
        let positions: Vec<Vec3> = flat
            .iter()
            .map(|flat| Vec3::new(flat.x, 0.0, flat.y))
            .collect();
        let mut world = World::new(&spec, &positions).with_substeps(4);
        world.config.row_strides = vec![4];
        world.config.column_strides = vec![4];
        for _ in 0..300 {
            world.step(&[]);
        }
        let strain = diagnose::strain(&world.model, &world.positions());
        assert!(
            strain.mean < mean && strain.p99 < p99,
            "jitter {jitter}: {strain:?}"
        );
    }
}
