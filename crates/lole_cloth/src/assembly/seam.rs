//! Seams: points of one line and of another are the same point.
//!
//! `C = p - q = 0` for two points on edges, `p = (1 - s) x_0 + s x_1`: linear, without compliance,
//! for thread does not give where cloth does. The lines may have different lengths: what is longer
//! is gathered, by as much everywhere.

use glam::Vec3;

use crate::assembly::joint::JointError;
use crate::assembly::knot::{EdgePoint, Knot, PieceParticle};
use crate::assembly::piece::{ClothPiece, PieceState};

/// Passes over the stitches in each substep: stitches that share an edge pull it from each other.
const PASS_COUNT: u32 = 4;

/// Over this ratio of lengths the longer line is gathered; below, it is eased in.
const GATHER_MIN: f32 = 1.05;

/// Keeps the quotient finite where all ends are pinned [1/kg].
const INV_MASS_FLOOR: f32 = 1.0e-6;

/// Two lines sewn together, point by point.
#[derive(Debug, Clone, PartialEq)]
pub struct ClothSeam {
    /// Points that become one.
    pub stitches: Vec<[EdgePoint; 2]>,
}

impl ClothSeam {
    /// Sews a line of particles to another from end to end, both as the seamstress meets them.
    ///
    /// Every particle of either line is sewn to the point of the other that is as far along it, as
    /// a share of its flat length. So lines of different spacings may be joined, within one piece
    /// or between two. Where one is longer it is gathered: only the particles of the shorter are
    /// sewn then, and what is too much puckers between them.
    ///
    /// # Errors
    /// A line of fewer than two particles, and particles that do not exist.
    pub fn along(
        pieces: &[ClothPiece],
        first: &[PieceParticle],
        second: &[PieceParticle],
    ) -> Result<Self, JointError> {
        let [(shares_first, length_first), (shares_second, length_second)] =
            [shares(pieces, first)?, shares(pieces, second)?];
        let mut stitches = Vec::new();
        if length_first <= length_second * GATHER_MIN {
            for (&place, &share) in first.iter().zip(&shares_first) {
                let other = point_at(second, &shares_second, share);
                stitches.push((share, [place.into(), other]));
            }
        }
        if length_second <= length_first * GATHER_MIN {
            for (&place, &share) in second.iter().zip(&shares_second) {
                let stitch = [point_at(first, &shares_first, share), place.into()];
                // Particles that face each other are sewn once.
                if !stitches.iter().any(|(_, other)| *other == stitch) {
                    stitches.push((share, stitch));
                }
            }
        }
        stitches.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        Ok(Self {
            stitches: stitches.into_iter().map(|(_, stitch)| stitch).collect(),
        })
    }
}

/// How far every particle of a line is along it, 0 to 1, and its flat length [m].
fn shares(pieces: &[ClothPiece], line: &[PieceParticle]) -> Result<(Vec<f32>, f32), JointError> {
    if line.len() < 2 {
        return Err(JointError::WrongCount {
            joint: "a line of a seam",
            actual: line.len(),
            rule: "at least 2",
        });
    }
    Knot::line(pieces, line)?;
    let mut lengths = vec![0.0];
    let mut sum = 0.0;
    for pair in line.windows(2) {
        if pair[0].piece == pair[1].piece {
            let particles = [pair[0].particle, pair[1].particle];
            sum += pieces[pair[0].piece].flat_distance(particles);
        }
        lengths.push(sum);
    }
    if sum <= 0.0 {
        return Err(JointError::OutOfRange {
            field: "seam.length",
            value: sum,
            rule: "above 0",
        });
    }
    let shares = lengths.into_iter().map(|length| length / sum);
    Ok((shares.collect(), sum))
}

/// The point of a line at a share of its length. Ends and particles are met exactly.
fn point_at(line: &[PieceParticle], shares: &[f32], share: f32) -> EdgePoint {
    const SAME: f32 = 1.0e-4;
    let after = shares.partition_point(|&other| other < share - SAME);
    let after = after.min(line.len() - 1);
    if (shares[after] - share).abs() <= SAME || after == 0 {
        return line[after].into();
    }
    let [start, end] = [line[after - 1], line[after]];
    if start.piece != end.piece {
        return end.into();
    }
    EdgePoint {
        piece: start.piece,
        particles: [start.particle, end.particle],
        share: (share - shares[after - 1]) / (shares[after] - shares[after - 1]),
    }
}

/// A prepared seam.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Stitches(Vec<Stitch>);

/// Up to four particles with the weights of `C`, those that have one first, and one over `Σ w weight²` [kg].
#[derive(Debug, Clone, PartialEq)]
struct Stitch {
    ends: [(Knot, f32); 4],
    count: usize,
    mass: f32,
}

impl Stitches {
    pub(crate) fn new(pieces: &[ClothPiece], seam: &ClothSeam) -> Result<Self, JointError> {
        let stitches = seam
            .stitches
            .iter()
            .map(|points| Stitch::new(pieces, points));
        Ok(Self(stitches.collect::<Result<_, _>>()?))
    }

    pub(crate) fn solve(&self, states: &mut [PieceState]) {
        for _ in 0..PASS_COUNT {
            for stitch in &self.0 {
                let ends = &stitch.ends[..stitch.count];
                let places = ends
                    .iter()
                    .map(|(knot, weight)| knot.place(states) * *weight);
                let impulse = places.fold(Vec3::ZERO, |sum, place| sum + place) * -stitch.mass;
                for (knot, weight) in ends {
                    knot.push(states, impulse * *weight);
                }
            }
        }
    }
}

impl Stitch {
    fn new(pieces: &[ClothPiece], points: &[EdgePoint; 2]) -> Result<Self, JointError> {
        for point in points {
            if !(0.0..=1.0).contains(&point.share) {
                return Err(JointError::OutOfRange {
                    field: "seam.share",
                    value: point.share,
                    rule: "between 0 and 1",
                });
            }
        }
        let end = |point: &EdgePoint, which: usize, weight: f32| {
            let particle = point.particles[which];
            let place = PieceParticle {
                piece: point.piece,
                particle,
            };
            Knot::new(pieces, place).map(|knot| (knot, weight))
        };
        let [p, q] = points;
        // A particle itself has no second end.
        let second = |point: &EdgePoint| usize::from(0.0 < point.share);
        let mut ends = [
            end(p, 0, 1.0 - p.share)?,
            end(p, second(p), p.share)?,
            end(q, 0, q.share - 1.0)?,
            end(q, second(q), -q.share)?,
        ];
        let sum: f32 = (ends.iter())
            .map(|(knot, weight)| knot.inv_mass * weight * weight)
            .sum();
        ends.sort_by_key(|&(_, weight)| weight == 0.0);
        Ok(Self {
            count: ends.iter().filter(|&&(_, weight)| weight != 0.0).count(),
            ends,
            mass: 1.0 / (sum + INV_MASS_FLOOR),
        })
    }
}
