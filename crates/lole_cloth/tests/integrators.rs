//! The paper's integrators against closed forms: falling, order, growth, stability.

mod reference_support;

use std::num::NonZeroU32;

use glam::DVec3;
use lole_cloth::Topology;
use lole_cloth::method::explicit::{
    self, ContactEvaluation, Counting, HighestMode, Integrator, LastStage, ReferenceInput,
    RungeKutta, StageDamping, stability_limit,
};
use lole_cloth::method::reference::{ReferenceModel, ReferenceState, SpringConstants};
use lole_geom::trig64;
use reference_support::{held_pins, model, pinned_net, rest_positions, spec, still};

const GRAVITY: f64 = 9.81;
const RK4: Integrator = Integrator::RungeKutta(RungeKutta::CLASSICAL);
const PRINTED: Integrator = Integrator::RungeKutta(RungeKutta::AS_PRINTED);
const DOUBLE: Integrator = Integrator::RungeKutta(RungeKutta::DOUBLE_COUNTED);
/// The correct last stage, but the damping of the print.
const FROZEN: Integrator = Integrator::RungeKutta(RungeKutta {
    damping: StageDamping::Frozen,
    ..RungeKutta::CLASSICAL
});

const NOTHING: ReferenceInput<'static> = ReferenceInput {
    time: 0.0,
    pin_targets: &[],
    capsules: &[],
};

/// Height [m] and vertical speed [m/s] of loose particles after `count` steps of `dt` [s] from
/// rest.
fn fallen(integrator: Integrator, drag_rate: f32, count: u32, dt: f64) -> [f64; 2] {
    let mut spec = spec(3, 3, Topology::Sheet, [0.01; 2]);
    spec.fabric.drag_rate = drag_rate;
    let model = model(&spec, SpringConstants::default());
    let mut config = still(count);
    config.gravity = DVec3::NEG_Y * GRAVITY;
    config.integrator = integrator;
    let mut state = ReferenceState::at_rest(vec![DVec3::ZERO; 9]);
    explicit::step(&model, &config, &NOTHING, &mut state, dt * f64::from(count))
        .expect("a target for every pin");
    [state.positions[4].y, state.velocities[4].y]
}

#[test]
fn every_method_falls_by_its_own_sum() {
    let dt = 0.01;
    for count in [1, 7, 300] {
        let n = f64::from(count);
        let unit = -GRAVITY * dt * dt;
        let once = -GRAVITY * n * dt;
        for (integrator, height, speed) in [
            (Integrator::Euler, unit * n * (n - 1.0) / 2.0, once),
            (Integrator::FbEuler, unit * n * (n + 1.0) / 2.0, once),
            (RK4, unit * n * n / 2.0, once),
            (FROZEN, unit * n * n / 2.0, once),
            (PRINTED, unit * (n * (n - 1.0) / 2.0 + 5.0 * n / 12.0), once),
        ] {
            let [y, v] = fallen(integrator, 0.0, count, dt);
            assert!(
                (y - height).abs() <= 1e-12 * height.abs(),
                "{integrator:?} {count}: {y} {height}"
            );
            assert!((v / speed - 1.0).abs() < 1e-12, "{integrator:?}: {v}");
        }
        // Gravity counted twice in three of four stages: (1 + 4 + 4 + 2) / 6 of it.
        let [_, v] = fallen(DOUBLE, 0.0, count, dt);
        assert!((v / (11.0 / 6.0 * once) - 1.0).abs() < 1e-12, "{v}");
    }
}

#[test]
fn drag_slows_every_method_by_its_own_factor() {
    let (rate, dt) = (2.0f32, 0.05);
    let z = f64::from(rate) * dt;
    let terminal = GRAVITY / f64::from(rate);
    let series = 1.0 - z + z * z / 2.0 - z.powi(3) / 6.0 + z.powi(4) / 24.0;
    for (integrator, factor) in [
        (Integrator::Euler, 1.0 - z),
        (Integrator::FbEuler, 1.0 - z),
        (RK4, series),
        (PRINTED, 1.0 - z),
        (DOUBLE, 1.0 - 11.0 / 6.0 * z),
    ] {
        for count in [1, 5, 40] {
            let expected = -terminal * (1.0 - factor.powi(count));
            let count = u32::try_from(count).expect("small");
            let [_, v] = fallen(integrator, rate, count, dt);
            assert!(
                (v / expected - 1.0).abs() < 1e-12,
                "{integrator:?} {count}: {v} {expected}"
            );
        }
        let [_, v] = fallen(integrator, rate, 2000, dt);
        assert!((v / -terminal - 1.0).abs() < 1e-12, "{integrator:?}: {v}");
    }
}

/// One free particle between two pins, moving along the springs: exactly `x'' = -ω² x - c v`.
struct Oscillator {
    model: ReferenceModel,
    /// `ω` [rad/s].
    frequency: f64,
    /// `c` [1/s].
    drag_rate: f64,
}

/// Where the free particle starts from its rest [m].
const START: f64 = 0.001;

impl Oscillator {
    fn new(drag_rate: f32) -> Self {
        let mut spec = spec(3, 3, Topology::Sheet, [0.02; 2]);
        spec.pinned = vec![true; 9];
        spec.pinned[4] = false;
        spec.fabric.drag_rate = drag_rate;
        let constants = SpringConstants {
            structural_u: 3.0e-4,
            ..SpringConstants::default()
        };
        let model = model(&spec, constants);
        let frequency = (2.0 * constants.structural_u / model.masses()[4]).sqrt();
        Self {
            model,
            frequency,
            drag_rate: f64::from(drag_rate),
        }
    }

    /// Offset [m] and velocity [m/s] after `count` steps of `dt` [s] from [`START`], at rest.
    fn run(&self, integrator: Integrator, count: u32, dt: f64) -> [f64; 2] {
        let rest = rest_positions(self.model.grid());
        let mut state = ReferenceState::at_rest(rest.clone());
        state.positions[4].x += START;
        let mut config = still(count);
        config.integrator = integrator;
        let input = ReferenceInput {
            pin_targets: &held_pins(&self.model, &state),
            ..NOTHING
        };
        explicit::step(
            &self.model,
            &config,
            &input,
            &mut state,
            dt * f64::from(count),
        )
        .expect("a target for every pin");
        [state.positions[4].x - rest[4].x, state.velocities[4].x]
    }

    /// The exact offset and velocity after `time` [s].
    fn exact(&self, time: f64) -> [f64; 2] {
        let half = 0.5 * self.drag_rate;
        let damped = (self.frequency * self.frequency - half * half).sqrt();
        let (sin, cos) = trig64::sin_cos(damped * time);
        let size = START * trig64::exp(-half * time);
        let velocity = -size * self.frequency * self.frequency / damped * sin;
        [size * (cos + half / damped * sin), velocity]
    }

    /// Binary logarithm of the error at 1 s over the error with half the step.
    fn order(&self, integrator: Integrator) -> f64 {
        let error = |count: u32| {
            let [x, v] = self.run(integrator, count, 1.0 / f64::from(count));
            let [exact_x, exact_v] = self.exact(1.0);
            let velocity_error = (v - exact_v) / self.frequency;
            ((x - exact_x).powi(2) + velocity_error.powi(2)).sqrt()
        };
        trig64::ln(error(200) / error(400)) / std::f64::consts::LN_2
    }
}

#[test]
fn orders_are_one_one_four_and_one() {
    let free = Oscillator::new(0.0);
    let damped = Oscillator::new(0.4);
    for (integrator, undamped_order, damped_order) in [
        (Integrator::Euler, 1.0, 1.0),
        (Integrator::FbEuler, 1.0, 1.0),
        (RK4, 4.0, 4.0),
        // Frozen damping alone takes the order away wherever there is damping.
        (FROZEN, 4.0, 1.0),
        (PRINTED, 1.0, 1.0),
    ] {
        let found = [free.order(integrator), damped.order(integrator)];
        assert!(
            (found[0] - undamped_order).abs() < 0.1 && (found[1] - damped_order).abs() < 0.1,
            "{integrator:?}: {found:?}"
        );
    }
}

#[test]
fn an_undamped_oscillator_grows_as_the_method_lets_it() {
    let oscillator = Oscillator::new(0.0);
    for (integrator, phase, growth, tolerance) in [
        (Integrator::Euler, 0.01f64, 5.0e-5, 1e-8),
        (PRINTED, 0.01, 8.333e-6, 1e-9),
        (RK4, 0.1, -1.0e-6 / 144.0, 1e-11),
    ] {
        let dt = phase / oscillator.frequency;
        let count = 2000;
        let [x, v] = oscillator.run(integrator, count, dt);
        let amplitude = (x * x + (v / oscillator.frequency).powi(2)).sqrt();
        let found = trig64::ln(amplitude / START) / f64::from(count);
        assert!(
            (found - growth).abs() < tolerance,
            "{integrator:?}: {found:e} a step"
        );
    }
}

/// The highest mode of a pinned net.
struct Net {
    mode: HighestMode,
}

impl Net {
    fn new() -> Self {
        let model = pinned_net(12, 0.0);
        let rest = rest_positions(model.grid());
        Self {
            mode: HighestMode::of(&model, &rest, 3000),
        }
    }

    /// Natural logarithm of the growth per step with the damping `c / ω` and the phase `ω Δt`.
    fn growth(&self, integrator: Integrator, damping: f64, phase: f64, count: u32) -> f64 {
        let frequency = self.mode.frequency;
        #[expect(clippy::cast_possible_truncation, reason = "models hold drag in f32")]
        let model = pinned_net(12, (damping * frequency) as f32);
        let count = NonZeroU32::new(count).expect("at least one");
        let step = [phase / frequency, 1e-10];
        self.mode.growth(&model, integrator, step, count)
    }

    /// That the highest mode shrinks 2 % below the `limit` of `ω Δt`, and grows 2 % above it.
    fn assert_limit(&self, integrator: Integrator, damping: f64, limit: f64, count: u32) {
        let theory = stability_limit(integrator, 1.0, damping).expect("a stable step");
        assert!(
            (theory / limit - 1.0).abs() < 0.01,
            "{integrator:?} c/ω {damping}: {theory} in theory, not {limit}"
        );
        let below = self.growth(integrator, damping, 0.98 * limit, count);
        let above = self.growth(integrator, damping, 1.02 * limit, count);
        assert!(
            below <= 1e-9 && 1e-9 < above,
            "{integrator:?} c/ω {damping} limit {limit}: {below:e} {above:e}"
        );
    }
}

#[test]
fn euler_is_stable_up_to_c_over_omega_squared() {
    let net = Net::new();
    for damping in [0.05, 0.1, 0.5] {
        net.assert_limit(Integrator::Euler, damping, damping, 4000);
    }
}

#[test]
fn an_overdamped_euler_is_stable_up_to_its_faster_decay() {
    // Two real decays; the faster one sets the step.
    for damping in [2.5f64, 8.0] {
        let fast = 0.5 * damping + (0.25 * damping * damping - 1.0).sqrt();
        let limit = stability_limit(Integrator::Euler, 1.0, damping).expect("a stable step");
        assert!(
            (limit * fast / 2.0 - 1.0).abs() < 1e-12,
            "{damping}: {limit}"
        );
    }
}

#[test]
fn damping_takes_stability_from_fb_euler() {
    let net = Net::new();
    // Undamped, 2 % above the limit: ω Δt = 2.04 gives acosh(2.0808 - 1), a factor of 1.49.
    let above = net.growth(Integrator::FbEuler, 0.0, 2.04, 20);
    assert!((above - trig64::ln(1.49)).abs() < 0.015, "{above}");
    let below = net.growth(Integrator::FbEuler, 0.0, 1.96, 200);
    assert!(below.abs() < 0.02, "{below}");
    for damping in [0.1f64, 0.5, 1.0] {
        let limit = (damping * damping + 4.0).sqrt() - damping;
        net.assert_limit(Integrator::FbEuler, damping, limit, 60);
    }
}

#[test]
fn the_classical_method_is_stable_up_to_the_root_of_eight() {
    let net = Net::new();
    // Damped: roots of the stability polynomial on the mode's eigenvalue, by an independent
    // program.
    for (damping, limit) in [
        (0.0, 8.0f64.sqrt()),
        (0.1, 2.910),
        (0.2, 2.951),
        (0.5, 2.897),
        (1.0, 2.62),
    ] {
        net.assert_limit(RK4, damping, limit, 40);
    }
}

#[test]
fn frozen_damping_takes_stability_from_the_classical_method() {
    let net = Net::new();
    for (damping, limit) in [(0.1, 2.810), (0.5, 2.744), (1.0, 1.596)] {
        net.assert_limit(FROZEN, damping, limit, 40);
    }
}

#[test]
fn equation_10_as_printed_is_stable_up_to_six_c_over_omega_squared() {
    let net = Net::new();
    net.assert_limit(PRINTED, 0.02, 6.0 * 0.02, 8000);
    net.assert_limit(DOUBLE, 0.02, 11.0 * 0.02, 4000);
    // Without damping there is no stable step at all.
    for integrator in [Integrator::Euler, PRINTED, DOUBLE] {
        assert_eq!(stability_limit(integrator, 1.0, 0.0), None);
    }
    let growth = net.growth(PRINTED, 0.0, 0.1, 2000);
    assert!((growth / (0.01 / 12.0) - 1.0).abs() < 0.01, "{growth:e}");
}

#[test]
fn the_last_stage_alone_costs_the_order_and_counting_twice_alone_the_weight() {
    // The two switches of the print that do not touch damping.
    let half = Integrator::RungeKutta(RungeKutta {
        last_stage: LastStage::Half,
        ..RungeKutta::CLASSICAL
    });
    let order = Oscillator::new(0.0).order(half);
    assert!((order - 1.0).abs() < 0.1, "{order}");
    let twice = Integrator::RungeKutta(RungeKutta {
        counting: Counting::Twice,
        ..RungeKutta::CLASSICAL
    });
    let [_, v] = fallen(twice, 0.0, 10, 0.01);
    assert!((v / (-GRAVITY * 0.1) - 11.0 / 6.0).abs() < 1e-12, "{v}");
}

#[test]
fn four_stages_give_the_same_bits_on_any_number_of_threads() {
    let model = pinned_net(48, 0.3);
    let rest = rest_positions(model.grid());
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("a pool");
        let mut state = ReferenceState::at_rest(rest.clone());
        for (index, position) in (0u32..).zip(&mut state.positions) {
            position.z += 1e-3 * trig64::sin(f64::from(index));
        }
        let mut config = still(5);
        config.gravity = DVec3::NEG_Y * GRAVITY;
        config.integrator = PRINTED;
        config.contact_evaluation = ContactEvaluation::PerStep;
        let input = ReferenceInput {
            pin_targets: &held_pins(&model, &state),
            ..NOTHING
        };
        pool.install(|| explicit::step(&model, &config, &input, &mut state, 0.001))
            .expect("a target for every pin");
        state
    };
    assert_eq!(run(1), run(3));
}
