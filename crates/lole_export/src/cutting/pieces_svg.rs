//! All pieces of a garment at full size as one SVG: one unit is a millimeter, and a square of 10 cm
//! before the first piece shows whether it is printed so.
//!
//! Each piece is a group with its name; what is cut, stitched, marked and notched are groups of
//! classes of their own, so that a plotter or a drawing program takes what it needs.

use kurbo::{Affine, Point};
use lole_language::Language;
use lole_pattern::piece::{Drawing, Piece};

use super::draw::{line, notch_places, outline};
use super::{CutGarment, MM, TOLERANCE, cut_words};
use crate::svg::{escape, head, number, path_data};

/// Space around and between pieces [mm].
const GAP: f64 = 20.0;
/// Pieces begin a new row where one would be longer than this [mm].
const ROW: f64 = 4000.0;
/// Side of the square by which a print is measured [mm].
const SQUARE: f64 = 100.0;
/// Length of a notch [mm].
const NOTCH: f64 = 5.0;

/// How each class is drawn, written at every group: cutters and small readers know no style sheets.
const LOOKS: [(&str, &str); 6] = [
    ("cut", "stroke-width=\"0.5\""),
    ("stitch", "stroke-width=\"0.3\" stroke-dasharray=\"3 3\""),
    ("mark", "stroke-width=\"0.3\""),
    ("notch", "stroke-width=\"0.5\""),
    ("point", "stroke-width=\"0.3\""),
    ("grain", "stroke-width=\"0.4\""),
];

/// Pieces whole, not folded; of pairs the wearer's left.
#[must_use]
pub fn pieces_svg(cut: &CutGarment, language: Language) -> Vec<u8> {
    let mut groups = String::new();
    let (mut x, mut y, mut row_height) = (2.0 * GAP + SQUARE, GAP, SQUARE);
    let mut width = 0.0_f64;
    for piece in &cut.garment.cutting().pieces {
        let whole = piece.unfolded();
        let drawing = whole.drawing(TOLERANCE);
        let bounds = drawing.cut.bounds();
        let size = [bounds.width() * MM, bounds.height() * MM];
        if GAP < x && ROW < x + size[0] {
            x = GAP;
            y += row_height + GAP;
            row_height = 0.0;
        }
        let page = Affine::translate((x, y))
            * Affine::scale_non_uniform(MM, -MM)
            * Affine::translate((-bounds.x0, -bounds.y1));
        groups.push_str(&piece_group(piece, &drawing, page, language));
        x += size[0] + GAP;
        row_height = row_height.max(size[1]);
        width = width.max(x);
    }
    let mut svg = head(width.max(2.0 * GAP), y + row_height + GAP);
    let name = escape(cut.garment.name.text(language));
    svg.push_str(&format!("<title>{name}</title>\n"));
    svg.push_str(&square(language));
    svg.push_str(&groups);
    svg.push_str("</svg>\n");
    svg.into_bytes()
}

/// The square by which a print is measured; it is of no class that is cut.
fn square(language: Language) -> String {
    let said = language.pick("この四角は 10 cm × 10 cm", "this square is 10 cm × 10 cm");
    let middle = GAP + 0.5 * SQUARE;
    format!(
        "<g id=\"scale\" class=\"scale\"><rect x=\"{GAP}\" y=\"{GAP}\" width=\"{SQUARE}\" height=\"{SQUARE}\" fill=\"none\" stroke=\"#000000\" stroke-width=\"0.3\"/><text x=\"{middle}\" y=\"{middle}\" font-size=\"6\" text-anchor=\"middle\">{said}</text></g>\n"
    )
}

/// A piece as a group of its classes.
fn piece_group(piece: &Piece, drawing: &Drawing, page: Affine, language: Language) -> String {
    let paths = |class: &str, paths: &mut dyn Iterator<Item = kurbo::BezPath>| -> String {
        let look = LOOKS.iter().find(|(name, _)| *name == class);
        let look = look.map_or("", |(_, look)| look);
        let data: String = paths
            .map(|path| format!("<path d=\"{}\"/>", path_data(&path)))
            .collect();
        format!("<g class=\"{class}\" fill=\"none\" stroke=\"#000000\" {look}>{data}</g>\n")
    };
    let stitches = drawing.stitches.iter();
    let stitches = stitches.filter(|stitches| 0.0 < stitches.allowance.to_m());
    let notches = drawing.notches.iter().flat_map(|notch| {
        let inward = notch.inward * (NOTCH / MM);
        let side = notch.inward.turn_90() * 0.002;
        notch_places(notch).iter().map(move |place| {
            let from = notch.at + side * *place;
            line(&[from, from + inward], page)
        })
    });
    let points = drawing.points.iter().flat_map(|(_, at)| {
        let arm = 0.004;
        [kurbo::Vec2::new(arm, 0.0), kurbo::Vec2::new(0.0, arm)]
            .map(|arm| line(&[*at - arm, *at + arm], page))
    });
    let label = page * drawing.label;
    let name = escape(piece.name.text(language));
    let count = escape(&cut_words(piece, language));
    let texts = [
        format!("<g id=\"{}\">\n", escape(piece.id)),
        paths("cut", &mut [outline(&drawing.cut, page)].into_iter()),
        paths(
            "stitch",
            &mut stitches.map(|stitches| line(&stitches.points, page)),
        ),
        paths(
            "mark",
            &mut drawing
                .lines
                .iter()
                .map(|marked| line(&marked.points, page)),
        ),
        paths("notch", &mut notches.into_iter()),
        paths("point", &mut points.into_iter()),
        paths(
            "grain",
            &mut [line(&drawing.grain as &[Point], page)].into_iter(),
        ),
        format!(
            "<text x=\"{}\" y=\"{}\" font-size=\"8\" text-anchor=\"middle\">{name} · {count}</text>\n</g>\n",
            number(label.x),
            number(label.y - 4.0)
        ),
    ];
    texts.concat()
}
