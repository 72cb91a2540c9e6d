//! Draws the prints that the program makes, to look at.
//!
//! `cargo run -p lole_print --example print_sheet -- FOLDER` writes `prints.png`, one repeat of every
//! motif in a colorway of its own; with `COLORWAY SEED` it writes three repeats each way of every motif,
//! one file each.

#![allow(
    clippy::unwrap_used,
    reason = "an example stops at what it did not expect"
)]

use std::path::Path;

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{DynamicImage, RgbaImage, imageops};
use lole_print::{COLORWAYS, Colorway, MOTIFS, PrintDesign, draw};

/// Pixels of one repeat, alone and in the overview.
const SIDE: u32 = 400;
const SMALL_SIDE: u32 = 220;
/// Pixels between two prints of the overview, and prints in its rows.
const GAP: u32 = 12;
const COLUMNS: u32 = 5;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let folder = Path::new(words.first().map_or(".", String::as_str));
    match words.get(1..) {
        Some([colorway, seed]) => {
            let colors = Colorway::from_id(colorway).unwrap();
            sheets(folder, colors, seed.parse().unwrap());
        }
        _ => overview(&folder.join("prints.png")),
    }
}

fn repeat(design: &PrintDesign, side: u32) -> RgbaImage {
    let drawn = draw(design, side);
    RgbaImage::from_raw(drawn.width, drawn.height, drawn.pixels).unwrap()
}

fn sheets(folder: &Path, colors: &Colorway, seed: u64) {
    for row in MOTIFS {
        let design = PrintDesign {
            motif: row.motif,
            seed,
            ..PrintDesign::in_colors(colors)
        };
        let repeat = repeat(&design, SIDE);
        let mut sheet = RgbaImage::new(3 * SIDE, 3 * SIDE);
        imageops::tile(&mut sheet, &repeat);
        sheet.save(folder.join(format!("{}.png", row.id))).unwrap();
    }
}

fn overview(file: &Path) {
    let place = |index: usize| {
        let index = u32::try_from(index).unwrap();
        [index % COLUMNS, index / COLUMNS].map(|cell| GAP + cell * (SMALL_SIDE + GAP))
    };
    let [_, last] = place(MOTIFS.len() - 1);
    let size = [GAP + COLUMNS * (SMALL_SIDE + GAP), last + SMALL_SIDE + GAP];
    let mut sheet = RgbaImage::from_pixel(size[0], size[1], image::Rgba([255; 4]));
    for (index, row) in MOTIFS.iter().enumerate() {
        let colors = &COLORWAYS[(7 * index + 2) % COLORWAYS.len()];
        let design = PrintDesign {
            motif: row.motif,
            ..PrintDesign::in_colors(colors)
        };
        let drawn = repeat(&design, SMALL_SIDE);
        let [x, y] = place(index).map(i64::from);
        imageops::replace(&mut sheet, &drawn, x, y);
    }
    let bytes = std::fs::File::create(file).unwrap();
    let encoder = PngEncoder::new_with_quality(bytes, CompressionType::Best, FilterType::NoFilter);
    DynamicImage::ImageRgba8(sheet)
        .into_rgb8()
        .write_with_encoder(encoder)
        .unwrap();
}
