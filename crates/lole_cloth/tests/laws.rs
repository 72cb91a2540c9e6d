//! The paper's equations against closed forms: falling, drag, oscillation, wind, momentum.

mod reference_support;

use std::f64::consts::FRAC_PI_4;

use glam::DVec3;
use lole_cloth::method::explicit::{self, ReferenceInput};
use lole_cloth::method::paper;
use lole_cloth::method::reference::{ReferenceModel, ReferenceState, SpringConstants};
use lole_cloth::wind::{Wind, WindLaw};
use lole_cloth::{MassLaw, Topology};
use lole_geom::trig64;
use reference_support::{Lcg, lattice, model, rest_positions, spec, still};

const DT: f64 = 1.0 / 60.0;
const GRAVITY: DVec3 = DVec3::new(0.0, -9.81, 0.0);

/// A sheet without springs after one step of `substeps` under gravity.
fn fallen(drag_rate: f32, substeps: u32) -> ReferenceState {
    let mut spec = spec(3, 3, Topology::Sheet, [0.01; 2]);
    spec.fabric.drag_rate = drag_rate;
    let model = model(&spec, SpringConstants::default());
    let mut config = still(substeps);
    config.gravity = GRAVITY;
    let mut state = ReferenceState::at_rest(vec![DVec3::ZERO; 9]);
    let input = ReferenceInput {
        time: 0.0,
        pin_targets: &[],
        capsules: &[],
    };
    explicit::step(
        &model,
        &config,
        &input,
        &mut state,
        DT * f64::from(substeps),
    )
    .expect("a target for every pin");
    state
}

#[test]
fn free_fall_follows_the_sum_of_its_velocities() {
    for n in [1, 10, 100] {
        let steps = f64::from(n);
        let expected = GRAVITY.y * DT * DT * steps * (steps + 1.0) / 2.0;
        for position in fallen(0.0, n).positions {
            assert!(
                (position.y / expected - 1.0).abs() < 1e-12,
                "{n}: {position}"
            );
        }
    }
}

#[test]
fn drag_bends_the_fall_into_a_geometric_series() {
    let rate = 2.0;
    for n in [1, 10, 1000] {
        let decay = (1.0 - rate * DT).powi(i32::try_from(n).expect("small"));
        let expected = GRAVITY.y / rate * (1.0 - decay);
        for velocity in fallen(2.0, n).velocities {
            assert!(
                (velocity.y / expected - 1.0).abs() < 1e-12,
                "{n}: {velocity}"
            );
        }
    }
}

#[test]
fn an_oscillator_keeps_its_modified_energy_for_a_million_steps() {
    let (stiffness, mass, rest_length) = (4.0, 0.25, 1.0);
    let omega_squared = stiffness / mass;
    let dt = 0.1;
    let (mut position, mut velocity) = (DVec3::new(1.5, 0.0, 0.0), DVec3::ZERO);
    let modified_energy = |position: DVec3, velocity: DVec3| {
        let (x, v) = (position.x - rest_length, velocity.x);
        0.5 * v * v + 0.5 * omega_squared * x * x - 0.5 * dt * omega_squared * x * v
    };
    let start = modified_energy(position, velocity);
    for _ in 0..1_000_000 {
        let force = paper::spring_force(position, DVec3::ZERO, rest_length, stiffness);
        let acceleration = paper::acceleration(mass, force);
        (position, velocity) = paper::fb_euler(position, velocity, acceleration, dt);
    }
    let drift = modified_energy(position, velocity) / start - 1.0;
    assert!(drift.abs() < 1e-12, "drift {drift:e}");
}

#[test]
fn the_period_of_an_oscillator_is_that_of_the_scheme() {
    // One period takes 2π / (2 asin(ω Δt / 2)) steps: count zero crossings of many periods.
    let (omega, dt) = (1.0, 0.5);
    let (mut position, mut velocity) = (DVec3::X, DVec3::ZERO);
    let mut crossings = Vec::new();
    for step in 0..200_000 {
        let acceleration = -position * (omega * omega);
        let before = position.x;
        (position, velocity) = paper::fb_euler(position, velocity, acceleration, dt);
        if before < 0.0 && 0.0 <= position.x {
            crossings.push(f64::from(step) + before / (before - position.x));
        }
    }
    let periods = f64::from(u32::try_from(crossings.len() - 1).expect("few"));
    let measured = (crossings[crossings.len() - 1] - crossings[0]) * dt / periods;
    let expected = std::f64::consts::TAU * 0.98939;
    assert!((measured / expected - 1.0).abs() < 1e-5, "{measured}");
}

/// A sheet of `model` crumpled and set moving at random.
fn crumpled(model: &ReferenceModel, seed: u64) -> ReferenceState {
    let mut dice = Lcg(seed);
    let mut state = ReferenceState::at_rest(rest_positions(model.grid()));
    for (position, velocity) in state.positions.iter_mut().zip(&mut state.velocities) {
        *position += dice.vector() * 0.003;
        *velocity = dice.vector();
    }
    state
}

#[test]
fn a_free_sheet_keeps_its_momentum() {
    for topology in [Topology::Sheet, Topology::Tube] {
        let mut spec = spec(13, 9, topology, [0.02, 0.015]);
        spec.mass = MassLaw::AreaWeighted;
        let model = model(
            &spec,
            SpringConstants {
                skip_u: 3.0,
                skip_v: 2.0,
                plate_u: 1e-5,
                plate_v: 2e-5,
                twist: 1e-5,
                ..lattice(20.0)
            },
        );
        let mut state = crumpled(&model, 7);
        let scale: f64 = (model.masses().iter().zip(&state.velocities))
            .map(|(mass, velocity)| mass * velocity.length())
            .sum();
        let before = model.momentum(&state);
        let input = ReferenceInput {
            time: 0.0,
            pin_targets: &[],
            capsules: &[],
        };
        explicit::step(&model, &still(2000), &input, &mut state, 1.0)
            .expect("a target for every pin");
        let after = model.momentum(&state);
        let linear = (after.linear - before.linear).length() / scale;
        let angular = (after.angular - before.angular).length() / scale;
        assert!(linear < 1e-12, "{topology:?}: linear {linear:e}");
        assert!(angular < 1e-12, "{topology:?}: angular {angular:e}");
    }
}

#[test]
fn the_energy_of_a_free_sheet_has_no_trend() {
    let model = model(&spec(5, 5, Topology::Sheet, [0.02; 2]), lattice(20.0));
    let mut state = crumpled(&model, 9);
    let dt = 1.0 / model.largest_frequency_bound();
    let input = ReferenceInput {
        time: 0.0,
        pin_targets: &[],
        capsules: &[],
    };
    let mut mean_energy = |steps: u32| {
        let mut sum = 0.0;
        for _ in 0..steps {
            explicit::step(&model, &still(1), &input, &mut state, dt)
                .expect("a target for every pin");
            sum += model.kinetic_energy(&state.velocities) + model.spring_energy(&state.positions);
        }
        sum / f64::from(steps)
    };
    let early = mean_energy(10_000);
    mean_energy(80_000);
    let late = mean_energy(10_000);
    assert!(
        (late / early - 1.0).abs() < 0.01,
        "{early} J, then {late} J"
    );
}

#[test]
fn wind_starts_at_nothing_and_never_exceeds_its_amplitude() {
    let wind = Wind {
        amplitude: 0.3,
        law: WindLaw::Spherical,
        heading: 0.0,
    };
    assert_eq!(wind.force(0.0), DVec3::ZERO);
    for step in 0..10_000 {
        let force = wind.force(f64::from(step) * 0.01);
        assert!(force.length() <= 0.3 * (1.0 + 1e-15));
        assert!(force.y.abs() < f64::MIN_POSITIVE);
    }
}

#[test]
fn wind_repeats_after_six_tenths_of_pi_and_blows_nowhere_on_average() {
    let wind = Wind {
        amplitude: 1.0,
        law: WindLaw::Spherical,
        heading: 0.0,
    };
    let period = 0.6 * std::f64::consts::PI;
    let count = 1200;
    let mut sum = DVec3::ZERO;
    for step in 0..count {
        let time = period * f64::from(step) / f64::from(count);
        let force = wind.force(time);
        sum += force;
        assert!((wind.force(time + period) - force).length() < 1e-12);
    }
    assert!((sum / f64::from(count)).length() < 1e-12);
    // No shorter period: half of it and a third of it give another force.
    for divisor in [2.0, 3.0] {
        assert!(0.1 < (wind.force(0.1 + period / divisor) - wind.force(0.1)).length());
    }
}

#[test]
fn the_literal_wind_goes_to_and_fro_along_the_diagonal() {
    let wind = Wind {
        amplitude: 1.0,
        law: WindLaw::LiteralScalar,
        heading: 0.0,
    };
    let period = 0.6 * std::f64::consts::PI;
    let count = 1200;
    let mut sum = DVec3::ZERO;
    let mut largest: f64 = 0.0;
    for step in 0..count {
        let time = period * f64::from(step) / f64::from(count);
        let force = wind.force(time);
        let [beta, gamma] = paper::wind_phases(time);
        let scalar = 2.0f64.sqrt() * trig64::sin(gamma) * trig64::sin(beta + FRAC_PI_4);
        assert!((force - DVec3::new(scalar, 0.0, scalar)).length() < 1e-12);
        assert!((wind.force(time + period) - force).length() < 1e-12);
        sum += force;
        largest = largest.max(force.x.abs());
    }
    assert!((sum / f64::from(count)).length() < 1e-12);
    assert!(1.2 < largest && largest <= 2.0f64.sqrt(), "{largest}");
}

#[test]
fn the_wind_has_two_tones() {
    // cos β sin γ = (sin(50 t / 3) - sin(10 t / 3)) / 2: 2.653 Hz and 0.531 Hz.
    let wind = Wind {
        amplitude: 1.0,
        law: WindLaw::Spherical,
        heading: 0.0,
    };
    for step in 0..1000 {
        let time = 0.01 * f64::from(step);
        let (fast, slow) = (50.0 / 3.0 * time, 10.0 / 3.0 * time);
        let x = 0.5 * (trig64::sin(fast) - trig64::sin(slow));
        let z = 0.5 * (trig64::cos(slow) - trig64::cos(fast));
        assert!((wind.force(time) - DVec3::new(x, 0.0, z)).length() < 1e-12);
    }
}

#[test]
fn a_steady_wind_rises_once_and_then_blows_where_it_heads() {
    let wind = |heading| Wind {
        amplitude: 0.5,
        law: WindLaw::Steady,
        heading,
    };
    let quarter = std::f64::consts::FRAC_PI_2;
    for (heading, toward) in [
        (0.0, DVec3::Z),
        (quarter, DVec3::X),
        (2.0 * quarter, DVec3::NEG_Z),
        (-quarter, DVec3::NEG_X),
    ] {
        let wind = wind(heading);
        assert_eq!(wind.force(0.0), DVec3::ZERO);
        let mut before = 0.0;
        for step in 1..=100 {
            let along = wind.force(0.01 * f64::from(step)).dot(toward);
            assert!(before < along, "{heading}: {before} N, then {along} N");
            before = along;
        }
        for time in [1.0, 7.3, 600.0] {
            assert!((wind.force(time) - 0.5 * toward).length() < 1e-12);
        }
    }
}

#[test]
fn wind_from_pressure_pushes_a_cloth_alike_on_any_grid() {
    for count in [100, 400, 25_000] {
        let total = Wind::from_pressure(3.0, 2.0, count).amplitude * f64::from(count);
        assert!((total - 6.0).abs() < 1e-12);
    }
}

#[test]
fn hooke_pulls_when_stretched_and_pushes_when_compressed() {
    let pull = paper::spring_force(DVec3::ZERO, DVec3::X * 1.5, 1.0, 10.0);
    let push = paper::spring_force(DVec3::ZERO, DVec3::X * 0.5, 1.0, 10.0);
    assert!((pull - DVec3::X * 5.0).length() < 1e-15);
    assert!((push + DVec3::X * 5.0).length() < 1e-15);
    assert_eq!(
        paper::spring_force(DVec3::X, DVec3::X, 1.0, 10.0),
        DVec3::ZERO
    );
}

#[test]
fn the_total_force_has_all_five_parts() {
    let forces = paper::Forces {
        gravity: DVec3::X,
        damper: DVec3::Y,
        stretch: DVec3::Z,
        wind: DVec3::X * 2.0,
        penalty: DVec3::Y * 4.0,
    };
    assert_eq!(paper::total_force(&forces), DVec3::new(3.0, 5.0, 1.0));
    assert_eq!(paper::gravity_force(2.0, GRAVITY), GRAVITY * 2.0);
    assert_eq!(paper::damper_force(0.5, DVec3::X), DVec3::X * -0.5);
}
