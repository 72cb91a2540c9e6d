//! Laws of contact with a body that is given as a moving triangle mesh.

mod mesh_support;

use glam::{Quat, Vec3};
use lole_cloth::mesh::{self, MeshSpec};
use lole_cloth::{Fabric, SKIN_REACH, StepInput};
use lole_geom::{MeshSurfels, Surfel, trig};
use mesh_support::{DT, FABRIC, World, rectangle};

/// Sides of the body, and its rings.
const AROUND: u16 = 24;
const RINGS: u16 = 12;

/// Radius of the body at a height [m], which counts from -1 to 1.
fn radius_at(height: f32) -> f32 {
    0.09 + 0.05 * height * height
}

/// How far a place is from the upright axis [m].
fn out(at: Vec3) -> f32 {
    at.with_y(0.0).length()
}

/// A closed body of triangles, as high as it is wide, whose waist is narrower than its ends: corners,
/// normals and triangles.
struct Body {
    rest: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    surfels: MeshSurfels,
}

impl Body {
    fn new(spacing: f32) -> Self {
        let mut rest = vec![Vec3::NEG_Y * 0.2];
        for ring in 0..=RINGS {
            let height = f32::from(ring) / f32::from(RINGS) * 2.0 - 1.0;
            let radius = radius_at(height);
            rest.extend((0..AROUND).map(|side| {
                let angle = std::f32::consts::TAU * f32::from(side) / f32::from(AROUND);
                let (sin, cos) = trig::sin_cos(angle);
                Vec3::new(radius * cos, 0.2 * height, radius * sin)
            }));
        }
        rest.push(Vec3::Y * 0.2);
        let at = |ring: u16, side: u16| 1 + u32::from(ring * AROUND + side % AROUND);
        let last = u32::try_from(rest.len() - 1).expect("few");
        let mut triangles = Vec::new();
        for side in 0..AROUND {
            triangles.push([0, at(0, side), at(0, side + 1)]);
            triangles.push([last, at(RINGS, side + 1), at(RINGS, side)]);
            for ring in 0..RINGS {
                let [a, b] = [at(ring, side), at(ring, side + 1)];
                let [c, d] = [at(ring + 1, side), at(ring + 1, side + 1)];
                triangles.extend([[a, c, b], [b, c, d]]);
            }
        }
        let surfels = MeshSurfels::new(&rest, &triangles, spacing);
        Self {
            rest,
            triangles,
            surfels,
        }
    }

    /// The corners at a time [s]: it sways, leans and is twisted.
    fn posed(&self, time: f32) -> Vec<Vec3> {
        let (lean, sway) = motion(time);
        let twist = |height: f32| Quat::from_rotation_y(4.0 * sway.x * height / 0.2);
        let corners = self.rest.iter();
        corners
            .map(|&at| lean * (twist(at.y) * at) + sway)
            .collect()
    }

    fn surfels_at(&self, corners: &[Vec3]) -> Vec<Surfel> {
        let normals = lole_geom::mesh::vertex_normals(corners, &self.triangles);
        let mut surfels = Vec::new();
        self.surfels.pose(corners, &normals, &mut surfels);
        surfels
    }
}

/// How the body leans at a time [s], and how far it has swayed [m].
fn motion(time: f32) -> (Quat, Vec3) {
    let lean = Quat::from_rotation_x(0.5 * trig::sin_cos(2.0 * time).0);
    (lean, Vec3::X * (0.1 * trig::sin_cos(3.0 * time).0))
}

/// How deep the deepest place is in the body [m]: a twist leaves every height as round as it was. The flat
/// sides lie within the circle.
fn deepest(time: f32, places: &[Vec3]) -> f32 {
    let (lean, sway) = motion(time);
    let depth = |&place: &Vec3| {
        let at = lean.inverse() * (place - sway);
        let inside = 0.985 * radius_at(at.y / 0.2) - out(at);
        inside.min(0.2 - at.y.abs())
    };
    places.iter().map(depth).fold(0.0, f32::max)
}

/// A level square of 60 cm whose middle is at a height.
fn sheet_at(height: f32) -> World {
    let (flat, triangles) = rectangle(61, 61, 0.01, 0.4);
    let positions: Vec<_> = (flat.iter())
        .map(|place| Vec3::new(place.x - 0.3, height, place.y - 0.3))
        .collect();
    let friction = 0.6;
    let spec = MeshSpec::new(flat, triangles, Fabric { friction, ..FABRIC });
    let mut world = World::new(&spec, &positions);
    world.config.contact_offset = 0.004;
    world
}

fn step_on(world: &mut World, surfels: &[Surfel]) {
    let input = StepInput {
        pin_targets: &world.pins,
        surfels,
        ..StepInput::default()
    };
    let outcome = mesh::step(&world.model, &world.config, &input, &mut world.state, DT);
    assert_eq!(outcome, Ok(()));
}

/// However the mesh is cut into triangles and how it moves: cloth that falls over it stays outside of its
/// triangles.
#[test]
fn cloth_stays_outside_of_a_mesh_that_moves() {
    for spacing in [0.008, 0.014] {
        let body = Body::new(spacing);
        let mut world = sheet_at(0.24);
        for frame in 0..180_u16 {
            let time = (f32::from(frame) - 40.0).max(0.0) * DT;
            step_on(&mut world, &body.surfels_at(&body.posed(time)));
            let depth = deepest(time, &world.positions());
            assert!(depth < 0.003, "{spacing} m, {frame}: {depth} m deep");
        }
    }
}

/// What begins in a body comes out of it where it is no deeper than the body is searched.
#[test]
fn cloth_comes_out_of_a_body_as_deep_as_it_is_looked_for() {
    let body = Body::new(0.01);
    let surfels = body.surfels_at(&body.posed(0.0));
    let last = |height: f32| {
        let mut world = sheet_at(height);
        world.config.gravity = Vec3::ZERO;
        for _ in 0..120 {
            step_on(&mut world, &surfels);
        }
        // Beside the rim it is outside already.
        let middle: Vec<Vec3> = (world.positions().into_iter())
            .filter(|&at| out(at) < 0.06)
            .collect();
        assert!(!middle.is_empty());
        deepest(0.0, &middle)
    };
    for depth in [0.3, 0.6, 0.9].map(|share| share * SKIN_REACH) {
        let left = last(0.2 - depth);
        assert!(left < 0.001, "{depth} m: {left}");
    }
}
