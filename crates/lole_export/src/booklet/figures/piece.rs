//! A piece with the edges and lines that a step works on.

use std::sync::Arc;

use kurbo::{Affine, BezPath, Point, Shape as _};
use lole_language::Language;
use lole_pattern::piece::{Drawing, LineKind, Mark, Piece};

use super::{LABEL, placement};
use crate::booklet::middle;
use crate::booklet::style::{CLOTH, SEWN};
use crate::canvas::Canvas;
use crate::cutting::draw::{arrow, draw_notch, line, outline};
use crate::pdf::{Align, Color, Item, Rect, Sheet, Stroke, TextStyle};

/// A piece, and what of it a step works on.
pub(super) struct WorkedPiece<'a> {
    pub(super) piece: &'a Piece,
    /// Indices into [`Piece::edges`].
    pub(super) edges: &'a [usize],
    /// Indices into [`Piece::marks`].
    pub(super) marks: &'a [usize],
}

impl WorkedPiece<'_> {
    /// Draws the whole piece, or a part of it larger where the work is too small to be seen on it.
    pub(super) fn draw(&self, canvas: &mut Canvas<'_>) {
        match self.detail() {
            Some(region) => self.draw_detail(canvas, region),
            None => self.draw_whole(canvas),
        }
    }

    fn draw_whole(&self, canvas: &mut Canvas<'_>) {
        let rect = canvas.rect;
        let place = middle(
            Rect {
                y: rect.y + 3.0,
                height: rect.height - 14.0,
                ..rect
            },
            rect.width - 76.0,
        );
        let place = Rect {
            x: rect.x + 16.0,
            ..place
        };
        let (piece, sheet) = (self.piece, &mut *canvas.sheet);
        let page = placement(piece, place);
        let cut = piece.cut_polygon(1e-3);
        sheet.path(outline(&cut, page), Some(CLOTH), Some(Stroke::solid(0.5)));
        let drawing = piece.drawing(1e-3);
        for stitches in &drawing.stitches {
            let stroke = Stroke::dashed(0.2, 1.5).with_color(Color::GRAY);
            sheet.path(line(&stitches.points, page), None, Some(stroke));
        }
        notches(sheet, &drawing, page);
        let grain = drawing.grain.map(|end| page * end);
        if self.marks.is_empty() {
            arrow(sheet, grain, &Stroke::solid(0.3).with_color(Color::GRAY));
        }
        let bounds = cut.bounds();
        let is_whole = self.edges.len() == piece.edges.len();
        if is_whole || (!self.edges.is_empty() && drawing.rectangle.is_some()) {
            draw_sizes(sheet, page, bounds);
        }
        // What is cut has all of its edges; what is sewn is brought out.
        let sewn = self.edges.iter().filter(|_| !is_whole);
        for edge in sewn.filter_map(|&edge| piece.edges.get(edge)) {
            let stroke = Stroke::solid(0.9).with_color(SEWN);
            sheet.path(line(&edge.points(1e-3), page), None, Some(stroke));
        }
        self.draw_lines(canvas, page, bounds);
    }

    /// The lines of the step, named at the right of the piece.
    fn draw_lines(&self, canvas: &mut Canvas<'_>, page: Affine, bounds: kurbo::Rect) {
        let sheet = &mut *canvas.sheet;
        let right = (page * Point::new(bounds.x1, 0.0)).x;
        let mut free = f64::NEG_INFINITY;
        let mut named: Vec<LineKind> = Vec::new();
        for (kind, path) in self.lines_from_top() {
            let stroke = Stroke::solid(0.45).with_color(SEWN);
            sheet.path(page * path.clone(), None, Some(stroke));
            let on_piece = path.bounding_box().center();
            let at = page * on_piece;
            let below = 100.0 * (bounds.y1 - on_piece.y);
            let name = short_name(kind, canvas.language);
            let box_of = path.bounding_box();
            let is_upright = kind == LineKind::Join && box_of.width() < box_of.height();
            let text = match kind {
                // Both legs of a dart have one name, and so have upright joins; where they lie is in the
                // pattern.
                _ if (kind == LineKind::Dart || is_upright) && named.contains(&kind) => continue,
                _ if kind == LineKind::Dart || is_upright => {
                    named.push(kind);
                    name.to_owned()
                }
                LineKind::Slit => format!("{:.1} cm  {name}", 100.0 * long_side(path)),
                _ => format!("{below:.1} cm  {name}"),
            };
            // Labels keep a line's distance, so that close lines can be told apart.
            let level = at.y.max(free + 4.6);
            free = level;
            let leader = Stroke::solid(0.15).with_color(Color::GRAY);
            sheet.line([right, at.y], [right + 6.0, level], leader);
            let at = [right + 7.0, level + 1.3];
            sheet.text(at, &text, &TextStyle::regular(9.5), Align::Left);
        }
    }

    /// What is to be shown larger: what lies around lines that would be too small on the whole piece.
    fn detail(&self) -> Option<kurbo::Rect> {
        /// Lines that reach over more of the piece are seen on the whole of it.
        const MOST: f64 = 0.3;
        let lines = self.lines_from_top();
        let is_small = |kind: LineKind| matches!(kind, LineKind::Dart | LineKind::Slit);
        if !self.edges.is_empty() || !lines.iter().all(|(kind, _)| is_small(*kind)) {
            return None;
        }
        let boxes = lines.iter().map(|(_, path)| path.bounding_box());
        let around = boxes.reduce(|one, other| one.union(other))?;
        let whole = self.piece.cut_polygon(1e-3).bounds();
        let size = around.width().max(around.height());
        (size < MOST * whole.height()).then(|| {
            let room = 0.4 * size;
            around.inflate(room, room)
        })
    }

    /// The whole piece small, and a part of it large beside it.
    fn draw_detail(&self, canvas: &mut Canvas<'_>, region: kurbo::Rect) {
        let (rect, sheet) = (canvas.rect, &mut *canvas.sheet);
        let small = Rect {
            x: rect.x + 11.0,
            y: rect.y + 2.0,
            width: 36.0,
            height: rect.height - 8.0,
        };
        let room = Rect {
            x: small.x + small.width + 12.0,
            width: 70.0,
            ..small
        };
        let large = room.fitting(region.width(), region.height());
        let page_small = placement(self.piece, small);
        self.draw_marked(sheet, page_small, 0.4);
        let [from, to] = [(region.x0, region.y1), (region.x1, region.y0)]
            .map(|corner| page_small * Point::from(corner));
        let frame = Rect {
            x: from.x,
            y: from.y,
            width: to.x - from.x,
            height: to.y - from.y,
        };
        let gray = Stroke::solid(0.2).with_color(Color::GRAY);
        sheet.rect(frame, None, Some(gray.clone()));
        sheet.line([to.x, from.y], [large.x, large.y], gray.clone());
        let foot = large.y + large.height;
        sheet.line([to.x, to.y], [large.x, foot], gray.clone());
        sheet.items.push(self.enlarged(region, large));
        sheet.rect(large, None, Some(gray));
        if let Some((kind, path)) = self.lines_from_top().first() {
            let name = short_name(*kind, canvas.language);
            let text = match kind {
                LineKind::Slit => format!("{:.1} cm  {name}", 100.0 * long_side(path)),
                _ => name.to_owned(),
            };
            let at = [large.x + large.width + 4.0, large.y + 0.5 * large.height];
            sheet.text(at, &text, &LABEL, Align::Left);
        }
    }

    /// A region of the piece as it fills a place of its proportions.
    fn enlarged(&self, region: kurbo::Rect, place: Rect) -> Item {
        let scale = place.width / region.width();
        let page = Affine::translate((place.x, place.y))
            * Affine::scale_non_uniform(scale, -scale)
            * Affine::translate((-region.x0, -region.y1));
        let mut inner = Sheet::new([0.0, 0.0]);
        self.draw_marked(&mut inner, page, 0.7);
        Item::Group {
            page_from_group: Affine::IDENTITY,
            clip: Some(place),
            items: Arc::new(inner.items),
        }
    }

    /// The piece with its stitching lines and the step's lines, all as thick [mm].
    fn draw_marked(&self, sheet: &mut Sheet, page: Affine, thick: f64) {
        let cut = self.piece.cut_polygon(1e-4);
        sheet.path(outline(&cut, page), Some(CLOTH), Some(Stroke::solid(thick)));
        for stitches in &self.piece.drawing(1e-4).stitches {
            let stroke = Stroke::dashed(0.2, 1.5).with_color(Color::GRAY);
            sheet.path(line(&stitches.points, page), None, Some(stroke));
        }
        for (_, path) in self.lines_from_top() {
            let stroke = Stroke::solid(thick).with_color(SEWN);
            sheet.path(page * path.clone(), None, Some(stroke));
        }
    }

    /// The lines from the top down, so that no label's line crosses another's.
    fn lines_from_top(&self) -> Vec<(LineKind, &BezPath)> {
        let mut lines: Vec<(LineKind, &BezPath)> = (self.marks.iter())
            .filter_map(|&mark| match self.piece.marks.get(mark) {
                Some(Mark::Line { kind, path }) => Some((*kind, path)),
                _ => None,
            })
            .collect();
        let level_of = |path: &BezPath| path.bounding_box().center().y;
        lines.sort_by(|(_, one), (_, other)| level_of(other).total_cmp(&level_of(one)));
        lines
    }
}

/// The notches of a piece in a drawing of a step.
pub(super) fn notches(sheet: &mut Sheet, drawing: &Drawing, page: Affine) {
    /// As long as can be seen where pieces are small [mm].
    const LONG: f64 = 2.4;
    let stroke = Stroke::solid(0.5);
    for notch in &drawing.notches {
        draw_notch(sheet, notch, page, (&stroke, LONG));
    }
}

/// Length of a line that runs straight across or down [m].
fn long_side(path: &BezPath) -> f64 {
    let bounds = path.bounding_box();
    bounds.width().max(bounds.height())
}

/// Names that fit beside a drawing.
const fn short_name(kind: LineKind, language: Language) -> &'static str {
    let (japanese, english) = match kind {
        LineKind::TurnUnder => ("折り代", "turn under"),
        LineKind::TopFold => ("上の折り山", "top fold"),
        LineKind::CasingTop => ("ゴム通し 上", "casing, top"),
        LineKind::CasingBottom => ("ゴム通し 下", "casing, bottom"),
        LineKind::HemFold => ("裾の折り線", "hem fold"),
        LineKind::Gather => ("ギャザー", "gathers"),
        LineKind::Dart => ("ダーツ", "dart"),
        LineKind::Placement => ("付け位置", "placement"),
        LineKind::Slit => ("切り込み", "slit"),
        LineKind::Join => ("はぎ", "join"),
        LineKind::Adjust => ("丈の調整", "length"),
    };
    language.pick(japanese, english)
}

/// Width below the piece, height at its left.
fn draw_sizes(sheet: &mut Sheet, page: Affine, bounds: kurbo::Rect) {
    let corner = page * Point::new(bounds.x0, bounds.y0);
    let far = page * Point::new(bounds.x1, bounds.y1);
    let stroke = Stroke::solid(0.25);
    let style = TextStyle::bold(12.0);
    // Halves of millimeters are rounded as in the sentences of the steps.
    let said = |meters: f64| format!("{:.1} cm", (1000.0 * meters).round() / 10.0);
    let below = corner.y + 3.5;
    let ends = [Point::new(corner.x, below), Point::new(far.x, below)];
    arrow(sheet, ends, &stroke);
    let at = [0.5 * (corner.x + far.x), below + 5.5];
    sheet.text(at, &said(bounds.width()), &style, Align::Center);
    let aside = corner.x - 3.5;
    let ends = [Point::new(aside, corner.y), Point::new(aside, far.y)];
    arrow(sheet, ends, &stroke);
    let at = [aside - 2.0, 0.5 * (corner.y + far.y)];
    let quarter = core::f64::consts::FRAC_PI_2;
    sheet.turned_text(at, quarter, &said(bounds.height()), &style);
}
