//! Everything on paper that cloth is cut by: cut plans, patterns at full size, sheets for ruler and
//! chalk, and the same as SVG, DXF and JSON.
//!
//! | File | Function |
//! |---|---|
//! | `cut-plan.pdf` | [`cut_plan_sheets`]: where each piece lies on the cloth |
//! | `cut-plan.svg` | [`cut_plan_svg`] |
//! | `pattern-a4.pdf` | [`tiled_sheets`]: pieces at full size over sheets to join |
//! | `pattern-roll.pdf` | [`whole_sheet`]: the same on one page, for plotters and projectors |
//! | `pattern-sizes.pdf` | [`nested_sheet`]: all sizes of a list around one another |
//! | `ruler.pdf` | [`ruler_sheets`]: rectangles to draw with ruler and chalk |
//! | `pattern.svg` | [`pieces_svg()`]: pieces at full size, a group for each |
//! | `pattern.dxf` | [`crate::dxf::pattern_dxf`] |
//! | `pattern.json` | [`pattern_json`] |
//! | all of them | [`pattern_folder`] |
//!
//! What a folder holds of an earlier costume is told by [`left_behind`].
//!
//! Pieces are drawn as they are worn, `+y` up; pages have `y` down and are in millimeters.

pub(crate) mod draw;
mod folder;
mod json;
mod label;
mod nested;
mod pieces_svg;
mod plan;
mod ruler;
mod stamp;
mod tiles;
mod whole;

use std::sync::Arc;

use lole_costume::order::PlannedGarment;
use lole_costume::tailoring::{ClothPlan, GarmentPattern};
use lole_geom::Length;
use lole_language::Language;
use lole_pattern::piece::{CutCount, Piece};
use lole_print::PrintImage;

pub use folder::{PATTERN_JSON, PatternParts, left_behind, pattern_folder, sizes_name, whole_name};
pub use json::pattern_json;
pub use nested::{MOST_SIZES, NotNested, nested_sheet};
pub use pieces_svg::pieces_svg;
pub use plan::{cut_plan_sheets, cut_plan_svg, lying_width, masses, short_words, used_words};
pub(crate) use plan::{draw_marker, numbers_words};
pub use ruler::ruler_sheets;
pub use stamp::Stamp;
pub use tiles::{TiledPattern, tiled_sheets};
pub use whole::{WholeSheet, has_shaped_pieces, whole_sheet};

/// One garment with its cut plans.
#[derive(Debug, Clone, PartialEq)]
pub struct CutGarment {
    /// The garment.
    pub garment: GarmentPattern,
    /// One for each of its cloths.
    pub plans: Vec<ClothPlan>,
    /// What is printed on its own cloth, to be shown on the cut plan.
    pub print: Option<Arc<PrintImage>>,
    /// Whose it is, written on every sheet of its pattern; empty where it is one dancer's alone.
    pub owner: String,
    /// Which design in which version it is, written beside it.
    pub stamp: Stamp,
}

impl CutGarment {
    /// A garment of a dancer's plan, without its print.
    pub(crate) fn of(planned: &PlannedGarment) -> Self {
        Self {
            garment: planned.tailored.clone(),
            plans: planned.plans.clone(),
            print: None,
            owner: String::new(),
            stamp: Stamp::default(),
        }
    }

    /// The garment's name, and whose it is.
    fn title(&self, language: Language) -> String {
        let name = self.garment.name.text(language);
        match (self.owner.as_str(), language) {
            ("", _) => name.to_owned(),
            (owner, Language::Japanese) => format!("{owner}　{name}"),
            (owner, Language::English) => format!("{owner}, {name}"),
        }
    }
}

/// Lines of full-size patterns stay this close to their curves [m]: half the width of a fine pencil.
const TOLERANCE: f64 = 1.0e-4;

/// Millimeters of a meter.
const MM: f64 = 1000.0;

/// How often a piece is cut, in words: "cut 2", "1 pair".
fn cut_words(piece: &Piece, language: Language) -> String {
    match (piece.cut, language) {
        (CutCount::Alike(count), Language::Japanese) => format!("{count} 枚"),
        (CutCount::Alike(count), Language::English) => format!("cut {count}"),
        (CutCount::Pairs(count), Language::Japanese) => format!("左右 {count} 組"),
        (CutCount::Pairs(1), Language::English) => "cut 1 pair".to_owned(),
        (CutCount::Pairs(count), Language::English) => format!("cut {count} pairs"),
    }
}

/// A length in centimeters with a millimeter's digit: "92.5 cm".
fn cm(length: Length) -> String {
    format!("{:.1} cm", length.to_cm())
}

/// A length in inches, as rulers in Hawaiʻi have it: "36 3/8 in".
fn inches(length: Length) -> String {
    let eighths = (length.to_cm() / 2.54 * 8.0).round();
    let whole = (eighths / 8.0).floor();
    let part = match eighths - whole * 8.0 {
        part if part < 0.5 => return format!("{whole:.0} in"),
        part if part < 1.5 => "1/8",
        part if part < 2.5 => "1/4",
        part if part < 3.5 => "3/8",
        part if part < 4.5 => "1/2",
        part if part < 5.5 => "5/8",
        part if part < 6.5 => "3/4",
        _ => "7/8",
    };
    if whole < 0.5 {
        format!("{part} in")
    } else {
        format!("{whole:.0} {part} in")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inches_are_said_in_eighths() {
        for (cm, said) in [
            (2.54, "1 in"),
            (92.5, "36 3/8 in"),
            (1.0, "3/8 in"),
            (2.5, "1 in"),
        ] {
            assert_eq!(inches(Length::from_cm(cm)), said);
        }
    }
}
