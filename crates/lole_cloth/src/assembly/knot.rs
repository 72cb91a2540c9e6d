//! Particles of an assembly, and points on the edges between them.

use glam::Vec3;

use crate::assembly::joint::JointError;
use crate::assembly::piece::{ClothPiece, PieceState};

/// A particle of one of the pieces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PieceParticle {
    /// Position in the list of pieces.
    pub piece: usize,
    /// Number of the particle in that piece.
    pub particle: u32,
}

/// How a line of particles ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ends {
    /// With its first and its last particle.
    Apart,
    /// Nowhere: the last particle is followed by the first.
    Joined,
}

/// Neighbors along a line, in order.
pub(crate) fn neighbors(line: &[PieceParticle], ends: Ends) -> Vec<[PieceParticle; 2]> {
    let mut pairs: Vec<[PieceParticle; 2]> =
        line.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    if let (Ends::Joined, [first, .., last]) = (ends, line) {
        pairs.push([*last, *first]);
    }
    pairs
}

/// A point on the straight line between two particles of one piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgePoint {
    /// Position in the list of pieces.
    pub piece: usize,
    /// Both ends; the same one twice for a particle itself.
    pub particles: [u32; 2],
    /// Share of the way from the first to the second, 0 to 1.
    pub share: f32,
}

impl EdgePoint {
    /// The end that it is nearer to.
    pub(crate) const fn nearest(&self) -> u32 {
        self.particles[if self.share < 0.5 { 0 } else { 1 }]
    }
}

impl From<PieceParticle> for EdgePoint {
    fn from(place: PieceParticle) -> Self {
        Self {
            piece: place.piece,
            particles: [place.particle; 2],
            share: 0.0,
        }
    }
}

/// A particle as joints see it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Knot {
    piece: usize,
    slot: usize,
    /// [1/kg]; 0 for what is pinned.
    pub(crate) inv_mass: f32,
}

impl Knot {
    pub(crate) fn new(pieces: &[ClothPiece], place: PieceParticle) -> Result<Self, JointError> {
        let piece = pieces.get(place.piece).ok_or(JointError::NoSuchPiece {
            piece: place.piece,
            piece_count: pieces.len(),
        })?;
        if piece.particle_count() <= place.particle as usize {
            return Err(JointError::NoSuchParticle {
                piece: place.piece,
                particle: place.particle,
                particle_count: piece.particle_count(),
            });
        }
        let (slot, inv_mass) = piece.slot(place.particle);
        Ok(Self {
            piece: place.piece,
            slot,
            inv_mass,
        })
    }

    /// The knots of a line.
    pub(crate) fn line(
        pieces: &[ClothPiece],
        places: &[PieceParticle],
    ) -> Result<Vec<Self>, JointError> {
        places
            .iter()
            .map(|&place| Self::new(pieces, place))
            .collect()
    }

    pub(crate) fn place(&self, states: &[PieceState]) -> Vec3 {
        states[self.piece].place(self.slot)
    }

    /// Moves it by its inverse mass times `impulse` [kg·m].
    pub(crate) fn push(&self, states: &mut [PieceState], impulse: Vec3) {
        if 0.0 < self.inv_mass {
            states[self.piece].shift(self.slot, impulse * self.inv_mass);
        }
    }
}
