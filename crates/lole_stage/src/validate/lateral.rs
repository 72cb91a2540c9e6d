//! A strip that stands on its narrow edge, held at one end: beyond a certain length it tips over
//! sideways and hangs twisted. Bending alone does not decide it, so it tells whether the twist term
//! of the plate is right.

use glam::DVec3;
use lole_cloth::{BuildError, ClothSpec, Fabric, Grid, MassLaw, Topology};

use super::Check;
use super::beam::{AREAL_DENSITY, weight};
use super::rig::{Rig, Subject};

/// `Γ = w L³ / B` at which the strip below buckles, for a plate without transverse contraction: a
/// series of ever finer lattices gave 20.42, 20.56 and 20.60 for this width; the closed form for a
/// strip of no width is 18.18.
const CRITICAL: f64 = 20.6;
/// Free length [m], and width over length.
const LENGTH: f64 = 0.2;
const WIDTH: f64 = 0.2;
/// Cells across the width.
const CELLS: u32 = 4;
/// First displacement of the tip over the length.
const SEED: f64 = 1.0e-3;
/// Drag [1/s], and frames it is watched.
const DRAG: f64 = 2.0;
const WATCH: u32 = 420;
/// Where the critical value is sought, over the true one, and how often the bracket is halved.
const BRACKET: [f64; 2] = [0.8, 1.2];
const HALVINGS: u32 = 5;
/// Membrane stiffness over the weight of the free length: the strip sags within its plane by less
/// than a hundredth.
const STIFFNESS: f64 = 3000.0;

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    let [mut stands, mut tips] = BRACKET.map(|share| share * CRITICAL);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (stands + tips);
        if tips_over(subject, middle)? {
            tips = middle;
        } else {
            stands = middle;
        }
    }
    let found = 0.5 * (stands + tips);
    Ok(vec![Check::new("Γ", [found, CRITICAL], 5.0)])
}

/// Whether a small sideways bow grows.
fn tips_over(subject: Subject, gamma: f64) -> Result<bool, BuildError> {
    let spacing = WIDTH * LENGTH / f64::from(CELLS);
    let grid = strip_grid(spacing);
    let spec = strip(&grid, weight() * LENGTH * LENGTH * LENGTH / gamma);
    let place = |row: u32, column: u32| {
        let along = f64::from(row) * spacing - spacing;
        let free = along.max(0.0) / LENGTH;
        let bow = SEED * LENGTH * free * free;
        DVec3::new(along, -f64::from(column) * spacing, bow)
    };
    let rows = 0..grid.row_count;
    let start: Vec<DVec3> = rows
        .flat_map(|row| (0..grid.column_count).map(move |column| place(row, column)))
        .collect();
    let mut rig = Rig::new(subject, &spec, &start)?;
    rig.settle(WATCH);
    let tip = grid.index(grid.row_count - 1, grid.column_count / 2);
    Ok(SEED * LENGTH < rig.positions()[tip].z.abs())
}

/// Rows stand side by side along the strip, one of them before the edge of the clamp.
#[expect(clippy::cast_possible_truncation, reason = "specifications are in f32")]
fn strip_grid(spacing: f64) -> Grid {
    let along = f64::from(CELLS) / WIDTH;
    #[expect(clippy::cast_sign_loss, reason = "a count of cells")]
    let along = along.round() as u32;
    Grid {
        column_count: CELLS + 1,
        row_count: along + 2,
        topology: Topology::Sheet,
        spacing: [spacing as f32; 2],
        flounce: None,
        crimp: None,
    }
}

/// An isotropic sheet of that bending rigidity [N·m], held by its first two rows.
#[expect(clippy::cast_possible_truncation, reason = "specifications are in f32")]
fn strip(grid: &Grid, bend: f64) -> ClothSpec {
    let stretch = (STIFFNESS * weight() * LENGTH) as f32;
    let columns = grid.column_count as usize;
    ClothSpec {
        fabric: Fabric {
            areal_density: AREAL_DENSITY,
            thickness: 3.0e-4,
            stretch: [stretch; 2],
            shear: 0.5 * stretch,
            bend: [bend as f32; 2],
            twist: bend as f32,
            hysteresis: lole_cloth::Hysteresis::NONE,
            friction: 0.0,
            cloth_friction: 0.0,
            drag_rate: DRAG as f32,
        },
        row_layers: vec![1.0; grid.row_count as usize],
        mass: MassLaw::AreaWeighted,
        pinned: (0..grid.particle_count())
            .map(|particle| particle < 2 * columns)
            .collect(),
        grid: *grid,
    }
}
