//! The law of substeps: more of them never make a sewn garment worse.

mod mesh_support;

use std::num::NonZeroU32;

use glam::Vec3;
use lole_cloth::assembly::{
    Assembly, AssemblyInput, AssemblyState, ClothJoint, ClothPiece, ClothSeam, PieceParticle,
    PieceState, step,
};
use lole_cloth::mesh::{MeshModel, MeshSpec, diagnose};
use lole_cloth::{Crossings, Fabric, SelfCollision, SolverConfig};
use lole_geom::{Capsule, trig};
use mesh_support::{DT, FABRIC, rectangle};

const COLUMNS: u32 = 23;
const ROWS: u32 = 28;
const SPACING: f32 = 0.02;
/// Height of the neckline before it comes to rest [m].
const TOP: f32 = 1.42;

/// A front and a back, sewn down both sides and on the shoulders, around a body that sways, turns about and
/// drops: the worst strain (p99) of a frame.
fn strained(substeps: u32, fabric: Fabric) -> f32 {
    let (flat, triangles) = rectangle(COLUMNS, ROWS, SPACING, 0.3);
    let spec = MeshSpec::new(flat.clone(), triangles, fabric);
    let config = SolverConfig {
        structural_sweep_count: NonZeroU32::MIN,
        contact_offset: 0.004,
        column_strides: Vec::new(),
        tether_scale: None,
        self_collision: Some(SelfCollision {
            radius: 0.003,
            substep_interval: NonZeroU32::MIN.saturating_add(2),
            crossings: Crossings::Repair,
        }),
        ..SolverConfig::default()
    };
    let piece = || {
        let model = MeshModel::new(&spec).expect("a surface");
        ClothPiece::Mesh(Box::new(model), Box::new(config.clone()))
    };
    let (last, shoulder) = (COLUMNS - 1, COLUMNS / 3);
    let sides = (0..ROWS).flat_map(|row| [row * COLUMNS, row * COLUMNS + last]);
    let shoulders = (1..=shoulder).flat_map(|column| [column, last - column]);
    let sewn = |particle: u32| [0, 1].map(|piece| PieceParticle { piece, particle }.into());
    let seam = ClothSeam {
        stitches: sides.chain(shoulders).map(sewn).collect(),
    };
    // Half around each, so that the sides meet.
    let width = last as f32 * SPACING;
    let radius = width / std::f32::consts::PI;
    let around = |front: f32| {
        let place = |flat: &glam::Vec2| {
            let (sin, cos) = trig::sin_cos((flat.x - 0.5 * width) / radius);
            // The shoulders nearly meet.
            let share = (flat.y / 0.12).clamp(0.08, 1.0);
            Vec3::new(radius * sin, TOP - flat.y, front * share * radius * cos)
        };
        flat.iter().map(place).collect::<Vec<_>>()
    };
    let count = NonZeroU32::new(substeps).expect("a count");
    let assembly = Assembly::new(vec![piece(), piece()], &[ClothJoint::Seam(seam)], count)
        .expect("joints fit");
    let mut state = AssemblyState::new(&assembly, &[around(1.0), around(-1.0)]);
    let mut worst = 0.0_f32;
    for frame in 0..170_u16 {
        let danced = f32::from(frame.saturating_sub(80)) * DT;
        let sway = 0.08 * trig::sin(9.0 * danced);
        let drop = 0.06 * (trig::cos(7.0 * danced) - 1.0);
        let at = Vec3::new(sway, drop, 0.5 * sway);
        let lean = Vec3::X * (0.05 * trig::sin(5.0 * danced));
        let body = [
            Capsule::uniform(Vec3::Y * 0.7 + at - lean, Vec3::Y * 1.24 + at + lean, 0.1),
            Capsule::uniform(
                Vec3::new(-0.13, 1.25, 0.0) + at,
                Vec3::new(0.13, 1.25, 0.0) + at,
                0.05,
            ),
        ];
        let input = AssemblyInput {
            capsules: &body,
            pin_targets: &[Vec::new(), Vec::new()],
            ..AssemblyInput::default()
        };
        step(&assembly, &input, &mut state, DT).expect("nothing is lost");
        for (piece, state) in assembly.pieces().iter().zip(&state.pieces) {
            if let (ClothPiece::Mesh(model, _), PieceState::Mesh(state)) = (piece, state) {
                let mut positions = Vec::new();
                state.copy_positions(model, &mut positions);
                if 80 < frame {
                    worst = worst.max(diagnose::strain(model, &positions).p99);
                }
            }
        }
    }
    worst
}

#[test]
fn more_substeps_never_strain_a_sewn_garment_more() {
    let limp = Fabric {
        bend: [9.0e-6, 6.0e-6],
        twist: 4.0e-6,
        drag_rate: 1.0,
        ..FABRIC
    };
    let stiff = Fabric {
        stretch: [20_000.0; 2],
        shear: 800.0,
        areal_density: 0.25,
        ..limp
    };
    for (name, fabric) in [("limp", limp), ("stiff", stiff)] {
        let counts = [12, 24, 48, 96];
        let strains = counts.map(|count| strained(count, fabric));
        for (pair, counts) in strains.windows(2).zip(counts.windows(2)) {
            assert!(
                pair[1] <= 1.05 * pair[0] + 0.002,
                "{name}: {} with {}, {} with {} substeps",
                pair[0],
                counts[0],
                pair[1],
                counts[1]
            );
        }
    }
}
