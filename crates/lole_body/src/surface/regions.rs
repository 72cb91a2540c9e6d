//! Where the leotard ends and the painted face begins: signed functions of the bind position.

use glam::{Vec2, Vec3};

use super::warp::smooth_step;
use crate::sections::Sections;

/// Where the leotard ends and the painted face begins, in the bind pose.
#[derive(Debug, Clone)]
pub(crate) struct Regions {
    /// Stature over 1.585 m.
    k: f32,
    crotch: f32,
    armpit: f32,
    armpit_x: f32,
    shoulder: f32,
    face_center: Vec3,
    face_radius: f32,
}

impl Regions {
    pub(crate) fn new(body: &Sections, crotch: f32) -> Self {
        let k = body.height / 1.585;
        let head = body.head.center;
        Self {
            k,
            crotch,
            armpit: body.level("armpit"),
            armpit_x: body.level("armpit_x"),
            shoulder: body.level("shoulder"),
            face_center: head + Vec3::new(0.0, -0.022, 0.085) * k,
            face_radius: 0.088 * k,
        }
    }

    /// Positive inside the leotard: above the leg line, below the scoop, inside the armholes.
    pub(crate) fn leotard(&self, point: Vec3) -> f32 {
        let k = self.k;
        let x = point.x.abs();
        let leg = point.y - (self.crotch - 0.022 * k) - 0.62 * (x - 0.02 * k).max(0.0);
        let front = smooth_front(point.z / (0.05 * k));
        let depth = self.armpit + (0.052 - 0.022 * front) * k;
        let scoop = depth + 14.5 / k * x * x - point.y;
        let armhole_x = 0.128 * k
            + (self.armpit_x + 0.012 * k - 0.128 * k) * (self.shoulder - point.y)
                / (self.shoulder - self.armpit);
        leg.min(scoop).min(armhole_x - x)
    }

    /// Positive on the front of the head.
    pub(crate) fn face(&self, point: Vec3) -> f32 {
        self.face_radius - (point - self.face_center).length()
    }

    /// The face seen from the front, over the square around it; `v` down.
    pub(crate) fn face_uv(&self, point: Vec3) -> Vec2 {
        let offset = (point - self.face_center) / (2.0 * self.face_radius);
        Vec2::new(0.5 + offset.x, 0.5 - offset.y).clamp(Vec2::ZERO, Vec2::ONE)
    }
}

/// -1 behind, 1 in front, smooth between.
fn smooth_front(x: f32) -> f32 {
    2.0 * smooth_step(0.5 + 0.5 * x) - 1.0
}
