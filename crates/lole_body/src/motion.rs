//! Hula basic steps as motion: settings in, a pose for every moment out.
//!
//! A [`Dance`] is built once for a skeleton and [`MotionSettings`], then asked for the pose at any
//! time. It starts in a ready stance, eases into the step during a lead-in of two counts and then
//! repeats the step for ever; all channels are continuous with their velocities, because cloth is
//! simulated on the result.
//!
//! Amplitudes and timing are compiled from public descriptions of the basics and from one
//! radiographic measurement of a dancer's hip (Komiyama et al. 2018, J Med Case Rep,
//! doi 10.1186/s13256-018-1942-2). Names, phase and amplitude differ between hālau; a kumu should
//! look at the result before it is called hula.

mod arms;
mod ease;
mod figure;
mod limbs;
mod rig;
mod settings;
mod steps;

pub use settings::{AmiTurn, ArmStyle, DanceStep, HipLead, HipLift, MotionError, MotionSettings};

use self::rig::Rig;
use crate::{Pose, Skeleton};

/// One dance step on one skeleton, ready to be asked for poses.
#[derive(Debug, Clone)]
pub struct Dance {
    settings: MotionSettings,
    rig: Rig,
    /// Height of the hip joints while standing even [m].
    standing_height: f32,
}

impl Dance {
    /// Prepares the step of `settings` for `skeleton`.
    ///
    /// # Errors
    ///
    /// [`MotionError`] if a setting is absurd or the skeleton has a limb without length.
    pub fn new(skeleton: &Skeleton, settings: &MotionSettings) -> Result<Self, MotionError> {
        settings.check()?;
        let rig = Rig::new(skeleton)?;
        let standing_height = rig.standing_height(settings);
        Ok(Self {
            settings: settings.clone(),
            rig,
            standing_height,
        })
    }

    /// Pose at `time` [s]: the ready stance up to 0, then the lead-in, then the repeated step.
    ///
    /// The loop begins at [`Dance::lead_in`]; from there on, poses repeat every
    /// [`Dance::period`]. A time that is not finite gives the ready stance.
    #[must_use]
    pub fn pose_at(&self, time: f32) -> Pose {
        if !(time.is_finite() && time > 0.0) {
            return self.stance();
        }
        let figure = steps::figure(&self.settings, self.count_at(time));
        self.rig.pose(&figure, self.standing_height)
    }

    /// Duration of one whole loop of the repeated step [s].
    #[must_use]
    pub fn period(&self) -> f32 {
        self.seconds(self.settings.dance_step.counts() as f32)
    }

    /// Duration of the lead-in [s], two counts, after which the loop begins on a beat.
    #[must_use]
    pub fn lead_in(&self) -> f32 {
        self.seconds(steps::LEAD_IN_COUNTS)
    }

    /// The ready stance, standing still.
    #[must_use]
    pub fn stance(&self) -> Pose {
        let figure = steps::stance(&self.settings);
        self.rig.pose(&figure, self.standing_height)
    }

    fn seconds(&self, counts: f32) -> f32 {
        counts * 60.0 / self.settings.beats_per_minute
    }

    /// Count of the step at `time` [s]: negative in the lead-in, then within one loop. Long dances
    /// keep their precision because the loops are taken away in `f64`.
    #[expect(
        clippy::cast_possible_truncation,
        reason = "a count within one loop is small"
    )]
    fn count_at(&self, time: f32) -> f32 {
        let beats = f64::from(time) * f64::from(self.settings.beats_per_minute) / 60.0;
        let count = beats - f64::from(steps::LEAD_IN_COUNTS);
        if count < 0.0 {
            return count as f32;
        }
        count.rem_euclid(f64::from(self.settings.dance_step.counts())) as f32
    }
}
