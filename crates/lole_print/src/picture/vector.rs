//! SVG, drawn at the size that a print needs. Nothing outside of the text is looked at: no file, no
//! font, no network.

use std::panic::{AssertUnwindSafe, catch_unwind};

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{self, roxmltree};

use super::{Picture, PictureError};

mod links;
mod styles;
mod work;

/// Longest text that is read [byte].
const LONGEST_TEXT: usize = 16 << 20;
/// Elements and texts of a drawing, at most.
const MOST_NODES: u32 = 400_000;
/// Longest side of the picture that is drawn [pixel].
const DRAWN_SIDE: f32 = 2048.0;

pub(super) fn read(bytes: &[u8]) -> Result<Picture, PictureError> {
    if LONGEST_TEXT < bytes.len() {
        let said = format!("the drawing has {} MB", bytes.len() >> 20);
        return Err(PictureError::broken(&said));
    }
    let text = std::str::from_utf8(bytes).map_err(|error| PictureError::broken(&error))?;
    let text = text.trim_start_matches('\u{feff}').trim_start();
    if styles::has_crowded_elements(text) {
        return Err(PictureError::SvgWork);
    }
    let parsing = roxmltree::ParsingOptions {
        allow_dtd: true,
        nodes_limit: MOST_NODES,
        ..roxmltree::ParsingOptions::default()
    };
    let document = roxmltree::Document::parse_with_options(text, parsing);
    let document = document.map_err(|error| PictureError::broken(&error))?;
    if document.root_element().tag_name().name() != "svg" {
        return Err(PictureError::NotPicture);
    }
    check_elements(&document)?;
    if !styles::are_few(&document) || !links::are_few(&document) {
        return Err(PictureError::SvgWork);
    }
    let options = usvg::Options {
        image_href_resolver: nothing_outside(),
        ..usvg::Options::default()
    };
    let drawn = || {
        let tree = usvg::Tree::from_xmltree(&document, &options);
        draw(&tree.map_err(|error| PictureError::broken(&error))?)
    };
    // Both libraries have places that were never thought to be come to; the drawing is lost there, and no more.
    let drawn = catch_unwind(AssertUnwindSafe(drawn));
    drawn.unwrap_or_else(|_| Err(PictureError::broken(&"its lines cannot be drawn")))
}

/// What would be left out silently is refused.
fn check_elements(document: &roxmltree::Document<'_>) -> Result<(), PictureError> {
    for node in document.descendants() {
        match node.tag_name().name() {
            "text" if node.descendants().any(has_letters) => return Err(PictureError::SvgText),
            "image" => return Err(PictureError::SvgImage),
            // Each stands at every corner of a line, and may have lines with markers in it.
            "marker" => return Err(PictureError::SvgMarkers),
            _ => {}
        }
    }
    Ok(())
}

fn has_letters(node: roxmltree::Node<'_, '_>) -> bool {
    node.is_text() && node.text().is_some_and(|text| !text.trim().is_empty())
}

/// Pictures inside the drawing are refused before; this makes sure that no path is opened.
fn nothing_outside() -> usvg::ImageHrefResolver<'static> {
    usvg::ImageHrefResolver {
        resolve_data: Box::new(|_, _, _| None),
        resolve_string: Box::new(|_, _| None),
    }
}

fn draw(tree: &usvg::Tree) -> Result<Picture, PictureError> {
    let size = tree.size();
    let scale = DRAWN_SIDE / size.width().max(size.height());
    let [width, height] = [size.width(), size.height()].map(|side| pixels(side * scale));
    let canvas = [width, height].map(f64::from);
    work::check(tree, canvas, Transform::from_scale(scale, scale)).map_err(|why| match why {
        work::TooMuch::Work => PictureError::SvgWork,
        work::TooMuch::Memory => PictureError::SvgMemory,
        work::TooMuch::Far => PictureError::broken(&"a line in it runs far out of its edges"),
    })?;
    let pixmap = Pixmap::new(width, height);
    let mut pixmap = pixmap.ok_or_else(|| PictureError::broken(&"it has no size"))?;
    resvg::render(
        tree,
        Transform::from_scale(scale, scale),
        &mut pixmap.as_mut(),
    );
    let drawn = pixmap.pixels().iter();
    let pixels_drawn = drawn.flat_map(|pixel| {
        let color = pixel.demultiply();
        [color.red(), color.green(), color.blue(), color.alpha()]
    });
    Ok(Picture {
        size_in_file: [size.width(), size.height()].map(pixels),
        width,
        height,
        pixels: pixels_drawn.collect(),
    })
}

/// A side as whole pixels, at least one.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "saturates, and sides are positive"
)]
fn pixels(side: f32) -> u32 {
    (side.round() as u32).max(1)
}
