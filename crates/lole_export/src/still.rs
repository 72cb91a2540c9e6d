//! Stills: PNG where every pixel must stay, JPEG where a page must stay small.

use crate::ExportError;

/// A picture to write: rows from the top, four bytes a pixel (red, green, blue, alpha), sRGB.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ImageView<'a> {
    /// Width [pixel].
    pub width: u32,
    /// Height [pixel].
    pub height: u32,
    /// Pixels, shape `[height, width, 4]`.
    pub pixels: &'a [u8],
}

/// Longest side of a JPEG [pixel]: its header stores 16 bits.
const JPEG_LIMIT: u32 = 65_535;

impl<'a> ImageView<'a> {
    /// Checks that the pixels fill the size.
    ///
    /// # Errors
    /// [`ExportError::PixelCount`] when they do not, or when the picture is empty.
    pub fn new(width: u32, height: u32, pixels: &'a [u8]) -> Result<Self, ExportError> {
        let expected = width as usize * height as usize * 4;
        if expected == 0 || pixels.len() != expected {
            let actual = pixels.len();
            return Err(ExportError::PixelCount {
                width,
                height,
                expected,
                actual,
            });
        }
        Ok(Self {
            width,
            height,
            pixels,
        })
    }
}

/// PNG bytes of an sRGB picture; alpha is kept only where some pixel needs it.
///
/// # Errors
/// [`ExportError::PixelCount`] when the picture's columns do not fit its size, or
/// [`ExportError::Encoding`] from the encoder.
pub fn encode_png(image: ImageView<'_>) -> Result<Vec<u8>, ExportError> {
    let image = ImageView::new(image.width, image.height, image.pixels)?;
    let opaque = image.pixels.chunks_exact(4).all(|pixel| pixel[3] == 255);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, image.width, image.height);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.set_compression(png::Compression::Balanced);
    encoder.set_color(if opaque {
        png::ColorType::Rgb
    } else {
        png::ColorType::Rgba
    });
    let written = encoder.write_header().and_then(|mut writer| {
        if opaque {
            writer.write_image_data(&rgb_of(image.pixels))?;
        } else {
            writer.write_image_data(image.pixels)?;
        }
        writer.finish()
    });
    match written {
        Ok(()) => Ok(bytes),
        Err(error) => Err(ExportError::Encoding {
            file: "PNG",
            cause: error.to_string(),
        }),
    }
}

/// JPEG bytes of an sRGB picture over white, at `quality` 1 to 100.
///
/// Chroma is kept at full resolution from quality 90, where saturated prints would smear.
///
/// # Errors
/// [`ExportError::PixelCount`] or [`ExportError::PictureSize`] for a picture that cannot be
/// stored, [`ExportError::Encoding`] from the encoder.
pub fn encode_jpeg(image: ImageView<'_>, quality: u8) -> Result<Vec<u8>, ExportError> {
    let image = ImageView::new(image.width, image.height, image.pixels)?;
    let (Ok(width), Ok(height)) = (u16::try_from(image.width), u16::try_from(image.height)) else {
        return Err(ExportError::PictureSize {
            format: "JPEG",
            width: image.width,
            height: image.height,
            limit: JPEG_LIMIT,
        });
    };
    let quality = quality.clamp(1, 100);
    let mut bytes = Vec::new();
    let mut encoder = jpeg_encoder::Encoder::new(&mut bytes, quality);
    encoder.set_optimized_huffman_tables(true);
    encoder.set_sampling_factor(if quality < 90 {
        jpeg_encoder::SamplingFactor::R_4_2_0
    } else {
        jpeg_encoder::SamplingFactor::R_4_4_4
    });
    encoder
        .encode(
            &over_white(image.pixels),
            width,
            height,
            jpeg_encoder::ColorType::Rgb,
        )
        .map_err(|error| ExportError::Encoding {
            file: "JPEG",
            cause: error.to_string(),
        })?;
    Ok(bytes)
}

/// The three color bytes of every pixel.
fn rgb_of(rgba: &[u8]) -> Vec<u8> {
    rgba.chunks_exact(4)
        .flat_map(|pixel| [pixel[0], pixel[1], pixel[2]])
        .collect()
}

/// The three color bytes of every pixel laid over white.
fn over_white(rgba: &[u8]) -> Vec<u8> {
    let blend = |channel: u8, alpha: u8| {
        let (channel, alpha) = (u16::from(channel), u16::from(alpha));
        u8::try_from((channel * alpha + 255 * (255 - alpha) + 127) / 255).unwrap_or(u8::MAX)
    };
    rgba.chunks_exact(4)
        .flat_map(|pixel| [0, 1, 2].map(|index| blend(pixel[index], pixel[3])))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A soft gradient with one transparent pixel.
    fn pixels() -> Vec<u8> {
        let mut pixels: Vec<u8> = (0..64_u8)
            .flat_map(|index| [index * 4, 128, 255 - index, 255])
            .collect();
        pixels[3] = 0;
        pixels
    }

    #[test]
    fn png_gives_back_every_bit() {
        let pixels = pixels();
        for (pixels, channels) in [(pixels.clone(), 4), ([9, 8, 7, 255].repeat(64), 3)] {
            let bytes = encode_png(ImageView::new(8, 8, &pixels).unwrap()).unwrap();
            let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
                .read_info()
                .unwrap();
            let mut back = vec![0; reader.output_buffer_size().unwrap()];
            reader.next_frame(&mut back).unwrap();
            let wanted: Vec<u8> = pixels
                .chunks_exact(4)
                .flat_map(|pixel| pixel[..channels].to_vec())
                .collect();
            assert_eq!(back, wanted);
        }
    }

    #[test]
    fn jpeg_says_its_size_and_gets_larger_with_quality() {
        let pixels = pixels();
        let image = ImageView::new(8, 8, &pixels).unwrap();
        let [low, high] = [30, 95].map(|quality| encode_jpeg(image, quality).unwrap());
        assert!(low.starts_with(&[0xff, 0xd8]) && low.ends_with(&[0xff, 0xd9]));
        assert!(low.len() < high.len());
        assert_eq!(over_white(&pixels)[..3], [255, 255, 255]);
    }

    #[test]
    fn pictures_that_do_not_fill_their_size_are_refused() {
        let error = ImageView::new(4, 4, &[0; 63]).unwrap_err();
        assert!(error.to_string().contains("64 bytes"), "{error}");
        let image = ImageView {
            width: 70_000,
            height: 1,
            pixels: &[255; 280_000],
        };
        assert!(
            encode_jpeg(image, 90)
                .unwrap_err()
                .to_string()
                .contains("65535")
        );
    }
}
