//! Springs and plate of the reference model: energies, forces, frequencies, statics, threads.

mod reference_support;

use std::num::NonZeroU32;

use glam::{DQuat, DVec3};
use lole_cloth::collision::penalty::{MovingCapsule, Penalty};
use lole_cloth::method::explicit::{self, ExplicitConfig, HighestMode, ReferenceInput, Substeps};
use lole_cloth::method::reference::{ReferenceModel, ReferenceState, SpringConstants};
use lole_cloth::{BuildError, ClothSpec, Fabric, MassLaw, Topology};
use lole_geom::trig64;
use reference_support::{
    FABRIC, Lcg, held_pins, lattice, model, pinned_net, rest_positions, spec, still,
};

/// Every family at once, all different.
const ALL: SpringConstants = SpringConstants {
    structural_u: 40.0,
    structural_v: 25.0,
    shear: 10.0,
    skip_u: 5.0,
    skip_v: 7.0,
    plate_u: 2e-4,
    plate_v: 3e-4,
    twist: 1e-4,
};

/// A sheet or tube with every family, two pins and area-weighted mass.
fn rich_model(topology: Topology) -> ReferenceModel {
    let mut spec = spec(7, 6, topology, [0.02, 0.03]);
    spec.mass = MassLaw::AreaWeighted;
    spec.pinned[0] = true;
    spec.pinned[7] = true;
    model(&spec, ALL)
}

/// Rest positions shaken by up to `amplitude` [m].
fn shaken(model: &ReferenceModel, amplitude: f64) -> Vec<DVec3> {
    let mut dice = Lcg(3);
    let mut positions = rest_positions(model.grid());
    for position in &mut positions {
        *position += dice.vector() * amplitude;
    }
    positions
}

fn energy(model: &ReferenceModel, positions: &[DVec3]) -> f64 {
    model.spring_energy(positions) + model.plate_energy(positions)
}

#[test]
fn forces_are_minus_the_gradient_of_the_energy() {
    for topology in [Topology::Sheet, Topology::Tube] {
        let model = rich_model(topology);
        let positions = shaken(&model, 0.004);
        let step = 1e-6;
        for index in 0..positions.len() {
            let force = model.internal_force(index, &positions);
            for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
                let moved = |sign: f64| {
                    let mut moved = positions.clone();
                    moved[index] += axis * (sign * step);
                    energy(&model, &moved)
                };
                let slope = (moved(1.0) - moved(-1.0)) / (2.0 * step);
                let error = (force.dot(axis) + slope).abs();
                assert!(
                    error < 1e-6,
                    "{topology:?} {index}: {force} against {slope}"
                );
            }
        }
    }
}

#[test]
fn energies_see_neither_rotation_nor_translation() {
    for topology in [Topology::Sheet, Topology::Tube] {
        let model = rich_model(topology);
        let positions = shaken(&model, 0.004);
        let turn = DQuat::from_axis_angle(DVec3::new(0.6, 0.0, 0.8), 1.1);
        let moved: Vec<DVec3> = positions
            .iter()
            .map(|&position| turn * position + DVec3::new(0.3, -0.2, 0.5))
            .collect();
        let spring_ratio = model.spring_energy(&moved) / model.spring_energy(&positions);
        let plate_ratio = model.plate_energy(&moved) / model.plate_energy(&positions);
        assert!((spring_ratio - 1.0).abs() < 1e-11, "{spring_ratio}");
        assert!((plate_ratio - 1.0).abs() < 1e-11, "{plate_ratio}");
    }
}

#[test]
fn a_flat_sheet_at_rest_feels_nothing() {
    let model = model(&spec(9, 8, Topology::Sheet, [0.02, 0.03]), ALL);
    let positions = rest_positions(model.grid());
    assert!(energy(&model, &positions) < 1e-25);
    for index in 0..positions.len() {
        assert!(model.internal_force(index, &positions).length() < 1e-12);
    }
}

#[test]
fn a_tube_closes_and_a_sheet_does_not() {
    let constants = SpringConstants {
        skip_u: 1.0,
        skip_v: 1.0,
        ..lattice(1.0)
    };
    let count = |topology| model(&spec(10, 6, topology, [0.02; 2]), constants).spring_count();
    // Rows of ring springs, columns, two diagonals a cell, every other along and down.
    assert_eq!(count(Topology::Tube), 60 + 50 + 100 + 60 + 40);
    assert_eq!(count(Topology::Sheet), 54 + 50 + 90 + 48 + 40);
}

#[test]
fn a_tube_has_no_first_column() {
    let model = model(&spec(9, 6, Topology::Tube, [0.02, 0.03]), ALL);
    let positions = shaken(&model, 0.004);
    let rotated: Vec<DVec3> = positions
        .chunks(9)
        .flat_map(|row| (0..9).map(|column| row[(column + 1) % 9]))
        .collect();
    for row in 0..6 {
        for column in 0..9 {
            let index = row * 9 + column;
            let original = row * 9 + (column + 1) % 9;
            let difference =
                model.internal_force(index, &rotated) - model.internal_force(original, &positions);
            assert!(difference.length() < 1e-13, "{index}: {difference}");
        }
    }
}

#[test]
fn bending_and_twist_store_what_a_plate_stores() {
    let spec = spec(11, 7, Topology::Sheet, [0.02, 0.03]);
    let model = model(&spec, ALL);
    let grid = model.grid();
    let [h_u, h_v] = grid.spacing.map(f64::from);
    let (width, height) = (h_u * 10.0, h_v * 6.0);
    let bent = |shape: &dyn Fn(f64, f64) -> f64| {
        let positions: Vec<DVec3> = rest_positions(grid)
            .iter()
            .map(|flat| DVec3::new(flat.x, flat.y, shape(flat.x, flat.y)))
            .collect();
        model.plate_energy(&positions)
    };
    let curvature = 3.0;
    let cases = [
        // A saddle x·y has κ_uv everywhere and nothing else: E = B_t κ² A.
        (bent(&|x, y| curvature * x * y), ALL.twist * height * width),
        // A trough: half a cell at each free end is flat.
        (
            bent(&|x, _| 0.5 * curvature * x * x),
            0.5 * ALL.plate_u * height * (width - h_u),
        ),
        (
            bent(&|_, y| 0.5 * curvature * y * y),
            0.5 * ALL.plate_v * width * (height - h_v),
        ),
    ];
    for (stored, per_square) in cases {
        let expected = per_square * curvature * curvature;
        assert!(
            (stored / expected - 1.0).abs() < 1e-12,
            "{stored} {expected}"
        );
    }
}

/// Power iterations after which a mode's frequency is known to four digits.
const ITERATIONS: u32 = 3000;

#[test]
fn the_highest_mode_of_the_net_nears_that_of_the_endless_lattice() {
    // Of the endless lattice 81/8 k/m. The finite values are those of an independent program;
    // power iteration still creeps in the fourth digit, the highest modes being close.
    for (size, expected) in [(8, 9.244), (12, 9.73297), (16, 9.906)] {
        let model = pinned_net(size, 0.0);
        let mode = HighestMode::of(&model, &rest_positions(model.grid()), ITERATIONS);
        let found = mode.frequency.powi(2);
        let ratio = found * model.masses()[0] / 10.0;
        assert!((ratio - expected).abs() < 2e-3, "{size}: {ratio} k/m");
        assert!(ratio < 81.0 / 8.0);
    }
}

#[test]
fn the_bound_is_never_below_the_highest_frequency_and_seldom_far_above() {
    let mut dice = Lcg(5);
    for case in 0..12 {
        let topology = if case % 2 == 0 {
            Topology::Sheet
        } else {
            Topology::Tube
        };
        let mut draw = |low: f64, high: f64| low + (high - low) * 0.5 * (dice.signed() + 1.0);
        let constants = SpringConstants {
            structural_u: draw(1.0, 50.0),
            structural_v: draw(1.0, 50.0),
            shear: draw(0.0, 30.0),
            skip_u: draw(0.0, 10.0),
            skip_v: draw(0.0, 10.0),
            plate_u: draw(0.0, 3e-4),
            plate_v: draw(0.0, 3e-4),
            twist: draw(0.0, 3e-4),
        };
        #[expect(clippy::cast_possible_truncation, reason = "a random spacing")]
        let spacing = [draw(0.01, 0.03) as f32, draw(0.01, 0.03) as f32];
        let mut spec = spec(9, 7, topology, spacing);
        spec.mass = MassLaw::AreaWeighted;
        spec.pinned[..9].fill(case % 3 != 0);
        let model = model(&spec, constants);
        // The bound is that of the flat cloth: a tube is measured on its polygon, where folds
        // between neighbors only lower the frequency.
        let mode = HighestMode::of(&model, &rest_positions(model.grid()), ITERATIONS);
        let ratio = model.largest_frequency_bound() / mode.frequency;
        assert!((0.9999..1.6).contains(&ratio), "case {case}: {ratio}");
    }
}

#[test]
fn the_bound_follows_rows_and_columns_that_come_to_lie_along_one_line() {
    // In gathers that open over the hips rows and columns meet at a narrow angle; and cloth is
    // taut there. Both raise the frequency above that of the flat cloth.
    for (angle, stretch) in [(90.0_f64, 1.2), (45.0, 1.0), (20.0, 1.0), (12.0, 1.1)] {
        let (sin, cos) = trig64::sin_cos(angle.to_radians());
        let spec = spec(24, 24, Topology::Sheet, [0.02; 2]);
        let constants = SpringConstants {
            structural_u: 40.0,
            structural_v: 40.0,
            ..SpringConstants::default()
        };
        let model = model(&spec, constants);
        let leaning: Vec<DVec3> = (0..24 * 24_u32)
            .map(|index| {
                let [row, column] = [index / 24, index % 24].map(f64::from);
                DVec3::new(column + cos * row, -sin * row, 0.0) * (0.02 * stretch)
            })
            .collect();
        let mode = HighestMode::of(&model, &leaning, ITERATIONS);
        let flat = model.largest_frequency_bound() / mode.frequency;
        let here = model.largest_frequency_bound_at(&leaning) / mode.frequency;
        assert!(
            (0.9999..1.1).contains(&here),
            "{angle} degrees, {stretch}: {here} of the frequency, {flat} when flat"
        );
        assert!(angle > 80.0 || flat < 0.95, "{angle} degrees: {flat}");
    }
}

#[test]
fn rectangular_cells_get_the_frequency_of_their_own_shape() {
    // Cells of 28 × 12 mm, structural and shear equal: 10.8 k/m, not the 8 of square cells.
    let model = model(
        &spec(40, 40, Topology::Sheet, [0.028, 0.012]),
        lattice(10.0),
    );
    let bound = model.largest_frequency_bound().powi(2) * model.masses()[0] / 10.0;
    assert!((bound - 10.76).abs() < 0.05, "{bound}");
}

#[test]
fn automatic_substeps_hold_a_stiff_cloth_with_contact() {
    let mut spec = spec(12, 12, Topology::Sheet, [0.02, 0.01]);
    spec.fabric.stretch = [900.0, 500.0];
    spec.fabric.shear = 60.0;
    spec.fabric.drag_rate = 1.0;
    spec.pinned[..12].fill(true);
    let model = ReferenceModel::new(&spec).expect("sound");
    let config = ExplicitConfig::for_model(&model, 1.0 / 60.0);
    let capsule = lole_geom::Capsule::uniform(
        glam::Vec3::new(-0.1, -0.05, 0.05),
        glam::Vec3::new(0.4, -0.05, 0.05),
        0.04,
    );
    let mut state = ReferenceState::at_rest(shaken(&model, 1e-4));
    let input = ReferenceInput {
        time: 0.0,
        pin_targets: &held_pins(&model, &state),
        capsules: &[capsule],
    };
    let mut count = 0;
    for _ in 0..60 {
        count = explicit::step(&model, &config, &input, &mut state, 1.0 / 60.0)
            .expect("a target for every pin");
    }
    let flat = model.stable_substeps(1.0 / 60.0, &config.penalty);
    assert!(
        (flat..=flat + flat / 2).contains(&count),
        "{count} of {flat}"
    );
    let strain = (model.springs().iter())
        .flat_map(|family| family.ends.iter().map(|ends| (ends, family.rest_length)))
        .map(|([a, b], length)| {
            let [a, b] = [a, b].map(|&end| state.positions[end as usize]);
            ((a - b).length() / length - 1.0).abs()
        })
        .fold(0.0, f64::max);
    assert!(strain < 0.1, "{strain}");
    let body = MovingCapsule::at_rest(&capsule, 0.0);
    for &position in &state.positions {
        assert!(-0.002 < body.signed_distance(position), "{position}");
    }
}

/// Runs `model` under gravity until it hangs still, by strong drag.
fn settled(model: &ReferenceModel, positions: Vec<DVec3>, seconds: f64) -> ReferenceState {
    let mut state = ReferenceState::at_rest(positions);
    let mut config = ExplicitConfig::for_model(model, 0.01);
    config.penalty = Penalty::new(0.0, 0.0);
    let input = ReferenceInput {
        time: 0.0,
        pin_targets: &held_pins(model, &state),
        capsules: &[],
    };
    explicit::step(model, &config, &input, &mut state, seconds).expect("a target for every pin");
    state
}

#[test]
fn a_hanging_strip_stretches_by_the_sum_of_the_weights_below() {
    let (n, stiffness) = (10u32, 50.0);
    let mut spec = spec(3, n + 1, Topology::Sheet, [0.02; 2]);
    spec.pinned[..3].fill(true);
    spec.fabric.drag_rate = 60.0;
    let constants = SpringConstants {
        structural_v: stiffness,
        ..SpringConstants::default()
    };
    let model = model(&spec, constants);
    let rest = rest_positions(model.grid());
    let state = settled(&model, rest.clone(), 8.0);
    let mass = model.masses()[0];
    let count = f64::from(n);
    let expected = mass * 9.81 * count * (count + 1.0) / (2.0 * stiffness);
    let tip = rest.len() - 1;
    let extension = rest[tip].y - state.positions[tip].y;
    assert!(
        (extension / expected - 1.0).abs() < 1e-6,
        "{extension} {expected}"
    );
}

#[test]
fn the_pins_carry_the_weight_of_the_skirt() {
    let mut spec = spec(24, 10, Topology::Tube, [0.02, 0.025]);
    spec.mass = MassLaw::AreaWeighted;
    spec.row_layers[9] = 2.0;
    spec.pinned[..24].fill(true);
    spec.fabric = Fabric {
        stretch: [60.0, 60.0],
        shear: 10.0,
        bend: [1e-5; 2],
        twist: 1e-5,
        drag_rate: 20.0,
        ..FABRIC
    };
    let model = ReferenceModel::new(&spec).expect("sound");
    let state = settled(&model, rest_positions(model.grid()), 4.0);
    let reaction: f64 = (model.pin_indices().iter())
        .map(|&pin| -model.internal_force(pin as usize, &state.positions).y)
        .sum();
    let weight: f64 = model.masses()[24..].iter().sum::<f64>() * 9.81;
    assert!(
        (reaction / weight - 1.0).abs() < 1e-4,
        "{reaction} N of {weight} N"
    );
}

#[test]
fn masses_add_up_to_the_cloth() {
    let mut spec = spec(5, 4, Topology::Sheet, [0.1, 0.2]);
    let total = |spec: &ClothSpec| -> f64 { model(spec, ALL).masses().iter().sum() };
    let expected = f64::from(0.15f32) * (4.0 * 0.1) * (3.0 * 0.2);
    assert!((total(&spec) / expected - 1.0).abs() < 1e-6);
    spec.mass = MassLaw::AreaWeighted;
    assert!((total(&spec) / expected - 1.0).abs() < 1e-6);
    let masses = model(&spec, ALL).masses().to_vec();
    assert!(
        (masses[1] / masses[0] - 2.0).abs() < 1e-12,
        "a corner is half a border"
    );
    assert!(
        (masses[6] / masses[0] - 4.0).abs() < 1e-12,
        "a quarter of an inner particle"
    );
}

#[test]
fn a_strip_shows_the_moduli_of_its_fabric() {
    // A long periodic-free strip pulled by its own constants: the plane lattice in closed form.
    let fabric = Fabric {
        stretch: [900.0, 400.0],
        shear: 70.0,
        ..FABRIC
    };
    let spacing = [0.028, 0.012];
    let k = SpringConstants::from_fabric(&fabric, spacing);
    // Energy per area of one periodic cell under homogeneous strain, by its springs alone.
    let energy = |e_u: f64, e_v: f64, gamma: f64| {
        let [h_u, h_v] = spacing;
        let spring = |stiffness: f64, du: f64, dv: f64| {
            let length = (du * du + dv * dv).sqrt();
            let extension = (du * du * e_u + dv * dv * e_v + du * dv * gamma) / length;
            0.5 * stiffness * extension * extension
        };
        let sum = spring(k.structural_u, h_u, 0.0)
            + spring(k.structural_v, 0.0, h_v)
            + spring(k.shear, h_u, h_v)
            + spring(k.shear, h_u, -h_v);
        sum / (h_u * h_v)
    };
    let c_11 = 2.0 * energy(1.0, 0.0, 0.0);
    let c_22 = 2.0 * energy(0.0, 1.0, 0.0);
    let c_12 = energy(1.0, 1.0, 0.0) - 0.5 * (c_11 + c_22);
    let c_66 = 2.0 * energy(0.0, 0.0, 1.0);
    assert!((c_11 - c_12 * c_12 / c_22 - 900.0).abs() < 1e-9);
    assert!((c_22 - c_12 * c_12 / c_11 - 400.0).abs() < 1e-9);
    assert!((c_66 - 70.0).abs() < 1e-9);
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let mut spec = spec(96, 32, Topology::Tube, [0.02, 0.02]);
    spec.pinned[..96].fill(true);
    let model = model(&spec, ALL);
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("a pool");
        pool.install(|| {
            let mut config = still(40);
            config.gravity = DVec3::NEG_Y * 9.81;
            config.substeps = Substeps::Fixed(NonZeroU32::new(40).expect("forty"));
            let mut state = ReferenceState::at_rest(shaken(&model, 0.001));
            let input = ReferenceInput {
                time: 0.0,
                pin_targets: &held_pins(&model, &state),
                capsules: &[],
            };
            explicit::step(&model, &config, &input, &mut state, 0.02)
                .expect("a target for every pin");
            state
        })
    };
    let one = run(1);
    assert_eq!(one, run(2));
    assert_eq!(one, run(3));
}

#[test]
fn pins_arrive_exactly_and_carry_their_speed() {
    let mut spec = spec(3, 3, Topology::Sheet, [0.02; 2]);
    spec.pinned[1] = true;
    let model = model(&spec, ALL);
    let mut state = ReferenceState::at_rest(rest_positions(model.grid()));
    let target = DVec3::new(0.1, 0.037, -0.2);
    let start = state.positions[1];
    let input = ReferenceInput {
        time: 0.0,
        pin_targets: &[target],
        capsules: &[],
    };
    explicit::step(&model, &still(7), &input, &mut state, 0.01).expect("a target for every pin");
    assert_eq!(state.positions[1], target);
    assert!((state.velocities[1] - (target - start) / 0.01).length() < 1e-12);
}

#[test]
fn a_cloth_that_cannot_be_built_says_why() {
    let mut few = spec(3, 3, Topology::Sheet, [0.02; 2]);
    few.row_layers.pop();
    let error = ReferenceModel::new(&few).expect_err("two layers for three rows");
    assert_eq!(
        error,
        BuildError::WrongLength {
            field: "row_layers",
            actual: 2,
            expected: 3
        }
    );
    let negative = SpringConstants { shear: -1.0, ..ALL };
    let sound = spec(3, 3, Topology::Sheet, [0.02; 2]);
    let error = ReferenceModel::with_constants(&sound, negative).expect_err("negative shear");
    assert!(error.to_string().contains("shear"), "{error}");
}
