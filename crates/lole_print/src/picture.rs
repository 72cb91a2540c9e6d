//! A picture of cloth that someone else drew or photographed: PNG, JPEG or SVG, upright and of a
//! size that a print needs.
//!
//! Bytes come from anywhere, so every size is looked at before memory is asked for, and what cannot
//! be read is refused in one sentence with what to do.

mod error;
mod raster;
mod resize;
mod vector;

pub use error::PictureError;
pub(super) use resize::{Light, resized};

/// A picture as it is seen, rows from the top.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    /// Width and height in the file, upright, as a viewer tells them [pixel]; user units of an SVG
    /// are rounded.
    pub size_in_file: [u32; 2],
    /// Width of what is kept [pixel].
    pub width: u32,
    /// Height of what is kept [pixel].
    pub height: u32,
    /// RGBA8 in sRGB, alpha not multiplied in, shape `[height, width, 4]`.
    pub pixels: Vec<u8>,
}

/// Longest side of what is kept [pixel]: on 110 cm of cloth a pixel is then a quarter of a
/// millimeter, and a yarn of broadcloth is as wide.
pub const KEPT_SIDE: u32 = 4096;
/// Longest side of a picture that is read [pixel].
pub const LONGEST_SIDE: u32 = 20_000;
/// Pixels of a picture that is read, at most: what a good camera takes. A progressive JPEG of that
/// size needs about half a gigabyte while it is read, and no picture needs more.
pub const MOST_PIXELS: u64 = 52_000_000;

impl Picture {
    /// Reads a picture from the bytes of a file; the kind is told by the bytes alone.
    ///
    /// # Errors
    /// Bytes that are no picture, a kind that is not read, a picture that is broken or too large.
    pub fn read(bytes: &[u8]) -> Result<Self, PictureError> {
        match kind(bytes) {
            Kind::Raster => raster::read(bytes),
            Kind::Svg => vector::read(bytes),
            Kind::Other(format) => Err(PictureError::OtherFormat { format }),
            Kind::Heic => Err(PictureError::Heic),
            Kind::Unknown => Err(PictureError::NotPicture),
        }
    }
}

/// Whether a picture of this size is read.
fn check_size(width: u32, height: u32) -> Result<(), PictureError> {
    let fits = width.max(height) <= LONGEST_SIDE
        && u64::from(width) * u64::from(height) <= MOST_PIXELS
        && 0 < width.min(height);
    if fits {
        Ok(())
    } else {
        Err(PictureError::TooLarge { width, height })
    }
}

enum Kind {
    Raster,
    Svg,
    Heic,
    Other(&'static str),
    Unknown,
}

/// What the first bytes say.
fn kind(bytes: &[u8]) -> Kind {
    let starts = |magic: &[u8]| bytes.starts_with(magic);
    let at = |start: usize, word: &[u8]| bytes.get(start..start + word.len()) == Some(word);
    if starts(b"\x89PNG\r\n\x1a\n") || starts(b"\xff\xd8\xff") {
        return Kind::Raster;
    }
    if at(4, b"ftyp") {
        return Kind::Heic;
    }
    let others: [(&[u8], &str); 7] = [
        (b"GIF8", "GIF"),
        (b"BM", "BMP"),
        (b"II*\0", "TIFF"),
        (b"MM\0*", "TIFF"),
        (b"%PDF", "PDF"),
        (b"8BPS", "Photoshop"),
        (b"\x1f\x8b", "gzip (SVGZ)"),
    ];
    if let Some((_, format)) = others.into_iter().find(|(magic, _)| starts(magic)) {
        return Kind::Other(format);
    }
    if starts(b"RIFF") && at(8, b"WEBP") {
        return Kind::Other("WebP");
    }
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if text.trim_ascii_start().starts_with(b"<") {
        return Kind::Svg;
    }
    Kind::Unknown
}

#[cfg(test)]
mod tests {
    use lole_language::Bilingual as _;

    use super::*;

    #[test]
    fn what_is_no_picture_is_refused_by_name_and_with_a_remedy() {
        for (bytes, said) in [
            (&b""[..], "PNG, JPEG or SVG"),
            (b"hello", "PNG, JPEG or SVG"),
            (b"GIF89a....", "GIF"),
            (b"RIFF\x10\0\0\0WEBPVP8 ", "WebP"),
            (b"\0\0\0\x18ftypheic\0\0\0\0mif1heic", "HEIC"),
            (b"\x1f\x8b\x08\0", "SVGZ"),
        ] {
            let error = Picture::read(bytes).unwrap_err();
            assert!(error.to_string().contains(said), "{error}");
            assert!(!error.japanese().is_empty());
        }
    }
}
