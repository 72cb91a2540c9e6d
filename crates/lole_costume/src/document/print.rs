//! The print of a document: what is drawn or which picture is taken, and the repeat it comes to.

use std::sync::Arc;

use image::{RgbaImage, imageops};
use lole_geom::Length;
use lole_language::{Bilingual, Sentence};
use lole_print::tile::{BareCloth, SizedPicture, lay_out};
use lole_print::{self as print, COLORWAYS, Colorway, Picture, PrintDesign, PrintImage, PrintLay};

use super::schema::LIST;
use super::{Design, FabricDesign, PrintChoice, Problem};

/// A picture that a document names. Whoever opens the document reads it: the pixels are not part of
/// the text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LinkedPicture {
    /// Its place from the document.
    pub name: String,
    /// What it shows; `None` until it is read.
    pub picture: Option<Arc<Picture>>,
}

impl LinkedPicture {
    /// A picture that is not read yet.
    #[must_use]
    pub fn named(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            picture: None,
        }
    }
}

/// What is known of a picture: which part of it is the repeat, and how large something on it is.
/// Places are from its upper left corner as a viewer shows it, in pixels of the file.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PhotoMarks {
    /// Left edge of the repeat [pixel]; the picture's own when `None`.
    pub crop_left_px: Option<f64>,
    /// Upper edge of the repeat [pixel]; the picture's own when `None`.
    pub crop_top_px: Option<f64>,
    /// Width of the repeat [pixel]; up to the picture's edge when `None`.
    pub crop_width_px: Option<f64>,
    /// Height of the repeat [pixel]; up to the picture's edge when `None`.
    pub crop_height_px: Option<f64>,
    /// Distance of two marked points on the cloth [cm]: it gives the size of the repeat.
    pub known_length_cm: Option<f64>,
    /// The first point, to the right [pixel].
    pub known_from_x_px: Option<f64>,
    /// The first point, down [pixel].
    pub known_from_y_px: Option<f64>,
    /// The second point, to the right [pixel].
    pub known_to_x_px: Option<f64>,
    /// The second point, down [pixel].
    pub known_to_y_px: Option<f64>,
}

impl PhotoMarks {
    /// Centimeters of cloth that a pixel of the file shows; `None` where no length is known.
    fn cm_per_pixel(&self) -> Option<f64> {
        let across = self.known_to_x_px? - self.known_from_x_px?;
        let down = self.known_to_y_px? - self.known_from_y_px?;
        let apart = (across * across + down * down).sqrt();
        (1.0 <= apart).then_some(self.known_length_cm? / apart)
    }

    fn knows_something(&self) -> bool {
        let points = [
            self.known_length_cm,
            self.known_from_x_px,
            self.known_from_y_px,
            self.known_to_x_px,
            self.known_to_y_px,
        ];
        points.iter().any(Option::is_some)
    }

    /// The part of a picture that is the repeat: left, top, width and height [pixel of the file], at
    /// least one pixel of it.
    fn crop(&self, size: [u32; 2]) -> [f64; 4] {
        let along = |start: Option<f64>, length: Option<f64>, side: u32| {
            let side = f64::from(side);
            let start = start.unwrap_or(0.0).clamp(0.0, side - 1.0);
            let length = length.unwrap_or(side).clamp(1.0, side - start);
            (start, length)
        };
        let (left, width) = along(self.crop_left_px, self.crop_width_px, size[0]);
        let (top, height) = along(self.crop_top_px, self.crop_height_px, size[1]);
        [left, top, width, height]
    }
}

/// Why a print cannot be made.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PrintError {
    /// The picture was not given with the design.
    #[error("the picture {file} was not read")]
    NotRead {
        /// Its name in the document.
        file: String,
    },
}

impl Bilingual for PrintError {
    fn japanese(&self) -> String {
        match self {
            Self::NotRead { file } => format!("画像 {file} が読み込まれていません"),
        }
    }
}

impl PrintChoice {
    /// The print to draw, where no picture is printed instead.
    #[must_use]
    pub fn print(&self) -> PrintDesign {
        // For a name set by a program and not on the list: the first.
        let colors = Colorway::from_id(self.colorway).unwrap_or(&COLORWAYS[0]);
        let ready = PrintDesign::in_colors(colors);
        PrintDesign {
            ground: self.ground.unwrap_or(ready.ground),
            flower: self.flower.unwrap_or(ready.flower),
            leaf: self.leaf.unwrap_or(ready.leaf),
            shadow: self.shadow.unwrap_or(ready.shadow),
            motif: self.motif,
            repeat: Length::from_cm(self.repeat_cm * self.lay.scale_ratio),
            seed: self.seed,
        }
    }

    /// One repeat on cloth of this width, as it lies there. What the program draws has `side` pixels
    /// on a side; a picture has as many as it comes with, up to some two thousand.
    ///
    /// # Errors
    /// A picture that was not read.
    pub fn image(&self, side: u32, cloth_width: Length) -> Result<PrintImage, PrintError> {
        let Some(file) = &self.file else {
            return Ok(self.drawn(side, cloth_width));
        };
        let Some(picture) = &file.picture else {
            let file = file.name.clone();
            return Err(PrintError::NotRead { file });
        };
        let ground = BareCloth {
            under: self.print().ground,
            beside: self.ground,
            width: cloth_width,
        };
        Ok(lay_out(self.sized(picture), &self.lay, &ground))
    }

    fn drawn(&self, side: u32, cloth_width: Length) -> PrintImage {
        let design = self.print();
        let drawn = print::draw(&design, side);
        let plain = PrintLay {
            scale_ratio: self.lay.scale_ratio,
            ..PrintLay::default()
        };
        if self.lay == plain {
            return drawn;
        }
        let picture = RgbaImage::from_raw(drawn.width, drawn.height, drawn.pixels);
        let sized = SizedPicture {
            picture: picture.unwrap_or_else(|| RgbaImage::new(1, 1)),
            size: drawn.repeat,
        };
        let ground = BareCloth {
            under: design.ground,
            beside: Some(design.ground),
            width: cloth_width,
        };
        lay_out(sized, &self.lay, &ground)
    }

    /// The part of a picture that is the repeat, and its size on the cloth.
    fn sized(&self, picture: &Picture) -> SizedPicture {
        let crop = self.marks.crop(picture.size_in_file);
        let [_, _, width, height] = crop;
        let cm_per_pixel = self.marks.cm_per_pixel();
        let cm_per_pixel = cm_per_pixel.unwrap_or(self.repeat_cm / width) * self.lay.scale_ratio;
        let size = [width, height].map(|side| Length::from_cm(side * cm_per_pixel));
        let [left, top, width, height] = kept(crop, picture);
        let whole = RgbaImage::from_raw(picture.width, picture.height, picture.pixels.clone());
        let whole = whole.unwrap_or_else(|| RgbaImage::new(1, 1));
        let picture = if [width, height] == [picture.width, picture.height] {
            whole
        } else {
            imageops::crop_imm(&whole, left, top, width, height).to_image()
        };
        SizedPicture { picture, size }
    }
}

/// A rectangle of the file, in the pixels that were kept.
fn kept([left, top, width, height]: [f64; 4], picture: &Picture) -> [u32; 4] {
    let along = |start: f64, length: f64, kept: u32, in_file: u32| {
        let scale = f64::from(kept) / f64::from(in_file);
        let first = whole(start * scale).min(kept - 1);
        (first, whole(length * scale).clamp(1, kept - first))
    };
    let [in_file_width, in_file_height] = picture.size_in_file;
    let (left, width) = along(left, width, picture.width, in_file_width);
    let (top, height) = along(top, height, picture.height, in_file_height);
    [left, top, width, height]
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "places within a picture"
)]
fn whole(pixels: f64) -> u32 {
    pixels.round() as u32
}

impl Design {
    /// One repeat of everything that is cut, as [`Self::cut`] has it (see [`PrintChoice::image`]).
    ///
    /// # Errors
    /// A picture that was not read.
    pub fn cut_print_images(&self, side: u32) -> Result<Vec<PrintImage>, PrintError> {
        let cloths = self.cut().map(|place| self.cloth_of(place));
        let images = cloths.map(|(fabric, print)| print.image(side, fabric.width()));
        images.collect()
    }

    /// The print of everything in the document: of the skirt, then of what is listed.
    pub fn prints_mut(&mut self) -> impl Iterator<Item = &mut PrintChoice> {
        let listed = self.garments.iter_mut().map(|garment| &mut garment.print);
        [&mut self.print].into_iter().chain(listed)
    }

    /// What only several keys of a print can get wrong, with the table to look at.
    pub(super) fn check_prints(&self) -> Result<(), (&'static str, Box<Problem>)> {
        let listed = (self.garments.iter()).map(|garment| (LIST, &garment.print));
        for (table, print) in [("print", &self.print)].into_iter().chain(listed) {
            print.check().map_err(|problem| (table, problem))?;
        }
        Ok(())
    }
}

impl FabricDesign {
    /// From selvage to selvage.
    #[must_use]
    pub fn width(&self) -> Length {
        Length::from_cm(self.width_cm)
    }
}

impl PrintChoice {
    fn check(&self) -> Result<(), Box<Problem>> {
        let refuse = |japanese: String, english: String| {
            let sentence = Sentence::new(japanese, english);
            Err(Box::new(Problem::Together { sentence }))
        };
        if self.marks.knows_something() && self.marks.cm_per_pixel().is_none() {
            return refuse(
                "写真の上の 2 点とその間の長さは、known_length_cm・known_from_x_px・known_from_y_px・\
                 known_to_x_px・known_to_y_px の 5 つを書き、2 点を離してください"
                    .to_owned(),
                "a known length on a photo needs known_length_cm, known_from_x_px, known_from_y_px, \
                 known_to_x_px and known_to_y_px, and the two points apart"
                    .to_owned(),
            );
        }
        if self.file.is_none() && self.marks != PhotoMarks::default() {
            return refuse(
                "known_ と crop_ は写真についての値です。file に写真を書くか、消してください"
                    .to_owned(),
                "known_ and crop_ say something of a photo; name it in file, or leave them out"
                    .to_owned(),
            );
        }
        Ok(())
    }
}
