//! An assembly, and its step: all pieces substep by substep, with the joints in between.

use std::num::NonZeroU32;

use glam::Vec3;
use lole_geom::{Capsule, Surfel, fnv};

use crate::assembly::attachment::{BoneFrame, Bones};
use crate::assembly::contact;
use crate::assembly::joint::{ClothJoint, JointError, Made};
use crate::assembly::piece::{ClothPiece, PieceState};
use crate::assembly::whole::{Whole, WholeState};
use crate::collision::face_contact::{FaceContacts, Faces};
use crate::lanes::Points;
use crate::lost::{Lost, check_cloth, check_pins};
use crate::mesh::finite::all_finite;
use crate::mesh::step::MeshStep;
use crate::method::fineness::{Fineness, Substeps};
use crate::method::xpbd;
use crate::phase::Phase;
use crate::step::GridStep;
use crate::{StepInput, mesh, mesh_state_hash, state_hash};

/// Pieces and what joins them: what never changes from step to step.
#[derive(Debug, Clone, PartialEq)]
pub struct Assembly {
    pieces: Vec<ClothPiece>,
    joints: Vec<Made>,
    /// How the pieces meet each other.
    faces: Faces,
    whole: Whole,
    substeps: Substeps,
}

/// What moves of an assembly.
#[derive(Debug, Clone)]
pub struct AssemblyState {
    /// States of the pieces, in their order.
    pub pieces: Vec<PieceState>,
    /// Where the bones were left; empty before the first step.
    frames: Vec<BoneFrame>,
    /// By piece, positions and velocities before the step.
    kept: Vec<[Vec<Points>; 2]>,
    /// Room for contacts between pieces.
    pub(super) contacts: FaceContacts,
    pub(super) whole: WholeState,
    fineness: Fineness,
}

/// What the world does during one step; by default nothing is in it.
#[derive(Debug, Clone, Copy, Default)]
pub struct AssemblyInput<'a> {
    /// By piece, where its pinned particles are at the end of the step [m]; an empty list, or none, where all
    /// of them stay.
    pub pin_targets: &'a [Vec<Vec3>],
    /// Where the bones are at the end of the step; always the same ones in the same order.
    pub frames: &'a [BoneFrame],
    /// Where the capsules are at the end of the step; always the same ones in the same order.
    pub capsules: &'a [Capsule],
    /// Where the surfels of a skinned body are at the end of the step; always the same ones in the
    /// same order.
    pub surfels: &'a [Surfel],
    /// Velocity of the air [m/s].
    pub air_velocity: Vec3,
}

impl Assembly {
    /// Joins pieces, which take `substep_count` substeps in every step whatever their own settings
    /// say.
    ///
    /// # Errors
    /// A joint of pieces or particles that do not exist, or with a number that is out of range.
    pub fn new(
        pieces: Vec<ClothPiece>,
        joints: &[ClothJoint],
        substep_count: NonZeroU32,
    ) -> Result<Self, JointError> {
        let made = joints.iter().map(|joint| Made::new(&pieces, joint));
        let made = made.collect::<Result<_, _>>()?;
        let assembly = Self {
            joints: made,
            faces: contact::faces(&pieces, joints),
            whole: Whole::new(&pieces, joints),
            pieces,
            substeps: Substeps::exactly(substep_count),
        };
        // All of them take as many.
        Ok(assembly.with_substep_count(substep_count))
    }

    /// This assembly, taking up to so many substeps a step, for a while, where more than one part of the cloth in
    /// a hundred, an edge of a grid or a direction of a triangle's yarns, is strained by more than 6 %.
    #[must_use]
    pub fn with_strained_substep_count(mut self, count: NonZeroU32) -> Self {
        for piece in &mut self.pieces {
            piece.config_mut().strained_substep_count = count;
        }
        self.substeps = self.substeps.up_to(count);
        self
    }

    /// This assembly, taking so many substeps in every step.
    #[must_use]
    pub fn with_substep_count(mut self, count: NonZeroU32) -> Self {
        for piece in &mut self.pieces {
            let config = piece.config_mut();
            (config.substep_count, config.strained_substep_count) = (count, count);
        }
        self.substeps = Substeps::exactly(count);
        self
    }

    /// The pieces, in the order in which they were given.
    #[must_use]
    pub fn pieces(&self) -> &[ClothPiece] {
        &self.pieces
    }
}

impl AssemblyState {
    /// All bits of positions and velocities as one number: of a lone piece that piece's own, of several one
    /// that holds them all.
    #[must_use]
    pub fn hash(&self) -> u64 {
        let mut hashes = self.pieces.iter().map(|piece| match piece {
            PieceState::Grid(state) => state_hash(state),
            PieceState::Mesh(state) => mesh_state_hash(state),
        });
        let first = hashes.next().unwrap_or(fnv::BASIS);
        hashes.fold(first, |all, next| all.wrapping_mul(fnv::PRIME) ^ next)
    }

    /// Moves all pieces, and where pins, bones and body were left, by as much [m], and makes the pieces
    /// `faster` [m/s].
    pub fn carry(&mut self, by: Vec3, faster: Vec3) {
        for piece in &mut self.pieces {
            match piece {
                PieceState::Grid(state) => state.carry(by, faster),
                PieceState::Mesh(state) => state.carry(by, faster),
            }
        }
        for frame in &mut self.frames {
            frame.translation += by;
        }
    }

    /// Every piece at rest at its `positions` [m].
    ///
    /// # Panics
    /// When there are more or fewer lists than pieces, or one has another length than its piece has
    /// particles.
    #[must_use]
    pub fn new(assembly: &Assembly, positions: &[Vec<Vec3>]) -> Self {
        assert_eq!(positions.len(), assembly.pieces.len(), "one list a piece");
        let pairs = assembly.pieces.iter().zip(positions);
        Self {
            pieces: pairs
                .map(|(piece, positions)| PieceState::new(piece, positions))
                .collect(),
            frames: Vec::new(),
            kept: vec![[Vec::new(), Vec::new()]; positions.len()],
            contacts: FaceContacts::default(),
            whole: WholeState::default(),
            fineness: Fineness::default(),
        }
    }

    /// Substeps of the next step.
    #[must_use]
    pub fn substep_count(&self, assembly: &Assembly) -> u32 {
        self.fineness.substep_count(assembly.substeps)
    }

    /// Remembers where everything is.
    fn keep(&mut self) {
        for (kept, piece) in self.kept.iter_mut().zip(&self.pieces) {
            for (kept, column) in kept.iter_mut().zip(piece.columns()) {
                kept.clone_from(column);
            }
        }
    }

    /// Puts everything back.
    fn restore(&mut self) {
        for (kept, piece) in self.kept.iter().zip(&mut self.pieces) {
            for (kept, column) in kept.iter().zip(piece.columns_mut()) {
                column.clone_from(kept);
            }
        }
    }
}

/// Moves the assembly on by `dt` [s].
///
/// # Errors
/// A state of other pieces, pins of a piece that were not told where they go, and a particle that would be at
/// no place afterwards; the state is then as it was before.
pub fn step(
    assembly: &Assembly,
    input: &AssemblyInput<'_>,
    state: &mut AssemblyState,
    dt: f32,
) -> Result<(), Lost> {
    step_observed(assembly, (input, dt), state, &mut |_| {})
}

/// Moves the assembly on as [`step`] does, bit for bit, and calls `passed` whenever a [`Phase`] has ended: first
/// of all for what the caller did before. A phase ends several times in a step; of a grid all that its springs do
/// counts as one.
///
/// # Errors
/// As [`step`].
pub fn step_observed(
    assembly: &Assembly,
    (input, dt): (&AssemblyInput<'_>, f32),
    state: &mut AssemblyState,
    passed: &mut dyn FnMut(Phase),
) -> Result<(), Lost> {
    passed(Phase::Outside);
    check_cloth(0, [assembly.pieces.len(), state.pieces.len()])?;
    for (place, (piece, state)) in assembly.pieces.iter().zip(&state.pieces).enumerate() {
        let lengths = match (piece, state) {
            (ClothPiece::Grid(model, _), PieceState::Grid(state)) => {
                [model.layout.vector_count(), state.positions.len()]
            }
            (ClothPiece::Mesh(model, _), PieceState::Mesh(state)) => {
                [model.inv_masses.len(), state.positions.len()]
            }
            _ => return Err(Lost::OtherCloth { piece: place }),
        };
        check_cloth(place, lengths)?;
    }
    for (piece, targets) in assembly.pieces.iter().zip(input.pin_targets) {
        check_pins(piece.pin_indices().len(), targets)?;
    }
    if state.frames.len() != input.frames.len() {
        state.frames = input.frames.to_vec();
    }
    let step = AssemblyStep {
        assembly,
        input,
        dt,
    };
    state.keep();
    advance(step, state, None, passed);
    if !state.pieces.iter().all(is_finite) {
        // The same again, looking at every piece after every substep.
        state.restore();
        let mut lost = None;
        advance(step, state, Some(&mut lost), passed);
        state.restore();
        let piece = assembly.pieces.len();
        return Err(lost.unwrap_or(Lost::Piece { piece, substep: 0 }));
    }
    keep_surroundings(input, state);
    let pieces = assembly.pieces.iter().zip(&state.pieces);
    state.fineness.learn(assembly.substeps, |strained, points| {
        for (piece, state) in pieces {
            state.copy_positions(piece, points);
            match piece {
                ClothPiece::Grid(model, _) => strained.count_grid(model, points),
                ClothPiece::Mesh(model, _) => strained.count_mesh(model, points),
            }
        }
    });
    Ok(())
}

/// From here pins, bones, capsules and surfels move on in the next step.
fn keep_surroundings(input: &AssemblyInput<'_>, state: &mut AssemblyState) {
    let pins = state.pieces.iter_mut().zip(input.pin_targets);
    for (piece, targets) in pins {
        let (pin_targets, capsules, surfels) = match piece {
            PieceState::Grid(state) => {
                let state = &mut **state;
                (
                    &mut state.pin_targets,
                    &mut state.capsules,
                    &mut state.surfels,
                )
            }
            PieceState::Mesh(state) => {
                let state = &mut **state;
                (
                    &mut state.pin_targets,
                    &mut state.capsules,
                    &mut state.surfels,
                )
            }
        };
        pin_targets.clone_from(targets);
        capsules.clear();
        capsules.extend_from_slice(input.capsules);
        surfels.clear();
        surfels.extend_from_slice(input.surfels);
    }
    state.frames.clear();
    state.frames.extend_from_slice(input.frames);
}

fn is_finite(piece: &PieceState) -> bool {
    piece.columns().iter().all(|column| all_finite(column))
}

/// One step of an assembly.
#[derive(Clone, Copy)]
struct AssemblyStep<'a> {
    assembly: &'a Assembly,
    input: &'a AssemblyInput<'a>,
    /// Duration [s].
    dt: f32,
}

/// Moves all pieces on; where `lost` is given, it is told of the first piece that goes nowhere.
fn advance(
    step: AssemblyStep<'_>,
    state: &mut AssemblyState,
    mut lost: Option<&mut Option<Lost>>,
    passed: &mut dyn FnMut(Phase),
) {
    let AssemblyStep {
        assembly,
        input,
        dt,
    } = step;
    let none = Vec::new();
    let inputs: Vec<StepInput<'_>> = (0..assembly.pieces.len())
        .map(|piece| StepInput {
            pin_targets: input.pin_targets.get(piece).unwrap_or(&none),
            capsules: input.capsules,
            surfels: input.surfels,
            air_velocity: input.air_velocity,
        })
        .collect();
    let pieces = || assembly.pieces.iter().zip(&inputs);
    let count = state.fineness.substep_count(assembly.substeps);
    for piece in &mut state.pieces {
        piece.fineness_mut().follow(count);
    }
    let plans: Vec<Option<Plan<'_>>> = (pieces().zip(&mut state.pieces))
        .map(|((piece, input), state)| Plan::begin(piece, input, dt, state))
        .collect();
    passed(Phase::FindBody);
    assembly.whole.begin(&state.pieces, &mut state.whole);
    let contact_interval = contact::find(&assembly.pieces, &assembly.faces, state, dt);
    passed(Phase::FindSelf);
    #[expect(clippy::cast_precision_loss, reason = "substeps are few")]
    let h = dt / count as f32;
    for index in 0..count {
        let planned = plans.iter().zip(&mut state.pieces);
        for (plan, state) in planned.filter_map(|(plan, state)| Some((plan.as_ref()?, state))) {
            plan.predict_and_project(index, state, passed);
        }
        #[expect(clippy::cast_precision_loss, reason = "substeps are few")]
        let bones = Bones {
            before: &state.frames,
            after: input.frames,
            share: (index + 1) as f32 / count as f32,
        };
        for joint in &assembly.joints {
            joint.solve(&mut state.pieces, &bones, h);
        }
        passed(Phase::Joints);
        if contact_interval.is_some_and(|interval| index.is_multiple_of(interval)) {
            state.contacts.solve(&mut state.pieces[..], h);
        }
        (assembly.whole).keep_guards(&mut state.pieces, &state.whole, h);
        passed(Phase::SelfContact);
        let planned = plans.iter().zip(&mut state.pieces);
        for (plan, state) in planned.filter_map(|(plan, state)| Some((plan.as_ref()?, state))) {
            plan.finish(index, state);
        }
        passed(Phase::BodyContact);
        if let Some(lost) = lost.as_deref_mut().filter(|lost| lost.is_none())
            && let Some(piece) = state.pieces.iter().position(|piece| !is_finite(piece))
        {
            *lost = Some(Lost::Piece {
                piece,
                substep: index,
            });
        }
    }
    finish_pins(assembly, state);
    (assembly.whole).repair(&assembly.pieces, &inputs, state, dt);
    passed(Phase::Crossings);
}

/// Rounding has moved the pins a little off where they go.
fn finish_pins(assembly: &Assembly, state: &mut AssemblyState) {
    for (piece, state) in assembly.pieces.iter().zip(&mut state.pieces) {
        match (piece, state) {
            (ClothPiece::Grid(model, _), PieceState::Grid(state)) => {
                xpbd::finish_pins(model, state);
            }
            (ClothPiece::Mesh(model, _), PieceState::Mesh(state)) => {
                mesh::step::finish_pins(model, state);
            }
            _ => {}
        }
    }
}

/// What holds for all substeps of a piece.
enum Plan<'a> {
    Grid(GridStep<'a>, Box<xpbd::Plan>),
    Mesh(MeshStep<'a>, mesh::step::Substep),
}

impl<'a> Plan<'a> {
    /// What is done once, before the first substep; `None` where the state is another piece's.
    fn begin(
        piece: &'a ClothPiece,
        input: &'a StepInput<'a>,
        dt: f32,
        state: &mut PieceState,
    ) -> Option<Self> {
        match (piece, state) {
            (ClothPiece::Grid(model, config), PieceState::Grid(state)) => {
                let step = GridStep {
                    model,
                    config,
                    input,
                    dt,
                };
                Some(Self::Grid(step, Box::new(xpbd::begin(step, state))))
            }
            (ClothPiece::Mesh(model, config), PieceState::Mesh(state)) => {
                let step = MeshStep {
                    model,
                    config,
                    input,
                    dt,
                };
                Some(Self::Mesh(step, mesh::step::begin(step, state)))
            }
            _ => None,
        }
    }

    fn predict_and_project(
        &self,
        index: u32,
        state: &mut PieceState,
        passed: &mut dyn FnMut(Phase),
    ) {
        match (self, state) {
            (&Self::Grid(step, ref plan), PieceState::Grid(state)) => {
                xpbd::SubstepNow { step, plan, index }.predict_and_project(state);
                passed(Phase::Springs);
            }
            (&Self::Mesh(step, ref substep), PieceState::Mesh(state)) => {
                mesh::step::SubstepNow {
                    step,
                    substep,
                    index,
                }
                .predict_and_project(state, &mut None, passed);
            }
            _ => {}
        }
    }

    fn finish(&self, index: u32, state: &mut PieceState) {
        match (self, state) {
            (&Self::Grid(step, ref plan), PieceState::Grid(state)) => {
                xpbd::SubstepNow { step, plan, index }.collide_and_finish(state);
            }
            (&Self::Mesh(step, ref substep), PieceState::Mesh(state)) => {
                let now = mesh::step::SubstepNow {
                    step,
                    substep,
                    index,
                };
                mesh::contact::finish(now, state);
            }
            _ => {}
        }
    }
}
