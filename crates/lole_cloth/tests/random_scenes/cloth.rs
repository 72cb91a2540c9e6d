//! The cloth of a random scene: a grid, triangles, or a pile of both.

use std::fmt::Write as _;
use std::num::NonZeroU32;

use glam::{Vec2, Vec3};
use lole_cloth::assembly::{
    Assembly, AssemblyInput, AssemblyState, ClothJoint, ClothPiece, ClothSeam, PieceParticle,
    PieceState, step as step_assembly,
};
use lole_cloth::mesh::{self, MeshModel, MeshSpec, MeshState};
use lole_cloth::scenes::waved_ring;
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Crossings, Fabric, SelfCollision, SolverConfig, StepInput,
    Topology, step,
};
use lole_geom::{Capsule, Chance, Surfel, trig};

use crate::mesh_support::rectangle;
use crate::xpbd_support::{FABRIC, sheet_spec};

/// What moves.
enum Moving {
    Grid(Box<ClothModel>, SolverConfig, Box<ClothState>),
    Mesh(Box<MeshModel>, SolverConfig, Box<MeshState>),
    Pieces(Box<Assembly>, Box<AssemblyState>),
}

/// Cloth of one or more pieces, whose particles are numbered piece by piece.
pub(super) struct Cloth {
    moving: Moving,
    pub(super) triangles: Vec<[u32; 3]>,
    /// By particle: itself, or the first of those to which it is sewn.
    pub(super) names: Vec<u32>,
}

/// How a piece lies at the start.
#[derive(Debug, Clone, Copy)]
enum Shape {
    /// Level.
    Level,
    /// Hanging in two layers so far apart [m], the fold below.
    Folded(f32),
    /// Rolled up like a scroll: inner radius and way from layer to layer [m].
    Rolled(f32, f32),
}

impl Shape {
    /// Where a place of the flat piece lies, of a piece so long [m].
    fn place(self, at: Vec2, length: f32) -> Vec3 {
        match self {
            Self::Level => Vec3::new(at.x, 0.0, at.y),
            Self::Folded(gap) => {
                let bend = 0.5 * std::f32::consts::PI * gap;
                let leg = 0.5 * (length - bend);
                let past = (at.y - leg).clamp(0.0, bend);
                let (sin, cos) = trig::sin_cos(2.0 * past / gap);
                let up = (at.y - leg - bend).max(0.0);
                let below = at.y.min(leg) - up + 0.5 * gap * sin;
                Vec3::new(at.x, -below, -0.5 * gap * cos)
            }
            Self::Rolled(inner, pitch) => {
                let growth = pitch / std::f32::consts::TAU;
                // The length of a spiral whose radius grows slowly: `inner angle + growth angle² / 2`.
                let angle = ((inner * inner + 2.0 * growth * at.y).sqrt() - inner) / growth;
                let radius = inner + growth * angle;
                let (sin, cos) = trig::sin_cos(angle % std::f32::consts::TAU);
                Vec3::new(at.x, -radius * cos, radius * sin)
            }
        }
    }
}

/// A piece that is not yet laid.
struct Cut {
    columns: u32,
    rows: u32,
    spacing: f32,
}

impl Cut {
    fn draw(chance: &mut Chance) -> Self {
        let mut count = || 8 + u32::try_from(chance.bits() % 17).expect("a few");
        let (columns, rows) = (count(), count());
        Self {
            columns,
            rows,
            spacing: chance.between(0.006, 0.014),
        }
    }

    const fn length(&self) -> f32 {
        (self.rows - 1) as f32 * self.spacing
    }

    fn flat(&self) -> Vec<Vec2> {
        let rows =
            (0..self.rows).flat_map(|row| (0..self.columns).map(move |column| [column, row]));
        rows.map(|[column, row]| Vec2::new(column as f32, row as f32) * self.spacing)
            .collect()
    }

    /// Some random particles.
    fn pinned(&self, chance: &mut Chance) -> Vec<bool> {
        let (columns, rows) = (self.columns as usize, self.rows as usize);
        let kind = chance.bits() % 6;
        let mut is_pinned = |index: usize| {
            let (row, column) = (index / columns, index % columns);
            let at_end = [
                row == 0,
                row == rows - 1,
                column == 0,
                column == columns - 1,
            ];
            match kind {
                0 => false,
                1 => at_end[0] && (at_end[2] || at_end[3]),
                2 => at_end[0],
                3 => at_end[0] || at_end[1],
                4 => (at_end[0] || at_end[1]) && (at_end[2] || at_end[3]),
                _ => chance.falls(0.03),
            }
        };
        (0..columns * rows).map(&mut is_pinned).collect()
    }
}

fn fabric(chance: &mut Chance) -> Fabric {
    let bend = *chance.choose(&[1.0e-6, 5.0e-6, 5.0e-5]).expect("three");
    Fabric {
        bend: [bend; 2],
        twist: bend,
        friction: chance.between(0.0, 0.6),
        cloth_friction: chance.between(0.0, 0.6),
        ..FABRIC
    }
}

fn count(chance: &mut Chance, least: u32, most: u32) -> u32 {
    least + u32::try_from(chance.bits() % u64::from(most - least + 1)).expect("a few")
}

fn config(chance: &mut Chance, spacing: f32) -> SolverConfig {
    let at_least_one = |count: u32| NonZeroU32::new(count).unwrap_or(NonZeroU32::MIN);
    SolverConfig {
        substep_count: at_least_one(count(chance, 3, 12)),
        structural_sweep_count: at_least_one(count(chance, 1, 4)),
        gathered_sweep_count: count(chance, 0, 2),
        contact_offset: *chance.choose(&[0.0, 0.002]).expect("two"),
        tether_scale: chance.falls(0.5).then_some(1.0),
        self_collision: Some(SelfCollision {
            radius: spacing * chance.between(0.2, 0.45),
            substep_interval: at_least_one(count(chance, 1, 2)),
            crossings: Crossings::Repair,
        }),
        ..SolverConfig::default()
    }
}

impl Cloth {
    pub(super) fn draw(chance: &mut Chance, about: &mut String) -> Self {
        match chance.bits() % 8 {
            0..=2 => Self::sheet(chance, about),
            3 => Self::tube(chance, about),
            4 | 5 => Self::mesh(chance, about),
            _ => Self::pile(chance, about),
        }
    }

    fn shape(chance: &mut Chance, spacing: f32, about: &mut String) -> Shape {
        let gap = spacing * chance.between(0.6, 1.5);
        let (shape, words) = match chance.bits() % 3 {
            0 => (Shape::Level, "level"),
            1 => (Shape::Folded(gap), "folded"),
            _ => (Shape::Rolled(2.0 * spacing, gap), "rolled up"),
        };
        about.push_str(words);
        shape
    }

    fn of_grid(spec: &ClothSpec, config: SolverConfig, places: &[Vec3]) -> Self {
        let model = ClothModel::new(spec).expect("a grid");
        Self {
            names: (0..).take(places.len()).collect(),
            triangles: spec.grid.triangles(),
            moving: Moving::Grid(
                Box::new(model.clone()),
                config,
                Box::new(ClothState::new(&model, places)),
            ),
        }
    }

    fn sheet(chance: &mut Chance, about: &mut String) -> Self {
        let cut = Cut::draw(chance);
        about.push_str("a sheet, ");
        let shape = Self::shape(chance, cut.spacing, about);
        let spec = ClothSpec {
            pinned: cut.pinned(chance),
            ..sheet_spec(cut.columns, cut.rows, cut.spacing, fabric(chance))
        };
        let places = cut
            .flat()
            .into_iter()
            .map(|at| shape.place(at, cut.length()));
        let places: Vec<_> = places.collect();
        Self::of_grid(&spec, config(chance, cut.spacing), &places)
    }

    /// A gathered tube that hangs from its first row.
    fn tube(chance: &mut Chance, about: &mut String) -> Self {
        let (columns, rows) = (count(chance, 30, 60), count(chance, 6, 14));
        let spacing = chance.between(0.006, 0.012);
        about.push_str("a gathered tube");
        let mut spec = sheet_spec(columns, rows, spacing, fabric(chance));
        spec.grid.topology = Topology::Tube;
        let pinned_rows = *chance
            .choose(&[&[][..], &[0], &[0, 2], &[0, 5]])
            .expect("four");
        let all = 0..rows * columns;
        spec.pinned = all
            .map(|it| pinned_rows.contains(&(it / columns)))
            .collect();
        let girth = columns as f32 * spacing;
        let radius = girth / std::f32::consts::TAU / chance.between(1.3, 2.5);
        let folds = f64::from(count(chance, 4, columns / 6));
        let ring = waved_ring(f64::from(radius), f64::from(girth), columns, folds);
        #[expect(clippy::cast_possible_truncation, reason = "drawn in f64, run in f32")]
        let places: Vec<_> = (0..rows)
            .flat_map(|row| ring.iter().map(move |&[x, z]| (row, x, z)))
            .map(|(row, x, z)| Vec3::new(x as f32, -(row as f32) * spacing, z as f32))
            .collect();
        Self::of_grid(&spec, config(chance, spacing), &places)
    }

    fn mesh(chance: &mut Chance, about: &mut String) -> Self {
        let cut = Cut::draw(chance);
        about.push_str("triangles, ");
        let shape = Self::shape(chance, cut.spacing, about);
        let (flat, triangles) = rectangle(cut.columns, cut.rows, cut.spacing, 0.4);
        let places = flat.iter().map(|&at| shape.place(at, cut.length()));
        let places: Vec<_> = places.collect();
        let mut spec = MeshSpec::new(flat, triangles.clone(), fabric(chance));
        spec.pinned = cut.pinned(chance);
        let model = MeshModel::new(&spec).expect("a surface");
        let state = MeshState::new(&model, &places);
        let config = config(chance, cut.spacing);
        Self {
            names: (0..).take(places.len()).collect(),
            triangles,
            moving: Moving::Mesh(Box::new(model), config, Box::new(state)),
        }
    }

    /// Two or three pieces above each other, grids and triangles; two of triangles may be sewn together.
    fn pile(chance: &mut Chance, about: &mut String) -> Self {
        let cut = Cut::draw(chance);
        let (piece_count, is_sewn) = (count(chance, 2, 3), chance.falls(0.5));
        let config = config(chance, cut.spacing);
        let gap = cut.spacing * chance.between(0.5, 1.5);
        let mut pieces = Vec::new();
        let mut starts = Vec::new();
        let (mut triangles, mut names) = (Vec::new(), Vec::new());
        for piece in 0..piece_count {
            let first = u32::try_from(names.len()).expect("few");
            let is_sewn_too = is_sewn && piece < 2;
            let (flat, corners) = rectangle(cut.columns, cut.rows, cut.spacing, 0.3);
            let height = |at: &Vec2| {
                // Sewn edges meet in the middle between the two.
                let share = if is_sewn_too {
                    (at.y / cut.spacing).min(2.0) * 0.5
                } else {
                    1.0
                };
                gap * if piece < 2 {
                    (piece as f32 - 0.5) * share
                } else {
                    2.0
                }
            };
            let is_grid = !is_sewn_too && chance.falls(0.5);
            let laid = if is_grid { cut.flat() } else { flat.clone() };
            starts.push(
                laid.iter()
                    .map(|at| Vec3::new(at.x, height(at), at.y))
                    .collect(),
            );
            let pinned = cut.pinned(chance);
            let made = if is_grid {
                let spec = ClothSpec {
                    pinned,
                    ..sheet_spec(cut.columns, cut.rows, cut.spacing, fabric(chance))
                };
                triangles.extend(
                    spec.grid
                        .triangles()
                        .iter()
                        .map(|it| it.map(|it| it + first)),
                );
                let model = ClothModel::new(&spec).expect("a grid");
                ClothPiece::Grid(Box::new(model), Box::new(config.clone()))
            } else {
                triangles.extend(corners.iter().map(|it| it.map(|it| it + first)));
                let mut spec = MeshSpec::new(flat, corners, fabric(chance));
                spec.pinned = pinned;
                // A seam that is pinned on both sides could not close.
                let edge = if is_sewn_too { cut.columns as usize } else { 0 };
                spec.pinned[..edge].fill(false);
                let model = MeshModel::new(&spec).expect("a surface");
                ClothPiece::Mesh(Box::new(model), Box::new(config.clone()))
            };
            pieces.push(made);
            let size = cut.columns * cut.rows;
            let is_named_before = |it: u32| is_sewn_too && piece == 1 && it < cut.columns;
            names.extend((0..size).map(|it| if is_named_before(it) { it } else { first + it }));
        }
        let stitch = |particle: u32| [0, 1].map(|piece| PieceParticle { piece, particle }.into());
        let seam = is_sewn.then(|| {
            let stitches = (0..cut.columns).map(stitch).collect();
            ClothJoint::Seam(ClothSeam { stitches })
        });
        let joints: Vec<ClothJoint> = seam.into_iter().collect();
        let assembly = Assembly::new(pieces, &joints, config.substep_count).expect("joints fit");
        let sewn = if is_sewn { ", two sewn" } else { "" };
        write!(about, "{piece_count} pieces{sewn}").expect("a string takes all");
        Self {
            moving: Moving::Pieces(
                Box::new(assembly.clone()),
                Box::new(AssemblyState::new(&assembly, &starts)),
            ),
            triangles,
            names,
        }
    }

    /// By piece, where the pins are [m].
    pub(super) fn pin_homes(&self) -> Vec<Vec<Vec3>> {
        let pieces = self.by_piece();
        let pins: Vec<&[u32]> = match &self.moving {
            Moving::Grid(model, ..) => vec![model.pin_indices()],
            Moving::Mesh(model, ..) => vec![model.pin_indices()],
            Moving::Pieces(assembly, _) => assembly
                .pieces()
                .iter()
                .map(ClothPiece::pin_indices)
                .collect(),
        };
        let homes = pieces.iter().zip(pins).map(|(places, pins)| {
            let homes = pins.iter().map(|&pin| places[pin as usize]);
            homes.collect()
        });
        homes.collect()
    }

    fn by_piece(&self) -> Vec<Vec<Vec3>> {
        let mut one = Vec::new();
        match &self.moving {
            Moving::Grid(model, _, state) => state.copy_positions(model, &mut one),
            Moving::Mesh(model, _, state) => state.copy_positions(model, &mut one),
            Moving::Pieces(assembly, state) => {
                let pieces = state.pieces.iter().zip(assembly.pieces());
                return pieces
                    .map(|(state, piece)| {
                        let mut places = Vec::new();
                        state.copy_positions(piece, &mut places);
                        places
                    })
                    .collect();
            }
        }
        vec![one]
    }

    /// Where everything is [m].
    pub(super) fn positions(&self) -> Vec<Vec3> {
        self.by_piece().concat()
    }

    /// Gives everything a velocity [m/s] by its place [m].
    pub(super) fn throw(&mut self, velocity: &impl Fn(Vec3) -> Vec3) {
        let all: Vec<Vec<Vec3>> = (self.by_piece().iter())
            .map(|places| places.iter().map(|&place| velocity(place)).collect())
            .collect();
        match &mut self.moving {
            Moving::Grid(model, _, state) => state.set_velocities(model, &all[0]),
            Moving::Mesh(model, _, state) => state.set_velocities(model, &all[0]),
            Moving::Pieces(assembly, state) => {
                let pieces = state.pieces.iter_mut().zip(assembly.pieces());
                for ((state, piece), velocities) in pieces.zip(&all) {
                    match (state, piece) {
                        (PieceState::Grid(state), ClothPiece::Grid(model, _)) => {
                            state.set_velocities(model, velocities);
                        }
                        (PieceState::Mesh(state), ClothPiece::Mesh(model, _)) => {
                            state.set_velocities(model, velocities);
                        }
                        _ => {}
                    }
                }
            }
        }
    }

    /// Moves on by `dt` [s]; whether the step was taken.
    pub(super) fn step(
        &mut self,
        (capsules, surfels): (&[Capsule], &[Surfel]),
        pin_targets: &[Vec<Vec3>],
        dt: f32,
    ) -> bool {
        let input = StepInput {
            pin_targets: &pin_targets[0],
            capsules,
            surfels,
            ..StepInput::default()
        };
        match &mut self.moving {
            Moving::Grid(model, config, state) => {
                step(model, config, &input, state, dt).expect("a target for every pin");
                true
            }
            Moving::Mesh(model, config, state) => {
                mesh::step(model, config, &input, state, dt) == Ok(())
            }
            Moving::Pieces(assembly, state) => {
                let input = AssemblyInput {
                    pin_targets,
                    capsules,
                    surfels,
                    ..AssemblyInput::default()
                };
                step_assembly(assembly, &input, state, dt).is_ok()
            }
        }
    }
}
