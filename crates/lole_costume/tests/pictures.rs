//! Pictures of cloth: what comes from a file is upright, of the right size, and never breaks the
//! program.

#![allow(
    clippy::unwrap_used,
    clippy::cast_possible_truncation,
    reason = "a test that meets anything unexpected should stop"
)]

use std::io::Cursor;
use std::sync::Arc;

use image::codecs::jpeg::JpegEncoder;
use image::{ImageFormat, Rgb, RgbImage};
use lole_costume::document::{Design, LinkedPicture, PrintChoice, parse};
use lole_geom::Length;
use lole_language::Bilingual as _;
use lole_print::picture::KEPT_SIDE;
use lole_print::{Picture, PictureError, PrintBorder, PrintImage};
use proptest::prelude::*;

const RED: Rgb<u8> = Rgb([220, 20, 20]);
const BLUE: Rgb<u8> = Rgb([20, 20, 220]);

/// Red on the left, blue on the right.
fn halves(width: u32, height: u32) -> RgbImage {
    RgbImage::from_fn(width, height, |x, _| if 2 * x < width { RED } else { BLUE })
}

fn png(picture: &RgbImage) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, ImageFormat::Png).unwrap();
    bytes.into_inner()
}

fn jpeg(picture: &RgbImage) -> Vec<u8> {
    let mut bytes = Vec::new();
    let encoder = JpegEncoder::new_with_quality(&mut bytes, 95);
    picture.write_with_encoder(encoder).unwrap();
    bytes
}

/// A JPEG whose camera was held so (EXIF 2.3, tag 274).
fn jpeg_held(picture: &RgbImage, orientation: u8) -> Vec<u8> {
    let mut exif = b"Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0".to_vec();
    exif.extend([orientation, 0, 0, 0, 0, 0, 0]);
    let length = u16::try_from(exif.len() + 2).unwrap().to_be_bytes();
    let plain = jpeg(picture);
    [&plain[..2], &[0xff, 0xe1], &length, &exif, &plain[2..]].concat()
}

/// Whether the pixel is nearer to red than to blue.
fn is_red(picture: &Picture, x: u32, y: u32) -> bool {
    let start = 4 * (y * picture.width + x) as usize;
    picture.pixels[start + 2] < picture.pixels[start]
}

#[test]
fn photos_stand_as_the_camera_was_held() {
    let stored = halves(48, 32);
    // Where red comes to lie: left, right, top or bottom.
    for (orientation, red) in (1..=8).zip(["l", "r", "r", "l", "t", "t", "b", "b"]) {
        let picture = Picture::read(&jpeg_held(&stored, orientation)).unwrap();
        let size = if orientation < 5 { [48, 32] } else { [32, 48] };
        assert_eq!([picture.width, picture.height], size, "{orientation}");
        assert_eq!(picture.size_in_file, size, "{orientation}");
        let (middle, center) = (size[0] / 2, size[1] / 2);
        let [near, far] = match red {
            "l" | "r" => [(4, center), (size[0] - 5, center)],
            _ => [(middle, 4), (middle, size[1] - 5)],
        };
        let first = is_red(&picture, near.0, near.1);
        assert_ne!(first, is_red(&picture, far.0, far.1), "{orientation}");
        assert_eq!(first, red == "l" || red == "t", "{orientation}");
    }
}

#[test]
fn a_large_picture_is_kept_smaller_and_remembers_its_size() {
    let picture = Picture::read(&png(&halves(2 * KEPT_SIDE, 30))).unwrap();
    assert_eq!([picture.width, picture.height], [KEPT_SIDE, 15]);
    assert_eq!(picture.size_in_file, [2 * KEPT_SIDE, 30]);
    assert!(is_red(&picture, KEPT_SIDE / 2 - 2, 7));
    assert!(!is_red(&picture, KEPT_SIDE / 2 + 2, 7));
}

/// A PNG that says it is so large, with the checksum of its header right.
fn png_of_size(width: u32, height: u32) -> Vec<u8> {
    let mut bytes = png(&halves(1, 1));
    bytes[16..20].copy_from_slice(&width.to_be_bytes());
    bytes[20..24].copy_from_slice(&height.to_be_bytes());
    let checksum = bytes[12..29].iter().fold(u32::MAX, |sum, byte| {
        (0..8).fold(sum ^ u32::from(*byte), |sum, _| {
            (sum >> 1) ^ (0xedb8_8320 * (sum & 1))
        })
    });
    bytes[29..33].copy_from_slice(&(!checksum).to_be_bytes());
    bytes
}

#[test]
fn thirty_thousand_pixels_are_refused_before_memory_is_asked_for() {
    for (width, height) in [(30_000, 30_000), (30_000, 10), (8000, 8000), (20_001, 2)] {
        let error = Picture::read(&png_of_size(width, height)).unwrap_err();
        assert_eq!(error, PictureError::TooLarge { width, height });
        assert!(error.to_string().contains("make it smaller"), "{error}");
        assert!(error.japanese().contains("小さく"), "{error}");
    }
}

#[test]
fn a_picture_that_breaks_off_is_refused() {
    for whole in [png(&halves(64, 64)), jpeg(&halves(64, 64))] {
        Picture::read(&whole).unwrap();
        for length in [20, whole.len() / 2, whole.len() - 30] {
            let error = Picture::read(&whole[..length]).unwrap_err();
            assert!(matches!(error, PictureError::Broken { .. }), "{error}");
        }
    }
    // What it says it holds is not there.
    let error = Picture::read(&png_of_size(7000, 7000)).unwrap_err();
    assert!(matches!(error, PictureError::Broken { .. }), "{error}");
}

const DRAWING: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100">
<rect width="100" height="100" fill="#dc1414"/><circle cx="150" cy="50" r="40" fill="#1414dc"/></svg>"##;

#[test]
fn a_drawing_is_drawn_fine_and_clear_where_it_is_empty() {
    let picture = Picture::read(DRAWING.as_bytes()).unwrap();
    assert_eq!([picture.width, picture.height], [2048, 1024]);
    assert_eq!(picture.size_in_file, [200, 100]);
    assert!(is_red(&picture, 500, 500));
    assert!(!is_red(&picture, 1536, 512));
    // A corner beside the circle.
    assert_eq!(picture.pixels[4 * 2047 + 3], 0);
}

#[test]
fn what_a_drawing_would_lose_is_refused() {
    let with = |part: &str| {
        let text = DRAWING.replace("</svg>", &format!("{part}</svg>"));
        Picture::read(text.as_bytes())
    };
    assert_eq!(with("<text>hula</text>"), Err(PictureError::SvgText));
    assert_eq!(with("<image href=\"a.png\"/>"), Err(PictureError::SvgImage));
    assert!(with("<text> </text>").is_ok());
    for text in [
        "<svg",
        "<html><body/></html>",
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"0\" height=\"5\"/>",
    ] {
        Picture::read(text.as_bytes()).unwrap_err();
    }
}

#[test]
fn entities_that_multiply_are_refused() {
    let mut text = String::from("<!DOCTYPE svg [<!ENTITY a \"ha\">");
    for (from, to) in "abcdefghijklm".chars().zip("bcdefghijklmn".chars()) {
        text.push_str(&format!(
            "<!ENTITY {to} \"{}\">",
            format!("&{from};").repeat(10)
        ));
    }
    text.push_str("]><svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\">&n;</svg>");
    Picture::read(text.as_bytes()).unwrap_err();
}

/// The print of a document whose picture was read.
fn printed(keys: &str, picture: &RgbImage) -> PrintImage {
    let text = format!("lole = 1\n[print]\nfile = \"cloth.png\"\n{keys}");
    let mut design = parse(&text, "mine.lole").unwrap();
    design.print.file.as_mut().unwrap().picture =
        Some(Arc::new(Picture::read(&png(picture)).unwrap()));
    design.cut_print_images(64).unwrap().remove(0)
}

#[test]
fn the_repeat_is_as_wide_as_the_document_says_and_as_high_as_the_picture() {
    let image = printed("repeat_cm = 60", &halves(300, 100));
    assert_eq!(image.repeat, [60.0, 20.0].map(Length::from_cm));
    let image = printed("repeat_cm = 60\nscale_ratio = 0.5", &halves(300, 100));
    assert_eq!(image.repeat, [30.0, 10.0].map(Length::from_cm));
}

#[test]
fn two_points_and_their_distance_give_the_size() {
    // 3-4-5: the points are 50 pixels apart, which are 10 cm; 300 pixels are 60 cm.
    let keys = "known_length_cm = 10\nknown_from_x_px = 20\nknown_from_y_px = 30\n\
                known_to_x_px = 60\nknown_to_y_px = 60\n";
    let image = printed(keys, &halves(300, 100));
    for (found, expected) in image
        .repeat
        .map(Length::to_cm)
        .into_iter()
        .zip([60.0, 20.0])
    {
        assert!((found - expected).abs() < 1e-9, "{found}");
    }
    let cropped = format!("{keys}crop_left_px = 150\ncrop_width_px = 100\n");
    let image = printed(&cropped, &halves(300, 100));
    assert!((image.repeat[0].to_cm() - 20.0).abs() < 1e-9);
    assert_eq!(image.width, 100);
    assert!(
        image.pixels[2] > image.pixels[0],
        "only the blue half is left"
    );
}

#[test]
fn half_known_lengths_and_marks_without_a_photo_are_refused_with_the_keys() {
    for (keys, said) in [
        ("file = \"a.png\"\nknown_length_cm = 10", "known_to_y_px"),
        (
            "file = \"a.png\"\nknown_length_cm = 10\nknown_from_x_px = 3\nknown_from_y_px = 3\n\
             known_to_x_px = 3\nknown_to_y_px = 3",
            "apart",
        ),
        ("crop_left_px = 3", "file"),
    ] {
        let error = parse(&format!("lole = 1\n[print]\n{keys}\n"), "mine.lole").unwrap_err();
        let text = error.to_string();
        assert!(text.starts_with("mine.lole:2: [print]"), "{text}");
        assert!(text.contains(said), "{text}");
    }
    let garment = "lole = 1\n[[garment]]\nkind = \"pau-top\"\n[garment.print]\ncrop_top_px = 1\n";
    let error = parse(garment, "mine.lole").unwrap_err();
    assert!(
        error.to_string().starts_with("mine.lole:2: [garment]"),
        "{error}"
    );
}

#[test]
fn a_picture_that_was_not_read_is_an_error_and_no_other_print() {
    let mut design = Design::default();
    design.print.file = Some(LinkedPicture::named("cloth.png"));
    let error = design.cut_print_images(64).unwrap_err();
    assert_eq!(error.to_string(), "the picture cloth.png was not read");
}

#[test]
fn a_drawn_print_can_be_a_border() {
    let mut choice = PrintChoice::default();
    choice.lay.border = PrintBorder::Hip;
    let image = choice.image(128, Length::from_cm(110.0)).unwrap();
    assert_eq!(image.repeat, [42.0, 110.0].map(Length::from_cm));
    let ground = choice.print().ground;
    let colors = |across: f64| {
        let at =
            (0..42).map(|along| image.color_at([f64::from(along), across].map(Length::from_cm)));
        at.filter(|color| *color == ground).count()
    };
    assert_eq!(colors(80.0), 42);
    assert!(colors(20.0) < 40);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(96) })]

    #[test]
    fn damaged_pictures_never_panic(
        kind in 0..3_usize,
        damage in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..12),
        cut in any::<prop::sample::Index>(),
    ) {
        let mut bytes = match kind {
            0 => png(&halves(40, 30)),
            1 => jpeg_held(&halves(40, 30), 6),
            _ => DRAWING.replace("<circle", "<g filter=\"url(#f)\" transform=\"scale(2)\"/><circle").into_bytes(),
        };
        for (place, byte) in damage {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        if cut.index(4) == 0 {
            let length = cut.index(bytes.len());
            bytes.truncate(length);
        }
        match Picture::read(&bytes) {
            Ok(picture) => prop_assert_eq!(
                picture.pixels.len(),
                4 * picture.width as usize * picture.height as usize
            ),
            Err(error) => {
                prop_assert!(!error.to_string().contains('\n'));
                prop_assert!(!error.japanese().contains('\n'));
            }
        }
    }

    #[test]
    fn arbitrary_bytes_never_panic(start in 0..5_usize, bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        let magic: [&[u8]; 5] = [b"", b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff", b"<svg ", b"\0\0\0\x18ftyp"];
        let _either = Picture::read(&[magic[start], &bytes].concat());
    }

    #[test]
    fn any_marks_and_lay_give_a_repeat(
        numbers in proptest::collection::vec(0.0..20_000.0_f64, 8),
        scale in 0.1..10.0_f64,
        offset in -400.0..400.0_f64,
        choices in proptest::collection::vec(0..4_usize, 4),
    ) {
        let mut choice = PrintChoice {
            file: Some(LinkedPicture {
                name: "cloth.png".to_owned(),
                picture: Some(Arc::new(Picture::read(&png(&halves(30, 20))).unwrap())),
            }),
            ..PrintChoice::default()
        };
        let marks = &mut choice.marks;
        marks.crop_left_px = Some(numbers[0]);
        marks.crop_top_px = Some(numbers[1]);
        marks.crop_width_px = Some(numbers[2]);
        marks.crop_height_px = Some(numbers[3]);
        marks.known_length_cm = Some(0.5 + numbers[4] / 50.0);
        marks.known_from_x_px = Some(numbers[5]);
        marks.known_from_y_px = Some(numbers[6]);
        marks.known_to_x_px = Some(numbers[7]);
        marks.known_to_y_px = Some(0.0);
        let text = format!(
            "lole = 1\n[print]\ndirection = \"{}\"\nflip = \"{}\"\ntiling = \"{}\"\nborder = \"{}\"\n\
             scale_ratio = {scale:?}\noffset_across_cm = {offset:?}\noffset_along_cm = {offset:?}\n",
            ["up", "right", "down", "left"][choices[0]],
            ["none", "sideways", "upside-down"][choices[1] % 3],
            ["straight", "half-drop", "brick", "mirror"][choices[2]],
            ["none", "hem", "hip"][choices[3] % 3],
        );
        choice.lay = parse(&text, "mine.lole").unwrap().print.lay;
        let image = choice.image(64, Length::from_cm(110.0)).unwrap();
        prop_assert_eq!(image.pixels.len(), 4 * image.width as usize * image.height as usize);
        prop_assert!(image.width.max(image.height) <= 4096);
        prop_assert!(image.pixels.chunks_exact(4).all(|pixel| pixel[3] == 255));
        let uv = image.uv_from_cloth();
        prop_assert!(uv.is_finite());
    }
}
