//! A square of cloth held by a disc, after Cusick: how much of what overhangs its shadow still
//! covers, and in how many folds.
//!
//! The grid knows no circular cloth, so the specimen is the square of the same area. The estimate
//! takes every ray from the disc to the edge for a strip of its own, clamped level.

use glam::DVec3;
use lole_cloth::drape_test::fold_count;
use lole_cloth::{BuildError, ClothSpec, Fabric, Grid, MassLaw, Topology};
use lole_geom::trig64;

use super::Check;
use super::beam::{AREAL_DENSITY, weight};
use super::elastica;
use super::rig::{Rig, Subject};

/// Bending lengths `(B / w)^(1/3)` [m]: those whose coefficients lie between 30 and 85 %, for which
/// the standards take a specimen of 30 cm.
const LENGTHS: [f64; 4] = [0.02, 0.025, 0.03, 0.035];
/// Radius of the disc [m], and side of the specimen: the square as large as a circle of 30 cm.
const DISC: f64 = 0.09;
const SIDE: f64 = 0.265_868;
/// Particles along a side.
const COUNT: u32 = 33;
/// Membrane stiffness [N/m]: an isotropic sheet without transverse contraction.
const STRETCH: f32 = 50.0;
/// Height of the first unevenness [m].
const SEED: f64 = 2.0e-4;
/// Drag [1/s], and frames until it hangs still.
const DRAG: f32 = 6.0;
const SETTLE: u32 = 180;
/// Rays by which the shadow is measured.
const RAYS: usize = 360;
/// Points on every edge of the grid whose shadows are looked at.
const EDGE_POINTS: u32 = 8;
/// Farthest that a coefficient may be from its estimate [points].
const GATE: f64 = 12.0;
/// Folds: a square hangs by its four corners.
const FOLDS: [f64; 2] = [3.5, 4.5];
/// What half a centimeter of bending length adds [points]: 9 to 16 for strips.
const RISE: [f64; 2] = [5.0, 16.0];

/// The estimate [%], by bending length [cm].
pub(super) fn points() -> Vec<[f64; 2]> {
    (15..=45_u8)
        .map(|tenths| {
            let length = 1.0e-3 * f64::from(tenths);
            [100.0 * length, estimated(length)]
        })
        .collect()
}

pub(super) fn run(subject: Subject) -> Result<Vec<Check>, BuildError> {
    let mut checks = Vec::new();
    let mut coefficients = Vec::new();
    for length in LENGTHS {
        let positions = draped(subject, length)?;
        let found = coefficient(&outline(&positions));
        let name = format!("l = {:.1} cm", 100.0 * length);
        let estimate = estimated(length);
        checks.push(
            Check::new(name.clone(), [found, estimate], GATE)
                .scale(100.0)
                .unit("%")
                .along(100.0 * length),
        );
        let folds = f64::from(fold_count(rim().map(|particle| positions[particle].y)));
        checks.push(Check::within(format!("{name}, folds"), folds, FOLDS));
        coefficients.push(found);
    }
    let rises = coefficients.windows(2).map(|pair| pair[1] - pair[0]);
    let least = rises.fold(f64::INFINITY, f64::min);
    checks.push(Check::within("least rise", least, RISE).unit("%"));
    Ok(checks)
}

/// The drape coefficient [%] of strips that know nothing of each other.
fn estimated(length: f64) -> f64 {
    let rays: Vec<f64> = (0..RAYS)
        .map(|ray| {
            let overhang = edge(angle(ray)) - DISC;
            let ratio = overhang / length;
            DISC + overhang * elastica::reach(ratio * ratio * ratio)[0]
        })
        .collect();
    coefficient(&rays)
}

/// Distance of the specimen's edge from its middle in a direction [m].
fn edge(angle: f64) -> f64 {
    let (sin, cos) = trig64::sin_cos(angle);
    0.5 * SIDE / sin.abs().max(cos.abs())
}

fn angle(ray: usize) -> f64 {
    std::f64::consts::TAU * (ray as f64 + 0.5) / RAYS as f64
}

/// Shadow less disc over specimen less disc [%], of the reach of the shadow along each ray [m].
fn coefficient(rays: &[f64]) -> f64 {
    let square = |reach: f64| reach * reach - DISC * DISC;
    let shadow: f64 = rays.iter().map(|&reach| square(reach)).sum();
    let whole: f64 = (0..RAYS).map(|ray| square(edge(angle(ray)))).sum();
    100.0 * shadow / whole
}

/// How far the shadow reaches along each ray [m].
fn outline(positions: &[DVec3]) -> Vec<f64> {
    let mut rays = vec![DISC; RAYS];
    let mut cast = |from: DVec3, to: DVec3| {
        for point in 0..EDGE_POINTS {
            let place = from.lerp(to, f64::from(point) / f64::from(EDGE_POINTS));
            let turn = trig64::atan2(place.z, place.x) / std::f64::consts::TAU;
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a share of a turn, from 0 to 1"
            )]
            let ray = ((turn - turn.floor()) * RAYS as f64) as usize;
            let reach = (place.x * place.x + place.z * place.z).sqrt();
            let far = &mut rays[ray.min(RAYS - 1)];
            *far = far.max(reach);
        }
    };
    let grid = grid();
    for row in 0..COUNT {
        for column in 0..COUNT {
            let here = positions[grid.index(row, column)];
            if column + 1 < COUNT {
                cast(here, positions[grid.index(row, column + 1)]);
            }
            if row + 1 < COUNT {
                cast(here, positions[grid.index(row + 1, column)]);
            }
        }
    }
    rays
}

/// Particles of the hem, once around.
fn rim() -> impl Iterator<Item = usize> {
    let grid = grid();
    let last = COUNT - 1;
    let top = (0..last).map(move |column| grid.index(0, column));
    let right = (0..last).map(move |row| grid.index(row, last));
    let bottom = (0..last).map(move |column| grid.index(last, last - column));
    let left = (0..last).map(move |row| grid.index(last - row, 0));
    top.chain(right).chain(bottom).chain(left)
}

/// Where a sheet of this bending length hangs [m].
fn draped(subject: Subject, length: f64) -> Result<Vec<DVec3>, BuildError> {
    let half = 0.5 * SIDE;
    let spacing = SIDE / f64::from(COUNT - 1);
    let mut start = Vec::new();
    for row in 0..COUNT {
        for column in 0..COUNT {
            let [x, z] = [column, row].map(|index| f64::from(index) * spacing - half);
            let beyond = ((x * x + z * z).sqrt() - DISC).max(0.0) / DISC;
            // Uneven as no symmetry of the square is.
            let uneven = trig64::sin(5.3 * trig64::atan2(z, x) + 1.0) + trig64::sin(47.0 * x);
            start.push(DVec3::new(x, SEED * beyond * uneven, z));
        }
    }
    let spec = spec(length, &start);
    let mut rig = Rig::new(subject, &spec, &start)?;
    rig.settle(SETTLE);
    Ok(rig.positions())
}

#[expect(clippy::cast_possible_truncation, reason = "specifications are in f32")]
fn grid() -> Grid {
    Grid {
        column_count: COUNT,
        row_count: COUNT,
        topology: Topology::Sheet,
        spacing: [(SIDE / f64::from(COUNT - 1)) as f32; 2],
        flounce: None,
        crimp: None,
    }
}

/// What lies on the disc is held.
#[expect(clippy::cast_possible_truncation, reason = "specifications are in f32")]
fn spec(length: f64, start: &[DVec3]) -> ClothSpec {
    let bend = (weight() * length * length * length) as f32;
    let on_disc = |place: &DVec3| place.x * place.x + place.z * place.z <= DISC * DISC;
    ClothSpec {
        fabric: Fabric {
            areal_density: AREAL_DENSITY,
            thickness: 3.0e-4,
            stretch: [STRETCH; 2],
            shear: 0.5 * STRETCH,
            bend: [bend; 2],
            twist: bend,
            hysteresis: lole_cloth::Hysteresis::NONE,
            friction: 0.0,
            cloth_friction: 0.0,
            drag_rate: DRAG,
        },
        row_layers: vec![1.0; COUNT as usize],
        mass: MassLaw::AreaWeighted,
        pinned: start.iter().map(on_disc).collect(),
        grid: grid(),
    }
}
