//! Making pictures smaller: every pixel is the mean light of the area that it covers.

use lole_geom::trig;

/// Light of the 256 bytes of sRGB (IEC 61966-2-1), and back.
pub(crate) struct Light {
    of_byte: [f32; 256],
    /// Light between a byte and the next.
    borders: [f32; 255],
}

impl Light {
    pub(crate) fn new() -> Self {
        let light = |level: f32| {
            let level = level / 255.0;
            if level <= 0.040_45 {
                level / 12.92
            } else {
                trig::powf((level + 0.055) / 1.055, 2.4)
            }
        };
        let byte = |index: usize| f32::from(u8::try_from(index).unwrap_or(u8::MAX));
        Self {
            of_byte: std::array::from_fn(|index| light(byte(index))),
            borders: std::array::from_fn(|index| light(byte(index) + 0.5)),
        }
    }

    /// Light of a byte, 0 to 1.
    pub(crate) fn decode(&self, byte: u8) -> f32 {
        self.of_byte[usize::from(byte)]
    }

    /// The nearest byte.
    pub(crate) fn encode(&self, light: f32) -> u8 {
        let below = self.borders.partition_point(|border| *border <= light);
        u8::try_from(below).unwrap_or(u8::MAX)
    }

    /// Adds `share` of a row of pixels to premultiplied light and alpha, a sum for each span.
    fn add_line<const CHANNELS: usize>(
        &self,
        line: &[u8],
        columns: &[Span],
        share: f32,
        sums: &mut [[f32; 4]],
    ) {
        for (span, sum) in columns.iter().zip(sums) {
            for (column, part) in span.shares() {
                let pixel = &line[column * CHANNELS..(column + 1) * CHANNELS];
                let alpha = match pixel.get(3) {
                    Some(alpha) => f32::from(*alpha) / 255.0,
                    None => 1.0,
                };
                let weight = share * part * alpha;
                sum[3] += weight;
                for channel in 0..3 {
                    sum[channel] += weight * self.decode(pixel[channel]);
                }
            }
        }
    }
}

/// `source`, of `CHANNELS` bytes a pixel (RGB or RGBA) and `from` pixels wide and high, as RGBA of
/// `to` pixels. A side that is not made smaller stays as it is drawn: pixels are repeated.
///
/// Panics if `source` is shorter than its size says.
pub(crate) fn resized<const CHANNELS: usize>(
    source: &[u8],
    [from_width, from_height]: [u32; 2],
    [to_width, to_height]: [u32; 2],
) -> Vec<u8> {
    let light = Light::new();
    let columns = spans(from_width, to_width);
    let rows = spans(from_height, to_height);
    let stride = from_width as usize * CHANNELS;
    let mut pixels = Vec::with_capacity(to_width as usize * to_height as usize * 4);
    // Premultiplied light and alpha of one row of the result.
    let mut sums = vec![[0.0_f32; 4]; to_width as usize];
    for row in &rows {
        sums.fill([0.0; 4]);
        for (line, share) in row.shares() {
            let line = &source[line * stride..(line + 1) * stride];
            light.add_line::<CHANNELS>(line, &columns, share, &mut sums);
        }
        for sum in &sums {
            let alpha = sum[3].min(1.0);
            let whole = if 0.0 < alpha { 1.0 / sum[3] } else { 0.0 };
            pixels.extend([0, 1, 2].map(|channel| light.encode(sum[channel] * whole)));
            pixels.push(alpha_byte(alpha));
        }
    }
    pixels
}

/// The pixels of a side that one pixel of the result covers.
struct Span {
    first: usize,
    last: usize,
    first_share: f32,
    last_share: f32,
    inner_share: f32,
}

impl Span {
    /// Indices with their shares, which sum to 1.
    fn shares(&self) -> impl Iterator<Item = (usize, f32)> + '_ {
        (self.first..=self.last).map(|index| {
            let share = if index == self.first {
                self.first_share
            } else if index == self.last {
                self.last_share
            } else {
                self.inner_share
            };
            (index, share)
        })
    }
}

/// What each of `to` pixels covers of `from`.
#[expect(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "sides are below 2^24 and places within them"
)]
fn spans(from: u32, to: u32) -> Vec<Span> {
    let scale = f64::from(from) / f64::from(to);
    let span = |index: u32| {
        let middle = (f64::from(index) + 0.5) * scale;
        if scale <= 1.0 {
            let at = (middle as usize).min(from as usize - 1);
            return Span {
                first: at,
                last: at,
                first_share: 1.0,
                last_share: 1.0,
                inner_share: 1.0,
            };
        }
        let (low, high) = (f64::from(index) * scale, f64::from(index + 1) * scale);
        let first = low as usize;
        // A border that falls on a pixel's own belongs to the pixel before.
        let last = ((high - 1e-9) as usize).min(from as usize - 1).max(first);
        let share = |width: f64| (width / scale) as f32;
        Span {
            first,
            last,
            first_share: share((first as f64 + 1.0).min(high) - low),
            last_share: share(high - last as f64),
            inner_share: share(1.0),
        }
    };
    (0..to).map(span).collect()
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "between 0 and 255"
)]
fn alpha_byte(alpha: f32) -> u8 {
    (alpha * 255.0 + 0.5) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_reads_back_as_the_byte_it_was() {
        let light = Light::new();
        for byte in 0..=255_u8 {
            assert_eq!(light.encode(light.decode(byte)), byte);
        }
    }

    #[test]
    fn shares_of_a_pixel_sum_to_one_and_pass_over_nothing() {
        for (from, to) in [(10, 3), (4096, 1000), (7, 7), (5, 9), (1, 1), (9, 2)] {
            let spans = spans(from, to);
            for span in &spans {
                let sum: f32 = span.shares().map(|(_, share)| share).sum();
                assert!((sum - 1.0).abs() < 1e-5, "{from} to {to}: {sum}");
            }
            assert_eq!(spans[0].first, 0);
            assert_eq!(spans[to as usize - 1].last, from as usize - 1);
            for pair in spans.windows(2) {
                assert!(pair[1].first <= pair[0].last + 1);
            }
        }
    }

    #[test]
    fn a_checkerboard_becomes_half_the_light_and_what_is_clear_has_no_color() {
        let board: Vec<u8> = (0..64_u8)
            .flat_map(|index| [if (index / 8 + index) % 2 == 0 { 255 } else { 0 }; 3])
            .collect();
        // Half of all light is 188 in sRGB.
        assert_eq!(resized::<3>(&board, [8, 8], [1, 1]), [188, 188, 188, 255]);
        let half_clear = [10, 20, 30, 255, 250, 0, 250, 0];
        assert_eq!(resized::<4>(&half_clear, [2, 1], [1, 1]), [10, 20, 30, 128]);
    }

    #[test]
    fn the_same_size_changes_nothing() {
        let picture: Vec<u8> = (0..5 * 3 * 3_u8)
            .map(|byte| byte.wrapping_mul(41))
            .collect();
        let same = resized::<3>(&picture, [5, 3], [5, 3]);
        let colors: Vec<u8> = same
            .chunks(4)
            .flat_map(|pixel| pixel[..3].to_vec())
            .collect();
        assert_eq!(colors, picture);
    }
}
