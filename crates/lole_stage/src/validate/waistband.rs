//! An elastic band stretched over a cylinder: its tension, by the weight that its friction holds.

use std::num::NonZeroU32;

use glam::{DVec3, Vec3};
use lole_cloth::{BuildError, ClothSpec, Fabric, Grid, MassLaw, Topology};
use lole_geom::{Capsule, trig64};

use super::Check;
use super::rig::{Rig, Subject};

/// Particles around the band, and its rows.
const COLUMNS: u32 = 64;
const ROWS: u32 = 3;
/// Radius of the cylinder [m], and half the length of its axis.
const RADIUS: f64 = 0.13;
const HALF_LENGTH: f32 = 1.0;
/// The cylinder's radius over that of the band at rest.
const STRETCHES: [f64; 2] = [1.05, 1.25];
/// Stiffness `EA` of each row [N], and its mass [kg].
const STIFFNESS: f64 = 5.0;
const MASS: f64 = 0.02;
/// Coefficient of friction.
const FRICTION: f64 = 0.4;
/// Frames that a weight hangs, and how far it may sink in these [m].
const WATCH: u32 = 30;
const SUNK: f64 = 1.0e-3;
/// Where the weight is sought, over the true one, and how often the bracket is halved.
const BRACKET: [f64; 2] = [0.9, 1.1];
const HALVINGS: u32 = 8;
/// Drag [1/s].
const DRAG: f64 = 5.0;
/// Substeps of the real-time method.
const SUBSTEPS: NonZeroU32 = NonZeroU32::MIN.saturating_add(39);

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    STRETCHES
        .iter()
        .map(|&stretch| {
            let tension = f64::from(ROWS) * STIFFNESS * (stretch - 1.0);
            let [mut holds, mut slides] = BRACKET.map(|share| share * tension);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (holds + slides);
                if holds_weight(subject, stretch, middle)? {
                    holds = middle;
                } else {
                    slides = middle;
                }
            }
            let found = 0.5 * (holds + slides);
            let case = format!("r / R₀ = {stretch}");
            Ok(Check::new(case, [found, tension], subject.gate([1.0, 6.0])).unit("N"))
        })
        .collect()
}

/// Whether the band holds the weight that friction at this tension [N] would just hold,
/// `μ 2 π T`.
fn holds_weight(subject: Subject, stretch: f64, tension: f64) -> Result<bool, BuildError> {
    let spec = spec(RADIUS / stretch);
    let weight = FRICTION * std::f64::consts::TAU * tension;
    let gravity = weight / (f64::from(ROWS) * MASS);
    let spacing = f64::from(spec.grid.spacing[1]);
    let start: Vec<DVec3> = (0..ROWS)
        .flat_map(|row| {
            (0..COLUMNS).map(move |column| {
                let turn = std::f64::consts::TAU * f64::from(column) / f64::from(COLUMNS);
                let (sin, cos) = trig64::sin_cos(turn);
                DVec3::new(RADIUS * cos, -f64::from(row) * spacing, RADIUS * sin)
            })
        })
        .collect();
    let axis = Vec3::Y * HALF_LENGTH;
    #[expect(clippy::cast_possible_truncation, reason = "capsules are in f32")]
    let body = Capsule::uniform(-axis, axis, RADIUS as f32);
    let mut rig = Rig::new(subject, &spec, &start)?
        .with_gravity(DVec3::NEG_Y * gravity)
        .with_capsules(&[body])
        .with_substeps(SUBSTEPS);
    rig.settle(WATCH);
    let middle = rig.positions()[COLUMNS as usize].y;
    Ok(-middle - spacing < SUNK)
}

/// A band with this radius at rest [m]. Its rows are joined by springs as stiff as they.
#[expect(clippy::cast_possible_truncation, reason = "specifications are in f32")]
fn spec(radius: f64) -> ClothSpec {
    let around = 2.0 * radius * trig64::sin(std::f64::consts::PI / f64::from(COLUMNS));
    let grid = Grid {
        column_count: COLUMNS,
        row_count: ROWS,
        topology: Topology::Tube,
        spacing: [around as f32; 2],
        flounce: None,
        crimp: None,
    };
    ClothSpec {
        fabric: Fabric {
            areal_density: (MASS / (f64::from(COLUMNS) * around * around)) as f32,
            thickness: 1.0e-3,
            stretch: [(STIFFNESS / around) as f32; 2],
            shear: 0.0,
            bend: [0.0; 2],
            twist: 0.0,
            hysteresis: lole_cloth::Hysteresis::NONE,
            friction: FRICTION as f32,
            cloth_friction: FRICTION as f32,
            drag_rate: DRAG as f32,
        },
        // All rows weigh the same, whatever the mass law makes of borders.
        row_layers: vec![ROWS as f32 / (ROWS - 1) as f32; ROWS as usize],
        mass: MassLaw::Uniform,
        pinned: vec![false; grid.particle_count()],
        grid,
    }
}
