//! Square specimens of cloth held level by a disc, as large as the round ones of the standards: grids, which
//! are the ones that know internal friction.
#![allow(dead_code, reason = "a test and an example use some of it each")]

use std::f32::consts::PI;

use glam::{Vec2, Vec3};
use lole_cloth::drape_test::{Hung, RoundDrape};
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Fabric, Grid, MassLaw, StepInput, Topology, step,
};

/// Frames until a specimen hangs still, and the drag [1/s] of air so thick that it sinks and does
/// not swing: friction keeps what it comes from.
const FRAMES: u32 = 300;
const DRAG: f32 = 40.0;
/// Cells along a side.
const CELLS: u32 = 40;

/// A square specimen as a grid, as large as the round one.
pub(crate) fn square(fabric: Fabric, drape: RoundDrape) -> Hung {
    let side = drape.specimen * PI.sqrt();
    let spacing = side / CELLS as f32;
    let count = CELLS + 1;
    let grid = Grid {
        column_count: count,
        row_count: count,
        topology: Topology::Sheet,
        spacing: [spacing; 2],
        flounce: None,
        crimp: None,
    };
    let flat: Vec<Vec2> = (0..count * count)
        .map(|index| {
            Vec2::new((index % count) as f32, (index / count) as f32) * spacing
                - Vec2::splat(0.5 * side)
        })
        .collect();
    let places: Vec<Vec3> = flat.iter().map(|&point| drape.start(point)).collect();
    let spec = ClothSpec {
        grid,
        fabric: Fabric {
            drag_rate: DRAG,
            ..fabric
        },
        row_layers: vec![1.0; count as usize],
        mass: MassLaw::AreaWeighted,
        pinned: (flat.iter())
            .map(|point| point.length() <= drape.disc)
            .collect(),
    };
    let model = ClothModel::new(&spec).expect("a sound cloth");
    let pins: Vec<Vec3> = (model.pin_indices().iter())
        .map(|&pin| places[pin as usize])
        .collect();
    let mut state = ClothState::new(&model, &places);
    let input = StepInput {
        pin_targets: &pins,
        ..StepInput::default()
    };
    for _ in 0..FRAMES {
        step(
            &model,
            &RoundDrape::settings(),
            &input,
            &mut state,
            1.0 / 60.0,
        )
        .expect("a target for every pin");
    }
    let mut positions = Vec::new();
    state.copy_positions(&model, &mut positions);
    let last = CELLS;
    let hem: Vec<Vec3> = (0..last)
        .map(|column| [0, column])
        .chain((0..last).map(|row| [row, last]))
        .chain((0..last).map(|column| [last, last - column]))
        .chain((0..last).map(|row| [last - row, 0]))
        .map(|[row, column]| positions[grid.index(row, column)])
        .collect();
    drape.hung(&hem)
}
