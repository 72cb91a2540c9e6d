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

/// Farthest distance from the axis at which a place at a height is met [m]; `None` where nothing is worn there.
fn outline(envelope: &Envelope, height: f32) -> Option<f32> {
    let place = Vec3::new(0.3, height, 0.1);
    let (clearance, _) = envelope.clearance(place)?;
    Some(place.with_y(0.0).length() - clearance)
}

#[test]
fn an_outline_goes_along_with_an_edge_and_steps_from_no_height_to_the_next() {
    let skirt = tube(0.205, 0.12);
    let triangles = skirt.model.spec().grid.triangles();
    let trunk = Trunk {
        axis: Vec3::ZERO,
        forward: Vec3::Z,
    };
    let mut envelope = Envelope::default();
    let mut before: Option<Vec<Option<f32>>> = None;
    for millimeter in 0..40_u8 {
        let by = Vec3::Y * (0.001 * f32::from(millimeter));
        let moved: Vec<Vec3> = skirt.positions().iter().map(|place| *place + by).collect();
        envelope.begin(trunk);
        envelope.put_on(&triangles, &moved);
        envelope.add_surfels(0.0, &mut Vec::new());
        let heights = (0..20_u8).map(|it| -0.10 + 0.006 * f32::from(it));
        let now: Vec<Option<f32>> = heights.map(|height| outline(&envelope, height)).collect();
        // The edge lies 8 cm below the axis at first, and rises.
        assert!(now[0].is_some_and(|radius| 0.2 < radius), "{now:?}");
        for (place, (now, before)) in now.iter().zip(before.iter().flatten()).enumerate() {
            if let (Some(now), Some(before)) = (now, before) {
                // It rises by as much as its slope where the edge comes by.
                assert!(
                    (now - before).abs() < 0.003,
                    "{place}: {before} and {now} m"
                );
            }
            // What comes new begins well inside of the cloth, and not as far out as its edge.
            let new = (before.is_none()).then_some(*now).flatten();
            assert!(new.is_none_or(|new| new < 0.20), "{place}: {new:?}");
        }
        before = Some(now);
    }
}

#[test]
fn an_outline_made_for_cloth_is_the_whole_one_around_it() {
    let skirt = tube(0.205, 0.12);
    let triangles = skirt.model.spec().grid.triangles();
    let positions = skirt.positions();
    let outer: Vec<Vec3> = (0..8_u8)
        .map(|it| Vec3::new(0.25, -0.10 - 0.005 * f32::from(it), 0.0))
        .collect();
    let [mut whole, mut around] = [Envelope::default(), Envelope::default()];
    let trunk = Trunk {
        axis: Vec3::ZERO,
        forward: Vec3::Z,
    };
    whole.begin(trunk);
    around.begin_around(trunk, &outer);
    for envelope in [&mut whole, &mut around] {
        envelope.put_on(&triangles, &positions);
        envelope.add_surfels(0.0, &mut Vec::new());
    }
    for height in (0..24_u8).map(|it| -0.06 - 0.01 * f32::from(it)) {
        let [whole, around] = [&whole, &around].map(|it| outline(it, height));
        if -0.25 < height {
            assert_eq!(whole, around, "at {height} m");
        }
    }
    assert_eq!(outline(&around, -0.45), None, "far below");
    assert!(outline(&whole, -0.45).is_some());
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
