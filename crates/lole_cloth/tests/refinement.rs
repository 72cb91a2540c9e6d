//! What stays the same when steps grow shorter or the world is mirrored, and where energy goes.

mod reference_support;
mod xpbd_support;

use std::num::NonZeroU32;

use glam::{DVec3, Vec3};
use lole_cloth::collision::penalty::Penalty;
use lole_cloth::method::explicit::{self, ExplicitConfig, ReferenceInput, Substeps};
use lole_cloth::method::reference::{ReferenceModel, ReferenceState};
use lole_cloth::{ClothSpec, MassLaw};
use reference_support::held_pins;
use xpbd_support::{FABRIC, World, flat_positions, sheet_spec};

const COUNT: u32 = 21;
const SPACING: f32 = 0.02;
/// Duration of a frame [s].
const FRAME: f64 = 1.0 / 60.0;

/// A sheet that hangs from two corners and starts level, its middle column on the plane `x = 0`.
fn swing() -> (ClothSpec, Vec<Vec3>) {
    let mut fabric = FABRIC;
    fabric.stretch = [100.0; 2];
    fabric.shear = 20.0;
    let mut spec = sheet_spec(COUNT, COUNT, SPACING, fabric);
    spec.mass = MassLaw::AreaWeighted;
    spec.pinned[0] = true;
    spec.pinned[COUNT as usize - 1] = true;
    let half = 0.5 * SPACING * (COUNT - 1) as f32;
    let positions = flat_positions(COUNT, COUNT, SPACING)
        .iter()
        .map(|&place| place - Vec3::X * half)
        .collect();
    (spec, positions)
}

/// Where it is after a third of a second of so many substeps a frame.
fn swung(substeps: u32) -> Vec<Vec3> {
    let (spec, positions) = swing();
    let mut world = World::new(&spec, &positions).with_substeps(substeps);
    world.config.tether_scale = None;
    world.config.column_strides.clear();
    for _ in 0..20 {
        world.step(&[]);
    }
    world.positions()
}

fn rms_distance(first: &[Vec3], second: &[Vec3]) -> f32 {
    let sum: f32 = (first.iter().zip(second))
        .map(|(a, b)| a.distance_squared(*b))
        .sum();
    (sum / first.len() as f32).sqrt()
}

/// Where the reference has it by then, with many times the substeps that it needs.
fn swung_by_reference() -> Vec<DVec3> {
    let (spec, positions) = swing();
    let model = ReferenceModel::new(&spec).expect("a sound specification");
    let mut state = ReferenceState::at_rest(positions.iter().map(|p| p.as_dvec3()).collect());
    let config = ExplicitConfig {
        penalty: Penalty::new(0.0, 0.0),
        substeps: Substeps::Fixed(NonZeroU32::MIN.saturating_add(399)),
        ..ExplicitConfig::for_model(&model, FRAME)
    };
    let pin_targets = held_pins(&model, &state);
    let input = ReferenceInput {
        time: 0.0,
        pin_targets: &pin_targets,
        capsules: &[],
    };
    for _ in 0..20 {
        explicit::step(&model, &config, &input, &mut state, FRAME).expect("a target for every pin");
    }
    state.positions
}

#[test]
fn half_the_substep_is_half_the_error() {
    let truth: Vec<Vec3> = (swung_by_reference().iter()).map(|p| p.as_vec3()).collect();
    let errors = [20, 40, 80].map(|count| rms_distance(&swung(count), &truth));
    for pair in errors.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((1.6..2.6).contains(&ratio), "{errors:?}");
    }
}

/// Farthest that a particle is from the mirror image of its partner [m].
fn asymmetry(positions: &[DVec3]) -> f64 {
    let count = COUNT as usize;
    let mut worst = 0.0_f64;
    for row in positions.chunks_exact(count) {
        for column in 0..count {
            let image = row[count - 1 - column] * DVec3::new(-1.0, 1.0, 1.0);
            worst = worst.max(row[column].distance(image));
        }
    }
    worst
}

#[test]
fn the_reference_knows_no_left_and_right() {
    // Rounding grows in what buckles, so not for long and not to the last bit.
    let found = asymmetry(&swung_by_reference());
    assert!(found < 1.0e-7, "{found} m");
}

#[test]
fn the_real_time_method_hardly_knows_left_and_right() {
    // It solves a row from one side, which costs it symmetry within a substep.
    let positions: Vec<DVec3> = swung(20).iter().map(|p| p.as_dvec3()).collect();
    let width = f64::from(SPACING) * f64::from(COUNT - 1);
    let found = asymmetry(&positions);
    assert!(found < 2.0e-3 * width, "{found} m");
}

#[test]
fn a_swinging_sheet_never_gains_energy() {
    let (spec, positions) = swing();
    let model = ReferenceModel::new(&spec).expect("a sound specification");
    let mut world = World::new(&spec, &positions);
    let energy = |world: &World| {
        let [positions, velocities] = [world.positions(), world.velocities()]
            .map(|vectors| -> Vec<DVec3> { vectors.iter().map(|v| v.as_dvec3()).collect() });
        let free = model.masses().iter().zip(model.pinned()).zip(&positions);
        let height: f64 = free
            .filter(|((_, is_pinned), _)| !**is_pinned)
            .map(|((mass, _), position)| 9.81 * mass * position.y)
            .sum();
        height
            + model.kinetic_energy(&velocities)
            + model.spring_energy(&positions)
            + model.plate_energy(&positions)
    };
    let mass: f64 = model.masses().iter().sum();
    // What the sheet would lose by falling its own length.
    let scale = mass * 9.81 * f64::from(SPACING) * f64::from(COUNT - 1);
    let mut least = energy(&world);
    let first = least;
    for frame in 0..300 {
        world.step(&[]);
        let now = energy(&world);
        assert!(
            now < least + 0.01 * scale,
            "{frame}: {now} J after {least} J"
        );
        least = least.min(now);
    }
    assert!(least < first - 0.1 * scale, "it swings and calms down");
}
