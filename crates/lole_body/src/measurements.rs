//! The tape: measurements of a dancer, the rules that fill what was not measured, and the bands
//! outside which a number is taken for a mistake.
//!
//! Default woman and rules: means of Japanese women (AIST 1997–98, size-JPN 2004–06, JIS L 4005
//! size 9AR) for the tape a costume maker takes.

use lole_geom::{Length, trig64};
use lole_language::{Words, words};

/// Names that sentences use.
pub(crate) const STATURE: Words = words("身長", "stature");
/// See [`STATURE`].
pub(crate) const HIP_GIRTH: Words = words("ヒップ", "hip girth");

use crate::BodyError;

/// Everything the dancer is built from. Girths are convex: a tape spans hollows.
///
/// Invariant through [`Measurements::from_tape`]: every value lies in its band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measurements {
    /// Height of the crown above the floor.
    pub stature: Length,
    /// Around the fullest part of the bust.
    pub bust_girth: Length,
    /// Around the narrowest part of the trunk.
    pub waist_girth: Length,
    /// Around the fullest part of the hips.
    pub hip_girth: Length,
    /// From the crotch to the floor.
    pub inseam_length: Length,
    /// Around one thigh just below the crotch.
    pub thigh_girth: Length,
    /// Around one knee at the middle of the kneecap.
    pub knee_girth: Length,
    /// Around the fullest part of one calf.
    pub calf_girth: Length,
    /// Around one ankle at its narrowest.
    pub ankle_girth: Length,
}

/// What a tailor wrote down: any value may be missing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Tape {
    /// See [`Measurements::stature`].
    pub stature: Option<Length>,
    /// See [`Measurements::bust_girth`].
    pub bust_girth: Option<Length>,
    /// See [`Measurements::waist_girth`].
    pub waist_girth: Option<Length>,
    /// See [`Measurements::hip_girth`].
    pub hip_girth: Option<Length>,
    /// See [`Measurements::inseam_length`].
    pub inseam_length: Option<Length>,
}

/// Tape of the default woman [cm]: stature, bust, waist, hip, inseam.
const WOMAN_CM: [f64; 5] = [158.0, 83.5, 66.0, 91.0, 71.0];
/// Leg girths of the default woman [cm]: thigh, knee, calf, ankle.
const WOMAN_LEG_CM: [f64; 4] = [52.0, 34.5, 34.5, 20.5];
/// How far each leg girth follows the hip rather than the stature (exponent).
const LEG_FOLLOWS_HIP: [f64; 4] = [0.85, 0.6, 0.6, 0.35];
/// How far a trunk girth that was not measured follows those that were (exponent).
const TRUNK_FOLLOWS_TRUNK: f64 = 0.85;

/// Girths that a dancer can have [cm].
const BUST_BAND_CM: [f64; 2] = [60.0, 140.0];
const WAIST_BAND_CM: [f64; 2] = [50.0, 130.0];
const HIP_BAND_CM: [f64; 2] = [70.0, 150.0];

impl Measurements {
    /// The default woman: 158 / 83.5 / 66 / 91, inseam 71 cm.
    #[must_use]
    pub fn woman() -> Self {
        Self::fill(&Tape::default())
    }

    /// Fills what is missing and checks every value against its band.
    ///
    /// # Errors
    /// The first value outside its band, with the band.
    pub fn from_tape(tape: &Tape) -> Result<Self, BodyError> {
        let measurements = Self::fill(tape);
        measurements.check()?;
        Ok(measurements)
    }

    /// Checks every value against its band.
    ///
    /// # Errors
    /// The first value outside its band, with the band.
    pub fn check(&self) -> Result<(), BodyError> {
        let stature_cm = self.stature.to_cm();
        let hip_cm = self.hip_girth.to_cm();
        let bands = [
            (STATURE, self.stature, 130.0, 195.0),
            (
                words("ウエスト", "waist girth"),
                self.waist_girth,
                WAIST_BAND_CM[0],
                WAIST_BAND_CM[1],
            ),
            (HIP_GIRTH, self.hip_girth, HIP_BAND_CM[0], HIP_BAND_CM[1]),
            (
                words("バスト", "bust girth"),
                self.bust_girth,
                BUST_BAND_CM[0],
                BUST_BAND_CM[1],
            ),
            (
                words("この身長での股下", "inseam length at this stature"),
                self.inseam_length,
                0.40 * stature_cm,
                0.50 * stature_cm,
            ),
            (
                words("太もも回り", "thigh girth"),
                self.thigh_girth,
                0.40 * hip_cm,
                0.70 * hip_cm,
            ),
            (words("ひざ回り", "knee girth"), self.knee_girth, 24.0, 60.0),
            (
                words("ふくらはぎ回り", "calf girth"),
                self.calf_girth,
                24.0,
                60.0,
            ),
            (
                words("足首回り", "ankle girth"),
                self.ankle_girth,
                14.0,
                36.0,
            ),
        ];
        for (name, value, least_cm, most_cm) in bands {
            let value_cm = value.to_cm();
            if !(least_cm..=most_cm).contains(&value_cm) {
                return Err(BodyError::OutOfBand {
                    name,
                    value_cm,
                    least_cm,
                    most_cm,
                });
            }
        }
        Ok(())
    }

    /// Missing girths follow the mean ratio of those measured, and the stature for the rest;
    /// a missing inseam keeps the default share of the stature.
    fn fill(tape: &Tape) -> Self {
        let [stature_0, bust_0, waist_0, hip_0, inseam_0] = WOMAN_CM;
        let stature = tape.stature.map_or(stature_0, Length::to_cm);
        let tall = trig64::ln(stature / stature_0);
        let measured = [
            (tape.bust_girth, bust_0),
            (tape.waist_girth, waist_0),
            (tape.hip_girth, hip_0),
        ];
        let mut count = 0.0;
        let mut wide = 0.0;
        for (girth, default) in measured {
            if let Some(girth) = girth {
                wide += trig64::ln(girth.to_cm() / default);
                count += 1.0;
            }
        }
        let wide = if count > 0.0 { wide / count } else { tall };
        let trunk = trig64::exp(TRUNK_FOLLOWS_TRUNK * wide + (1.0 - TRUNK_FOLLOWS_TRUNK) * tall);
        let mut bands = [BUST_BAND_CM, WAIST_BAND_CM, HIP_BAND_CM].into_iter();
        let [bust, waist, hip] = measured.map(|(girth, default)| {
            // What is guessed never leaves the band: nobody could mend it.
            let [least, most] = bands.next().unwrap_or([0.0, f64::INFINITY]);
            girth.map_or((default * trunk).clamp(least, most), Length::to_cm)
        });
        let inseam = tape
            .inseam_length
            .map_or(inseam_0 * stature / stature_0, Length::to_cm);
        let leg = |index: usize| {
            let follow = LEG_FOLLOWS_HIP[index];
            let ratio = follow * trig64::ln(hip / hip_0) + (1.0 - follow) * tall;
            Length::from_cm(WOMAN_LEG_CM[index] * trig64::exp(ratio))
        };
        Self {
            stature: Length::from_cm(stature),
            bust_girth: Length::from_cm(bust),
            waist_girth: Length::from_cm(waist),
            hip_girth: Length::from_cm(hip),
            inseam_length: Length::from_cm(inseam),
            thigh_girth: leg(0),
            knee_girth: leg(1),
            calf_girth: leg(2),
            ankle_girth: leg(3),
        }
    }
}
