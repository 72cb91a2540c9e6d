//! From a picture to one repeat on the cloth: cropped, turned, flipped, tiled, or laid as a border
//! along a selvage.

use image::{RgbaImage, imageops};
use lole_geom::Length;

use super::picture::{Light, resized};
use super::{PrintBorder, PrintDirection, PrintFlip, PrintImage, PrintLay, PrintTiling};

/// Longest side of a repeat that is made from a picture [pixel].
const REPEAT_SIDE: u32 = 2048;

/// A picture and how large it is on the cloth.
pub struct SizedPicture {
    /// Upright.
    pub picture: RgbaImage,
    /// Width and height on the cloth, before it is turned.
    pub size: [Length; 2],
}

/// The cloth under a print.
pub struct BareCloth {
    /// What shows through where the picture is clear.
    pub under: [u8; 3],
    /// What lies beside a border; the picture's own edge where `None`.
    pub beside: Option<[u8; 3]>,
    /// From selvage to selvage.
    pub width: Length,
}

/// The repeat of a picture on its cloth.
pub fn lay_out(sized: SizedPicture, lay: &PrintLay, ground: &BareCloth) -> PrintImage {
    let SizedPicture { picture, size } = turned(sized, lay);
    let copies = copies(lay);
    let mut whole = [0, 1].map(|axis| size[axis] * f64::from(copies[axis]));
    if lay.border != PrintBorder::None {
        whole[1] = ground.width;
    }
    let from = [picture.width(), picture.height()];
    // As fine as the picture is, and no finer than one repeat may be.
    let to = [0, 1].map(|axis| {
        let most = f64::from(REPEAT_SIDE) * (size[axis].to_m() / whole[axis].to_m());
        pixel_count(most.min(f64::from(from[axis])))
    });
    let mut small = RgbaImage::from_raw(to[0], to[1], resized::<4>(&picture, from, to))
        .unwrap_or_else(|| RgbaImage::new(to[0], to[1]));
    drop(picture);
    cover(&mut small, ground.under);
    let tile = tiled(&small, lay, copies);
    let offset = [lay.offset_along_cm, lay.offset_across_cm].map(Length::from_cm);
    if lay.border == PrintBorder::None {
        return image(tile, whole, offset, lay.border);
    }
    let rows_per_meter = f64::from(tile.height()) / size[1].to_m();
    let strip = along_selvage(&tile, rows_per_meter, offset[1], ground);
    image(strip, whole, [offset[0], Length::ZERO], lay.border)
}

fn image(
    pixels: RgbaImage,
    repeat: [Length; 2],
    offset: [Length; 2],
    border: PrintBorder,
) -> PrintImage {
    PrintImage {
        width: pixels.width(),
        height: pixels.height(),
        pixels: pixels.into_raw(),
        repeat,
        offset,
        border,
    }
}

/// Flipped as it is seen upright, then turned on the cloth.
fn turned(sized: SizedPicture, lay: &PrintLay) -> SizedPicture {
    let SizedPicture { mut picture, size } = sized;
    match lay.flip {
        PrintFlip::None => {}
        PrintFlip::Sideways => imageops::flip_horizontal_in_place(&mut picture),
        PrintFlip::UpsideDown => imageops::flip_vertical_in_place(&mut picture),
    }
    let [width, height] = size;
    let (picture, size) = match lay.direction {
        PrintDirection::Up => (picture, size),
        PrintDirection::Down => (imageops::rotate180(&picture), size),
        PrintDirection::Right => (imageops::rotate90(&picture), [height, width]),
        PrintDirection::Left => (imageops::rotate270(&picture), [height, width]),
    };
    SizedPicture { picture, size }
}

/// Pictures of one repeat, along the cloth and across it.
fn copies(lay: &PrintLay) -> [u32; 2] {
    match (lay.tiling, lay.border) {
        (PrintTiling::Mirror, PrintBorder::None) => [2, 2],
        (PrintTiling::Mirror, _) | (PrintTiling::HalfDrop, PrintBorder::None) => [2, 1],
        (PrintTiling::Brick, PrintBorder::None) => [1, 2],
        _ => [1, 1],
    }
}

/// Lays the copies beside each other.
fn tiled(picture: &RgbaImage, lay: &PrintLay, [across, down]: [u32; 2]) -> RgbaImage {
    let (width, height) = picture.dimensions();
    RgbaImage::from_fn(width * across, height * down, |x, y| {
        let (column, row) = (x / width, y / height);
        let (mut x, mut y) = (x % width, y % height);
        match lay.tiling {
            PrintTiling::Straight => {}
            PrintTiling::HalfDrop => y = (y + column * (height / 2)) % height,
            PrintTiling::Brick => x = (x + row * (width / 2)) % width,
            PrintTiling::Mirror => {
                x = if column == 1 { width - 1 - x } else { x };
                y = if row == 1 { height - 1 - y } else { y };
            }
        }
        *picture.get_pixel(x, y)
    })
}

/// A strip across the whole cloth with the picture's lower edge `offset` above the lower selvage.
fn along_selvage(
    tile: &RgbaImage,
    rows_per_meter: f64,
    offset: Length,
    ground: &BareCloth,
) -> RgbaImage {
    let (width, height) = tile.dimensions();
    let rows = pixel_count(rows_per_meter * ground.width.to_m());
    let beside = ground.beside.unwrap_or_else(|| mean_of_row(tile, 0));
    let [red, green, blue] = beside;
    let mut strip = RgbaImage::from_pixel(width, rows, image::Rgba([red, green, blue, 255]));
    #[expect(clippy::cast_possible_truncation, reason = "saturates")]
    let up = (rows_per_meter * offset.to_m()).round() as i64;
    let top = i64::from(rows) - i64::from(height) - up;
    imageops::replace(&mut strip, tile, 0, top);
    strip
}

/// Mean light of a row of pixels.
fn mean_of_row(picture: &RgbaImage, row: u32) -> [u8; 3] {
    let stride = picture.width() as usize * 4;
    let line = &picture.as_raw()[row as usize * stride..][..stride];
    let mean = resized::<4>(line, [picture.width(), 1], [1, 1]);
    [mean[0], mean[1], mean[2]]
}

/// Lays a picture over a color, so that nothing of it is clear.
fn cover(picture: &mut RgbaImage, under: [u8; 3]) {
    let light = Light::new();
    for pixel in picture.pixels_mut() {
        let alpha = f32::from(pixel[3]) / 255.0;
        if pixel[3] < 255 {
            for (channel, under) in under.into_iter().enumerate() {
                let mixed =
                    light.decode(pixel[channel]) * alpha + light.decode(under) * (1.0 - alpha);
                pixel[channel] = light.encode(mixed);
            }
            pixel[3] = 255;
        }
    }
}

/// A number of pixels, at least one.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "saturates, and sizes are positive"
)]
fn pixel_count(pixels: f64) -> u32 {
    (pixels.round() as u32).clamp(1, 2 * REPEAT_SIDE)
}

#[cfg(test)]
mod tests {
    use super::*;

    const RED: [u8; 4] = [200, 0, 0, 255];
    const BLUE: [u8; 4] = [0, 0, 200, 255];
    const GREEN: [u8; 4] = [0, 200, 0, 255];
    const WHITE: [u8; 4] = [255; 4];

    /// Red and blue above green and white, 20 cm wide and 10 cm high.
    fn flag() -> SizedPicture {
        let quarter = |x: u32, y: u32| match (x < 10, y < 5) {
            (true, true) => RED,
            (false, true) => BLUE,
            (true, false) => GREEN,
            (false, false) => WHITE,
        };
        SizedPicture {
            picture: RgbaImage::from_fn(20, 10, |x, y| image::Rgba(quarter(x, y))),
            size: [20.0, 10.0].map(Length::from_cm),
        }
    }

    fn ground() -> BareCloth {
        BareCloth {
            under: [1, 2, 3],
            beside: None,
            width: Length::from_cm(110.0),
        }
    }

    fn laid(lay: &PrintLay) -> PrintImage {
        lay_out(flag(), lay, &ground())
    }

    /// What lies `along` and `across` the cloth, in centimeters from its lower corner.
    fn color(image: &PrintImage, along: f64, across: f64) -> [u8; 3] {
        image.color_at([along, across].map(Length::from_cm))
    }

    fn rgb(color: [u8; 4]) -> [u8; 3] {
        [color[0], color[1], color[2]]
    }

    #[test]
    fn a_picture_stands_upright_on_the_cloth_from_its_corner() {
        let image = laid(&PrintLay::default());
        assert_eq!(image.repeat, [20.0, 10.0].map(Length::from_cm));
        for (along, across) in [(0.0, 0.0), (40.0, 30.0), (-20.0, 10.0)] {
            let at = |x: f64, y: f64| color(&image, along + x, across + y);
            assert_eq!(at(5.0, 7.5), rgb(RED));
            assert_eq!(at(15.0, 7.5), rgb(BLUE));
            assert_eq!(at(5.0, 2.5), rgb(GREEN));
            assert_eq!(at(15.0, 2.5), rgb(WHITE));
        }
    }

    #[test]
    fn its_top_points_where_the_direction_says() {
        // The middle of its upper edge, which is red on its left and blue on its right.
        for (direction, red, blue) in [
            (PrintDirection::Up, (5.0, 9.0), (15.0, 9.0)),
            (PrintDirection::Down, (15.0, 1.0), (5.0, 1.0)),
            (PrintDirection::Right, (9.0, 15.0), (9.0, 5.0)),
            (PrintDirection::Left, (1.0, 5.0), (1.0, 15.0)),
        ] {
            let lay = PrintLay {
                direction,
                ..PrintLay::default()
            };
            let image = laid(&lay);
            assert_eq!(color(&image, red.0, red.1), rgb(RED), "{direction:?}");
            assert_eq!(color(&image, blue.0, blue.1), rgb(BLUE), "{direction:?}");
        }
    }

    #[test]
    fn flips_are_of_the_upright_picture() {
        let flipped = |flip| {
            laid(&PrintLay {
                flip,
                ..PrintLay::default()
            })
        };
        assert_eq!(color(&flipped(PrintFlip::Sideways), 5.0, 7.5), rgb(BLUE));
        assert_eq!(color(&flipped(PrintFlip::UpsideDown), 5.0, 7.5), rgb(GREEN));
    }

    #[test]
    fn half_drops_bricks_and_mirrors_lie_as_their_names_say() {
        let tiled = |tiling| {
            laid(&PrintLay {
                tiling,
                ..PrintLay::default()
            })
        };
        let drop = tiled(PrintTiling::HalfDrop);
        assert_eq!(color(&drop, 25.0, 7.5), rgb(GREEN), "half a height lower");
        assert_eq!(color(&drop, 45.0, 7.5), rgb(RED));
        let brick = tiled(PrintTiling::Brick);
        assert_eq!(color(&brick, 5.0, 17.5), rgb(RED));
        assert_eq!(color(&brick, 5.0, 7.5), rgb(BLUE), "half a width aside");
        let mirror = tiled(PrintTiling::Mirror);
        assert_eq!(color(&mirror, 5.0, 17.5), rgb(RED));
        assert_eq!(color(&mirror, 25.0, 17.5), rgb(BLUE));
        assert_eq!(color(&mirror, 35.0, 2.5), rgb(RED));
    }

    #[test]
    fn a_border_lies_at_the_selvage_and_its_ground_beside_it() {
        let lay = PrintLay {
            border: PrintBorder::Hem,
            ..PrintLay::default()
        };
        let plain = BareCloth {
            beside: Some([9, 8, 7]),
            ..ground()
        };
        let image = lay_out(flag(), &lay, &plain);
        assert_eq!(image.repeat[1], Length::from_cm(110.0));
        assert_eq!(color(&image, 5.0, 2.5), rgb(GREEN));
        assert_eq!(color(&image, 45.0, 7.5), rgb(RED));
        for across in [10.5, 60.0, 109.0] {
            assert_eq!(color(&image, 5.0, across), [9, 8, 7]);
        }
        let higher = PrintLay {
            offset_across_cm: 4.0,
            ..lay
        };
        let image = lay_out(flag(), &higher, &plain);
        assert_eq!(color(&image, 5.0, 6.5), rgb(GREEN));
        assert_eq!(color(&image, 5.0, 2.0), [9, 8, 7]);
    }

    #[test]
    fn offsets_move_the_picture_along_and_across() {
        let lay = PrintLay {
            offset_along_cm: 3.0,
            offset_across_cm: -2.0,
            ..PrintLay::default()
        };
        let image = laid(&lay);
        assert_eq!(color(&image, 3.5, -1.5), rgb(GREEN));
        assert_eq!(color(&image, 2.5, -1.5), rgb(WHITE));
        assert_eq!(color(&image, 3.5, -2.5), rgb(RED));
    }

    #[test]
    fn what_is_clear_shows_the_ground() {
        let clear = SizedPicture {
            picture: RgbaImage::from_pixel(4, 4, image::Rgba([255, 255, 255, 0])),
            size: [Length::from_cm(10.0); 2],
        };
        let image = lay_out(clear, &PrintLay::default(), &ground());
        assert!(image.pixels.chunks(4).all(|pixel| pixel == [1, 2, 3, 255]));
    }
}
