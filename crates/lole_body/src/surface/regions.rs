//! Where the leotard ends and the face begins: signed functions of the bind position.

use glam::{Vec2, Vec3};

use super::warp::smooth_step;
use crate::sections::Sections;
use crate::{Bone, Skeleton};

/// Share of the arm from which on nothing is leotard.
const ARM_LIMIT: f32 = 0.7;
/// Outer edge of the shoulder strap from the middle [m] at a stature of 158.5 cm.
const STRAP_EDGE: f32 = 0.118;
/// Middle of the strap [m].
const STRAP_MIDDLE: f32 = 0.1;
/// How far beyond the armpit the armhole is still bent [m].
const SEAM_OUT: f32 = 0.0;
/// How far below the armpit the armhole ends [m].
const ARMHOLE_DROP: f32 = 0.037;
/// The same on the drawn body, whose arms are raised for it.
const RAISED_DROP: f32 = 0.028;
/// Height of the armhole's bend as a share of the armhole.
const ARMHOLE_RISE: f32 = 0.62;

/// Places of the measured woman (`body_sections.json`) by which they are found on a given body: her
/// shoulder joints above the crotch and aside [m], the armpit and the top of the shoulders over that
/// height above the crotch, and the armpit aside over the joint.
const SHOULDER_ABOVE_CROTCH: f32 = 0.542;
const SHOULDER_ASIDE: f32 = 0.1525;
const ARMPIT_SHARE: f32 = 0.884;
const SHOULDER_SHARE: f32 = 1.049;
const ARMPIT_ASIDE: f32 = 1.03;

/// Where the leotard ends and the face begins, in the bind pose.
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
    pub(crate) fn new(body: &Sections, crotch: f32, head_size: f32) -> Self {
        let k = body.height / 1.585;
        let head = body.head.center;
        Self {
            k,
            crotch,
            armpit: body.level("armpit"),
            armpit_x: body.level("armpit_x"),
            shoulder: body.level("shoulder"),
            face_center: head + Vec3::new(0.0, -0.022, 0.085) * head_size,
            face_radius: 0.088 * head_size,
        }
    }

    /// The leotard's regions of a given body with its arms lowered; it has no painted face.
    pub(crate) fn of_given(skeleton: &Skeleton, crotch: f32) -> Self {
        let [left, right] =
            [Bone::LeftUpperArm, Bone::RightUpperArm].map(|bone| skeleton.joint(bone));
        let height = 0.5 * (left.y + right.y) - crotch;
        let aside = 0.5 * (left.x - right.x).abs();
        // Straps of a child with a large head, or of a stout figure, lie by what is less.
        let k = (height / SHOULDER_ABOVE_CROTCH).min(aside / SHOULDER_ASIDE);
        Self {
            k,
            crotch,
            armpit: crotch + ARMPIT_SHARE * height,
            armpit_x: ARMPIT_ASIDE * aside,
            shoulder: crotch + SHOULDER_SHARE * height,
            face_center: Vec3::ZERO,
            face_radius: 0.0,
        }
    }

    /// Positive inside the leotard: above the leg line, below the scoop, inside the armholes and
    /// off the arm, of which `arm` is the share at this point.
    pub(crate) fn leotard(&self, point: Vec3, arm: f32) -> f32 {
        let k = self.k;
        let x = point.x.abs();
        let leg = point.y - (self.crotch - 0.022 * k) - 0.62 * (x - 0.02 * k).max(0.0);
        let front = smooth_front(point.z / (0.05 * k));
        let depth = self.armpit + (0.052 - 0.022 * front) * k;
        let scoop = depth + 14.5 / k * x * x - point.y;
        let off_arm = (ARM_LIMIT - arm) * (0.1 * k);
        leg.min(scoop)
            .min(self.armhole(Vec2::new(x, point.y), ARMHOLE_DROP))
            .min(off_arm)
    }

    /// Where a point with the left arm raised is inside the leotard's armhole, and is not: negative and positive.
    pub(crate) fn raised_armhole(&self, raised: Vec3) -> f32 {
        self.armhole(raised.truncate(), RAISED_DROP)
    }

    /// Whether a point in the bind pose is where the left armhole may be: outward of the middle of the strap, and not
    /// far below the armpit.
    pub(crate) fn is_beside_armhole(&self, point: Vec3) -> bool {
        STRAP_MIDDLE * self.k < point.x && self.armpit - 0.12 * self.k < point.y
    }

    /// Negative inside the armhole, which is cut as seen from the front: straight down beside the
    /// strap, then a quarter of an ellipse out to the side seam, which it meets level below the
    /// armpit, where the skin hardly follows the arm.
    fn armhole(&self, at: Vec2, drop: f32) -> f32 {
        let k = self.k;
        let strap = STRAP_EDGE * k;
        let seam = self.armpit_x + SEAM_OUT * k;
        let bottom = self.armpit - drop * k;
        let rise = ARMHOLE_RISE * (self.shoulder - bottom);
        let from_center = Vec2::new(seam - at.x, bottom + rise - at.y).max(Vec2::ZERO);
        let radii = Vec2::new(seam - strap, rise);
        ((from_center / radii).length() - 1.0) * radii.min_element()
    }

    /// Positive on the front of the head.
    pub(crate) fn face(&self, point: Vec3) -> f32 {
        self.face_radius - (point - self.face_center).length()
    }
}

/// -1 behind, 1 in front, smooth between.
fn smooth_front(x: f32) -> f32 {
    2.0 * smooth_step(0.5 + 0.5 * x) - 1.0
}
