//! Hula basic steps as motion: settings in, a pose for every moment out.
//!
//! A [`Dance`] is built once for a skeleton and [`MotionSettings`], then asked for the pose at any
//! time. It starts in a ready stance and eases into its first step during a lead-in of two counts.
//! Then it repeats one step for ever, or dances the parts of a choreography one after the other and
//! comes to rest. All channels are continuous with their velocities, because cloth is simulated on
//! the result.
//!
//! Each step is a score, plain data with its sources, one file in `repertoire/`. Amplitudes and
//! timing are compiled from public descriptions of the basics and from one radiographic measurement
//! of a dancer's hip (Komiyama et al. 2018, J Med Case Rep, doi 10.1186/s13256-018-1942-2). Names,
//! phase and amplitude differ between hālau; a kumu should look at the result before it is called
//! hula.

mod arms;
mod choreography;
mod ease;
mod figure;
mod formation;
mod limbs;
mod plan;
mod repertoire;
mod rig;
mod schools;
mod score;
mod segment;
mod settings;
mod sources;
mod steps;
mod tempo;

pub use choreography::{Count, Part};
pub use formation::{Formation, assign_places};
pub use lole_body::Side;
pub use repertoire::{DanceStep, Statement};
pub use schools::{SCHOOLS, School};
pub use settings::{
    AmiTurn, ArmManner, ArmStyle, Hands, HipLead, HipLift, MotionError, MotionSettings,
};
pub use sources::{SOURCES, Source};

use lole_body::{Pose, Skeleton};
use lole_geom::narrow;

use self::plan::Plan;
use self::rig::Rig;
use self::tempo::Tempo;

/// A dance on one skeleton, ready to be asked for poses.
#[derive(Debug, Clone)]
pub struct Dance {
    settings: MotionSettings,
    rig: Rig,
    plan: Plan,
    tempo: Tempo,
    /// Height of the hip joints while standing even [m].
    standing_height: f32,
}

/// Counts that are said after the last part, while the dancer comes to rest.
const ENDING_COUNTS: u32 = 2;

impl Dance {
    /// Prepares the dance of `settings` for `skeleton`.
    ///
    /// # Errors
    ///
    /// [`MotionError`] if a setting or a part is absurd or the skeleton has a limb without length.
    pub fn new(skeleton: &Skeleton, settings: &MotionSettings) -> Result<Self, MotionError> {
        settings.check()?;
        let rig = Rig::new(skeleton)?;
        let plan = Plan::new(settings, rig.to_balls());
        // One height for the whole dance, so that the head keeps its own.
        let standing_height = (plan.readings())
            .map(|reading| rig.standing_height(settings, reading.score))
            .fold(f32::INFINITY, f32::min);
        Ok(Self {
            tempo: tempo_of(settings),
            settings: settings.clone(),
            rig,
            plan,
            standing_height,
        })
    }

    /// Stature of the dancer by her legs [m], in which lengths of settings are counted.
    #[must_use]
    pub const fn stature(&self) -> f32 {
        self.rig.stature()
    }

    /// Pose at `time` [s]: the ready stance up to 0, then the lead-in, then the dance.
    ///
    /// A repeated step begins at [`Dance::lead_in`]; from there on, poses repeat every
    /// [`Dance::period`]. A time that is not finite gives the ready stance.
    #[must_use]
    pub fn pose_at(&self, time: f32) -> Pose {
        if !(time.is_finite() && time > 0.0) {
            return self.stance();
        }
        let figure = self.plan.figure(self.tempo.count_at(f64::from(time)));
        self.rig.pose(&figure, self.standing_height)
    }

    /// Duration of one whole loop of the repeated step, or of all parts [s].
    #[must_use]
    pub fn period(&self) -> f32 {
        if self.settings.parts.is_empty() {
            return self.seconds(self.settings.dance_step.counts() as f32);
        }
        let counts: u32 = self.settings.parts.iter().map(|part| part.counts).sum();
        let lead_in = f64::from(steps::LEAD_IN_COUNTS);
        let time = self.tempo.time_of(lead_in + f64::from(counts)) - self.tempo.time_of(lead_in);
        narrow(time)
    }

    /// Duration of the lead-in [s], two counts, after which the first step begins on a beat.
    #[must_use]
    pub fn lead_in(&self) -> f32 {
        if self.settings.parts.is_empty() {
            return self.seconds(steps::LEAD_IN_COUNTS);
        }
        narrow(self.tempo.time_of(f64::from(steps::LEAD_IN_COUNTS)))
    }

    /// Duration of the whole dance with its lead-in and its ending [s]; `None` for a step that is
    /// repeated for ever.
    #[must_use]
    pub fn duration(&self) -> Option<f64> {
        if self.settings.parts.is_empty() {
            return None;
        }
        let parts: u32 = self.settings.parts.iter().map(|part| part.counts).sum();
        let counts = f64::from(steps::LEAD_IN_COUNTS) + f64::from(parts + ENDING_COUNTS);
        Some(self.tempo.time_of(counts))
    }

    /// Beats since the dance began to be counted, lead-in included, at `time` [s].
    #[must_use]
    pub fn beat_at(&self, time: f64) -> f64 {
        self.tempo.count_at(time)
    }

    /// Time [s] of a beat, as [`Dance::beat_at`] counts them.
    #[must_use]
    pub fn time_of_beat(&self, beat: f64) -> f64 {
        self.tempo.time_of(beat)
    }

    /// When every count up to `until` [s] falls, the lead-in and the ending included.
    ///
    /// A part's count 1 is the beat after the one on which the part before ends.
    #[must_use]
    pub fn counts(&self, until: f64) -> Vec<Count> {
        let mut counts = Vec::new();
        let mut beat = 0_u32;
        let mut say = |part, number, step, side| {
            let time = self.tempo.time_of(f64::from(beat));
            let within = time <= until;
            if within {
                counts.push(Count {
                    time,
                    part,
                    number,
                    step,
                    side,
                    beats_per_minute: self.tempo.bpm_at(f64::from(beat)),
                });
            }
            beat += 1;
            within
        };
        // The lead-in is said from the first beat on; its last beat is the one a part begins on.
        let repeated = self.settings.parts.is_empty();
        let step = self.settings.dance_step;
        for number in 1..=if repeated { 2 + step.first_count() } else { 3 } {
            say(None, number, None, Side::Right);
        }
        for (index, part) in (1..).zip(&self.settings.parts) {
            for number in 1..=part.counts {
                say(Some(index), number, Some(part.step), part.side);
            }
        }
        if repeated {
            let mut number = 0;
            while say(Some(1), number % step.counts() + 1, Some(step), Side::Right) {
                number += 1;
            }
        } else {
            for number in 1..=ENDING_COUNTS {
                say(None, number, None, Side::Right);
            }
        }
        counts
    }

    /// The ready stance, standing still.
    #[must_use]
    pub fn stance(&self) -> Pose {
        self.rig.pose(&self.plan.stance(), self.standing_height)
    }

    fn seconds(&self, counts: f32) -> f32 {
        counts * 60.0 / self.settings.beats_per_minute
    }
}

/// When the counts of a dance fall.
fn tempo_of(settings: &MotionSettings) -> Tempo {
    let first = settings.parts.first();
    let bpm = first.and_then(|part| part.beats_per_minute);
    let mut tempo = Tempo::even(bpm.unwrap_or(settings.beats_per_minute));
    let mut count = f64::from(steps::LEAD_IN_COUNTS);
    for part in &settings.parts {
        let counts = f64::from(part.counts);
        if let Some(bpm) = part.beats_per_minute {
            tempo.change(count, counts, bpm);
        }
        count += counts;
    }
    tempo
}
