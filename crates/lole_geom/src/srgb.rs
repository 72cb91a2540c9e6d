//! Colors as eyes see them, and as light adds up.

use crate::trig;

/// Linear light of an sRGB-encoded share, both 0 to 1 (IEC 61966-2-1).
#[must_use]
pub fn linear_from_srgb(value: f32) -> f32 {
    if value <= 0.040_45 {
        value / 12.92
    } else {
        trig::powf((value + 0.055) / 1.055, 2.4)
    }
}
