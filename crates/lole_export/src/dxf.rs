//! Pieces as DXF in the layers of ASTM D6673 (formerly ANSI/AAMA 292), which pattern software reads.
//!
//! Each piece is a block: its cut line on layer 1, turn points on 2, curve points on 3, notches on 4,
//! the grain on 7, marked lines on 8, slits on 11, drill holes on 13, stitching lines on 14, words for
//! people on 15. Piece text (`Piece Name`, `Size`, `Quantity`, …) stands in the block on layer 1, style
//! text (`Style Name`, `Units`, …) once beside the inserted blocks. Units are millimeters.
//!
//! A notch is a point on the cut line with its depth as height and the way into the cloth as angle, as the
//! standard has it; where it is to be seen, it is a short line on layer 15, too.
//!
//! The file is of the plain kind that all readers take: release 12, `POLYLINE` and `LINE`, ASCII, a
//! header that says the release and millimeters. The standard's quality curves (layers 84 to 87) are for exact re-import by one
//! program and left out.

use kurbo::{Affine, Point};
use lole_pattern::piece::{CutCount, Drawing, LineKind, Piece};
use lole_pattern::polygon::Polygon;

use crate::cutting::CutGarment;
use crate::cutting::draw::notch_places;

/// Layers by the standard's numbers.
mod layer {
    pub(super) const CUT: &str = "1";
    pub(super) const TURN_POINT: &str = "2";
    pub(super) const CURVE_POINT: &str = "3";
    pub(super) const NOTCH: &str = "4";
    pub(super) const GRAIN: &str = "7";
    pub(super) const INTERNAL: &str = "8";
    pub(super) const CUTOUT: &str = "11";
    pub(super) const DRILL: &str = "13";
    pub(super) const SEW: &str = "14";
    pub(super) const NOTE: &str = "15";
}

/// Millimeters of a meter.
const MM: f64 = 1000.0;
/// Curves become lines this close to them [m].
const TOLERANCE: f64 = 5.0e-5;
/// Height of letters [mm].
const LETTER: f64 = 6.0;
/// How deep a notch is cut [m].
const NOTCH_DEPTH: f64 = 0.005;
/// Between inserted pieces [mm].
const GAP: f64 = 50.0;
/// A corner that turns less belongs to a curve [rad]: the sine of fifteen degrees.
const TURN: f64 = 0.26;

/// Writes the pieces of a garment, whole and the wearer's left of pairs; `size` is the dancer's or the
/// design's name.
#[must_use]
pub fn pattern_dxf(cut: &CutGarment, size: &str) -> Vec<u8> {
    let mut dxf = Dxf::default();
    dxf.header();
    dxf.pair(0, "SECTION").pair(2, "BLOCKS");
    let mut names: Vec<String> = Vec::new();
    let mut widths = Vec::new();
    for piece in &cut.garment.cutting().pieces {
        let name = block_name(piece, &names);
        let drawing = piece.unfolded().drawing(TOLERANCE);
        widths.push(drawing.cut.bounds());
        dxf.block(&name, size, piece, &drawing);
        names.push(name);
    }
    dxf.pair(0, "ENDSEC");
    dxf.pair(0, "SECTION").pair(2, "ENTITIES");
    let style = plain(&cut.garment.id);
    let lines = [
        format!("Style Name: {style}"),
        "Author: Lole".to_owned(),
        format!("Sample Size: {}", plain(size)),
        "Units: METRIC".to_owned(),
        "Grading Rule Table: NONE".to_owned(),
    ];
    for (row, line) in (0_u32..).zip(&lines) {
        let y = -(GAP + 1.5 * LETTER * f64::from(row));
        dxf.text(layer::CUT, Point::new(0.0, y), line);
    }
    let mut x = 0.0;
    for (name, bounds) in names.iter().zip(&widths) {
        let at = Point::new(x - MM * bounds.x0, -MM * bounds.y0);
        dxf.pair(0, "INSERT").pair(8, layer::CUT).pair(2, name);
        dxf.point([10, 20, 30], at);
        x += MM * bounds.width() + GAP;
    }
    dxf.pair(0, "ENDSEC").pair(0, "EOF");
    dxf.text.into_bytes()
}

/// Points in millimeters.
fn scaled(points: &[Point]) -> Vec<Point> {
    let points = points.iter();
    points.map(|point| Affine::scale(MM) * *point).collect()
}

/// Name of a block: upper case, and no two alike.
fn block_name(piece: &Piece, others: &[String]) -> String {
    let name: String = (piece.id.chars())
        .map(|letter| {
            if letter.is_ascii_alphanumeric() {
                letter.to_ascii_uppercase()
            } else {
                '_'
            }
        })
        .collect();
    let alike = others
        .iter()
        .filter(|other| other.starts_with(&name))
        .count();
    if alike == 0 {
        name
    } else {
        format!("{name}_{}", alike + 1)
    }
}

/// Most letters of a name: a value of release 12 holds 255 with what stands before it.
const MOST_LETTERS: usize = 80;

/// Text that release 12 can hold: kahakō and ʻokina are left out, other letters become `?`, and so do those with
/// which readers spell other letters and new lines (`^J`, `%%010`, `\U+000A`).
pub(crate) fn plain(text: &str) -> String {
    let letter = |letter: char| match letter {
        'ā' => Some('a'),
        'ē' => Some('e'),
        'ī' => Some('i'),
        'ō' => Some('o'),
        'ū' => Some('u'),
        'Ā' => Some('A'),
        'Ē' => Some('E'),
        'Ī' => Some('I'),
        'Ō' => Some('O'),
        'Ū' => Some('U'),
        'ʻ' | '‘' | '’' => None,
        '^' | '\\' => Some('?'),
        ' '..='~' => Some(letter),
        _ => Some('?'),
    };
    let letters = text.chars().filter_map(letter).take(MOST_LETTERS);
    letters.collect::<String>().replace("%%", "??")
}

/// Whether a line comes back to its beginning.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Ends {
    Open,
    Closed,
}

/// Group codes and values, a line each.
#[derive(Default)]
struct Dxf {
    text: String,
}

impl Dxf {
    fn pair(&mut self, code: u32, value: &str) -> &mut Self {
        let line = format!("{code:>3}\r\n{value}\r\n");
        self.text.push_str(&line);
        self
    }

    fn number(&mut self, code: u32, value: f64) -> &mut Self {
        // Adding zero makes minus nothing nothing.
        self.pair(code, &format!("{:.5}", value + 0.0))
    }

    fn point(&mut self, [x, y, z]: [u32; 3], at: Point) {
        self.number(x, at.x).number(y, at.y).number(z, 0.0);
    }

    /// Release 12, in millimeters.
    fn header(&mut self) {
        self.pair(0, "SECTION").pair(2, "HEADER");
        self.pair(9, "$ACADVER").pair(1, "AC1009");
        self.pair(9, "$MEASUREMENT").pair(70, "1");
        self.pair(9, "$INSUNITS").pair(70, "4");
        self.pair(0, "ENDSEC");
    }

    /// A piece in a block of its own.
    fn block(&mut self, name: &str, size: &str, piece: &Piece, drawing: &Drawing) {
        self.pair(0, "BLOCK")
            .pair(8, layer::CUT)
            .pair(2, name)
            .pair(70, "64");
        self.point([10, 20, 30], Point::ZERO);
        self.outlines(drawing);
        self.marks(drawing);
        let lines = [
            format!("Piece Name: {name}"),
            format!("Size: {}", plain(size)),
        ];
        self.words(lines, piece, Affine::scale(MM) * drawing.label);
        self.pair(0, "ENDBLK").pair(8, layer::CUT);
    }

    /// Where a piece is cut and stitched, and the lines on it.
    fn outlines(&mut self, drawing: &Drawing) {
        self.polyline(layer::CUT, &scaled(&drawing.cut.points), Ends::Closed);
        self.corners(&drawing.cut);
        for stitches in &drawing.stitches {
            if 0.0 < stitches.allowance.to_m() {
                self.polyline(layer::SEW, &scaled(&stitches.points), Ends::Open);
            }
        }
        for marked in &drawing.lines {
            let layer = match marked.kind {
                LineKind::Slit => layer::CUTOUT,
                _ => layer::INTERNAL,
            };
            self.polyline(layer, &scaled(&marked.points), Ends::Open);
        }
    }

    /// Notches, drill holes and the grain.
    fn marks(&mut self, drawing: &Drawing) {
        for notch in &drawing.notches {
            let side = notch.inward.turn_90() * 0.002;
            let angle = lole_geom::trig64::atan2(notch.inward.y, notch.inward.x).to_degrees();
            for place in notch_places(notch) {
                let at = notch.at + side * *place;
                let [x, y] = [at.x, at.y].map(|along| MM * along);
                self.pair(0, "POINT").pair(8, layer::NOTCH);
                self.number(10, x)
                    .number(20, y)
                    .number(30, MM * NOTCH_DEPTH);
                self.number(50, angle);
                let end = at + notch.inward * NOTCH_DEPTH;
                self.line(layer::NOTE, scaled(&[at, end]));
            }
        }
        for (_, at) in &drawing.points {
            self.pair(0, "POINT").pair(8, layer::DRILL);
            self.point([10, 20, 30], Affine::scale(MM) * *at);
        }
        self.line(layer::GRAIN, scaled(&drawing.grain));
    }

    /// Where the cut line turns, and the points of its curves.
    fn corners(&mut self, cut: &Polygon) {
        let count = cut.points.len();
        for (index, at) in cut.points.iter().enumerate() {
            let before = *at - cut.points[(index + count - 1) % count];
            let after = cut.points[(index + 1) % count] - *at;
            let turn = before.cross(after).abs() / (before.hypot() * after.hypot()).max(1e-18);
            let layer = if turn < TURN && 0.0 < before.dot(after) {
                layer::CURVE_POINT
            } else {
                layer::TURN_POINT
            };
            self.pair(0, "POINT").pair(8, layer);
            self.point([10, 20, 30], Affine::scale(MM) * *at);
        }
    }

    /// Name and size, then the rest of a piece's text from `label` down, and words for people above.
    fn words(&mut self, [name, size]: [String; 2], piece: &Piece, label: Point) {
        let (quantity, pair) = match piece.cut {
            CutCount::Alike(count) => (count, String::new()),
            CutCount::Pairs(count) => (2 * count, format!("{count} PAIR, LEFT DRAWN")),
        };
        let said = plain(piece.name.english);
        let lines = [
            name,
            size,
            format!("Quantity: {quantity}"),
            format!("Material: {:?}", piece.cloth),
            format!("Annotation: {said} {pair}").trim_end().to_owned(),
        ];
        for (row, line) in (0_u32..).zip(&lines) {
            let at = Point::new(label.x, label.y - 1.5 * LETTER * f64::from(row));
            self.text(layer::CUT, at, line);
        }
        let at = Point::new(label.x, label.y + 2.0 * LETTER);
        self.text(layer::NOTE, at, &format!("{said} x{quantity}"));
    }

    fn line(&mut self, layer: &str, ends: Vec<Point>) {
        if let [from, to] = ends.as_slice() {
            self.pair(0, "LINE").pair(8, layer);
            self.point([10, 20, 30], *from);
            self.point([11, 21, 31], *to);
        }
    }

    fn polyline(&mut self, layer: &str, points: &[Point], ends: Ends) {
        let flag = if ends == Ends::Closed { "1" } else { "0" };
        self.pair(0, "POLYLINE")
            .pair(8, layer)
            .pair(66, "1")
            .pair(70, flag);
        self.point([10, 20, 30], Point::ZERO);
        for point in points {
            self.pair(0, "VERTEX").pair(8, layer);
            self.point([10, 20, 30], *point);
        }
        self.pair(0, "SEQEND").pair(8, layer);
    }

    fn text(&mut self, layer: &str, at: Point, text: &str) {
        self.pair(0, "TEXT").pair(8, layer);
        self.point([10, 20, 30], at);
        self.number(40, LETTER).pair(1, text);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hawaiian_names_lose_their_marks_only() {
        assert_eq!(plain("pāʻū skirt"), "pau skirt");
        assert_eq!(plain("パウ 1"), "?? 1");
    }

    #[test]
    fn numbers_have_a_point_and_no_minus_nothing() {
        let mut dxf = Dxf::default();
        dxf.number(10, -0.0);
        assert_eq!(dxf.text, " 10\r\n0.00000\r\n");
    }
}
