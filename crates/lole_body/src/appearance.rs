//! How a dancer looks: her hair, its color, her skin's and her leotard's.

mod face;
mod hair;
mod hair_paint;

pub(crate) use face::oldness;
pub use face::{Face, Feature, hair_srgb_at};
pub(crate) use hair::{add_drawn_hair, add_hair};

use crate::{Dancer, Figure};
use lole_language::{Words, words};

/// Color of bare skin unless another is chosen, sRGB-encoded bytes.
pub const SKIN_SRGB: [u8; 3] = [222, 178, 148];
/// Color of the leotard unless another is chosen, sRGB-encoded bytes.
pub const LEOTARD_SRGB: [u8; 3] = [38, 36, 44];
/// Color of the hair without its strands unless another is chosen, sRGB-encoded bytes.
pub const HAIR_SRGB: [u8; 3] = [36, 27, 24];
/// Color of nails over that of the skin, linear.
pub const NAIL_TONE: [f32; 3] = [1.08, 1.04, 1.17];
/// Color of the flower's petals, sRGB-encoded bytes.
pub const FLOWER_SRGB: [u8; 3] = [250, 244, 234];
/// Color of the flower's heart, sRGB-encoded bytes.
pub const FLOWER_HEART_SRGB: [u8; 3] = [246, 196, 84];

/// How the hair is worn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum HairStyle {
    /// A bun for a woman, short for a man, a bob for a child.
    #[default]
    OfFigure,
    /// Combed back into a wound bun, with a plumeria behind the left ear.
    Bun,
    /// Open down the back to below the shoulder blades, with the plumeria.
    Long,
    /// Cut short, ears and nape free.
    Short,
    /// A child's bob with a fringe, over the ears to the jaw.
    Bob,
}

impl HairStyle {
    /// All of them, the usual one first.
    pub const ALL: [Self; 5] = [
        Self::OfFigure,
        Self::Bun,
        Self::Long,
        Self::Short,
        Self::Bob,
    ];

    /// What a person calls it.
    #[must_use]
    pub const fn name(self) -> Words {
        match self {
            Self::OfFigure => words("体つきに合わせる", "as the figure has it"),
            Self::Bun => words("お団子", "a bun"),
            Self::Long => words("長く下ろす", "long and open"),
            Self::Short => words("短髪", "short"),
            Self::Bob => words("おかっぱ", "a bob"),
        }
    }

    /// Name in the document.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::OfFigure => "of-figure",
            Self::Bun => "bun",
            Self::Long => "long",
            Self::Short => "short",
            Self::Bob => "bob",
        }
    }

    /// What is worn by a dancer of this figure.
    #[must_use]
    pub const fn worn_by(self, figure: Figure) -> Self {
        match (self, figure) {
            (Self::OfFigure, Figure::Man) => Self::Short,
            (Self::OfFigure, Figure::Child) => Self::Bob,
            (Self::OfFigure, Figure::OfStature | Figure::Woman) => Self::Bun,
            (style, _) => style,
        }
    }
}

/// How the face is made up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Makeup {
    /// A woman's light, a man's and a child's none that is seen.
    #[default]
    OfFigure,
    /// None.
    Bare,
    /// A little color on lips and cheeks.
    Light,
    /// For the stage: red lips, dark lashes, color over the eyes.
    Stage,
}

impl Makeup {
    /// All of them, the usual one first.
    pub const ALL: [Self; 4] = [Self::OfFigure, Self::Bare, Self::Light, Self::Stage];

    /// Name in the document.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::OfFigure => "of-figure",
            Self::Bare => "bare",
            Self::Light => "light",
            Self::Stage => "stage",
        }
    }

    /// What a person calls it.
    #[must_use]
    pub const fn name(self) -> Words {
        match self {
            Self::OfFigure => words("体つきに合わせる", "as the figure has it"),
            Self::Bare => words("なし", "none"),
            Self::Light => words("うすく", "light"),
            Self::Stage => words("舞台", "for the stage"),
        }
    }
}

/// Hair, face and colors of a dancer; no measure depends on them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Appearance {
    /// What makes her face unlike others.
    pub face: Face,
    /// How old she looks [years]; as the measured bodies that she is made of when `None`.
    pub age_years: Option<f32>,
    /// How the hair is worn.
    pub hair: HairStyle,
    /// How the face is made up.
    pub makeup: Makeup,
    /// Color of bare skin, sRGB-encoded bytes.
    pub skin_srgb: [u8; 3],
    /// Color of the hair without its strands, sRGB-encoded bytes.
    pub hair_srgb: [u8; 3],
    /// Color of the leotard, sRGB-encoded bytes.
    pub leotard_srgb: [u8; 3],
}

impl Default for Appearance {
    fn default() -> Self {
        Self {
            face: Face::default(),
            age_years: None,
            hair: HairStyle::OfFigure,
            makeup: Makeup::OfFigure,
            skin_srgb: SKIN_SRGB,
            hair_srgb: HAIR_SRGB,
            leotard_srgb: LEOTARD_SRGB,
        }
    }
}

/// A square picture that lies on a part of the body, with its side in pixels.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BodyPicture {
    /// Width and height [pixel].
    pub side: u32,
    /// Rows from the top, RGBA, sRGB-encoded, opaque, shape `[side, side, 4]`.
    pub pixels: Vec<u8>,
}

impl Dancer {
    /// The picture of [`crate::PartKind::Hair`]; it goes by the colors of skin and hair alone.
    #[must_use]
    pub fn hair_picture(&self) -> BodyPicture {
        hair_paint::hair_texture(&self.appearance)
    }
}
