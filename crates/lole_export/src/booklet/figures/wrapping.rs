//! A long cloth that is wound around its wearer: laid flat with its parts, and seen from above.

use std::f64::consts::TAU;

use kurbo::{BezPath, Point, Shape as _};
use lole_geom::trig64;
use lole_language::Language;
use lole_pattern::pattern::WrapPart;

use super::LABEL;
use crate::booklet::style::{ACCENT, CLOTH, SEWN};
use crate::canvas::Canvas;
use crate::pdf::{Align, Color, Rect, Sheet, Stroke, TextStyle};

/// Half width and half depth of the trunk seen from above [mm].
const TRUNK: [f64; 2] = [15.0, 10.5];
/// Cloth lies so far from the skin, and each turn so much farther out [mm].
const LAYER: f64 = 2.6;
/// Points of a turn.
const POINTS: f64 = 72.0;
/// Radius of the disk of a number [mm].
const DISK: f64 = 2.7;

/// Draws the cloth at the left, and the way that it goes around her at the right.
pub(super) fn draw(canvas: &mut Canvas<'_>, parts: &[WrapPart]) {
    let rect = canvas.rect;
    let above = 62.0;
    let flat = Rect {
        x: rect.x + 11.0,
        width: rect.width - above - 17.0,
        ..rect
    };
    draw_flat(canvas, flat, parts);
    let above = Rect {
        x: rect.x + rect.width - above,
        width: above,
        ..rect
    };
    draw_from_above(canvas, above, parts);
}

/// The cloth, parted, with a line for each part below it.
fn draw_flat(canvas: &mut Canvas<'_>, rect: Rect, parts: &[WrapPart]) {
    const HEIGHT: f64 = 12.0;
    let language = canvas.language;
    let sheet = &mut *canvas.sheet;
    let whole: f64 = parts.iter().map(|part| part.length.to_m()).sum();
    let strip = Rect {
        y: rect.y + 3.0,
        height: HEIGHT,
        ..rect
    };
    sheet.rect(strip, Some(CLOTH), Some(Stroke::solid(0.5)));
    let mut from = strip.x;
    let mut level = strip.y + HEIGHT + 5.5;
    for (number, part) in (1_u32..).zip(parts) {
        let to = from + strip.width * part.length.to_m() / whole.max(1e-6);
        if to < strip.x + strip.width - 0.1 {
            let stroke = Stroke::dashed(0.4, 1.2).with_color(SEWN);
            sheet.line([to, strip.y], [to, strip.y + HEIGHT], stroke);
        }
        numbered(sheet, [0.5 * (from + to), strip.y + 0.5 * HEIGHT], number);
        numbered(sheet, [rect.x + DISK, level - 1.3], number);
        let cm = part.length.to_cm();
        let name = part.name.text(language);
        let text = format!("{cm:.1} cm  {name}");
        let lines = LABEL.wrap(&text, rect.width - 8.0);
        for line in &lines {
            sheet.text([rect.x + 8.0, level], line, &LABEL, Align::Left);
            level += LABEL.line_height();
        }
        level += 1.4;
        from = to;
    }
}

/// A number in a disk around a point.
fn numbered(sheet: &mut Sheet, center: [f64; 2], number: u32) {
    let disk = kurbo::Circle::new((center[0], center[1]), DISK).to_path(0.01);
    sheet.path(disk, Some(ACCENT), None);
    let style = TextStyle::bold(9.5).with_color(Color::WHITE);
    let at = [center[0], center[1] + 1.2];
    sheet.text(at, &number.to_string(), &style, Align::Center);
}

/// Her trunk from above, her front towards the reader, and the cloth around it.
fn draw_from_above(canvas: &mut Canvas<'_>, rect: Rect, parts: &[WrapPart]) {
    let language = canvas.language;
    let sheet = &mut *canvas.sheet;
    let center = Point::new(rect.x + 0.5 * rect.width, rect.y + 29.0);
    let trunk = kurbo::Ellipse::new(center, (TRUNK[0], TRUNK[1]), 0.0).to_path(0.01);
    sheet.path(trunk, Some(Color(236, 224, 212)), Some(Stroke::solid(0.35)));
    let small = TextStyle::regular(9.0);
    let middle = |sheet: &mut Sheet, at: [f64; 2], text: &str| {
        sheet.text(at, text, &small, Align::Center);
    };
    let said = |japanese, english| language.pick(japanese, english);
    middle(
        sheet,
        [center.x, center.y + TRUNK[1] - 2.0],
        said("前", "front"),
    );
    middle(
        sheet,
        [center.x, center.y - TRUNK[1] + 4.0],
        said("後ろ", "back"),
    );
    middle(
        sheet,
        [center.x - TRUNK[0] + 4.2, center.y + 1.2],
        said("右", "right"),
    );
    middle(
        sheet,
        [center.x + TRUNK[0] - 4.0, center.y + 1.2],
        said("左", "left"),
    );
    for (number, part) in (1_u32..).zip(parts) {
        if let Some(turns) = part.around {
            draw_around(sheet, center, (turns, number));
        }
    }
    let foot = [center.x, rect.y + rect.height - 4.0];
    middle(sheet, foot, caption(language));
}

const fn caption(language: Language) -> &'static str {
    language.pick("上から見たところ", "seen from above")
}

/// One part around her, with an arrow at its end and its number where it begins.
fn draw_around(sheet: &mut Sheet, center: Point, ([from, to], number): ([f64; 2], u32)) {
    let out = |turn: f64| LAYER * (1.0 + turn - from);
    let at = |turn: f64| place(center, turn, out(turn));
    let count = ((to - from) * POINTS).ceil().max(2.0);
    let mut path = BezPath::new();
    path.move_to(at(from));
    let mut step = 1.0;
    while step <= count {
        path.line_to(at(from + (to - from) * step / count));
        step += 1.0;
    }
    sheet.path(path, None, Some(Stroke::solid(0.9).with_color(SEWN)));
    // The head of an arrow along the last stretch.
    let (end, before) = (at(to), at(to - 0.03));
    let along = (end - before) / (end - before).hypot().max(1e-9);
    let side = kurbo::Vec2::new(-along.y, along.x);
    let mut head = BezPath::new();
    head.move_to(end + along * 3.2);
    head.line_to(end + side * 1.5);
    head.line_to(end - side * 1.5);
    head.close_path();
    sheet.path(head, Some(SEWN), None);
    let outside = place(center, from, out(from) + out(to) + 1.0);
    let stroke = Stroke::solid(0.2).with_color(Color::GRAY);
    let begin = at(from);
    sheet.line([begin.x, begin.y], [outside.x, outside.y], stroke);
    numbered(sheet, [outside.x, outside.y], number);
}

/// A place around the trunk: 0 is the middle of the front, a quarter her left, so far from the skin [mm].
fn place(center: Point, turn: f64, out: f64) -> Point {
    let angle = turn * TAU;
    Point::new(
        center.x + (TRUNK[0] + out) * trig64::sin(angle),
        center.y + (TRUNK[1] + out) * trig64::cos(angle),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn her_left_is_at_the_readers_right_where_her_front_is_towards_the_reader() {
        let center = Point::new(0.0, 0.0);
        let [front, left, back] = [0.0, 0.25, 0.5].map(|turn| place(center, turn, 1.0));
        assert!((front.y - (TRUNK[1] + 1.0)).abs() < 1e-9 && front.x.abs() < 1e-9);
        assert!((left.x - (TRUNK[0] + 1.0)).abs() < 1e-9);
        assert!(back.y < 0.0);
    }
}
