//! Parts danced one after the other, as a choreographer writes them down, and when counts fall.

use lole_body::Side;

use super::repertoire::DanceStep;
use super::settings::{ArmStyle, MotionError};

/// Most counts of one part.
pub(super) const MOST_COUNTS: u32 = 256;
/// Most the dancer turns from one part to the next [°].
const MOST_TURN: f32 = 180.0;

/// One part of a choreography.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Part {
    /// What is danced.
    pub step: DanceStep,
    /// Which side begins.
    pub side: Side,
    /// How many counts: whole phrases of the step ([`DanceStep::phrase`]), at most 256.
    pub counts: u32,
    /// Where the dancer faces, to her left of the front [°]; at most 180 away from the part before.
    pub facing_degrees: f32,
    /// What the arms do; what the settings say when `None`.
    pub arms: Option<ArmStyle>,
    /// Tempo from here on [counts per minute], reached within two counts; as before when `None`.
    pub beats_per_minute: Option<f32>,
    /// How far she gets in this part besides what its step does, to her left and ahead as she faces the front
    /// [statures]: every foot lands so much farther.
    pub travel: [f32; 2],
}

impl Part {
    /// `counts` of a step to the right, facing the front.
    #[must_use]
    pub const fn new(step: DanceStep, counts: u32) -> Self {
        Self {
            step,
            side: Side::Right,
            counts,
            facing_degrees: 0.0,
            arms: None,
            beats_per_minute: None,
            travel: [0.0; 2],
        }
    }
}

/// Checks what each part asks for.
pub(super) fn check(parts: &[Part]) -> Result<(), MotionError> {
    let mut facing = 0.0;
    for (number, part) in (1..).zip(parts) {
        let phrase = part.step.phrase();
        if part.counts == 0 || !part.counts.is_multiple_of(phrase) || MOST_COUNTS < part.counts {
            return Err(MotionError::Phrase {
                part: number,
                step: part.step.id(),
                counts: part.counts,
                phrase,
                most: MOST_COUNTS / phrase * phrase,
            });
        }
        let degrees = part.facing_degrees - facing;
        if !(-MOST_TURN..=MOST_TURN).contains(&degrees) {
            return Err(MotionError::Turn {
                part: number,
                degrees,
                most: MOST_TURN,
            });
        }
        facing = part.facing_degrees;
        check_travel(number, part)?;
        let bpm = part.beats_per_minute.unwrap_or(60.0);
        if !(30.0..=240.0).contains(&bpm) {
            return Err(MotionError::OutOfRange {
                setting: "beats_per_minute",
                value: bpm,
                lowest: 30.0,
                highest: 240.0,
            });
        }
    }
    Ok(())
}

/// Checks that feet get where a part goes.
fn check_travel(number: usize, part: &Part) -> Result<(), MotionError> {
    let [left, ahead] = part.travel;
    let way = (left * left + ahead * ahead).sqrt();
    if way == 0.0 {
        return Ok(());
    }
    let most = part.step.longest_way(part.counts);
    if way.is_finite() && way <= most {
        return Ok(());
    }
    Err(MotionError::Travel {
        part: number,
        step: part.step.id(),
        counts: part.counts,
        way,
        most,
        needed: part.step.counts_for(way),
    })
}

/// One count of a dance, for whoever plays the music.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Count {
    /// When it falls [s].
    pub time: f64,
    /// Number of the part, counted from 1; `None` in the lead-in and at the end, where nothing but
    /// the beat goes on.
    pub part: Option<usize>,
    /// Number of the count within its part or lead-in, counted from 1.
    pub number: u32,
    /// What is danced.
    pub step: Option<DanceStep>,
    /// Which side begins.
    pub side: Side,
    /// Counts per minute.
    pub beats_per_minute: f64,
}
