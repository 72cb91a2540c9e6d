//! Pleats: creases that keep the angle they were pressed to.
//!
//! Along each edge of the crease the angle `θ` between the triangles left and right of it stores
//! `½ k l (θ - θ_0)²`, with the edge's length `l`. `θ` is 0 where the cloth is flat and positive
//! where the crease is a ridge towards the side from which the triangles turn counterclockwise; its
//! gradient is that of Bridson, Marino and Fedkiw 2003.

use std::f32::consts::PI;

use glam::Vec3;
use lole_geom::trig;

use crate::assembly::joint::{JointError, positive};
use crate::assembly::knot::{Knot, PieceParticle};
use crate::assembly::piece::{ClothPiece, PieceState};

/// Below this squared area (m⁴) a triangle has no side.
const DEGENERATE_SQUARE: f32 = 1.0e-16;

/// Farthest that one substep turns a crease [rad].
const TURN_MAX: f32 = 0.3;

/// A crease pressed into the cloth.
#[derive(Debug, Clone, PartialEq)]
pub struct Pleat {
    /// Edges of the crease: both ends, then the corners of the triangles left and right of it as
    /// one walks from the first end to the second.
    pub hinges: Vec<[PieceParticle; 4]>,
    /// Angle that it was pressed to [rad], -π to π; 0 is flat.
    pub rest_angle: f32,
    /// Torque per radian and length of the crease `k` [N].
    pub stiffness: f32,
}

/// A prepared crease.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PleatKnots {
    /// The knots of each edge, and its flat length [m].
    hinges: Vec<([Knot; 4], f32)>,
    rest_angle: f32,
    stiffness: f32,
}

/// An angle [rad], and its gradient by the two ends and the two corners [rad/m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Hinge {
    pub(crate) angle: f32,
    pub(crate) gradient: [Vec3; 4],
}

/// The hinge of an edge `a`, `b` with the corners `left` and `right` of it; `None` where a triangle
/// has no side.
pub(crate) fn hinge([a, b, left, right]: [Vec3; 4]) -> Option<Hinge> {
    let edge = b - a;
    let length = edge.length();
    let normals = [edge.cross(left - a), (right - a).cross(edge)];
    let squares = normals.map(Vec3::length_squared);
    if squares[0] < DEGENERATE_SQUARE || squares[1] < DEGENERATE_SQUARE {
        return None;
    }
    let along = edge / length;
    let sin = along.dot(normals[0].cross(normals[1]));
    let angle = trig::atan2(sin, normals[0].dot(normals[1]));
    // A corner that rises by dz turns its triangle by dz over its height above the edge.
    let [by_left, by_right] = [
        normals[0] * (-length / squares[0]),
        normals[1] * (-length / squares[1]),
    ];
    let share = |corner: Vec3| (corner - a).dot(along) / length;
    let (s, t) = (share(left), share(right));
    Some(Hinge {
        angle,
        gradient: [
            -(by_left * (1.0 - s) + by_right * (1.0 - t)),
            -(by_left * s + by_right * t),
            by_left,
            by_right,
        ],
    })
}

impl PleatKnots {
    pub(crate) fn new(pieces: &[ClothPiece], pleat: &Pleat) -> Result<Self, JointError> {
        if !(-PI..=PI).contains(&pleat.rest_angle) {
            return Err(JointError::OutOfRange {
                field: "pleat.rest_angle",
                value: pleat.rest_angle,
                rule: "between -π and π",
            });
        }
        let mut hinges = Vec::new();
        for places in &pleat.hinges {
            let [a, b, left, right] = *places;
            let knots = [
                Knot::new(pieces, a)?,
                Knot::new(pieces, b)?,
                Knot::new(pieces, left)?,
                Knot::new(pieces, right)?,
            ];
            let length = pieces[a.piece].flat_distance([a.particle, b.particle]);
            hinges.push((knots, positive("pleat.length", length)?));
        }
        Ok(Self {
            hinges,
            rest_angle: pleat.rest_angle,
            stiffness: positive("pleat.stiffness", pleat.stiffness)?,
        })
    }

    pub(crate) fn solve(&self, states: &mut [PieceState], h: f32) {
        for (knots, length) in &self.hinges {
            let Some(hinge) = hinge(knots.map(|knot| knot.place(states))) else {
                continue;
            };
            let sum: f32 = (knots.iter().zip(&hinge.gradient))
                .map(|(knot, gradient)| knot.inv_mass * gradient.length_squared())
                .sum();
            // The way back never leads through the fold.
            let off = hinge.angle - self.rest_angle;
            let compliance = 1.0 / (self.stiffness * length * h * h);
            let lambda = -off.clamp(-TURN_MAX, TURN_MAX) / (sum + compliance);
            for (knot, gradient) in knots.iter().zip(hinge.gradient) {
                knot.push(states, gradient * lambda);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [Vec3; 4] = [
        Vec3::new(0.01, 0.0, 0.02),
        Vec3::new(0.06, 0.01, 0.01),
        Vec3::new(0.03, 0.02, -0.05),
        Vec3::new(0.04, 0.015, 0.06),
    ];

    #[test]
    fn the_gradient_is_the_slope_of_the_angle() {
        let found = hinge(CORNERS).expect("a hinge");
        for corner in 0..4 {
            for axis in 0..3 {
                let step = 1e-4;
                let angle = |by: f32| {
                    let mut moved = CORNERS;
                    moved[corner][axis] += by;
                    hinge(moved).expect("a hinge").angle
                };
                let slope = (angle(step) - angle(-step)) / (2.0 * step);
                let error = (slope - found.gradient[corner][axis]).abs();
                assert!(
                    error < 0.05,
                    "{corner} {axis}: {slope} {}",
                    found.gradient[corner][axis]
                );
            }
        }
        let sum: Vec3 = found.gradient.iter().sum();
        assert!(sum.length() < 1e-3, "{sum}");
    }

    #[test]
    fn a_flat_cloth_has_no_angle_and_a_roof_has_a_right_one() {
        let [a, b] = [Vec3::ZERO, Vec3::X];
        let flat = hinge([a, b, -Vec3::Z, Vec3::Z]).expect("a hinge");
        assert!(flat.angle.abs() < 1e-6);
        let roof = hinge([a, b, -Vec3::Y - Vec3::Z, Vec3::Z - Vec3::Y]).expect("a hinge");
        assert!((roof.angle - 0.5 * PI).abs() < 1e-6, "{}", roof.angle);
    }
}
