//! What moves in a drawn face without a bone: the lids that close, and the eyes that turn.

use std::ops::Range;

use glam::{Affine3A, Quat, Vec3};
use lole_geom::trig;

use crate::parts::HeadPart;
use crate::skin::blend;
use crate::surface::warp::smooth_step;
use crate::{Bone, SkinnedMesh};

/// Where the lids meet: so much of the way from the upper lid's rim to the lower one's.
const MEETS: f32 = 0.86;
/// How much of the upper lid's way the lower lid goes.
const LOWER: f32 = 0.8;
/// Skin over the eye keeps so far from its middle, in radii; over its front a little more.
const CLEAR: f32 = 1.035;
const CLEAR_BEFORE: f32 = 0.03;
/// How far eyes turn: aside, up and down [rad].
const MOST_ASIDE: f32 = 0.26;
const MOST_UP: f32 = 0.16;
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
    /// Points that move with the lids.
    pub(crate) lids: Vec<LidPoint>,
    /// The left eye and the right one.
    pub(crate) eyes: [Eyeball; 2],
}

/// A point that moves with a lid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LidPoint {
    /// The vertex.
    pub(crate) vertex: u32,
    /// How far it has moved when the eye is half closed and when it is closed [m], in the bind pose.
    pub(crate) moved: [Vec3; 2],
}

/// An eyeball.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Eyeball {
    /// Its vertices, with the light in it.
    pub(crate) vertices: Range<u32>,
    /// Its middle [m], and where it looks, in the bind pose.
    pub(crate) center: Vec3,
    pub(crate) ahead: Vec3,
}

impl DrawnBody {
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

impl Eyeball {
    /// How it turns to look at a place of the bind pose, as far as eyes turn, and how far down that is, 0 to 1.
    fn turn(&self, target: Vec3) -> (Quat, f32) {
        let way = (target - self.center).normalize_or(self.ahead);
        // Behind her she does not look.
        let before = smooth_step((way.z + 0.1) / 0.4);
        let aside = before * trig::atan2(way.x, way.z.max(0.05));
        let level = (way.x * way.x + way.z * way.z).sqrt();
        let up = before * trig::atan2(way.y, level);
        let aside = soft(aside, MOST_ASIDE);
        let up = soft(up, MOST_UP);
        let turn = Quat::from_rotation_y(aside) * Quat::from_rotation_x(-up);
        (turn, (-up / MOST_UP).max(0.0))
    }
}

/// A number that comes near to a limit but not over it.
fn soft(value: f32, most: f32) -> f32 {
    value / (1.0 + (value / most).abs())
}

/// What an axis and an angle do with a place.
struct Turn {
    axis: Vec3,
    angle: f32,
}

/// How a column of lid points turns about the eye's middle when it closes.
fn column_turn(from: Vec3, to: Vec3) -> Option<Turn> {
    let cross = from.cross(to);
    let sine = cross.length();
    (1.0e-12 < sine).then(|| Turn {
        axis: cross / sine,
        angle: trig::atan2(sine, from.dot(to)),
    })
}

/// How far from the eye's middle a ring of the lids stays, in radii; those far behind the rim go where they are led.
fn clear_of(ring: usize, rim: usize) -> f32 {
    if rim + 3 < ring {
        return 0.0;
    }
    let front = ((rim as f32 - ring as f32) / 4.0 + 0.5).clamp(0.0, 1.0);
    CLEAR + CLEAR_BEFORE * front
}

/// Where points of the head go when the eye closes by a share: points by number, and how far each moves [m].
pub(super) fn closing(head: &HeadPart, share: f32) -> Vec<(u32, Vec3)> {
    let (rim, around) = (head.lid_rim, head.lids[head.lid_rim].len());
    let place = |ring: usize, column: usize| {
        head.part.positions[head.lids[ring][column] as usize] - head.eye
    };
    let radius = head.eye_radius;
    let mut moved = Vec::new();
    for upper in 1..around / 2 {
        let lower = around - upper;
        let [from, opposite] = [place(rim, upper), place(rim, lower)];
        let meets = (from * (1.0 - MEETS) + opposite * MEETS).normalize_or(from);
        let meets = meets * opposite.length().max(1.06 * radius);
        for (column, start) in [(upper, from), (lower, opposite)] {
            let Some(turn) = column_turn(start, meets) else {
                continue;
            };
            let way = if column == lower { LOWER } else { 1.0 };
            for (ring, points) in head.lids.iter().enumerate() {
                let fade = if ring < rim {
                    way * smooth_step(ring as f32 / rim as f32)
                } else {
                    1.0
                };
                let before = place(ring, column);
                let turned = Quat::from_axis_angle(turn.axis, turn.angle * fade * share) * before;
                let length = turned.length();
                let wanted = length.max(radius * clear_of(ring, rim));
                let turned = turned * (1.0 + (wanted / length.max(1.0e-6) - 1.0) * share * fade);
                moved.push((points[column], turned - before));
            }
        }
    }
    moved
}

/// Where a place on the upper lid at a column goes when the eye closes by a share [m].
pub(super) fn with_upper_lid(head: &HeadPart, place: Vec3, column: usize, share: f32) -> Vec3 {
    let rim = &head.lids[head.lid_rim];
    let at = |column: usize| head.part.positions[rim[column] as usize] - head.eye;
    let column = column.clamp(1, rim.len() / 2 - 1);
    let [from, opposite] = [at(column), at(rim.len() - column)];
    let meets = (from * (1.0 - MEETS) + opposite * MEETS).normalize_or(from);
    let meets = meets * opposite.length().max(1.06 * head.eye_radius);
    column_turn(from, meets).map_or(Vec3::ZERO, |turn| {
        let before = place - head.eye;
        Quat::from_axis_angle(turn.axis, turn.angle * share) * before - before
    })
}
