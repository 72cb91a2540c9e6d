//! Laws of internal friction: residual bend and shear, decay by the loop, momentum, bits.

mod xpbd_support;

use glam::Vec3;
use lole_cloth::scenes::{FRAME_DT, SCENES};
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Fabric, Hysteresis, InstructionSet, MassLaw, StepInput,
    state_hash, step,
};
use lole_geom::trig;
use xpbd_support::{FABRIC, World, mean, sheet_spec};

/// A strip of three columns that only bends down its rows.
fn strip(rows: u32, spacing: f32, fabric: Fabric) -> ClothSpec {
    let mut spec = sheet_spec(3, rows, spacing, fabric);
    spec.mass = MassLaw::AreaWeighted;
    spec
}

/// A strip rolled to a curvature [1/m] about the `x` axis, its middle level.
fn rolled(rows: u32, spacing: f32, curvature: f32) -> Vec<Vec3> {
    // Chords of the circle are as long as the spacing.
    let turn = spacing * curvature;
    let middle = 0.5 * (rows - 1) as f32;
    let mut places = vec![[0.0_f32; 2]];
    for row in 1..rows {
        let angle = turn * (row as f32 - 0.5 - middle);
        let [z, y] = places[places.len() - 1];
        places.push([
            z + spacing * trig::cos(angle),
            y + spacing * trig::sin(angle),
        ]);
    }
    (places.into_iter())
        .flat_map(|[z, y]| (0..3).map(move |column| Vec3::new(column as f32 * spacing, y, z)))
        .collect()
}

/// Mean curvature [1/m] down the middle column, positive as [`rolled`].
fn curvature(positions: &[Vec3], spacing: f32) -> f32 {
    let middle: Vec<Vec3> = positions.chunks(3).map(|row| row[1]).collect();
    let terms = middle.windows(3).map(|points| {
        let second = points[0] + points[2] - points[1] * 2.0;
        let along = (points[2] - points[0]).normalize_or_zero();
        // Upward across the strip.
        let up = along.cross(Vec3::X);
        second.dot(up) / (spacing * spacing)
    });
    terms.sum::<f32>() / (middle.len() - 2) as f32
}

/// A world without gravity, tethers and strides.
fn floating(spec: &ClothSpec, positions: &[Vec3]) -> World {
    let mut world = World::new(spec, positions);
    world.config.gravity = Vec3::ZERO;
    world.config.tether_scale = None;
    world.config.column_strides = Vec::new();
    world
}

#[test]
fn a_rolled_strip_keeps_the_residual_curvature_of_its_friction() {
    for (rows, spacing) in [(11_u32, 0.01_f32), (21, 0.005)] {
        let residual = 6.0;
        let bend = 2.0e-6;
        let fabric = Fabric {
            bend: [bend; 2],
            twist: bend,
            hysteresis: Hysteresis {
                bend: [2.0 * bend * residual; 2],
                shear: 0.0,
            },
            drag_rate: 60.0,
            ..FABRIC
        };
        let start = rolled(rows, spacing, 25.0);
        let mut world = floating(&strip(rows, spacing, fabric), &start);
        for _ in 0..300 {
            world.step(&[]);
        }
        let left = curvature(&world.positions(), spacing);
        assert!(
            (left / residual - 1.0).abs() < 0.05,
            "{rows} rows: {left} 1/m"
        );
    }
}

#[test]
fn a_sheared_patch_keeps_the_residual_angle_of_its_friction() {
    let (residual, shear, spacing) = (0.05, 0.2, 0.02);
    let fabric = Fabric {
        shear,
        bend: [0.0; 2],
        twist: 0.0,
        hysteresis: Hysteresis {
            bend: [0.0; 2],
            shear: 2.0 * shear * residual,
        },
        // Thick enough that it creeps back and does not swing past.
        drag_rate: 200.0,
        ..FABRIC
    };
    let mut spec = sheet_spec(5, 5, spacing, fabric);
    spec.mass = MassLaw::AreaWeighted;
    let start: Vec<Vec3> = (0..25_u8)
        .map(|index| {
            let [row, column] = [index / 5, index % 5].map(f32::from);
            // Columns lean by the angle, their cells as long as ever.
            let (sin, cos) = (trig::sin(0.25), trig::cos(0.25));
            Vec3::new(column + sin * row, 0.0, cos * row) * spacing
        })
        .collect();
    let mut world = floating(&spec, &start);
    for _ in 0..400 {
        world.step(&[]);
    }
    let positions = world.positions();
    let lean = (positions[22] - positions[2]).normalize_or_zero();
    let angle = lean.dot((positions[14] - positions[10]).normalize_or_zero());
    assert!((angle / residual - 1.0).abs() < 0.06, "{angle} rad");
}

/// Turning points of the curvature [1/m] of a strip of three rows that swings freely.
fn turning_points(residual: f32, frames_per_second: u32) -> Vec<f32> {
    const SPACING: f32 = 0.02;
    // `ω² = 8 B / (ρ h⁴)`, about 1.5 swings a second.
    let bend = 2.6e-7;
    let fabric = Fabric {
        bend: [0.0, bend],
        twist: 0.0,
        hysteresis: Hysteresis {
            bend: [0.0, 2.0 * bend * residual],
            shear: 0.0,
        },
        ..FABRIC
    };
    let mut world =
        floating(&strip(3, SPACING, fabric), &rolled(3, SPACING, 6.0)).with_substeps(24);
    let dt = 1.0 / frames_per_second as f32;
    let curvatures: Vec<f32> = (0..3 * frames_per_second)
        .map(|_| {
            let input = StepInput::default();
            step(&world.model, &world.config, &input, &mut world.state, dt)
                .expect("a target for every pin");
            curvature(&world.positions(), SPACING)
        })
        .collect();
    (curvatures.windows(3))
        .filter(|part| (part[1] - part[0]) * (part[2] - part[1]) <= 0.0)
        .map(|part| part[1].abs())
        .collect()
}

#[test]
fn a_swing_loses_the_work_of_friction_and_no_more() {
    let residual = 0.4;
    // Half a swing loses `2 r` of its amplitude, but for the play in which the yarns turn over.
    let play = residual / 1.5;
    for frames_per_second in [60, 120] {
        let amplitudes = turning_points(residual, frames_per_second);
        let free = turning_points(0.0, frames_per_second);
        assert!(0.9 * 6.0 < free[4], "{free:?}");
        let mut expected = 6.0;
        for (index, &found) in amplitudes.iter().take(5).enumerate() {
            let next = expected - 2.0 * residual * (1.0 - 2.0 * play / (2.0 * expected - residual));
            // What the method itself damps.
            let truth = next * free[index] / 6.0;
            assert!(
                (found - truth).abs() < 0.1 * residual * (index + 2) as f32,
                "{frames_per_second} Hz, turn {index}: {found} and not {truth} of {amplitudes:?}, free {free:?}"
            );
            expected = next;
        }
    }
}

/// Amplitudes of the middle of a strip of 20 cm against its ends [m] in the first seconds of a
/// free swing.
fn strip_swing(rows: u32, frames_per_second: u32, residual: f32) -> Vec<f32> {
    let spacing = 0.2 / (rows - 1) as f32;
    let bend = 5.0e-5;
    let fabric = Fabric {
        bend: [0.0, bend],
        twist: 0.0,
        shear: 5.0,
        hysteresis: Hysteresis {
            bend: [0.0, 2.0 * bend * residual],
            shear: 0.0,
        },
        ..FABRIC
    };
    let mut world = floating(&strip(rows, spacing, fabric), &rolled(rows, spacing, 4.0));
    world = world.with_substeps(2400 / frames_per_second);
    let dt = 1.0 / frames_per_second as f32;
    let heights: Vec<f32> = (0..2 * frames_per_second)
        .map(|_| {
            let input = StepInput::default();
            step(&world.model, &world.config, &input, &mut world.state, dt)
                .expect("a target for every pin");
            let positions = world.positions();
            let middle = positions[3 * (rows / 2) as usize + 1];
            let ends = [positions[1], positions[positions.len() - 2]];
            (ends[0] + ends[1]).y * 0.5 - middle.y
        })
        .collect();
    let largest = |part: &[f32]| {
        part.iter()
            .fold(0.0_f32, |most, height| most.max(height.abs()))
    };
    (heights.chunks((frames_per_second / 2) as usize))
        .map(largest)
        .collect()
}

#[test]
fn a_swing_decays_alike_on_two_grids_and_with_two_time_steps() {
    let truth = strip_swing(21, 120, 0.25);
    let free = strip_swing(21, 120, 0.0);
    // Friction takes most of it, the method itself little.
    assert!(truth[3] < 0.5 * free[3], "{truth:?} {free:?}");
    for (rows, rate) in [(21, 60), (11, 120), (11, 60)] {
        let found = strip_swing(rows, rate, 0.25);
        for (found, truth_here) in found.iter().zip(&truth) {
            assert!(
                (found - truth_here).abs() < 0.1 * truth[0],
                "{rows} rows at {rate} Hz: {found} of {truth:?}"
            );
        }
    }
}

/// A fabric with much friction of both kinds.
const RUBBING: Fabric = Fabric {
    hysteresis: Hysteresis {
        bend: [1.0e-3; 2],
        shear: 2.0,
    },
    ..FABRIC
};

#[test]
fn a_bent_strip_that_spins_keeps_its_angular_momentum() {
    let start = rolled(21, 0.01, 8.0);
    let center = mean(&start);
    let velocities: Vec<Vec3> = (start.iter())
        .map(|&place| Vec3::new(3.0, 5.0, 1.0).cross(place - center) + Vec3::new(0.2, 0.0, 0.1))
        .collect();
    let momenta = |fabric: Fabric| {
        let spec = strip(21, 0.01, fabric);
        let masses = lole_cloth::model::particle_masses(&spec);
        let mut world = floating(&spec, &start);
        world.state.set_velocities(&world.model, &velocities);
        let measure = |world: &World| {
            let (positions, velocities) = (world.positions(), world.velocities());
            let mut sums = [Vec3::ZERO; 2];
            for ((&mass, &place), &velocity) in masses.iter().zip(&positions).zip(&velocities) {
                sums[0] += velocity * mass;
                sums[1] += (place - mean(&positions)).cross(velocity) * mass;
            }
            sums
        };
        let before = measure(&world);
        for _ in 0..60 {
            world.step(&[]);
        }
        let after = measure(&world);
        [0, 1].map(|kind| (after[kind] - before[kind]).length() / before[kind].length())
    };
    let (with, without) = (momenta(RUBBING), momenta(FABRIC));
    for (with, without) in with.into_iter().zip(without) {
        assert!(with < 2.0 * without + 1e-3, "{with} where {without}");
    }
}

#[test]
fn what_falls_freely_feels_no_internal_friction() {
    let start = rolled(11, 0.01, 0.0);
    let fallen = |fabric: Fabric| {
        let mut world = World::new(&strip(11, 0.01, fabric), &start);
        for _ in 0..30 {
            world.step(&[]);
        }
        mean(&world.positions())
    };
    assert!((fallen(RUBBING) - fallen(FABRIC)).length() < 1e-5);
}

#[test]
fn friction_has_the_same_bits_with_all_vector_instructions() {
    let scene = SCENES.iter().find(|scene| scene.name == "skirt");
    let scene = scene.expect("a scene of that name");
    let hash = |instruction_set: InstructionSet, hysteresis: Hysteresis| {
        let mut setup = (scene.build)();
        setup.config.instruction_set = instruction_set;
        setup.spec.fabric.hysteresis = hysteresis;
        let model = ClothModel::new(&setup.spec).expect("a sound cloth");
        let pins: Vec<Vec3> = (model.pin_indices().iter())
            .map(|&pin| setup.positions[pin as usize])
            .collect();
        let mut state = ClothState::new(&model, &setup.positions);
        for frame in 0..3 {
            let capsules = (scene.capsules)(f64::from(frame + 1) * f64::from(FRAME_DT));
            let input = StepInput {
                pin_targets: &pins,
                capsules: &capsules,
                ..StepInput::default()
            };
            step(&model, &setup.config, &input, &mut state, FRAME_DT)
                .expect("a target for every pin");
        }
        state_hash(&state)
    };
    let detected = hash(InstructionSet::Detected, RUBBING.hysteresis);
    for set in [InstructionSet::Wide, InstructionSet::Baseline] {
        assert_eq!(detected, hash(set, RUBBING.hysteresis), "{set:?}");
    }
    assert_ne!(detected, hash(InstructionSet::Detected, Hysteresis::NONE));
}
