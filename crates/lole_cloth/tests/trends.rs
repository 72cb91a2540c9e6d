//! What dressmakers know of skirts, as laws of the real-time method.

mod xpbd_support;

use glam::Vec3;
use lole_cloth::scenes::waved_ring;
use lole_cloth::{ClothSpec, Fabric, Grid, Hysteresis, MassLaw, Topology};
use xpbd_support::{World, mean};

/// A light cotton without drag or friction.
const COTTON: Fabric = Fabric {
    areal_density: 0.12,
    thickness: 0.3e-3,
    stretch: [600.0; 2],
    shear: 40.0,
    bend: [8.0e-6; 2],
    twist: 8.0e-6,
    hysteresis: Hysteresis::NONE,
    friction: 0.0,
    cloth_friction: 0.0,
    drag_rate: 0.0,
};

fn tube(columns: u32, rows: u32, spacing: f32, fabric: Fabric) -> ClothSpec {
    let grid = Grid {
        column_count: columns,
        row_count: rows,
        topology: Topology::Tube,
        spacing: [spacing; 2],
        flounce: None,
        crimp: None,
    };
    ClothSpec {
        fabric,
        row_layers: vec![1.0; rows as usize],
        mass: MassLaw::AreaWeighted,
        pinned: (0..grid.particle_count())
            .map(|particle| particle < columns as usize)
            .collect(),
        grid,
    }
}

/// Folds at the hem of a gathered skirt of this bending rigidity [N·m].
fn hem_folds(bend: f32) -> usize {
    const COLUMNS: u32 = 192;
    const ROWS: u32 = 40;
    const SPACING: f32 = 0.0075;
    let fabric = Fabric {
        bend: [bend; 2],
        twist: bend,
        drag_rate: 4.0,
        ..COTTON
    };
    // Gathered two to one in many small folds, of which the cloth keeps as many as it can.
    let girth = f64::from(COLUMNS) * f64::from(SPACING);
    let ring = waved_ring(0.5 * girth / std::f64::consts::TAU, girth, COLUMNS, 32.0);
    let ring: Vec<Vec3> = ring
        .iter()
        .map(|&[x, z]| glam::DVec3::new(x, 0.0, z).as_vec3())
        .collect();
    let positions: Vec<Vec3> = (0..ROWS)
        .flat_map(|row| {
            let height = Vec3::NEG_Y * (row as f32 * SPACING);
            ring.iter().map(move |&place| place + height)
        })
        .collect();
    let mut world = World::new(&tube(COLUMNS, ROWS, SPACING, fabric), &positions);
    for _ in 0..240 {
        world.step(&[]);
    }
    let positions = world.positions();
    let hem = &positions[(COLUMNS * (ROWS - 1)) as usize..];
    let center = mean(hem);
    let radii: Vec<f32> = hem.iter().map(|p| (*p - center).length()).collect();
    let middle = radii.iter().sum::<f32>() / radii.len() as f32;
    let is_out = |index: usize| middle < radii[index % radii.len()];
    (0..radii.len())
        .filter(|&index| !is_out(index) && is_out(index + 1))
        .count()
}

#[test]
fn stiffer_cloth_falls_in_fewer_folds() {
    let folds = [1.0e-6, 3.0e-5, 3.0e-4, 2.0e-3].map(hem_folds);
    assert!(folds.is_sorted_by(|one, next| next <= one), "{folds:?}");
    assert!(folds[1] < folds[0] && folds[3] < folds[1], "{folds:?}");
    assert!(2 <= folds[3], "{folds:?}");
}

/// How far the hem of a skirt of `rows` swings sideways [m] after it was carried along at half a
/// meter a second and its waist stopped: the farthest of each of the first frames.
fn sway(rows: u32, fabric: Fabric, frames: usize) -> Vec<f32> {
    const COLUMNS: u32 = 32;
    const SPACING: f32 = 0.02;
    let spec = tube(COLUMNS, rows, SPACING, fabric);
    let turn = std::f32::consts::TAU / COLUMNS as f32;
    let radius = 0.5 * SPACING / lole_geom::trig::sin(0.5 * turn);
    let positions: Vec<Vec3> = (0..rows)
        .flat_map(|row| {
            (0..COLUMNS).map(move |column| {
                let angle = turn * column as f32;
                let (sin, cos) = (lole_geom::trig::sin(angle), lole_geom::trig::cos(angle));
                Vec3::new(radius * cos, -(row as f32) * SPACING, radius * sin)
            })
        })
        .collect();
    let mut world = World::new(&spec, &positions);
    let velocities: Vec<Vec3> = (0..positions.len())
        .map(|particle| {
            if particle < COLUMNS as usize {
                Vec3::ZERO
            } else {
                Vec3::X * 0.5
            }
        })
        .collect();
    world.state.set_velocities(&world.model, &velocities);
    (0..frames)
        .map(|_| {
            world.step(&[]);
            mean(&world.positions()[(COLUMNS * (rows - 1)) as usize..]).x
        })
        .collect()
}

#[test]
fn a_longer_skirt_sways_farther() {
    let farthest = |rows: u32| sway(rows, COTTON, 40).into_iter().fold(0.0, f32::max);
    let (short, long) = (farthest(16), farthest(36));
    // A chain's swing grows with the root of its length, here 0.3 and 0.7 m; a tube resists shear
    // besides, the more the shorter it is.
    let root = (0.7_f32 / 0.3).sqrt();
    assert!(root * short < long, "{long} m after {short} m");
}

/// What is left of a sway a second after it began: half a swing lasts about half a second.
fn left_of_sway(fabric: Fabric) -> f32 {
    let swing = sway(26, fabric, 120);
    let most = |swing: &[f32]| swing.iter().fold(0.0_f32, |most, x| most.max(x.abs()));
    most(&swing[60..]) / most(&swing[..60])
}

#[test]
fn sway_lasts_longer_with_less_damping() {
    let lefts = [0.2, 1.0, 3.0].map(|drag_rate| {
        left_of_sway(Fabric {
            drag_rate,
            ..COTTON
        })
    });
    assert!(lefts[1] < 0.95 * lefts[0], "{lefts:?}");
    assert!(lefts[2] < 0.8 * lefts[1], "{lefts:?}");
}

#[test]
fn sway_lasts_longer_with_less_internal_friction() {
    // The air takes the same from all three; the yarns hold up to 0, 0.1 and 0.3 degrees of
    // shear. With a degree of it they stick, and the skirt sways on as one of stiffer cloth.
    let lefts = [0.0_f32, 0.1, 0.3].map(|degrees| {
        left_of_sway(Fabric {
            drag_rate: 0.2,
            hysteresis: Hysteresis {
                bend: [2.0 * 5.0 * degrees * COTTON.bend[0]; 2],
                shear: 2.0 * degrees.to_radians() * COTTON.shear,
            },
            ..COTTON
        })
    });
    assert!(lefts[1] < 0.95 * lefts[0], "{lefts:?}");
    assert!(lefts[2] < 0.95 * lefts[1], "{lefts:?}");
}
