//! Two squares of triangles are sewn along an edge and hang from the upper one: `cargo run --release --example
//! two_pieces -p lole_cloth`.

#![allow(clippy::print_stdout, reason = "an example says what it found")]

use std::error::Error;
use std::num::NonZeroU32;

use glam::{Vec2, Vec3};
use lole_cloth::assembly::{
    Assembly, AssemblyInput, AssemblyState, ClothJoint, ClothPiece, ClothSeam, PieceParticle, step,
};
use lole_cloth::mesh::{MeshModel, MeshSpec};
use lole_cloth::{Fabric, SolverConfig};

/// Vertices a side, and how far apart they lie [m].
const SIDE: u32 = 16;
const SPACING: f32 = 0.015;

fn main() -> Result<(), Box<dyn Error>> {
    let pieces = [true, false].map(|is_upper| -> Result<ClothPiece, Box<dyn Error>> {
        let mut spec = MeshSpec::new(flat(), triangles(), Fabric::COTTON);
        if is_upper {
            spec.pinned[..SIDE as usize].fill(true);
        }
        let config = SolverConfig::default();
        Ok(ClothPiece::Mesh(
            Box::new(MeshModel::new(&spec)?),
            Box::new(config),
        ))
    });
    let pieces: Vec<ClothPiece> = pieces.into_iter().collect::<Result<_, _>>()?;
    let edge = |piece: usize, first: u32| -> Vec<PieceParticle> {
        let particles = (0..SIDE).map(|along| first + along);
        particles
            .map(|particle| PieceParticle { piece, particle })
            .collect()
    };
    // The last row of the upper one to the first row of the lower one, which lies 5 cm below it.
    let seam = ClothSeam::along(&pieces, &edge(0, SIDE * (SIDE - 1)), &edge(1, 0))?;
    let substeps = NonZeroU32::MIN.saturating_add(11);
    let assembly = Assembly::new(pieces, &[ClothJoint::Seam(seam)], substeps)?;
    let height = SPACING * (SIDE - 1) as f32;
    let hung = |down: f32| -> Vec<Vec3> {
        let places = flat().into_iter();
        places
            .map(|at| Vec3::new(at.x, -at.y - down, 0.0))
            .collect()
    };
    let mut state = AssemblyState::new(&assembly, &[hung(0.0), hung(height + 0.05)]);
    for frame in 1..=120 {
        step(&assembly, &AssemblyInput::default(), &mut state, 1.0 / 60.0)?;
        if frame % 30 == 0 {
            let [upper, lower] = [0, 1].map(|piece| {
                let mut places = Vec::new();
                state.pieces[piece].copy_positions(&assembly.pieces()[piece], &mut places);
                places
            });
            let last = (SIDE * (SIDE - 1)) as usize;
            let gaps = upper[last..]
                .iter()
                .zip(&lower)
                .map(|(a, b)| a.distance(*b));
            let widest = gaps.fold(0.0, f32::max);
            println!(
                "{:.1} s: the seam is open by {:.2} mm",
                f64::from(frame) / 60.0,
                1000.0 * widest
            );
        }
    }
    Ok(())
}

fn flat() -> Vec<Vec2> {
    let rows = (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| [column, row]));
    rows.map(|at| Vec2::from(at.map(|it| it as f32)) * SPACING)
        .collect()
}

fn triangles() -> Vec<[u32; 3]> {
    let cells = (0..SIDE - 1).flat_map(|row| (0..SIDE - 1).map(move |column| row * SIDE + column));
    cells
        .flat_map(|a| [[a, a + 1, a + SIDE], [a + 1, a + SIDE + 1, a + SIDE]])
        .collect()
}
