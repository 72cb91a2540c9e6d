//! Two edges brought together: a piece closed to a ring is folded in half, others lie side by side.

use kurbo::Point;
use lole_pattern::pattern::{Pattern, Seam};
use lole_pattern::piece::{LineKind, Piece};

use super::piece::notches;
use super::section::levels;
use super::{LABEL, placement};
use crate::booklet::style::{ACCENT, CLOTH, INSIDE, SEWN};
use crate::canvas::Canvas;
use crate::cutting::draw::{arrow, fitting, line, outline};
use crate::pdf::{Align, Rect, Sheet, Stroke, TextStyle};

/// Seams side by side; those of the other side of the body look alike and are drawn once.
pub(super) fn draw(canvas: &mut Canvas<'_>, pattern: &Pattern, seams: &[usize]) {
    /// More would be too small to know.
    const MOST: usize = 3;
    let mut shown: Vec<&Seam> = Vec::new();
    for seam in seams.iter().filter_map(|&seam| pattern.seams.get(seam)) {
        let edges = |seam: &Seam| [seam.flat, seam.full].map(|side| (side.piece, side.edge));
        if !shown.iter().any(|other| edges(other) == edges(seam)) {
            shown.push(seam);
        }
    }
    if MOST < shown.len()
        && let Some(common) = common(&shown)
    {
        draw_onto(canvas, pattern, (&shown, common));
        return;
    }
    shown.truncate(MOST);
    let rect = canvas.rect;
    let gap = 8.0;
    let count = f64::from(u32::try_from(shown.len().max(1)).unwrap_or(1));
    let width = (rect.width - gap * (count - 1.0)) / count;
    for (index, seam) in (0_u32..).zip(shown) {
        let place = Rect {
            x: rect.x + f64::from(index) * (width + gap),
            width,
            ..rect
        };
        draw_seam(&mut canvas.at(place), pattern, seam);
    }
}

/// The piece that all seams are of, where there is one alone.
fn common(seams: &[&Seam]) -> Option<usize> {
    let has = |seam: &Seam, piece: usize| [seam.flat.piece, seam.full.piece].contains(&piece);
    let last = seams.last()?;
    let mut found = vec![last.flat.piece, last.full.piece];
    found.dedup();
    found.retain(|&piece| seams.iter().all(|seam| has(seam, piece)));
    match found[..] {
        [only] => Some(only),
        _ => None,
    }
}

/// Many pieces that are sewn onto one, as a sleeve into its armhole: it is drawn once, with all of its edges.
fn draw_onto(canvas: &mut Canvas<'_>, pattern: &Pattern, (seams, common): (&[&Seam], usize)) {
    /// Share of the width that the one piece has, and the arrow before it.
    const SHARES: [f64; 2] = [0.3, 0.09];
    let rect = canvas.rect;
    let Some(piece) = pattern.pieces.get(common) else {
        return;
    };
    let [own, between] = SHARES.map(|share| share * rect.width);
    let mut edges = Vec::new();
    // A seam of the piece with itself, as that below the arm, is among its edges.
    let own_seams = seams
        .iter()
        .filter(|seam| seam.flat.piece == seam.full.piece);
    edges.extend(own_seams.flat_map(|seam| [seam.flat.edge, seam.full.edge]));
    let others = || {
        seams
            .iter()
            .filter(|seam| seam.flat.piece != seam.full.piece)
    };
    let count = f64::from(u32::try_from(others().count().max(1)).unwrap_or(1));
    let width = (rect.width - own - between) / count;
    for (index, seam) in (0_u32..).zip(others()) {
        let (onto, side) = if seam.full.piece == common {
            (seam.full, seam.flat)
        } else {
            (seam.flat, seam.full)
        };
        edges.push(onto.edge);
        let place = Rect {
            x: rect.x + f64::from(index) * width,
            width: width - 3.0,
            ..rect
        };
        if let Some(other) = pattern.pieces.get(side.piece) {
            draw_side(&mut canvas.at(place), other, &[side.edge], width);
        }
    }
    let place = Rect {
        x: rect.x + rect.width - own,
        width: own,
        ..rect
    };
    draw_side(&mut canvas.at(place), piece, &edges, own);
    let y = rect.y + 0.5 * rect.height;
    let ends = [0.2, 0.8].map(|share| {
        let right = rect.x + rect.width - own;
        Point::new(right - between * (1.0 - share), y)
    });
    arrow(canvas.sheet, ends, &Stroke::solid(0.5).with_color(ACCENT));
}

fn draw_seam(canvas: &mut Canvas<'_>, pattern: &Pattern, seam: &Seam) {
    let sides = [seam.flat, seam.full];
    let [Some(one), Some(other)] = sides.map(|side| pattern.pieces.get(side.piece)) else {
        return;
    };
    let rect = canvas.rect;
    if seam.flat.piece == seam.full.piece && seam.flat.copy == seam.full.copy {
        if one.rectangle(1e-3).is_some() {
            draw_ring(canvas, one, seam.flat.edge);
        } else {
            draw_side(canvas, one, &[seam.flat.edge, seam.full.edge], rect.width);
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
        let most = half + 0.4 * between;
        draw_side(&mut canvas.at(place), piece, &[side.edge], most);
    }
    let y = rect.y + 0.5 * rect.height;
    let middle = rect.x + 0.5 * rect.width;
    let reach = 0.35 * between;
    let ends = [Point::new(middle - reach, y), Point::new(middle + reach, y)];
    arrow(canvas.sheet, ends, &Stroke::solid(0.5).with_color(ACCENT));
}

/// A piece with the edges that are sewn, and its name no wider than `most` [mm].
fn draw_side(canvas: &mut Canvas<'_>, piece: &Piece, edges: &[usize], most: f64) {
    let (rect, sheet) = (canvas.rect, &mut *canvas.sheet);
    let place = Rect {
        y: rect.y + 2.0,
        height: rect.height - 10.0,
        ..rect
    };
    let page = placement(piece, place);
    let cut = outline(&piece.cut_polygon(1e-3), page);
    sheet.path(cut, Some(CLOTH), Some(Stroke::solid(0.4)));
    let drawing = piece.drawing(1e-3);
    notches(sheet, &drawing, page);
    let gathers = drawing
        .lines
        .iter()
        .filter(|it| it.kind == LineKind::Gather);
    for gathers in gathers {
        let stroke = Stroke::dashed(0.5, 1.2).with_color(SEWN);
        sheet.path(line(&gathers.points, page), None, Some(stroke));
    }
    for edge in edges.iter().filter_map(|&edge| piece.edges.get(edge)) {
        let stroke = Stroke::solid(0.9).with_color(SEWN);
        sheet.path(line(&edge.points(1e-3), page), None, Some(stroke));
    }
    let at = [rect.x + 0.5 * rect.width, rect.y + rect.height - 2.0];
    let name = piece.name.text(canvas.language);
    let fitted = fitting(name, most, LABEL.size_pt).unwrap_or(LABEL);
    let label = TextStyle {
        size_pt: fitted.size_pt,
        ..LABEL
    };
    sheet.text(at, name, &label, Align::Center);
}

/// A piece folded right sides together, its ends sewn, with gaps where casings will be.
fn draw_ring(canvas: &mut Canvas<'_>, piece: &Piece, edge: usize) {
    let (rect, language) = (canvas.rect, canvas.language);
    let sheet = &mut *canvas.sheet;
    let bounds = piece.cut_polygon(1e-3).bounds();
    let height = rect.height - 12.0;
    let scale = height / bounds.height();
    let front = Rect {
        x: rect.x + 30.0,
        y: rect.y + 4.0,
        width: (0.5 * bounds.width() * scale).min(0.52 * rect.width),
        height,
    };
    // The layer behind shows at the fold and below.
    let behind = Rect {
        x: front.x - 1.5,
        y: front.y + 1.5,
        ..front
    };
    sheet.rect(behind, Some(CLOTH), Some(Stroke::solid(0.3)));
    sheet.rect(front, Some(INSIDE), Some(Stroke::solid(0.5)));
    let right = front.x + front.width;
    let allowance = piece
        .edges
        .get(edge)
        .map_or(0.0, |edge| edge.allowance.to_m());
    let x = right - (allowance * scale).clamp(2.5, 8.0);
    let gaps = gaps(piece);
    let on_page = gaps
        .iter()
        .map(|gap| gap.map(|down| front.y + down * scale));
    draw_gapped_seam(sheet, x, [front.y, front.y + height], on_page);
    let said = right + 5.0;
    if !gaps.is_empty() {
        let text = language.pick("あけておく（ゴムの口）", "leave open for the elastic");
        sheet.text([said, front.y + 8.0], text, &LABEL, Align::Left);
    }
    let sew = language.pick("縫う", "sew");
    sheet.text([said, front.y + 0.6 * height], sew, &LABEL, Align::Left);
    let level = front.y + 0.5 * height;
    let inside = language.pick("裏", "wrong side");
    let at = [front.x + 0.5 * front.width, level];
    sheet.text(at, inside, &LABEL, Align::Center);
    let fold = language.pick("わ", "fold");
    sheet.text([front.x - 4.0, level], fold, &LABEL, Align::Right);
}

/// A seam down at `x`, left open and fastened at both ends of each gap [mm].
fn draw_gapped_seam(
    sheet: &mut Sheet,
    x: f64,
    [top, bottom]: [f64; 2],
    gaps: impl Iterator<Item = [f64; 2]>,
) {
    let stroke = Stroke::dashed(0.7, 2.0).with_color(SEWN);
    let mut y = top;
    for [from, to] in gaps {
        sheet.line([x, y], [x, from], stroke.clone());
        let tick = Stroke::solid(0.5).with_color(SEWN);
        sheet.line([x - 1.5, from], [x + 1.5, from], tick.clone());
        sheet.line([x - 1.5, to], [x + 1.5, to], tick);
        y = to;
    }
    sheet.line([x, y], [x, bottom], stroke);
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
