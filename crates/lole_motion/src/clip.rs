//! A recorded dance as a dancer's own: poses, sixty a second, for every moment.

use lole_body::{Dancer, Pose, Skeleton};

use crate::feet::{Planting, plant};
use crate::repeat::{self, Loop};
use crate::retarget::Retarget;
use crate::room::Room;
use crate::{BoneMap, Recording, RecordingError};

/// Poses per second of a clip, the rate of the product's frames.
pub(crate) const POSES_PER_SECOND: f32 = 60.0;
/// Longest dance that is taken over [s].
const LONGEST: f64 = 1200.0;
/// Time in which the clip comes up to its speed [s], and in which it slows down at its end: cloth
/// at rest would be thrown off by a dancer who is at full speed at once.
const EASE: f32 = 0.6;

/// What follows the last pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Repeat {
    /// She stands in it.
    #[default]
    Once,
    /// The part of the recording that comes back best to where it began, over and over.
    Loop,
}

/// What becomes of the way that the dancer goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Drift {
    /// She goes it.
    #[default]
    Keep,
    /// The straight line from the first place to the last is taken away. What loops has none.
    Remove,
}

/// How a recording is taken over.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ClipSettings {
    /// What follows the last pose.
    pub repeat: Repeat,
    /// What becomes of the way that the dancer goes.
    pub drift: Drift,
}

/// A recorded dance on one skeleton, ready to be asked for poses.
#[derive(Debug, Clone)]
pub struct Clip {
    poses: Vec<Pose>,
    found: Option<Loop>,
}

impl Clip {
    /// Takes a recording over to `skeleton`.
    ///
    /// Bones of the limbs point where the recording's point, whatever its rest pose; the trunk
    /// turns as the recording's turns from rest. Ways are scaled by the length of the legs. Feet
    /// that stand in the recording stand still on the floor, and none goes below it: legs are bent
    /// to reach. The dancer begins over the origin and faces the front.
    ///
    /// # Errors
    /// A recording without frames, without bones that have a length, or longer than twenty minutes.
    pub fn retarget(
        recording: &Recording,
        map: &BoneMap,
        skeleton: &Skeleton,
        settings: ClipSettings,
    ) -> Result<Self, RecordingError> {
        if LONGEST < recording.duration() {
            return Err(RecordingError::TooLarge {
                what: "frames",
                count: recording.frame_count(),
                limit: whole(LONGEST / recording.frame_seconds),
            });
        }
        let retarget = Retarget::new(recording, map, skeleton)?;
        let mut poses: Vec<Pose> = (0..retarget.pose_count())
            .map(|pose| retarget.pose(pose))
            .collect();
        let found = match settings.repeat {
            Repeat::Once => None,
            Repeat::Loop => repeat::find(&poses, skeleton),
        };
        let drift = match (found, settings.drift) {
            (Some(found), _) => found.cut(&mut poses),
            (None, Drift::Remove) => repeat::remove_drift(&mut poses),
            (None, Drift::Keep) => glam::Vec3::ZERO,
        };
        let planting = Planting {
            skeleton,
            drift,
            closed: found.is_some(),
        };
        plant(&mut poses, &planting);
        Ok(Self { poses, found })
    }

    /// A dance of poses, sixty a second, after which she stands in the last one.
    #[must_use]
    pub const fn of_poses(poses: Vec<Pose>) -> Self {
        Self { poses, found: None }
    }

    /// The dance with arms that would hang in a skirt's folds brought out of them.
    #[must_use]
    pub fn clear_of_skirt(mut self, dancer: &Dancer) -> Self {
        if let Some(room) = Room::of(dancer) {
            for pose in &mut self.poses {
                room.clear(pose);
            }
        }
        self
    }

    /// Pose at `time` [s]: the first one up to 0, then the recording, which takes
    /// [`Self::lead_in`] to come up to its speed. A time that is not finite gives the first pose.
    #[must_use]
    pub fn pose_at(&self, time: f32) -> Pose {
        let Some(last) = self.poses.len().checked_sub(1) else {
            return Pose::default();
        };
        if !(time.is_finite() && 0.0 < time) {
            return self.poses[0].clone();
        }
        // The speed grows evenly from 0 to 1.
        let eased = if time < EASE {
            0.5 * time * time / EASE
        } else {
            time - 0.5 * EASE
        };
        let place = f64::from(eased) * f64::from(POSES_PER_SECOND);
        let (place, count) = if self.found.is_some() {
            (place.rem_euclid(self.poses.len() as f64), self.poses.len())
        } else {
            (slowed(place, last as f64), last + 1)
        };
        let first = whole(place).min(count - 1);
        let next = if self.found.is_some() {
            (first + 1) % count
        } else {
            (first + 1).min(last)
        };
        #[expect(clippy::cast_possible_truncation, reason = "a share of a frame")]
        let share = (place - first as f64) as f32;
        mixed(&self.poses[first], &self.poses[next], share.clamp(0.0, 1.0))
    }

    /// Time until the recording is danced at its own speed [s].
    #[must_use]
    pub const fn lead_in(&self) -> f32 {
        EASE
    }

    /// Length of the dance, or of one round of it [s].
    #[must_use]
    pub fn duration(&self) -> f32 {
        let intervals = self.poses.len() - usize::from(self.found.is_none());
        intervals as f32 / POSES_PER_SECOND
    }

    /// The poses, sixty a second, as they were recorded: without the easing of [`Self::pose_at`].
    #[must_use]
    pub fn poses(&self) -> &[Pose] {
        &self.poses
    }
}

/// A place on the way to `last` that is reached evenly and left slower and slower, without ever
/// passing it: the last [`EASE`] takes twice its time.
fn slowed(place: f64, last: f64) -> f64 {
    let ease = (f64::from(EASE) * f64::from(POSES_PER_SECOND) * 0.5).min(last);
    let beyond = place - (last - ease);
    if beyond <= 0.0 {
        return place;
    }
    // From speed 1 to 0 in 2·ease.
    let rest = (2.0 * ease - beyond).max(0.0);
    last - rest * rest / (4.0 * ease.max(f64::MIN_POSITIVE))
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "places within a clip are small and not negative"
)]
pub(crate) fn whole(place: f64) -> usize {
    place.max(0.0) as usize
}

/// Pose between two: `a` at share 0, `b` at 1.
pub(crate) fn mixed(a: &Pose, b: &Pose, share: f32) -> Pose {
    let rotations = a.rotations.iter().zip(&b.rotations);
    Pose {
        hips_translation: a.hips_translation.lerp(b.hips_translation, share),
        rotations: rotations.map(|(a, b)| a.slerp(*b, share)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::slowed;

    #[test]
    fn the_end_is_reached_without_a_jolt() {
        let last = 100.0;
        let mut before = 0.0;
        for i in 1..3000 {
            let place = slowed(0.1 * f64::from(i), last);
            let step = place - before;
            assert!((0.0..=0.1 + 1e-9).contains(&step), "{step}");
            before = place;
        }
        assert!((before - last).abs() < 1e-9);
    }
}
