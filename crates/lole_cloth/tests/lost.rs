//! What does not fit a cloth is said at the door, and changes nothing.

use std::num::NonZeroU32;

use glam::{Vec2, Vec3};
use lole_cloth::assembly::{self, Assembly, AssemblyInput, AssemblyState, ClothPiece};
use lole_cloth::mesh::{self, MeshModel, MeshSpec, MeshState};
use lole_cloth::method::explicit_rows::{self, ExplicitModel};
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Fabric, Grid, Lost, SolverConfig, StepInput,
    mesh_state_hash, state_hash, step,
};

const DT: f32 = 1.0 / 60.0;

/// A sheet of so many particles a side, pinned along its first row, level.
fn sheet(side: u32) -> (ClothModel, ClothState) {
    let grid = Grid::sheet(side, side, [0.02; 2]);
    let spec = ClothSpec::new(grid, Fabric::COTTON).pinned_where(|row, _| row == 0);
    let model = ClothModel::new(&spec).expect("a sheet");
    let places = (0..side).flat_map(|row| (0..side).map(move |column| [column, row]));
    let places: Vec<Vec3> = places
        .map(|[x, z]| Vec3::new(x as f32, 0.0, z as f32) * 0.02)
        .collect();
    let state = ClothState::new(&model, &places);
    (model, state)
}

/// A square of two triangles at rest, two of its particles pinned.
fn triangles() -> (MeshModel, MeshState) {
    let flat: Vec<Vec2> = [[0.0, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1]]
        .map(Vec2::from)
        .to_vec();
    let mut spec = MeshSpec::new(flat.clone(), vec![[0, 1, 2], [0, 2, 3]], Fabric::COTTON);
    spec.pinned[..2].fill(true);
    let model = MeshModel::new(&spec).expect("two triangles");
    let places: Vec<Vec3> = flat.iter().map(|at| at.extend(0.0)).collect();
    let state = MeshState::new(&model, &places);
    (model, state)
}

#[test]
fn as_many_targets_as_there_are_not_pins_are_refused_and_none_stay_where_they_are() {
    let (model, mut state) = sheet(8);
    let before = state_hash(&state);
    let three = [Vec3::ZERO; 3];
    let input = StepInput {
        pin_targets: &three,
        ..StepInput::default()
    };
    let config = SolverConfig::default();
    let refused = step(&model, &config, &input, &mut state, DT);
    let lost = Lost::Pins {
        expected: 8,
        found: 3,
    };
    assert_eq!(refused, Err(lost));
    assert_eq!(state_hash(&state), before);
    assert!(lost.to_string().contains("3 targets for 8"), "{lost}");
    let world = StepInput::default();
    for _ in 0..30 {
        step(&model, &config, &world, &mut state, DT).expect("pins stay");
    }
    let now = state.positions(&model);
    assert_eq!(now[3], Vec3::X * 0.06);
    assert!(now[60].y < -0.05, "and the rest hangs: {}", now[60]);

    let (model, mut state) = triangles();
    let before = mesh_state_hash(&state);
    let refused = mesh::step(&model, &config, &input, &mut state, DT);
    assert_eq!(
        refused,
        Err(Lost::Pins {
            expected: 2,
            found: 3
        })
    );
    assert_eq!(mesh_state_hash(&state), before);
}

#[test]
fn a_state_of_another_cloth_is_refused() {
    let (model, _) = sheet(8);
    let (_, mut other) = sheet(24);
    let before = state_hash(&other);
    let config = SolverConfig::default();
    let refused = step(&model, &config, &StepInput::default(), &mut other, DT);
    assert_eq!(refused, Err(Lost::OtherCloth { piece: 0 }));
    assert_eq!(state_hash(&other), before);

    let rows = ExplicitModel::new(model.spec()).expect("a sheet");
    let refused = explicit_rows::step(&rows, &config, &StepInput::default(), &mut other, DT);
    assert_eq!(refused, Err(Lost::OtherCloth { piece: 0 }));
    assert_eq!(state_hash(&other), before);

    let (mesh, _) = triangles();
    let pieces = vec![
        ClothPiece::Grid(Box::new(model), Box::new(config.clone())),
        ClothPiece::Mesh(Box::new(mesh), Box::new(config)),
    ];
    let assembly = Assembly::new(pieces, &[], NonZeroU32::MIN).expect("two pieces");
    let places = assembly.pieces().iter().map(|piece| {
        let count = 0..piece.particle_count();
        count.map(|at| Vec3::X * at as f32 * 0.02).collect()
    });
    let mut state = AssemblyState::new(&assembly, &places.collect::<Vec<Vec<Vec3>>>());
    state.pieces.swap(0, 1);
    let refused = assembly::step(&assembly, &AssemblyInput::default(), &mut state, DT);
    assert_eq!(refused, Err(Lost::OtherCloth { piece: 0 }));
    state.pieces.swap(0, 1);
    let input = AssemblyInput {
        pin_targets: &[vec![Vec3::ZERO; 8], vec![Vec3::ZERO]],
        ..AssemblyInput::default()
    };
    let refused = assembly::step(&assembly, &input, &mut state, DT);
    assert_eq!(
        refused,
        Err(Lost::Pins {
            expected: 2,
            found: 1
        })
    );
}
