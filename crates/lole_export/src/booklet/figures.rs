//! Drawings of the sewing steps, from the pieces themselves.
//!
//! Long pieces are drawn shorter than they are, so that what matters can be seen; sections show cloth
//! layer on layer with gaps between the layers.

mod craft;
mod piece;
mod seams;
mod section;
mod wrapping;

use kurbo::Affine;
use lole_language::words;
use lole_pattern::pattern::{NotionKind, Pattern, StepFigure};
use lole_pattern::piece::Piece;

use crate::canvas::Canvas;
use crate::pdf::{Rect, TextStyle};
use piece::WorkedPiece;

/// Letters in drawings.
const LABEL: TextStyle = TextStyle::regular(11.0);

/// Height of the drawing of a step [mm]; 0 for none.
pub(super) const fn height(figure: &StepFigure) -> f64 {
    match figure {
        StepFigure::None => 0.0,
        StepFigure::Piece { .. } => 48.0,
        StepFigure::Seams(_) => 46.0,
        StepFigure::Section { .. } => 47.0,
        StepFigure::Wrapping(_) => 66.0,
        StepFigure::Craft(_) => 40.0,
    }
}

/// Draws a figure into its place.
pub(super) fn draw(canvas: &mut Canvas<'_>, pattern: &Pattern, figure: &StepFigure) {
    match figure {
        StepFigure::None => {}
        StepFigure::Piece {
            piece,
            edges,
            marks,
        } => {
            if let Some(piece) = pattern.pieces.get(*piece) {
                let worked = WorkedPiece {
                    piece,
                    edges,
                    marks,
                };
                worked.draw(canvas);
            }
        }
        StepFigure::Seams(seams) => seams::draw(canvas, pattern, seams),
        StepFigure::Wrapping(parts) => wrapping::draw(canvas, parts),
        StepFigure::Craft(craft) => craft::draw(canvas, *craft),
        StepFigure::Section { piece, marks } => {
            if let Some(piece) = pattern.pieces.get(*piece) {
                let has_elastic =
                    (pattern.notions.iter()).any(|notion| notion.kind == NotionKind::Elastic);
                let casing = if has_elastic {
                    words("ゴム通し", "casing")
                } else {
                    words("ひも通し", "casing")
                };
                section::draw(canvas, piece, marks, casing);
            }
        }
    }
}

/// Page from piece: upright, as large as fits, and at most three times shorter across than true.
fn placement(piece: &Piece, rect: Rect) -> Affine {
    let bounds = piece.cut_polygon(1e-3).bounds();
    let scale_y = rect.height / bounds.height();
    let scale_x = (rect.width / bounds.width()).min(scale_y);
    let scale_y = scale_y.min(3.0 * scale_x);
    let left = rect.x + 0.5 * (rect.width - bounds.width() * scale_x);
    Affine::translate((left, rect.y))
        * Affine::scale_non_uniform(scale_x, -scale_y)
        * Affine::translate((-bounds.x0, -bounds.y1))
}
