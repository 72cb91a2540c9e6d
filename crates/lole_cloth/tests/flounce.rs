//! Laws of fuller cloth that is sewn to the lower part of a grid.

mod xpbd_support;

use glam::Vec3;
use lole_cloth::method::explicit_rows::ExplicitModel;
use lole_cloth::method::reference::ReferenceModel;
use lole_cloth::model::particle_masses;
use lole_cloth::{BuildError, ClothModel, ClothSpec, Flounce, MassLaw, diagnose};
use xpbd_support::{FABRIC, World, flat_positions, sheet_spec};

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

/// Flat, with every row as long as the first, and bulged a little so that it can buckle.
fn bulged() -> Vec<Vec3> {
    let mut positions = flat_positions(COLUMNS, ROWS, SPACING);
    for (index, position) in positions.iter_mut().enumerate() {
        position.y = 0.001 * lole_geom::trig::sin(index as f32 * 0.7);
    }
    positions
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
    let positions = bulged();
    let mut plain = World::new(&sheet_spec(COLUMNS, ROWS, SPACING, FABRIC), &positions);
    let mut flounced = World::new(&flounced(1.0), &positions);
    for world in [&mut plain, &mut flounced] {
        for _ in 0..30 {
            world.step(&[]);
        }
    }
    assert_eq!(plain.positions(), flounced.positions());
}

#[test]
fn what_lies_as_narrow_as_the_cloth_above_opens_to_its_own_width() {
    let mut fabric = FABRIC;
    fabric.drag_rate = 4.0;
    let spec = ClothSpec {
        fabric,
        ..flounced(1.5)
    };
    let mut world = World::new(&spec, &bulged());
    world.config.gravity = Vec3::ZERO;
    for _ in 0..180 {
        world.step(&[]);
    }
    let positions = world.positions();
    let length = |row: u32| {
        let place = |column| positions[spec.grid.index(row, column)];
        let edges = (0..COLUMNS - 1).map(|column| place(column).distance(place(column + 1)));
        edges.sum::<f32>() / ((COLUMNS - 1) as f32 * SPACING)
    };
    for row in 0..SEAM {
        assert!((length(row) - 1.0).abs() < 0.02, "{row}: {}", length(row));
    }
    for row in SEAM + 3..ROWS {
        assert!((length(row) - 1.5).abs() < 0.04, "{row}: {}", length(row));
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
