//! Laws of strands: truth from closed forms.

use glam::Vec3;
use lole_cloth::strands::{
    Link, Ring, Strand, StrandConfig, StrandError, StrandInput, StrandModel, StrandState, Tie, step,
};
use lole_geom::{Surfel, trig64};

const FRAME: f32 = 1.0 / 60.0;

fn line(count: u16, spacing: f32, towards: Vec3) -> Vec<Vec3> {
    (0..count)
        .map(|k| towards * (f32::from(k) * spacing))
        .collect()
}

fn still() -> StrandConfig {
    StrandConfig {
        drag_rate: 0.0,
        ..StrandConfig::default()
    }
}

#[test]
fn a_mass_on_a_thread_has_the_period_of_a_pendulum() {
    // T = 2π √(L / g) (1 + θ² / 16) for a swing of θ to either side.
    let (length, swing) = (0.5_f32, 0.2_f32);
    let start = Vec3::new(0.198_669_3, -0.980_066_6, 0.0);
    let strand = Strand {
        positions: line(2, length, start),
        spacing: length,
        pinned: vec![0],
        linear_density: 0.1,
        ..Strand::default()
    };
    let strands = [strand];
    let model = StrandModel::new(&strands, &[], &[]).expect("strands");
    let mut state = StrandState::new(&strands);
    let input = StrandInput {
        pins: &[Vec3::ZERO],
        ..StrandInput::default()
    };
    let mut crossings = Vec::new();
    let mut time = 0.0;
    while crossings.len() < 5 {
        let before = state.positions[1].x;
        step(&model, &still(), &input, &mut state, FRAME).expect("a target for every pin");
        let after = state.positions[1].x;
        if before.signum() != after.signum() {
            crossings.push(time + FRAME * before / (before - after));
        }
        time += FRAME;
        assert!(time < 20.0, "it swings");
    }
    let period = (crossings[4] - crossings[0]) / 2.0;
    let wanted = std::f32::consts::TAU * (length / 9.81).sqrt() * (1.0 + swing * swing / 16.0);
    assert!(
        (period / wanted - 1.0).abs() < 0.01,
        "{period} s, {wanted} s"
    );
}

#[test]
fn a_thread_between_two_pins_hangs_as_a_catenary() {
    // Of length s over the span d, y = a cosh(x / a) with 2 a sinh(d / 2a) = s; it sags
    // a (cosh(d / 2a) - 1).
    let (span, length, count) = (0.6_f64, 0.8_f64, 41_u16);
    let mut a = 0.01;
    for _ in 0..200 {
        let excess = 2.0 * a * sinh(span / (2.0 * a)) - length;
        a *= if 0.0 < excess { 1.02 } else { 0.98 };
        if excess.abs() < 1e-6 {
            break;
        }
    }
    let mut bounds = [0.05, 5.0];
    for _ in 0..100 {
        a = 0.5 * (bounds[0] + bounds[1]);
        let is_long = length < 2.0 * a * sinh(span / (2.0 * a));
        bounds[usize::from(!is_long)] = a;
    }
    let sag =
        a * (trig64::exp(span / (2.0 * a)) * 0.5 + trig64::exp(-span / (2.0 * a)) * 0.5 - 1.0);
    let spacing = 0.8 / f32::from(count - 1);
    let strand = Strand {
        positions: line(count, 0.6 / f32::from(count - 1), Vec3::X),
        spacing,
        pinned: vec![0, u32::from(count - 1)],
        linear_density: 0.05,
        ..Strand::default()
    };
    let strands = [strand];
    let model = StrandModel::new(&strands, &[], &[]).expect("strands");
    let mut state = StrandState::new(&strands);
    let input = StrandInput {
        pins: &[Vec3::ZERO, Vec3::X * 0.6],
        ..StrandInput::default()
    };
    let config = StrandConfig {
        drag_rate: 5.0,
        substep_count: 24,
        ..StrandConfig::default()
    };
    // Straight to begin with, it needs a way to fall.
    state.positions[20].y -= 0.01;
    for _ in 0..400 {
        step(&model, &config, &input, &mut state, FRAME).expect("a target for every pin");
    }
    let lowest = state.positions.iter().map(|p| p.y).fold(0.0, f32::min);
    assert!(
        (f64::from(-lowest) / sag - 1.0).abs() < 0.02,
        "{lowest} m, {sag} m"
    );
}

fn sinh(x: f64) -> f64 {
    0.5 * (trig64::exp(x) - trig64::exp(-x))
}

#[test]
fn a_clamped_leaf_bends_as_a_cantilever() {
    // Tip deflection of a little bent beam under its weight: μ g L⁴ / (8 EI).
    let (count, spacing) = (9_u16, 0.025_f32);
    let (density, stiffness) = (0.014_f32, 1.5e-3_f32);
    let strand = Strand {
        positions: line(count, spacing, Vec3::X),
        spacing,
        pinned: vec![0, 1],
        linear_density: density,
        bend_stiffness: stiffness,
        ..Strand::default()
    };
    let strands = [strand];
    let model = StrandModel::new(&strands, &[], &[]).expect("strands");
    let mut state = StrandState::new(&strands);
    let input = StrandInput {
        pins: &[Vec3::ZERO, Vec3::X * spacing],
        ..StrandInput::default()
    };
    let config = StrandConfig {
        drag_rate: 20.0,
        substep_count: 60,
        ..StrandConfig::default()
    };
    for _ in 0..120 {
        step(&model, &config, &input, &mut state, FRAME).expect("a target for every pin");
    }
    // Clamped in the middle of the first free stretch.
    let length = spacing * (f32::from(count) - 1.5);
    let wanted = density * 9.81 * length * length * length * length / (8.0 * stiffness);
    let tip = -state.positions[8].y;
    assert!((tip / wanted - 1.0).abs() < 0.1, "{tip} m, {wanted} m");
}

/// A plane of surfels that rises by `slope` along x.
fn slope(slope: f32) -> Vec<Surfel> {
    let normal = Vec3::new(-slope, 1.0, 0.0).normalize_or_zero();
    let places = (-30_i16..30).flat_map(|x| (-10_i16..10).map(move |z| (x, z)));
    let surfel = |(x, z): (i16, i16)| {
        let x = f32::from(x) * 0.015;
        Surfel {
            position: Vec3::new(x, slope * x, f32::from(z) * 0.015),
            normal,
        }
    };
    places.map(surfel).collect()
}

/// How far a short thread has slid down a slope in a second [m], and its gap to it.
fn slid(rise: f32, friction: f32) -> (f32, f32) {
    let surfels = slope(rise);
    let normal = surfels[0].normal;
    let positions = line(4, 0.01, Vec3::Z);
    let strand = Strand {
        positions: positions.iter().map(|p| *p + normal * 0.006).collect(),
        spacing: 0.01,
        linear_density: 0.02,
        contact_offset: 0.005,
        ..Strand::default()
    };
    let strands = [strand];
    let model = StrandModel::new(&strands, &[], &[]).expect("a strand of four points");
    let mut state = StrandState::new(&strands);
    let input = StrandInput {
        surfels: &surfels,
        ..StrandInput::default()
    };
    let config = StrandConfig {
        friction,
        ..still()
    };
    for _ in 0..30 {
        step(&model, &config, &input, &mut state, FRAME).expect("a target for every pin");
    }
    let moved = state.positions[0] - strands[0].positions[0];
    (moved.length(), state.positions[0].dot(normal))
}

#[test]
fn friction_holds_up_to_its_angle_and_the_gap_is_kept() {
    let (held, gap) = slid(0.3, 0.35);
    assert!(held < 0.004, "{held} m");
    assert!((gap - 0.005).abs() < 5e-4, "{gap} m");
    // s = g (sin - μ cos) t² / 2 in half a second.
    let (slid, _) = slid(0.3, 0.1);
    let cos = 1.0 / (1.0_f32 + 0.09).sqrt();
    let wanted = 0.5 * 9.81 * cos * (0.3 - 0.1) * 0.25;
    assert!((slid / wanted - 1.0).abs() < 0.12, "{slid} m, {wanted} m");
}

#[test]
fn links_and_ties_hold_what_they_hold() {
    let strand = |x: f32| Strand {
        positions: line(5, 0.05, Vec3::NEG_Y)
            .into_iter()
            .map(|p| p + Vec3::X * x)
            .collect(),
        spacing: 0.05,
        pinned: vec![0],
        linear_density: 0.02,
        ..Strand::default()
    };
    let strands = [strand(0.0), strand(0.1)];
    let link = Link {
        particles: [4, 9],
        range: [0.02, 0.05],
        compliance: 0.0,
    };
    let tie = Tie {
        particle: 2,
        compliance: 0.0,
    };
    let model = StrandModel::new(&strands, &[link], &[tie]).expect("strands");
    let mut state = StrandState::new(&strands);
    let input = StrandInput {
        pins: &[Vec3::ZERO, Vec3::X * 0.1],
        ties: &[Vec3::new(0.0, -0.1, 0.0)],
        ..StrandInput::default()
    };
    for _ in 0..240 {
        step(&model, &StrandConfig::default(), &input, &mut state, FRAME)
            .expect("a target for every pin");
    }
    let apart = state.positions[4].distance(state.positions[9]);
    assert!(apart < 0.052, "{apart} m");
    let away = state.positions[2].distance(Vec3::new(0.0, -0.1, 0.0));
    assert!(away < 0.002, "{away} m");
}

#[test]
fn what_cannot_be_prepared_is_refused() {
    let ring = Strand {
        positions: line(2, 0.1, Vec3::X),
        spacing: 0.1,
        ring: Ring::Closed,
        linear_density: 0.1,
        ..Strand::default()
    };
    let error = StrandModel::new(&[ring], &[], &[]).expect_err("refused");
    assert_eq!(error.to_string(), "strand 0 has 2 particles; it needs 3");
    let weightless = Strand {
        positions: line(2, 0.1, Vec3::X),
        spacing: 0.1,
        ..Strand::default()
    };
    let error = StrandModel::new(&[weightless], &[], &[]).expect_err("refused");
    assert!(matches!(
        error,
        StrandError::OutOfRange {
            field: "linear_density",
            ..
        }
    ));
}
