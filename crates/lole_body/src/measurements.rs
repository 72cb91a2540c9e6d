//! The tape: measurements of a dancer, the rules that fill what was not measured, and the bands
//! outside which a number, or two together, are taken for a mistake.

mod estimate;
mod measure;
mod plausible;

use lole_geom::Length;

use crate::BodyError;

pub use measure::Measure;

/// Whose proportions a dancer has: what her tape does not say.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Figure {
    /// A child below [`Figure::CHILD_BELOW_CM`] of stature, else the women and children of the
    /// table nearest to the tape.
    #[default]
    OfStature,
    /// A grown woman.
    Woman,
    /// A grown man.
    Man,
    /// A girl or a boy, by stature.
    Child,
}

impl Figure {
    /// All figures, the default first.
    pub const ALL: [Self; 4] = [Self::OfStature, Self::Woman, Self::Man, Self::Child];

    /// A stature [cm] below which a figure that was not said is a child's.
    pub const CHILD_BELOW_CM: f64 = 140.0;

    /// Name in documents.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::OfStature => "of-stature",
            Self::Woman => "woman",
            Self::Man => "man",
            Self::Child => "child",
        }
    }

    /// [`Figure::Child`] where the stature says so, else itself.
    #[must_use]
    pub fn resolved(self, stature: Option<Length>) -> Self {
        let small = stature.is_some_and(|stature| stature.to_cm() < Self::CHILD_BELOW_CM);
        if self == Self::OfStature && small {
            Self::Child
        } else {
            self
        }
    }
}

/// Everything the dancer is built from. Girths are convex: a tape spans hollows.
///
/// A value that is `None` was not measured and follows from the measured sections: what it became
/// is read from the finished dancer, see [`Dancer::taped`](crate::Dancer::taped).
///
/// Invariant through [`Measurements::from_tape`]: every value is plausible, alone and beside the
/// others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measurements {
    /// Whose proportions.
    pub figure: Figure,
    /// Height of the crown above the floor.
    pub stature: Length,
    /// Around the fullest part of the bust.
    pub bust_girth: Length,
    /// Around the trunk under the bust.
    pub underbust_girth: Option<Length>,
    /// Around the narrowest part of the trunk.
    pub waist_girth: Length,
    /// Around the trunk over the front points of the hip bones.
    pub high_hip_girth: Option<Length>,
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
    /// From the waist tape to the floor.
    pub waist_height: Option<Length>,
    /// From shoulder point to shoulder point.
    pub shoulder_breadth: Option<Length>,
    /// From shoulder point to elbow.
    pub upper_arm_length: Option<Length>,
}

/// What a tailor wrote down: any value may be missing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Tape {
    /// See [`Measurements::figure`].
    pub figure: Figure,
    /// See [`Measurements::stature`].
    pub stature: Option<Length>,
    /// See [`Measurements::bust_girth`].
    pub bust_girth: Option<Length>,
    /// See [`Measurements::underbust_girth`].
    pub underbust_girth: Option<Length>,
    /// See [`Measurements::waist_girth`].
    pub waist_girth: Option<Length>,
    /// See [`Measurements::high_hip_girth`].
    pub high_hip_girth: Option<Length>,
    /// See [`Measurements::hip_girth`].
    pub hip_girth: Option<Length>,
    /// See [`Measurements::thigh_girth`].
    pub thigh_girth: Option<Length>,
    /// See [`Measurements::knee_girth`].
    pub knee_girth: Option<Length>,
    /// See [`Measurements::calf_girth`].
    pub calf_girth: Option<Length>,
    /// See [`Measurements::ankle_girth`].
    pub ankle_girth: Option<Length>,
    /// See [`Measurements::inseam_length`].
    pub inseam_length: Option<Length>,
    /// See [`Measurements::waist_height`].
    pub waist_height: Option<Length>,
    /// See [`Measurements::shoulder_breadth`].
    pub shoulder_breadth: Option<Length>,
    /// See [`Measurements::upper_arm_length`].
    pub upper_arm_length: Option<Length>,
}

impl Measurements {
    /// The default woman: 158 / 83.5 / 66 / 91, inseam 71 cm.
    #[must_use]
    pub fn woman() -> Self {
        estimate::fill(&Tape::default())
    }

    /// Fills what is missing and checks that the whole is plausible.
    ///
    /// # Errors
    /// The first value outside its band, or the first two that exclude each other.
    pub fn from_tape(tape: &Tape) -> Result<Self, BodyError> {
        // Before the estimates, which follow what was given wherever it leads.
        plausible::check_bands(|measure| measure.of(tape).map(Length::to_cm))?;
        let measurements = estimate::fill(tape);
        measurements.check()?;
        Ok(measurements)
    }

    /// Checks that every value is plausible, alone and beside the others.
    ///
    /// # Errors
    /// The first value outside its band, or the first two that exclude each other.
    pub fn check(&self) -> Result<(), BodyError> {
        plausible::check(self)
    }

    /// One value; `None` where it follows from the measured sections.
    #[must_use]
    pub const fn get(&self, measure: Measure) -> Option<Length> {
        match measure {
            Measure::Stature => Some(self.stature),
            Measure::Bust => Some(self.bust_girth),
            Measure::Underbust => self.underbust_girth,
            Measure::Waist => Some(self.waist_girth),
            Measure::HighHip => self.high_hip_girth,
            Measure::Hip => Some(self.hip_girth),
            Measure::Thigh => Some(self.thigh_girth),
            Measure::Knee => Some(self.knee_girth),
            Measure::Calf => Some(self.calf_girth),
            Measure::Ankle => Some(self.ankle_girth),
            Measure::Inseam => Some(self.inseam_length),
            Measure::WaistHeight => self.waist_height,
            Measure::ShoulderBreadth => self.shoulder_breadth,
            Measure::UpperArmLength => self.upper_arm_length,
        }
    }
}
