//! One page as a list of things drawn on it.

use std::sync::Arc;

use kurbo::{Affine, BezPath, Shape as _};

use super::typeface::{MM_PER_PT, Weight, text_width};
use super::wrap::wrap;
use crate::still::ImageView;
use crate::{ExportError, still};

/// A color as printers of a home know it: red, green, blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Color(pub u8, pub u8, pub u8);

impl Color {
    /// Of text and cut lines.
    pub const BLACK: Self = Self(0, 0, 0);
    /// Of paper.
    pub const WHITE: Self = Self(255, 255, 255);
    /// Of rules and of what stands in the background.
    pub const GRAY: Self = Self(120, 120, 120);
}

/// How a line is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Stroke {
    /// Thickness [mm].
    pub width: f64,
    /// Its color.
    pub color: Color,
    /// Lengths of dashes and gaps in turn [mm]; empty for an unbroken line.
    pub dashes: Vec<f64>,
}

impl Stroke {
    /// An unbroken black line of this thickness [mm].
    #[must_use]
    pub const fn solid(width: f64) -> Self {
        Self {
            width,
            color: Color::BLACK,
            dashes: Vec::new(),
        }
    }

    /// A broken black line; dashes and gaps are equally long [mm].
    #[must_use]
    pub fn dashed(width: f64, dash: f64) -> Self {
        Self {
            dashes: vec![dash, dash],
            ..Self::solid(width)
        }
    }

    /// The line in another color.
    #[must_use]
    pub fn with_color(self, color: Color) -> Self {
        Self { color, ..self }
    }
}

/// How letters look.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TextStyle {
    /// Thickness of their strokes.
    pub weight: Weight,
    /// Size of an em [pt].
    pub size_pt: f64,
    /// Their color.
    pub color: Color,
}

impl TextStyle {
    /// Text to read: 12.5 pt, which older eyes read without effort.
    #[must_use]
    pub const fn body() -> Self {
        Self::regular(12.5)
    }

    /// Black letters of this size [pt].
    #[must_use]
    pub const fn regular(size_pt: f64) -> Self {
        Self {
            weight: Weight::Regular,
            size_pt,
            color: Color::BLACK,
        }
    }

    /// Black bold letters of this size [pt].
    #[must_use]
    pub const fn bold(size_pt: f64) -> Self {
        Self {
            weight: Weight::Bold,
            ..Self::regular(size_pt)
        }
    }

    /// The letters in another color.
    #[must_use]
    pub const fn with_color(self, color: Color) -> Self {
        Self { color, ..self }
    }

    /// Width of one line of text [mm].
    #[must_use]
    pub fn width_of(&self, text: &str) -> f64 {
        text_width(text, self.weight, self.size_pt)
    }

    /// From one baseline to the next [mm]: 1.6 em, the usual leading of Japanese text.
    #[must_use]
    pub fn line_height(&self) -> f64 {
        1.6 * self.em()
    }

    /// Size of an em [mm].
    #[must_use]
    pub fn em(&self) -> f64 {
        self.size_pt * MM_PER_PT
    }

    /// The text in lines no wider than `width` [mm].
    #[must_use]
    pub fn wrap(&self, text: &str, width: f64) -> Vec<String> {
        wrap(text, self.weight, self.size_pt, width)
    }
}

/// Where text stands about its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Align {
    /// It begins there.
    Left,
    /// Its middle is there.
    Center,
    /// It ends there.
    Right,
}

/// A rectangle on a page [mm].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rect {
    /// Left edge from the page's left.
    pub x: f64,
    /// Upper edge from the page's top.
    pub y: f64,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
}

impl Rect {
    /// The largest rectangle of these proportions in the middle of this one.
    #[must_use]
    pub fn fitting(self, width: f64, height: f64) -> Self {
        let scale = (self.width / width).min(self.height / height);
        let (width, height) = (width * scale, height * scale);
        Self {
            x: self.x + (self.width - width) * 0.5,
            y: self.y + (self.height - height) * 0.5,
            width,
            height,
        }
    }

    /// Its edges as a path.
    #[must_use]
    pub fn to_path(self) -> BezPath {
        kurbo::Rect::new(self.x, self.y, self.x + self.width, self.y + self.height).to_path(0.1)
    }
}

/// An encoded picture; cheap to copy.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EncodedPicture {
    /// Width [pixel].
    pub width: u32,
    /// Height [pixel].
    pub height: u32,
    pub(super) bytes: Arc<Vec<u8>>,
    pub(super) encoding: Encoding,
}

/// How a picture is encoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Jpeg,
    Png,
}

impl EncodedPicture {
    /// A photograph-like picture, small in the file.
    ///
    /// # Errors
    /// As [`still::encode_jpeg`].
    pub fn photo(image: ImageView<'_>) -> Result<Self, ExportError> {
        let bytes = Arc::new(still::encode_jpeg(image, 88)?);
        Ok(Self::new(image, bytes, Encoding::Jpeg))
    }

    /// A picture of which every pixel is kept, transparency included.
    ///
    /// # Errors
    /// As [`still::encode_png`].
    pub fn exact(image: ImageView<'_>) -> Result<Self, ExportError> {
        let bytes = Arc::new(still::encode_png(image)?);
        Ok(Self::new(image, bytes, Encoding::Png))
    }

    /// The encoded bytes.
    pub(crate) fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// How the bytes are encoded, as browsers say it.
    pub(crate) const fn media_type(&self) -> &'static str {
        match self.encoding {
            Encoding::Jpeg => "image/jpeg",
            Encoding::Png => "image/png",
        }
    }

    /// A picture that is a JPEG already, of this width and height [pixel]; `None` of other bytes.
    #[must_use]
    pub fn of_jpeg(bytes: Vec<u8>, [width, height]: [u32; 2]) -> Option<Self> {
        let is_jpeg = bytes.starts_with(&[0xff, 0xd8]) && bytes.ends_with(&[0xff, 0xd9]);
        is_jpeg.then(|| Self {
            width,
            height,
            bytes: Arc::new(bytes),
            encoding: Encoding::Jpeg,
        })
    }

    const fn new(image: ImageView<'_>, bytes: Arc<Vec<u8>>, encoding: Encoding) -> Self {
        Self {
            width: image.width,
            height: image.height,
            bytes,
            encoding,
        }
    }
}

/// One thing on a page.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// Lines and shapes.
    Path {
        /// The path [mm].
        path: BezPath,
        /// Color of its inside.
        fill: Option<Color>,
        /// Its line.
        stroke: Option<Stroke>,
    },
    /// One line of text.
    Text {
        /// Left end of its baseline [mm].
        at: [f64; 2],
        /// The text.
        text: String,
        /// Its letters.
        style: TextStyle,
    },
    /// A picture.
    Picture {
        /// Where it stands.
        rect: Rect,
        /// What it shows.
        picture: EncodedPicture,
    },
    /// Things drawn elsewhere, at another size, or cut off: one tile of a large drawing.
    Group {
        /// Page from the space of `items`.
        page_from_group: Affine,
        /// Nothing outside of it is seen [mm on the page].
        clip: Option<Rect>,
        /// What is drawn; shared between the pages that show parts of it.
        items: Arc<Vec<Self>>,
    },
}

/// One page.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// Width and height [mm].
    pub size: [f64; 2],
    /// What is on it, the lowest first.
    pub items: Vec<Item>,
    /// What readers list beside the pages, to go to this one.
    pub bookmarks: Vec<String>,
}

impl Sheet {
    /// An empty page of this size [mm].
    #[must_use]
    pub const fn new(size: [f64; 2]) -> Self {
        Self {
            size,
            items: Vec::new(),
            bookmarks: Vec::new(),
        }
    }

    /// Draws a straight line.
    pub fn line(&mut self, from: [f64; 2], to: [f64; 2], stroke: Stroke) {
        let mut path = BezPath::new();
        path.move_to((from[0], from[1]));
        path.line_to((to[0], to[1]));
        self.path(path, None, Some(stroke));
    }

    /// Draws a rectangle.
    pub fn rect(&mut self, rect: Rect, fill: Option<Color>, stroke: Option<Stroke>) {
        self.path(rect.to_path(), fill, stroke);
    }

    /// Draws a path.
    pub fn path(&mut self, path: BezPath, fill: Option<Color>, stroke: Option<Stroke>) {
        self.items.push(Item::Path { path, fill, stroke });
    }

    /// Writes one line of text; `at` lies on its baseline. Returns its width [mm].
    pub fn text(&mut self, at: [f64; 2], text: &str, style: &TextStyle, align: Align) -> f64 {
        let width = style.width_of(text);
        let shift = match align {
            Align::Left => 0.0,
            Align::Center => 0.5 * width,
            Align::Right => width,
        };
        self.items.push(Item::Text {
            at: [at[0] - shift, at[1]],
            text: text.to_owned(),
            style: *style,
        });
        width
    }

    /// Writes text in lines from the upper left corner `at` on. Returns its height [mm].
    pub fn paragraph(&mut self, at: [f64; 2], width: f64, text: &str, style: &TextStyle) -> f64 {
        let lines = style.wrap(text, width);
        for (index, line) in (0_u32..).zip(&lines) {
            let baseline = at[1] + style.line_height() * f64::from(index) + baseline(style);
            self.text([at[0], baseline], line, style, Align::Left);
        }
        style.line_height() * f64::from(u32::try_from(lines.len()).unwrap_or(u32::MAX))
    }

    /// Writes one line of text turned counterclockwise by `angle` [rad] about the middle of its
    /// baseline, which stands at `at`.
    pub fn turned_text(&mut self, at: [f64; 2], angle: f64, text: &str, style: &TextStyle) {
        let mut turned = Self::new(self.size);
        turned.text([0.0, 0.0], text, style, Align::Center);
        self.items.push(Item::Group {
            page_from_group: Affine::translate((at[0], at[1])) * Affine::rotate(-angle),
            clip: None,
            items: Arc::new(turned.items),
        });
    }

    /// Shows a picture, as large as fits into the middle of `rect`. Returns where it stands.
    pub fn picture(&mut self, rect: Rect, picture: &EncodedPicture) -> Rect {
        let rect = rect.fitting(f64::from(picture.width), f64::from(picture.height));
        let picture = picture.clone();
        self.items.push(Item::Picture { rect, picture });
        rect
    }

    /// Everything written on the page, in order.
    #[must_use]
    pub fn texts(&self) -> Vec<&str> {
        texts_of(&self.items)
    }
}

fn texts_of(items: &[Item]) -> Vec<&str> {
    (items.iter())
        .flat_map(|item| match item {
            Item::Text { text, .. } => vec![text.as_str()],
            Item::Group { items, .. } => texts_of(items),
            Item::Path { .. } | Item::Picture { .. } => Vec::new(),
        })
        .collect()
}

/// From the top of a line of text to its baseline [mm]: letters stand in the middle of the leading.
pub(super) fn baseline(style: &TextStyle) -> f64 {
    // Full-width letters reach 0.88 em above the baseline and 0.12 em below it.
    0.5 * (style.line_height() - style.em()) + 0.88 * style.em()
}
