//! What was decided for an adornment, by key, and its colors.

use glam::Vec3;
use lole_geom::Chance;
use lole_pattern::DraftError;

use crate::drafting::chosen::Chosen as Decided;
use crate::{Colors, GarmentSpec};

/// The options of one adornment, and its colors.
pub(crate) struct Chosen<'a> {
    decided: Decided<'a>,
    colors: Colors,
}

impl<'a> Chosen<'a> {
    /// Refuses values outside the ranges of their rows.
    pub(crate) fn new(spec: &GarmentSpec<'a>) -> Result<Self, DraftError> {
        Ok(Self {
            decided: Decided::new(spec.template.options, spec.options)?,
            colors: spec.colors,
        })
    }

    /// A number, `usual` where it follows from the measures.
    pub(crate) fn number(&self, key: &str, usual: f64) -> f64 {
        self.decided.number_or(key, usual)
    }

    /// A length given in centimeters [m], `usual` where it follows from the measures.
    #[expect(clippy::cast_possible_truncation, reason = "shapes are f32")]
    pub(crate) fn m(&self, key: &str, usual: f64) -> f32 {
        self.decided.m_or(key, usual) as f32
    }

    /// A count.
    pub(crate) fn count(&self, key: &str) -> usize {
        self.decided.count(key) as usize
    }

    /// Identifier of a choice.
    pub(crate) fn choice(&self, key: &str) -> &'static str {
        self.decided.choice(key)
    }

    /// Linear color of the ground.
    pub(crate) fn ground(&self) -> Vec3 {
        linear(self.colors.ground)
    }

    /// Linear color of flowers and feathers.
    pub(crate) fn flower(&self) -> Vec3 {
        linear(self.colors.flower)
    }

    /// Linear color of leaves.
    pub(crate) fn leaf(&self) -> Vec3 {
        linear(self.colors.leaf)
    }

    /// Linear color of hearts and what else sets off.
    pub(crate) fn shadow(&self) -> Vec3 {
        linear(self.colors.shadow)
    }
}

/// A number of things, rounded, at least 0.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "options are held to ranges of a few hundred"
)]
pub(crate) fn whole(value: f64) -> usize {
    value.round().clamp(0.0, 100_000.0) as usize
}

/// Linear light of an sRGB-encoded color (IEC 61966-2-1).
fn linear(srgb: [u8; 3]) -> Vec3 {
    let channel = |byte: u8| {
        let value = f32::from(byte) / 255.0;
        if value <= 0.04045 {
            value / 12.92
        } else {
            lole_geom::trig::powf((value + 0.055) / 1.055, 2.4)
        }
    };
    Vec3::from_array(srgb.map(channel))
}

/// A number from -1 to 1 that follows from two numbers and nothing else.
pub(crate) fn chance(one: usize, other: usize) -> f32 {
    let seed = (one as u64)
        .wrapping_mul(0x9e37_79b9_7f4a_7c15)
        .wrapping_add((other as u64).wrapping_mul(0xd1b5_4a32_d192_ed03));
    let top = u16::try_from(Chance::new(seed).bits() >> 48).unwrap_or(0);
    f32::from(top) / 32767.5 - 1.0
}

/// A place in a row of things as a number.
#[expect(clippy::cast_precision_loss, reason = "things are counted in hundreds")]
pub(crate) const fn real(count: usize) -> f32 {
    count as f32
}
