//! Pieces of both kinds sewn together, and what else a maker puts in: each against a closed form or
//! what it must keep.

mod mesh_support;

use std::f32::consts::FRAC_PI_2;
use std::num::NonZeroU32;

use glam::{DVec3, Quat, Vec2, Vec3};
use lole_cloth::assembly::{
    Assembly, AssemblyInput, AssemblyState, Attachment, BoneFrame, ClothJoint, ClothPiece,
    ClothSeam, Drawstring, Elastic, Ends, PieceParticle, PieceState, Pleat, step,
};
use lole_cloth::mesh::{MeshModel, MeshSpec, Strip};
use lole_cloth::{
    ClothModel, ClothSpec, ClothState, Fabric, Grid, InstructionSet, MassLaw, SolverConfig,
    StepInput, Topology, mesh_state_hash, state_hash,
};
use mesh_support::{DT, Dice, FABRIC, World, rectangle};

fn config() -> SolverConfig {
    SolverConfig {
        structural_sweep_count: NonZeroU32::MIN,
        ..SolverConfig::default()
    }
}

fn untethered() -> SolverConfig {
    SolverConfig {
        tether_scale: None,
        column_strides: Vec::new(),
        ..config()
    }
}

fn mesh_piece(spec: &MeshSpec, config: SolverConfig) -> ClothPiece {
    let model = MeshModel::new(spec).expect("a surface");
    ClothPiece::Mesh(Box::new(model), Box::new(config))
}

fn grid_spec(columns: u32, rows: u32, spacing: f32) -> ClothSpec {
    let grid = Grid {
        column_count: columns,
        row_count: rows,
        topology: Topology::Sheet,
        spacing: [spacing; 2],
        flounce: None,
        crimp: None,
    };
    ClothSpec {
        grid,
        fabric: Fabric {
            drag_rate: 3.0,
            ..FABRIC
        },
        row_layers: vec![1.0; rows as usize],
        mass: MassLaw::AreaWeighted,
        pinned: (0..grid.particle_count())
            .map(|k| k < columns as usize)
            .collect(),
    }
}

/// An assembly on its way.
struct Sewn {
    assembly: Assembly,
    state: AssemblyState,
    pins: Vec<Vec<Vec3>>,
    frames: Vec<BoneFrame>,
}

impl Sewn {
    fn new(
        pieces: Vec<ClothPiece>,
        joints: &[ClothJoint],
        positions: &[Vec<Vec3>],
        substeps: u32,
    ) -> Self {
        let count = NonZeroU32::new(substeps).expect("a count");
        let assembly = Assembly::new(pieces, joints, count).expect("joints fit");
        let pins = assembly
            .pieces()
            .iter()
            .zip(positions)
            .map(|(piece, positions)| {
                (piece.pin_indices().iter())
                    .map(|&pin| positions[pin as usize])
                    .collect()
            });
        Self {
            pins: pins.collect(),
            state: AssemblyState::new(&assembly, positions),
            frames: Vec::new(),
            assembly,
        }
    }

    fn step(&mut self) {
        let input = AssemblyInput {
            pin_targets: &self.pins,
            frames: &self.frames,
            ..AssemblyInput::default()
        };
        step(&self.assembly, &input, &mut self.state, DT).expect("nothing is lost");
    }

    fn positions(&self, piece: usize) -> Vec<Vec3> {
        let mut positions = Vec::new();
        self.state.pieces[piece].copy_positions(&self.assembly.pieces()[piece], &mut positions);
        positions
    }
}

fn hanging(flat: &[Vec2], top: f32) -> Vec<Vec3> {
    flat.iter()
        .map(|flat| Vec3::new(flat.x, top - flat.y, 0.0))
        .collect()
}

/// The first or last so many particles of a piece.
fn line(piece: usize, particles: impl IntoIterator<Item = u32>) -> Vec<PieceParticle> {
    particles
        .into_iter()
        .map(|particle| PieceParticle { piece, particle })
        .collect()
}

/// A grid of 9 by 9 that hangs, and a mesh of `columns` by 9 that is sewn to its hem.
fn hem(columns: u32, width: f32) -> Sewn {
    let upper = grid_spec(9, 9, 0.02);
    let (mut flat, triangles) = rectangle(columns, 9, 0.02, 0.3);
    for place in &mut flat {
        place.x *= width / (columns - 1) as f32 / 0.02;
    }
    let lower = MeshSpec {
        ..MeshSpec::new(
            flat.clone(),
            triangles,
            Fabric {
                drag_rate: 3.0,
                ..FABRIC
            },
        )
    };
    let pieces = vec![
        ClothPiece::Grid(
            Box::new(ClothModel::new(&upper).expect("a grid")),
            Box::new(config()),
        ),
        mesh_piece(&lower, config()),
    ];
    let above = line(0, 72..81);
    let below = line(1, 0..columns);
    let seam = ClothSeam::along(&pieces, &above, &below).expect("a seam");
    let upper_flat: Vec<Vec2> = (0..81_u8)
        .map(|k| Vec2::new((k % 9).into(), (k / 9).into()) * 0.02)
        .collect();
    // The mesh is laid as wide as the hem, so a wider one starts gathered.
    let laid: Vec<Vec2> = flat
        .iter()
        .map(|place| Vec2::new(place.x * 0.16 / width, place.y))
        .collect();
    let mut below = hanging(&laid, -0.16);
    for (place, flat) in below.iter_mut().zip(&flat) {
        place.z = 0.002 * lole_geom::trig::sin(300.0 * flat.x);
    }
    Sewn::new(
        pieces,
        &[ClothJoint::Seam(seam)],
        &[hanging(&upper_flat, 0.0), below],
        12,
    )
}

#[test]
fn a_grid_and_a_mesh_of_another_spacing_hang_as_one_cloth() {
    let mut sewn = hem(12, 0.16);
    for _ in 0..120 {
        sewn.step();
    }
    let (upper, lower) = (sewn.positions(0), sewn.positions(1));
    // Particle 11 k / 8 of the mesh lies at particle k of the grid.
    for k in 0..9_usize {
        let (first, eighths) = (11 * k / 8, 11 * k % 8);
        let (first, share) = if first < 11 {
            (
                first,
                [0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875][eighths],
            )
        } else {
            (10, 1.0)
        };
        let point = lower[first].lerp(lower[first + 1], share);
        let gap = point.distance(upper[72 + k]);
        assert!(gap < 5e-4, "stitch {k}: {gap} m");
    }
    // 0.16 m and 0.16 m of cloth that hardly stretches.
    let lowest = lower
        .iter()
        .map(|place| place.y)
        .fold(f32::INFINITY, f32::min);
    assert!((lowest + 0.32).abs() < 0.006, "{lowest}");
}

#[test]
fn a_longer_line_is_gathered_evenly() {
    let mut sewn = hem(17, 0.32);
    for _ in 0..120 {
        sewn.step();
    }
    let (upper, lower) = (sewn.positions(0), sewn.positions(1));
    for k in 0..9 {
        let gap = lower[2 * k].distance(upper[72 + k]);
        assert!(gap < 2.0e-3, "stitch {k}: {gap} m");
    }
}

#[test]
fn a_grid_alone_moves_as_without_an_assembly() {
    let spec = grid_spec(20, 14, 0.02);
    let model = ClothModel::new(&spec).expect("a grid");
    let flat: Vec<Vec2> = (0..280_u16)
        .map(|k| Vec2::new((k % 20).into(), (k / 20).into()) * 0.02)
        .collect();
    let positions: Vec<Vec3> = flat
        .iter()
        .map(|flat| Vec3::new(flat.x, 0.0, flat.y))
        .collect();
    let piece = ClothPiece::Grid(Box::new(model.clone()), Box::default());
    let mut sewn = Sewn::new(vec![piece], &[], std::slice::from_ref(&positions), 12);
    let mut state = ClothState::new(&model, &positions);
    for _ in 0..20 {
        sewn.step();
        let input = StepInput {
            pin_targets: &positions[..20],
            capsules: &[],
            ..StepInput::default()
        };
        lole_cloth::step(&model, &SolverConfig::default(), &input, &mut state, DT)
            .expect("a target for every pin");
    }
    let PieceState::Grid(found) = &sewn.state.pieces[0] else {
        panic!("a grid")
    };
    assert_eq!(state_hash(found), state_hash(&state));
}

/// A free sheet in the void with a joint, and its momentum before and after half a second.
fn momentum_change(joint: impl FnOnce(&[ClothPiece]) -> ClothJoint) -> f64 {
    let (flat, triangles) = rectangle(10, 10, 0.02, 0.4);
    let spec = MeshSpec::new(flat.clone(), triangles, FABRIC);
    let void = SolverConfig {
        gravity: Vec3::ZERO,
        ..config()
    };
    let pieces = vec![mesh_piece(&spec, void)];
    let masses = MeshModel::new(&spec).expect("a surface").particle_masses();
    let positions = hanging(&flat, 0.0);
    let joint = joint(&pieces);
    let mut sewn = Sewn::new(pieces, &[joint], &[positions], 12);
    let mut dice = Dice::new(5);
    let velocities: Vec<Vec3> = (flat.iter())
        .map(|_| Vec3::X + 0.5 * Vec3::new(dice.throw(), dice.throw(), dice.throw()))
        .collect();
    let (ClothPiece::Mesh(model, _), PieceState::Mesh(state)) =
        (&sewn.assembly.pieces()[0], &mut sewn.state.pieces[0])
    else {
        panic!("a mesh")
    };
    state.set_velocities(model, &velocities);
    let momentum = |velocities: &[Vec3]| -> DVec3 {
        let terms = velocities.iter().zip(&masses);
        terms
            .map(|(velocity, &mass)| velocity.as_dvec3() * f64::from(mass))
            .sum()
    };
    let before = momentum(&velocities);
    for _ in 0..30 {
        sewn.step();
    }
    let mut after = Vec::new();
    let (ClothPiece::Mesh(model, _), PieceState::Mesh(state)) =
        (&sewn.assembly.pieces()[0], &sewn.state.pieces[0])
    else {
        panic!("a mesh")
    };
    state.copy_velocities(model, &mut after);
    (momentum(&after) - before).length() / before.length()
}

#[test]
fn joints_within_the_cloth_keep_its_momentum() {
    let edge = || line(0, 0..10);
    let changes = [
        (
            "seam",
            momentum_change(|pieces| {
                let seam = ClothSeam::along(pieces, &edge(), &line(0, 90..100));
                ClothJoint::Seam(seam.expect("a seam"))
            }),
        ),
        (
            "elastic",
            momentum_change(|_| {
                ClothJoint::Elastic(Elastic {
                    line: edge(),
                    ends: Ends::Apart,
                    rest_share: 0.5,
                    stretch_stiffness: 20.0,
                })
            }),
        ),
        (
            "drawstring",
            momentum_change(|_| {
                ClothJoint::Drawstring(Drawstring {
                    line: line(0, [0, 9, 99, 90]),
                    ends: Ends::Joined,
                    length: 0.5,
                })
            }),
        ),
        (
            "pleat",
            momentum_change(|_| {
                ClothJoint::Pleat(Pleat {
                    hinges: crease(10),
                    rest_angle: 1.5,
                    stiffness: 0.1,
                })
            }),
        ),
    ];
    for (joint, change) in changes {
        assert!(change < 2e-4, "{joint}: {change}");
    }
}

/// The hinges of the fifth row of a rectangle of ten columns with all diagonals one way: corners
/// straight above and below the first end and the second.
fn crease(columns: u32) -> Vec<[PieceParticle; 4]> {
    let row = 5 * columns;
    (row..row + columns - 1)
        .map(|a| {
            [a, a + 1, a + 1 + columns, a - columns]
                .map(|particle| PieceParticle { piece: 0, particle })
        })
        .collect()
}

#[test]
fn a_pleat_folds_the_cloth_to_its_angle() {
    let (flat, triangles) = rectangle(10, 11, 0.02, 0.0);
    let mut spec = MeshSpec::new(
        flat.clone(),
        triangles,
        Fabric {
            drag_rate: 5.0,
            ..FABRIC
        },
    );
    // So limp that the crease has its way.
    spec.fabric.bend = [1e-8; 2];
    spec.fabric.twist = 1e-8;
    let void = SolverConfig {
        gravity: Vec3::ZERO,
        ..config()
    };
    for rest_angle in [FRAC_PI_2, -0.7] {
        let pleat = Pleat {
            hinges: crease(10),
            rest_angle,
            stiffness: 0.05,
        };
        let pieces = vec![mesh_piece(&spec, void.clone())];
        let positions = hanging(&flat, 0.0);
        let mut sewn = Sewn::new(pieces, &[ClothJoint::Pleat(pleat)], &[positions], 12);
        for _ in 0..180 {
            sewn.step();
        }
        let now = sewn.positions(0);
        // Between the normals of the triangles on both sides of the crease.
        let angles = crease(10).into_iter().map(|hinge| {
            let [a, b, left, right] = hinge.map(|place| now[place.particle as usize]);
            let normals = [(b - a).cross(left - a), (right - a).cross(b - a)];
            normals[0].angle_between(normals[1])
        });
        let angle = angles.sum::<f32>() / 9.0;
        assert!(
            (angle - rest_angle.abs()).abs() < 0.05,
            "{rest_angle}: {angle}"
        );
    }
}

#[test]
fn an_elastic_carries_its_share_of_a_hanging_strip() {
    // Beside a cloth of stiffness Y w the band adds EA: ρ g L / 2 (Y + EA / w).
    let (flat, triangles) = rectangle(3, 16, 0.02, 0.0);
    let mut spec = MeshSpec::new(
        flat.clone(),
        triangles,
        Fabric {
            drag_rate: 4.0,
            ..FABRIC
        },
    );
    spec.fabric.stretch = [8.0; 2];
    spec.fabric.shear = 8.0;
    spec.pinned[..3].fill(true);
    let bands = (0..3_u16).map(|column| {
        // The border carries half a column of cloth, so it has half of the band.
        let share = if column == 1 { 0.5 } else { 0.25 };
        ClothJoint::Elastic(Elastic {
            line: line(0, (0..16_u16).map(|row| u32::from(3 * row + column))),
            ends: Ends::Apart,
            rest_share: 1.0,
            stretch_stiffness: 0.32 * share,
        })
    });
    let bands: Vec<ClothJoint> = bands.collect();
    let pieces = vec![mesh_piece(&spec, untethered())];
    let mut sewn = Sewn::new(pieces, &bands, &[hanging(&flat, 0.0)], 60);
    for _ in 0..240 {
        sewn.step();
    }
    let now = sewn.positions(0);
    let found = -(now[45].y + now[46].y + now[47].y) / 3.0 / 0.3 - 1.0;
    let expected = 0.15 * 9.81 * 0.3 / (2.0 * (8.0 + 0.32 / 0.04));
    assert!((found / expected - 1.0).abs() < 0.05, "{found} {expected}");
}

#[test]
fn a_drawstring_is_never_longer_than_it_is() {
    let (flat, triangles) = rectangle(12, 12, 0.02, 0.4);
    let spec = MeshSpec::new(flat.clone(), triangles, FABRIC);
    let mut spec = spec;
    spec.pinned[0] = true;
    let casing: Vec<u32> = (0..12).chain((1..12).map(|row| 12 * row + 11)).collect();
    let string = Drawstring {
        line: line(0, casing.iter().copied()),
        ends: Ends::Apart,
        length: 0.3,
    };
    let pieces = vec![mesh_piece(&spec, config())];
    let mut sewn = Sewn::new(
        pieces,
        &[ClothJoint::Drawstring(string)],
        &[hanging(&flat, 0.0)],
        12,
    );
    let mut longest: f32 = 0.0;
    for frame in 0..90 {
        sewn.step();
        let now = sewn.positions(0);
        let length: f32 = casing
            .windows(2)
            .map(|pair| now[pair[0] as usize].distance(now[pair[1] as usize]))
            .sum();
        // Half a second to draw 0.44 m of casing in.
        if 30 < frame {
            longest = longest.max(length);
        }
    }
    assert!(longest < 0.3 * 1.01, "{longest}");
}

#[test]
fn ties_to_a_bone_sag_by_their_stiffness_and_turn_with_it() {
    let (flat, triangles) = rectangle(4, 4, 0.02, 0.0);
    let spec = MeshSpec::new(
        flat.clone(),
        triangles,
        Fabric {
            drag_rate: 6.0,
            ..FABRIC
        },
    );
    let weight = 0.15 * 0.06 * 0.06 * 9.81;
    let positions = hanging(&flat, 0.0);
    let (sag, ties) = (0.004, positions.len() as f32);
    let attachment = Attachment {
        bone: 0,
        ties: line(0, 0..16)
            .into_iter()
            .zip(positions.iter().copied())
            .collect(),
        stiffness: weight / (ties * sag),
    };
    let pieces = vec![mesh_piece(&spec, untethered())];
    let joints = [ClothJoint::Attachment(attachment)];
    let mut sewn = Sewn::new(pieces, &joints, std::slice::from_ref(&positions), 12);
    sewn.frames = vec![BoneFrame::IDENTITY];
    let mean = |places: &[Vec3]| places.iter().sum::<Vec3>() / ties;
    for _ in 0..180 {
        sewn.step();
    }
    let sunk = mean(&positions).y - mean(&sewn.positions(0)).y;
    assert!((sunk / sag - 1.0).abs() < 0.02, "{sunk}");
    let turned = BoneFrame {
        rotation: Quat::from_xyzw(0.0, 1.0, 0.0, 0.0),
        translation: Vec3::new(0.1, 0.2, 0.3),
    };
    for frame in 0..180_u8 {
        let share = (f32::from(frame) / 60.0).min(1.0);
        sewn.frames = vec![BoneFrame {
            rotation: Quat::IDENTITY.slerp(turned.rotation, share),
            translation: turned.translation * share,
        }];
        sewn.step();
    }
    let expected = turned.world_from_bone(mean(&positions)) - sag * Vec3::Y;
    let found = mean(&sewn.positions(0));
    assert!(found.distance(expected) < 2e-4, "{found} {expected}");
}

#[test]
fn a_strand_hangs_like_the_elastica() {
    let (length, linear_density) = (0.2, 8e-4);
    let weight = linear_density * 9.81;
    let strand = Strip {
        length,
        width: 0.006,
        segment_count: 8,
        linear_density,
        stretch_stiffness: 4e3 * weight * length,
        bend_stiffness: weight * length * length * length / 8.0,
        twist_stiffness: weight * length * length * length / 8.0,
        friction: 0.3,
        drag_rate: 17.0,
    };
    // One segment more, clamped.
    let clamped = Strip {
        length: 0.225,
        segment_count: 9,
        ..strand
    };
    let mut spec = clamped.spec();
    spec.pinned[..4].fill(true);
    let positions: Vec<Vec3> = (spec.flat_positions.iter())
        .map(|flat| Vec3::new(flat.x - 0.025, 0.0, flat.y))
        .collect();
    let mut world = World::new(&spec, &positions).untethered().with_substeps(40);
    for _ in 0..240 {
        world.step(&[]);
    }
    let now = world.positions();
    let tip = 0.5 * (now[now.len() - 1] + now[now.len() - 2]);
    let error = -tip.y / tip.x / 0.88433 - 1.0;
    assert!(error.abs() < 0.08, "{error}");
}

#[test]
fn an_assembly_has_the_same_bits_with_all_vector_instructions() {
    let hashes = [
        InstructionSet::Detected,
        InstructionSet::Wide,
        InstructionSet::Baseline,
    ]
    .map(|set| {
        let mut sewn = hem(12, 0.16);
        let pieces = sewn.assembly.pieces().iter().cloned().map(|mut piece| {
            match &mut piece {
                ClothPiece::Grid(_, config) | ClothPiece::Mesh(_, config) => {
                    config.instruction_set = set;
                }
            }
            piece
        });
        let pieces: Vec<ClothPiece> = pieces.collect();
        let seam = ClothSeam::along(&pieces, &line(0, 72..81), &line(1, 0..12)).expect("a seam");
        sewn.assembly = Assembly::new(
            pieces,
            &[ClothJoint::Seam(seam)],
            NonZeroU32::MIN.saturating_add(7),
        )
        .expect("fits");
        for _ in 0..20 {
            sewn.step();
        }
        match (&sewn.state.pieces[0], &sewn.state.pieces[1]) {
            (PieceState::Grid(grid), PieceState::Mesh(mesh)) => {
                [state_hash(grid), mesh_state_hash(mesh)]
            }
            _ => panic!("a grid and a mesh"),
        }
    });
    assert_eq!(hashes[0], hashes[1]);
    assert_eq!(hashes[0], hashes[2]);
}

#[test]
fn a_step_that_loses_a_particle_is_not_taken() {
    let mut sewn = hem(12, 0.16);
    sewn.step();
    let before = [sewn.positions(0), sewn.positions(1)];
    sewn.pins[0][3] = Vec3::NAN;
    let input = AssemblyInput {
        pin_targets: &sewn.pins,
        ..AssemblyInput::default()
    };
    let lost = step(&sewn.assembly, &input, &mut sewn.state, DT).expect_err("it is lost");
    assert_eq!(
        lost.to_string(),
        "a particle of piece 0 went nowhere in substep 0; the step was not taken"
    );
    assert_eq!(before, [sewn.positions(0), sewn.positions(1)]);
}

#[test]
fn a_joint_that_does_not_fit_is_refused() {
    let (flat, triangles) = rectangle(4, 4, 0.02, 0.0);
    let pieces = vec![mesh_piece(
        &MeshSpec::new(flat, triangles, FABRIC),
        config(),
    )];
    let refused = |joint: ClothJoint| {
        let made = Assembly::new(pieces.clone(), &[joint], NonZeroU32::MIN);
        made.expect_err("it does not fit").to_string()
    };
    let elastic = |line: Vec<PieceParticle>, rest_share: f32| {
        ClothJoint::Elastic(Elastic {
            line,
            ends: Ends::Apart,
            rest_share,
            stretch_stiffness: 1.0,
        })
    };
    assert_eq!(
        refused(elastic(line(3, 0..2), 1.0)),
        "a joint names piece 3, and there are 1"
    );
    assert_eq!(
        refused(elastic(line(0, [0, 99]), 1.0)),
        "a joint names particle 99 of piece 0, which has 16"
    );
    assert_eq!(
        refused(elastic(line(0, [0]), 1.0)),
        "an elastic has 1 particles; it needs at least 2"
    );
    assert_eq!(
        refused(elastic(line(0, 0..4), f32::NAN)),
        "`elastic.rest_share` is NaN; it must be finite and above 0"
    );
    assert_eq!(
        refused(ClothJoint::Pleat(Pleat {
            hinges: Vec::new(),
            rest_angle: 7.0,
            stiffness: 1.0
        })),
        "`pleat.rest_angle` is 7; it must be between -π and π"
    );
}
