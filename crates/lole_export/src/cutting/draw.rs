//! Pieces drawn on a page, at full size or small.

use kurbo::{Affine, BezPath, Point, Vec2};
use lole_language::{Language, Words, words};
use lole_pattern::piece::{Drawing, DrawnNotch, DrawnStitches, Finish, LineKind};
use lole_pattern::polygon::Polygon;

use super::label::Label;
use crate::pdf::{Align, Color, Layer, Sheet, Stroke, TextStyle};

/// Length of a notch [mm].
const NOTCH: f64 = 5.0;
/// Distance of the two cuts of a double notch [mm].
const NOTCH_PITCH: f64 = 4.0;
/// Length of an arrow's head [mm].
const HEAD: f64 = 5.0;

/// Points nearer to a line than this are on it [m].
const ON_LINE: f64 = 1.0e-5;

/// Letters of their names.
const NAME: TextStyle = TextStyle::regular(8.0);

/// What an edge on a fold says.
pub(super) const PLACE_ON_FOLD: Words = words("わ（布の折り山に置く）", "place on fold");

/// Color of stitching lines.
const STITCH: Color = Color(60, 60, 60);

/// A closed outline on the page.
pub(crate) fn outline(polygon: &Polygon, page_from_piece: Affine) -> BezPath {
    let mut path = line(&polygon.points, page_from_piece);
    path.close_path();
    path
}

/// A line through points on the page.
pub(crate) fn line(points: &[Point], page_from_piece: Affine) -> BezPath {
    let mut path = BezPath::new();
    for (index, point) in points.iter().enumerate() {
        let at = page_from_piece * *point;
        if index == 0 {
            path.move_to(at);
        } else {
            path.line_to(at);
        }
    }
    path
}

/// A straight line with a head at both ends.
pub(crate) fn arrow(sheet: &mut Sheet, [tail, head]: [Point; 2], stroke: &Stroke) {
    let mut path = BezPath::new();
    path.move_to(tail);
    path.line_to(head);
    let along = (head - tail) / (head - tail).hypot().max(1e-9);
    let size = HEAD.min(0.4 * tail.distance(head));
    let mut tip = |at: Point, along: Vec2| {
        let side = Vec2::new(-along.y, along.x);
        path.move_to(at - along * size + side * (0.35 * size));
        path.line_to(at);
        path.line_to(at - along * size - side * (0.35 * size));
    };
    tip(head, along);
    tip(tail, -along);
    sheet.path(path, None, Some(stroke.clone()));
}

/// What is drawn of pieces, by what it is for.
pub(super) struct PieceLines {
    /// Where they are sewn.
    sewing: Sheet,
    /// What is marked on the cloth, and the grain.
    marks: Sheet,
    /// Where they are cut, notches and folds with it.
    cut: Sheet,
    /// Their names.
    words: Sheet,
}

impl PieceLines {
    pub(super) const fn none() -> Self {
        const EMPTY: Sheet = Sheet::new([0.0, 0.0]);
        Self {
            sewing: EMPTY,
            marks: EMPTY,
            cut: EMPTY,
            words: EMPTY,
        }
    }

    /// As layers of a page, the lowest first.
    pub(super) fn into_layers(self, language: Language) -> Vec<Layer> {
        let named = [
            (words("縫い線", "sewing lines"), self.sewing),
            (words("印と布目", "marks and grain"), self.marks),
            (words("裁ち線", "cutting lines"), self.cut),
            (words("名前", "names of the pieces"), self.words),
        ];
        let layers = named.map(|(name, sheet)| Layer {
            name: name.text(language).to_owned(),
            items: sheet.items,
        });
        layers.into()
    }
}

/// Of lines on a piece, so many times as thick as on paper: dotted, so that nobody cuts along one.
pub(super) fn marked_stroke(thick: f64) -> Stroke {
    Stroke::dashed(0.3 * thick, 0.9)
}

/// A piece at full size.
pub(super) struct FullSize<'a> {
    pub(super) drawing: &'a Drawing,
    pub(super) page_from_piece: Affine,
    pub(super) language: Language,
    /// How thick lines are, over those of paper.
    pub(super) thick: f64,
}

impl FullSize<'_> {
    /// Draws everything of the piece, and its words in their place.
    pub(super) fn draw(&self, lines: &mut PieceLines, words: &[String], label: &Label) {
        let drawing = self.drawing;
        for stitches in &drawing.stitches {
            self.draw_edge(lines, stitches);
        }
        self.draw_lines(&mut lines.marks);
        self.draw_points(&mut lines.marks);
        let cut = cut_path(drawing, self.page_from_piece);
        let stroke = Stroke::solid(0.5 * self.thick);
        lines.cut.path(cut, None, Some(stroke.clone()));
        for notch in &drawing.notches {
            draw_notch(
                &mut lines.cut,
                notch,
                self.page_from_piece,
                (&stroke, NOTCH),
            );
        }
        let grain = drawing.grain.map(|end| self.page_from_piece * end);
        arrow(&mut lines.marks, grain, &Stroke::solid(0.35 * self.thick));
        draw_label(&mut lines.words, words, label);
    }

    /// Of lines and points on the piece.
    fn thin(&self) -> Stroke {
        marked_stroke(self.thick)
    }

    fn draw_lines(&self, sheet: &mut Sheet) {
        let mut dart_end = None;
        for marked in &self.drawing.lines {
            let path = line(&marked.points, self.page_from_piece);
            sheet.path(path, None, Some(self.thin()));
            // Both legs of a dart end in one point and have one name.
            let end = marked.points.last().copied();
            let is_second_leg = marked.kind == LineKind::Dart && dart_end == end;
            if marked.kind == LineKind::Dart {
                dart_end = end;
            }
            if let Some(at) = middle(&marked.points).filter(|_| !is_second_leg) {
                let at = self.page_from_piece * at;
                let name = marked.kind.name().text(self.language);
                sheet.text([at.x + 1.0, at.y - 1.0], name, &NAME, Align::Left);
            }
        }
    }

    fn draw_points(&self, sheet: &mut Sheet) {
        for (name, at) in &self.drawing.points {
            let at = self.page_from_piece * *at;
            for arm in [Vec2::new(4.0, 0.0), Vec2::new(0.0, 4.0)] {
                let [from, to] = [at - arm, at + arm];
                sheet.line([from.x, from.y], [to.x, to.y], self.thin());
            }
            let name = name.text(self.language);
            sheet.text([at.x + 2.0, at.y - 2.0], name, &NAME, Align::Left);
        }
    }

    /// The stitching line of an edge: broken where it is sewn, and said where it lies on a fold.
    fn draw_edge(&self, lines: &mut PieceLines, stitches: &DrawnStitches) {
        let path = line(&stitches.points, self.page_from_piece);
        if stitches.finish == Finish::Fold {
            lines.cut.path(path, None, Some(fold_stroke()));
            if let [first, .., last] = stitches.points[..] {
                self.say_fold(
                    &mut lines.cut,
                    [first, last].map(|end| self.page_from_piece * end),
                );
            }
        } else if 1e-9 < stitches.allowance.to_m() {
            let stroke = Stroke::dashed(0.3 * self.thick, 3.0).with_color(STITCH);
            lines.sewing.path(path, None, Some(stroke));
        }
    }

    /// What is done at a fold, along it.
    fn say_fold(&self, sheet: &mut Sheet, [from, to]: [Point; 2]) {
        let along = to - from;
        // Words that would stand on their head are turned over.
        let upright = if along.x < 0.0 { -along } else { along };
        let angle = -lole_geom::trig64::atan2(upright.y, upright.x);
        // Edges run counterclockwise: on the page the piece is on the right, and the words stand
        // on it.
        let inward = Vec2::new(along.y, -along.x) / along.hypot().max(1e-9);
        let letters = if along.x < 0.0 { 6.0 } else { 2.5 };
        let at = from.midpoint(to) + inward * letters;
        let words = PLACE_ON_FOLD.text(self.language);
        sheet.turned_text([at.x, at.y], angle, words, &TextStyle::bold(12.0));
    }
}

/// Of an edge on a fold.
pub(super) fn fold_stroke() -> Stroke {
    Stroke {
        dashes: vec![12.0, 3.0, 2.0, 3.0],
        ..Stroke::solid(0.7)
    }
}

/// The cut line without what lies on a fold, where nothing is cut.
fn cut_path(drawing: &Drawing, page_from_piece: Affine) -> BezPath {
    let folds: Vec<Polygon> = (drawing.stitches.iter())
        .filter(|stitches| stitches.finish == Finish::Fold)
        .map(|stitches| Polygon::new(stitches.points.iter().copied()))
        .collect();
    if folds.is_empty() {
        return outline(&drawing.cut, page_from_piece);
    }
    let is_on_fold = |point: Point| folds.iter().any(|fold| fold.distance(point) < ON_LINE);
    let mut path = BezPath::new();
    let mut end = None;
    for [from, to] in drawing.cut.sides() {
        // The allowances at both ends of the fold lie on it too, beyond its stitching line.
        let is_fold = is_on_fold(from.midpoint(to));
        if is_fold {
            continue;
        }
        if end != Some(from) {
            path.move_to(page_from_piece * from);
        }
        path.line_to(page_from_piece * to);
        end = Some(to);
    }
    path
}

/// Where the cuts of a notch lie beside it, in halves of their distance.
pub(crate) const fn notch_places(notch: &DrawnNotch) -> &'static [f64] {
    if notch.is_double {
        &[-1.0, 1.0]
    } else {
        &[0.0]
    }
}

/// A notch, as long as said [mm].
pub(crate) fn draw_notch(
    sheet: &mut Sheet,
    notch: &DrawnNotch,
    page_from_piece: Affine,
    (stroke, long): (&Stroke, f64),
) {
    let at = page_from_piece * notch.at;
    let inward = page_from_piece * (notch.at + notch.inward) - at;
    let inward = inward / inward.hypot().max(1e-9);
    let side = Vec2::new(-inward.y, inward.x) * (0.5 * NOTCH_PITCH / NOTCH * long);
    for place in notch_places(notch) {
        let from = at + side * *place;
        let to = from + inward * long;
        sheet.line([from.x, from.y], [to.x, to.y], stroke.clone());
    }
}

/// The words of a piece in their place, the last line lowest.
fn draw_label(sheet: &mut Sheet, words: &[String], label: &Label) {
    let Label { foot, style } = label;
    let count = f64::from(u32::try_from(words.len()).unwrap_or(1));
    for (row, text) in (0_u32..).zip(words) {
        let y = foot.y - style.line_height() * (count - 1.0 - f64::from(row));
        sheet.text([foot.x, y], text, style, Align::Center);
    }
}

/// The largest size of bold letters, at most `most` [pt], in which a line is no wider than `width`
/// [mm]; `None` where it would be too small to read.
pub(crate) fn fitting(text: &str, width: f64, most: f64) -> Option<TextStyle> {
    let natural = TextStyle::bold(most).width_of(text);
    let size_pt = if natural <= width {
        most
    } else {
        most * width / natural
    };
    (5.0 <= size_pt).then(|| TextStyle::bold(size_pt))
}

/// Page millimeters of a meter of the piece.
pub(super) fn scale_of(transform: Affine) -> f64 {
    transform.determinant().abs().sqrt()
}

/// The point in the middle of a line.
fn middle(points: &[Point]) -> Option<Point> {
    let lengths: Vec<f64> = points
        .windows(2)
        .map(|pair| pair[0].distance(pair[1]))
        .collect();
    let mut left = 0.5 * lengths.iter().sum::<f64>();
    for (pair, length) in points.windows(2).zip(&lengths) {
        if left <= *length && 0.0 < *length {
            return Some(pair[0].lerp(pair[1], left / length));
        }
        left -= length;
    }
    points.first().copied()
}
