//! Sheets to the bytes of a PDF.

use krilla::Data;
use krilla::SerializeSettings;
use krilla::color::rgb;
use krilla::destination::XyzDestination;
use krilla::geom::{Path, PathBuilder, Point, Size, Transform};
use krilla::image::Image;
use krilla::metadata::Metadata;
use krilla::outline::{Outline, OutlineNode};
use krilla::page::PageSettings;
use krilla::paint::{Fill, FillRule, LineCap, LineJoin, Stroke as PdfStroke, StrokeDash};
use krilla::surface::Surface;
use krilla::text::{Font, GlyphId, KrillaGlyph};
use kurbo::{Affine, BezPath, PathEl};
use lole_geom::narrow;
use lole_language::Language;

use super::sheet::{Color, EncodedPicture, Encoding, Item, Rect, Sheet, Stroke, TextStyle};
use super::typeface::{MM_PER_PT, Weight, printable, shape};
use crate::ExportError;

/// Points of a millimeter.
const PT_PER_MM: f64 = 1.0 / MM_PER_PT;

/// Pages in order.
#[derive(Debug, Clone, PartialEq)]
pub struct Document {
    /// Shown by readers at the top of their window.
    pub title: String,
    /// Language tag of the text: `"ja"` or `"en"`.
    pub language: &'static str,
    /// The pages.
    pub sheets: Vec<Sheet>,
}

impl Document {
    /// Pages under a title, of which the text is in one of the product's languages.
    #[must_use]
    pub fn new(title: &str, language: Language, sheets: Vec<Sheet>) -> Self {
        Self {
            title: title.to_owned(),
            language: language.pick("ja", "en"),
            sheets,
        }
    }

    /// The document as PDF; equal sheets give equal bytes.
    ///
    /// # Errors
    /// [`ExportError::Encoding`] for a picture or a document that cannot be written.
    pub fn to_bytes(&self) -> Result<Vec<u8>, ExportError> {
        let failed = |cause: String| ExportError::Encoding { file: "PDF", cause };
        let fonts =
            [Weight::Regular, Weight::Bold].map(|weight| Font::new(Data::from(weight.bytes()), 0));
        let [Some(regular), Some(bold)] = fonts else {
            return Err(failed("the built-in fonts cannot be read".to_owned()));
        };
        let fonts = Fonts { regular, bold };
        let mut document = krilla::Document::new_with(SerializeSettings {
            enable_tagging: false,
            ..SerializeSettings::default()
        });
        document.set_metadata(
            Metadata::new()
                .title(printable(&self.title))
                .language(self.language.to_owned())
                .producer("Lole".to_owned()),
        );
        for sheet in &self.sheets {
            let [width, height] = sheet.size.map(|side| narrow(side * PT_PER_MM));
            let settings = PageSettings::from_wh(width, height)
                .ok_or_else(|| failed(format!("a page of {:?} mm", sheet.size)))?;
            let mut page = document.start_page_with(settings);
            let mut surface = page.surface();
            surface.push_transform(&transform(Affine::scale(PT_PER_MM)));
            let mut painter = Painter {
                surface: &mut surface,
                fonts: &fonts,
            };
            let drawn = painter.draw(&sheet.items);
            surface.pop();
            surface.finish();
            page.finish();
            drawn.map_err(failed)?;
        }
        document.set_outline(self.outline());
        document
            .finish()
            .map_err(|error| failed(format!("{error:?}")))
    }
}

impl Document {
    /// The bookmarks of all pages, in order.
    fn outline(&self) -> Outline {
        let mut outline = Outline::new();
        for (index, sheet) in self.sheets.iter().enumerate() {
            for text in &sheet.bookmarks {
                let top = XyzDestination::new(index, Point::from_xy(0.0, 0.0));
                outline.push_child(OutlineNode::new(printable(text), top));
            }
        }
        outline
    }
}

struct Fonts {
    regular: Font,
    bold: Font,
}

/// A page that is being drawn.
struct Painter<'p, 's> {
    surface: &'p mut Surface<'s>,
    fonts: &'p Fonts,
}

impl Painter<'_, '_> {
    fn draw(&mut self, items: &[Item]) -> Result<(), String> {
        for item in items {
            match item {
                Item::Path { path, fill, stroke } => {
                    self.draw_path(path, *fill, stroke.as_ref());
                }
                Item::Text { at, text, style } => self.draw_text(*at, text, style),
                Item::Picture { rect, picture } => self.draw_picture(*rect, picture)?,
                Item::Group {
                    page_from_group,
                    clip,
                    items,
                } => {
                    let clip = clip.and_then(|clip| path_of(&clip.to_path()));
                    if let Some(clip) = &clip {
                        self.surface.push_clip_path(clip, &FillRule::NonZero);
                    }
                    self.surface.push_transform(&transform(*page_from_group));
                    let drawn = self.draw(items);
                    self.surface.pop();
                    if clip.is_some() {
                        self.surface.pop();
                    }
                    drawn?;
                }
            }
        }
        Ok(())
    }

    fn draw_path(&mut self, path: &BezPath, fill: Option<Color>, stroke: Option<&Stroke>) {
        // A path without extent has nothing to draw.
        let Some(path) = path_of(path) else { return };
        self.surface.set_fill(fill.map(fill_of));
        self.surface.set_stroke(stroke.map(|stroke| PdfStroke {
            paint: color(stroke.color).into(),
            width: narrow(stroke.width),
            line_cap: LineCap::Butt,
            line_join: LineJoin::Round,
            dash: (!stroke.dashes.is_empty()).then(|| StrokeDash {
                array: stroke.dashes.iter().copied().map(narrow).collect(),
                offset: 0.0,
            }),
            ..PdfStroke::default()
        }));
        self.surface.draw_path(&path);
    }

    fn draw_text(&mut self, at: [f64; 2], text: &str, style: &TextStyle) {
        let text = printable(text);
        let shaped = shape(&text, style.weight);
        let glyphs: Vec<KrillaGlyph> = (0..shaped.len())
            .map(|index| {
                let glyph = shaped[index];
                // Letters joined to one cluster share its stretch of the text.
                let end = (shaped[index..].iter().map(|next| next.cluster))
                    .find(|&next| glyph.cluster < next)
                    .unwrap_or(text.len());
                KrillaGlyph::new(
                    GlyphId::new(glyph.id),
                    narrow(glyph.advance),
                    narrow(glyph.offset[0]),
                    narrow(glyph.offset[1]),
                    0.0,
                    glyph.cluster..end,
                    None,
                )
            })
            .collect();
        let font = match style.weight {
            Weight::Regular => &self.fonts.regular,
            Weight::Bold => &self.fonts.bold,
        };
        self.surface.set_fill(Some(fill_of(style.color)));
        self.surface.set_stroke(None);
        self.surface.draw_glyphs(
            Point::from_xy(narrow(at[0]), narrow(at[1])),
            &glyphs,
            font.clone(),
            &text,
            narrow(style.em()),
            false,
        );
    }

    fn draw_picture(&mut self, rect: Rect, picture: &EncodedPicture) -> Result<(), String> {
        let data = Data::from(std::sync::Arc::clone(&picture.bytes));
        let image = match picture.encoding {
            Encoding::Jpeg => Image::from_jpeg(data, true),
            Encoding::Png => Image::from_png(data, true),
        }?;
        let size = Size::from_wh(narrow(rect.width), narrow(rect.height))
            .ok_or_else(|| "a picture without extent".to_owned())?;
        self.surface
            .push_transform(&transform(Affine::translate((rect.x, rect.y))));
        self.surface.draw_image(image, size);
        self.surface.pop();
        Ok(())
    }
}

fn color(Color(red, green, blue): Color) -> rgb::Color {
    rgb::Color::new(red, green, blue)
}

fn fill_of(of: Color) -> Fill {
    Fill {
        paint: color(of).into(),
        ..Fill::default()
    }
}

fn path_of(path: &BezPath) -> Option<Path> {
    let mut builder = PathBuilder::new();
    let xy = |point: kurbo::Point| (narrow(point.x), narrow(point.y));
    for element in path.elements() {
        match *element {
            PathEl::MoveTo(to) => builder.move_to(xy(to).0, xy(to).1),
            PathEl::LineTo(to) => builder.line_to(xy(to).0, xy(to).1),
            PathEl::QuadTo(a, to) => builder.quad_to(xy(a).0, xy(a).1, xy(to).0, xy(to).1),
            PathEl::CurveTo(a, b, to) => {
                let (a, b, to) = (xy(a), xy(b), xy(to));
                builder.cubic_to(a.0, a.1, b.0, b.1, to.0, to.1);
            }
            PathEl::ClosePath => builder.close(),
        }
    }
    builder.finish()
}

fn transform(affine: Affine) -> Transform {
    let [a, b, c, d, e, f] = affine.as_coeffs().map(narrow);
    Transform::from_row(a, b, c, d, e, f)
}

#[cfg(test)]
mod tests {
    use super::super::{Align, Paper};
    use super::*;

    fn document() -> Document {
        let mut sheet = Sheet::new(Paper::A4.size_mm());
        sheet.text(
            [20.0, 30.0],
            "ʻAmi、パウスカート",
            &TextStyle::body(),
            Align::Left,
        );
        sheet.line([20.0, 50.0], [120.0, 50.0], Stroke::solid(0.3));
        let pixels = [200, 30, 60, 255].repeat(64);
        let picture = EncodedPicture::photo(crate::ImageView::new(8, 8, &pixels).unwrap()).unwrap();
        let rect = Rect {
            x: 20.0,
            y: 60.0,
            width: 40.0,
            height: 30.0,
        };
        assert_eq!(sheet.picture(rect, &picture).width, 30.0);
        let items = std::sync::Arc::new(sheet.items.clone());
        sheet.items.push(Item::Group {
            page_from_group: Affine::translate((0.0, 100.0)),
            clip: Some(rect),
            items,
        });
        Document {
            title: "pāʻū".to_owned(),
            language: "ja",
            sheets: vec![sheet],
        }
    }

    #[test]
    fn equal_sheets_give_equal_bytes() {
        let [first, second] = [(); 2].map(|()| document().to_bytes().unwrap());
        assert_eq!(first, second);
        assert!(first.starts_with(b"%PDF-1"));
    }

    #[test]
    fn a_font_enters_a_file_in_part_only() {
        let bytes = document().to_bytes().unwrap();
        assert!(bytes.len() < 40_000, "{} bytes", bytes.len());
    }

    #[test]
    fn texts_of_groups_are_found() {
        assert_eq!(document().sheets[0].texts().len(), 2);
    }

    #[test]
    fn pages_without_extent_are_refused() {
        let mut document = document();
        document.sheets.push(Sheet::new([0.0, 100.0]));
        let error = document.to_bytes().unwrap_err();
        assert!(error.to_string().contains("0.0, 100.0"), "{error}");
    }
}
