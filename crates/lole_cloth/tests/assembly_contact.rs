//! Laws of contact between the pieces of an assembly, whatever their kinds.

mod mesh_support;

use std::num::NonZeroU32;

use glam::{Vec2, Vec3};
use lole_cloth::assembly::{
    Assembly, AssemblyInput, AssemblyState, ClothJoint, ClothPiece, ClothSeam, PieceParticle,
    PieceState, step,
};
use lole_cloth::mesh::{MeshModel, MeshSpec};
use lole_cloth::{
    ClothModel, ClothSpec, Crossings, Fabric, Grid, InstructionSet, MassLaw, SelfCollision,
    SolverConfig, Topology, mesh_state_hash, state_hash,
};
use lole_geom::triangle_grid::TriangleGrid;
use mesh_support::{DT, FABRIC, rectangle};

const RADIUS: f32 = 0.004;
const SPACING: f32 = 0.012;

/// Fabric that comes to rest.
const CALM: Fabric = Fabric {
    drag_rate: 3.0,
    ..FABRIC
};

fn config() -> SolverConfig {
    SolverConfig {
        structural_sweep_count: NonZeroU32::MIN,
        self_collision: Some(SelfCollision {
            radius: RADIUS,
            substep_interval: NonZeroU32::MIN,
            crossings: Crossings::Leave,
        }),
        ..SolverConfig::default()
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Grid,
    Mesh,
}

#[derive(Clone, Copy, PartialEq)]
enum Border {
    Free,
    Pinned,
}

/// A square of `side` by `side` particles, and where they lie flat [m].
fn square(kind: Kind, side: u32, border: Border, config: SolverConfig) -> (ClothPiece, Vec<Vec2>) {
    let is_border = |k: u32| {
        let (row, column) = (k / side, k % side);
        row == 0 || column == 0 || row + 1 == side || column + 1 == side
    };
    let pinned: Vec<bool> = (0..side * side)
        .map(|k| border == Border::Pinned && is_border(k))
        .collect();
    let jitter = if kind == Kind::Mesh { 0.4 } else { 0.0 };
    let (flat, triangles) = rectangle(side, side, SPACING, jitter);
    let config = Box::new(config);
    let piece = match kind {
        Kind::Grid => {
            let spec = ClothSpec {
                grid: Grid {
                    column_count: side,
                    row_count: side,
                    topology: Topology::Sheet,
                    spacing: [SPACING; 2],
                    flounce: None,
                    crimp: None,
                },
                fabric: CALM,
                row_layers: vec![1.0; side as usize],
                mass: MassLaw::AreaWeighted,
                pinned,
            };
            ClothPiece::Grid(Box::new(ClothModel::new(&spec).expect("a grid")), config)
        }
        Kind::Mesh => {
            let mut spec = MeshSpec::new(flat.clone(), triangles, CALM);
            spec.pinned = pinned;
            ClothPiece::Mesh(Box::new(MeshModel::new(&spec).expect("a surface")), config)
        }
    };
    (piece, flat)
}

fn triangles_of(piece: &ClothPiece) -> Vec<[u32; 3]> {
    match piece {
        ClothPiece::Grid(model, _) => model.spec().grid.triangles(),
        ClothPiece::Mesh(model, _) => model.triangles().to_vec(),
    }
}

struct World {
    assembly: Assembly,
    state: AssemblyState,
    pins: Vec<Vec<Vec3>>,
}

impl World {
    fn new(pieces: Vec<ClothPiece>, joints: &[ClothJoint], positions: &[Vec<Vec3>]) -> Self {
        let substeps = NonZeroU32::MIN.saturating_add(11);
        let assembly = Assembly::new(pieces, joints, substeps).expect("joints fit");
        let pins = assembly.pieces().iter().zip(positions);
        let pins = pins.map(|(piece, positions)| {
            let pins = piece.pin_indices().iter();
            pins.map(|&pin| positions[pin as usize]).collect()
        });
        Self {
            pins: pins.collect(),
            state: AssemblyState::new(&assembly, positions),
            assembly,
        }
    }

    fn step(&mut self) {
        let input = AssemblyInput {
            pin_targets: &self.pins,
            ..AssemblyInput::default()
        };
        step(&self.assembly, &input, &mut self.state, DT).expect("nothing is lost");
    }

    fn positions(&self, piece: usize) -> Vec<Vec3> {
        let mut positions = Vec::new();
        self.state.pieces[piece].copy_positions(&self.assembly.pieces()[piece], &mut positions);
        positions
    }

    /// Sides of triangles of either of two pieces that cross triangles of the other.
    fn crossings(&self) -> usize {
        let side = |one: usize, other: usize| {
            let positions = [one, other].map(|piece| self.positions(piece));
            let [sides, crossed] =
                [one, other].map(|piece| triangles_of(&self.assembly.pieces()[piece]));
            let search = TriangleGrid::new(&positions[1], &crossed, 2.0 * SPACING);
            let mut found = Vec::new();
            let mut count = 0;
            for [a, b, c] in sides {
                for [start, end] in [[a, b], [b, c], [c, a]] {
                    let [start, end] = [start, end].map(|end| positions[0][end as usize]);
                    search.crossed_by(start, end, &mut found);
                    count += found.len();
                }
            }
            count
        };
        side(0, 1) + side(1, 0)
    }
}

/// A smaller piece, turned and tilted a little, over a larger one that is held by its border.
fn dropped(kinds: [Kind; 2], config: &SolverConfig) -> World {
    let (held, held_flat) = square(kinds[0], 31, Border::Pinned, config.clone());
    let (free, free_flat) = square(kinds[1], 17, Border::Free, config.clone());
    let below = held_flat.iter().map(|p| Vec3::new(p.x, 0.0, p.y));
    let turn = Vec2::from_angle(0.3);
    let above = free_flat.iter().map(|&p| {
        let p = turn.rotate(p - 8.0 * SPACING) + 15.0 * SPACING;
        Vec3::new(p.x, 0.05 + 0.2 * (p.x - 15.0 * SPACING), p.y)
    });
    World::new(vec![held, free], &[], &[below.collect(), above.collect()])
}

#[test]
fn a_piece_dropped_on_another_lies_on_it() {
    use Kind::{Grid, Mesh};
    for (what, kinds) in [
        ("mesh on grid", [Grid, Mesh]),
        ("grid on mesh", [Mesh, Grid]),
        ("grid on grid", [Grid, Grid]),
        ("mesh on mesh", [Mesh, Mesh]),
    ] {
        let mut world = dropped(kinds, &config());
        for frame in 0..90 {
            world.step();
            assert_eq!(world.crossings(), 0, "{what}, frame {frame}");
        }
        let (below, above) = (world.positions(0), world.positions(1));
        let triangles = triangles_of(&world.assembly.pieces()[0]);
        let search = TriangleGrid::new(&below, &triangles, 2.0 * SPACING);
        let gaps = above.iter().map(|&point| {
            let nearest = search.nearest(point, 0.05).expect("it is there");
            nearest.distance
        });
        let mean = gaps.sum::<f32>() / above.len() as f32;
        // As thick as both, and a little where it does not lie all over.
        assert!(
            (0.9..1.3).contains(&(mean / (2.0 * RADIUS))),
            "{what}: {mean}"
        );
    }
}

#[test]
fn pieces_without_contact_fall_through_each_other() {
    let without = SolverConfig {
        self_collision: None,
        ..config()
    };
    let mut world = dropped([Kind::Grid, Kind::Mesh], &without);
    let crossed = (0..60).any(|_| {
        world.step();
        0 < world.crossings()
    });
    assert!(crossed);
}

#[test]
fn pieces_sewn_side_by_side_do_not_touch() {
    let hem = |config: SolverConfig| {
        let (mut upper, flat) = square(Kind::Grid, 15, Border::Free, config.clone());
        let (lower, lower_flat) = square(Kind::Mesh, 15, Border::Free, config);
        if let ClothPiece::Grid(model, _) = &mut upper {
            let mut spec = model.spec().clone();
            spec.pinned[..15].fill(true);
            **model = ClothModel::new(&spec).expect("a grid");
        }
        let line = |piece: usize, first: u32| -> Vec<PieceParticle> {
            (first..first + 15)
                .map(|particle| PieceParticle { piece, particle })
                .collect()
        };
        let pieces = vec![upper, lower];
        let seam = ClothSeam::along(&pieces, &line(0, 14 * 15), &line(1, 0)).expect("a seam");
        let hanging = |flat: &[Vec2], top: f32| -> Vec<Vec3> {
            (flat.iter())
                .map(|p| Vec3::new(p.x, top - p.y, 0.0))
                .collect()
        };
        let positions = [hanging(&flat, 0.0), hanging(&lower_flat, -14.0 * SPACING)];
        let mut world = World::new(pieces, &[ClothJoint::Seam(seam)], &positions);
        for _ in 0..20 {
            world.step();
        }
        [world.positions(0), world.positions(1)]
    };
    let without = SolverConfig {
        self_collision: None,
        ..config()
    };
    assert_eq!(hem(config()), hem(without));
}

#[test]
fn contact_between_pieces_has_the_same_bits_with_all_vector_instructions() {
    let hashes = |set: InstructionSet| {
        let config = SolverConfig {
            instruction_set: set,
            ..config()
        };
        let mut world = dropped([Kind::Grid, Kind::Mesh], &config);
        for _ in 0..25 {
            world.step();
        }
        world
            .state
            .pieces
            .iter()
            .map(|piece| match piece {
                PieceState::Grid(state) => state_hash(state),
                PieceState::Mesh(state) => mesh_state_hash(state),
            })
            .collect::<Vec<u64>>()
    };
    let expected = hashes(InstructionSet::Baseline);
    assert_eq!(hashes(InstructionSet::Wide), expected);
    assert_eq!(hashes(InstructionSet::Detected), expected);
}
