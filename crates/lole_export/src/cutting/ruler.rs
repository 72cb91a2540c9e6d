//! Rectangles by ruler and chalk: their size, and every line across them from one edge.

use kurbo::{Affine, Point};
use lole_costume::tailoring::role_name;
use lole_geom::Length;
use lole_language::{Language, Words, words};
use lole_pattern::piece::{CutCount, Drawing, Finish, Piece};

use super::draw::{arrow, line, outline};
use super::{CutGarment, TOLERANCE, cm, cut_words, inches};
use crate::canvas::Canvas;
use crate::pdf::{
    Align, Cell, Color, Column, Flow, Margins, PageTable, Paper, Rect, Sheet, Stroke, TextStyle,
};

/// Largest height of a drawing, and what stands around it [mm].
const DRAWING: f64 = 74.0;
const AROUND: f64 = 20.0;
/// Numbers beside the drawing stand at least this far apart [mm].
const LEADING: f64 = 4.6;
/// What is straight beside a ruler [m].
const STRAIGHT: f64 = 1.0e-4;

const STITCHING_LINE: Words = words("縫い線", "stitching line");
const FINISHED_EDGE: Words = words("でき上がりの端", "finished edge");

/// A line across a rectangle.
struct Ruled {
    name: Words,
    /// From the upper raw edge, or from the left one [m].
    from_edge: f64,
    is_level: bool,
}

/// One part for each rectangle of the garments; empty where there is none.
#[must_use]
pub fn ruler_sheets(garments: &[CutGarment], paper: Paper, language: Language) -> Vec<Sheet> {
    let mut flow = Flow::new(
        paper.size_mm(),
        Margins {
            side: 16.0,
            top: 16.0,
            bottom: 16.0,
        },
    );
    let pieces = garments.iter().flat_map(|cut| {
        let pieces = cut.garment.cutting().pieces.iter();
        pieces.filter_map(move |piece| Rectangle::of(cut, piece))
    });
    let mut is_empty = true;
    for rectangle in pieces {
        flow.new_page();
        rectangle.write(&mut flow, language);
        is_empty = false;
    }
    if is_empty {
        return Vec::new();
    }
    flow.numbered([16.0, 8.0])
}

/// A rectangle of a garment, whole.
struct Rectangle<'a> {
    cut: &'a CutGarment,
    piece: Piece,
    drawing: Drawing,
    /// Width and height, allowances included.
    size: [Length; 2],
}

impl<'a> Rectangle<'a> {
    /// `None` for a piece of another shape.
    fn of(cut: &'a CutGarment, piece: &Piece) -> Option<Self> {
        let piece = piece.unfolded();
        let drawing = piece.drawing(TOLERANCE);
        drawing.rectangle.map(|size| Self {
            cut,
            piece,
            drawing,
            size,
        })
    }

    fn write(&self, flow: &mut Flow, language: Language) {
        let garment = self.cut.garment.name.text(language);
        let name = self.piece.name.text(language);
        let title = if garment == name {
            name.to_owned()
        } else {
            format!("{garment}: {name}")
        };
        flow.paragraph(&title, &TextStyle::bold(19.0));
        flow.paragraph(&self.facts(language), &TextStyle::regular(12.0));
        if matches!(self.piece.cut, CutCount::Pairs(_)) {
            let said = language.pick(
                "左右で一組です。図は一枚目。二枚目は、切り込みの位置を図と左右逆に付けます。",
                "They are a pair. One is drawn; on the other the notches stand the other way round, left for right.",
            );
            flow.paragraph(said, &TextStyle::regular(12.0));
        }
        flow.space(4.0);
        let ruled = ruled_lines(&self.drawing);
        let scales = scales(&self.drawing, flow.width());
        let height = self.drawing.cut.bounds().height() * scales[1] + AROUND;
        flow.drawing(height, language, |canvas| {
            draw(canvas, &self.drawing, &ruled, scales);
        });
        flow.space(5.0);
        let mut table = table(&ruled, language);
        table
            .rows
            .extend(notch_rows(&notched(&self.drawing), language));
        table.draw(flow);
    }

    /// Its size, its cloth, how often it is cut and how the warp runs.
    fn facts(&self, language: Language) -> String {
        let piece = &self.piece;
        let warp = if piece.is_on_bias() {
            language.pick(
                "バイアス（耳から斜め 45°）に裁つ",
                "cut on the bias, at 45° to the selvage",
            )
        } else if piece.grain.y.abs() < piece.grain.x.abs() {
            language.pick(
                "横に縦地（耳と平行）",
                "the warp (selvage) runs across the drawing",
            )
        } else {
            language.pick(
                "縦に縦地（耳と平行）",
                "the warp (selvage) runs up the drawing",
            )
        };
        let cloth = role_name(piece.cloth).text(language);
        let count = cut_words(piece, language);
        let [width, height] = self.size;
        match language {
            Language::Japanese => format!(
                "横 {} × 縦 {}（縫い代込み）、{cloth} {count}。{warp}。型紙はいりません。布に定規とチャコで線を引きます。",
                cm(width),
                cm(height)
            ),
            Language::English => format!(
                "{} across × {} up ({} × {}), allowances included; {cloth}, {count}; {warp}. No paper is \
                 needed: draw the lines on the cloth with ruler and chalk.",
                cm(width),
                cm(height),
                inches(width),
                inches(height)
            ),
        }
    }
}

/// A notch in an edge of a rectangle.
struct Notched {
    /// Which edge it is in.
    edge: Words,
    /// From the end of that edge that is written in [`Notched::edge`] [m].
    from_end: f64,
    is_double: bool,
}

/// The notches, edge by edge, along each in order.
fn notched(drawing: &Drawing) -> Vec<Notched> {
    let bounds = drawing.cut.bounds();
    let edges = [
        words("上の端で、左から", "in the upper edge, from the left"),
        words("下の端で、左から", "in the lower edge, from the left"),
        words("左の端で、上から", "in the left edge, from the top"),
        words("右の端で、上から", "in the right edge, from the top"),
    ];
    let mut found: Vec<(usize, Notched)> = (drawing.notches.iter())
        .map(|notch| {
            let edge = match (notch.inward.x, notch.inward.y) {
                (x, y) if y.abs() >= x.abs() => usize::from(0.0 < y),
                (x, _) => 2 + usize::from(x < 0.0),
            };
            let from_end = if edge < 2 {
                notch.at.x - bounds.x0
            } else {
                bounds.y1 - notch.at.y
            };
            let notched = Notched {
                edge: edges[edge],
                from_end,
                is_double: notch.is_double,
            };
            (edge, notched)
        })
        .collect();
    found.sort_by(|(a, one), (b, other)| a.cmp(b).then(one.from_end.total_cmp(&other.from_end)));
    found.into_iter().map(|(_, notched)| notched).collect()
}

/// Marked lines and stitching lines that run straight across, from the top down and from the left on.
fn ruled_lines(drawing: &Drawing) -> Vec<Ruled> {
    let bounds = drawing.cut.bounds();
    let mut ruled: Vec<Ruled> = Vec::new();
    let mut add = |name: Words, points: &[Point]| {
        let spread = |of: fn(&Point) -> f64| {
            let values = points.iter().map(of);
            let [low, high] = values
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
                    [low.min(value), high.max(value)]
                });
            (high - low < STRAIGHT).then_some(0.5 * (low + high))
        };
        let line = match (spread(|point| point.y), spread(|point| point.x)) {
            (Some(y), None) => Some((bounds.y1 - y, true)),
            (None, Some(x)) => Some((x - bounds.x0, false)),
            _ => None,
        };
        let Some((from_edge, is_level)) = line else {
            return;
        };
        let is_there = ruled.iter().any(|other| {
            other.is_level == is_level && (other.from_edge - from_edge).abs() < STRAIGHT
        });
        if !is_there && STRAIGHT < from_edge {
            ruled.push(Ruled {
                name,
                from_edge,
                is_level,
            });
        }
    };
    for marked in &drawing.lines {
        add(marked.kind.name(), &marked.points);
    }
    for stitches in &drawing.stitches {
        if STRAIGHT < stitches.allowance.to_m() {
            let name = if stitches.finish == Finish::Hem {
                FINISHED_EDGE
            } else {
                STITCHING_LINE
            };
            add(name, &stitches.points);
        }
    }
    ruled.sort_by(|a, b| (b.is_level.cmp(&a.is_level)).then(a.from_edge.total_cmp(&b.from_edge)));
    ruled
}

/// Page millimeters of a meter, across and up. A skirt is four times as long as it is high: the long
/// way is drawn shorter where it must be.
fn scales(drawing: &Drawing, width: f64) -> [f64; 2] {
    let bounds = drawing.cut.bounds();
    let up = DRAWING / bounds.height();
    let across = ((width - 62.0) / bounds.width()).min(up);
    [across, up.min(3.0 * across)]
}

/// The rectangle with its lines, numbered.
fn draw(canvas: &mut Canvas<'_>, drawing: &Drawing, ruled: &[Ruled], [scale_x, scale_y]: [f64; 2]) {
    let bounds = drawing.cut.bounds();
    let place = Rect {
        x: canvas.rect.x + 16.0,
        y: canvas.rect.y + 4.0,
        width: bounds.width() * scale_x,
        height: bounds.height() * scale_y,
    };
    let page = Affine::translate((place.x, place.y))
        * Affine::scale_non_uniform(scale_x, -scale_y)
        * Affine::translate((-bounds.x0, -bounds.y1));
    let sheet = &mut *canvas.sheet;
    draw_lines(sheet, drawing, page);
    let right = place.x + place.width;
    write_numbers(sheet, ruled, page, [right, place.y]);
    let sizes = [bounds.width(), bounds.height()].map(|side| cm(Length::from_m(side)));
    draw_sizes(sheet, place, sizes);
    if (scale_x - scale_y).abs() > 1e-6 {
        let language = canvas.language;
        let said = language.pick("図の横は縮めてあります", "drawn shorter across than it is");
        let at = [right, place.y + place.height + 5.0 + 5.0];
        sheet.text(at, said, &TextStyle::regular(8.0), Align::Right);
    }
}

/// The cut line, stitching lines, marked lines and the grain.
fn draw_lines(sheet: &mut Sheet, drawing: &Drawing, page: Affine) {
    sheet.path(
        outline(&drawing.cut, page),
        Some(Color(250, 248, 244)),
        Some(Stroke::solid(0.5)),
    );
    for stitches in &drawing.stitches {
        if STRAIGHT < stitches.allowance.to_m() {
            let stroke = Stroke::dashed(0.25, 2.0);
            sheet.path(line(&stitches.points, page), None, Some(stroke));
        }
    }
    for marked in &drawing.lines {
        sheet.path(line(&marked.points, page), None, Some(Stroke::solid(0.25)));
    }
    for notch in &drawing.notches {
        /// Length of a notch and distance of the two of a double one on the page [mm].
        const NOTCH: [f64; 2] = [3.0, 1.4];
        let at = page * notch.at;
        // Upright edges and level ones: on the page up is down.
        let inward = kurbo::Vec2::new(notch.inward.x, -notch.inward.y);
        let beside = kurbo::Vec2::new(inward.y, inward.x) * NOTCH[1];
        let shifts = if notch.is_double {
            [-0.5, 0.5]
        } else {
            [0.0, 0.0]
        };
        for shift in shifts {
            let from = at + beside * shift;
            let to = from + inward * NOTCH[0];
            sheet.line([from.x, from.y], [to.x, to.y], Stroke::solid(0.4));
        }
    }
    let grain = drawing.grain.map(|end| page * end);
    arrow(sheet, grain, &Stroke::solid(0.3).with_color(Color::GRAY));
}

/// Width below the rectangle, height at its left.
fn draw_sizes(sheet: &mut Sheet, place: Rect, [width, height]: [String; 2]) {
    let style = TextStyle::bold(11.0);
    let bottom = place.y + place.height;
    let below = bottom + 5.0;
    let [from, to] = [
        Point::new(place.x, below),
        Point::new(place.x + place.width, below),
    ];
    arrow(sheet, [from, to], &Stroke::solid(0.2));
    let at = [from.midpoint(to).x, below + 5.0];
    sheet.text(at, &width, &style, Align::Center);
    let aside = place.x - 5.0;
    let [low, high] = [Point::new(aside, bottom), Point::new(aside, place.y)];
    arrow(sheet, [low, high], &Stroke::solid(0.2));
    let at = [aside - 1.5, low.midpoint(high).y];
    sheet.turned_text(at, core::f64::consts::FRAC_PI_2, &height, &style);
}

/// Numbers of the level lines at the right, apart from each other, with what they measure.
fn write_numbers(sheet: &mut Sheet, ruled: &[Ruled], page: Affine, [right, top]: [f64; 2]) {
    let style = TextStyle::regular(9.0);
    let scale = page.as_coeffs()[3].abs();
    let mut last = top - LEADING;
    for (number, ruled) in (1..).zip(ruled).filter(|(_, ruled)| ruled.is_level) {
        let y = top + ruled.from_edge * scale;
        let label = y.max(last + LEADING);
        last = label;
        let fine = Stroke::solid(0.12).with_color(Color::GRAY);
        sheet.line([right, y], [right + 4.0, y], fine.clone());
        sheet.line([right + 4.0, y], [right + 8.0, label], fine);
        let said = format!("{number}: {}", cm(Length::from_m(ruled.from_edge)));
        sheet.text([right + 9.0, label + 1.2], &said, &style, Align::Left);
    }
}

/// Every notch with its distance from the end of its edge.
fn notch_rows(notches: &[Notched], language: Language) -> Vec<Vec<Cell>> {
    let rows = notches.iter().map(|notch| {
        let distance = Length::from_m(notch.from_end);
        let name = if notch.is_double {
            language.pick("切り込み 2 本", "double notch")
        } else {
            language.pick("切り込み（合印）", "notch")
        };
        vec![
            Cell::from("–"),
            Cell::bold(name),
            Cell::from(notch.edge.text(language)),
            Cell::bold(cm(distance)),
            Cell::from(inches(distance)),
        ]
    });
    rows.collect()
}

/// Every line with its distance from the edge.
fn table(ruled: &[Ruled], language: Language) -> PageTable {
    let rows = (1..).zip(ruled).map(|(number, ruled)| {
        let distance = Length::from_m(ruled.from_edge);
        let edge = if ruled.is_level {
            language.pick("上の端から", "from the upper edge")
        } else {
            language.pick("左の端から", "from the left edge")
        };
        vec![
            Cell::from(number.to_string()),
            Cell::bold(ruled.name.text(language)),
            Cell::from(edge),
            Cell::bold(cm(distance)),
            Cell::from(inches(distance)),
        ]
    });
    PageTable {
        columns: vec![
            Column::text("", 0.06),
            Column::text(language.pick("引く線", "line to draw"), 0.38),
            Column::text("", 0.28),
            Column::number("cm", 0.14),
            Column::number(language.pick("インチ", "inch"), 0.14),
        ],
        rows: rows.collect(),
        size_pt: 11.0,
    }
}
