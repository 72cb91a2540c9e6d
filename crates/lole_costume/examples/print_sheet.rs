//! Draws every print that the program makes, three repeats each way, to look at:
//! `cargo run -p lole_costume --example print_sheet -- FOLDER [COLORWAY] [SEED] [MOTIF]`.

#![allow(
    clippy::unwrap_used,
    reason = "an example stops at what it did not expect"
)]

use image::RgbaImage;
use lole_costume::print::{MOTIFS, PrintDesign, draw};

/// Pixels of one repeat.
const SIDE: u32 = 400;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let word = |place: usize| words.get(place).map(String::as_str);
    let folder = std::path::Path::new(word(0).unwrap_or("."));
    let colors = PrintDesign::colorway(word(1).unwrap_or("red")).unwrap();
    let seed = word(2).map_or(1, |seed| seed.parse().unwrap());
    let wanted = MOTIFS
        .iter()
        .filter(|row| word(3).is_none_or(|id| id == row.id));
    for row in wanted {
        let design = PrintDesign {
            motif: row.motif,
            seed,
            ..colors.clone()
        };
        let repeat = draw(&design, SIDE);
        let sheet = RgbaImage::from_fn(3 * SIDE, 3 * SIDE, |x, y| {
            let start = 4 * ((y % SIDE) * SIDE + x % SIDE) as usize;
            image::Rgba([0, 1, 2, 3].map(|channel| repeat.pixels[start + channel]))
        });
        sheet.save(folder.join(format!("{}.png", row.id))).unwrap();
    }
}
