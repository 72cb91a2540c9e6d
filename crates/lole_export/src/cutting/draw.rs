//! Pieces drawn on a page, at full size or small.

use kurbo::{Affine, BezPath, Point, Vec2};
use lole_language::{Language, words};
use lole_pattern::piece::{Drawing, Finish, LineKind};
use lole_pattern::polygon::Polygon;

use super::label::Label;
use crate::pdf::{Align, Color, Sheet, Stroke, TextStyle};

/// Length of a notch [mm].
const NOTCH: f64 = 5.0;
/// Distance of the two cuts of a double notch [mm].
const NOTCH_PITCH: f64 = 4.0;
/// Length of an arrow's head [mm].
const HEAD: f64 = 5.0;

/// Points nearer to a line than this are on it [m].
const ON_LINE: f64 = 1.0e-5;

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

/// Everything of a piece at full size, and its words in their place.
pub(super) fn full_size(
    sheet: &mut Sheet,
    drawing: &Drawing,
    (words, label): (&[String], &Label),
    page_from_piece: Affine,
    language: Language,
) {
    for stitches in &drawing.stitches {
        draw_edge(sheet, stitches, page_from_piece, language);
    }
    let thin = Stroke::solid(0.25);
    let mut dart_end = None;
    for marked in &drawing.lines {
        sheet.path(
            line(&marked.points, page_from_piece),
            None,
            Some(thin.clone()),
        );
        // Both legs of a dart end in one point and have one name.
        let end = marked.points.last().copied();
        let is_second_leg = marked.kind == LineKind::Dart && dart_end == end;
        if marked.kind == LineKind::Dart {
            dart_end = end;
        }
        if let Some(at) = middle(&marked.points).filter(|_| !is_second_leg) {
            let at = page_from_piece * at;
            let style = TextStyle::regular(8.0);
            sheet.text(
                [at.x + 1.0, at.y - 1.0],
                marked.kind.name().text(language),
                &style,
                Align::Left,
            );
        }
    }
    for (name, at) in &drawing.points {
        let at = page_from_piece * *at;
        for arm in [Vec2::new(4.0, 0.0), Vec2::new(0.0, 4.0)] {
            let [from, to] = [at - arm, at + arm];
            sheet.line([from.x, from.y], [to.x, to.y], thin.clone());
        }
        sheet.text(
            [at.x + 2.0, at.y - 2.0],
            name.text(language),
            &TextStyle::regular(8.0),
            Align::Left,
        );
    }
    let cut = cut_path(drawing, page_from_piece);
    sheet.path(cut, None, Some(Stroke::solid(0.5)));
    for notch in &drawing.notches {
        draw_notch(sheet, notch, page_from_piece);
    }
    let grain = drawing.grain.map(|end| page_from_piece * end);
    arrow(sheet, grain, &Stroke::solid(0.35));
    draw_label(sheet, words, label);
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

/// The stitching line of an edge: broken where it is sewn, and said where it lies on a fold.
fn draw_edge(
    sheet: &mut Sheet,
    stitches: &lole_pattern::piece::DrawnStitches,
    page_from_piece: Affine,
    language: Language,
) {
    let path = line(&stitches.points, page_from_piece);
    if stitches.finish == Finish::Fold {
        sheet.path(
            path,
            None,
            Some(Stroke {
                dashes: vec![12.0, 3.0, 2.0, 3.0],
                ..Stroke::solid(0.7)
            }),
        );
        if let (Some(first), Some(last)) = (stitches.points.first(), stitches.points.last()) {
            let [from, to] = [*first, *last].map(|end| page_from_piece * end);
            let at = from.midpoint(to);
            let along = to - from;
            // Words that would stand on their head are turned over.
            let upright = if along.x < 0.0 { -along } else { along };
            let angle = -lole_geom::trig64::atan2(upright.y, upright.x);
            let style = TextStyle::bold(12.0);
            // Edges run counterclockwise: on the page the piece is on the right, and the words stand
            // on it.
            let inward = Vec2::new(along.y, -along.x) / along.hypot().max(1e-9);
            let letters = if along.x < 0.0 { 6.0 } else { 2.5 };
            let at = at + inward * letters;
            let words = words("わ（布の折り山に置く）", "place on fold").text(language);
            sheet.turned_text([at.x, at.y], angle, words, &style, Align::Center);
        }
    } else if 1e-9 < stitches.allowance.to_m() {
        sheet.path(
            path,
            None,
            Some(Stroke::dashed(0.3, 3.0).with_color(STITCH)),
        );
    }
}

fn draw_notch(sheet: &mut Sheet, notch: &lole_pattern::piece::DrawnNotch, page_from_piece: Affine) {
    let at = page_from_piece * notch.at;
    let inward = page_from_piece * (notch.at + notch.inward) - at;
    let inward = inward / inward.hypot().max(1e-9);
    let side = Vec2::new(-inward.y, inward.x) * (0.5 * NOTCH_PITCH);
    let places: &[f64] = if notch.is_double {
        &[-1.0, 1.0]
    } else {
        &[0.0]
    };
    for place in places {
        let from = at + side * *place;
        let to = from + inward * NOTCH;
        sheet.line([from.x, from.y], [to.x, to.y], Stroke::solid(0.5));
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
