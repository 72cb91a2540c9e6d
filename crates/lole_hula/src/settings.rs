//! What a dance can be asked for, with units, defaults and limits.

use lole_language::Bilingual;
use thiserror::Error;

use super::choreography::Part;
use super::repertoire::DanceStep;

/// Which side of the pelvis is higher while it sways; the schools differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum HipLift {
    /// The hip goes out and up over the leg that carries the weight. It is the default, because it
    /// gives the hip adduction measured in a dancer (15° in kaʻo).
    #[default]
    WeightedSide,
    /// "Ka lewa": the hip of the free leg is lifted with its heel.
    FreeSide,
}

/// Where the hips are on the count; the schools differ. It shifts kaʻo and kāholo by one count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum HipLead {
    /// On the count the foot is placed while the hips are still over the other foot, and the
    /// weight crosses as the next foot closes (taught in Japan).
    #[default]
    OtherFoot,
    /// On the count the hips sway toward the stepping foot.
    SteppingFoot,
}

/// Direction of the ʻami circle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AmiTurn {
    /// ʻAmi ʻākau: left, back, right, front; counter-clockwise seen from above.
    #[default]
    Akau,
    /// ʻAmi hema: right, back, left, front; clockwise seen from above.
    Hema,
}

impl AmiTurn {
    /// +1 for ʻākau, −1 for hema.
    pub(super) const fn sign(self) -> f32 {
        match self {
            Self::Akau => 1.0,
            Self::Hema => -1.0,
        }
    }
}

/// What the arms do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ArmStyle {
    /// The arms that belong to the step: kāholo leads with one arm out and the other hand before
    /// the chest; kaʻo and ʻami open both arms; ʻuwehe raises the arm of the lifted foot.
    #[default]
    OfStep,
    /// Both arms softly open to the sides, a little below shoulder height.
    Open,
    /// Both hands on the waist above the skirt's band, as the basics are practiced.
    HandsOnHips,
    /// Makaʻukau: the left arm out at shoulder height with its palm down, the right hand before
    /// the chest.
    Ready,
    /// Both arms up, open in a "U".
    OpenUp,
    /// Both arms low in front with their palms up.
    LowFront,
    /// Both arms rounded in front at the height of the lower ribs.
    Rounded,
}

/// How the arms move.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ArmManner {
    /// ʻAuana: curved and always in motion.
    #[default]
    Curved,
    /// Kahiko: straighter; they arrive on the count and stop.
    Crisp,
}

/// What the hands are like.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Hands {
    /// Fingers softly together, following the wrist.
    #[default]
    Soft,
    /// Open and stretched, as women dance kahiko.
    Flat,
    /// Closed, as men dance kahiko.
    Fist,
}

/// Settings of a dance. Lengths are fractions of the stature that fits the dancer's legs, so that
/// one setting suits every body.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionSettings {
    /// The step to be danced.
    pub dance_step: DanceStep,
    /// Tempo [beats per minute], 30 to 240. 80 is a medium ʻauana.
    pub beats_per_minute: f32,
    /// Factor on the sway of the hips (shift, roll and yaw), 0 to 1.6. 1 gives the amplitudes of
    /// the sources: 7 cm and 9° to each side in kaʻo at a stature of 158 cm.
    pub sway: f32,
    /// Bend of both knees while standing even [°], 10 (tall) to 65 (kahiko ʻai haʻa). 32 is the
    /// haʻa of ʻauana. Kāholo sinks 0.012 statures deeper, or the legs could not reach.
    pub knee_degrees: f32,
    /// Which side of the pelvis is higher while it sways.
    pub hip_lift: HipLift,
    /// Where the hips are on the count.
    pub hip_lead: HipLead,
    /// Height of the free foot's heel [statures], 0 (soles stay down) to 0.03. 0.02 is 3 cm.
    pub heel_lift: f32,
    /// Side step of kāholo [statures], 0 to 0.26: how far a foot goes. 0.22, the width of the
    /// shoulders, is the most teachers allow; 0.18 (28 cm) keeps the far leg from lunging.
    pub step_width: f32,
    /// Distance between the ankles while standing [statures], 0.1 to 0.3. 0.124 leaves a woman's
    /// one fist (11 cm) between the feet; men stand at about 0.22.
    pub stance_width: f32,
    /// Turn-out of each foot [°], 0 to 30; 7 by default ("toes straight or 5 to 10° out").
    pub toe_out_degrees: f32,
    /// What the arms do.
    pub arms: ArmStyle,
    /// How the arms move.
    pub arm_manner: ArmManner,
    /// What the hands are like.
    pub hands: Hands,
    /// How much farther an elbow is opened than the step asks for where the hand lies before the chest
    /// [°], 0 to 30: room for what she wears there. 10 keeps the hand 4 cm farther away.
    pub chest_room_degrees: f32,
    /// Direction of the ʻami circle.
    pub ami_turn: AmiTurn,
    /// How far the hips go back at both ends of a sway [statures], 0 to 0.02: the figure of eight
    /// behind the navel that some schools teach. 0.008 is 1.3 cm.
    pub figure_eight: f32,
    /// A choreography. Where it has parts they are danced, once, instead of `dance_step`, and the
    /// dancer stands still afterwards.
    pub parts: Vec<Part>,
}

impl Default for MotionSettings {
    fn default() -> Self {
        Self {
            dance_step: DanceStep::Kaholo,
            beats_per_minute: 80.0,
            sway: 1.0,
            knee_degrees: 32.0,
            hip_lift: HipLift::default(),
            hip_lead: HipLead::default(),
            heel_lift: 0.02,
            step_width: 0.18,
            stance_width: 0.124,
            toe_out_degrees: 7.0,
            arms: ArmStyle::default(),
            arm_manner: ArmManner::default(),
            hands: Hands::default(),
            chest_room_degrees: 0.0,
            ami_turn: AmiTurn::default(),
            figure_eight: 0.0,
            parts: Vec::new(),
        }
    }
}

/// Why a dance cannot be made.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MotionError {
    /// A setting is not a number or outside of what a body can dance.
    #[error("motion {setting} is {value}; use a number from {lowest} to {highest}")]
    OutOfRange {
        /// Name of the field of [`MotionSettings`].
        setting: &'static str,
        /// What was given.
        value: f32,
        /// Smallest accepted value.
        lowest: f32,
        /// Largest accepted value.
        highest: f32,
    },
    /// A part of a choreography ends in the middle of a phrase.
    #[error(
        "part {part} dances {step} for {counts} counts, and its phrases have {phrase}; write a \
         multiple of {phrase}, up to {most}"
    )]
    Phrase {
        /// Number of the part, counted from 1.
        part: usize,
        /// Document name of the step.
        step: &'static str,
        /// What was given.
        counts: u32,
        /// Counts of one phrase.
        phrase: u32,
        /// Most counts of one part.
        most: u32,
    },
    /// The dancer would have to spin from one part to the next.
    #[error(
        "part {part} faces {degrees}° away from the one before; turn at most {most}° from part to \
         part, or dance a turning step"
    )]
    Turn {
        /// Number of the part, counted from 1.
        part: usize,
        /// The turn that was asked for [°].
        degrees: f32,
        /// The most [°].
        most: f32,
    },
    /// Nobody gets so far in a part.
    #[error(
        "part {part} is too short: in {counts} counts of {step} the feet carry her {most:.2} statures, and her way is \
         {way:.2}; give it {needed} counts or more, or a nearer place"
    )]
    Travel {
        /// Number of the part, counted from 1.
        part: usize,
        /// Document name of the step.
        step: &'static str,
        /// Counts of the part.
        counts: u32,
        /// The way that was asked for [statures].
        way: f32,
        /// The longest [statures].
        most: f32,
        /// Counts that it takes, in whole phrases.
        needed: u32,
    },
    /// Two joints that span a limb coincide or are not finite.
    #[error("the bone {bone} of the skeleton has no length; give its joints different places")]
    BoneWithoutLength {
        /// VRM name of the bone.
        bone: &'static str,
    },
}

impl Bilingual for MotionError {
    fn japanese(&self) -> String {
        match self {
            Self::OutOfRange {
                setting,
                value,
                lowest,
                highest,
            } => format!(
                "踊りの {setting} が {value} です。{lowest} から {highest} までの数にしてください"
            ),
            Self::Phrase {
                part,
                step,
                counts,
                phrase,
                most,
            } => format!(
                "{part} 番目の部分は {step} が {counts} 拍ですが、ひと区切りは {phrase} 拍です。\
                 {most} までの {phrase} の倍数にしてください"
            ),
            Self::Turn {
                part,
                degrees,
                most,
            } => format!(
                "{part} 番目の部分の向きが前から {degrees}° 変わります。一度に {most}° までにするか、\
                 回るステップを入れてください"
            ),
            Self::Travel {
                part,
                step,
                counts,
                way,
                most,
                needed,
            } => format!(
                "{part} 番目の部分は短すぎます。{step} の {counts} 拍で歩けるのは身長の {most:.2} 倍までで、道のりは \
                 {way:.2} 倍です。{needed} 拍以上にするか、近い場所にしてください"
            ),
            Self::BoneWithoutLength { bone } => {
                format!("骨格の {bone} の長さがありません。関節を別の位置に置いてください")
            }
        }
    }
}

impl MotionSettings {
    /// Checks every number.
    ///
    /// # Errors
    ///
    /// [`MotionError::OutOfRange`] for the first number that is not finite or outside its range.
    pub fn check(&self) -> Result<(), MotionError> {
        let ranges = [
            ("beats_per_minute", self.beats_per_minute, 30.0, 240.0),
            ("sway", self.sway, 0.0, 1.6),
            ("knee_degrees", self.knee_degrees, 10.0, 65.0),
            ("heel_lift", self.heel_lift, 0.0, 0.03),
            ("step_width", self.step_width, 0.0, 0.26),
            ("stance_width", self.stance_width, 0.1, 0.3),
            ("toe_out_degrees", self.toe_out_degrees, 0.0, 30.0),
            ("chest_room_degrees", self.chest_room_degrees, 0.0, 30.0),
            ("figure_eight", self.figure_eight, 0.0, 0.02),
        ];
        for (setting, value, lowest, highest) in ranges {
            if !(lowest..=highest).contains(&value) {
                return Err(MotionError::OutOfRange {
                    setting,
                    value,
                    lowest,
                    highest,
                });
            }
        }
        super::choreography::check(&self.parts)
    }
}
