//! sRGB bytes to linear light and back (IEC 61966-2-1), by table, with the same bits everywhere.

use crate::whole;
use glam::Vec3;
use lole_geom::trig;

/// Entries of the table from linear to sRGB. With 8192, the error against the exact curve stays
/// below one byte even near black, where the curve is steepest (12.92).
const ENCODE_ENTRIES: usize = 8192;

/// Both directions as tables.
#[derive(Debug)]
pub struct SrgbTable {
    linear_from_byte: [f32; 256],
    byte_from_linear: Vec<u8>,
}

impl Default for SrgbTable {
    fn default() -> Self {
        Self::new()
    }
}

impl SrgbTable {
    /// Works the tables out.
    #[must_use]
    pub fn new() -> Self {
        let linear_from_byte = std::array::from_fn(|byte| linear_from_srgb(byte as f32 / 255.0));
        let byte_from_linear = (0..=ENCODE_ENTRIES)
            .map(|entry| byte(srgb_from_linear(entry as f32 / ENCODE_ENTRIES as f32)))
            .collect();
        Self {
            linear_from_byte,
            byte_from_linear,
        }
    }

    /// Linear color of sRGB bytes.
    #[must_use]
    pub fn decode(&self, bytes: [u8; 3]) -> Vec3 {
        Vec3::from(bytes.map(|byte| self.linear_from_byte[usize::from(byte)]))
    }

    /// sRGB bytes of a linear color; what is outside 0 to 1 is cut off.
    #[must_use]
    pub fn encode(&self, color: Vec3) -> [u8; 3] {
        color.to_array().map(|linear| {
            let entry = linear.clamp(0.0, 1.0) * ENCODE_ENTRIES as f32 + 0.5;
            self.byte_from_linear[whole::index(entry).min(ENCODE_ENTRIES)]
        })
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "rounded to 0..=255 before the cast"
)]
fn byte(value: f32) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0).round() as u8
}

pub use lole_geom::srgb::linear_from_srgb;

fn srgb_from_linear(value: f32) -> f32 {
    if value <= 0.003_130_8 {
        value * 12.92
    } else {
        1.055 * trig::powf(value, 1.0 / 2.4) - 0.055
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_survives_the_way_to_light_and_back() {
        let table = SrgbTable::new();
        for byte in 0..=255_u8 {
            assert_eq!(table.encode(table.decode([byte; 3])), [byte; 3]);
        }
    }
}
