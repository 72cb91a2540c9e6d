//! The painted hair: strands drawn back from a soft hairline, dark brown with dull light on them.
//!
//! The picture is laid over the hair so that strands run down it: `u` counts across them, `v`
//! from the hairline inwards (see [`hairline_v`]). At the hairline it is bare skin, so that hair
//! begins strand by strand and not with an edge.

use super::{Appearance, BodyPicture};
use crate::surface::warp::smooth_step;

/// Side of the picture [pixel].
const SIDE: u32 = 1024;
/// Distance inside the hairline [°] at the top and at the bottom of the picture.
const RANGE: [f32; 2] = [-12.0, 78.0];
/// How far strands that catch the light are on the way from the hair's color to white, by channel.
const STRAND_LIGHT: [f32; 3] = [0.21, 0.154, 0.121];
/// What is left of the hair's color between locks, by channel.
const STRAND_DARK: [f32; 3] = [0.39, 0.41, 0.46];

/// The colors of one head, sRGB-encoded.
struct Palette {
    skin: [f32; 3],
    hair: [f32; 3],
    light: [f32; 3],
    dark: [f32; 3],
}

impl Palette {
    fn new(appearance: &Appearance) -> Self {
        let hair = appearance.hair_srgb.map(f32::from);
        Self {
            skin: appearance.skin_srgb.map(f32::from),
            hair,
            light: std::array::from_fn(|k| hair[k] + (255.0 - hair[k]) * STRAND_LIGHT[k]),
            dark: std::array::from_fn(|k| hair[k] * STRAND_DARK[k]),
        }
    }
}

/// Row of the picture, 0 to 1, at a distance inside the hairline [°]; never so near to an end that
/// small copies of the picture mix it with the other.
pub(super) fn hairline_v(inside: f32) -> f32 {
    ((inside - RANGE[0]) / (RANGE[1] - RANGE[0])).clamp(0.05, 0.92)
}

/// The hair's picture.
pub(super) fn hair_texture(appearance: &Appearance) -> BodyPicture {
    let palette = Palette::new(appearance);
    let mut pixels = Vec::with_capacity((SIDE * SIDE * 4) as usize);
    for row in 0..SIDE {
        let v = (row as f32 + 0.5) / SIDE as f32;
        for column in 0..SIDE {
            let u = (column as f32 + 0.5) / SIDE as f32;
            pixels.extend(palette.color(u, v).map(byte));
            pixels.push(255);
        }
    }
    BodyPicture { side: SIDE, pixels }
}

impl Palette {
    /// sRGB-encoded color at a place of the picture.
    fn color(&self, u: f32, v: f32) -> [f32; 3] {
        let inside = RANGE[0] + (RANGE[1] - RANGE[0]) * v;
        // Strands do not run quite straight, and no two alike.
        let across = u + 0.010 * (noise(2.0 * v + 7.0 * u, 11) - 0.5);
        let lock = noise(across * 42.0, 1);
        let strand = noise(across * 150.0, 2);
        let hair = noise(across * 470.0 + 2.0 * noise(v * 9.0, 5), 3);
        let fine = 0.45 * lock + 0.35 * strand + 0.2 * hair;

        // Light lies in bands across the strands, where the head turns towards the room.
        let bell = |middle: f32, width: f32| {
            let x = ((inside - middle) / width).clamp(-1.0, 1.0);
            (1.0 - x * x) * (1.0 - x * x)
        };
        let band = 0.25 + 0.75 * bell(20.0 + 6.0 * lock, 20.0) + 0.35 * bell(52.0, 14.0);
        let light = (0.15 + 0.85 * smooth_step((fine - 0.3) / 0.5)) * band * 0.62;
        let gap = smooth_step((0.36 - (0.6 * lock + 0.4 * strand)) / 0.22) * 0.8;
        let dark = mix(self.hair, self.dark, gap);
        let combed = mix(dark, self.light, light);

        // Strands begin at different places; the short ones of the rim are thin.
        let root = 4.4 * noise(u * 23.0, 8) * noise(u * 61.0, 10) + 1.6 * noise(u * 190.0, 9) - 2.2;
        let density = smooth_step((inside - root) / 4.2);
        let thin = smooth_step((noise(across * 380.0, 13) - 0.42) / 0.3)
            * smooth_step((inside + 3.0 - 1.8 * noise(u * 260.0, 14)) / 3.0);
        mix(self.skin, combed, density.max(0.5 * thin).clamp(0.0, 1.0))
    }
}

fn mix(from: [f32; 3], to: [f32; 3], share: f32) -> [f32; 3] {
    std::array::from_fn(|k| from[k] + (to[k] - from[k]) * share)
}

/// Smooth noise 0 to 1 along a line, one value for each whole number.
fn noise(x: f32, seed: u32) -> f32 {
    let whole = x.floor();
    let [left, right] = [0.0, 1.0].map(|step| scattered(whole + step, seed));
    left + (right - left) * smooth_step(x - whole)
}

/// A number 0 to 1 for a whole number (a 32-bit finalizer of xor and multiply).
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "arguments are small whole numbers, not negative"
)]
fn scattered(whole: f32, seed: u32) -> f32 {
    let mut bits =
        (whole.max(0.0) as u32).wrapping_mul(0x9e37_79b9) ^ seed.wrapping_mul(0x85eb_ca6b);
    bits = (bits ^ (bits >> 16)).wrapping_mul(0x7feb_352d);
    bits = (bits ^ (bits >> 15)).wrapping_mul(0x846c_a68b);
    bits ^= bits >> 16;
    (bits >> 8) as f32 / 16_777_215.0
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "clamped before"
)]
fn byte(value: f32) -> u8 {
    value.round().clamp(0.0, 255.0) as u8
}

#[cfg(test)]
mod tests {
    use super::super::SKIN_SRGB;
    use super::*;

    #[test]
    fn hair_begins_as_bare_skin_and_is_dense_inside() {
        let picture = hair_texture(&Appearance::default());
        let side = SIDE as usize;
        let row = |v: f32| {
            let start = byte(v * 255.0) as usize * side / 255 * side * 4;
            &picture.pixels[start..start + side * 4]
        };
        assert!(
            row(0.0)
                .chunks_exact(4)
                .all(|pixel| pixel[..3] == SKIN_SRGB)
        );
        let inner = row(hairline_v(12.0));
        assert!(inner.chunks_exact(4).all(|pixel| pixel[0] < 110));
    }
}
