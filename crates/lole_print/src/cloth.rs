//! The cloth of a cut plan with its print, seen from above as it lies on the table.

use lole_geom::Length;
use lole_pattern::Marker;
use lole_pattern::polygon::Polygon;

use super::PrintImage;

/// A picture of cloth with its print.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ClothPicture {
    /// Width [pixel], along the cloth.
    pub width: u32,
    /// Height [pixel], across it.
    pub height: u32,
    /// RGBA8 in sRGB, rows from the upper selvage, opaque, shape `[height, width, 4]`.
    pub pixels: Vec<u8>,
}

/// Longest side of the picture [pixel].
const LONGEST: f64 = 1600.0;
/// Points that are mixed for one pixel, along each side: motifs are much finer than the plan's pixels.
const MIXED: u32 = 3;
/// Part of white in the print on pieces, so that lines and names on it can be read.
const WHITE_ON_PIECES: f64 = 0.35;
/// And on what is left over, so that the pieces stand out.
const WHITE_BESIDE: f64 = 0.72;

/// The cloth of a plan, `length` along the warp by `across`, its print where the pieces will have it.
/// Doubled cloth is shown by its lower layer.
#[must_use]
pub fn cloth_picture(print: &PrintImage, marker: &Marker, across: Length) -> ClothPicture {
    let [length, across] = [marker.yardage.needed, across].map(|side| side.to_m().max(1e-3));
    let pixels_per_m = (LONGEST / length.max(across)).min(1000.0);
    let [width, height] = [length, across].map(|side| whole(side * pixels_per_m).max(1));
    let outlines: Vec<&Polygon> = marker.placed.iter().map(|placed| &placed.outline).collect();
    let mut pixels = Vec::with_capacity(4 * width as usize * height as usize);
    for row in 0..height {
        let y = across * (1.0 - (f64::from(row) + 0.5) / f64::from(height));
        let spans = spans(&outlines, y);
        for column in 0..width {
            let x = length * (f64::from(column) + 0.5) / f64::from(width);
            let is_piece = spans.iter().any(|[from, to]| (*from..*to).contains(&x));
            let white = if is_piece {
                WHITE_ON_PIECES
            } else {
                WHITE_BESIDE
            };
            let color = mixed(print, [x, y], 1.0 / pixels_per_m);
            pixels.extend(color.map(|channel| byte(channel + (255.0 - channel) * white)));
            pixels.push(255);
        }
    }
    ClothPicture {
        width,
        height,
        pixels,
    }
}

/// Where a level lies within pieces, by even and odd crossings.
fn spans(outlines: &[&Polygon], y: f64) -> Vec<[f64; 2]> {
    let mut spans = Vec::new();
    for outline in outlines {
        let mut crossings: Vec<f64> = (outline.sides())
            .filter(|[a, b]| (a.y <= y) != (b.y <= y))
            .map(|[a, b]| a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y))
            .collect();
        crossings.sort_by(f64::total_cmp);
        spans.extend(crossings.chunks_exact(2).map(|pair| [pair[0], pair[1]]));
    }
    spans
}

/// Mean color around a place on the cloth, over a square of this side [m].
fn mixed(print: &PrintImage, [x, y]: [f64; 2], side: f64) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for index in 0..MIXED * MIXED {
        let aside = |step: u32| side * ((f64::from(step) + 0.5) / f64::from(MIXED) - 0.5);
        let at = [x + aside(index % MIXED), y + aside(index / MIXED)];
        let color = print.color_at(at.map(Length::from_m));
        for (sum, channel) in sum.iter_mut().zip(color) {
            *sum += f64::from(channel);
        }
    }
    sum.map(|channel| channel / f64::from(MIXED * MIXED))
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a channel of a color"
)]
fn byte(channel: f64) -> u8 {
    channel.round().clamp(0.0, 255.0) as u8
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a side of at most some thousand pixels"
)]
fn whole(pixels: f64) -> u32 {
    pixels.round() as u32
}

#[cfg(test)]
mod tests {
    use lole_pattern::marker::{Nap, Placed, TableCloth};
    use lole_pattern::{Yardage, marker::Lay};

    use super::*;
    use crate::PrintBorder;

    /// Half of the cloth is a piece; the print is black below 0.5 m and white above.
    fn picture() -> ClothPicture {
        let outline =
            Polygon::new([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(Into::into));
        let marker = Marker {
            cloth: TableCloth {
                width: Length::from_m(1.0),
                nap: Nap::TwoWay,
                border: None,
                matched_repeat: None,
                lay: Lay::Single,
            },
            placed: vec![Placed {
                piece: 0,
                copy: 0,
                layers: 1,
                cloth_from_piece: Default::default(),
                outline,
                is_on_fold: false,
            }],
            folded_length: Length::ZERO,
            yardage: Yardage::for_length(Length::from_m(2.0)),
            efficiency: 0.5,
            warnings: Vec::new(),
        };
        let print = PrintImage {
            width: 1,
            height: 2,
            pixels: vec![255, 255, 255, 255, 0, 0, 0, 255],
            repeat: [Length::from_m(1.0); 2],
            offset: [Length::ZERO; 2],
            border: PrintBorder::None,
        };
        cloth_picture(&print, &marker, Length::from_m(1.0))
    }

    #[test]
    fn the_print_lies_on_the_cloth_as_the_maker_sees_it_and_pieces_stand_out() {
        let picture = picture();
        assert_eq!([picture.width, picture.height], [1600, 800]);
        let at = |x: u32, y: u32| picture.pixels[4 * (y * picture.width + x) as usize];
        // White above, black below, paler beside the piece than on it.
        assert_eq!(at(100, 100), 255);
        assert_eq!(at(1500, 100), 255);
        let (on, beside) = (at(100, 700), at(1500, 700));
        assert!(on < beside && beside < 255, "{on} {beside}");
        assert_eq!(on, byte(255.0 * WHITE_ON_PIECES));
    }
}
