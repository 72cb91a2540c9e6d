//! Words on pictures, in a font that comes with the program (Latin, Greek and the marks of Hawaiian) or in the
//! caller's.

use ab_glyph::{Font as _, FontRef, Glyph, PxScale, ScaleFont as _, point};

use crate::{Image, RenderError, whole};

/// The font that comes with the program.
pub const LATIN: &[u8] = epaint_default_fonts::UBUNTU_LIGHT;
/// Distance from line to line over the height of the font.
const LEADING: f32 = 1.18;

/// A paragraph that breaks between words.
#[derive(Debug, Clone, Copy)]
pub struct Label<'a> {
    /// What it says.
    pub text: &'a str,
    /// A font file: TrueType or OpenType.
    pub font: &'a [u8],
    /// Height of the letters' box [pixel].
    pub size: f32,
    /// sRGB.
    pub color: [u8; 3],
    /// How much of the picture the letters hide, 0 to 1.
    pub opacity: f32,
    /// Longest line [pixel]; a longer word stands alone.
    pub width: f32,
}

impl Label<'_> {
    /// Writes with the top left corner at column `x`, row `y`, and returns the height used
    /// [pixel]. What falls outside the picture is left out.
    ///
    /// # Errors
    /// [`RenderError::Font`] where the font is damaged.
    pub fn write(&self, image: &mut Image, [x, y]: [f32; 2]) -> Result<f32, RenderError> {
        let font = self.face()?;
        let scaled = font.as_scaled(PxScale::from(self.size));
        let lines = self.lines(|text| advance(&font, text, self.size));
        let step = self.size * LEADING;
        let mut baseline = y + scaled.ascent();
        for line in &lines {
            let mut pen = x;
            for letter in line.chars().map(drawn) {
                let glyph = scaled
                    .glyph_id(letter)
                    .with_scale_and_position(self.size, point(pen, baseline));
                pen += scaled.h_advance(glyph.id);
                self.ink(&font, glyph, image);
            }
            baseline += step;
        }
        Ok(step * lines.len() as f32)
    }

    /// Width of the text on one line [pixel].
    ///
    /// # Errors
    /// [`RenderError::Font`] where the font is damaged.
    pub fn advance(&self) -> Result<f32, RenderError> {
        Ok(advance(&self.face()?, self.text, self.size))
    }

    fn face(&self) -> Result<FontRef<'_>, RenderError> {
        FontRef::try_from_slice(self.font).map_err(|_| RenderError::Font)
    }

    /// The text in lines no wider than asked, by the width `advance` [pixel] of a piece of text.
    fn lines(&self, advance: impl Fn(&str) -> f32) -> Vec<String> {
        let mut lines: Vec<String> = Vec::new();
        for word in self.text.split_whitespace() {
            let longer = lines.last().map(|line| format!("{line} {word}"));
            match (longer, lines.last_mut()) {
                (Some(longer), Some(line)) if advance(&longer) <= self.width => *line = longer,
                _ => lines.push(word.to_owned()),
            }
        }
        lines
    }

    /// Lays one letter over the picture.
    fn ink(&self, font: &FontRef<'_>, glyph: Glyph, image: &mut Image) {
        let Some(outline) = font.outline_glyph(glyph) else {
            return;
        };
        let corner = outline.px_bounds().min;
        outline.draw(|column, row, cover| {
            let (x, y) = (corner.x + column as f32, corner.y + row as f32);
            if x < 0.0 || y < 0.0 || image.width as f32 <= x || image.height as f32 <= y {
                return;
            }
            let pixel = (whole::index(y) * image.width as usize + whole::index(x)) * 4;
            for (channel, ink) in image.pixels[pixel..pixel + 3].iter_mut().zip(self.color) {
                let (paper, ink) = (f32::from(*channel), f32::from(ink));
                let mixed = paper + (ink - paper) * cover.clamp(0.0, 1.0) * self.opacity;
                *channel = u8::try_from(whole::index(mixed + 0.5)).unwrap_or(u8::MAX);
            }
        });
    }
}

/// Width of a line of text [pixel].
fn advance(font: &FontRef<'_>, text: &str, size: f32) -> f32 {
    let scaled = font.as_scaled(PxScale::from(size));
    let letters = text.chars().map(drawn);
    letters
        .map(|letter| scaled.h_advance(scaled.glyph_id(letter)))
        .sum()
}

/// The letter whose shape stands for `letter`: the font lacks the ʻokina, whose shape is that of a
/// turned comma.
const fn drawn(letter: char) -> char {
    match letter {
        'ʻ' => '‘',
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Size;

    #[test]
    fn words_leave_ink_inside_their_width_and_break_at_spaces() {
        let mut image = Image::filled(Size::new(200, 120), [255; 3]);
        let label = Label {
            text: "pāʻū ω Δt kāholo skirt dances",
            font: LATIN,
            size: 20.0,
            color: [0; 3],
            opacity: 1.0,
            width: 120.0,
        };
        let height = label.write(&mut image, [10.0, 5.0]).unwrap();
        assert!((40.0..120.0).contains(&height), "{height}");
        let inked = |x: u32, y: u32| image.pixel(x, y).is_some_and(|pixel| pixel[0] < 128);
        let columns: Vec<u32> = (0..200)
            .filter(|&x| (0..120).any(|y| inked(x, y)))
            .collect();
        assert!(columns.first().is_some_and(|&x| 10 <= x));
        assert!(columns.last().is_some_and(|&x| x < 131), "{columns:?}");
    }

    #[test]
    fn every_letter_of_hawaiian_and_of_the_equations_is_in_the_font() {
        let font = FontRef::try_from_slice(LATIN).unwrap();
        for letter in "āēīōūĀĒĪŌŪʻωΔ²₃×–".chars() {
            assert_ne!(font.glyph_id(drawn(letter)).0, 0, "{letter}");
        }
    }

    #[test]
    fn what_falls_outside_is_left_out() {
        let mut image = Image::filled(Size::new(8, 8), [255; 3]);
        let label = Label {
            text: "outside",
            font: LATIN,
            size: 40.0,
            color: [0; 3],
            opacity: 1.0,
            width: 10.0,
        };
        for place in [[-20.0, -20.0], [4.0, 4.0], [100.0, 100.0]] {
            assert!(label.write(&mut image, place).is_ok());
        }
    }
}
