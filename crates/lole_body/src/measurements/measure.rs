//! The fourteen measures of a dancer's tape: what each is called and where it stands.

use lole_geom::Length;
use lole_language::{Words, words};

use super::Tape;

/// One measure of the tape.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Measure {
    /// Crown above the floor.
    Stature,
    /// Girth of the fullest part of the bust.
    Bust,
    /// Girth under the bust.
    Underbust,
    /// Girth of the narrowest part of the trunk.
    Waist,
    /// Girth over the front points of the hip bones.
    HighHip,
    /// Girth of the fullest part of the hips.
    Hip,
    /// Girth of one thigh just below the crotch.
    Thigh,
    /// Girth of one knee at the middle of the kneecap.
    Knee,
    /// Girth of the fullest part of one calf.
    Calf,
    /// Girth of one ankle at its narrowest.
    Ankle,
    /// Crotch above the floor.
    Inseam,
    /// Waist tape above the floor.
    WaistHeight,
    /// From shoulder point to shoulder point (biacromial breadth).
    ShoulderBreadth,
    /// From shoulder point to elbow.
    UpperArmLength,
}

impl Measure {
    /// All measures, in the order of the document.
    pub const ALL: [Self; 14] = [
        Self::Stature,
        Self::Bust,
        Self::Underbust,
        Self::Waist,
        Self::HighHip,
        Self::Hip,
        Self::Thigh,
        Self::Knee,
        Self::Calf,
        Self::Ankle,
        Self::Inseam,
        Self::WaistHeight,
        Self::ShoulderBreadth,
        Self::UpperArmLength,
    ];

    /// Key of the document's `[dancer]`.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Stature => "stature_cm",
            Self::Bust => "bust_cm",
            Self::Underbust => "underbust_cm",
            Self::Waist => "waist_cm",
            Self::HighHip => "high_hip_cm",
            Self::Hip => "hip_cm",
            Self::Thigh => "thigh_cm",
            Self::Knee => "knee_cm",
            Self::Calf => "calf_cm",
            Self::Ankle => "ankle_cm",
            Self::Inseam => "inseam_cm",
            Self::WaistHeight => "waist_height_cm",
            Self::ShoulderBreadth => "shoulder_breadth_cm",
            Self::UpperArmLength => "upper_arm_length_cm",
        }
    }

    /// What sentences call it.
    #[must_use]
    pub const fn words(self) -> Words {
        match self {
            Self::Stature => words("身長", "stature"),
            Self::Bust => words("バスト", "bust girth"),
            Self::Underbust => words("アンダーバスト", "underbust girth"),
            Self::Waist => words("ウエスト", "waist girth"),
            Self::HighHip => words("腰骨回り", "high hip girth"),
            Self::Hip => words("ヒップ", "hip girth"),
            Self::Thigh => words("太もも回り", "thigh girth"),
            Self::Knee => words("ひざ回り", "knee girth"),
            Self::Calf => words("ふくらはぎ回り", "calf girth"),
            Self::Ankle => words("足首回り", "ankle girth"),
            Self::Inseam => words("股下", "inseam length"),
            Self::WaistHeight => words("ウエストの高さ", "waist height"),
            Self::ShoulderBreadth => words("肩幅", "shoulder breadth"),
            Self::UpperArmLength => words("上腕の長さ", "upper-arm length"),
        }
    }

    /// Least and most of it that a dancer has [cm]; wide enough for every body.
    #[must_use]
    pub const fn band_cm(self) -> [f64; 2] {
        super::plausible::band_cm(self)
    }

    /// What the tailor wrote down for it.
    #[must_use]
    pub const fn of(self, tape: &Tape) -> Option<Length> {
        match self {
            Self::Stature => tape.stature,
            Self::Bust => tape.bust_girth,
            Self::Underbust => tape.underbust_girth,
            Self::Waist => tape.waist_girth,
            Self::HighHip => tape.high_hip_girth,
            Self::Hip => tape.hip_girth,
            Self::Thigh => tape.thigh_girth,
            Self::Knee => tape.knee_girth,
            Self::Calf => tape.calf_girth,
            Self::Ankle => tape.ankle_girth,
            Self::Inseam => tape.inseam_length,
            Self::WaistHeight => tape.waist_height,
            Self::ShoulderBreadth => tape.shoulder_breadth,
            Self::UpperArmLength => tape.upper_arm_length,
        }
    }
}
