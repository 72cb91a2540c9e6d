//! From sRGB pixels to the planes H.264 stores: BT.709, limited range, one chroma sample per
//! 2 × 2 pixels.

use openh264::formats::YUVSource;

/// Fixed-point one of the color matrix.
const ONE_BITS: u32 = 16;

/// Rows of the BT.709 matrix (ITU-R BT.709-6, items 3.2 and 3.3: `E'Y = 0.2126 R + 0.7152 G +
/// 0.0722 B`, chroma over 1.8556 and 1.5748), scaled to the limited range 219/255 and 224/255 and
/// to `2^16`. The chroma rows sum to zero, so that gray has no color.
const LUMA: [i32; 3] = [11_966, 40_254, 4_064];
const CHROMA_BLUE: [i32; 3] = [-6_596, -22_189, 28_785];
const CHROMA_RED: [i32; 3] = [28_785, -26_145, -2_640];

/// Black of the limited range, and chroma of gray (ITU-R BT.709-6, item 4.6).
const LUMA_OFFSET: i32 = 16;
const CHROMA_OFFSET: i32 = 128;

/// Planar picture with chroma at half size, sited as H.264 assumes: level with the left pixel of
/// each pair, halfway between two rows.
#[derive(Debug, Clone)]
pub(super) struct YuvPicture {
    width: usize,
    height: usize,
    luma: Vec<u8>,
    chroma_blue: Vec<u8>,
    chroma_red: Vec<u8>,
}

impl YuvPicture {
    /// A picture of even size, all zero.
    pub(super) fn new(width: usize, height: usize) -> Self {
        let chroma_count = (width / 2) * (height / 2);
        Self {
            width,
            height,
            luma: vec![0; width * height],
            chroma_blue: vec![0; chroma_count],
            chroma_red: vec![0; chroma_count],
        }
    }

    /// Takes over RGBA8 pixels of the same size; alpha is ignored.
    pub(super) fn fill(&mut self, rgba: &[u8]) {
        for (luma, pixel) in self.luma.iter_mut().zip(rgba.chunks_exact(4)) {
            let color = [0, 1, 2].map(|channel| i32::from(pixel[channel]));
            *luma = quantize(dot(LUMA, color), ONE_BITS, LUMA_OFFSET);
        }
        let chroma_width = self.width / 2;
        for row in 0..self.height / 2 {
            let rows =
                [2 * row, 2 * row + 1].map(|y| &rgba[4 * y * self.width..][..4 * self.width]);
            for column in 0..chroma_width {
                let color = color_sum(rows, column);
                // The color is summed with weights 1 2 1 over two rows: 8, or three bits more.
                let index = row * chroma_width + column;
                self.chroma_blue[index] =
                    quantize(dot(CHROMA_BLUE, color), ONE_BITS + 3, CHROMA_OFFSET);
                self.chroma_red[index] =
                    quantize(dot(CHROMA_RED, color), ONE_BITS + 3, CHROMA_OFFSET);
            }
        }
    }
}

/// Color around the left pixel of pair `column` in two rows, weighted 1 2 1, summed.
fn color_sum(rows: [&[u8]; 2], column: usize) -> [i32; 3] {
    let middle = 8 * column;
    // The picture is continued by its first column.
    let left = middle.saturating_sub(4);
    [0, 1, 2].map(|channel| {
        rows.iter()
            .map(|row| {
                i32::from(row[left + channel])
                    + 2 * i32::from(row[middle + channel])
                    + i32::from(row[middle + 4 + channel])
            })
            .sum()
    })
}

/// Product of one matrix row with a color.
fn dot(row: [i32; 3], color: [i32; 3]) -> i32 {
    row[0] * color[0] + row[1] * color[1] + row[2] * color[2]
}

/// Rounds a fixed-point value and moves it by the offset of its plane.
fn quantize(value: i32, bits: u32, offset: i32) -> u8 {
    let level = ((value + (1 << (bits - 1))) >> bits) + offset;
    u8::try_from(level.clamp(0, 255)).unwrap_or(u8::MAX)
}

impl YUVSource for YuvPicture {
    fn dimensions(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    fn strides(&self) -> (usize, usize, usize) {
        (self.width, self.width / 2, self.width / 2)
    }

    fn y(&self) -> &[u8] {
        &self.luma
    }

    fn u(&self) -> &[u8] {
        &self.chroma_blue
    }

    fn v(&self) -> &[u8] {
        &self.chroma_red
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Planes of a picture of one color.
    fn planes(color: [u8; 3]) -> [u8; 3] {
        let pixels = [color[0], color[1], color[2], 255].repeat(16);
        let mut picture = YuvPicture::new(4, 4);
        picture.fill(&pixels);
        [
            picture.luma[5],
            picture.chroma_blue[1],
            picture.chroma_red[1],
        ]
    }

    /// The colors of 100 % color bars in 8-bit BT.709, computed from the standard in f64.
    #[test]
    fn pure_colors_have_the_levels_of_bt_709() {
        for corner in 0..8u8 {
            let color = [corner & 1, corner >> 1 & 1, corner >> 2 & 1].map(|bit| bit * 255);
            let [red, green, blue] = color.map(|channel| f64::from(channel) / 255.0);
            let luma = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
            let expected = [
                16.0 + 219.0 * luma,
                128.0 + 224.0 * (blue - luma) / 1.8556,
                128.0 + 224.0 * (red - luma) / 1.5748,
            ];
            for (level, expected) in planes(color).into_iter().zip(expected) {
                let error = (f64::from(level) - expected).abs();
                assert!(error <= 0.51, "{color:?}: {level} instead of {expected}");
            }
        }
    }

    #[test]
    fn gray_has_no_color() {
        for gray in 0..=255 {
            assert_eq!(planes([gray; 3])[1..], [128, 128], "gray {gray}");
        }
    }
}
