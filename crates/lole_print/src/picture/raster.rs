//! PNG and JPEG, turned upright as their EXIF orientation says.

use std::io::Cursor;

use image::{DynamicImage, ImageDecoder as _, ImageReader, Limits, RgbaImage};

use super::{KEPT_SIDE, Picture, PictureError, check_size, resized};

/// Memory that the reader may ask for at once [byte]: [`MOST_PIXELS`](super::MOST_PIXELS) with
/// four channels of 16 bits.
const MOST_BYTES: u64 = 8 * super::MOST_PIXELS + (1 << 20);

pub(super) fn read(bytes: &[u8]) -> Result<Picture, PictureError> {
    let broken = |error: image::ImageError| PictureError::broken(&error);
    let mut reader = ImageReader::new(Cursor::new(bytes))
        .with_guessed_format()
        .map_err(|error| PictureError::broken(&error))?;
    let mut limits = Limits::default();
    limits.max_alloc = Some(MOST_BYTES);
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(broken)?;
    let (width, height) = decoder.dimensions();
    check_size(width, height)?;
    if bytes.starts_with(b"\xff\xd8") && !is_whole_jpeg(bytes) {
        return Err(PictureError::broken(&"its end is missing"));
    }
    let orientation = decoder.orientation().map_err(broken)?;
    let decoded = DynamicImage::from_decoder(decoder).map_err(broken)?;
    let (kept_width, kept_height, pixels) = reduced(decoded);
    let kept = RgbaImage::from_raw(kept_width, kept_height, pixels);
    let kept = kept.ok_or_else(|| PictureError::broken(&"its size is wrong"))?;
    let mut upright = DynamicImage::ImageRgba8(kept);
    upright.apply_orientation(orientation);
    let upright = upright.into_rgba8();
    let lies = upright.dimensions() != (kept_width, kept_height);
    // A square shows no difference, and needs none.
    let size_in_file = if lies {
        [height, width]
    } else {
        [width, height]
    };
    Ok(Picture {
        size_in_file,
        width: upright.width(),
        height: upright.height(),
        pixels: upright.into_raw(),
    })
}

/// The picture at the size that is kept: width, height and RGBA.
fn reduced(decoded: DynamicImage) -> (u32, u32, Vec<u8>) {
    let size @ [width, height] = [decoded.width(), decoded.height()];
    let [kept_width, kept_height] = kept_size(size);
    // Photos are RGB: no copy of 50 million pixels only for an alpha of 255.
    let pixels = match &decoded {
        DynamicImage::ImageRgb8(rgb) => {
            resized::<3>(rgb, [width, height], [kept_width, kept_height])
        }
        _ => resized::<4>(
            &decoded.into_rgba8(),
            [width, height],
            [kept_width, kept_height],
        ),
    };
    (kept_width, kept_height, pixels)
}

/// The size with the longer side brought down to [`KEPT_SIDE`].
fn kept_size([width, height]: [u32; 2]) -> [u32; 2] {
    let longest = width.max(height);
    if longest <= KEPT_SIDE {
        return [width, height];
    }
    let share = |side: u32| {
        let kept = u64::from(side) * u64::from(KEPT_SIDE) / u64::from(longest);
        u32::try_from(kept).unwrap_or(KEPT_SIDE).max(1)
    };
    [share(width), share(height)]
}

/// Whether the marker that ends a JPEG follows its pixels: readers fill what is missing with gray.
fn is_whole_jpeg(bytes: &[u8]) -> bool {
    const START_OF_SCAN: u8 = 0xda;
    let mut at = 2;
    while let Some(&[0xff, marker, high, low]) = bytes.get(at..at + 4) {
        if marker == START_OF_SCAN {
            // Within the pixels a byte of 255 is followed by 0 or a restart, never by this.
            return bytes[at..].windows(2).any(|pair| pair == [0xff, 0xd9]);
        }
        // Filling bytes before a marker.
        at += match marker {
            0xff => 1,
            _ => 2 + usize::from(u16::from_be_bytes([high, low])),
        };
    }
    false
}
