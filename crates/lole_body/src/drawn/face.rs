//! What moves in a drawn face without a bone: the lids that close, and the eyes that turn.

use std::ops::Range;

use glam::{Quat, Vec3};
use lole_geom::trig;

use crate::parts::HeadPart;
use crate::surface::warp::smooth_step;

/// Where the lids meet: so much of the way from the upper lid's rim to the lower one's.
const MEETS: f32 = 0.86;
/// How far from the eye's middle they meet at least, in radii.
const LEAST_MEETING: f32 = 1.06;
/// How much of the upper lid's way the lower lid goes.
const LOWER: f32 = 0.8;
/// Skin over the eye keeps so far from its middle, in radii; over its front a little more.
const CLEAR: f32 = 1.035;
const CLEAR_BEFORE: f32 = 0.03;
/// How far eyes turn: aside, up and down [rad].
const MOST_ASIDE: f32 = 0.26;
const MOST_UP: f32 = 0.16;
/// A point that moves with a lid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LidPoint {
    /// The vertex.
    pub(super) vertex: u32,
    /// How far it has moved when the eye is half closed and when it is closed [m], in the bind pose.
    pub(super) moved: [Vec3; 2],
}

/// An eyeball.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Eyeball {
    /// Its vertices, with the light in it.
    pub(super) vertices: Range<u32>,
    /// Its middle [m], and where it looks, in the bind pose.
    pub(super) center: Vec3,
    pub(super) ahead: Vec3,
}

impl Eyeball {
    /// How it turns to look at a place of the bind pose, as far as eyes turn, and how far down that is, 0 to 1.
    pub(super) fn turn(&self, target: Vec3) -> (Quat, f32) {
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

/// Where the rim of the upper lid and that of the lower one opposite to it meet, all from the eye's middle [m].
fn meeting([upper, lower]: [Vec3; 2], radius: f32) -> Vec3 {
    let way = (upper * (1.0 - MEETS) + lower * MEETS).normalize_or(upper);
    way * lower.length().max(LEAST_MEETING * radius)
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
        let meets = meeting([from, opposite], radius);
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
    let meets = meeting([from, opposite], head.eye_radius);
    column_turn(from, meets).map_or(Vec3::ZERO, |turn| {
        let before = place - head.eye;
        Quat::from_axis_angle(turn.axis, turn.angle * share) * before - before
    })
}
