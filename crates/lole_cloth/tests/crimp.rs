//! Laws of cloth that lies shorter than it is, because it is crimped.

mod xpbd_support;

use glam::Vec3;
use lole_cloth::method::explicit_rows::ExplicitModel;
use lole_cloth::method::reference::ReferenceModel;
use lole_cloth::model::particle_masses;
use lole_cloth::{BuildError, ClothModel, ClothSpec, Crimp, MassLaw, diagnose};
use xpbd_support::{FABRIC, World, bulged_positions, row_lengths, sheet_spec};

const COLUMNS: u32 = 48;
const ROWS: u32 = 24;
const SPACING: f32 = 0.01;

fn crimped(share: f32) -> ClothSpec {
    let mut spec = sheet_spec(COLUMNS, ROWS, SPACING, FABRIC);
    spec.grid.crimp = Some(Crimp {
        share,
        last_row: 4,
        open_row: 14,
    });
    spec
}

#[test]
fn it_weighs_what_its_cloth_weighs() {
    for mass in [MassLaw::Uniform, MassLaw::AreaWeighted] {
        let masses = |share| {
            particle_masses(&ClothSpec {
                mass,
                ..crimped(share)
            })
        };
        assert_eq!(masses(0.4), masses(1.0));
    }
}

#[test]
fn cloth_that_is_not_pushed_together_moves_as_plain_cloth_to_the_bit() {
    let positions = bulged_positions(COLUMNS, ROWS, SPACING);
    let plain = sheet_spec(COLUMNS, ROWS, SPACING, FABRIC);
    let [plain, crimped] =
        [plain, crimped(1.0)].map(|spec| World::new(&spec, &positions).run(30).positions());
    assert_eq!(plain, crimped);
}

#[test]
fn what_lies_as_wide_as_its_cloth_draws_together_where_it_is_crimped() {
    let mut fabric = FABRIC;
    fabric.drag_rate = 4.0;
    let spec = ClothSpec {
        fabric,
        ..crimped(0.6)
    };
    let mut world = World::new(&spec, &bulged_positions(COLUMNS, ROWS, SPACING));
    world.config.gravity = Vec3::ZERO;
    let positions = world.run(240).positions();
    let lengths = row_lengths(&spec.grid, &positions);
    let mut last = 0.0;
    for row in 0..ROWS {
        let length = lengths[row as usize];
        let expected = spec.grid.crimp_share(row);
        assert!((length - expected).abs() < 0.04, "{row}: {length}");
        assert!(last < expected + 1e-6, "{row}: it opens downwards");
        last = expected;
    }
    assert!((last - 1.0).abs() < 1e-6, "the lowest rows lie open");
    let strain = diagnose::strain(&spec, &positions);
    assert!(strain.mean < 0.02, "{strain:?}");
}

#[test]
fn what_is_no_crimp_is_refused() {
    for share in [0.0, -0.5, 1.1, f32::NAN] {
        let error = ClothModel::new(&crimped(share)).expect_err("it is refused");
        assert!(error.to_string().contains("grid.crimp"), "{error}");
    }
    for share in [0.0, -0.5, f32::NAN] {
        let error = ReferenceModel::new(&crimped(share)).expect_err("it is refused");
        assert!(error.to_string().contains("grid.crimp"), "{error}");
    }
    let rows = ExplicitModel::new(&crimped(0.5)).map(drop);
    assert_eq!(rows, Err(BuildError::Crimp));
}
