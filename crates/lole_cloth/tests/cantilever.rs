//! Plate bending against the heavy elastica: a strip clamped level hangs as far as it must.

mod reference_support;

use glam::DVec3;
use lole_cloth::collision::penalty::Penalty;
use lole_cloth::method::explicit::{self, ExplicitConfig, ReferenceInput};
use lole_cloth::method::reference::{ReferenceModel, ReferenceState, SpringConstants};
use lole_cloth::{MassLaw, Topology};
use reference_support::{held_pins, model, rest_positions, spec};

/// `Γ = w L³ / B` and the height over width of the hanging strip, from
/// `θ'' = -Γ (1 - s) cos θ`, `θ(0) = 0`, `θ'(1) = 0`, integrated by an independent program.
const ELASTICA: [(f64, f64); 4] = [
    (1.0, 0.12456),
    (8.0, 0.88433),
    (10.0, 1.06680),
    (30.0, 2.54721),
];

/// Free length of the strip [m].
const LENGTH: f32 = 0.2;

/// Height over width of the free part of a clamped strip with this `Γ`, at rest, in so many
/// segments.
fn height_over_width(gamma: f64, segments: u16) -> f64 {
    let spacing = LENGTH / f32::from(segments);
    let length = f64::from(segments) * f64::from(spacing);
    let mut spec = spec(3, u32::from(segments) + 2, Topology::Sheet, [spacing; 2]);
    spec.mass = MassLaw::AreaWeighted;
    spec.pinned[..6].fill(true);
    // Near the critical damping 2 ω of the slowest swing, ω² ≈ 12 g / (Γ L) + 1.5 g / L.
    spec.fabric.drag_rate = 17.0;
    let weight = f64::from(spec.fabric.areal_density) * 9.81;
    let rigidity = weight * length * length * length / gamma;
    // Inextensible enough: the strip's own weight stretches it by 2.5e-4.
    let stretch = 4e3 * weight * length;
    let constants = SpringConstants {
        structural_v: stretch,
        plate_v: rigidity,
        ..SpringConstants::default()
    };
    let model = model(&spec, constants);
    // The strip lies level along x, its clamp at the origin.
    let mut state = ReferenceState::at_rest(
        rest_positions(model.grid())
            .iter()
            .map(|flat| DVec3::new(-flat.y - f64::from(spacing), 0.0, flat.x))
            .collect(),
    );
    settle(&model, &mut state);
    let tip = state.positions[state.positions.len() - 2];
    -tip.y / tip.x
}

/// Lets the strip swing out in thick air.
fn settle(model: &ReferenceModel, state: &mut ReferenceState) {
    let config = ExplicitConfig {
        penalty: Penalty::new(0.0, 0.0),
        ..ExplicitConfig::for_model(model, 1.0)
    };
    let pin_targets = held_pins(model, state);
    let input = ReferenceInput {
        time: 0.0,
        pin_targets: &pin_targets,
        capsules: &[],
    };
    explicit::step(model, &config, &input, state, 3.0).expect("a target for every pin");
    let speed = (state.velocities.iter()).fold(0.0, |most: f64, v| most.max(v.length()));
    assert!(speed < 1e-5, "still moving at {speed} m/s");
}

#[test]
fn a_clamped_strip_hangs_like_the_elastica() {
    for (gamma, expected) in ELASTICA {
        let error = height_over_width(gamma, 24) / expected - 1.0;
        assert!(error.abs() < 0.01, "Γ = {gamma}: {error}");
    }
}

#[test]
fn the_clamp_converges_with_the_square_of_the_spacing() {
    // A clamp whose arm is a whole cell too long converges only with the spacing itself.
    let (gamma, expected) = ELASTICA[1];
    let error = |segments| height_over_width(gamma, segments) / expected - 1.0;
    let ratio = error(10) / error(20);
    assert!((3.5..4.6).contains(&ratio), "{ratio}");
}
