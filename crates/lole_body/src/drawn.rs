//! The body as it is drawn: the skin that cloth meets, whose head, hands and feet are cut off, and measured ones
//! with lids, lips, ears, nails and toes sewn on instead.
//!
//! Skin and drawn body are the same everywhere else, so what cloth meets is what is seen under it.

mod armhole;
mod build;
mod eyes;
mod face;
mod features;
pub(crate) mod open_hair;
mod paint;
mod weld;
mod years;

pub(crate) use build::build_drawn;
pub use open_hair::{Combed, HairKnot, OpenHair, Swing};

use glam::{Affine3A, Vec3};
use lole_geom::finer::Finer;

use crate::skin::blend;
use crate::{Bone, SkinnedMesh};
use face::{Eyeball, LidPoint};

/// How much a lid follows an eye that looks as far down as it does.
const LID_FOLLOWS: f32 = 0.14;

/// What a face does in a moment.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Expression {
    /// How far the eyes are closed, 0 to 1.
    pub closed: f32,
    /// Where she looks, in the world [m]; straight ahead where it is `None`.
    pub looks_at: Option<Vec3>,
}

/// A body as it is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnBody {
    /// Its surface in the bind pose, with open eyes that look ahead.
    pub mesh: SkinnedMesh,
    /// Single strands over the hair, for pictures from near by: ribbons, in one part.
    pub strands: SkinnedMesh,
    /// What of the hair swings; nothing of combed or cut hair.
    pub open_hair: OpenHair,
    /// Points that move with the lids.
    lids: Vec<LidPoint>,
    /// The left eye and the right one.
    eyes: [Eyeball; 2],
}

impl DrawnBody {
    /// How its skin and leotard are made finer for pictures from near by: their triangles, part after part.
    #[must_use]
    pub fn finer(&self) -> Finer {
        let parts = self.mesh.parts.iter().filter(|part| part.kind.is_rounded());
        let triangles: Vec<[u32; 3]> = parts.flat_map(|part| part.triangles.clone()).collect();
        let alone: Vec<u32> = (0..).take(self.mesh.positions.len()).collect();
        Finer::new(&triangles, &alone)
    }

    /// The middle between the eyes [m], in the bind pose.
    #[must_use]
    pub fn between_eyes(&self) -> Vec3 {
        0.5 * (self.eyes[0].center + self.eyes[1].center)
    }

    /// Vertices that move with the lids, ascending, and how far each has moved when the eyes are half closed and when
    /// they are closed [m], in the bind pose.
    pub fn closing(&self) -> impl Iterator<Item = (u32, [Vec3; 2])> {
        self.lids.iter().map(|lid| (lid.vertex, lid.moved))
    }

    /// Shares of both when the eyes are so far closed, 0 to 1: the way of a lid is an arc, and a line would go
    /// through the eye.
    #[must_use]
    pub fn closing_shares(closed: f32) -> [f32; 2] {
        [4.0 * closed * (1.0 - closed), closed * (2.0 * closed - 1.0)]
    }

    /// Posed positions and normals as [`SkinnedMesh::pose`] has them, with what the face does.
    pub fn pose(
        &self,
        world_from_bind: &[Affine3A],
        expression: Expression,
        positions: &mut Vec<Vec3>,
        normals: &mut Vec<Vec3>,
    ) {
        self.mesh.pose(world_from_bind, positions, normals);
        let head = world_from_bind[Bone::Head.index()];
        let mut down = 0.0_f32;
        if let Some(target) = expression.looks_at {
            let target = head.inverse().transform_point3(target);
            for eye in &self.eyes {
                let (turn, lowered) = eye.turn(target);
                down = down.max(lowered);
                for vertex in eye.vertices.clone() {
                    let vertex = vertex as usize;
                    let place = eye.center + turn * (self.mesh.positions[vertex] - eye.center);
                    positions[vertex] = head.transform_point3(place);
                    let normal = turn * self.mesh.normals[vertex];
                    normals[vertex] = head.transform_vector3(normal).normalize_or_zero();
                }
            }
        }
        let closed = (expression.closed + LID_FOLLOWS * down).clamp(0.0, 1.0);
        if 0.0 < closed {
            let shares = Self::closing_shares(closed);
            for lid in &self.lids {
                let vertex = lid.vertex as usize;
                let moved = lid.moved[0] * shares[0] + lid.moved[1] * shares[1];
                let (joints, weights) = (self.mesh.joints[vertex], self.mesh.weights[vertex]);
                let blended = blend(world_from_bind, joints, weights);
                positions[vertex] += blended.transform_vector3(moved);
            }
        }
    }
}
