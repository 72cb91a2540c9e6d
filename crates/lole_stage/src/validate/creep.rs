//! A stack of folded cloth on a slope, for a minute: below the angle of friction neither the stack moves on the
//! slope nor one layer on the other.
//!
//! The slope is that of [`super::incline`], on which a single layer stays. Cloth meets itself as a skirt does, by
//! spheres that nearly close its surface. Spheres that are far smaller than its cells roll off each other and into
//! the gaps, and a stack of such beads rattles downhill by centimeters a minute; so does one of cloth ten times as
//! soft. The design says how far.

use std::num::NonZeroU32;

use glam::DVec3;
use lole_cloth::{BuildError, ClothSpec, Crossings, Fabric, SelfCollision};
use lole_geom::trig64;

use super::Check;
use super::incline::{self, SPACING, cylinder};
use super::rig::{FRAME, GRAVITY, Rig, Subject, mean};

/// Layers, rows of each, and columns.
const LAYERS: u32 = 3;
const ROWS: u32 = 10;
const COLUMNS: u32 = 5;
/// Half of the distance between layers [m]: so much of a column's width as a skirt has it.
const RADIUS: f32 = 4.5e-3;
/// Coefficients of friction, on the slope and between layers, and how far below their angles the slope is [°].
const FRICTIONS: [f64; 2] = [0.3, 0.5];
const BELOW: f64 = 5.0;
/// Farthest that a layer comes in a minute [mm].
const CREEP: f64 = 0.1;
/// Substeps, and every so manyth in which cloth meets itself, as a skirt dances with them.
const SUBSTEPS: NonZeroU32 = NonZeroU32::MIN.saturating_add(13);
const INTERVAL: NonZeroU32 = NonZeroU32::MIN.saturating_add(1);
/// Frames until the stack lies, and those of a minute.
const SETTLE: u32 = 300;
const MINUTE: u32 = 3600;

/// For the real-time method: the reference knows no contact of cloth with itself.
pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    debug_assert!(
        (f64::from(MINUTE) * FRAME - 60.0).abs() < 1.0e-9,
        "a minute"
    );
    let mut checks = Vec::new();
    for friction in FRICTIONS {
        let angle = trig64::atan2(friction, 1.0) - BELOW.to_radians();
        let (sin, cos) = trig64::sin_cos(angle);
        let rig = Rig::new(subject, &spec(friction), &stack())?
            .with_gravity(DVec3::new(sin, -cos, 0.0) * GRAVITY)
            .with_capsules(&[cylinder(0.0)])
            .with_substeps(SUBSTEPS);
        let mut rig = rig.with_self_collision(SelfCollision {
            radius: RADIUS,
            substep_interval: INTERVAL,
            crossings: Crossings::Repair,
        });
        rig.settle(SETTLE);
        let before = rig.positions();
        rig.settle(MINUTE);
        let after = rig.positions();
        let count = (ROWS * COLUMNS) as usize;
        let layers = before.chunks(count).zip(after.chunks(count));
        for (layer, (before, after)) in (1..).zip(layers) {
            let way: Vec<DVec3> = (after.iter().zip(before))
                .map(|(after, before)| *after - *before)
                .collect();
            let case = format!("μ = {friction}, layer {layer}");
            checks.push(Check::vanishing(case, 1.0e3 * mean(&way).length(), CREEP).unit("mm"));
        }
    }
    Ok(checks)
}

/// The strip folded to and fro.
fn stack() -> Vec<DVec3> {
    let mut places = Vec::new();
    for layer in 0..LAYERS {
        for row in 0..ROWS {
            // As far beyond the fold as keeps rows a spacing apart.
            let along = if layer % 2 == 0 {
                f64::from(row)
            } else {
                f64::from(ROWS - 1 - row) + 0.95
            };
            let half = 0.5 * f64::from(COLUMNS - 1);
            places.extend((0..COLUMNS).map(|column| {
                let height = f64::from(layer) * 2.0 * f64::from(RADIUS);
                let across = f64::from(column) - half;
                DVec3::new(along * SPACING, height, across * SPACING)
            }));
        }
    }
    places
}

/// The cloth of [`super::incline`], woven, and as stiff as a cotton of skirts.
fn spec(friction: f64) -> ClothSpec {
    let mut spec = incline::spec(friction, [COLUMNS, LAYERS * ROWS]);
    spec.fabric = Fabric {
        stretch: [500.0; 2],
        shear: 50.0,
        bend: [1.0e-5; 2],
        twist: 1.0e-5,
        ..spec.fabric
    };
    spec
}
