//! The promise: what did not cross does not come to cross, whatever is done to it, and a tangle
//! grows by no more than drawing it out takes. Judged by exact predicates that share nothing with the engine.

mod exact_support;
mod mesh_support;
mod xpbd_support;

use std::num::NonZeroU32;

use glam::{Vec2, Vec3};
use lole_cloth::assembly::{
    Assembly, AssemblyInput, AssemblyState, ClothJoint, ClothPiece, ClothSeam, PieceParticle,
    step as step_assembly,
};
use lole_cloth::mesh::{MeshModel, MeshSpec};
use lole_cloth::{ClothModel, Crossings, Fabric, SelfCollision, SolverConfig};
use lole_geom::{Capsule, Chance, trig};

use exact_support::crossing_count;
use xpbd_support::{FABRIC, World, flat_positions, sheet_spec};

const COLUMNS: u32 = 26;
const ROWS: u32 = 22;
const SPACING: f32 = 0.01;

fn limp() -> Fabric {
    Fabric {
        bend: [5.0e-6; 2],
        twist: 5.0e-6,
        ..FABRIC
    }
}

fn keeping(config: &mut SolverConfig) {
    config.self_collision = Some(SelfCollision {
        radius: 0.004,
        substep_interval: NonZeroU32::MIN,
        crossings: Crossings::Repair,
    });
}

/// Waves of velocity that throw folds against each other, up to some meters a second.
fn gust(chance: &mut Chance, positions: &[Vec3]) -> Vec<Vec3> {
    let mut draw =
        |low: f32, high: f32| Vec3::from_array([(); 3].map(|()| chance.between(low, high)));
    let waves = [(); 3].map(|()| (draw(-60.0, 60.0), draw(-2.5, 2.5), draw(0.0, 6.0).x));
    let velocity = |place: &Vec3| {
        let each = waves
            .iter()
            .map(|(number, reach, phase)| *reach * trig::sin(number.dot(*place) + *phase));
        each.sum::<Vec3>()
    };
    positions.iter().map(velocity).collect()
}

/// A bar that sweeps through where the cloth is.
fn bar(frame: u16) -> Capsule {
    let x = 0.12 + 0.12 * trig::sin(0.11 * f32::from(frame));
    Capsule::uniform(Vec3::new(x, 0.02, -0.1), Vec3::new(x, 0.02, 0.4), 0.015)
}

#[test]
fn a_grid_that_does_not_cross_never_comes_to_cross() {
    for seed in 0..5 {
        let mut chance = Chance::new(seed);
        let mut spec = sheet_spec(COLUMNS, ROWS, SPACING, limp());
        let last = COLUMNS as usize - 1;
        (spec.pinned[0], spec.pinned[last]) = (true, true);
        let mut world = World::new(&spec, &flat_positions(COLUMNS, ROWS, SPACING));
        keeping(&mut world.config);
        let triangles = spec.grid.triangles();
        for frame in 0..90_u16 {
            if frame % 9 == 0 {
                let velocities = gust(&mut chance, &world.positions());
                world.state.set_velocities(&world.model, &velocities);
            }
            // The corners come together and go apart.
            let by = 0.12 * (1.0 - trig::cos(0.07 * f32::from(frame)));
            world.pins = vec![
                Vec3::X * by,
                Vec3::X * ((COLUMNS - 1) as f32 * SPACING - by),
            ];
            world.step(&[bar(frame)]);
            let positions = world.positions();
            assert!(
                positions.iter().all(|it| it.is_finite()),
                "{seed}: frame {frame}"
            );
            assert_eq!(
                crossing_count(&triangles, &positions),
                0,
                "{seed}: frame {frame}"
            );
        }
    }
}

#[test]
fn a_mesh_that_does_not_cross_never_comes_to_cross() {
    for seed in 0..5 {
        let mut chance = Chance::new(100 + seed);
        let (flat, triangles) = mesh_support::rectangle(COLUMNS, ROWS, SPACING, 0.4);
        let positions: Vec<Vec3> = flat
            .iter()
            .map(|it: &Vec2| Vec3::new(it.x, 0.0, it.y))
            .collect();
        let spec = MeshSpec::new(flat, triangles.clone(), limp());
        let mut world = mesh_support::World::new(&spec, &positions);
        keeping(&mut world.config);
        let mut taken = 0;
        for frame in 0..90_u16 {
            if frame % 9 == 0 {
                let velocities = gust(&mut chance, &world.positions());
                world.state.set_velocities(&world.model, &velocities);
            }
            // A step that would lead nowhere is not taken, and that is a promise too.
            if world.try_step(&[bar(frame)]) == Ok(()) {
                taken += 1;
            }
            let positions = world.positions();
            assert_eq!(
                crossing_count(&triangles, &positions),
                0,
                "{seed}: frame {frame}"
            );
        }
        assert!(80 < taken, "{seed}: {taken} of 90 steps");
    }
}

#[test]
fn tangles_never_grow_beyond_what_drawing_them_out_takes() {
    for seed in 0..8 {
        let mut chance = Chance::new(200 + seed);
        let spec = sheet_spec(COLUMNS, ROWS, SPACING, limp());
        let reach = chance.between(0.004, 0.02);
        let thrown: Vec<Vec3> = flat_positions(COLUMNS, ROWS, SPACING)
            .into_iter()
            .map(|place| {
                let by = [(); 3].map(|()| chance.between(-reach, reach));
                place + Vec3::from_array(by)
            })
            .collect();
        let mut world = World::new(&spec, &thrown);
        keeping(&mut world.config);
        let triangles = spec.grid.triangles();
        let first = crossing_count(&triangles, &thrown);
        let mut known = first;
        // A contour that becomes shorter may meet more triangles for a while.
        let most = first + first / 4 + 8;
        for frame in 0..60 {
            world.step(&[]);
            let now = crossing_count(&triangles, &world.positions());
            assert!(now <= most, "{seed}: {first}, then {now} in frame {frame}");
            assert!(0 < known || now == 0, "{seed}: frame {frame}");
            known = now;
        }
        assert!(known < first, "{seed}: {first} stay {known}");
    }
}

/// A sheet folded in two whose ends, pinned all along, are drawn through each other and back.
#[test]
fn pins_that_would_cross_yield_and_come_back() {
    let mut spec = sheet_spec(16, 41, SPACING, limp());
    let columns = 16;
    for column in 0..columns {
        spec.pinned[column] = true;
        spec.pinned[40 * columns + column] = true;
    }
    // Up one side and down the other, 4 cm apart.
    let place = |(index, _): (usize, &Vec3)| {
        let (row, column) = (index / columns, index % columns);
        let (side, depth) = if row < 20 {
            (0.02, row)
        } else {
            (-0.02, 40 - row)
        };
        let side = if row == 20 { 0.0 } else { side };
        Vec3::new(column as f32 * SPACING, -(depth as f32) * SPACING, side)
    };
    let start: Vec<Vec3> = flat_positions(16, 41, SPACING)
        .iter()
        .enumerate()
        .map(place)
        .collect();
    let mut world = World::new(&spec, &start);
    keeping(&mut world.config);
    let triangles = spec.grid.triangles();
    let home = world.pins.clone();
    let mut most_off = 0.0_f32;
    for frame in 0..160_u16 {
        // To the other side and back within two seconds.
        let swing =
            0.0125 * (1.0 - trig::cos(std::f32::consts::TAU * f32::from(frame.min(120)) / 120.0));
        world.pins = (home.iter())
            .map(|pin| *pin - Vec3::Z * (swing * pin.z.signum()))
            .collect();
        world.step(&[]);
        let positions = world.positions();
        assert_eq!(crossing_count(&triangles, &positions), 0, "frame {frame}");
        let offs = world.model.pin_indices().iter().zip(&world.pins);
        let offs = offs.map(|(&pin, target)| positions[pin as usize].distance(*target));
        let off = offs.fold(0.0, f32::max);
        most_off = most_off.max(off);
        if 150 < frame {
            assert!(
                off < 1.0e-6,
                "they are home again: {off} m in frame {frame}"
            );
        }
    }
    assert!(0.002 < most_off, "they had to yield: {most_off} m");
}

/// Whether two of the pieces are sewn together.
#[derive(Clone, Copy, PartialEq)]
enum Seams {
    None,
    One,
}

/// A grid and two meshes, one below the other: the meshes are sewn to each other along an edge where
/// there is a seam. Triangles are numbered piece by piece, without those beside the seam, which a pull opens.
struct Pile {
    assembly: Assembly,
    state: AssemblyState,
    triangles: Vec<[u32; 3]>,
    piece_size: usize,
}

impl Pile {
    const SIDE: u32 = 14;

    fn new(seam: Seams) -> Self {
        let is_sewn = seam == Seams::One;
        let side = Self::SIDE;
        let mut config = SolverConfig {
            structural_sweep_count: NonZeroU32::MIN,
            ..SolverConfig::default()
        };
        keeping(&mut config);
        let grid = sheet_spec(side, side, SPACING, limp());
        let (flat, cut) = mesh_support::rectangle(side, side, SPACING, 0.3);
        let mesh = MeshSpec::new(flat.clone(), cut.clone(), limp());
        let model = ClothModel::new(&grid).expect("a grid");
        let mut pieces = vec![ClothPiece::Grid(Box::new(model), Box::new(config.clone()))];
        for _ in 0..2 {
            let model = MeshModel::new(&mesh).expect("a surface");
            pieces.push(ClothPiece::Mesh(Box::new(model), Box::new(config.clone())));
        }
        let size = side * side;
        let edge: Vec<u32> = (0..side).collect();
        let stitch = |particle: u32| [1, 2].map(|piece| PieceParticle { piece, particle }.into());
        let mut joints = Vec::new();
        if is_sewn {
            joints.push(ClothJoint::Seam(ClothSeam {
                stitches: edge.iter().map(|&it| stitch(it)).collect(),
            }));
        }
        let mut starts = vec![flat_positions(side, side, SPACING)];
        for layer in [1.0_f32, 2.0] {
            let height = |flat: &Vec2| {
                // Sewn edges meet in the middle between the two.
                let share = if is_sewn {
                    (flat.y / 0.02).min(1.0)
                } else {
                    1.0
                };
                0.03 + 0.01 * (layer - 1.5) * share
            };
            let place = |flat: &Vec2| Vec3::new(flat.x, height(flat), flat.y);
            starts.push(flat.iter().map(place).collect());
        }
        let assembly =
            Assembly::new(pieces, &joints, NonZeroU32::MIN.saturating_add(11)).expect("joints fit");
        let mut triangles = grid.grid.triangles();
        for piece in [1, 2] {
            let is_apart =
                |corners: &&[u32; 3]| !is_sewn || corners.iter().all(|corner| side <= *corner);
            let own = cut.iter().filter(is_apart);
            triangles.extend(own.map(|corners| corners.map(|corner| corner + size * piece)));
        }
        Self {
            state: AssemblyState::new(&assembly, &starts),
            assembly,
            triangles,
            piece_size: size as usize,
        }
    }

    fn positions(&self) -> Vec<Vec3> {
        let mut all = Vec::new();
        let mut one = Vec::new();
        for (state, piece) in self.state.pieces.iter().zip(self.assembly.pieces()) {
            state.copy_positions(piece, &mut one);
            all.extend_from_slice(&one);
        }
        all
    }

    fn throw(&mut self, chance: &mut Chance) {
        use lole_cloth::assembly::PieceState;
        let positions = self.positions();
        let velocities = gust(chance, &positions);
        let parts = velocities.chunks(self.piece_size);
        for ((state, piece), part) in self
            .state
            .pieces
            .iter_mut()
            .zip(self.assembly.pieces())
            .zip(parts)
        {
            match (state, piece) {
                (PieceState::Grid(state), ClothPiece::Grid(model, _)) => {
                    state.set_velocities(model, part);
                }
                (PieceState::Mesh(state), ClothPiece::Mesh(model, _)) => {
                    state.set_velocities(model, part);
                }
                _ => {}
            }
        }
    }
}

#[test]
fn pieces_that_do_not_cross_never_come_to_cross_each_other() {
    for seed in 0..6 {
        let mut chance = Chance::new(400 + seed);
        let seams = [Seams::None, Seams::One][usize::from(seed % 2 == 1)];
        let mut pile = Pile::new(seams);
        for frame in 0..90_u16 {
            if frame % 9 == 0 {
                pile.throw(&mut chance);
            }
            let input = AssemblyInput {
                capsules: &[bar(frame)],
                pin_targets: &[Vec::new(), Vec::new(), Vec::new()],
                ..AssemblyInput::default()
            };
            step_assembly(&pile.assembly, &input, &mut pile.state, 1.0 / 60.0)
                .expect("nothing is lost");
            let positions = pile.positions();
            let crossings = crossing_count(&pile.triangles, &positions);
            assert_eq!(crossings, 0, "{seed}: frame {frame}");
        }
    }
}

/// What a repair may do, seen from outside: the same step once with and once without it.
///
/// From cloth thrown about at random and from cloth that does not cross, in gusts and with pins that pull,
/// it never leaves more crossings than it found, and takes nothing farther than its reach and three times
/// the way of what went farthest.
#[test]
fn a_repair_raises_no_crossings_and_moves_nothing_far() {
    const REACH: f32 = 0.06;
    for seed in 0..12 {
        let mut chance = Chance::new(300 + seed);
        let mut spec = sheet_spec(COLUMNS, ROWS, SPACING, limp());
        let last = COLUMNS as usize - 1;
        (spec.pinned[0], spec.pinned[last]) = (true, true);
        let flat = flat_positions(COLUMNS, ROWS, SPACING);
        let reach = if seed % 3 == 0 {
            0.0
        } else {
            chance.between(0.002, 0.03)
        };
        let thrown: Vec<Vec3> = (flat.iter())
            .map(|&place| {
                let by = [(); 3].map(|()| chance.between(-1.0, 1.0));
                place + Vec3::from_array(by) * reach
            })
            .collect();
        let triangles = spec.grid.triangles();
        let mut known = World::new(&spec, &thrown);
        keeping(&mut known.config);
        let home = known.pins.clone();
        for frame in 0..40_u16 {
            if frame % 10 == 0 {
                let velocities = gust(&mut chance, &known.positions());
                known.state.set_velocities(&known.model, &velocities);
            }
            let by = 0.1 * (1.0 - trig::cos(0.09 * f32::from(frame)));
            let pins = vec![home[0] + Vec3::X * by, home[1] - Vec3::X * by];
            let (starts, velocities) = (known.positions(), known.velocities());
            // Fresh ones, which keep nothing apart in their substeps.
            let [repaired, left] = [Crossings::Repair, Crossings::Leave].map(|crossings| {
                let mut world = World::new(&spec, &starts);
                keeping(&mut world.config);
                if let Some(contact) = &mut world.config.self_collision {
                    contact.crossings = crossings;
                }
                world.state.set_velocities(&world.model, &velocities);
                world.pins.clone_from(&pins);
                world.step(&[bar(frame)]);
                world.positions()
            });
            let farthest = |from: &[Vec3], to: &[Vec3]| {
                let pairs = from.iter().zip(to);
                pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f32::max)
            };
            let [before, after] = [&left, &repaired].map(|it| crossing_count(&triangles, it));
            assert!(
                after <= before,
                "{seed}: frame {frame}, {before} became {after}"
            );
            let (moved, way) = (farthest(&left, &repaired), farthest(&starts, &left));
            assert!(
                moved <= REACH + 3.0 * way,
                "{seed}: frame {frame}, {moved} m moved where {way} m were gone"
            );
            known.pins.clone_from(&pins);
            known.step(&[bar(frame)]);
        }
    }
}
