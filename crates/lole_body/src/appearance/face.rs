//! What makes one face unlike another: its features, and its age.

use lole_geom::chance::Chance;
use lole_language::{Words, words};

/// A feature of a face that may be more or less than the measured face has it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Feature {
    /// How large the eyes are.
    EyeSize,
    /// How far apart they are.
    EyeDistance,
    /// How much their outer corners are raised.
    EyeTilt,
    /// How thick the brows are.
    BrowThickness,
    /// How wide the nose is.
    NoseWidth,
    /// How high the bridge of the nose is.
    NoseBridge,
    /// How far down the tip of the nose reaches.
    NoseLength,
    /// How wide the mouth is.
    MouthWidth,
    /// How full the lips are.
    LipFullness,
    /// How full the cheeks are.
    CheekFullness,
    /// How broad the jaw is.
    JawWidth,
    /// How far down the chin reaches.
    ChinLength,
}

impl Feature {
    /// How many there are.
    pub const COUNT: usize = Self::ALL.len();
    /// All of them, from the eyes to the chin.
    pub const ALL: [Self; 12] = [
        Self::EyeSize,
        Self::EyeDistance,
        Self::EyeTilt,
        Self::BrowThickness,
        Self::NoseWidth,
        Self::NoseBridge,
        Self::NoseLength,
        Self::MouthWidth,
        Self::LipFullness,
        Self::CheekFullness,
        Self::JawWidth,
        Self::ChinLength,
    ];

    /// Its place in [`Self::ALL`].
    #[must_use]
    pub const fn index(self) -> usize {
        self as usize
    }

    /// Name in the document.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::EyeSize => "eye_size",
            Self::EyeDistance => "eye_distance",
            Self::EyeTilt => "eye_tilt",
            Self::BrowThickness => "brow_thickness",
            Self::NoseWidth => "nose_width",
            Self::NoseBridge => "nose_bridge",
            Self::NoseLength => "nose_length",
            Self::MouthWidth => "mouth_width",
            Self::LipFullness => "lip_fullness",
            Self::CheekFullness => "cheek_fullness",
            Self::JawWidth => "jaw_width",
            Self::ChinLength => "chin_length",
        }
    }

    /// What a person calls it.
    #[must_use]
    pub const fn name(self) -> Words {
        match self {
            Self::EyeSize => words("目の大きさ", "Size of the eyes"),
            Self::EyeDistance => words("目のあいだ", "Between the eyes"),
            Self::EyeTilt => words("目尻の高さ", "Outer corners of the eyes"),
            Self::BrowThickness => words("眉の太さ", "Thickness of the brows"),
            Self::NoseWidth => words("鼻の幅", "Width of the nose"),
            Self::NoseBridge => words("鼻筋の高さ", "Bridge of the nose"),
            Self::NoseLength => words("鼻の長さ", "Length of the nose"),
            Self::MouthWidth => words("口の幅", "Width of the mouth"),
            Self::LipFullness => words("唇の厚さ", "Fullness of the lips"),
            Self::CheekFullness => words("頬のふくらみ", "Fullness of the cheeks"),
            Self::JawWidth => words("あごの幅", "Width of the jaw"),
            Self::ChinLength => words("あごの長さ", "Length of the chin"),
        }
    }
}

/// How far each feature is from that of the measured face: from −1 (least) over 0 to 1 (most).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Face([f32; Feature::COUNT]);

impl Face {
    /// A face as good as any other, the same for the same seed; 0 is the measured face.
    #[must_use]
    pub fn of_seed(seed: u64) -> Self {
        if seed == 0 {
            return Self::default();
        }
        let mut chance = Chance::new(seed);
        // The mean of two is oftener near to the middle than far from it.
        Self(std::array::from_fn(|_| {
            chance.share() + chance.share() - 1.0
        }))
    }

    /// How far a feature is from that of the measured face, −1 to 1.
    #[must_use]
    pub const fn feature(&self, feature: Feature) -> f32 {
        self.0[feature.index()]
    }

    /// The same face with a feature changed, held to −1 to 1.
    #[must_use]
    pub const fn with(mut self, feature: Feature, value: f32) -> Self {
        self.0[feature.index()] = if value.is_nan() {
            0.0
        } else {
            value.clamp(-1.0, 1.0)
        };
        self
    }
}

/// How old a face looks, from 0 at 30 years to 1 at 65 and somewhat over it later.
#[must_use]
pub(crate) fn oldness(age_years: Option<f32>) -> f32 {
    age_years.map_or(0.0, |age| ((age - 30.0) / 35.0).clamp(0.0, 1.25))
}

/// Color of hair that nobody dyes at an age [years], sRGB-encoded bytes: of the usual color's hairs more and more are
/// white from the forties on.
#[must_use]
pub fn hair_srgb_at(age_years: f32, usual: [u8; 3]) -> [u8; 3] {
    /// White hair, sRGB-encoded.
    const WHITE: [f32; 3] = [207.0, 204.0, 198.0];
    let share = ((age_years - 42.0) / 38.0).clamp(0.0, 1.0);
    // Few at first, most in the sixties, hardly any dark one is left at eighty.
    let share = 0.94 * share * share * (3.0 - 2.0 * share);
    let mut mixed = usual;
    for (byte, white) in mixed.iter_mut().zip(WHITE) {
        let dark = f32::from(*byte);
        let light = dark + (white.max(dark) - dark) * share;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 0 to 255"
        )]
        {
            *byte = light.round() as u8;
        }
    }
    mixed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn features_stand_at_their_places_and_have_names_of_their_own() {
        for (index, feature) in Feature::ALL.into_iter().enumerate() {
            assert_eq!(feature.index(), index);
            let same = Feature::ALL
                .iter()
                .filter(|other| other.id() == feature.id());
            assert_eq!(same.count(), 1);
        }
    }

    #[test]
    fn seeds_are_faces_that_differ_and_repeat() {
        assert_eq!(Face::of_seed(0), Face::default());
        for seed in 1..200 {
            let face = Face::of_seed(seed);
            assert_eq!(face, Face::of_seed(seed));
            assert_ne!(face, Face::of_seed(seed + 1));
            assert!(face.0.iter().all(|value| value.abs() <= 1.0));
        }
    }

    #[test]
    fn what_is_out_of_range_is_held_to_it() {
        let face = Face::default().with(Feature::EyeTilt, 7.0);
        assert_eq!(face.feature(Feature::EyeTilt), 1.0);
        assert_eq!(face.with(Feature::EyeTilt, f32::NAN), Face::default());
    }

    #[test]
    fn hair_grows_white_and_never_dark_again() {
        let usual = [36, 27, 24];
        assert_eq!(hair_srgb_at(30.0, usual), usual);
        let ages: Vec<[u8; 3]> = (30..100)
            .map(|age| hair_srgb_at(age as f32, usual))
            .collect();
        let grows = |pair: &[[u8; 3]]| (0..3).all(|channel| pair[0][channel] <= pair[1][channel]);
        assert!(ages.windows(2).all(grows));
        assert!(180 < hair_srgb_at(85.0, usual)[1]);
    }
}
