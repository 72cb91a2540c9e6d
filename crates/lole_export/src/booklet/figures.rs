//! Drawings of the sewing steps, from the pieces themselves.
//!
//! Long pieces are drawn shorter than they are, so that what matters can be seen; sections show cloth
//! layer on layer with gaps between the layers.

use std::sync::Arc;

use kurbo::{Affine, BezPath, Point, Shape as _};
use lole_geom::Length;
use lole_language::{Language, words};
use lole_pattern::pattern::{Figure, NotionKind, Pattern, Seam};
use lole_pattern::piece::{Finish, LineKind, Mark, Piece, hem_turns};

use super::middle;
use super::style::{ACCENT, CLOTH, INSIDE, SEWN};
use crate::cutting::draw::{arrow, fitting, line, outline};
use crate::pdf::{Align, Color, Item, Rect, Sheet, Stroke, TextStyle};

/// Letters in drawings.
const LABEL: TextStyle = TextStyle::regular(11.0);

/// Height of the drawing of a step [mm]; 0 for none.
pub(super) const fn height(figure: &Figure) -> f64 {
    match figure {
        Figure::None => 0.0,
        Figure::Piece { .. } => 48.0,
        Figure::Seams(_) => 46.0,
        Figure::Section { .. } => 47.0,
    }
}

/// Draws a figure into its place.
pub(super) fn draw(
    sheet: &mut Sheet,
    rect: Rect,
    pattern: &Pattern,
    figure: &Figure,
    language: Language,
) {
    match figure {
        Figure::None => {}
        Figure::Piece {
            piece,
            edges,
            marks,
        } => {
            if let Some(piece) = pattern.pieces.get(*piece) {
                draw_piece(sheet, rect, piece, (edges, marks), language);
            }
        }
        Figure::Seams(seams) => draw_seams(sheet, rect, pattern, seams, language),
        Figure::Section { piece, marks } => {
            if let Some(piece) = pattern.pieces.get(*piece) {
                let has_elastic =
                    (pattern.notions.iter()).any(|notion| notion.kind == NotionKind::Elastic);
                let casing = if has_elastic {
                    words("ゴム通し", "casing")
                } else {
                    words("ひも通し", "casing")
                };
                let casing = casing.text(language);
                draw_section(sheet, rect, piece, (marks, casing), language);
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

fn path_of(points: &[Point], page: Affine) -> BezPath {
    line(points, page)
}

fn draw_piece(
    sheet: &mut Sheet,
    rect: Rect,
    piece: &Piece,
    (edges, marks): (&[usize], &[usize]),
    language: Language,
) {
    if let Some(region) = detail(piece, (edges, marks)) {
        draw_detail(sheet, rect, piece, (marks, region), language);
        return;
    }
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
    let page = placement(piece, place);
    let cut = piece.cut_polygon(1e-3);
    sheet.path(outline(&cut, page), Some(CLOTH), Some(Stroke::solid(0.5)));
    let drawing = piece.drawing(1e-3);
    for stitches in &drawing.stitches {
        let stroke = Stroke::dashed(0.2, 1.5).with_color(Color::GRAY);
        sheet.path(path_of(&stitches.points, page), None, Some(stroke));
    }
    let grain = drawing.grain.map(|end| page * end);
    if marks.is_empty() {
        arrow(sheet, grain, &Stroke::solid(0.3).with_color(Color::GRAY));
    }
    let bounds = cut.bounds();
    let is_whole = edges.len() == piece.edges.len();
    if is_whole || (!edges.is_empty() && drawing.rectangle.is_some()) {
        draw_sizes(sheet, page, bounds);
    }
    // What is cut has all of its edges; what is sewn is brought out.
    let sewn = edges.iter().filter(|_| !is_whole);
    for edge in sewn.filter_map(|&edge| piece.edges.get(edge)) {
        let stroke = Stroke::solid(0.9).with_color(SEWN);
        sheet.path(path_of(&edge.points(1e-3), page), None, Some(stroke));
    }
    let right = (page * Point::new(bounds.x1, 0.0)).x;
    let mut free = f64::NEG_INFINITY;
    let mut darts_named = false;
    for (kind, path) in lines_from_top(piece, marks) {
        let stroke = Stroke::solid(0.45).with_color(SEWN);
        sheet.path(page * path.clone(), None, Some(stroke));
        let on_piece = path.bounding_box().center();
        let at = page * on_piece;
        // Labels keep a line's distance, so that close lines can be told apart.
        let below = 100.0 * (bounds.y1 - on_piece.y);
        let name = short_name(kind, language);
        let text = match kind {
            // Both legs of a dart have one name; where it lies is in the pattern.
            LineKind::Dart if darts_named => continue,
            LineKind::Dart => {
                darts_named = true;
                name.to_owned()
            }
            LineKind::Slit => format!("{:.1} cm  {name}", 100.0 * long_side(path)),
            _ => format!("{below:.1} cm  {name}"),
        };
        let level = at.y.max(free + 4.6);
        free = level;
        let leader = Stroke::solid(0.15).with_color(Color::GRAY);
        sheet.line([right, at.y], [right + 6.0, level], leader);
        sheet.text(
            [right + 7.0, level + 1.3],
            &text,
            &TextStyle::regular(9.5),
            Align::Left,
        );
    }
}

/// Where a piece is to be shown larger: around lines that would be too small on the whole of it.
fn detail(piece: &Piece, (edges, marks): (&[usize], &[usize])) -> Option<kurbo::Rect> {
    /// Lines that reach over more of the piece are seen on the whole of it.
    const MOST: f64 = 0.3;
    let lines = lines_from_top(piece, marks);
    let is_small = |kind: LineKind| matches!(kind, LineKind::Dart | LineKind::Slit);
    if !edges.is_empty() || !lines.iter().all(|(kind, _)| is_small(*kind)) {
        return None;
    }
    let boxes = lines.iter().map(|(_, path)| path.bounding_box());
    let around = boxes.reduce(|one, other| one.union(other))?;
    let whole = piece.cut_polygon(1e-3).bounds();
    let size = around.width().max(around.height());
    (size < MOST * whole.height()).then(|| {
        let room = 0.4 * size;
        around.inflate(room, room)
    })
}

/// The whole piece small, and a part of it large beside it.
fn draw_detail(
    sheet: &mut Sheet,
    rect: Rect,
    piece: &Piece,
    (marks, region): (&[usize], kurbo::Rect),
    language: Language,
) {
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
    let scale = large.width / region.width();
    let page_large = Affine::translate((large.x, large.y))
        * Affine::scale_non_uniform(scale, -scale)
        * Affine::translate((-region.x0, -region.y1));
    let page_small = placement(piece, small);
    let gray = Stroke::solid(0.2).with_color(Color::GRAY);
    draw_marked(sheet, piece, page_small, (marks, 0.4));
    let [from, to] = [(region.x0, region.y1), (region.x1, region.y0)]
        .map(|corner| page_small * Point::from(corner));
    let frame = Rect {
        x: from.x,
        y: from.y,
        width: to.x - from.x,
        height: to.y - from.y,
    };
    sheet.rect(frame, None, Some(gray.clone()));
    sheet.line([to.x, from.y], [large.x, large.y], gray.clone());
    let foot = large.y + large.height;
    sheet.line([to.x, to.y], [large.x, foot], gray.clone());
    let mut inner = Sheet::new([0.0, 0.0]);
    draw_marked(&mut inner, piece, page_large, (marks, 0.7));
    sheet.items.push(Item::Group {
        page_from_group: Affine::IDENTITY,
        clip: Some(large),
        items: Arc::new(inner.items),
    });
    sheet.rect(large, None, Some(gray));
    if let Some((kind, path)) = lines_from_top(piece, marks).first() {
        let name = short_name(*kind, language);
        let text = match kind {
            LineKind::Slit => format!("{:.1} cm  {name}", 100.0 * long_side(path)),
            _ => name.to_owned(),
        };
        let at = [large.x + large.width + 4.0, large.y + 0.5 * large.height];
        sheet.text(at, &text, &LABEL, Align::Left);
    }
}

/// A piece with its stitching lines and some of its marks.
fn draw_marked(sheet: &mut Sheet, piece: &Piece, page: Affine, (marks, thick): (&[usize], f64)) {
    let cut = piece.cut_polygon(1e-4);
    sheet.path(outline(&cut, page), Some(CLOTH), Some(Stroke::solid(thick)));
    for stitches in &piece.drawing(1e-4).stitches {
        let stroke = Stroke::dashed(0.2, 1.5).with_color(Color::GRAY);
        sheet.path(path_of(&stitches.points, page), None, Some(stroke));
    }
    for (_, path) in lines_from_top(piece, marks) {
        let stroke = Stroke::solid(thick).with_color(SEWN);
        sheet.path(page * path.clone(), None, Some(stroke));
    }
}

/// Lines of a piece from the top down, so that no label's line crosses another's.
fn lines_from_top<'a>(piece: &'a Piece, marks: &[usize]) -> Vec<(LineKind, &'a BezPath)> {
    let mut lines: Vec<(LineKind, &BezPath)> = (marks.iter())
        .filter_map(|&mark| match piece.marks.get(mark) {
            Some(Mark::Line { kind, path }) => Some((*kind, path)),
            _ => None,
        })
        .collect();
    let level_of = |path: &BezPath| path.bounding_box().center().y;
    lines.sort_by(|(_, one), (_, other)| level_of(other).total_cmp(&level_of(one)));
    lines
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
    };
    language.pick(japanese, english)
}

/// Width below the piece, height at its left.
fn draw_sizes(sheet: &mut Sheet, page: Affine, bounds: kurbo::Rect) {
    let corner = page * Point::new(bounds.x0, bounds.y0);
    let far = page * Point::new(bounds.x1, bounds.y1);
    let stroke = Stroke::solid(0.25);
    let style = TextStyle::bold(12.0);
    let below = corner.y + 3.5;
    arrow(
        sheet,
        [Point::new(corner.x, below), Point::new(far.x, below)],
        &stroke,
    );
    // Halves of millimeters are rounded as in the sentences of the steps.
    let said = |meters: f64| format!("{:.1} cm", (1000.0 * meters).round() / 10.0);
    let width = said(bounds.width());
    sheet.text(
        [0.5 * (corner.x + far.x), below + 5.5],
        &width,
        &style,
        Align::Center,
    );
    let aside = corner.x - 3.5;
    arrow(
        sheet,
        [Point::new(aside, corner.y), Point::new(aside, far.y)],
        &stroke,
    );
    let height = said(bounds.height());
    let at = [aside - 2.0, 0.5 * (corner.y + far.y)];
    sheet.turned_text(
        at,
        core::f64::consts::FRAC_PI_2,
        &height,
        &style,
        Align::Center,
    );
}

/// Two edges brought together: a piece closed to a ring is folded in half, others lie side by side.
/// Seams side by side; those of the other side of the body look alike and are drawn once.
fn draw_seams(
    sheet: &mut Sheet,
    rect: Rect,
    pattern: &Pattern,
    seams: &[usize],
    language: Language,
) {
    /// More would be too small to know.
    const MOST: usize = 3;
    let mut shown: Vec<&Seam> = Vec::new();
    for seam in seams.iter().filter_map(|&seam| pattern.seams.get(seam)) {
        let edges = |seam: &Seam| [seam.flat, seam.full].map(|side| (side.piece, side.edge));
        if !shown.iter().any(|other| edges(other) == edges(seam)) {
            shown.push(seam);
        }
    }
    shown.truncate(MOST);
    let gap = 8.0;
    let count = f64::from(u32::try_from(shown.len().max(1)).unwrap_or(1));
    let width = (rect.width - gap * (count - 1.0)) / count;
    for (index, seam) in (0_u32..).zip(shown) {
        let place = Rect {
            x: rect.x + f64::from(index) * (width + gap),
            width,
            ..rect
        };
        draw_seam(sheet, place, pattern, seam, language);
    }
}

fn draw_seam(sheet: &mut Sheet, rect: Rect, pattern: &Pattern, seam: &Seam, language: Language) {
    let sides = [seam.flat, seam.full];
    let [Some(one), Some(other)] = sides.map(|side| pattern.pieces.get(side.piece)) else {
        return;
    };
    if seam.flat.piece == seam.full.piece && seam.flat.copy == seam.full.copy {
        if one.drawing(1e-3).rectangle.is_some() {
            draw_ring(sheet, rect, one, seam.flat.edge, language);
        } else {
            let edges = [seam.flat.edge, seam.full.edge];
            draw_side(sheet, rect, (one, &edges, rect.width), language);
        }
        return;
    }
    // The arrow between them, with room at its ends.
    let between = (0.12 * rect.width).clamp(9.0, 20.0);
    let half = 0.5 * (rect.width - between);
    for (index, (piece, side)) in [one, other].into_iter().zip(sides).enumerate() {
        let left = if index == 0 {
            rect.x
        } else {
            rect.x + half + between
        };
        let place = Rect {
            x: left,
            width: half,
            ..rect
        };
        let edges = [side.edge];
        draw_side(
            sheet,
            place,
            (piece, &edges, half + 0.4 * between),
            language,
        );
    }
    let y = rect.y + 0.5 * rect.height;
    let middle = rect.x + 0.5 * rect.width;
    let reach = 0.35 * between;
    let ends = [Point::new(middle - reach, y), Point::new(middle + reach, y)];
    arrow(sheet, ends, &Stroke::solid(0.5).with_color(ACCENT));
}

/// A piece with the edges that are sewn, and its name no wider than `most` [mm].
fn draw_side(
    sheet: &mut Sheet,
    rect: Rect,
    (piece, edges, most): (&Piece, &[usize], f64),
    language: Language,
) {
    let place = Rect {
        y: rect.y + 2.0,
        height: rect.height - 10.0,
        ..rect
    };
    let page = placement(piece, place);
    sheet.path(
        outline(&piece.cut_polygon(1e-3), page),
        Some(CLOTH),
        Some(Stroke::solid(0.4)),
    );
    for edge in edges.iter().filter_map(|&edge| piece.edges.get(edge)) {
        let stroke = Stroke::solid(0.9).with_color(SEWN);
        sheet.path(path_of(&edge.points(1e-3), page), None, Some(stroke));
    }
    let at = [rect.x + 0.5 * rect.width, rect.y + rect.height - 2.0];
    let name = piece.name.text(language);
    let fitted = fitting(name, most, LABEL.size_pt).unwrap_or(LABEL);
    let label = TextStyle {
        size_pt: fitted.size_pt,
        ..LABEL
    };
    sheet.text(at, name, &label, Align::Center);
}

/// A piece folded right sides together, its ends sewn, with gaps where casings will be.
fn draw_ring(sheet: &mut Sheet, rect: Rect, piece: &Piece, edge: usize, language: Language) {
    let bounds = piece.cut_polygon(1e-3).bounds();
    let height = rect.height - 12.0;
    let scale = height / bounds.height();
    let width = (0.5 * bounds.width() * scale).min(0.52 * rect.width);
    let [left, top] = [rect.x + 30.0, rect.y + 4.0];
    let [right, bottom] = [left + width, top + height];
    // The layer behind shows at the fold and below.
    let behind = Rect {
        x: left - 1.5,
        y: top + 1.5,
        width,
        height,
    };
    sheet.rect(behind, Some(CLOTH), Some(Stroke::solid(0.3)));
    let front = Rect {
        x: left,
        y: top,
        width,
        height,
    };
    sheet.rect(front, Some(INSIDE), Some(Stroke::solid(0.5)));
    let seam = piece.edges.get(edge);
    let allowance = seam.map_or(0.0, |edge| edge.allowance.to_m());
    let x = right - (allowance * scale).clamp(2.5, 8.0);
    let stroke = Stroke::dashed(0.7, 2.0).with_color(SEWN);
    let mut y = top;
    for [from, to] in gaps(piece) {
        let [from, to] = [from, to].map(|along| top + along * scale);
        sheet.line([x, y], [x, from], stroke.clone());
        let tick = Stroke::solid(0.5).with_color(SEWN);
        sheet.line([x - 1.5, from], [x + 1.5, from], tick.clone());
        sheet.line([x - 1.5, to], [x + 1.5, to], tick);
        y = to;
    }
    sheet.line([x, y], [x, bottom], stroke);
    let text = |sheet: &mut Sheet, at: [f64; 2], text: &str| {
        sheet.text(at, text, &LABEL, Align::Left);
    };
    let said = right + 5.0;
    if !gaps(piece).is_empty() {
        text(
            sheet,
            [said, top + 8.0],
            language.pick("あけておく（ゴムの口）", "leave open for the elastic"),
        );
    }
    text(
        sheet,
        [said, top + 0.6 * height],
        language.pick("縫う", "sew"),
    );
    let inside = language.pick("裏", "wrong side");
    sheet.text(
        [left + 0.5 * width, top + 0.5 * height],
        inside,
        &LABEL,
        Align::Center,
    );
    let fold = language.pick("わ", "fold");
    sheet.text([left - 4.0, top + 0.5 * height], fold, &LABEL, Align::Right);
}

/// Gaps of the closing seam, from the raw upper edge down [m]: the casings mirrored at the top fold,
/// as far as they lie in the folded band.
fn gaps(piece: &Piece) -> Vec<[f64; 2]> {
    let lines = levels(piece);
    let of = |wanted: LineKind| lines.iter().filter(move |(kind, _)| *kind == wanted);
    let Some(&(_, fold)) = of(LineKind::TopFold).next() else {
        return Vec::new();
    };
    let turn = of(LineKind::TurnUnder)
        .next()
        .map_or(0.0, |&(_, level)| level);
    let mut gaps: Vec<[f64; 2]> = of(LineKind::CasingTop)
        .zip(of(LineKind::CasingBottom))
        .map(|(&(_, from), &(_, to))| [2.0 * fold - to, 2.0 * fold - from])
        .filter(|gap| turn - 1e-6 <= gap[0])
        .collect();
    gaps.sort_by(|one, other| one[0].total_cmp(&other[0]));
    gaps
}

/// Marked level lines: what for, and how far below the raw upper edge [m].
fn levels(piece: &Piece) -> Vec<(LineKind, f64)> {
    let top = piece.cut_polygon(1e-3).bounds().y1;
    let marks = piece.marks.iter();
    marks
        .filter_map(|mark| match mark {
            Mark::Line { kind, path } => Some((*kind, top - path.bounding_box().center().y)),
            Mark::Notch { .. } | Mark::Point { .. } => None,
        })
        .collect()
}

/// Cloth in section: a band that is folded at the top, or a hem.
fn draw_section(
    sheet: &mut Sheet,
    rect: Rect,
    piece: &Piece,
    (marks, casing): (&[usize], &str),
    language: Language,
) {
    let all = levels(piece);
    let marks: Vec<(LineKind, f64)> = marks
        .iter()
        .filter_map(|&mark| all.get(mark).copied())
        .collect();
    let is_hem = marks.iter().all(|(kind, _)| *kind == LineKind::HemFold);
    if is_hem {
        draw_hem(sheet, rect, piece, language);
        return;
    }
    let level = |wanted: LineKind| {
        all.iter()
            .find(|(kind, _)| *kind == wanted)
            .map(|&(_, at)| at)
    };
    let Some(fold) = level(LineKind::TopFold) else {
        return;
    };
    let turn = level(LineKind::TurnUnder).unwrap_or(0.0);
    let depth = fold - turn;
    let scale = (rect.height - 14.0) / (1.25 * depth);
    let [outer, inner, top] = [rect.x + 60.0, rect.x + 68.0, rect.y + 6.0];
    let bottom = rect.y + rect.height - 2.0;
    let end = top + depth * scale;
    let path = band_path([outer, inner], [top, end, bottom], turn * scale);
    sheet.path(path, None, Some(Stroke::solid(0.9)));
    let said = [outer - 6.0, inner + 6.0];
    let casings = |wanted: LineKind| {
        let lines = marks.iter().filter(move |(kind, _)| *kind == wanted);
        lines.map(move |&(_, at)| top + (at - fold) * scale)
    };
    let in_band = |y: &f64| *y <= end + 0.5;
    let stitched = casings(LineKind::CasingTop).chain(casings(LineKind::CasingBottom));
    for y in stitched.filter(in_band) {
        let stroke = Stroke::dashed(0.6, 1.2).with_color(SEWN);
        sheet.line([outer - 3.0, y], [inner + 3.0, y], stroke);
    }
    let is_threaded = marks
        .first()
        .is_some_and(|(kind, _)| *kind == LineKind::TopFold);
    let mut number = 0;
    for (from, to) in casings(LineKind::CasingTop).zip(casings(LineKind::CasingBottom)) {
        number += 1;
        let y = 0.5 * (from + to);
        if is_threaded && y <= end {
            let elastic = kurbo::Rect::new(outer + 2.4, from + 0.8, inner - 2.4, to - 0.8);
            sheet.path(
                elastic.to_rounded_rect(1.0).to_path(0.01),
                Some(ACCENT),
                None,
            );
        }
        if y <= end {
            let text = match language {
                Language::Japanese => format!("{casing} {number} 段目"),
                Language::English => format!("{casing} {number}"),
            };
            sheet.text([said[1], y + 1.3], &text, &LABEL, Align::Left);
        }
    }
    section_labels(sheet, [outer, inner, top, end], (said, depth), language);
}

/// A band in section: outside up, over the fold, inside down, and the turned edge between the layers.
fn band_path([outer, inner]: [f64; 2], [top, end, bottom]: [f64; 3], turned: f64) -> BezPath {
    let mut path = BezPath::new();
    path.move_to((outer, bottom));
    path.line_to((outer, top + 2.0));
    path.curve_to((outer, top - 1.0), (inner, top - 1.0), (inner, top + 2.0));
    path.line_to((inner, end));
    path.curve_to(
        (inner, end + 1.5),
        (inner - 3.0, end + 1.5),
        (inner - 3.0, end),
    );
    path.line_to((inner - 3.0, end - turned));
    path
}

/// Names of the layers, and the depth of the band.
fn section_labels(
    sheet: &mut Sheet,
    [outer, inner, top, end]: [f64; 4],
    (said, depth): ([f64; 2], f64),
    language: Language,
) {
    let aside = outer - 12.0;
    let ends = [Point::new(aside, top), Point::new(aside, end)];
    arrow(sheet, ends, &Stroke::solid(0.25));
    let at = [aside - 2.0, 0.5 * (top + end)];
    let text = format!("{:.1} cm", 100.0 * depth);
    sheet.text(at, &text, &TextStyle::bold(12.0), Align::Right);
    let words = language.pick("上の折り山", "top fold");
    sheet.text([said[1], top + 0.5], words, &LABEL, Align::Left);
    let words = language.pick("表", "right side");
    sheet.text([said[0] - 8.0, end + 5.0], words, &LABEL, Align::Right);
    let words = language.pick(
        "裏（体の側）・折り代を中へ",
        "inside, raw edge turned under",
    );
    sheet.text([inner + 6.0, end + 5.0], words, &LABEL, Align::Left);
}

/// Centimeters with a second decimal where it takes one, as of half of 1.5 cm.
fn fine_cm(meters: f64) -> String {
    let hundredths = (1.0e4 * meters).round();
    if hundredths % 10.0 == 0.0 {
        format!("{:.1} cm", hundredths / 100.0)
    } else {
        format!("{:.2} cm", hundredths / 100.0)
    }
}

fn draw_hem(sheet: &mut Sheet, rect: Rect, piece: &Piece, language: Language) {
    let hem = piece.edges.iter().filter(|edge| edge.finish == Finish::Hem);
    // The lowest hem of the piece: the band has its own drawing.
    let lowest = |edge: &&lole_pattern::piece::Edge| {
        edge.segments
            .iter()
            .map(|segment| segment.bounding_box().y0)
            .fold(f64::INFINITY, f64::min)
    };
    let hem = hem.min_by(|one, other| lowest(one).total_cmp(&lowest(other)));
    let depth = hem.map_or(0.0, |edge| edge.allowance.to_m());
    if depth <= 0.0 {
        return;
    }
    let [turn, folded] = hem_turns(Length::from_m(depth)).map(Length::to_m);
    let [outer, inner] = [rect.x + 60.0, rect.x + 68.0];
    let [top, bottom] = [rect.y + 2.0, rect.y + rect.height - 8.0];
    let scale = 0.7 * (bottom - top) / folded;
    let end = bottom - folded * scale;
    let mut path = BezPath::new();
    path.move_to((outer, top));
    path.line_to((outer, bottom - 2.0));
    path.curve_to(
        (outer, bottom + 1.0),
        (inner, bottom + 1.0),
        (inner, bottom - 2.0),
    );
    path.line_to((inner, end));
    path.curve_to(
        (inner, end - 1.5),
        (inner - 3.0, end - 1.5),
        (inner - 3.0, end),
    );
    path.line_to((inner - 3.0, end + turn * scale));
    sheet.path(path, None, Some(Stroke::solid(0.9)));
    let stitch = end + 1.8;
    let stroke = Stroke::dashed(0.6, 1.2).with_color(SEWN);
    sheet.line([outer - 3.0, stitch], [inner + 3.0, stitch], stroke);
    let aside = outer - 12.0;
    let ends = [Point::new(aside, end), Point::new(aside, bottom)];
    arrow(sheet, ends, &Stroke::solid(0.25));
    let text = fine_cm(folded);
    let at = [aside - 2.0, 0.5 * (end + bottom)];
    sheet.text(at, &text, &TextStyle::bold(12.0), Align::Right);
    let said = inner + 6.0;
    let label = |sheet: &mut Sheet, y: f64, text: &str| {
        sheet.text([said, y], text, &LABEL, Align::Left);
    };
    label(
        sheet,
        stitch + 1.0,
        language.pick("ぐるりと縫う", "sew all around"),
    );
    let turned = fine_cm(turn);
    let turned = match language {
        Language::Japanese => format!("中へ {turned} 折る"),
        Language::English => format!("{turned} turned under"),
    };
    label(sheet, end + 9.0, &turned);
    label(sheet, bottom + 1.0, language.pick("裾の折り線", "hem fold"));
}
