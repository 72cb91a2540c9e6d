//! Round specimens on a disc, after Cusick.

mod drape_support;

use drape_support::square;
use lole_cloth::drape_test::RoundDrape;
use lole_cloth::{Fabric, Hysteresis};

/// An isotropic sheet with this bending length `(B / w)^(1/3)` [m].
fn sheet(length: f32) -> Fabric {
    let bend = 0.15 * 9.81 * length * length * length;
    Fabric {
        areal_density: 0.15,
        thickness: 3.0e-4,
        stretch: [100.0; 2],
        shear: 50.0,
        bend: [bend; 2],
        twist: bend,
        hysteresis: Hysteresis::NONE,
        friction: 0.0,
        cloth_friction: 0.0,
        drag_rate: 0.0,
    }
}

#[test]
fn a_stiffer_sheet_drapes_less_and_never_more_than_its_strips() {
    // Strips clamped level from the edge of the disc, as heavy elasticas. Whole cloth is stiffer,
    // because between its folds it would have to bend two ways at once: the limper, the more.
    let estimates = [(0.02, 0.31), (0.025, 0.49), (0.03, 0.68)];
    let mut last = 0.0;
    for (length, estimate) in estimates {
        let found = RoundDrape::BS.hang(sheet(length)).expect("a sound piece");
        assert!(last < found.coefficient, "{length}: {found:?}");
        assert!(
            (0.1..0.4).contains(&(found.coefficient - estimate)),
            "{length}: {found:?}"
        );
        assert!((4..=9).contains(&found.folds), "{length}: {found:?}");
        last = found.coefficient;
    }
}

#[test]
fn yarns_that_rub_hold_the_cloth_up() {
    let elastic = sheet(0.02);
    let rubbing = Fabric {
        hysteresis: Hysteresis {
            bend: [50.0 * elastic.bend[0]; 2],
            shear: 0.04 * elastic.shear,
        },
        ..elastic
    };
    let [elastic, rubbing] = [elastic, rubbing].map(|fabric| square(fabric, RoundDrape::BS));
    assert!(
        elastic.coefficient + 0.05 < rubbing.coefficient,
        "{elastic:?} {rubbing:?}"
    );
}
