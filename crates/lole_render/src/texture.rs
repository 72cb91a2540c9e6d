//! Pictures on surfaces, with mipmaps.

use crate::RenderError;

/// An sRGB picture that repeats, with its mipmaps. Alpha is not used.
#[derive(Clone, PartialEq, Eq)]
pub struct Texture {
    levels: Vec<Level>,
}

/// One mipmap level.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct Level {
    /// Columns.
    pub(crate) width: u32,
    /// Rows.
    pub(crate) height: u32,
    /// RGBA, sRGB, top row first.
    pub(crate) pixels: Vec<u8>,
}

impl std::fmt::Debug for Texture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Texture({} x {})", self.width(), self.height())
    }
}

impl Texture {
    /// A texture of `width` times `height` pixels, RGBA in sRGB, top row first.
    ///
    /// # Errors
    /// [`RenderError::ImageSize`] where a side is 0 or too long, [`RenderError::TextureSize`]
    /// where `pixels` is not four bytes a pixel.
    pub fn new(width: u32, height: u32, pixels: Vec<u8>) -> Result<Self, RenderError> {
        let size = crate::Size::new(width, height);
        size.check()?;
        let needed = size.pixel_count() * 4;
        if pixels.len() != needed {
            return Err(RenderError::TextureSize {
                width,
                height,
                needed,
                given: pixels.len(),
            });
        }
        let levels = vec![Level {
            width,
            height,
            pixels,
        }];
        Ok(Self { levels })
    }

    /// Columns.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.levels[0].width
    }

    /// Rows.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.levels[0].height
    }

    /// RGBA in sRGB, top row first.
    #[must_use]
    pub fn pixels(&self) -> &[u8] {
        &self.levels[0].pixels
    }
}
