//! Specimens of cloth held level by a disc, after Cusick: round ones of triangles, and squares of
//! the same area as grids, which are the ones that know internal friction.
#![allow(dead_code, reason = "a test and an example use some of it each")]

use std::f32::consts::{PI, TAU};
use std::num::NonZeroU32;

use glam::{Vec2, Vec3};
use lole_cloth::mesh::{self, MeshModel, MeshSpec, MeshState};
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Fabric, Grid, MassLaw, SolverConfig, StepInput, Topology,
    step,
};
use lole_geom::trig;

/// Radii of the disc and of the specimen [m].
#[derive(Clone, Copy)]
pub(crate) struct Drape {
    pub(crate) disc: f32,
    pub(crate) specimen: f32,
}

/// How a specimen hangs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hung {
    /// Shadow less disc over specimen less disc.
    pub(crate) coefficient: f32,
    /// Folds of the hem.
    pub(crate) folds: u32,
}

/// Frames until a specimen hangs still, and the drag [1/s] of air so thick that it sinks and does
/// not swing: friction keeps what it comes from.
const FRAMES: u32 = 300;
const DRAG: f32 = 40.0;
/// Height of the first unevenness [m].
const SEED: f32 = 2.0e-4;
/// Rings of a round specimen, cells along a side of a square one.
const RINGS: u32 = 24;
const CELLS: u32 = 40;

fn settings() -> SolverConfig {
    SolverConfig {
        substep_count: NonZeroU32::MIN.saturating_add(23),
        structural_sweep_count: NonZeroU32::MIN.saturating_add(1),
        row_strides: Vec::new(),
        column_strides: Vec::new(),
        tether_scale: None,
        ..SolverConfig::default()
    }
}

/// Uneven outside the disc as no symmetry of the specimen is.
fn start(flat: Vec2, drape: Drape) -> Vec3 {
    let beyond = (flat.length() - drape.disc).max(0.0) / drape.disc;
    let uneven = trig::sin(47.0 * flat.x + 31.0 * flat.y) + trig::sin(23.0 * flat.y + 1.0);
    Vec3::new(flat.x, SEED * beyond * uneven, flat.y)
}

/// Rings of `6 k` points and the triangles between them.
fn disc(radius: f32, rings: u32) -> (Vec<Vec2>, Vec<[u32; 3]>) {
    let mut points = vec![Vec2::ZERO];
    let mut triangles = Vec::new();
    let first = |ring: u32| {
        if ring == 0 {
            0
        } else {
            1 + 3 * ring * (ring - 1)
        }
    };
    let at = |ring: u32, index: u32| first(ring) + if ring == 0 { 0 } else { index % (6 * ring) };
    for ring in 1..=rings {
        let reach = radius * ring as f32 / rings as f32;
        points.extend((0..6 * ring).map(|index| {
            let angle = TAU * index as f32 / (6 * ring) as f32;
            Vec2::new(trig::cos(angle), trig::sin(angle)) * reach
        }));
        for side in 0..6 {
            let (outer, inner) = (side * ring, side * (ring - 1));
            for step in 0..ring {
                let [a, b] = [0, 1].map(|next| at(ring, outer + step + next));
                triangles.push([at(ring - 1, inner + step), a, b]);
                if step + 1 < ring {
                    let next = at(ring - 1, inner + step + 1);
                    triangles.push([at(ring - 1, inner + step), b, next]);
                }
            }
        }
    }
    (points, triangles)
}

/// A round specimen of triangles, elastic.
pub(crate) fn round(fabric: Fabric, drape: Drape) -> Hung {
    let fabric = Fabric {
        drag_rate: DRAG,
        ..fabric
    };
    let (flat, triangles) = disc(drape.specimen, RINGS);
    let places: Vec<Vec3> = flat.iter().map(|&point| start(point, drape)).collect();
    let mut spec = MeshSpec::new(flat, triangles, fabric);
    for (pinned, point) in spec.pinned.iter_mut().zip(&spec.flat_positions) {
        *pinned = point.length() <= 1.001 * drape.disc;
    }
    let model = MeshModel::new(&spec).expect("a sound piece");
    let pins: Vec<Vec3> = (model.pin_indices().iter())
        .map(|&pin| places[pin as usize])
        .collect();
    let mut state = MeshState::new(&model, &places);
    let input = StepInput {
        pin_targets: &pins,
        ..StepInput::default()
    };
    for _ in 0..FRAMES {
        let outcome = mesh::step(&model, &settings(), &input, &mut state, 1.0 / 60.0);
        assert_eq!(outcome, Ok(()));
    }
    let mut positions = Vec::new();
    state.copy_positions(&model, &mut positions);
    let hem = (6 * RINGS) as usize;
    hung(&positions[positions.len() - hem..], drape)
}

/// A square specimen as a grid, as large as the round one.
pub(crate) fn square(fabric: Fabric, drape: Drape) -> Hung {
    let side = drape.specimen * PI.sqrt();
    let spacing = side / CELLS as f32;
    let count = CELLS + 1;
    let grid = Grid {
        column_count: count,
        row_count: count,
        topology: Topology::Sheet,
        spacing: [spacing; 2],
        flounce: None,
        crimp: None,
    };
    let flat: Vec<Vec2> = (0..count * count)
        .map(|index| {
            Vec2::new((index % count) as f32, (index / count) as f32) * spacing
                - Vec2::splat(0.5 * side)
        })
        .collect();
    let places: Vec<Vec3> = flat.iter().map(|&point| start(point, drape)).collect();
    let spec = ClothSpec {
        grid,
        fabric: Fabric {
            drag_rate: DRAG,
            ..fabric
        },
        row_layers: vec![1.0; count as usize],
        mass: MassLaw::AreaWeighted,
        pinned: (flat.iter())
            .map(|point| point.length() <= drape.disc)
            .collect(),
    };
    let model = ClothModel::new(&spec).expect("a sound cloth");
    let pins: Vec<Vec3> = (model.pin_indices().iter())
        .map(|&pin| places[pin as usize])
        .collect();
    let mut state = ClothState::new(&model, &places);
    let input = StepInput {
        pin_targets: &pins,
        ..StepInput::default()
    };
    for _ in 0..FRAMES {
        step(&model, &settings(), &input, &mut state, 1.0 / 60.0).expect("a target for every pin");
    }
    let mut positions = Vec::new();
    state.copy_positions(&model, &mut positions);
    let last = CELLS;
    let hem: Vec<Vec3> = (0..last)
        .map(|column| [0, column])
        .chain((0..last).map(|row| [row, last]))
        .chain((0..last).map(|column| [last, last - column]))
        .chain((0..last).map(|row| [last - row, 0]))
        .map(|[row, column]| positions[grid.index(row, column)])
        .collect();
    hung(&hem, drape)
}

/// What the hem tells, once around.
fn hung(hem: &[Vec3], drape: Drape) -> Hung {
    // Twice the area of the shadow's outline.
    let doubled: f32 = (hem.iter().zip(hem.iter().cycle().skip(1)))
        .map(|(here, next)| here.x * next.z - here.z * next.x)
        .sum();
    let square = drape.disc * drape.disc;
    let whole = drape.specimen * drape.specimen - square;
    let shadow = 0.5 * doubled.abs() / PI - square;
    let mean = hem.iter().map(|place| place.y).sum::<f32>() / hem.len() as f32;
    let [low, high] = (hem.iter())
        .fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], place| {
            [low.min(place.y), high.max(place.y)]
        });
    let margin = 0.05 * (high - low);
    let (mut is_up, mut folds) = (None, 0);
    // Twice round, so that the first place does not matter.
    for (index, place) in hem.iter().chain(hem).enumerate() {
        let now = if mean + margin < place.y {
            true
        } else if place.y < mean - margin {
            false
        } else {
            continue;
        };
        if hem.len() <= index && is_up == Some(false) && now {
            folds += 1;
        }
        is_up = Some(now);
    }
    Hung {
        coefficient: shadow / whole,
        folds,
    }
}
