//! Capsules and the penalty force: distances against an independent library, bounce, rest, friction.

mod reference_support;

use std::num::NonZeroU32;

use glam::{DVec3, Vec3};
use lole_cloth::Topology;
use lole_cloth::collision::penalty::{MovingCapsule, Overlap, Penalty, Response, contact_force};
use lole_cloth::method::explicit::{
    self, ContactEvaluation, ExplicitConfig, Integrator, ReferenceInput, RungeKutta, Substeps,
};
use lole_cloth::method::paper;
use lole_cloth::method::reference::{ReferenceModel, ReferenceState, SpringConstants};
use lole_geom::{Capsule, trig64};
use parry3d::math::Vector;
use parry3d::query::PointQuery as _;
use reference_support::{Lcg, model, spec, still};

/// A random point as the engine stores points.
fn single(vector: DVec3) -> Vec3 {
    vector.as_vec3()
}

/// The distance another library finds.
fn independent_distance(capsule: &Capsule, point: Vec3) -> f32 {
    let [a, b] = capsule.ends.map(|end| Vector::new(end.x, end.y, end.z));
    parry3d::shape::Capsule::new(a, b, capsule.radii[0])
        .distance_to_local_point(Vector::new(point.x, point.y, point.z), false)
}

#[test]
fn capsule_distance_agrees_with_an_independent_library() {
    let mut dice = Lcg(1);
    let (mut inside_count, mut beyond_count) = (0, 0);
    for case in 0..10_000 {
        let start = single(dice.vector());
        let end = start + single(dice.vector());
        let capsule = Capsule::uniform(start, end, 0.31);
        // Well beyond both ends too: the infinite cylinder of the print would be caught.
        let reach = if case % 2 == 0 { 1.5 } else { 0.5 };
        let point = start + single(dice.vector() * reach);
        let expected = independent_distance(&capsule, point);
        let found = capsule.signed_distance(point);
        assert!((found - expected).abs() < 2e-6, "{capsule:?} {point}");
        let in_double = MovingCapsule::at_rest(&capsule, 0.0).signed_distance(point.as_dvec3());
        assert!((in_double - f64::from(expected)).abs() < 2e-6);
        inside_count += u32::from(expected < 0.0);
        let s = capsule.axis_parameter(point);
        beyond_count += u32::from(s <= 0.0 || 1.0 <= s);
    }
    assert!(
        1000 < inside_count && 3000 < beyond_count,
        "{inside_count}, {beyond_count}"
    );
}

#[test]
fn a_capsule_without_length_is_a_ball_for_everyone() {
    let mut dice = Lcg(2);
    for _ in 0..1000 {
        let center = single(dice.vector());
        let capsule = Capsule::uniform(center, center, 0.4);
        let point = single(dice.vector());
        let ball = parry3d::shape::Ball::new(0.4);
        let offset = point - center;
        let expected =
            ball.distance_to_local_point(Vector::new(offset.x, offset.y, offset.z), false);
        assert!((capsule.signed_distance(point) - expected).abs() < 1e-6);
        let body = MovingCapsule::at_rest(&capsule, 0.0);
        assert!((body.signed_distance(point.as_dvec3()) - f64::from(expected)).abs() < 1e-6);
    }
}

#[test]
fn equations_12_and_13_together_are_the_confined_11() {
    let mut dice = Lcg(3);
    let radius = 0.3;
    for _ in 0..10_000 {
        let ends = [dice.vector(), dice.vector()];
        let point = dice.vector() * 1.5;
        let foot = paper::axis_foot(point, ends);
        let is_inside = (point - foot.point).length() - radius < 0.0;
        let is_hit = paper::is_in_cylinder(point, ends, radius)
            || paper::is_in_hemisphere(point, ends, radius);
        assert_eq!(is_inside, is_hit, "{point} {ends:?}");
    }
    let ends = [DVec3::ZERO, DVec3::X];
    assert!(
        !paper::is_in_cylinder(DVec3::X * 5.0, ends, radius),
        "beyond the end"
    );
}

#[test]
fn the_contact_is_the_gradient_of_the_distance() {
    let mut dice = Lcg(4);
    let capsule = MovingCapsule::at_rest(&Capsule::uniform(Vec3::ZERO, Vec3::X, 0.5), 0.02);
    for _ in 0..1000 {
        let point = DVec3::X * 0.5 + dice.vector();
        let distance = capsule.signed_distance(point);
        let Some(contact) = capsule.contact(point) else {
            assert!(0.0 <= distance);
            continue;
        };
        assert!((contact.depth + distance).abs() < 1e-12);
        assert!((contact.normal.length() - 1.0).abs() < 1e-12);
        let out = point + contact.normal * contact.depth;
        assert!(capsule.signed_distance(out).abs() < 1e-12);
    }
    let on_axis = capsule.contact(DVec3::X * 0.5).expect("inside");
    assert!((on_axis.depth - 0.52).abs() < 1e-7 && on_axis.normal.is_normalized());
}

#[test]
fn the_penalty_never_pulls_and_never_acts_from_afar() {
    assert!((paper::penalty_force(0.01, 0.0, 100.0, 5.0) - 1.0).abs() < 1e-15);
    assert!((paper::penalty_force(0.01, 0.2, 100.0, 5.0) - 2.0).abs() < 1e-15);
    assert_eq!(paper::penalty_force(0.01, -10.0, 100.0, 5.0), 0.0);
    assert_eq!(paper::penalty_force(0.0, 10.0, 100.0, 5.0), 0.0);
    assert_eq!(paper::penalty_force(-0.1, 10.0, 100.0, 5.0), 0.0);
}

#[test]
fn the_damper_feels_the_moving_surface() {
    let at = |x: f32| Capsule::uniform(Vec3::new(x, 0.0, 0.0), Vec3::new(x, 1.0, 0.0), 0.1);
    let moving = MovingCapsule::between(&at(0.0), &at(0.02), 0.0, 0.01);
    let penalty = Penalty::new(0.0, 3.0);
    let push = |velocity: DVec3| {
        let point = DVec3::new(0.05, 0.5, 0.0);
        contact_force(&penalty, [moving].iter(), point, velocity)
            .expect("inside")
            .force
            .x
    };
    // The surface comes at 2 m/s: a resting particle is pushed, one that flees faster is not.
    assert!((push(DVec3::ZERO) - 6.0).abs() < 1e-6);
    assert!((push(DVec3::X) - 3.0).abs() < 1e-6);
    assert_eq!(push(DVec3::X * 3.0), 0.0);
}

#[test]
fn a_turning_capsule_moves_its_surface_like_a_rigid_body() {
    let (sin, cos) = (0.001f32, 1.0f32);
    let upright = Capsule::uniform(Vec3::ZERO, Vec3::Y, 0.2);
    let tilted = Capsule::uniform(Vec3::ZERO, Vec3::new(-sin, cos, 0.0), 0.2);
    let body = MovingCapsule::between(&upright, &tilted, 0.0, 0.001);
    // ω = 1 rad/s about z: the surface at (0.2, 0.5, 0) moves at ω × x = (-0.5, 0.2, 0).
    let contact = body.contact(DVec3::new(0.15, 0.5, 0.0)).expect("inside");
    let expected = DVec3::new(-0.5, 0.2, 0.0);
    assert!((contact.surface_velocity - expected).length() < 1e-3);
}

#[test]
fn overlapping_capsules_push_once_or_together() {
    let capsule = MovingCapsule::at_rest(&Capsule::uniform(Vec3::ZERO, Vec3::X, 0.1), 0.0);
    let thicker = MovingCapsule::at_rest(&Capsule::uniform(Vec3::ZERO, Vec3::X, 0.12), 0.0);
    let mut penalty = Penalty::new(100.0, 0.0);
    let point = DVec3::new(0.5, 0.09, 0.0);
    let push = |penalty: &Penalty| {
        contact_force(penalty, [capsule, thicker].iter(), point, DVec3::ZERO)
            .expect("inside")
            .force
            .y
    };
    assert!((push(&penalty) - 3.0).abs() < 1e-5);
    penalty.overlap = Overlap::Sum {
        count: NonZeroU32::new(2).expect("two"),
    };
    assert!((push(&penalty) - 4.0).abs() < 1e-5);
}

/// What a penalty does to particles that arrive at 1 m/s in every phase of a substep.
struct Bounce {
    /// Least and greatest speed after over speed before.
    restitution: [f64; 2],
    /// Greatest depth over `v / ω`, the depth of exact motion.
    depth: f64,
}

/// Bounces of an undamped penalty with `ω Δt = phase_step`.
fn bounce(phase_step: f64) -> Bounce {
    let (mass, dt): (f64, f64) = (0.25, 1e-3);
    let omega = phase_step / dt;
    let stiffness = mass * omega * omega;
    let mut found = Bounce {
        restitution: [f64::INFINITY, 0.0],
        depth: 0.0,
    };
    for phase in 0..1000 {
        let mut position = DVec3::Y * (dt * f64::from(phase) / 1000.0);
        let mut velocity = DVec3::NEG_Y;
        while velocity.y < 0.0 || position.y <= 0.0 {
            let force = paper::penalty_force(-position.y, -velocity.y, stiffness, 0.0);
            let acceleration = paper::acceleration(mass, DVec3::Y * force);
            (position, velocity) = paper::fb_euler(position, velocity, acceleration, dt);
            found.depth = found.depth.max(-position.y * omega);
        }
        found.restitution[0] = found.restitution[0].min(velocity.y);
        found.restitution[1] = found.restitution[1].max(velocity.y);
    }
    found
}

#[test]
fn a_penalty_returns_what_the_substep_lets_it() {
    // Bounds found by an independent program, all phases swept.
    let cases = [
        (0.5, [0.98, 1.02], 1.035),
        (1.0, [0.9999, 1.0001], 1.0001),
        (1.5, [0.8, 1.25], 1.5001),
    ];
    for (phase_step, [low, high], depth) in cases {
        let found = bounce(phase_step);
        let [least, greatest] = found.restitution;
        assert!(low - 0.005 <= least, "{phase_step}: {least}");
        assert!(greatest <= high + 0.005, "{phase_step}: {greatest}");
        let range = 0.99 * depth..depth;
        assert!(
            range.contains(&found.depth),
            "{phase_step}: {}",
            found.depth
        );
    }
}

/// Least and greatest speed after over speed before of a particle of a cloth without springs that
/// falls on a thick capsule at 1 m/s in 100 phases of a step with `ω Δt = phase_step`.
fn bounce_of(
    integrator: Integrator,
    contact_evaluation: ContactEvaluation,
    phase_step: f64,
) -> [f64; 2] {
    let model = one_particle();
    let dt = 1e-3;
    let omega = phase_step / dt;
    let config = ExplicitConfig {
        penalty: Penalty::new(model.masses()[4] * omega * omega, 0.0),
        integrator,
        contact_evaluation,
        ..still(1)
    };
    let capsule = [Capsule::uniform(Vec3::NEG_X, Vec3::X, 0.5)];
    let pin_targets = [DVec3::splat(100.0); 8];
    let input = ReferenceInput {
        time: 0.0,
        pin_targets: &pin_targets,
        capsules: &capsule,
    };
    let mut found = [f64::INFINITY, 0.0f64];
    for phase in 0..100 {
        let mut positions = vec![DVec3::splat(100.0); 9];
        positions[4] = DVec3::Y * (0.5 + dt * f64::from(phase) / 100.0);
        let mut state = ReferenceState::at_rest(positions);
        state.velocities[4] = DVec3::NEG_Y;
        while state.velocities[4].y < 0.0 || state.positions[4].y <= 0.5 {
            explicit::step(&model, &config, &input, &mut state, dt)
                .expect("a target for every pin");
        }
        let speed = state.velocities[4].y;
        found = [found[0].min(speed), found[1].max(speed)];
    }
    found
}

#[test]
fn each_method_returns_a_particle_at_its_own_speed() {
    // Found by an independent program, all phases swept.
    let rk4 = Integrator::RungeKutta(RungeKutta::CLASSICAL);
    let (stage, step) = (ContactEvaluation::PerStage, ContactEvaluation::PerStep);
    for (integrator, evaluation, phase_step, [low, high]) in [
        (Integrator::FbEuler, stage, 1.0, [1.0, 1.0]),
        // Explicit Euler throws cloth off the body.
        (Integrator::Euler, stage, 0.1, [1.15, 1.19]),
        (Integrator::Euler, stage, 0.5, [1.9, 2.2]),
        (Integrator::Euler, stage, 1.0, [2.9, 4.1]),
        (rk4, stage, 0.5, [0.97, 1.03]),
        (rk4, stage, 1.0, [0.85, 1.10]),
        // Contact looked at once a step makes the best method as bad.
        (rk4, step, 0.1, [1.06, 1.10]),
        (rk4, step, 0.5, [1.40, 1.53]),
        (rk4, step, 1.0, [1.75, 2.27]),
    ] {
        let [least, greatest] = bounce_of(integrator, evaluation, phase_step);
        assert!(
            low - 1e-9 <= least && greatest <= high + 1e-9,
            "{integrator:?} {evaluation:?} {phase_step}: {least} {greatest}"
        );
    }
}

#[test]
fn a_chosen_bounce_is_what_comes_back() {
    let (mass, stiffness) = (2.0e-4, 500.0);
    let dt = 1e-7;
    for response in [Response::Clamped, Response::AsPrinted] {
        for bounce in [1.0, 0.8, 0.5, 0.2] {
            let penalty = Penalty::with_bounce(stiffness, mass, bounce, response);
            let law = match response {
                Response::Clamped => paper::penalty_force,
                Response::AsPrinted => paper::penalty_force_as_printed,
            };
            let mut position = DVec3::NEG_Y * 1e-12;
            let mut velocity = DVec3::NEG_Y;
            while position.y < 0.0 {
                let force = law(-position.y, -velocity.y, penalty.stiffness, penalty.damping);
                let acceleration = paper::acceleration(mass, DVec3::Y * force);
                (position, velocity) = paper::fb_euler(position, velocity, acceleration, dt);
            }
            assert!(
                (velocity.y - bounce).abs() < 2e-3,
                "{response:?} {bounce}: {}",
                velocity.y
            );
        }
    }
}

#[test]
fn printed_skin_is_sticky() {
    let pull = paper::penalty_force_as_printed(0.001, -2.0, 100.0, 1.0);
    assert!((pull - -1.9).abs() < 1e-12, "{pull}");
    assert!(paper::penalty_force(0.001, -2.0, 100.0, 1.0).abs() < f64::MIN_POSITIVE);
}

#[test]
fn a_printed_cylinder_has_no_ends() {
    let body = MovingCapsule::at_rest(&Capsule::uniform(Vec3::ZERO, Vec3::X, 0.1), 0.0);
    let beyond = DVec3::new(7.0, 0.05, 0.0);
    assert!(body.contact(beyond).is_none());
    let depth = body.contact_unbounded(beyond).expect("inside").depth;
    assert!((depth - 0.05).abs() < 1e-8, "{depth}");
    let beside = DVec3::new(0.5, 0.05, 0.0);
    assert_eq!(body.contact(beside), body.contact_unbounded(beside));
}

#[test]
fn a_particle_tunnels_when_a_step_carries_it_past_the_axis() {
    // At ω Δt = 1 the penalty stops a particle exactly `v Δt` deep, whatever the phase.
    let (radius, dt) = (0.04, 1.0 / 60.0);
    let model = one_particle();
    let config = ExplicitConfig {
        penalty: Penalty::new(model.masses()[4] / (dt * dt), 0.0),
        ..still(1)
    };
    let capsule = [Capsule::uniform(Vec3::NEG_X, Vec3::X, radius)];
    let radius = f64::from(radius);
    let pin_targets = [DVec3::splat(100.0); 8];
    let input = ReferenceInput {
        time: 0.0,
        pin_targets: &pin_targets,
        capsules: &capsule,
    };
    for (share, side) in [(0.97, 1.0), (1.03, -1.0)] {
        let speed = share * radius / dt;
        let mut positions = vec![DVec3::splat(100.0); 9];
        positions[4] = DVec3::Y * (radius * (1.0 + 1e-9));
        let mut state = ReferenceState::at_rest(positions);
        state.velocities[4] = DVec3::NEG_Y * speed;
        for _ in 0..30 {
            explicit::step(&model, &config, &input, &mut state, dt)
                .expect("a target for every pin");
        }
        assert!(
            state.positions[4].y * side > radius,
            "{share}: {}",
            state.positions[4].y
        );
    }
}

/// One free particle of a cloth without springs, all others pinned far away.
fn one_particle() -> ReferenceModel {
    let mut spec = spec(3, 3, Topology::Sheet, [0.02; 2]);
    spec.pinned = vec![true; 9];
    spec.pinned[4] = false;
    model(&spec, SpringConstants::default())
}

/// The particle after `seconds` on a capsule that moves from the first to the second.
fn after(
    config: &ExplicitConfig,
    position: DVec3,
    capsules: [Capsule; 2],
    seconds: f64,
) -> ReferenceState {
    let model = one_particle();
    let mut positions = vec![DVec3::splat(100.0); 9];
    positions[4] = position;
    let mut state = ReferenceState::at_rest(positions);
    state.capsules = vec![capsules[0]];
    let input = ReferenceInput {
        time: 0.0,
        pin_targets: &[DVec3::splat(100.0); 8],
        capsules: &capsules[1..],
    };
    explicit::step(&model, config, &input, &mut state, seconds).expect("a target for every pin");
    state
}

/// Contact of the one particle: natural frequency 500 rad/s, critically damped.
fn firm_contact(friction: f64) -> ExplicitConfig {
    let mass = one_particle().masses()[4];
    let mut config = still(1);
    config.substeps = Substeps::Automatic;
    config.gravity = DVec3::NEG_Y * 9.81;
    config.penalty = Penalty {
        friction,
        ..Penalty::new(mass * 500.0 * 500.0, 2.0 * mass * 500.0)
    };
    config
}

#[test]
fn a_particle_rests_as_deep_as_its_weight_presses() {
    let config = firm_contact(0.0);
    let mass = one_particle().masses()[4];
    let capsule = Capsule::uniform(Vec3::new(-1.0, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0), 0.5);
    let state = after(&config, DVec3::Y * 0.501, [capsule; 2], 0.5);
    let depth = 0.5 - state.positions[4].y;
    let expected = mass * 9.81 / config.penalty.stiffness;
    assert!((depth / expected - 1.0).abs() < 1e-6, "{depth} {expected}");
}

#[test]
fn the_contact_offset_lifts_the_cloth_off_the_skin() {
    let mut config = firm_contact(0.0);
    config.penalty.contact_offset = 0.003;
    let capsule = Capsule::uniform(Vec3::new(-1.0, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0), 0.5);
    let state = after(&config, DVec3::Y * 0.503, [capsule; 2], 0.5);
    assert!((state.positions[4].y - 0.503).abs() < 1e-4);
}

#[test]
fn a_particle_sticks_below_the_angle_of_friction_and_slides_above() {
    let friction: f64 = 0.3;
    let config = firm_contact(friction);
    let critical = trig64::atan2(friction, 1.0);
    let radius = 2.0;
    let capsule = Capsule::uniform(Vec3::new(0.0, 0.0, -1.0), Vec3::new(0.0, 0.0, 1.0), 2.0);
    let creep = |angle: f64| {
        let (sin, cos) = trig64::sin_cos(angle);
        let start = DVec3::new(sin, cos, 0.0) * radius;
        let half = after(&config, start, [capsule; 2], 0.1);
        half.velocities[4].length()
    };
    let half_degree = 0.5f64.to_radians();
    assert!(creep(critical - half_degree) < 1e-4);
    let steep = critical + half_degree;
    let (sin, cos) = trig64::sin_cos(steep);
    let expected = 9.81 * (sin - friction * cos) * 0.1;
    let found = creep(steep);
    assert!(
        0.7 * expected < found && found < 1.3 * expected,
        "{found} {expected}"
    );
}

#[test]
fn friction_carries_a_particle_along_with_a_moving_limb() {
    let capsule = |x: f32| {
        Capsule::uniform(
            Vec3::new(x - 3.0, 0.0, 0.0),
            Vec3::new(x + 3.0, 0.0, 0.0),
            0.5,
        )
    };
    let config = firm_contact(0.5);
    // A limb at 0.4 m/s takes v / (μ g) = 0.08 s to take the particle along.
    let state = after(
        &config,
        DVec3::Y * 0.49996,
        [capsule(0.0), capsule(0.2)],
        0.5,
    );
    assert!(
        (state.velocities[4].x - 0.4).abs() < 1e-3,
        "{}",
        state.velocities[4]
    );
    let lost = 0.4 * 0.4 / (2.0 * 0.5 * 9.81);
    assert!(
        (state.positions[4].x - (0.2 - lost)).abs() < 0.001,
        "{}",
        state.positions[4]
    );
}
