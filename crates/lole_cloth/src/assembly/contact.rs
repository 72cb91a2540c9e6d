//! Contact of the pieces of an assembly with each other, and of those of triangles with themselves;
//! grids meet themselves by their own law.

use glam::Vec3;

use crate::assembly::joint::ClothJoint;
use crate::assembly::piece::{ClothPiece, PieceState};
use crate::assembly::step::AssemblyState;
use crate::collision::face_contact::{FacePiece, Faces, Meeting, Moving};
use crate::lanes::LANES;
use crate::mesh::self_contact::{began, meeting, shift};
use crate::{ClothModel, SolverConfig};

/// What contact must know of all pieces.
pub(crate) fn faces(pieces: &[ClothPiece], joints: &[ClothJoint]) -> Faces {
    let mut is_sewn: Vec<Vec<bool>> = (pieces.iter())
        .map(|piece| vec![false; piece.particle_count()])
        .collect();
    for joint in joints {
        if let ClothJoint::Seam(seam) = joint {
            for point in seam.stitches.iter().flatten() {
                for particle in point.particles {
                    is_sewn[point.piece][particle as usize] = true;
                }
            }
        }
    }
    let pieces = pieces.iter().zip(is_sewn);
    let pieces = pieces.map(|(piece, is_sewn)| match piece {
        ClothPiece::Grid(model, _) => grid_piece(model, is_sewn),
        ClothPiece::Mesh(model, _) => model.face_piece(is_sewn),
    });
    Faces::new(&pieces.collect::<Vec<_>>())
}

fn grid_piece(model: &ClothModel, is_sewn: Vec<bool>) -> FacePiece<'_> {
    let grid = &model.spec().grid;
    let mut pins = Vec::new();
    for (row, &pinned) in (0_u32..).zip(&model.pinned_rows.nearest) {
        #[expect(clippy::cast_precision_loss, reason = "rows are fewer than 2^24")]
        let length = row.abs_diff(pinned) as f32 * grid.spacing[1];
        let first = pinned * grid.column_count;
        pins.extend((first..first + grid.column_count).map(|pin| (pin, length)));
    }
    FacePiece {
        triangles: grid.triangles(),
        flat_distance: Box::new(|ends| {
            let [first, second] = ends.map(|end| end as usize);
            crate::constraint::tether::flat_distance(grid, first, second)
        }),
        flat_positions: None,
        placement: &model.layout,
        inv_masses: &model.inv_masses,
        pins,
        is_sewn,
        particle_count: grid.particle_count(),
    }
}

/// Finds where the pieces may touch in a step; every how many substeps that is solved, if at all.
pub(crate) fn find(
    pieces: &[ClothPiece],
    faces: &Faces,
    state: &mut AssemblyState,
    dt: f32,
) -> Option<u32> {
    let AssemblyState {
        pieces: states,
        contacts,
        ..
    } = state;
    contacts.clear();
    let meetings: Vec<Meeting> = pieces.iter().map(meeting_of).collect();
    let intervals = pieces.iter().filter_map(|piece| {
        let contact = config_of(piece).self_collision?;
        Some(contact.substep_interval.get())
    });
    let interval = intervals.min()?;
    contacts.positions.clear();
    contacts.velocities.clear();
    contacts.is_tangled.clear();
    let mut one = Vec::new();
    for (piece, state) in pieces.iter().zip(&*states) {
        state.copy_positions(piece, &mut one);
        contacts.positions.extend_from_slice(&one);
        // A piece alone closes in on nothing: its folds move together.
        if 1 < pieces.len() {
            state.copy_velocities(piece, &mut one);
            contacts.velocities.extend_from_slice(&one);
        }
        let is_tangled = match state {
            PieceState::Grid(state) => &state.scratch.crossing_repair.is_tangled,
            PieceState::Mesh(state) => &state.scratch.crossing_repair.is_tangled,
        };
        contacts.is_tangled.extend_from_slice(is_tangled);
        contacts.is_tangled.resize(contacts.positions.len(), false);
    }
    let level = pieces
        .first()
        .map(|piece| config_of(piece).instruction_set)?
        .level();
    contacts.find(level, faces, &meetings, dt);
    Some(interval)
}

fn config_of(piece: &ClothPiece) -> &SolverConfig {
    match piece {
        ClothPiece::Grid(_, config) | ClothPiece::Mesh(_, config) => config,
    }
}

fn meeting_of(piece: &ClothPiece) -> Meeting {
    match piece {
        ClothPiece::Grid(model, config) => Meeting {
            radius: config.self_collision.map(|contact| contact.radius),
            friction: model.spec().fabric.cloth_friction,
        },
        ClothPiece::Mesh(model, config) => meeting(model, config),
    }
}

impl Moving for [PieceState] {
    fn place(&self, piece: usize, slot: usize) -> Vec3 {
        self[piece].place(slot)
    }

    fn start(&self, piece: usize, slot: usize, h: f32) -> Vec3 {
        match &self[piece] {
            PieceState::Grid(state) => {
                began(&state.scratch.predicted, &state.velocities, (slot, h))
            }
            PieceState::Mesh(state) => state.start(0, slot, h),
        }
    }

    fn put(&mut self, piece: usize, slot: usize, position: Vec3, quiet: Vec3) {
        match &mut self[piece] {
            PieceState::Grid(state) => {
                state.positions[slot / LANES].set(slot % LANES, position);
                shift(&mut state.scratch.predicted, slot, quiet);
            }
            PieceState::Mesh(state) => state.put(0, slot, position, quiet),
        }
    }
}
