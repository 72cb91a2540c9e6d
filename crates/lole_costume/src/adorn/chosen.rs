//! What was decided for an adornment, by key, and its colors.

use glam::Vec3;
use lole_geom::Length;
use lole_pattern::template::OptionKind;

use crate::document::WornTemplate;

/// The options of one adornment.
pub(super) struct Chosen<'a>(pub(super) &'a WornTemplate);

impl Chosen<'_> {
    fn value(&self, key: &str) -> Option<f64> {
        let position = self.0.template.position(key)?;
        self.0.options.get(position)
    }

    /// A number, `usual` where it follows from the measures.
    pub(super) fn number(&self, key: &str, usual: f64) -> f64 {
        self.value(key).unwrap_or(usual)
    }

    /// A length given in centimeters [m], `usual` where it follows from the measures.
    #[expect(clippy::cast_possible_truncation, reason = "shapes are f32")]
    pub(super) fn m(&self, key: &str, usual: f64) -> f32 {
        let decided = self.value(key).map(|cm| Length::from_cm(cm).to_m());
        decided.unwrap_or(usual) as f32
    }

    /// A count.
    pub(super) fn count(&self, key: &str) -> usize {
        whole(self.number(key, 1.0))
    }

    /// Identifier of a choice.
    pub(super) fn choice(&self, key: &str) -> &'static str {
        let Some(position) = self.0.template.position(key) else {
            return "";
        };
        match self.0.template.options[position].kind {
            OptionKind::Choice(choices) => choices
                .get(whole(self.0.options.get(position).unwrap_or(0.0)))
                .map_or("", |choice| choice.id),
            _ => "",
        }
    }

    /// Linear color of the ground.
    pub(super) fn ground(&self) -> Vec3 {
        linear(self.0.print.print().ground)
    }

    /// Linear color of flowers and feathers.
    pub(super) fn flower(&self) -> Vec3 {
        linear(self.0.print.print().flower)
    }

    /// Linear color of leaves.
    pub(super) fn leaf(&self) -> Vec3 {
        linear(self.0.print.print().leaf)
    }

    /// Linear color of hearts and what else sets off.
    pub(super) fn shadow(&self) -> Vec3 {
        linear(self.0.print.print().shadow)
    }
}

/// A number of things, rounded, at least 0.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "options are held to ranges of a few hundred"
)]
pub(super) fn whole(value: f64) -> usize {
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

/// A number from -1 to 1 that follows from two numbers and nothing else (the finalizer of `SplitMix64`,
/// Steele and others 2014).
pub(super) fn chance(one: usize, other: usize) -> f32 {
    let mut bits = (one as u64)
        .wrapping_mul(0x9e37_79b9_7f4a_7c15)
        .wrapping_add((other as u64).wrapping_mul(0xd1b5_4a32_d192_ed03))
        .wrapping_add(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^= bits >> 31;
    let top = u16::try_from(bits >> 48).unwrap_or(0);
    f32::from(top) / 32767.5 - 1.0
}

/// A place in a row of things as a number.
#[expect(clippy::cast_precision_loss, reason = "things are counted in hundreds")]
pub(super) const fn real(count: usize) -> f32 {
    count as f32
}
