//! Laws of fuller cloth that is sewn to the lower part of a grid.

mod xpbd_support;

use glam::Vec3;
use lole_cloth::method::explicit_rows::ExplicitModel;
use lole_cloth::method::reference::ReferenceModel;
use lole_cloth::model::particle_masses;
use lole_cloth::{BuildError, ClothModel, ClothSpec, Flounce, MassLaw, diagnose};
use xpbd_support::{FABRIC, World, bulged_positions, row_lengths, sheet_spec};

const COLUMNS: u32 = 48;
const ROWS: u32 = 20;
const SEAM: u32 = 8;
const SPACING: f32 = 0.01;

fn flounced(fullness: f32) -> ClothSpec {
    let mut spec = sheet_spec(COLUMNS, ROWS, SPACING, FABRIC);
    spec.grid.flounce = Some(Flounce {
        seam_row: SEAM,
        fullness,
    });
    spec
}

#[test]
fn it_weighs_what_its_cloth_weighs() {
    for mass in [MassLaw::Uniform, MassLaw::AreaWeighted] {
        let spec = ClothSpec {
            mass,
            ..flounced(1.5)
        };
        let total: f32 = particle_masses(&spec).iter().sum();
        let (above, below) = (SEAM as f32, 1.5 * (ROWS - 1 - SEAM) as f32);
        let area = (COLUMNS - 1) as f32 * SPACING * (above + below) * SPACING;
        let expected = FABRIC.areal_density * area;
        assert!((total / expected - 1.0).abs() < 1e-5, "{total} {expected}");
    }
}

#[test]
fn one_that_is_no_fuller_moves_as_plain_cloth_to_the_bit() {
    let positions = bulged_positions(COLUMNS, ROWS, SPACING);
    let plain = sheet_spec(COLUMNS, ROWS, SPACING, FABRIC);
    let [plain, flounced] =
        [plain, flounced(1.0)].map(|spec| World::new(&spec, &positions).run(30).positions());
    assert_eq!(plain, flounced);
}

#[test]
fn what_lies_as_narrow_as_the_cloth_above_opens_to_its_own_width() {
    let mut fabric = FABRIC;
    fabric.drag_rate = 4.0;
    let spec = ClothSpec {
        fabric,
        ..flounced(1.5)
    };
    let mut world = World::new(&spec, &bulged_positions(COLUMNS, ROWS, SPACING));
    world.config.gravity = Vec3::ZERO;
    let positions = world.run(180).positions();
    let lengths = row_lengths(&spec.grid, &positions);
    for (row, length) in lengths.into_iter().enumerate() {
        if row < SEAM as usize {
            assert!((length - 1.0).abs() < 0.02, "{row}: {length}");
        } else if SEAM as usize + 3 <= row {
            assert!((length - 1.5).abs() < 0.04, "{row}: {length}");
        }
    }
    // Strain is that of each row's own cloth.
    let strain = diagnose::strain(&spec, &positions);
    assert!(strain.mean < 0.02, "{strain:?}");
}

#[test]
fn what_is_no_flounce_is_refused() {
    for (seam_row, fullness) in [(0, 1.5), (ROWS - 1, 1.5), (SEAM, 0.9), (SEAM, f32::NAN)] {
        let mut spec = flounced(1.0);
        spec.grid.flounce = Some(Flounce { seam_row, fullness });
        let error = ClothModel::new(&spec).expect_err("it is refused");
        assert!(error.to_string().contains("grid.flounce"), "{error}");
    }
}

#[test]
fn other_methods_say_that_they_move_none() {
    let spec = flounced(1.5);
    let reference = ReferenceModel::new(&spec).map(drop);
    assert_eq!(reference, Err(BuildError::Flounce));
    let rows = ExplicitModel::new(&spec).map(drop);
    assert_eq!(rows, Err(BuildError::Flounce));
}
