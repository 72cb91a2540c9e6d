//! Laws of layers: three skirts, one over the other, stay in their order while hips sway in them.

mod xpbd_support;

use std::f64::consts::TAU;

use glam::Vec3;
use lole_cloth::collision::layer::{Envelope, Layer, Trunk};
use lole_cloth::scenes::{swaying_hips, waved_ring};
use lole_cloth::{ClothSpec, Fabric, Grid, MassLaw, Topology, diagnose};
use xpbd_support::{FABRIC, World};

/// How far inside a layer its particles are looked for [m].
const REACH: f32 = 0.04;

/// Distance kept from the crests of a layer [m].
const GAP: f32 = 0.002;

/// Whether outer layers meet inner ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Order {
    Kept,
    Open,
}

/// A tube of `radius` [m] with soft waves, pinned at its upper ring.
fn tube(radius: f64, areal_density: f32) -> World {
    full_tube((radius, 1.06), areal_density)
}

/// A tube with soft waves, pinned at its upper ring; `fullness` is its cloth over the circle that it is laid on.
fn full_tube((radius, fullness): (f64, f64), areal_density: f32) -> World {
    let (column_count, row_count) = (64, 24);
    let girth = fullness * TAU * radius;
    let spacing = girth / f64::from(column_count);
    let grid = Grid {
        column_count,
        row_count,
        topology: Topology::Tube,
        spacing: [glam::DVec2::splat(spacing).as_vec2().x, 0.018],
        flounce: None,
        crimp: None,
    };
    let ring = waved_ring(radius, girth, column_count, 8.0);
    let positions: Vec<Vec3> = (0..row_count)
        .flat_map(|row| {
            let height = -0.08 - 0.018 * f64::from(row);
            ring.iter()
                .map(move |&[x, z]| glam::DVec3::new(x, height, z).as_vec3())
        })
        .collect();
    let spec = ClothSpec {
        grid,
        fabric: Fabric {
            areal_density,
            friction: 0.2,
            ..FABRIC
        },
        row_layers: vec![1.0; row_count as usize],
        mass: MassLaw::Uniform,
        pinned: (0..grid.particle_count())
            .map(|particle| particle < column_count as usize)
            .collect(),
    };
    World::new(&spec, &positions)
}

/// Inversions of all neighboring layers.
fn inversions(layers: &[World]) -> usize {
    let triangles = layers[0].model.spec().grid.triangles();
    layers
        .windows(2)
        .map(|pair| {
            let inner = Layer {
                triangles: &triangles,
                positions: &pair[0].positions(),
            };
            diagnose::layer_inversions(inner, &pair[1].positions(), REACH)
        })
        .sum()
}

/// Moves all layers on by a frame, each over those inside of it where their order is kept.
fn advance(layers: &mut [World], time: f64, order: Order) {
    let capsules = swaying_hips(time);
    let mut envelope = Envelope::default();
    envelope.begin(Trunk {
        axis: Vec3::ZERO,
        forward: Vec3::Z,
    });
    let mut surfels = Vec::new();
    for layer in layers.iter_mut() {
        layer.step_over(&capsules, &surfels);
        if order == Order::Kept {
            let triangles = layer.model.spec().grid.triangles();
            envelope.put_on(&triangles, &layer.positions());
            surfels.clear();
            envelope.add_surfels(-GAP, &mut surfels);
        }
    }
}

/// Worst number of inversions over two seconds of swaying.
fn worst_inversions(order: Order) -> usize {
    let mut layers = [(0.205, 0.12), (0.215, 0.2), (0.225, 0.1)].map(|(r, w)| tube(r, w));
    assert_eq!(inversions(&layers), 0, "the start is in order");
    let frames = 1..=120_u32;
    let worst = frames.map(|frame| {
        advance(&mut layers, f64::from(frame) / 60.0, order);
        inversions(&layers)
    });
    worst.max().unwrap_or(0)
}

#[test]
fn three_layers_stay_in_their_order_while_hips_sway() {
    assert_eq!(worst_inversions(Order::Kept), 0);
}

#[test]
fn unordered_layers_pass_through_each_other() {
    assert!(50 < worst_inversions(Order::Open));
}

#[test]
fn a_start_in_the_wrong_order_comes_right_soon_and_without_a_pop() {
    // The outer one has the cloth to go around the inner one.
    let mut layers = [(0.215, 1.03), (0.209, 1.1)].map(|ring| full_tube(ring, 0.12));
    let wrong = inversions(&layers);
    assert!(500 < wrong, "{wrong} particles start on the wrong side");
    for frame in 0..90 {
        advance(&mut layers, 0.0, Order::Kept);
        for layer in &layers {
            let speeds = layer.velocities();
            let fastest = speeds.iter().map(|v| v.length()).fold(0.0, f32::max);
            assert!(fastest < 4.0, "{fastest} m/s in frame {frame}");
        }
    }
    let triangles = layers[0].model.spec().grid.triangles();
    // The pinned rings cannot come right, nor what they hold; what hangs freely does.
    let inner = layers[0].positions();
    let layer = Layer {
        triangles: &triangles,
        positions: &inner,
    };
    let free = &layers[1].positions()[5 * 64..];
    assert_eq!(diagnose::layer_inversions(layer, free, REACH), 0);
}
