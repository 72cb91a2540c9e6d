//! What a tailor takes of her for a draft, beside the tape that her body is built from.

use lole_geom::Length;
use lole_language::{Words, words};

use crate::{DraftError, Measure, Measures};

/// What was taken of each of [`Tailored::ALL`] [cm]; nothing at first.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TailorTape([Option<f64>; Tailored::ALL.len()]);

impl TailorTape {
    /// Nothing was taken.
    pub const NONE: Self = Self([None; Tailored::ALL.len()]);

    /// These, with one of them anew [cm]; `None` leaves it out again.
    #[must_use]
    pub const fn with_cm(mut self, tailored: Tailored, cm: Option<f64>) -> Self {
        self.0[tailored as usize] = cm;
        self
    }

    /// One, as it was taken [cm].
    #[must_use]
    pub const fn cm(&self, tailored: Tailored) -> Option<f64> {
        self.0[tailored as usize]
    }

    /// Whether it says what a draft calls this measure.
    #[must_use]
    pub fn has(&self, measure: Measure) -> bool {
        let mut taken = Tailored::ALL.iter().zip(&self.0);
        taken.any(|(tailored, cm)| cm.is_some() && tailored.measure() == measure)
    }

    /// What a draft goes by: the measures of a body, and in their place what was taken.
    ///
    /// The front length that was not taken is longer or shorter with the back length that was: both hang from the
    /// same shoulders to the same waist.
    ///
    /// # Errors
    /// [`DraftError::Tailored`] for the first that is too far from the body's for the same person.
    pub fn over(&self, body: Measures) -> Result<Measures, DraftError> {
        let mut measures = body.clone();
        for tailored in Tailored::ALL {
            let Some(cm) = self.cm(tailored) else {
                continue;
            };
            let on_body = tailored.measure().of(&body);
            tailored.check(cm, on_body.to_cm())?;
            *tailored.measure().of_mut(&mut measures) = Length::from_cm(cm);
        }
        if self.cm(Tailored::FrontLength).is_none() {
            let longer = measures.back_length - body.back_length;
            measures.front_length = body.front_length + longer;
        }
        Ok(measures)
    }
}

/// A measure that drafts go by and no body is built from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Tailored {
    /// [`Measure::NeckGirth`].
    Neck,
    /// [`Measure::BackBreadth`].
    BackBreadth,
    /// [`Measure::ChestBreadth`].
    ChestBreadth,
    /// [`Measure::BackLength`].
    BackLength,
    /// [`Measure::FrontLength`].
    FrontLength,
    /// [`Measure::BustPointBreadth`].
    BustPoints,
    /// [`Measure::UpperArmGirth`].
    UpperArm,
    /// [`Measure::WristGirth`].
    Wrist,
    /// [`Measure::ArmLength`].
    ArmLength,
    /// [`Measure::CrotchLength`].
    CrotchLength,
    /// [`Measure::HeadGirth`].
    Head,
}

impl Tailored {
    /// All of them, in the order of the document.
    pub const ALL: [Self; 11] = [
        Self::Neck,
        Self::BackBreadth,
        Self::ChestBreadth,
        Self::BackLength,
        Self::FrontLength,
        Self::BustPoints,
        Self::UpperArm,
        Self::Wrist,
        Self::ArmLength,
        Self::CrotchLength,
        Self::Head,
    ];

    /// What a draft calls it.
    #[must_use]
    pub const fn measure(self) -> Measure {
        match self {
            Self::Neck => Measure::NeckGirth,
            Self::BackBreadth => Measure::BackBreadth,
            Self::ChestBreadth => Measure::ChestBreadth,
            Self::BackLength => Measure::BackLength,
            Self::FrontLength => Measure::FrontLength,
            Self::BustPoints => Measure::BustPointBreadth,
            Self::UpperArm => Measure::UpperArmGirth,
            Self::Wrist => Measure::WristGirth,
            Self::ArmLength => Measure::ArmLength,
            Self::CrotchLength => Measure::CrotchLength,
            Self::Head => Measure::HeadGirth,
        }
    }

    /// Key of the document's `[dancer]`.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Neck => "neck_cm",
            Self::BackBreadth => "back_breadth_cm",
            Self::ChestBreadth => "chest_breadth_cm",
            Self::BackLength => "back_length_cm",
            Self::FrontLength => "front_length_cm",
            Self::BustPoints => "bust_point_distance_cm",
            Self::UpperArm => "upper_arm_cm",
            Self::Wrist => "wrist_cm",
            Self::ArmLength => "arm_length_cm",
            Self::CrotchLength => "crotch_length_cm",
            Self::Head => "head_cm",
        }
    }

    /// What a sewing class calls it.
    #[must_use]
    pub const fn name(self) -> Words {
        match self {
            Self::Neck => words("首回り", "neck girth"),
            Self::BackBreadth => words("背幅", "back breadth"),
            Self::ChestBreadth => words("胸幅", "chest breadth"),
            Self::BackLength => words("背丈", "back length"),
            Self::FrontLength => words("前丈", "front length"),
            Self::BustPoints => words("乳間", "bust point distance"),
            Self::UpperArm => words("腕回り", "upper-arm girth"),
            Self::Wrist => words("手首回り", "wrist girth"),
            Self::ArmLength => words("袖丈", "arm length"),
            Self::CrotchLength => words("股上前後長", "crotch length"),
            Self::Head => words("頭回り", "head girth"),
        }
    }

    /// Where the tape lies.
    #[must_use]
    pub const fn how(self) -> Words {
        match self {
            Self::Neck => words(
                "首の付け根を一周。鎖骨のくぼみと首の後ろの骨を通る",
                "around the root of the neck, over the pit and the bone at the nape",
            ),
            Self::BackBreadth => words(
                "後ろで、右の腕の付け根から左の腕の付け根まで",
                "across the back, from arm to arm",
            ),
            Self::ChestBreadth => words(
                "前で、右の腕の付け根から左の腕の付け根まで",
                "across the chest, from arm to arm",
            ),
            Self::BackLength => words(
                "首の後ろの骨から、背中に沿ってウエストまで",
                "from the bone at the nape down the back to the waist",
            ),
            Self::FrontLength => words(
                "首の横から、胸の先を通ってウエストまで",
                "from the side of the neck over the bust point to the waist",
            ),
            Self::BustPoints => words(
                "胸の先から、もう片方の胸の先まで",
                "from one bust point to the other",
            ),
            Self::UpperArm => words(
                "腕の付け根のすぐ下の、いちばん太いところを一周",
                "around the fullest part, below the armpit",
            ),
            Self::Wrist => words("手首の骨の上を一周", "around the bone of the wrist"),
            Self::ArmLength => words(
                "肩先から、軽く曲げたひじを通って手首の骨まで",
                "from the shoulder point over the bent elbow to the wrist",
            ),
            Self::CrotchLength => words(
                "前のウエストから、またを通って後ろのウエストまで",
                "from the waist in front between the legs to the waist at the back",
            ),
            Self::Head => words(
                "まゆの上から、後ろのいちばん出たところを一周",
                "around the head, above the brows",
            ),
        }
    }

    /// What the key means: patterns alone go by it, because the body has nothing to turn for it.
    #[must_use]
    pub const fn about(self) -> Words {
        match self {
            Self::Neck => words(
                "首の付け根の一周。型紙だけが変わり、体の形は変わらない",
                "around the root of the neck; patterns alone go by it, the body stays",
            ),
            Self::BackBreadth => words(
                "背中で腕の付け根から付け根まで。型紙だけが変わる",
                "across the back from arm to arm; for patterns alone",
            ),
            Self::ChestBreadth => words(
                "胸で腕の付け根から付け根まで。型紙だけが変わる",
                "across the chest from arm to arm; for patterns alone",
            ),
            Self::BackLength => words(
                "首の後ろの骨からウエストまで。型紙だけが変わり、前丈を書かなければ前も同じだけ変わる",
                "nape to waist; for patterns alone, the front going with it where its length is left out",
            ),
            Self::FrontLength => words(
                "首の横から胸の先を通ってウエストまで。型紙だけが変わる",
                "side of the neck over the bust point to the waist; for patterns alone",
            ),
            Self::BustPoints => words(
                "胸の先から胸の先まで。型紙だけが変わる",
                "bust point to bust point; for patterns alone",
            ),
            Self::UpperArm => words(
                "上腕のいちばん太いところの一周。型紙だけが変わる",
                "around the fullest part of one upper arm; for patterns alone",
            ),
            Self::Wrist => words(
                "手首の一周。型紙だけが変わる",
                "around one wrist; for patterns alone",
            ),
            Self::ArmLength => words(
                "肩先からひじを通って手首まで。型紙だけが変わる",
                "shoulder point over the elbow to the wrist; for patterns alone",
            ),
            Self::CrotchLength => words(
                "前のウエストからまたを通って後ろのウエストまで。型紙だけが変わる",
                "waist between the legs to the waist; for patterns alone",
            ),
            Self::Head => words(
                "まゆの上の頭の一周。型紙だけが変わる",
                "around the head above the brows; for patterns alone",
            ),
        }
    }

    /// What anybody has [cm]: beyond it a number was typed in another unit.
    #[must_use]
    pub const fn band_cm(self) -> [f64; 2] {
        match self {
            Self::Neck => [20.0, 60.0],
            Self::BackBreadth => [16.0, 60.0],
            Self::ChestBreadth => [15.0, 60.0],
            Self::BackLength => [18.0, 60.0],
            Self::FrontLength => [20.0, 75.0],
            Self::BustPoints => [8.0, 36.0],
            Self::UpperArm => [14.0, 60.0],
            Self::Wrist => [9.0, 30.0],
            Self::ArmLength => [25.0, 80.0],
            Self::CrotchLength => [35.0, 125.0],
            Self::Head => [42.0, 75.0],
        }
    }

    /// What it can be over what a body of her tape has: beyond it one of the two was measured wrong.
    #[must_use]
    pub const fn ratio_to_body(self) -> [f64; 2] {
        match self {
            Self::UpperArm | Self::BustPoints => [0.6, 1.6],
            Self::Neck | Self::Wrist | Self::CrotchLength => [0.7, 1.5],
            Self::BackBreadth
            | Self::ChestBreadth
            | Self::BackLength
            | Self::FrontLength
            | Self::ArmLength => [0.75, 1.35],
            Self::Head => [0.8, 1.3],
        }
    }

    /// What can be taken where her body has `on_body_cm` [cm], to the millimeter.
    #[must_use]
    pub fn room_cm(self, on_body_cm: f64) -> [f64; 2] {
        let [least, most] = self.ratio_to_body();
        let [lowest, highest] = self.band_cm();
        [
            ((10.0 * least * on_body_cm).ceil() / 10.0).max(lowest),
            ((10.0 * most * on_body_cm).floor() / 10.0).min(highest),
        ]
    }

    fn check(self, cm: f64, on_body_cm: f64) -> Result<(), DraftError> {
        let [least_cm, most_cm] = self.room_cm(on_body_cm);
        if (least_cm..=most_cm).contains(&cm) {
            return Ok(());
        }
        Err(DraftError::Tailored {
            tailored: self,
            cm,
            on_body_cm,
            least_cm,
            most_cm,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_anybody_has_can_be_drafted() {
        for tailored in Tailored::ALL {
            let [least, most] = tailored.band_cm();
            let [lowest, highest] = tailored.measure().band_cm();
            assert!(lowest <= least && most <= highest, "{tailored:?}");
            let [smaller, larger] = tailored.ratio_to_body();
            assert!(smaller < 1.0 && 1.0 < larger);
        }
    }

    #[test]
    fn each_stands_at_its_place() {
        for (place, tailored) in Tailored::ALL.into_iter().enumerate() {
            assert_eq!(tailored as usize, place);
            let tape = TailorTape::NONE.with_cm(tailored, Some(20.0));
            for other in Tailored::ALL {
                assert_eq!(tape.cm(other).is_some(), other == tailored);
                assert_eq!(tape.has(other.measure()), other == tailored);
            }
            assert_eq!(tape.with_cm(tailored, None), TailorTape::NONE);
        }
    }
}
