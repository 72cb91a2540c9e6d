//! Drawstrings: a line may be no longer than its string, however the cloth is spread along it.
//!
//! `C = Σ |x_(i+1) - x_i| - length ≤ 0`. A line that is too long is drawn in evenly: all of it is
//! scaled towards its center of mass, or towards what is pinned, which makes it exactly as long as
//! the string and keeps linear and angular momentum. (The shortest way to satisfy `C` moves only
//! the ends of a straight line, and crushes the cloth there.) The string does not stretch.

use glam::Vec3;

use crate::assembly::joint::{JointError, positive};
use crate::assembly::knot::{Ends, Knot, PieceParticle};
use crate::assembly::piece::{ClothPiece, PieceState};

/// A string along a line of particles.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawstring {
    /// Particles in order.
    pub line: Vec<PieceParticle>,
    /// Whether the string is tied to a ring.
    pub ends: Ends,
    /// Longest that the line may be [m].
    pub length: f32,
}

/// A prepared string.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DrawstringKnots {
    knots: Vec<Knot>,
    ends: Ends,
    length: f32,
}

impl DrawstringKnots {
    pub(crate) fn new(pieces: &[ClothPiece], string: &Drawstring) -> Result<Self, JointError> {
        if string.line.len() < 2 {
            return Err(JointError::WrongCount {
                joint: "a drawstring",
                actual: string.line.len(),
                rule: "at least 2",
            });
        }
        Ok(Self {
            knots: Knot::line(pieces, &string.line)?,
            ends: string.ends,
            length: positive("drawstring.length", string.length)?,
        })
    }

    /// How long the line is [m].
    fn total(&self, states: &[PieceState]) -> f32 {
        let places = || self.knots.iter().map(|knot| knot.place(states));
        let open: f32 = places()
            .zip(places().skip(1))
            .map(|(a, b)| a.distance(b))
            .sum();
        let closing = match (self.ends, places().next(), places().next_back()) {
            (Ends::Joined, Some(first), Some(last)) => first.distance(last),
            _ => 0.0,
        };
        open + closing
    }

    /// What the line is drawn towards: its pinned knots, else its center of mass.
    fn center(&self, states: &[PieceState]) -> Vec3 {
        let pinned = || self.knots.iter().filter(|knot| knot.inv_mass <= 0.0);
        let is_held = pinned().next().is_some();
        let (mut sum, mut weight) = (Vec3::ZERO, 0.0);
        for knot in &self.knots {
            let mass = match (is_held, 0.0 < knot.inv_mass) {
                (false, _) => 1.0 / knot.inv_mass,
                (true, is_free) => f32::from(u8::from(!is_free)),
            };
            sum += knot.place(states) * mass;
            weight += mass;
        }
        sum / weight
    }

    pub(crate) fn solve(&self, states: &mut [PieceState]) {
        let total = self.total(states);
        if total <= self.length {
            return;
        }
        let center = self.center(states);
        let drawn = 1.0 - self.length / total;
        for knot in &self.knots {
            if 0.0 < knot.inv_mass {
                let change = (center - knot.place(states)) * drawn;
                knot.push(states, change / knot.inv_mass);
            }
        }
    }
}
