//! Pictures on surfaces, with mipmaps.

use crate::RenderError;
use crate::srgb::SrgbTable;
use crate::whole;
use glam::{Vec2, Vec3, Vec4};
use std::ops::{Add, Mul};

/// An sRGB picture that repeats, with its mipmaps. Alpha counts in panoramas alone.
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
        let mut levels = vec![Level {
            width,
            height,
            pixels,
        }];
        while let Some(next) = levels.last().and_then(Level::halved) {
            levels.push(next);
        }
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
    /// All mipmap levels, the finest first; each side is half the one before, rounded down.
    pub(crate) fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// Linear color at `uv` (repeating, v down), bilinear within two levels and linear between
    /// them; `lod` 0 is the finest level, 1 the next.
    pub(crate) fn sample(&self, srgb: &SrgbTable, uv: Vec2, lod: f32) -> Vec3 {
        self.between_levels(lod, |level| level.bilinear(srgb, uv))
    }

    /// The same with alpha.
    pub(crate) fn sample_with_alpha(&self, srgb: &SrgbTable, uv: Vec2, lod: f32) -> Vec4 {
        self.between_levels(lod, |level| {
            level.bilinear(srgb, uv).extend(level.bilinear_alpha(uv))
        })
    }

    /// What two levels show, mixed as `lod` lies between them.
    fn between_levels<T>(&self, lod: f32, at: impl Fn(&Level) -> T) -> T
    where
        T: Add<Output = T> + Mul<f32, Output = T>,
    {
        let last = self.levels.len() - 1;
        let lod = lod.clamp(0.0, last as f32);
        let fine = whole::index(lod).min(last);
        let between = lod - fine as f32;
        let fine_color = at(&self.levels[fine]);
        if between <= 0.0 || fine == last {
            return fine_color;
        }
        fine_color * (1.0 - between) + at(&self.levels[fine + 1]) * between
    }
}

impl Level {
    /// The next level, each pixel the mean light of the pixels it covers; `None` after 1 x 1.
    fn halved(&self) -> Option<Self> {
        if self.width == 1 && self.height == 1 {
            return None;
        }
        let srgb = SrgbTable::new();
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let mut pixels = Vec::with_capacity(width as usize * height as usize * 4);
        for y in 0..height {
            for x in 0..width {
                let covered = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(dx, dy)| {
                    let (x, y) = (x * 2 + dx, y * 2 + dy);
                    (x.min(self.width - 1), y.min(self.height - 1))
                });
                let colors = covered.map(|(x, y)| self.texel(&srgb, x, y));
                pixels.extend(srgb.encode(colors.iter().sum::<Vec3>() * 0.25));
                let alphas = covered.map(|(x, y)| self.alpha(x, y));
                pixels.push(whole::byte(alphas.iter().sum::<f32>() * 0.25));
            }
        }
        Some(Self {
            width,
            height,
            pixels,
        })
    }

    #[inline]
    fn texel(&self, srgb: &SrgbTable, x: u32, y: u32) -> Vec3 {
        let start = (y as usize * self.width as usize + x as usize) * 4;
        match self.pixels[start..] {
            [r, g, b, ..] => srgb.decode([r, g, b]),
            _ => Vec3::ZERO,
        }
    }

    /// Alpha of a texel, 0 to 255.
    fn alpha(&self, x: u32, y: u32) -> f32 {
        let start = (y as usize * self.width as usize + x as usize) * 4;
        f32::from(self.pixels[start + 3])
    }

    fn bilinear(&self, srgb: &SrgbTable, uv: Vec2) -> Vec3 {
        self.mixed(uv, |x, y| self.texel(srgb, x, y))
    }

    /// Alpha at `uv`, 0 to 1.
    fn bilinear_alpha(&self, uv: Vec2) -> f32 {
        self.mixed(uv, |x, y| self.alpha(x, y)) / 255.0
    }

    /// The four texels around `uv`, mixed.
    #[inline]
    fn mixed<T>(&self, uv: Vec2, texel: impl Fn(u32, u32) -> T) -> T
    where
        T: Add<Output = T> + Mul<f32, Output = T>,
    {
        let whole_uv = Vec2::new(whole::floor(uv.x) as f32, whole::floor(uv.y) as f32);
        let at = (uv - whole_uv) * Vec2::new(self.width as f32, self.height as f32) - 0.5;
        let (column, row) = (whole::floor(at.x), whole::floor(at.y));
        let part = at - Vec2::new(column as f32, row as f32);
        let (x0, x1) = neighbors(column, self.width);
        let (y0, y1) = neighbors(row, self.height);
        let between = |a: T, b: T, share: f32| a * (1.0 - share) + b * share;
        let top = between(texel(x0, y0), texel(x1, y0), part.x);
        let bottom = between(texel(x0, y1), texel(x1, y1), part.x);
        between(top, bottom, part.y)
    }
}

/// The texels on both sides of a sample, around the edge; `base` is -1 to `side` - 1.
fn neighbors(base: i32, side: u32) -> (u32, u32) {
    let first = u32::try_from(base).map_or(side - 1, |base| base.min(side - 1));
    let second = if first + 1 == side { 0 } else { first + 1 };
    (first, second)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_mipmap_is_the_mean_light() {
        let pixels: Vec<u8> = (0..64_u8)
            .flat_map(|index| [if (index / 8 + index) % 2 == 0 { 255 } else { 0 }; 4])
            .collect();
        let texture = Texture::new(8, 8, pixels).unwrap();
        let last = texture.levels().last().unwrap();
        assert_eq!((last.width, last.height), (1, 1));
        // Half of all light is 188 in sRGB.
        assert_eq!(last.pixels[..3], [188; 3]);
    }

    #[test]
    fn whole_turns_of_the_coordinates_change_nothing() {
        let pixels: Vec<u8> = (0..=255_u8).map(|byte| byte.wrapping_mul(37)).collect();
        let texture = Texture::new(8, 8, pixels).unwrap();
        let srgb = SrgbTable::new();
        for (u, v) in [(0.0, 0.0), (0.03125, 0.9375), (0.5, 0.25)] {
            let here = texture.sample(&srgb, Vec2::new(u, v), 0.5);
            let there = texture.sample(&srgb, Vec2::new(u + 3.0, v - 2.0), 0.5);
            assert_eq!(here, there);
        }
    }

    #[test]
    fn a_texture_needs_four_bytes_a_pixel() {
        assert!(matches!(
            Texture::new(4, 4, vec![0; 63]),
            Err(RenderError::TextureSize {
                needed: 64,
                given: 63,
                ..
            })
        ));
        assert!(matches!(
            Texture::new(0, 4, Vec::new()),
            Err(RenderError::ImageSize { .. })
        ));
    }
}
