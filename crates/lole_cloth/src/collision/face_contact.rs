//! Contact of cloth with cloth by vertices and triangles: of a piece of any mesh with itself, and
//! of the pieces of an assembly with each other, whatever their kinds.
//!
//! Spheres around particles close a surface only where particles lie as near as the cloth is thick,
//! which no mesh promises; a vertex against a triangle holds whatever their sizes. Candidates are
//! found once a step with the side on which they lie, and solved in a fixed order.

mod faces;
mod search;

use glam::Vec3;
use lole_geom::triangle_grid::{blend, nearest_barycentric};

use crate::collision::grid::CellGrid;
use crate::collision::parting::{FARTHEST_LEVER, Touching};
pub(crate) use faces::{FacePiece, Faces, FlatShape};

/// A vertex and a triangle that may touch, by bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Pair {
    /// The vertex, then the corners.
    bodies: [u32; 4],
    /// Kept between them [m].
    diameter: f32,
    friction: f32,
    /// Unit vector from the triangle to the vertex when the pair was found.
    side: Vec3,
}

/// A particle that is in a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Body {
    position: Vec3,
    inv_mass: f32,
    /// Where it was at the start of the substep [m].
    before: Vec3,
    /// Whether contacts have moved it in this solution.
    is_touched: bool,
    /// What contacts moved it without a push [m].
    quiet: Vec3,
    /// Whether `before` is known.
    has_before: bool,
    piece: u32,
    slot: u32,
}

/// Candidates and room to find and solve them.
#[derive(Debug, Clone, Default)]
pub(crate) struct FaceContacts {
    /// Every particle at the start of the step [m], piece by piece.
    pub(crate) positions: Vec<Vec3>,
    /// Velocity of every particle then [m/s], piece by piece; empty for a piece alone, whose folds move
    /// together.
    pub(crate) velocities: Vec<Vec3>,
    /// Particles where cloth has gone through cloth: they do not know on which side they belong, and
    /// do not touch each other. Empty where there are none.
    pub(crate) is_tangled: Vec<bool>,
    cells: CellGrid,
    room: search::Room,
    pairs: Vec<Pair>,
    bodies: Vec<Body>,
}

/// How the pieces meet in a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Meeting {
    /// Half of the distance kept [m]; `None` for a piece that meets no cloth.
    pub(crate) radius: Option<f32>,
    /// Coulomb friction coefficient of cloth on cloth.
    pub(crate) friction: f32,
}

/// Particles in the engine's order, between the springs of a substep and its contacts with the body.
pub(crate) trait Moving {
    /// Where a slot of a piece is [m].
    fn place(&self, piece: usize, slot: usize) -> Vec3;

    /// Where it began the substep of `h` [s], in meters.
    fn start(&self, piece: usize, slot: usize, h: f32) -> Vec3;

    /// Puts it there; what moved it by `quiet` [m] gives no speed.
    fn put(&mut self, piece: usize, slot: usize, position: Vec3, quiet: Vec3);
}

impl FaceContacts {
    /// Moves apart what is nearer than allowed in a substep of `h` [s]. What undoes an approach
    /// becomes velocity; the rest gives none, so that overlapping cloth parts without a push.
    pub(crate) fn solve(&mut self, moving: &mut (impl Moving + ?Sized), h: f32) {
        if self.pairs.is_empty() {
            return;
        }
        for body in &mut self.bodies {
            body.position = moving.place(body.piece as usize, body.slot as usize);
            body.is_touched = false;
            body.has_before = false;
        }
        for pair in &self.pairs {
            let [vertex, a, b, c] = pair.bodies.map(|body| self.bodies[body as usize].position);
            if is_beyond(vertex, [a, b, c], pair.diameter) {
                continue;
            }
            let weights = nearest_barycentric(vertex, [a, b, c]);
            let gap = vertex - blend([a, b, c], weights);
            let nearest = NearestPoint { weights, gap };
            if gap.length_squared() < pair.diameter * pair.diameter {
                for body in pair.bodies {
                    meet(&mut self.bodies[body as usize], moving, h);
                }
                part(&mut self.bodies, pair, nearest, h);
            }
        }
        for body in self.bodies.iter().filter(|body| body.is_touched) {
            let (piece, slot) = (body.piece as usize, body.slot as usize);
            moving.put(piece, slot, body.position, body.quiet);
        }
    }
}

/// Whether a vertex is certainly farther than `reach` [m] from a triangle.
#[inline(always)]
fn is_beyond(vertex: Vec3, [a, b, c]: [Vec3; 3], reach: f32) -> bool {
    let normal = (b - a).cross(c - a);
    let height = normal.dot(vertex - a);
    reach * reach * normal.length_squared() < height * height
}

/// Fetches what only touching particles need.
fn meet(body: &mut Body, moving: &(impl Moving + ?Sized), h: f32) {
    if !body.has_before {
        body.has_before = true;
        body.before = moving.start(body.piece as usize, body.slot as usize, h);
        body.quiet = Vec3::ZERO;
    }
}

/// The point of a triangle that is nearest to a vertex.
#[derive(Debug, Clone, Copy, PartialEq)]
struct NearestPoint {
    /// Weights of the triangle's corners there.
    weights: Vec3,
    /// From there to the vertex [m].
    gap: Vec3,
}

/// Parts a vertex from the nearest point of a triangle in a substep of `h` [s].
fn part(bodies: &mut [Body], pair: &Pair, nearest: NearestPoint, h: f32) {
    let NearestPoint { weights, gap } = nearest;
    let shares = [1.0, -weights.x, -weights.y, -weights.z];
    let (mut slip, mut inv_mass_sum, mut most) = (Vec3::ZERO, 0.0, 0.0_f32);
    for (&body, share) in pair.bodies.iter().zip(shares) {
        let body = &bodies[body as usize];
        slip += (body.position - body.before) * share;
        inv_mass_sum += body.inv_mass * share * share;
        most = most.max(body.inv_mass * share.abs());
    }
    let inv_mass_sum = inv_mass_sum.max(most / FARTHEST_LEVER);
    if inv_mass_sum <= 0.0 {
        return;
    }
    let touching = Touching {
        gap,
        slip,
        side: pair.side,
        diameter: pair.diameter,
    };
    let Some(parting) = touching.part(pair.friction, h) else {
        return;
    };
    let change = parting.change / inv_mass_sum;
    let quiet = parting.normal * (parting.quiet / inv_mass_sum);
    for (&body, share) in pair.bodies.iter().zip(shares) {
        let body = &mut bodies[body as usize];
        let moved = body.inv_mass * share;
        body.position += change * moved;
        body.quiet += quiet * moved;
        body.is_touched |= moved != 0.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_corner_that_alone_is_free_is_not_thrown_by_the_lever_it_has() {
        let at = |position: Vec3, inv_mass: f32| Body {
            position,
            inv_mass,
            before: position,
            is_touched: false,
            quiet: Vec3::ZERO,
            has_before: true,
            piece: 0,
            slot: 0,
        };
        let free = 1.0e5;
        // Pinned: the vertex, a millimeter above the edge of the two corners that are pinned too.
        for share in [1.0e-4, 0.01, 0.1, 0.4, 0.9] {
            let corners = [Vec3::ZERO, Vec3::X * 0.02, Vec3::Z * 0.02];
            let weights = Vec3::new(1.0 - share, 0.0, share);
            let vertex = blend(corners, weights) + Vec3::Y * 0.001;
            let mut bodies = vec![at(vertex, 0.0)];
            let masses = [0.0, 0.0, free];
            let others = corners.into_iter().zip(masses);
            bodies.extend(others.map(|(corner, inv_mass)| at(corner, inv_mass)));
            let pair = Pair {
                bodies: [0, 1, 2, 3],
                diameter: 0.006,
                friction: 0.3,
                side: Vec3::Y,
            };
            let gap = Vec3::Y * 0.001;
            part(
                &mut bodies,
                &pair,
                NearestPoint { weights, gap },
                1.0 / 720.0,
            );
            let moved = corners[2].y - bodies[3].position.y;
            let parted = 0.7 * 0.005_f32.min(2.0 / 720.0 / 0.7);
            assert!(0.0 < moved, "{share}: {moved}");
            let most = FARTHEST_LEVER * parted * 1.001;
            assert!(moved <= most, "{share}: {moved} of {parted}");
            // Where its share is great enough, the contact is solved.
            if 0.5 < share {
                assert!((moved * share - parted).abs() < 1.0e-5, "{moved} {parted}");
            }
        }
    }
}
