//! Elastic: a band sewn into a line, shorter than the cloth it is sewn to.
//!
//! Each stretch of the line between two particles is a spring of the band, with its share of the
//! band's length. Tension `EA (l / r - 1)` by length `l` over rest length `r`, and none when slack:
//! a band is not pushed. Compliance `r / EA`.

use crate::assembly::joint::{JointError, positive};
use crate::assembly::knot::{Ends, Knot, PieceParticle, neighbors};
use crate::assembly::piece::{ClothPiece, PieceState};

/// Below this length [m] a stretch has no direction.
const DEGENERATE_LENGTH: f32 = 1.0e-7;

/// A band along a line of particles.
#[derive(Debug, Clone, PartialEq)]
pub struct Elastic {
    /// Particles in order.
    pub line: Vec<PieceParticle>,
    /// Whether the band is a ring.
    pub ends: Ends,
    /// Length of the band at rest over the flat length of the line, below 1 where it gathers.
    pub rest_share: f32,
    /// Tension at twice the rest length `EA` [N].
    pub stretch_stiffness: f32,
}

/// A prepared band.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ElasticKnots {
    /// Both ends of each spring, and its rest length [m].
    springs: Vec<([Knot; 2], f32)>,
    stretch_stiffness: f32,
}

impl ElasticKnots {
    pub(crate) fn new(pieces: &[ClothPiece], elastic: &Elastic) -> Result<Self, JointError> {
        if elastic.line.len() < 2 {
            return Err(JointError::WrongCount {
                joint: "an elastic",
                actual: elastic.line.len(),
                rule: "at least 2",
            });
        }
        let rest_share = positive("elastic.rest_share", elastic.rest_share)?;
        let mut springs = Vec::new();
        for [first, second] in neighbors(&elastic.line, elastic.ends) {
            let knots = [Knot::new(pieces, first)?, Knot::new(pieces, second)?];
            // Across a seam the line goes on where it is: no band lies there.
            if first.piece == second.piece {
                let flat = pieces[first.piece].flat_distance([first.particle, second.particle]);
                springs.push((knots, positive("elastic.length", flat * rest_share)?));
            }
        }
        Ok(Self {
            springs,
            stretch_stiffness: positive("elastic.stretch_stiffness", elastic.stretch_stiffness)?,
        })
    }

    pub(crate) fn solve(&self, states: &mut [PieceState], h: f32) {
        for &([first, second], rest_length) in &self.springs {
            let offset = second.place(states) - first.place(states);
            let length = offset.length();
            if length <= rest_length.max(DEGENERATE_LENGTH) {
                continue;
            }
            let compliance = rest_length / (self.stretch_stiffness * h * h);
            let sum = first.inv_mass + second.inv_mass + compliance;
            let impulse = offset * ((length - rest_length) / (length * sum));
            first.push(states, impulse);
            second.push(states, -impulse);
        }
    }
}
