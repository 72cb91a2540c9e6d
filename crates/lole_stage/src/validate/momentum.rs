//! A crumpled sheet in empty space keeps its linear and its angular momentum.

use glam::DVec3;
use lole_cloth::model::particle_masses;
use lole_cloth::{BuildError, ClothSpec, Fabric, Grid, MassLaw, Topology};
use lole_geom::trig64;

use super::Check;
use super::rig::{Rig, Subject};

/// Columns and rows, and the distance between them [m].
const COLUMNS: u32 = 13;
const ROWS: u32 = 9;
const SPACING: f64 = 0.02;
/// How far particles are from where they rest [m], and their speed [m/s].
const CRUMPLE: f64 = 0.003;
const SPEED: f64 = 1.0;
/// Frames that it moves.
const FRAMES: u32 = 60;

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    let spec = spec();
    let start = scattered(1.0, |row, column| {
        DVec3::new(f64::from(column), f64::from(row), 0.0) * SPACING
    });
    let velocities: Vec<DVec3> = scattered(SPEED / CRUMPLE, |_, _| DVec3::ZERO);
    let mut rig = Rig::new(subject, &spec, &start)?
        .with_gravity(DVec3::ZERO)
        .with_velocities(&velocities);
    let masses: Vec<f64> = particle_masses(&spec).into_iter().map(f64::from).collect();
    let before = momentum(&rig, &masses);
    rig.settle(FRAMES);
    let after = momentum(&rig, &masses);
    // What both are measured by: all speeds in one direction, at the sheet's half diagonal.
    let scale: f64 = (masses.iter().zip(&velocities))
        .map(|(mass, velocity)| mass * velocity.length())
        .sum();
    let [across, down] = [COLUMNS, ROWS].map(f64::from);
    let arm = 0.5 * SPACING * (across * across + down * down).sqrt();
    let drifts = [
        (after[0] - before[0]).length() / scale,
        (after[1] - before[1]).length() / (scale * arm),
    ];
    // Positions in `f32` are rounded in thousands of substeps.
    let bounds = [
        subject.gate([1.0e-12, 1.0e-3]),
        subject.gate([1.0e-12, 1.0e-2]),
    ];
    Ok(vec![
        Check::vanishing("linear", drifts[0], bounds[0]),
        Check::vanishing("angular", drifts[1], bounds[1]),
    ])
}

/// Linear and angular momentum [kg·m/s, kg·m²/s].
fn momentum(rig: &Rig, masses: &[f64]) -> [DVec3; 2] {
    let (positions, velocities) = (rig.positions(), rig.velocities());
    let mut sums = [DVec3::ZERO; 2];
    for ((&mass, &position), &velocity) in masses.iter().zip(&positions).zip(&velocities) {
        sums[0] += velocity * mass;
        sums[1] += position.cross(velocity) * mass;
    }
    sums
}

/// Row by row, what `place` says and up to `CRUMPLE` times `factor` more in every direction.
fn scattered(factor: f64, place: impl Fn(u32, u32) -> DVec3) -> Vec<DVec3> {
    let mut count = 0.0;
    (0..ROWS)
        .flat_map(|row| (0..COLUMNS).map(move |column| (row, column)))
        .map(|(row, column)| {
            count += 1.0;
            // No pattern that the grid has.
            let [x, y, z] = [1.7, 2.3, 2.9].map(|step| trig64::sin(step * count * count));
            place(row, column) + DVec3::new(x, y, z) * (CRUMPLE * factor)
        })
        .collect()
}

#[expect(clippy::cast_possible_truncation, reason = "specifications are in f32")]
fn spec() -> ClothSpec {
    let grid = Grid {
        column_count: COLUMNS,
        row_count: ROWS,
        topology: Topology::Sheet,
        spacing: [SPACING as f32; 2],
        flounce: None,
        crimp: None,
    };
    ClothSpec {
        fabric: Fabric {
            areal_density: 0.15,
            thickness: 3.0e-4,
            stretch: [50.0; 2],
            shear: 10.0,
            bend: [1.0e-5; 2],
            twist: 1.0e-5,
            hysteresis: lole_cloth::Hysteresis::NONE,
            friction: 0.0,
            cloth_friction: 0.0,
            drag_rate: 0.0,
        },
        row_layers: vec![1.0; grid.row_count as usize],
        mass: MassLaw::AreaWeighted,
        pinned: vec![false; grid.particle_count()],
        grid,
    }
}
