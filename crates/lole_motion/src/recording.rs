//! A recording as files hold it: a tree of joints and what they do, frame by frame.

use glam::{Quat, Vec3};

use crate::clip::whole;

/// One joint of a recorded skeleton.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Name in the file; empty for the end of a bone that has no joint of its own.
    pub name: String,
    /// The joint it hangs on, which stands before it; `None` for a root.
    pub parent: Option<usize>,
    /// Place in the parent's space while at rest [file units].
    pub translation: Vec3,
    /// Turn relative to the parent while at rest.
    pub rotation: Quat,
    /// Channels that move it.
    pub channel_count: u8,
}

/// A joint in the recording's world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointPlace {
    /// Where [file units].
    pub position: Vec3,
    /// Turn from the joint's own axes to the recording's.
    pub rotation: Quat,
}

/// Joints and their motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    /// Parents before children.
    pub joints: Vec<Joint>,
    /// Time from one frame to the next [s].
    pub frame_seconds: f64,
    /// Turn of each joint relative to its parent, shape `[frame_count, joints.len()]`.
    pub rotations: Vec<Quat>,
    /// Place of each joint in its parent's space [file units], of the same shape.
    pub translations: Vec<Vec3>,
}

impl Recording {
    /// Number of frames.
    #[must_use]
    pub fn frame_count(&self) -> usize {
        self.rotations
            .len()
            .checked_div(self.joints.len())
            .unwrap_or(0)
    }

    /// Time from the first frame to the last [s].
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.frame_count().saturating_sub(1) as f64 * self.frame_seconds
    }

    /// Every joint at rest, shape `[joints.len()]`.
    #[must_use]
    pub fn rest_places(&self) -> Vec<JointPlace> {
        let mut places = Vec::with_capacity(self.joints.len());
        for joint in &self.joints {
            let place = self.placed(&places, joint.parent, joint.translation, joint.rotation);
            places.push(place);
        }
        places
    }

    /// Every joint in one frame; a frame beyond the last is the last.
    #[must_use]
    pub fn places(&self, frame: usize) -> Vec<JointPlace> {
        let count = self.joints.len();
        let start = frame.min(self.frame_count().saturating_sub(1)) * count;
        let mut places = Vec::with_capacity(count);
        for (index, joint) in self.joints.iter().enumerate() {
            let (translation, rotation) = (
                self.translations[start + index],
                self.rotations[start + index],
            );
            let place = self.placed(&places, joint.parent, translation, rotation);
            places.push(place);
        }
        places
    }

    /// Every joint between two frames; a place beyond the last frame is the last.
    #[must_use]
    pub fn places_between(&self, frame: f64) -> Vec<JointPlace> {
        let last = self.frame_count().saturating_sub(1);
        let first = whole(frame).min(last);
        let next = (first + 1).min(last);
        #[expect(clippy::cast_possible_truncation, reason = "a share of a frame")]
        let share = (frame - first as f64).clamp(0.0, 1.0) as f32;
        let count = self.joints.len();
        let mut places = Vec::with_capacity(count);
        for (index, joint) in self.joints.iter().enumerate() {
            let [a, b] = [first, next].map(|frame| frame * count + index);
            let translation = self.translations[a].lerp(self.translations[b], share);
            let rotation = self.rotations[a].slerp(self.rotations[b], share);
            let place = self.placed(&places, joint.parent, translation, rotation);
            places.push(place);
        }
        places
    }

    fn placed(
        &self,
        places: &[JointPlace],
        parent: Option<usize>,
        translation: Vec3,
        rotation: Quat,
    ) -> JointPlace {
        debug_assert!(places.len() < self.joints.len());
        match parent.and_then(|parent| places.get(parent)) {
            Some(parent) => JointPlace {
                position: parent.position + parent.rotation * translation,
                rotation: (parent.rotation * rotation).normalize(),
            },
            None => JointPlace {
                position: translation,
                rotation,
            },
        }
    }

    /// Joints that hang on `joint`.
    pub fn children(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        let joints = self.joints.iter().enumerate();
        joints
            .filter(move |(_, child)| child.parent == Some(joint))
            .map(|(index, _)| index)
    }

    /// `joint` and what it hangs on, up to the root.
    pub fn ancestors(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(Some(joint), |&at| self.joints[at].parent)
    }

    /// Whether the first frame is a stance for calibration and not yet the dance: most joints lie
    /// at rest there to the last digit, and no longer in the second frame.
    ///
    /// Conversions of the CMU recordings begin so, and a leap from it to the dance would throw the
    /// cloth off.
    #[must_use]
    pub fn begins_with_a_stance(&self) -> bool {
        let count = self.joints.len();
        if self.frame_count() < 3 {
            return false;
        }
        let resting = |frame: usize| {
            let turns = &self.rotations[frame * count..(frame + 1) * count];
            let moving = self.joints.iter().zip(turns);
            moving
                .filter(|(joint, _)| joint.channel_count > 0)
                .filter(|(joint, turn)| joint.rotation.dot(**turn).abs() > 0.999_999_9)
                .count()
        };
        let moved = self.joints.iter().filter(|joint| joint.channel_count > 0);
        let moved = moved.count();
        resting(0) * 5 >= moved * 4 && resting(1) * 2 < moved
    }
}
