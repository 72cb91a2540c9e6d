//! What the body is asked to do at one moment, before joints are solved.
//!
//! A figure is plain numbers so that two figures can be mixed and a right half be mirrored into a
//! left half. Lengths are in statures, angles in degrees; `[left, right]` for paired limbs.

use super::ease::mix;

/// Targets for the whole body.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Figure {
    /// Where the pelvis is and how it leans.
    pub pelvis: Pelvis,
    /// Left and right foot.
    pub feet: [Foot; 2],
    /// Left and right arm.
    pub arms: [Arm; 2],
    /// Turn of the head toward the left [°].
    pub gaze: f32,
}

/// Target of the pelvis, at the middle between the hip joints.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Pelvis {
    /// Where the whole body is along `+X` (left) [statures]; shoulders and head go there too.
    pub travel: f32,
    /// Sway to the left of that [statures]; shoulders and head stay.
    pub x: f32,
    /// Sway to the front [statures].
    pub z: f32,
    /// How much lower than the standing height of the step [statures].
    pub drop: f32,
    /// Left side up [°].
    pub roll: f32,
    /// Left side forward [°].
    pub yaw: f32,
    /// Top forward, tail out [°].
    pub tilt: f32,
}

/// Target of one foot. A foot with `heel > 0` stands on its ball, which stays where it was flat.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Foot {
    /// Where the ankle would be along `+X` were the sole flat [statures].
    pub x: f32,
    /// Height of the whole foot above the floor [statures].
    pub lift: f32,
    /// Height of the heel above the ball [statures].
    pub heel: f32,
    /// Turn-out of the toes [°].
    pub turn_out: f32,
    /// Turn-out of the knee beyond the toes [°].
    pub knee_out: f32,
}

/// Target of one arm as directions in chest space. Azimuth 0 points to the arm's own side, 90 to
/// the front, 180 across the body; elevation is above the horizontal.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Arm {
    /// Azimuth of the upper arm [°].
    pub azimuth: f32,
    /// Elevation of the upper arm [°].
    pub elevation: f32,
    /// Azimuth of the forearm [°].
    pub fore_azimuth: f32,
    /// Elevation of the forearm [°].
    pub fore_elevation: f32,
    /// Turn of the hand from palm down toward thumb up [°].
    pub palm: f32,
    /// Bend of the wrist toward the palm [°].
    pub wrist: f32,
    /// Curl of the fingers beyond their relaxed shape [°] per joint.
    pub fingers: f32,
}

impl Figure {
    /// Mixture of two figures: `self` at weight 0, `other` at weight 1.
    pub(super) fn mixed(&self, other: &Self, weight: f32) -> Self {
        let pair = |i: usize| (&self.feet[i], &other.feet[i], &self.arms[i], &other.arms[i]);
        let foot = |i| pair(i).0.mixed(pair(i).1, weight);
        let arm = |i| pair(i).2.mixed(pair(i).3, weight);
        Self {
            pelvis: self.pelvis.mixed(&other.pelvis, weight),
            feet: [foot(0), foot(1)],
            arms: [arm(0), arm(1)],
            gaze: mix(self.gaze, other.gaze, weight),
        }
    }

    /// The same figure seen in a mirror that stands at `x` [statures] across the dancer.
    pub(super) fn mirrored(&self, x: f32) -> Self {
        let foot = |foot: Foot| Foot {
            x: 2.0 * x - foot.x,
            ..foot
        };
        let pelvis = self.pelvis;
        Self {
            pelvis: Pelvis {
                travel: 2.0 * x - pelvis.travel,
                x: -pelvis.x,
                roll: -pelvis.roll,
                yaw: -pelvis.yaw,
                ..pelvis
            },
            feet: [foot(self.feet[1]), foot(self.feet[0])],
            arms: [self.arms[1], self.arms[0]],
            gaze: -self.gaze,
        }
    }
}

impl Pelvis {
    fn mixed(&self, other: &Self, weight: f32) -> Self {
        Self {
            travel: mix(self.travel, other.travel, weight),
            x: mix(self.x, other.x, weight),
            z: mix(self.z, other.z, weight),
            drop: mix(self.drop, other.drop, weight),
            roll: mix(self.roll, other.roll, weight),
            yaw: mix(self.yaw, other.yaw, weight),
            tilt: mix(self.tilt, other.tilt, weight),
        }
    }
}

impl Foot {
    fn mixed(&self, other: &Self, weight: f32) -> Self {
        Self {
            x: mix(self.x, other.x, weight),
            lift: mix(self.lift, other.lift, weight),
            heel: mix(self.heel, other.heel, weight),
            turn_out: mix(self.turn_out, other.turn_out, weight),
            knee_out: mix(self.knee_out, other.knee_out, weight),
        }
    }
}

impl Arm {
    /// Mixture of two arms: `self` at weight 0, `other` at weight 1.
    pub(super) fn mixed(&self, other: &Self, weight: f32) -> Self {
        Self {
            azimuth: mix(self.azimuth, other.azimuth, weight),
            elevation: mix(self.elevation, other.elevation, weight),
            fore_azimuth: mix(self.fore_azimuth, other.fore_azimuth, weight),
            fore_elevation: mix(self.fore_elevation, other.fore_elevation, weight),
            palm: mix(self.palm, other.palm, weight),
            wrist: mix(self.wrist, other.wrist, weight),
            fingers: mix(self.fingers, other.fingers, weight),
        }
    }
}
