//! Pages for a printer: text in Japanese, English and Hawaiian, lines, shapes and pictures.
//!
//! A [`Sheet`] is a list of things drawn on one page, in millimeters from its upper left corner, `y`
//! down. [`Flow`] fills sheets from top to bottom: headings, paragraphs, tables, pictures. At the end
//! [`Document::to_bytes`] writes all sheets as one PDF; the same sheets give the same bytes, because
//! no date goes into the file.
//!
//! ```
//! use lole_export::pdf::{Align, Document, Paper, Sheet, TextStyle};
//!
//! let mut sheet = Sheet::new(Paper::A4.size_mm());
//! sheet.text([105.0, 40.0], "pāʻū スカート", &TextStyle::body(), Align::Center);
//! let document = Document { title: "pāʻū".to_owned(), language: "ja", sheets: vec![sheet] };
//! assert!(document.to_bytes()?.starts_with(b"%PDF-"));
//! # Ok::<(), lole_export::ExportError>(())
//! ```

mod flow;
mod layers;
mod paper;
mod sheet;
mod table;
mod typeface;
mod wrap;
mod write;

pub use flow::{Flow, Margins};
pub use layers::{Layer, LayeredSheet};
pub use paper::Paper;
pub use sheet::{Align, Color, EncodedPicture, Item, Rect, Sheet, Stroke, TextStyle};
pub use table::{Cell, Column, PageTable};
#[cfg(target_arch = "wasm32")]
pub use typeface::give_fonts;
#[cfg(not(target_arch = "wasm32"))]
pub use typeface::regular_font;
pub use typeface::{Weight, missing_glyphs, printable, text_width};
pub use wrap::wrap;
pub use write::Document;
