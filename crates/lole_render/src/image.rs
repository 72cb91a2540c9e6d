//! The finished picture and its size.

use crate::RenderError;
use crate::srgb::SrgbTable;
use glam::Vec3;
use rayon::prelude::*;

/// Width and height of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Size {
    /// Columns [pixel].
    pub width: u32,
    /// Rows [pixel].
    pub height: u32,
}

/// Longest side that every backend can draw [pixel]; WebGL2 promises no more than 2048, today's
/// adapters 8192.
pub const MAX_SIDE: u32 = 8192;

impl Size {
    /// A size of `width` times `height` pixels; checked where a renderer is made of it.
    #[must_use]
    pub const fn new(width: u32, height: u32) -> Self {
        Self { width, height }
    }

    /// Width over height.
    #[must_use]
    pub fn aspect(self) -> f32 {
        self.width as f32 / self.height.max(1) as f32
    }

    /// Pixels in the picture.
    #[must_use]
    pub const fn pixel_count(self) -> usize {
        self.width as usize * self.height as usize
    }

    /// Refuses a picture without pixels or one too large to draw.
    pub(crate) fn check(self) -> Result<(), RenderError> {
        let fits = |side: u32| (1..=MAX_SIDE).contains(&side);
        if fits(self.width) && fits(self.height) {
            Ok(())
        } else {
            Err(RenderError::ImageSize {
                width: self.width,
                height: self.height,
            })
        }
    }
}

/// A picture: 8-bit sRGB with an alpha of 255.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Image {
    /// Columns [pixel].
    pub width: u32,
    /// Rows [pixel].
    pub height: u32,
    /// RGBA, row-major, top row first, shape `[height, width, 4]`.
    pub pixels: Vec<u8>,
}

impl Image {
    /// A picture of one sRGB color.
    #[must_use]
    pub fn filled(size: Size, [red, green, blue]: [u8; 3]) -> Self {
        Self {
            width: size.width,
            height: size.height,
            pixels: [red, green, blue, 255].repeat(size.pixel_count()),
        }
    }

    /// Copies `other` with its top left pixel at column `x`, row `y`; what does not fit is left out.
    pub fn paste(&mut self, other: &Self, x: u32, y: u32) {
        let width = other.width.min(self.width.saturating_sub(x)) as usize * 4;
        let height = other.height.min(self.height.saturating_sub(y));
        for row in 0..height as usize {
            let from = row * other.width as usize * 4;
            let to = ((y as usize + row) * self.width as usize + x as usize) * 4;
            self.pixels[to..to + width].copy_from_slice(&other.pixels[from..from + width]);
        }
    }

    /// The RGBA bytes at column `x`, row `y`; `None` outside the picture.
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> Option<[u8; 4]> {
        if x >= self.width || y >= self.height {
            return None;
        }
        let start = (y as usize * self.width as usize + x as usize) * 4;
        let bytes = self.pixels.get(start..start + 4)?;
        Some([bytes[0], bytes[1], bytes[2], bytes[3]])
    }
}

/// Light that falls on one film from several pictures of the same size.
pub struct Exposure {
    srgb: SrgbTable,
    size: Size,
    /// Sum of the linear light, by pixel.
    light: Vec<Vec3>,
    /// How long it has fallen, in all.
    time: f32,
}

impl Exposure {
    /// A film that has seen nothing.
    #[must_use]
    pub fn new(size: Size) -> Self {
        Self {
            srgb: SrgbTable::new(),
            size,
            light: vec![Vec3::ZERO; size.pixel_count()],
            time: 0.0,
        }
    }

    /// Lets it see a picture of its size for so long; what of another lies outside is not seen.
    pub fn add(&mut self, picture: &Image, time: f32) {
        let srgb = &self.srgb;
        let pixels = picture.pixels.par_chunks_exact(4);
        let seen = self.light.par_iter_mut().zip(pixels);
        seen.for_each(|(light, pixel)| {
            *light += time * srgb.decode([pixel[0], pixel[1], pixel[2]]);
        });
        self.time += time;
    }

    /// The mean of what it has seen; black if that was nothing.
    #[must_use]
    pub fn develop(self) -> Image {
        let share = if 0.0 < self.time {
            1.0 / self.time
        } else {
            0.0
        };
        let srgb = &self.srgb;
        let pixels = self.light.par_iter().flat_map_iter(|light| {
            let [red, green, blue] = srgb.encode(*light * share);
            [red, green, blue, 255]
        });
        Image {
            width: self.size.width,
            height: self.size.height,
            pixels: pixels.collect(),
        }
    }
}
