//! A patch of cloth on a slope: it sticks below the angle of friction and slides above it.
//!
//! The slope is the crest of a broad cylinder, along its axis: there it has no curvature. Instead
//! of the cylinder, gravity is tilted.

use std::num::NonZeroU32;

use glam::{DVec3, Vec3};
use lole_cloth::{BuildError, ClothSpec, Fabric, Grid, MassLaw, Topology};
use lole_geom::{Capsule, trig64};

use super::Check;
use super::rig::{FRAME, GRAVITY, Rig, Subject, mean};

/// Columns across the cylinder, rows along it, and their distance [m].
const COLUMNS: u32 = 3;
const ROWS: u32 = 8;
pub(super) const SPACING: f64 = 0.01;
/// Radius of the cylinder [m]: the outer columns lie at 0.01 radians, where the normal force is
/// less by 5e-5. A larger one would round the depths of the real-time method.
const RADIUS: f32 = 1.0;
/// Half the length of its axis [m].
const HALF_LENGTH: f32 = 4.0;
/// Coefficients of friction.
const FRICTIONS: [f64; 2] = [0.3, 0.5];
/// How far below the angle of friction the patch must stick, and above it must slide, in degrees.
const BELOW: f64 = 0.5;
const ABOVE: [f64; 2] = [0.5, 5.0];
/// Substeps of the real-time method: those it dances with. In a shorter substep the patch falls
/// less far, and the rounding of positions counts for more of it.
const SUBSTEPS: NonZeroU32 = NonZeroU32::MIN.saturating_add(11);
/// Frames until the patch lies, and frames that are measured.
const SETTLE: u32 = 30;
const MEASURE: u32 = 60;
/// Fastest creep of a patch that sticks [m/s].
const CREEP: f64 = 1.0e-4;
/// Speed of the belt [m/s].
const BELT: f64 = 0.8;

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    let mut checks = Vec::new();
    for friction in FRICTIONS {
        let angle = trig64::atan2(friction, 1.0);
        let [creep, _] = slide(subject, friction, angle - BELOW.to_radians())?;
        let case = format!("μ = {friction}, -{BELOW}°");
        checks.push(Check::vanishing(case, creep, CREEP).unit("m/s"));
        for above in ABOVE {
            let (sin, cos) = trig64::sin_cos(angle + above.to_radians());
            let [_, found] = slide(subject, friction, angle + above.to_radians())?;
            let reference = GRAVITY * (sin - friction * cos);
            let case = format!("μ = {friction}, +{above}°");
            // Half a degree above, friction takes all but a fortieth of the slope's pull, and its
            // rounding in `f32` shows.
            let gate = if above < 1.0 {
                subject.gate([1.0, 4.0])
            } else {
                1.0
            };
            checks.push(Check::new(case, [found, reference], gate).unit("m/s²"));
        }
        let reference = 1e3 * BELT * BELT / (2.0 * friction * GRAVITY);
        let found = 1e3 * slip_on_belt(subject, friction)?;
        let case = format!("μ = {friction}, belt");
        checks.push(Check::new(case, [found, reference], 1.0).unit("mm"));
    }
    Ok(checks)
}

/// Mean speed [m/s] and acceleration [m/s²] down a slope of `angle`, after it has settled.
fn slide(subject: Subject, friction: f64, angle: f64) -> Result<[f64; 2], BuildError> {
    let (sin, cos) = trig64::sin_cos(angle);
    let mut rig = patch(subject, friction)?.with_gravity(DVec3::new(sin, -cos, 0.0) * GRAVITY);
    rig.settle(SETTLE);
    let place = |rig: &Rig| mean(&rig.positions()).x;
    let before = place(&rig);
    rig.settle(MEASURE);
    let middle = place(&rig);
    rig.settle(MEASURE);
    let after = place(&rig);
    let time = f64::from(MEASURE) * FRAME;
    Ok([
        0.5 * (after - before) / time,
        (after - 2.0 * middle + before) / (time * time),
    ])
}

/// How far [m] a belt that starts at once leaves the patch behind until it has taken it along.
fn slip_on_belt(subject: Subject, friction: f64) -> Result<f64, BuildError> {
    let mut rig = patch(subject, friction)?;
    rig.settle(SETTLE);
    let start = mean(&rig.positions()).x;
    let mut belt = 0.0;
    for _ in 0..MEASURE {
        belt += BELT * FRAME;
        rig.set_capsules(&[cylinder(belt)]);
        rig.advance();
    }
    Ok(belt - (mean(&rig.positions()).x - start))
}

/// The patch lying on the crest of a cylinder at rest.
fn patch(subject: Subject, friction: f64) -> Result<Rig, BuildError> {
    let half = 0.5 * SPACING * f64::from(COLUMNS - 1);
    let start: Vec<DVec3> = (0..ROWS)
        .flat_map(|row| {
            (0..COLUMNS).map(move |column| {
                let across = f64::from(column) * SPACING - half;
                let (sin, cos) = trig64::sin_cos(across / f64::from(RADIUS));
                let radius = f64::from(RADIUS);
                DVec3::new(f64::from(row) * SPACING, radius * (cos - 1.0), radius * sin)
            })
        })
        .collect();
    let rig = Rig::new(subject, &spec(friction, [COLUMNS, ROWS]), &start)?;
    Ok(rig.with_capsules(&[cylinder(0.0)]).with_substeps(SUBSTEPS))
}

/// The slope, `shift` [m] along itself.
#[expect(clippy::cast_possible_truncation, reason = "capsules are in f32")]
pub(super) fn cylinder(shift: f64) -> Capsule {
    let center = Vec3::new(shift as f32, -RADIUS, 0.0);
    let half = Vec3::X * HALF_LENGTH;
    Capsule::uniform(center - half, center + half, RADIUS)
}

/// Loose cloth of so many columns and rows without bending.
#[expect(clippy::cast_possible_truncation, reason = "specifications are in f32")]
pub(super) fn spec(friction: f64, [column_count, row_count]: [u32; 2]) -> ClothSpec {
    let grid = Grid {
        column_count,
        row_count,
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
            shear: 20.0,
            bend: [0.0; 2],
            twist: 0.0,
            hysteresis: lole_cloth::Hysteresis::NONE,
            friction: friction as f32,
            cloth_friction: friction as f32,
            drag_rate: 0.0,
        },
        row_layers: vec![1.0; grid.row_count as usize],
        mass: MassLaw::Uniform,
        pinned: vec![false; grid.particle_count()],
        grid,
    }
}
