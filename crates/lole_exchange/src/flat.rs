//! The panels of a pattern drawn flat, with their stitches numbered, as SVG.

use std::fmt::Write as _;

use kurbo::{
    Affine, BezPath, ParamCurve as _, ParamCurveArclen as _, PathSeg, Point, Rect, Shape as _,
};
use lole_garment::Given;
use lole_pattern::piece::{Edge, Piece};

/// Centimeters in a meter: the drawing's unit is a centimeter of cloth.
const CM: f64 = 100.0;
/// Free room around every panel [cm].
const ROOM: f64 = 6.0;
/// Width after which a new row begins [cm].
const ROW: f64 = 240.0;
/// Height of letters [cm].
const LETTERS: f64 = 2.6;
/// Numbers of stitches lie this far inside of their edge [cm].
const INSIDE: f64 = 2.4;
/// Colors of numbers, so that both sides of a stitch are found.
const COLORS: [&str; 8] = [
    "#b3261e", "#1d5fa8", "#2d7a35", "#8a4fb0", "#b06a00", "#007a80", "#a0326e", "#555555",
];
/// How exactly lengths are taken [m].
const EXACT: f64 = 1.0e-5;

/// The drawing: outlines at their size in centimeters, the number and the name of every panel, and at both edges
/// of every stitch its number, counted from 1 as the file lists them.
#[must_use]
pub fn svg(given: &Given) -> String {
    let mut at = Point::new(ROOM, ROOM);
    let (mut right, mut row) = (0.0_f64, 0.0_f64);
    let mut body = String::new();
    for (place, (piece, panel)) in given.pattern.pieces.iter().zip(&given.panels).enumerate() {
        let bounds = piece.stitching_line().bounding_box();
        let [width, height] = [bounds.width() * CM, bounds.height() * CM];
        if ROW < at.x + width && ROOM < at.x {
            at = Point::new(ROOM, at.y + row + 2.0 * ROOM);
            row = 0.0;
        }
        draw(&mut body, (given, place), piece, (bounds, at));
        let name = escaped(&panel.name);
        // Writing to a string cannot fail.
        let _ignored = writeln!(
            body,
            "<text x=\"{:.2}\" y=\"{:.2}\">{} {name}</text>",
            at.x,
            at.y + height + LETTERS + 0.6,
            place + 1
        );
        right = right.max(at.x + width);
        row = row.max(height);
        at.x += width + 2.0 * ROOM;
    }
    let [width, height] = [right + ROOM, at.y + row + 2.0 * ROOM];
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.1}mm\" height=\"{height:.1}mm\" \
         viewBox=\"0 0 {width:.2} {height:.2}\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n\
         <g font-family=\"sans-serif\" font-size=\"{LETTERS}\">\n{body}</g>\n</svg>\n"
    )
}

fn draw(
    body: &mut String,
    (given, place): (&Given, usize),
    piece: &Piece,
    (bounds, at): (Rect, Point),
) {
    // Down the page is down the piece.
    let page = Affine::translate((at.x - bounds.x0 * CM, at.y + bounds.y1 * CM))
        * Affine::scale_non_uniform(CM, -CM);
    let path: BezPath = page * piece.stitching_line();
    let _ignored = writeln!(
        body,
        "<path d=\"{}\" fill=\"#f4f1ea\" stroke=\"#222222\" stroke-width=\"0.25\"/>",
        rounded(&path)
    );
    for (number, seam) in given.pattern.seams.iter().enumerate() {
        let color = COLORS[number % COLORS.len()];
        for side in [seam.flat, seam.full] {
            let Some(edge) = (side.piece == place).then(|| &piece.edges[side.edge]) else {
                continue;
            };
            let (middle, inward) = middle_of(edge);
            let label = page * (middle + inward * (INSIDE / CM));
            let edge: BezPath = page * BezPath::from_path_segments(edge.segments.iter().copied());
            let _ignored = writeln!(
                body,
                "<path d=\"{}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"0.5\"/>\
                 <text x=\"{:.2}\" y=\"{:.2}\" fill=\"{color}\" text-anchor=\"middle\">{}</text>",
                rounded(&edge),
                label.x,
                label.y + 0.35 * LETTERS,
                number + 1
            );
        }
    }
}

/// A path with numbers to a hundredth of a millimeter: SVG readers need no more.
fn rounded(path: &BezPath) -> String {
    let mut text = String::new();
    let mut point = |letter: &str, points: &[Point]| {
        text.push_str(letter);
        for point in points {
            let _ignored = write!(text, " {:.3} {:.3}", point.x, point.y);
        }
    };
    for element in path.elements() {
        match *element {
            kurbo::PathEl::MoveTo(a) => point("M", &[a]),
            kurbo::PathEl::LineTo(a) => point("L", &[a]),
            kurbo::PathEl::QuadTo(a, b) => point("Q", &[a, b]),
            kurbo::PathEl::CurveTo(a, b, c) => point("C", &[a, b, c]),
            kurbo::PathEl::ClosePath => point("Z", &[]),
        }
    }
    text
}

/// The middle of an edge and the way into the piece there: cloth lies on the left of its edges.
fn middle_of(edge: &Edge) -> (Point, kurbo::Vec2) {
    let whole: f64 = edge.segments.iter().map(|it| it.arclen(EXACT)).sum();
    let mut left = 0.5 * whole;
    for segment in &edge.segments {
        let own = segment.arclen(EXACT);
        if own < left {
            left -= own;
            continue;
        }
        let at =
            |length: f64| PathSeg::eval(segment, segment.inv_arclen(length.clamp(0.0, own), EXACT));
        let step = 0.01 * own;
        let along = at(left + step) - at(left - step);
        let inward = kurbo::Vec2::new(-along.y, along.x) / along.hypot().max(1.0e-9);
        return (at(left), inward);
    }
    (Point::ZERO, kurbo::Vec2::ZERO)
}

fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            _ => escaped.push(letter),
        }
    }
    escaped
}
