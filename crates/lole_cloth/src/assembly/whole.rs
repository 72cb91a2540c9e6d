//! All pieces of an assembly as one surface: what comes to cross is repaired whether both sides belong to
//! one piece or to two.

use std::ops::Range;

use glam::Vec3;

use crate::assembly::joint::ClothJoint;
use crate::assembly::knot::EdgePoint;
use crate::assembly::piece::{ClothPiece, PieceState};
use crate::assembly::step::AssemblyState;
use crate::collision::face_contact::Moving;
use crate::collision::outside::{Body, Outside};
use crate::collision::placement::Placement;
use crate::collision::repair::{CrossingRepair, Fixed};
use crate::collision::surface::Surface;
use crate::lanes::{LANES, Points, Scalars, narrow};
use crate::{Crossings, SelfCollision, StepInput};

/// Passes in which seams are closed: at a corner more than two particles are sewn to each other.
const CLOSING_PASSES: u32 = 4;

/// The pieces, one after the other: what never changes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Whole {
    surface: Surface,
    placement: WholePlacement,
    inv_masses: Vec<Scalars>,
    /// Particles that are sewn to each other, one to one.
    seams: Vec<[u32; 2]>,
    /// By piece, its vectors and its particles.
    vectors: Vec<Range<usize>>,
    particles: Vec<Range<usize>>,
    /// Whether crossings are repaired, which they are where any piece asks for it.
    repairs: bool,
    /// Coulomb friction of what is guarded: the least of all pieces.
    friction: f32,
}

/// Particles of all pieces, in their vectors one after the other.
#[derive(Debug, Clone, PartialEq, Default)]
struct WholePlacement {
    /// By particle.
    slots: Vec<u32>,
    vector_count: usize,
}

/// What moves of it.
#[derive(Debug, Clone, Default)]
pub(crate) struct WholeState {
    repair: CrossingRepair,
    starts: Vec<Vec3>,
    positions: Vec<Points>,
    velocities: Vec<Points>,
}

impl Whole {
    pub(crate) fn new(pieces: &[ClothPiece], joints: &[ClothJoint]) -> Self {
        let mut whole = Self {
            surface: Surface::default(),
            placement: WholePlacement::default(),
            inv_masses: Vec::new(),
            seams: Vec::new(),
            vectors: Vec::new(),
            particles: Vec::new(),
            repairs: false,
            friction: f32::INFINITY,
        };
        for piece in pieces {
            whole.add(piece);
        }
        let surfaces = pieces.iter().map(surface_of);
        whole.surface = Surface::join(&surfaces.collect::<Vec<_>>());
        let particles = &whole.particles;
        let place = |point: &EdgePoint| narrow(particles[point.piece].start) + point.nearest();
        let is_one_to_one = |pair: &&[EdgePoint; 2]| pair.iter().all(|it| it.share <= 0.0);
        let seams = stitches(joints).filter(is_one_to_one);
        whole.seams = seams.map(|pair| pair.each_ref().map(place)).collect();
        whole
            .surface
            .sew(stitches(joints).map(|pair| pair.each_ref().map(place)));
        whole
    }

    fn add(&mut self, piece: &ClothPiece) {
        let (first, first_vector) = (self.placement.slots.len(), self.inv_masses.len());
        let count = piece.particle_count();
        let slots = (0..narrow(count)).map(|particle| {
            let (slot, _) = piece.slot(particle);
            narrow(first_vector * LANES + slot)
        });
        self.placement.slots.extend(slots);
        let (inv_masses, fabric, config) = match piece {
            ClothPiece::Grid(model, config) => (&model.inv_masses, &model.spec().fabric, config),
            ClothPiece::Mesh(model, config) => (&model.inv_masses, &model.spec().fabric, config),
        };
        self.inv_masses.extend_from_slice(inv_masses);
        self.vectors.push(first_vector..self.inv_masses.len());
        self.particles.push(first..first + count);
        self.placement.vector_count = self.inv_masses.len();
        let repairs = |contact: SelfCollision| contact.crossings == Crossings::Repair;
        self.repairs |= config.self_collision.is_some_and(repairs);
        self.friction = self.friction.min(fabric.cloth_friction);
    }

    /// Remembers where all pieces are at the start of a step.
    pub(crate) fn begin(&self, pieces: &[PieceState], state: &mut WholeState) {
        if !self.repairs {
            return;
        }
        let is_new = pieces.iter().any(|piece| !repair_of(piece).is_part);
        if is_new {
            // Somebody has put one where it is.
            state.repair.forget();
        }
        self.gather(pieces, state);
        self.placement
            .gather_points(&state.positions, &mut state.starts);
        let guards = &mut state.repair.guards;
        guards.prepare(&state.starts, &self.placement, &self.inv_masses);
    }

    fn gather(&self, pieces: &[PieceState], state: &mut WholeState) {
        state.positions.clear();
        state.velocities.clear();
        for piece in pieces {
            let [positions, velocities] = piece.columns();
            state.positions.extend_from_slice(positions);
            state.velocities.extend_from_slice(velocities);
        }
    }

    /// Brings what is sewn together to one place: contact comes after thread in a substep, and opens seams on
    /// which folds press, but what is looked at for crossings is what is seen, with its seams closed.
    fn close_seams(&self, positions: &mut [Points]) {
        for _ in 0..CLOSING_PASSES {
            for pair in &self.seams {
                let slots = pair.map(|it| self.placement.slot(it as usize));
                let [a, b] = slots.map(|(vector, lane)| positions[vector].get(lane));
                let weights = slots.map(|(vector, lane)| self.inv_masses[vector].0[lane]);
                let sum = weights[0] + weights[1];
                if 0.0 < sum {
                    let gap = b - a;
                    positions[slots[0].0].set(slots[0].1, a + gap * (weights[0] / sum));
                    positions[slots[1].0].set(slots[1].1, b - gap * (weights[1] / sum));
                }
            }
        }
    }

    /// Keeps what was parted in earlier steps apart in a substep of `h` [s].
    pub(crate) fn keep_guards(&self, pieces: &mut [PieceState], state: &WholeState, h: f32) {
        let mut moving = Slots {
            vectors: &self.vectors,
            pieces,
        };
        state.repair.guards.solve(&mut moving, self.friction, h);
    }

    /// Takes back what came to cross in a step of `dt` [s], at whose end the world is as in `inputs`.
    pub(crate) fn repair(
        &self,
        pieces: &[ClothPiece],
        inputs: &[StepInput<'_>],
        state: &mut AssemblyState,
        dt: f32,
    ) {
        let AssemblyState {
            pieces: states,
            whole: state,
            ..
        } = state;
        if !self.repairs {
            return;
        }
        self.gather(states, state);
        self.close_seams(&mut state.positions);
        let all = pieces.iter().zip(inputs).zip(&*states);
        let bodies = all.map(|((piece, input), state)| body_of(piece, input, state));
        let body = Bodies {
            vectors: &self.vectors,
            bodies: bodies.collect(),
        };
        let Some(ClothPiece::Grid(_, config) | ClothPiece::Mesh(_, config)) = pieces.first() else {
            return;
        };
        let fixed = Fixed {
            level: config.instruction_set.level(),
            surface: &self.surface,
            layout: &self.placement,
            inv_masses: &self.inv_masses,
            body: &body,
            dt,
        };
        let columns = (&mut state.positions[..], &mut state.velocities[..]);
        state
            .repair
            .repair(fixed, &state.starts, columns.0, columns.1);
        let parts = self.vectors.iter().zip(&self.particles);
        for (piece, (vectors, particles)) in states.iter_mut().zip(parts) {
            let [positions, velocities] = piece.columns_mut();
            positions.copy_from_slice(&state.positions[vectors.clone()]);
            velocities.copy_from_slice(&state.velocities[vectors.clone()]);
            let own = match piece {
                PieceState::Grid(state) => &mut state.scratch.crossing_repair,
                PieceState::Mesh(state) => &mut state.scratch.crossing_repair,
            };
            own.become_part(&state.repair, (vectors.clone(), particles.clone()));
        }
    }
}

/// What two points are sewn to each other.
fn stitches(joints: &[ClothJoint]) -> impl Iterator<Item = &[EdgePoint; 2]> {
    let seams = joints.iter().filter_map(|joint| match joint {
        ClothJoint::Seam(seam) => Some(&seam.stitches),
        _ => None,
    });
    seams.flatten()
}

const fn surface_of(piece: &ClothPiece) -> &Surface {
    match piece {
        ClothPiece::Grid(model, _) => &model.surface,
        ClothPiece::Mesh(model, _) => &model.surface,
    }
}

const fn repair_of(piece: &PieceState) -> &CrossingRepair {
    match piece {
        PieceState::Grid(state) => &state.scratch.crossing_repair,
        PieceState::Mesh(state) => &state.scratch.crossing_repair,
    }
}

/// # Panics
/// When `state` is another piece's, which the step has refused before.
fn body_of<'a>(piece: &'a ClothPiece, input: &StepInput<'a>, state: &'a PieceState) -> Body<'a> {
    let (layout, config): (&dyn Placement, _) = match piece {
        ClothPiece::Grid(model, config) => (&model.layout, config),
        ClothPiece::Mesh(model, config) => (&model.slots, config),
    };
    let (skin, held) = match state {
        PieceState::Grid(state) => (&state.scratch.surfel_contacts, &state.scratch.held_depths),
        PieceState::Mesh(state) => (&state.scratch.surfel_contacts, &state.scratch.held),
    };
    Body {
        layout,
        capsules: input.capsules,
        contact_offset: config.contact_offset,
        skin,
        held,
    }
}

/// The piece of a vector, and the vector there.
fn piece_of(vectors: &[Range<usize>], vector: usize) -> (usize, usize) {
    let piece = vectors.partition_point(|own| own.end <= vector);
    (piece, vector - vectors[piece].start)
}

/// What each piece has around it.
struct Bodies<'a> {
    vectors: &'a [Range<usize>],
    bodies: Vec<Body<'a>>,
}

impl Outside for Bodies<'_> {
    fn outside(&self, (vector, lane): (usize, usize), position: Vec3) -> Vec3 {
        let (piece, vector) = piece_of(self.vectors, vector);
        self.bodies[piece].outside((vector, lane), position)
    }
}

/// Slots of all pieces as if they were one.
struct Slots<'a> {
    vectors: &'a [Range<usize>],
    pieces: &'a mut [PieceState],
}

impl Slots<'_> {
    fn of(&self, slot: usize) -> (usize, usize) {
        let (piece, vector) = piece_of(self.vectors, slot / LANES);
        (piece, vector * LANES + slot % LANES)
    }
}

impl Moving for Slots<'_> {
    fn place(&self, _piece: usize, slot: usize) -> Vec3 {
        let (piece, slot) = self.of(slot);
        Moving::place(&*self.pieces, piece, slot)
    }

    fn start(&self, _piece: usize, slot: usize, h: f32) -> Vec3 {
        let (piece, slot) = self.of(slot);
        self.pieces.start(piece, slot, h)
    }

    fn put(&mut self, _piece: usize, slot: usize, position: Vec3, quiet: Vec3) {
        let (piece, slot) = self.of(slot);
        self.pieces.put(piece, slot, position, quiet);
    }
}

impl Placement for WholePlacement {
    fn slot(&self, particle: usize) -> (usize, usize) {
        let slot = self.slots[particle] as usize;
        (slot / LANES, slot % LANES)
    }

    fn row_count(&self) -> usize {
        self.vector_count
    }

    fn row_of(&self, vector: usize) -> usize {
        vector
    }

    fn add_row_slots(&self, row: usize, slots: &mut Vec<(usize, usize)>) {
        let own = self.slots.iter().map(|&slot| slot as usize);
        let own = own.filter(|slot| slot / LANES == row);
        slots.extend(own.map(|slot| (row, slot % LANES)));
    }

    fn gather_points(&self, vectors: &[Points], points: &mut Vec<Vec3>) {
        points.clear();
        let at = |&slot: &u32| vectors[slot as usize / LANES].get(slot as usize % LANES);
        points.extend(self.slots.iter().map(at));
    }
}
