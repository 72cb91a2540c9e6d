//! Cloth in section: a band that is folded at the top, or a hem.

use kurbo::{BezPath, Point, Shape as _};
use lole_geom::Length;
use lole_language::{Language, Words};
use lole_pattern::piece::{Edge, Finish, LineKind, Mark, Piece, hem_turns};

use super::LABEL;
use crate::booklet::style::{ACCENT, SEWN};
use crate::canvas::Canvas;
use crate::cutting::draw::arrow;
use crate::pdf::{Align, Sheet, Stroke, TextStyle};

/// Draws the section across some marks of a piece; `casing` is what its casings are called.
pub(super) fn draw(canvas: &mut Canvas<'_>, piece: &Piece, marks: &[usize], casing: Words) {
    let all = levels(piece);
    let marks: Vec<(LineKind, f64)> = marks
        .iter()
        .filter_map(|&mark| all.get(mark).copied())
        .collect();
    if marks.iter().all(|(kind, _)| *kind == LineKind::HemFold) {
        draw_hem(canvas, piece);
        return;
    }
    let level = |wanted: LineKind| {
        let mut levels = all.iter().filter(|(kind, _)| *kind == wanted);
        levels.next().map(|&(_, at)| at)
    };
    let Some(fold) = level(LineKind::TopFold) else {
        return;
    };
    let rect = canvas.rect;
    let turn = level(LineKind::TurnUnder).unwrap_or(0.0);
    let depth = fold - turn;
    let scale = (rect.height - 14.0) / (1.25 * depth);
    let top = rect.y + 6.0;
    let section = Folded {
        layers: [rect.x + 60.0, rect.x + 68.0],
        beginning: rect.y + rect.height - 2.0,
        fold: top,
        end: top + depth * scale,
        turned: turn * scale,
    };
    let sheet = &mut *canvas.sheet;
    sheet.path(section.path(), None, Some(Stroke::solid(0.9)));
    let casings = |wanted: LineKind| {
        let lines = marks.iter().filter(move |(kind, _)| *kind == wanted);
        lines.map(move |&(_, at)| top + (at - fold) * scale)
    };
    let stitched = casings(LineKind::CasingTop).chain(casings(LineKind::CasingBottom));
    for y in stitched.filter(|y| *y <= section.end + 0.5) {
        section.draw_stitches(sheet, y);
    }
    let is_threaded = marks
        .first()
        .is_some_and(|(kind, _)| *kind == LineKind::TopFold);
    let casings = casings(LineKind::CasingTop).zip(casings(LineKind::CasingBottom));
    for (number, (from, to)) in (1..).zip(casings) {
        let y = 0.5 * (from + to);
        if section.end < y {
            continue;
        }
        if is_threaded {
            section.draw_elastic(sheet, [from, to]);
        }
        let name = numbered(casing, number, canvas.language);
        let at = [section.layers[1] + 6.0, y + 1.3];
        sheet.text(at, &name, &LABEL, Align::Left);
    }
    section.draw_depth(
        sheet,
        [top, section.end],
        &format!("{:.1} cm", 100.0 * depth),
    );
    section.name_layers(canvas);
}

/// "casing 2".
fn numbered(casing: Words, number: u32, language: Language) -> String {
    let name = casing.text(language);
    match language {
        Language::Japanese => format!("{name} {number} 段目"),
        Language::English => format!("{name} {number}"),
    }
}

/// Cloth that is folded over and turned under, as a line on the page [mm].
struct Folded {
    /// Where the outer and the inner layer stand.
    layers: [f64; 2],
    /// Where the outer layer begins, far from the fold.
    beginning: f64,
    fold: f64,
    /// Where the inner layer ends.
    end: f64,
    /// How much of the inner layer's end is turned between the layers.
    turned: f64,
}

impl Folded {
    /// Along the outer layer, over the fold, along the inner one, and the turned edge between them.
    fn path(&self) -> BezPath {
        let Self {
            layers: [outer, inner],
            fold,
            end,
            ..
        } = *self;
        // Away from the layers at the fold.
        let out = if self.beginning < fold { 1.0 } else { -1.0 };
        let mut path = BezPath::new();
        path.move_to((outer, self.beginning));
        path.line_to((outer, fold - 2.0 * out));
        path.curve_to(
            (outer, fold + out),
            (inner, fold + out),
            (inner, fold - 2.0 * out),
        );
        path.line_to((inner, end));
        let turn = end - 1.5 * out;
        path.curve_to((inner, turn), (inner - 3.0, turn), (inner - 3.0, end));
        path.line_to((inner - 3.0, end + self.turned * out));
        path
    }

    /// Stitches through both layers.
    fn draw_stitches(&self, sheet: &mut Sheet, y: f64) {
        let [outer, inner] = self.layers;
        let stroke = Stroke::dashed(0.6, 1.2).with_color(SEWN);
        sheet.line([outer - 3.0, y], [inner + 3.0, y], stroke);
    }

    /// Elastic between the layers.
    fn draw_elastic(&self, sheet: &mut Sheet, [from, to]: [f64; 2]) {
        let [outer, inner] = self.layers;
        let elastic = kurbo::Rect::new(outer + 2.4, from + 0.8, inner - 2.4, to - 0.8);
        let elastic = elastic.to_rounded_rect(1.0).to_path(0.01);
        sheet.path(elastic, Some(ACCENT), None);
    }

    /// An arrow beside the layers, with how deep what it spans is.
    fn draw_depth(&self, sheet: &mut Sheet, [from, to]: [f64; 2], said: &str) {
        let aside = self.layers[0] - 12.0;
        let ends = [Point::new(aside, from), Point::new(aside, to)];
        arrow(sheet, ends, &Stroke::solid(0.25));
        let at = [aside - 2.0, 0.5 * (from + to)];
        sheet.text(at, said, &TextStyle::bold(12.0), Align::Right);
    }

    /// Names of a band's layers.
    fn name_layers(&self, canvas: &mut Canvas<'_>) {
        let (sheet, language) = (&mut *canvas.sheet, canvas.language);
        let [outer, inner] = self.layers;
        let words = language.pick("上の折り山", "top fold");
        sheet.text([inner + 6.0, self.fold + 0.5], words, &LABEL, Align::Left);
        let words = language.pick("表", "right side");
        let at = [outer - 6.0 - 8.0, self.end + 5.0];
        sheet.text(at, words, &LABEL, Align::Right);
        let words = language.pick(
            "裏（体の側）・折り代を中へ",
            "inside, raw edge turned under",
        );
        sheet.text([inner + 6.0, self.end + 5.0], words, &LABEL, Align::Left);
    }
}

/// Marked level lines: what for, and how far below the raw upper edge [m].
pub(super) fn levels(piece: &Piece) -> Vec<(LineKind, f64)> {
    let top = piece.cut_polygon(1e-3).bounds().y1;
    let marks = piece.marks.iter();
    marks
        .filter_map(|mark| match mark {
            Mark::Line { kind, path } => Some((*kind, top - path.bounding_box().center().y)),
            Mark::Notch { .. } | Mark::Point { .. } => None,
        })
        .collect()
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

/// Depth of the lowest hem of a piece [m], as its band has its own drawing; 0 without a hem.
fn hem_depth(piece: &Piece) -> f64 {
    let lowest = |edge: &&Edge| {
        let boxes = edge.segments.iter().map(|segment| segment.bounding_box());
        boxes.map(|bounds| bounds.y0).fold(f64::INFINITY, f64::min)
    };
    let hems = piece.edges.iter().filter(|edge| edge.finish == Finish::Hem);
    let hem = hems.min_by(|one, other| lowest(one).total_cmp(&lowest(other)));
    hem.map_or(0.0, |edge| edge.allowance.to_m())
}

fn draw_hem(canvas: &mut Canvas<'_>, piece: &Piece) {
    let depth = hem_depth(piece);
    if depth <= 0.0 {
        return;
    }
    let (rect, language) = (canvas.rect, canvas.language);
    let sheet = &mut *canvas.sheet;
    let [turn, folded] = hem_turns(Length::from_m(depth)).map(Length::to_m);
    let [top, bottom] = [rect.y + 2.0, rect.y + rect.height - 8.0];
    let scale = 0.7 * (bottom - top) / folded;
    let section = Folded {
        layers: [rect.x + 60.0, rect.x + 68.0],
        beginning: top,
        fold: bottom,
        end: bottom - folded * scale,
        turned: turn * scale,
    };
    let end = section.end;
    sheet.path(section.path(), None, Some(Stroke::solid(0.9)));
    let stitch = end + 1.8;
    section.draw_stitches(sheet, stitch);
    section.draw_depth(sheet, [end, bottom], &fine_cm(folded));
    let turned = fine_cm(turn);
    let turned = match language {
        Language::Japanese => format!("中へ {turned} 折る"),
        Language::English => format!("{turned} turned under"),
    };
    for (y, text) in [
        (
            stitch + 1.0,
            language.pick("ぐるりと縫う", "sew all around"),
        ),
        (end + 9.0, turned.as_str()),
        (bottom + 1.0, language.pick("裾の折り線", "hem fold")),
    ] {
        let at = [section.layers[1] + 6.0, y];
        sheet.text(at, text, &LABEL, Align::Left);
    }
}
