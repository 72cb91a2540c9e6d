//! Shoulder breadth and upper-arm length where they were measured: shoulders slide out or in with
//! their arms, and the upper arm stretches along itself.

use glam::Vec3;

use super::half::is_on_plane;
use super::warp::{arm_share, smooth_step};
use crate::Measurements;
use crate::measured::{highest_above, shoulder_point_out};
use crate::sections::Sections;

/// How far below the armpit the trunk still follows the shoulder, as a share of the stature.
const FADE: f32 = 0.035;

/// The two warps of one shoulder, the left one.
pub(crate) struct Shoulders {
    /// Outward way of shoulder and arm [m].
    shift: f32,
    /// Longer by this much [m], between shoulder joint and elbow.
    longer: f32,
    /// Shoulder joint before its shift.
    joint: Vec3,
    /// Unit direction and length of the upper arm.
    axis: Vec3,
    length: f32,
    /// Heights between which the trunk begins to follow.
    fade: [f32; 2],
    neck_x: f32,
}

impl Shoulders {
    /// `None` where neither was measured. `body` has its final heights; `positions` and
    /// `triangles` are its left half.
    pub(crate) fn new(
        body: &Sections,
        tape: &Measurements,
        positions: &[Vec3],
        triangles: &[[u32; 3]],
    ) -> Option<Self> {
        if tape.shoulder_breadth.is_none() && tape.upper_arm_length.is_none() {
            return None;
        }
        #[expect(clippy::cast_possible_truncation, reason = "a body to 0.1 µm")]
        let meters = |length: lole_geom::Length| length.to_m() as f32;
        let joint = body.joint("leftUpperArm");
        let elbow = body.joint("leftLowerArm");
        let out = shoulder_point_out(tape.figure, body.height);
        let shift =
            (tape.shoulder_breadth).map_or(0.0, |breadth| 0.5 * meters(breadth) - (joint.x + out));
        let arm = elbow - joint;
        let length = arm.length();
        let axis = arm.normalize_or_zero();
        let top = highest_above(positions, triangles.iter().copied(), joint.x + out, joint.z);
        // Shoulder point over the joint: the elbow runs along the arm until it is as far as the tape.
        let from_point = joint - Vec3::new(joint.x + out, top, joint.z);
        let longer = tape.upper_arm_length.map_or(0.0, |wanted| {
            let half = from_point.dot(axis);
            let inside =
                half * half - from_point.length_squared() + meters(wanted) * meters(wanted);
            inside.max(0.0).sqrt() - half - length
        });
        let armpit = body.level("armpit");
        Some(Self {
            shift,
            longer: longer.max(-0.5 * length),
            joint,
            axis,
            length,
            fade: [armpit - FADE * body.height, armpit + 0.01 * body.height],
            neck_x: 0.3 * joint.x,
        })
    }

    /// A point of the left half; `arm` in `0..=1` is the share that belongs to the arm. A point of the
    /// mirror plane stays there, or the halves would come apart: averaged shares reach it as traces.
    pub(crate) fn carry(&self, point: Vec3, arm: f32) -> Vec3 {
        let [low, high] = self.fade;
        let across = smooth_step((point.x - self.neck_x) / (self.joint.x - self.neck_x));
        let up = smooth_step((point.y - low) / (high - low));
        let follows = if is_on_plane(point) {
            0.0
        } else {
            arm.max(across * up)
        };
        let along = ((point - self.joint).dot(self.axis) / self.length).clamp(0.0, 1.0);
        point + Vec3::X * (self.shift * follows) + self.axis * (self.longer * along * arm)
    }

    /// Joints and the armpit's place.
    pub(crate) fn carry_sections(&self, body: &mut Sections) {
        for (name, joint) in &mut body.joints {
            let arm = if name.contains("leftUpperArm") {
                1.0
            } else {
                arm_share(name)
            };
            *joint = self.carry(*joint, arm);
        }
        if let Some(x) = body.levels.get_mut("armpit_x") {
            *x += self.shift;
        }
    }
}
