//! Static drape: it ends where the reference comes to rest, says so, and obeys who calls it.

mod reference_support;

use std::num::NonZeroU32;
use std::ops::ControlFlow;

use glam::Vec3;
use lole_cloth::collision::penalty::Penalty;
use lole_cloth::method::explicit::{self, ExplicitConfig};
use lole_cloth::method::reference::{ReferenceModel, ReferenceState};
use lole_cloth::method::settle::{Drape, SettleConfig, settle};
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Fabric, MassLaw, SolverConfig, StepInput, Topology,
    state_hash,
};
use lole_geom::{Capsule, trig};
use reference_support::{held_pins, spec};

const FABRIC: Fabric = Fabric {
    areal_density: 0.15,
    thickness: 0.4e-3,
    stretch: [600.0; 2],
    shear: 40.0,
    bend: [2.0e-5; 2],
    twist: 1.5e-5,
    hysteresis: lole_cloth::Hysteresis::NONE,
    friction: 0.3,
    cloth_friction: 0.3,
    drag_rate: 0.0,
};

/// A cloth and where it starts.
struct Case {
    spec: ClothSpec,
    positions: Vec<Vec3>,
}

/// A strip that is clamped level: 8 cells of 12.5 mm on its free length, its bending length 24 mm;
/// so wide that its free edges, half as stiff in the reference, hardly count.
fn cantilever() -> Case {
    let mut spec = spec(25, 10, Topology::Sheet, [0.0125; 2]);
    spec.mass = MassLaw::AreaWeighted;
    spec.fabric = FABRIC;
    spec.pinned[..50].fill(true);
    let positions = level(&spec);
    Case { spec, positions }
}

/// A curtain of 0.3 m whose rail is a wave, lifted to one side.
fn curtain() -> Case {
    let columns = 25;
    let mut spec = spec(columns, 17, Topology::Sheet, [0.0125, 0.02]);
    spec.fabric = FABRIC;
    spec.pinned[..columns as usize].fill(true);
    let mut positions = Vec::new();
    for row in 0..17_u8 {
        for [x, z] in wave(columns, 0.0125, 0.02) {
            let down = 0.02 * f32::from(row);
            positions.push(Vec3::new(x, -0.8 * down, z + 0.6 * down));
        }
    }
    Case { spec, positions }
}

/// Points `spacing` apart on two waves of this height, each about 0.13 m long.
fn wave(count: u32, spacing: f32, height: f32) -> Vec<[f32; 2]> {
    let mut points = Vec::new();
    let mut x = 0.0_f32;
    for _ in 0..count {
        let phase = std::f32::consts::TAU * x / 0.13;
        points.push([x, height * trig::sin(phase)]);
        let slope = height * std::f32::consts::TAU / 0.13 * trig::cos(phase);
        x += spacing / (1.0 + slope * slope).sqrt();
    }
    points
}

/// A handkerchief of 0.3 m that hangs from two corners, started level.
fn handkerchief() -> Case {
    let mut spec = spec(13, 13, Topology::Sheet, [0.025; 2]);
    spec.fabric = FABRIC;
    spec.pinned[0] = true;
    spec.pinned[12] = true;
    Case {
        positions: level(&spec),
        spec,
    }
}

fn level(spec: &ClothSpec) -> Vec<Vec3> {
    let [h_u, h_v] = spec.grid.spacing;
    (0..spec.grid.row_count)
        .flat_map(|row| (0..spec.grid.column_count).map(move |column| (row, column)))
        .map(|(row, column)| Vec3::new(h_u * column as f32, 0.0, h_v * row as f32))
        .collect()
}

fn config(substep_count: u32) -> SolverConfig {
    SolverConfig {
        substep_count: NonZeroU32::new(substep_count).expect("a count"),
        ..SolverConfig::default()
    }
}

fn settled(
    case: &Case,
    (config, settle_config): (&SolverConfig, &SettleConfig),
    capsules: &[Capsule],
) -> (Drape, Vec<Vec3>, u64) {
    let model = ClothModel::new(&case.spec).expect("the cloth is valid");
    let pins: Vec<Vec3> = (model.pin_indices().iter())
        .map(|&pin| case.positions[pin as usize])
        .collect();
    let mut state = ClothState::new(&model, &case.positions);
    let input = StepInput {
        pin_targets: &pins,
        capsules,
        ..StepInput::default()
    };
    let both = (config, settle_config);
    let drape = settle(&model, both, &input, &mut state, |_| {
        ControlFlow::Continue(())
    });
    let mut positions = Vec::new();
    state.copy_positions(&model, &mut positions);
    (
        drape.expect("a target for every pin"),
        positions,
        state_hash(&state),
    )
}

/// Where `fb-euler` comes to rest: it swings for a second, then in air as thick as honey.
fn reference_rest(spec: &ClothSpec, start: &[Vec3]) -> Vec<Vec3> {
    let start = start.iter().map(|p| p.as_dvec3()).collect();
    let mut state = ReferenceState::at_rest(start);
    for (drag_rate, seconds) in [(0.0, 1), (8.0, 12)] {
        let mut spec = spec.clone();
        spec.fabric.drag_rate = drag_rate;
        let model = ReferenceModel::new(&spec).expect("the cloth is valid");
        let config = ExplicitConfig {
            penalty: Penalty::new(0.0, 0.0),
            ..ExplicitConfig::for_model(&model, 1.0)
        };
        let pin_targets = held_pins(&model, &state);
        let input = explicit::ReferenceInput {
            time: 0.0,
            pin_targets: &pin_targets,
            capsules: &[],
        };
        for _ in 0..seconds {
            explicit::step(&model, &config, &input, &mut state, 1.0)
                .expect("a target for every pin");
        }
    }
    let fastest = (state.velocities.iter()).fold(0.0_f64, |most, v| most.max(v.length()));
    assert!(fastest < 1e-4, "the reference still moves at {fastest} m/s");
    state.positions.iter().map(|p| p.as_vec3()).collect()
}

fn rms_distance(left: &[Vec3], right: &[Vec3]) -> f32 {
    let sum: f32 = (left.iter().zip(right))
        .map(|(a, b)| a.distance_squared(*b))
        .sum();
    (sum / left.len() as f32).sqrt()
}

/// Folded cloth has more than one rest, and which one it finds hangs on how it came down; so what
/// is asked of the drape is that the reference, let go from there, stays.
#[test]
fn the_drape_is_a_rest_of_the_reference() {
    let settle_config = SettleConfig {
        residual: 5e-4,
        frame_limit: 2000,
        ..SettleConfig::default()
    };
    for (name, case, size) in [
        ("cantilever", cantilever(), 0.1),
        ("curtain", curtain(), 0.32),
    ] {
        let (drape, found, _) = settled(&case, (&config(40), &settle_config), &[]);
        assert!(matches!(drape, Drape::Settled { .. }), "{name}: {drape:?}");
        let truth = reference_rest(&case.spec, &found);
        let apart = rms_distance(&truth, &found) / size;
        assert!(apart < 0.006, "{name}: {apart} of its length, {drape:?}");
    }
}

/// What bends but does not buckle has one rest, wherever it starts.
#[test]
fn the_only_rest_is_found_from_afar() {
    let case = cantilever();
    let settle_config = SettleConfig {
        residual: 5e-4,
        frame_limit: 2000,
        ..SettleConfig::default()
    };
    let (_, found, _) = settled(&case, (&config(40), &settle_config), &[]);
    let truth = reference_rest(&case.spec, &case.positions);
    let apart = rms_distance(&truth, &found) / 0.1;
    assert!(apart < 0.006, "{apart} of its length");
}

/// Layers that slide on each other weigh and bend as many times as much as one, in both methods.
#[test]
fn loose_layers_hang_as_one_does() {
    let one = cantilever();
    let mut case = cantilever();
    case.spec.row_layers.fill(3.0);
    let settle_config = SettleConfig {
        residual: 5e-4,
        frame_limit: 2000,
        ..SettleConfig::default()
    };
    let rest = |case: &Case| settled(case, (&config(40), &settle_config), &[]).1;
    let apart = rms_distance(&rest(&one), &rest(&case)) / 0.1;
    assert!(apart < 0.006, "{apart} of its length");
    let rest = |case: &Case| reference_rest(&case.spec, &case.positions);
    let apart = rms_distance(&rest(&one), &rest(&case)) / 0.1;
    assert!(apart < 0.006, "{apart} of its length by the reference");
}

#[test]
fn a_cloth_over_a_capsule_comes_to_rest_and_stays_there() {
    let mut case = handkerchief();
    case.spec.pinned.fill(false);
    let capsule = Capsule::uniform(
        Vec3::new(-0.2, -0.08, 0.15),
        Vec3::new(0.5, -0.08, 0.15),
        0.05,
    );
    let both = (&config(12), &SettleConfig::default());
    let (drape, rest, _) = settled(&case, both, &[capsule]);
    let Drape::Settled { residual, .. } = drape else {
        panic!("{drape:?}");
    };
    assert!(residual <= SettleConfig::default().residual);
    let lowest = rest.iter().fold(f32::INFINITY, |low, p| low.min(p.y));
    assert!(-0.3 < lowest, "it slid off: {lowest}");
    // Let go for a second, it hardly moves.
    case.positions.clone_from(&rest);
    let second = SettleConfig {
        frame_limit: 60,
        residual: -1.0,
        lowering_frame_count: 0,
        ..SettleConfig::default()
    };
    let (_, later, _) = settled(&case, (&config(12), &second), &[capsule]);
    let apart = rms_distance(&rest, &later);
    assert!(apart < 2e-3, "{apart} m");
}

#[test]
fn a_drape_has_the_same_bits_every_time() {
    let case = handkerchief();
    let both = (&config(12), &SettleConfig::default());
    let (first, second) = (settled(&case, both, &[]), settled(&case, both, &[]));
    assert_eq!(first.0, second.0);
    assert_eq!(first.2, second.2);
}

#[test]
fn it_is_given_up_at_the_limit_and_broken_off_on_request() {
    let case = handkerchief();
    let short = SettleConfig {
        frame_limit: 20,
        ..SettleConfig::default()
    };
    let (drape, ..) = settled(&case, (&config(12), &short), &[]);
    assert!(matches!(drape, Drape::GivenUp { .. }), "{drape:?}");
    let model = ClothModel::new(&case.spec).expect("the cloth is valid");
    let mut state = ClothState::new(&model, &case.positions);
    let pins = [case.positions[0], case.positions[12]];
    let input = StepInput {
        pin_targets: &pins,
        capsules: &[],
        ..StepInput::default()
    };
    let mut frames = Vec::new();
    let both = (&config(12), &SettleConfig::default());
    let drape = settle(&model, both, &input, &mut state, |progress| {
        frames.push(progress.frame);
        if progress.frame == 7 {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    });
    assert_eq!(drape, Ok(Drape::Interrupted { frame_count: 7 }));
    assert_eq!(frames, [1, 2, 3, 4, 5, 6, 7]);
}
