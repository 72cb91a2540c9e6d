//! What the body is asked to do at one moment, before joints are solved.
//!
//! A figure is plain numbers so that two figures can be mixed and a right half be mirrored into a
//! left half. Lengths are in statures, angles in degrees; `[left, right]` for paired limbs.

use lole_geom::trig;

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
    /// Bow of the head toward the floor [°].
    pub nod: f32,
}

/// Target of the pelvis, at the middle between the hip joints.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Pelvis {
    /// Where the whole body is along `+X` [statures]; shoulders and head go there too.
    pub travel: f32,
    /// Where the whole body is along `+Z` [statures].
    pub ahead: f32,
    /// Where the whole body faces: to the left of `+Z` [°]. What follows is seen from there.
    pub heading: f32,
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
    /// Lean of the upper body to the left [°].
    pub lean: f32,
}

/// Target of one foot. A foot with `heel > 0` stands on its ball, which stays where it was flat.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Foot {
    /// Where the ankle would be along `+X` were the sole flat and not twisted [statures].
    pub x: f32,
    /// Where it would be along `+Z` [statures], from the line on which the ankles stand.
    pub z: f32,
    /// Where the body faced when the foot was set down: to the left of `+Z` [°].
    pub heading: f32,
    /// Turn of the foot about its ball since then, to the left [°].
    pub twist: f32,
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
    /// How far the arm leaves all that and puts its hand on the waist, 0 to 1.
    pub on_waist: f32,
}

/// A place on the floor and where a body faces there.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Place {
    /// Along `+X` [statures].
    pub x: f32,
    /// Along `+Z` [statures].
    pub z: f32,
    /// To the left of `+Z` [°].
    pub heading: f32,
}

impl Place {
    /// A point [statures] of this place's own axes, on the floor.
    pub(super) fn point(&self, [x, z]: [f32; 2]) -> [f32; 2] {
        let [x, z] = turned([x, z], self.heading);
        [self.x + x, self.z + z]
    }

    /// A foot of this place's own axes, on the floor.
    pub(super) fn foot(&self, foot: Foot) -> Foot {
        let [x, z] = self.point([foot.x, foot.z]);
        Foot {
            x,
            z,
            heading: self.heading + foot.heading,
            ..foot
        }
    }
}

/// A floor vector turned to the left by `heading` [°].
pub(super) fn turned([x, z]: [f32; 2], heading: f32) -> [f32; 2] {
    let (sin, cos) = trig::sin_cos(heading.to_radians());
    [x * cos + z * sin, z * cos - x * sin]
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
            nod: mix(self.nod, other.nod, weight),
        }
    }

    /// The figure seen in a mirror that stands in the middle of the body.
    pub(super) fn mirrored(&self) -> Self {
        Self {
            pelvis: self.pelvis.mirrored(),
            feet: [self.feet[1].mirrored(0.0), self.feet[0].mirrored(0.0)],
            arms: [self.arms[1], self.arms[0]],
            gaze: -self.gaze,
            nod: self.nod,
        }
    }

    /// The body of this figure at a place on the floor; its feet stay where they are.
    pub(super) fn placed(&self, place: &Place) -> Self {
        let [travel, ahead] = place.point([self.pelvis.travel, self.pelvis.ahead]);
        Self {
            pelvis: Pelvis {
                travel,
                ahead,
                heading: place.heading + self.pelvis.heading,
                ..self.pelvis
            },
            ..*self
        }
    }
}

impl Pelvis {
    fn mixed(&self, other: &Self, weight: f32) -> Self {
        Self {
            travel: mix(self.travel, other.travel, weight),
            ahead: mix(self.ahead, other.ahead, weight),
            heading: mix(self.heading, other.heading, weight),
            x: mix(self.x, other.x, weight),
            z: mix(self.z, other.z, weight),
            drop: mix(self.drop, other.drop, weight),
            roll: mix(self.roll, other.roll, weight),
            yaw: mix(self.yaw, other.yaw, weight),
            tilt: mix(self.tilt, other.tilt, weight),
            lean: mix(self.lean, other.lean, weight),
        }
    }

    fn mirrored(&self) -> Self {
        Self {
            travel: -self.travel,
            heading: -self.heading,
            x: -self.x,
            roll: -self.roll,
            yaw: -self.yaw,
            lean: -self.lean,
            ..*self
        }
    }
}

impl Foot {
    /// Mixture of two feet: `self` at weight 0, `other` at weight 1.
    pub(super) fn mixed(&self, other: &Self, weight: f32) -> Self {
        Self {
            x: mix(self.x, other.x, weight),
            z: mix(self.z, other.z, weight),
            heading: mix(self.heading, other.heading, weight),
            twist: mix(self.twist, other.twist, weight),
            lift: mix(self.lift, other.lift, weight),
            heel: mix(self.heel, other.heel, weight),
            turn_out: mix(self.turn_out, other.turn_out, weight),
            knee_out: mix(self.knee_out, other.knee_out, weight),
        }
    }

    /// The other foot in a mirror that carries 0 to `x` [statures].
    pub(super) fn mirrored(&self, x: f32) -> Self {
        Self {
            x: x - self.x,
            heading: -self.heading,
            twist: -self.twist,
            ..*self
        }
    }

    /// Where the toes point, to the left of `+Z` [°]; `side` is +1 for the left foot, −1 for the
    /// right one.
    pub(super) fn yaw(&self, side: f32) -> f32 {
        self.heading + self.twist + side * self.turn_out
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
            on_waist: mix(self.on_waist, other.on_waist, weight),
        }
    }
}
