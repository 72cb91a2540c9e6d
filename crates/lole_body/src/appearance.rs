//! Colors of the dancer, her painted face, her hair and the flower in it.

mod face;
mod hair;
mod hair_paint;

pub use face::face_texture;
pub(crate) use hair::add_hair;
pub use hair_paint::hair_texture;

/// Color of bare skin, sRGB-encoded bytes.
pub const SKIN_SRGB: [u8; 3] = [222, 178, 148];
/// Color of the leotard, sRGB-encoded bytes.
pub const LEOTARD_SRGB: [u8; 3] = [38, 36, 44];
/// Color of the hair without its strands, sRGB-encoded bytes.
pub const HAIR_SRGB: [u8; 3] = [36, 27, 24];
/// Color of the flower's petals, sRGB-encoded bytes.
pub const FLOWER_SRGB: [u8; 3] = [250, 244, 234];
/// Color of the flower's heart, sRGB-encoded bytes.
pub const FLOWER_HEART_SRGB: [u8; 3] = [246, 196, 84];

/// A square picture that lies on a part of the body, with its side in pixels.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BodyPicture {
    /// Width and height [pixel].
    pub side: u32,
    /// Rows from the top, RGBA, sRGB-encoded, opaque, shape `[side, side, 4]`.
    pub pixels: Vec<u8>,
}
