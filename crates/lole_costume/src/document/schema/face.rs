//! Keys of the dancer's face, one row each.

use lole_body::Feature;
use lole_language::{Words, words};

use super::tables::MAX_SEED;
use super::{Key, Kind, Table};

/// A feature from least to most.
macro_rules! feature {
    ($feature:expr, $japanese:literal, $english:literal) => {
        Key {
            name: $feature.id(),
            about: words($japanese, $english),
            kind: Kind::Number {
                min: -1.0,
                max: 1.0,
                get: |design| design.face.features[$feature.index()],
                set: |design, value| design.face.features[$feature.index()] = Some(value),
            },
        }
    };
}

/// What a table of a face holds.
const ABOUT: Words = words(
    "顔立ち。どれも -1 から 1 まで、0 が測った顔",
    "features of the face, each from -1 to 1; 0 is the measured face",
);

pub(super) const FACE: Table = Table {
    name: "face",
    about: ABOUT,
    keys: &[
        Key {
            name: "seed",
            about: words(
                "顔を偶然に決める種。0 は測った顔",
                "a face by chance; 0 is the measured one",
            ),
            kind: Kind::Count {
                min: 0,
                max: MAX_SEED,
                get: |design| Some(design.face.seed).filter(|&seed| seed != 0),
                set: |design, value| design.face.seed = value,
            },
        },
        feature!(Feature::EyeSize, "目の大きさ", "how large the eyes are"),
        feature!(
            Feature::EyeDistance,
            "目と目のあいだ",
            "how far apart the eyes are"
        ),
        feature!(
            Feature::EyeTilt,
            "目尻の高さ",
            "how high the outer corners of the eyes are"
        ),
        feature!(
            Feature::BrowThickness,
            "眉の太さ",
            "how thick the brows are"
        ),
        feature!(Feature::NoseWidth, "鼻の幅", "how wide the nose is"),
        feature!(
            Feature::NoseBridge,
            "鼻筋の高さ",
            "how high the bridge of the nose is"
        ),
        feature!(Feature::NoseLength, "鼻の長さ", "how long the nose is"),
        feature!(Feature::MouthWidth, "口の幅", "how wide the mouth is"),
        feature!(Feature::LipFullness, "唇の厚さ", "how full the lips are"),
        feature!(
            Feature::CheekFullness,
            "頬のふくらみ",
            "how full the cheeks are"
        ),
        feature!(Feature::JawWidth, "あごの幅", "how broad the jaw is"),
        feature!(Feature::ChinLength, "あごの長さ", "how long the chin is"),
    ],
};
