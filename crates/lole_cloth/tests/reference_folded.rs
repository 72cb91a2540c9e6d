//! The reference in cloth that lies in folds: its substeps follow the cloth, and it stays whole.

use glam::DVec3;
use lole_cloth::collision::penalty::Penalty;
use lole_cloth::diagnose::{self, StrainSummary};
use lole_cloth::method::explicit::{self, ExplicitConfig, HighestMode, ReferenceInput};
use lole_cloth::method::reference::{ReferenceModel, ReferenceState};
use lole_cloth::scenes::{FRAME_DT, SCENES};

/// Duration of a frame [s].
const DT: f64 = FRAME_DT as f64;

/// The scene `skirt` after so many frames without capsules, in the substeps that the reference
/// chooses: its model, where it hangs [m], and its strain.
fn skirt(frames: u32) -> (ReferenceModel, Vec<DVec3>, StrainSummary) {
    let scene = SCENES.iter().find(|scene| scene.name == "skirt");
    let setup = (scene.expect("a scene of that name").build)();
    let model = ReferenceModel::new(&setup.spec).expect("a sound cloth");
    let places = setup.positions.iter().map(|place| place.as_dvec3());
    let mut state = ReferenceState::at_rest(places.collect());
    let pins: Vec<DVec3> = (model.pin_indices().iter())
        .map(|&pin| state.positions[pin as usize])
        .collect();
    // Contact would ask for more substeps than the cloth.
    let config = ExplicitConfig {
        penalty: Penalty::new(0.0, 0.0),
        ..ExplicitConfig::for_model(&model, DT)
    };
    for frame in 0..frames {
        let input = ReferenceInput {
            time: f64::from(frame) * DT,
            pin_targets: &pins,
            capsules: &[],
        };
        explicit::step(&model, &config, &input, &mut state, DT).expect("a target for every pin");
    }
    let narrow = state.positions.iter().map(|place| place.as_vec3());
    let strain = diagnose::strain(&setup.spec, &narrow.collect::<Vec<_>>());
    (model, state.positions, strain)
}

#[test]
fn a_gathered_skirt_stays_whole_because_its_substeps_follow_its_folds() {
    let (model, positions, strain) = skirt(30);
    assert!(strain.mean < 0.03 && strain.max < 0.2, "{strain:?}");
    let highest = HighestMode::of(&model, &positions, 300).frequency;
    let flat = model.largest_frequency_bound() / highest;
    let here = model.largest_frequency_bound_at(&positions) / highest;
    assert!(
        (1.0..1.4).contains(&here),
        "{here} of the frequency, {flat} when flat"
    );
}

#[test]
fn flat_cloth_takes_the_substeps_of_its_flat_bound() {
    let scene = SCENES.iter().find(|scene| scene.name == "hang-64");
    let setup = (scene.expect("a scene of that name").build)();
    let model = ReferenceModel::new(&setup.spec).expect("a sound cloth");
    let flat: Vec<DVec3> = setup
        .positions
        .iter()
        .map(|place| place.as_dvec3())
        .collect();
    let config = ExplicitConfig::for_model(&model, DT);
    let [expected, found] = [
        model.stable_substeps(DT, &config.penalty),
        model.stable_substeps_at(&flat, DT, &config.penalty),
    ];
    assert!(
        (expected..=expected + expected / 50).contains(&found),
        "{found} of {expected}"
    );
}
