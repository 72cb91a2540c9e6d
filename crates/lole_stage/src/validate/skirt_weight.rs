//! A skirt that hangs free: its waist carries the whole of it.

use glam::DVec3;
use lole_cloth::method::reference::ReferenceModel;
use lole_cloth::{BuildError, ClothSpec, Fabric, Grid, MassLaw, Topology};

use super::Check;
use super::rig::{GRAVITY, Rig, Subject};

/// Columns and rows, and the distance between them [m].
const COLUMNS: u32 = 48;
const ROWS: u32 = 20;
const SPACING: f32 = 0.015;
/// Membrane stiffness down the skirt [N/m]: it stretches by two percent at the waist.
const STIFFNESS: f32 = 20.0;
/// Drag [1/s], and frames until it hangs still.
const DRAG: f32 = 15.0;
const SETTLE: u32 = 180;

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    let spec = spec();
    // Forces are those of the springs at the lengths they have, for both methods.
    let model = ReferenceModel::new(&spec)?;
    let start = model.rest_positions();
    let mut rig = Rig::new(subject, &spec, &start)?;
    rig.settle(SETTLE);
    let positions = rig.positions();
    let waist = model.pin_indices().iter();
    let pull: DVec3 = waist
        .map(|&pin| model.internal_force(pin as usize, &positions))
        .sum();
    let free = model.masses().iter().zip(model.pinned());
    let weight: f64 = free
        .filter(|&(_, &is_pinned)| !is_pinned)
        .map(|(mass, _)| mass * GRAVITY)
        .sum();
    let gate = subject.gate([0.01, 2.0]);
    Ok(vec![Check::new("waist", [-pull.y, weight], gate).unit("N")])
}

fn spec() -> ClothSpec {
    let grid = Grid {
        column_count: COLUMNS,
        row_count: ROWS,
        topology: Topology::Tube,
        spacing: [SPACING; 2],
        flounce: None,
        crimp: None,
    };
    ClothSpec {
        fabric: Fabric {
            areal_density: 0.15,
            thickness: 3.0e-4,
            stretch: [STIFFNESS; 2],
            shear: 0.2 * STIFFNESS,
            bend: [1.0e-5; 2],
            twist: 1.0e-5,
            hysteresis: lole_cloth::Hysteresis::NONE,
            friction: 0.0,
            cloth_friction: 0.0,
            drag_rate: DRAG,
        },
        row_layers: vec![1.0; grid.row_count as usize],
        mass: MassLaw::AreaWeighted,
        pinned: (0..grid.particle_count())
            .map(|particle| particle < COLUMNS as usize)
            .collect(),
        grid,
    }
}
