//! A tube of cloth on a character that bends: a skinned mesh of two bones, the way a game has it. `cargo run
//! --release --example character -p lole_cloth`.

#![allow(clippy::print_stdout, reason = "an example says what it found")]

use std::error::Error;

use glam::{Affine3A, Quat, Vec2, Vec3};
use lole_cloth::mesh::{self, MeshBody, MeshModel, MeshSpec, MeshState};
use lole_cloth::{Fabric, Grid, StepInput};
use lole_geom::trig;

/// Vertices around the limb, and rings along it; its radius and length [m].
const AROUND: u32 = 24;
const RINGS: u32 = 31;
const RADIUS: f32 = 0.05;
const LENGTH: f32 = 0.6;
/// Farthest that the elbow bends [rad].
const BENT: f32 = 1.2;

fn main() -> Result<(), Box<dyn Error>> {
    let limb = Limb::new();
    let mut body = MeshBody::new(&limb.bind, &limb.triangles, 0.012)?;
    // A sleeve over the elbow, 2 cm off the skin, its upper edge carried by the upper bone.
    let sleeve = tube(44, 24, RADIUS + 0.02, [0.45, 0.15]);
    let mut spec = MeshSpec::of_surface(&sleeve.0, sleeve.1.clone(), |_| Vec3::Y, Fabric::COTTON);
    spec.pinned[..44].fill(true);
    let model = MeshModel::new(&spec)?;
    let config = model.settings();
    let mut state = MeshState::new(&model, &sleeve.0);
    // The upper bone stands still here; a game would carry them.
    let pins = &sleeve.0[..44];
    for frame in 1..=180_u16 {
        let time = f32::from(frame) / 60.0;
        let bend = BENT * 0.5 * (1.0 - trig::cos(std::f32::consts::TAU * time / 3.0));
        body.pose(&limb.posed(bend))?;
        let depths = body.look(&model, &mut state);
        let input = StepInput {
            pin_targets: pins,
            surfels: body.surfels(),
            ..StepInput::default()
        };
        mesh::step(&model, &config, &input, &mut state, 1.0 / 60.0)?;
        if frame % 45 == 0 {
            let now = state.positions(&model);
            let strain = mesh::diagnose::strain(&model, &now);
            println!(
                "{time:.2} s: bent by {:.0} degrees, the sleeve is stretched by {:.1} % at the 99th percentile, {} of it deep",
                bend.to_degrees(),
                100.0 * strain.p99,
                depths.deep
            );
        }
    }
    Ok(())
}

/// A limb along the height, its elbow halfway.
struct Limb {
    bind: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    /// By vertex, the lower bone's share of it.
    shares: Vec<f32>,
}

impl Limb {
    fn new() -> Self {
        let (mut bind, mut triangles) = tube(AROUND, RINGS, RADIUS, [LENGTH, 0.0]);
        // Closed by a cap at either end.
        for (first, middle, is_top) in [(0, LENGTH, true), ((RINGS - 1) * AROUND, 0.0, false)] {
            let center = u32::try_from(bind.len()).unwrap_or(u32::MAX);
            bind.push(Vec3::Y * middle);
            triangles.extend((0..AROUND).map(|at| {
                let [one, next] = [first + at, first + (at + 1) % AROUND];
                if is_top {
                    [next, one, center]
                } else {
                    [one, next, center]
                }
            }));
        }
        let elbow = |place: &Vec3| ((0.5 * LENGTH + 0.06 - place.y) / 0.12).clamp(0.0, 1.0);
        let shares = bind.iter().map(elbow).collect();
        Self {
            bind,
            triangles,
            shares,
        }
    }

    /// Linear blend skinning: the lower bone turned about the elbow.
    fn posed(&self, bend: f32) -> Vec<Vec3> {
        let elbow = Vec3::Y * (0.5 * LENGTH);
        let turn = Affine3A::from_translation(elbow)
            * Affine3A::from_quat(Quat::from_rotation_x(bend))
            * Affine3A::from_translation(-elbow);
        let vertices = self.bind.iter().zip(&self.shares);
        vertices
            .map(|(place, share)| place.lerp(turn.transform_point3(*place), *share))
            .collect()
    }
}

/// Rings around the height from one level [m] to another: vertices and triangles, outward.
fn tube(
    around: u32,
    rings: u32,
    radius: f32,
    [top, bottom]: [f32; 2],
) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let vertices = (0..rings).flat_map(|ring| {
        let height = top + (bottom - top) * ring as f32 / (rings - 1) as f32;
        (0..around).map(move |at| {
            let (sin, cos) = trig::sin_cos(std::f32::consts::TAU * at as f32 / around as f32);
            Vec3::new(radius * cos, height, radius * sin)
        })
    });
    // Columns run from +X to +Z and rows down: outward.
    let grid = Grid::tube(around, rings, Vec2::ONE.to_array());
    (vertices.collect(), grid.triangles())
}
