//! Colours of the dancer and her painted face.

/// Colour of bare skin, sRGB-encoded bytes.
pub const SKIN_SRGB: [u8; 3] = [222, 178, 148];
/// Colour of the leotard, sRGB-encoded bytes.
pub const LEOTARD_SRGB: [u8; 3] = [38, 36, 44];
/// Colour of the hair, sRGB-encoded bytes.
pub const HAIR_SRGB: [u8; 3] = [28, 22, 20];
/// Colour of the flower's petals, sRGB-encoded bytes.
pub const FLOWER_SRGB: [u8; 3] = [250, 244, 234];
/// Colour of the flower's heart, sRGB-encoded bytes.
pub const FLOWER_HEART_SRGB: [u8; 3] = [246, 196, 84];

/// A square picture with its side in pixels.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FaceTexture {
    /// Width and height [pixel].
    pub side: u32,
    /// Rows from the top, RGBA, sRGB-encoded, opaque, shape `[side, side, 4]`.
    pub pixels: Vec<u8>,
}

/// The painted face for [`crate::PartKind::Face`]; its border is exactly [`SKIN_SRGB`].
#[must_use]
pub fn face_texture() -> FaceTexture {
    let side = 1024;
    let [r, g, b] = SKIN_SRGB;
    FaceTexture {
        side,
        pixels: [r, g, b, 255].repeat(1024 * 1024),
    }
}
