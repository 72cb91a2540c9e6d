//! A skirt that flies in a whirl: its hem is a ring that holds itself together.

mod xpbd_support;

use std::f32::consts::TAU;

use glam::Vec3;
use lole_cloth::{Topology, diagnose};
use lole_geom::trig;
use xpbd_support::{DT, FABRIC, World, sheet_spec};

const COLUMNS: u32 = 384;
const ROWS: u32 = 60;
const SPACING: f32 = 0.01;

/// Radius of the belt [m]: the cloth, 61 cm in radius where it is open, lies in folds around it.
const BELT: f32 = 0.15;
const FOLDS: f32 = 32.0;

/// Speed of the whirl [rad/s] and time in which it is come to [s].
const SPEED: f32 = 10.0;
const START: f32 = 0.6;

/// A place of the belt when it has turned by an angle.
fn at_belt(column: u32, turned: f32) -> Vec3 {
    let around = TAU * column as f32 / COLUMNS as f32;
    let radius = BELT + 0.026 * trig::sin(FOLDS * around);
    let (sin, cos) = trig::sin_cos(around + turned);
    Vec3::new(cos, 0.0, sin) * radius
}

/// The worst strain at the 99th percentile in a whirl of three seconds, and how far the hem flew out [m].
fn whirled(row_strides: &[u32]) -> (f32, f32) {
    let mut spec = sheet_spec(COLUMNS, ROWS, SPACING, FABRIC);
    spec.grid.topology = Topology::Tube;
    spec.pinned[..COLUMNS as usize].fill(true);
    let places = (0..ROWS).flat_map(|row| {
        (0..COLUMNS).map(move |column| at_belt(column, 0.0) - Vec3::Y * (row as f32 * SPACING))
    });
    let mut world = World::new(&spec, &places.collect::<Vec<_>>());
    world.config.row_strides = row_strides.to_vec();
    let (mut turned, mut worst, mut flown) = (0.0, 0.0_f32, 0.0_f32);
    for frame in 0..180_u16 {
        let time = f32::from(frame) * DT;
        turned += SPEED * (time / START).min(1.0) * DT;
        for (column, pin) in (0..).zip(&mut world.pins) {
            *pin = at_belt(column, turned);
        }
        world.step(&[]);
        let now = world.positions();
        worst = worst.max(diagnose::strain(world.model.spec(), &now).p99);
        let hem = &now[now.len() - COLUMNS as usize..];
        let radius = hem.iter().map(|it| Vec3::new(it.x, 0.0, it.z).length());
        flown = flown.max(radius.fold(0.0, f32::max));
    }
    (worst, flown)
}

#[test]
fn chords_over_a_sixteenth_of_a_ring_hold_it_together() {
    let (plain, _) = whirled(&[]);
    let (held, flown) = whirled(&[COLUMNS / 16]);
    let open = COLUMNS as f32 * SPACING / TAU;
    assert!(open < flown && flown < 1.1 * open, "{flown} m");
    assert!(held < 0.12 && held < 0.5 * plain, "{held}, without {plain}");
}
