//! What is printed on cloth: a Hawaiian-style print drawn by the program, in one repeat that tiles
//! without a seam, or a [`Picture`] of someone's own; and how it lies on the cloth.
//!
//! The crate knows no garment but the rectangle that a print is laid on, no document and no file.

mod canvas;
mod cloth;
pub mod colorway;
mod geometry;
mod lay;
mod layout;
mod motif;
pub mod picture;
mod shape;
pub mod tile;

use lole_geom::Length;

use canvas::Canvas;
use geometry::Geometry;
use motif::{Recipe, Shadow};

pub use cloth::{ClothPicture, cloth_picture};
pub use colorway::{COLORWAYS, Colorway};
pub use lay::{PrintBorder, PrintDirection, PrintFlip, PrintLay, PrintTiling};
pub use motif::{MOTIFS, MotifRow, PrintMotif};
pub use picture::{Picture, PictureError};

/// A print before it is drawn. Colors are sRGB bytes.
#[derive(Debug, Clone, PartialEq)]
pub struct PrintDesign {
    /// Color of the ground.
    pub ground: [u8; 3],
    /// Color of the flowers, or of the fruit.
    pub flower: [u8; 3],
    /// Color of the large leaves.
    pub leaf: [u8; 3],
    /// Color of the quiet second layer, close to the ground.
    pub shadow: [u8; 3],
    /// What is drawn.
    pub motif: PrintMotif,
    /// Width and height of one repeat on the cloth.
    pub repeat: Length,
    /// Chooses places and turns.
    pub seed: u64,
}

/// A drawn repeat.
#[derive(Debug, Clone, PartialEq)]
pub struct PrintImage {
    /// Width [pixel].
    pub width: u32,
    /// Height [pixel].
    pub height: u32,
    /// RGBA8 in sRGB, rows from the top, opaque, shape `[height, width, 4]`.
    pub pixels: Vec<u8>,
    /// Length along the cloth and height across it of the picture.
    pub repeat: [Length; 2],
    /// Where its lower left corner lies from the lower left corner of the cloth.
    pub offset: [Length; 2],
    /// Which selvage it lies along, where it does not cover the cloth.
    pub border: PrintBorder,
}

impl PrintDesign {
    /// Hibiscus in the colorway of this name; `None` for a name not in [`COLORWAYS`].
    #[must_use]
    pub fn colorway(name: &str) -> Option<Self> {
        Colorway::from_id(name).map(Self::in_colors)
    }

    /// Hibiscus in these colors.
    #[must_use]
    pub fn in_colors(colors: &Colorway) -> Self {
        Self {
            ground: colors.ground,
            flower: colors.flower,
            leaf: colors.leaf,
            shadow: colors.shadow,
            motif: PrintMotif::Hibiscus,
            repeat: Length::from_cm(42.0),
            seed: 1,
        }
    }
}

/// Draws one repeat of `size` × `size` pixels; the same design gives the same bytes.
#[must_use]
pub fn draw(design: &PrintDesign, size: u32) -> PrintImage {
    let size = size.clamp(1, SIZE_MAX);
    let mut canvas = Canvas::new(design, size);
    match &design.motif.row().recipe {
        Recipe::Bare => {}
        Recipe::Geometry(geometry) => {
            for part in &geometry.parts(design.seed) {
                canvas.draw(part);
            }
        }
        Recipe::Scatter(scatter) => {
            if matches!(scatter.shadow, Shadow::Surf) {
                for part in &Geometry::Surf.parts(design.seed) {
                    canvas.draw(part);
                }
            }
            for placement in &layout::place(scatter, design.seed) {
                canvas.stamp(placement);
            }
        }
    }
    PrintImage {
        width: size,
        height: size,
        pixels: canvas.into_pixels(),
        repeat: [design.repeat; 2],
        offset: [Length::ZERO; 2],
        border: PrintBorder::None,
    }
}

/// Largest picture [pixel]; a repeat of 45 cm then has 460 pixels per inch.
const SIZE_MAX: u32 = 8192;

#[cfg(test)]
mod tests {
    use super::*;

    fn pixel(image: &PrintImage, x: u32, y: u32) -> [u8; 3] {
        let at = 4 * (y * image.width + x) as usize;
        [image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]]
    }

    /// Mean absolute difference between two columns, or two rows, of a picture.
    fn difference(image: &PrintImage, [a, b]: [u32; 2], at: fn(u32, u32) -> (u32, u32)) -> f64 {
        let sum: u32 = (0..image.width)
            .map(|along| {
                let [(ax, ay), (bx, by)] = [at(a, along), at(b, along)];
                let (p, q) = (pixel(image, ax, ay), pixel(image, bx, by));
                (0..3)
                    .map(|channel| u32::from(p[channel].abs_diff(q[channel])))
                    .sum::<u32>()
            })
            .sum();
        f64::from(sum) / f64::from(image.width)
    }

    #[test]
    fn the_repeat_has_no_seam() {
        for (name, seed) in [("red", 1), ("niihau", 5)] {
            for motif in MOTIFS.iter().map(|row| row.motif) {
                let design = PrintDesign {
                    motif,
                    seed,
                    ..PrintDesign::colorway(name).unwrap()
                };
                let image = draw(&design, 256);
                for at in [|line, along| (line, along), |line, along| (along, line)] {
                    let inside: f64 = (0..255)
                        .map(|line| difference(&image, [line, line + 1], at))
                        .fold(0.0, f64::max);
                    let seam = difference(&image, [255, 0], at);
                    assert!(
                        seam <= inside,
                        "{name} {motif:?}: {seam} over the edge, {inside} inside"
                    );
                }
            }
        }
    }

    #[test]
    fn motifs_and_ground_share_the_cloth() {
        for (name, seed) in [("red", 1), ("pink", 2), ("blue", 3), ("green", 4)] {
            let design = PrintDesign {
                seed,
                ..PrintDesign::colorway(name).unwrap()
            };
            let image = draw(&design, 256);
            let share = |color: [u8; 3]| {
                let near = image.pixels.chunks_exact(4).filter(|pixel| {
                    (0..3).all(|channel| pixel[channel].abs_diff(color[channel]) < 6)
                });
                near.count() as f64 / (256.0 * 256.0)
            };
            let (flower, leaf) = (share(design.flower), share(design.leaf));
            let ground = share(design.ground) + share(design.shadow);
            assert!((0.12..0.35).contains(&flower), "{name}: flowers {flower}");
            assert!((0.14..0.42).contains(&leaf), "{name}: leaves {leaf}");
            assert!((0.25..0.60).contains(&ground), "{name}: ground {ground}");
            assert!(image.pixels.chunks_exact(4).all(|pixel| pixel[3] == 255));
        }
    }

    #[test]
    fn the_same_design_gives_the_same_print_and_another_seed_another() {
        let design = PrintDesign::colorway("red").unwrap();
        assert_eq!(draw(&design, 200), draw(&design, 200));
        let other = PrintDesign {
            seed: 7,
            ..design.clone()
        };
        assert_ne!(draw(&design, 200), draw(&other, 200));
        assert!(PrintDesign::colorway("plaid").is_none());
    }
}
