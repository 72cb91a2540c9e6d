//! Work of hands without cloth: a braid, leaves wound on, a leaf slit, stems on a cord.

use std::f64::consts::TAU;

use kurbo::{BezPath, Point, Shape as _, Vec2};
use lole_geom::trig64;
use lole_language::Language;
use lole_pattern::pattern::Craft;

use super::LABEL;
use crate::booklet::style::{ACCENT, SEWN};
use crate::canvas::Canvas;
use crate::cutting::draw::arrow;
use crate::pdf::{Align, Color, Sheet, Stroke};

/// Leaves, flowers and their cord.
const LEAF: Color = Color(132, 170, 104);
const FLOWER: Color = Color(236, 160, 148);
const CORD: Color = Color(206, 178, 128);
const EDGE: Stroke = Stroke::solid(0.3);

/// Draws it into the place of a step's figure.
pub(super) fn draw(canvas: &mut Canvas<'_>, craft: Craft) {
    let rect = canvas.rect;
    let left = Point::new(rect.x + 14.0, rect.y + 0.5 * rect.height);
    match craft {
        Craft::Braid => draw_braid(canvas, left),
        Craft::Wili => draw_wili(canvas, left),
        Craft::SlitLeaf(stem) => draw_slit_leaf(canvas, left, stem.to_cm()),
        Craft::LeavesOnCord(gap) => draw_leaves_on_cord(canvas, left, gap.to_cm()),
    }
}

/// A braid of three between two points on a level: strands swing across and pass over each other in turn.
fn braid(sheet: &mut Sheet, left: Point, length: f64, [swing, pitch, wide]: [f64; 3]) {
    const STEPS: u32 = 8;
    let colors = [CORD, Color(226, 204, 164), Color(178, 148, 96)];
    let mut pieces: Vec<(f64, usize, Point, Point)> = Vec::new();
    let step = pitch / f64::from(3 * STEPS);
    let count = (length / step).floor().max(1.0);
    let mut index = 0.0;
    while index < count {
        for strand in 0..3_usize {
            let phase = |x: f64| TAU * (x / pitch + strand as f64 / 3.0);
            let at = |x: f64| Point::new(left.x + x, left.y + swing * trig64::sin(phase(x)));
            let x = index * step;
            let depth = trig64::sin(2.0 * phase(x + 0.5 * step));
            pieces.push((depth, strand, at(x), at(x + 1.2 * step)));
        }
        index += 1.0;
    }
    // What lies deeper is drawn first.
    pieces.sort_by(|one, other| one.0.total_cmp(&other.0));
    for (_, strand, from, to) in pieces {
        let ends = [[from.x, from.y], [to.x, to.y]];
        sheet.line(
            ends[0],
            ends[1],
            Stroke::solid(wide + 0.6).with_color(Color(90, 74, 48)),
        );
        sheet.line(
            ends[0],
            ends[1],
            Stroke::solid(wide).with_color(colors[strand]),
        );
    }
}

fn draw_braid(canvas: &mut Canvas<'_>, left: Point) {
    let (rect, language) = (canvas.rect, canvas.language);
    let sheet = &mut *canvas.sheet;
    // Three strands come together from the left.
    for (rise, color) in [
        (-9.0, CORD),
        (0.0, Color(226, 204, 164)),
        (9.0, Color(178, 148, 96)),
    ] {
        let from = left + Vec2::new(0.0, rise);
        let to = left + Vec2::new(26.0, 0.2 * rise);
        let stroke = Stroke::solid(2.2).with_color(color);
        sheet.line([from.x, from.y], [to.x, to.y], stroke);
    }
    braid(sheet, left + Vec2::new(26.0, 0.0), 70.0, [3.4, 24.0, 2.2]);
    let words = language.pick(
        "外の 1 本を中へ、左右かわるがわる",
        "the outer strand over to the middle, from either side in turn",
    );
    let at = [left.x, rect.y + rect.height - 3.0];
    sheet.text(at, words, &LABEL, Align::Left);
}

/// A leaf from its stem towards a direction, as long and wide as said [mm].
fn leaf(stem: Point, towards: Vec2, [long, wide]: [f64; 2]) -> BezPath {
    let along = towards / towards.hypot().max(1e-9);
    let side = Vec2::new(-along.y, along.x) * (0.66 * wide);
    let tip = stem + along * long;
    let mut path = BezPath::new();
    path.move_to(stem);
    path.curve_to(
        stem + along * (0.3 * long) + side,
        tip - along * (0.4 * long) + side,
        tip,
    );
    path.curve_to(
        tip - along * (0.4 * long) - side,
        stem + along * (0.3 * long) - side,
        stem,
    );
    path.close_path();
    path
}

fn draw_wili(canvas: &mut Canvas<'_>, left: Point) {
    let (rect, language) = (canvas.rect, canvas.language);
    let sheet = &mut *canvas.sheet;
    let base = left + Vec2::new(0.0, -2.0);
    braid(sheet, base, 96.0, [1.2, 10.0, 1.3]);
    // What is laid later lies over what was laid before it.
    let mut x = 20.0;
    let mut is_up = true;
    while x < 64.0 {
        let stem = base + Vec2::new(x, 0.0);
        let lean = if is_up { -0.55 } else { 0.55 };
        sheet.path(
            leaf(stem, Vec2::new(-1.0, lean), [17.0, 6.5]),
            Some(LEAF),
            Some(EDGE),
        );
        // The strand that winds them on, over the stems.
        let [from, to] = [Vec2::new(1.2, -2.6), Vec2::new(-0.6, 2.6)].map(|off| stem + off);
        sheet.line(
            [from.x, from.y],
            [to.x, to.y],
            Stroke::solid(0.9).with_color(SEWN),
        );
        x += 5.5;
        is_up = !is_up;
    }
    for place in [25.0, 41.0, 57.0] {
        let flower = kurbo::Circle::new(base + Vec2::new(place, -0.5), 2.8).to_path(0.01);
        sheet.path(flower, Some(FLOWER), Some(EDGE));
    }
    let end = base + Vec2::new(x - 5.5, 0.0);
    let hand = end + Vec2::new(14.0, 11.0);
    sheet.line(
        [end.x, end.y],
        [hand.x, hand.y],
        Stroke::solid(0.9).with_color(SEWN),
    );
    let at = [hand.x + 2.0, hand.y + 1.0];
    sheet.text(
        at,
        language.pick("巻くひも", "the strand that winds"),
        &LABEL,
        Align::Left,
    );
    let [from, to] = [40.0, 64.0].map(|x| base + Vec2::new(x, -13.0));
    let accent = Stroke::solid(0.4).with_color(ACCENT);
    sheet.line([from.x, from.y], [to.x, to.y], accent.clone());
    for side in [-1.5, 1.5] {
        sheet.line([to.x - 3.0, to.y + side], [to.x, to.y], accent.clone());
    }
    let words = language.pick(
        "根元を土台に当て、前の根元に重ねて巻く",
        "stems on the base, each over the stem before it, wound on",
    );
    sheet.text(
        [left.x, rect.y + rect.height - 2.0],
        words,
        &LABEL,
        Align::Left,
    );
}

fn draw_slit_leaf(canvas: &mut Canvas<'_>, left: Point, stem_cm: f64) {
    let (rect, language) = (canvas.rect, canvas.language);
    let sheet = &mut *canvas.sheet;
    let stem = left + Vec2::new(10.0, -2.0);
    sheet.path(
        leaf(stem, Vec2::new(1.0, 0.0), [88.0, 20.0]),
        Some(LEAF),
        Some(EDGE),
    );
    let [from, slit, tip] = [0.0, 22.0, 88.0].map(|x| stem + Vec2::new(x, 0.0));
    let tail = stem + Vec2::new(-10.0, 0.0);
    sheet.line(
        [tail.x, tail.y],
        [slit.x, slit.y],
        Stroke::solid(1.1).with_color(CORD),
    );
    sheet.line(
        [slit.x, slit.y],
        [tip.x, tip.y],
        Stroke::dashed(0.5, 1.6).with_color(SEWN),
    );
    // The midrib comes off towards the tip.
    let mut rib = BezPath::new();
    rib.move_to(slit);
    rib.curve_to(
        slit + Vec2::new(10.0, -2.0),
        slit + Vec2::new(20.0, -10.0),
        slit + Vec2::new(34.0, -13.0),
    );
    sheet.path(rib, None, Some(Stroke::solid(1.1).with_color(CORD)));
    let ends = [from, slit].map(|end| end + Vec2::new(0.0, 10.0));
    arrow(sheet, ends, &Stroke::solid(0.25));
    let at = [ends[0].x + 11.0, ends[0].y + 5.5];
    sheet.text(at, &format!("{stem_cm:.0} cm"), &LABEL, Align::Center);
    let words = language.pick(
        "裏の芯を先へ引いて取る",
        "pull the midrib off the back, towards the tip",
    );
    let at = [slit.x + 8.0, rect.y + rect.height - 2.0];
    sheet.text(at, words, &LABEL, Align::Left);
}

fn draw_leaves_on_cord(canvas: &mut Canvas<'_>, left: Point, gap_cm: f64) {
    let (rect, language) = (canvas.rect, canvas.language);
    let sheet = &mut *canvas.sheet;
    let (upper, lower) = (rect.y + 7.0, rect.y + 18.0);
    let foot = rect.y + rect.height - 1.0;
    let places: Vec<f64> = (0..7_u32)
        .map(|leaf| left.x + 12.0 + 9.0 * f64::from(leaf))
        .collect();
    for &x in &places {
        let hung = leaf(
            Point::new(x, lower - 1.0),
            Vec2::new(0.0, 1.0),
            [foot - lower + 6.0, 8.0],
        );
        let clip = crate::pdf::Rect {
            x: x - 6.0,
            y: rect.y,
            width: 12.0,
            height: rect.height,
        };
        sheet.items.push(crate::pdf::Item::Group {
            page_from_group: kurbo::Affine::IDENTITY,
            clip: Some(clip),
            items: std::sync::Arc::new(vec![crate::pdf::Item::Path {
                path: hung,
                fill: Some(LEAF),
                stroke: Some(EDGE),
            }]),
        });
    }
    braid(sheet, Point::new(left.x, upper), 82.0, [1.5, 10.0, 1.3]);
    for &x in &places {
        // Each stem comes over the braid to the front and lies along its own leaf.
        let mut stem = BezPath::new();
        stem.move_to((x - 1.0, lower + 3.0));
        stem.line_to((x - 1.0, upper));
        stem.curve_to(
            (x - 1.0, upper - 4.0),
            (x + 1.2, upper - 4.0),
            (x + 1.2, upper),
        );
        stem.line_to((x + 1.2, lower + 3.0));
        sheet.path(
            stem,
            None,
            Some(Stroke::solid(0.9).with_color(Color(84, 120, 60))),
        );
    }
    // The lower cord goes around both parts of each stem.
    for pair in places.windows(2) {
        let mut way = BezPath::new();
        way.move_to((pair[0] + 2.4, lower + 1.2));
        way.line_to((pair[1] - 2.4, lower - 1.2));
        sheet.path(way, None, Some(Stroke::solid(1.0).with_color(SEWN)));
    }
    for &x in &places {
        sheet.line(
            [x - 2.4, lower - 1.2],
            [x + 2.4, lower + 1.2],
            Stroke::solid(1.0).with_color(SEWN),
        );
    }
    let aside = left.x + 86.0;
    name_cords(sheet, [aside, upper, lower, foot], gap_cm, language);
}

/// What the cords are, and how far they are from each other.
fn name_cords(
    sheet: &mut Sheet,
    [aside, upper, lower, foot]: [f64; 4],
    gap_cm: f64,
    language: Language,
) {
    let ends = [Point::new(aside, upper), Point::new(aside, lower)];
    arrow(sheet, ends, &Stroke::solid(0.25));
    let pick = |japanese: &'static str, english: &'static str| language.pick(japanese, english);
    let gap = format!("{gap_cm:.1} cm");
    for (y, text) in [
        (
            upper + 0.5,
            pick("三つ編み（上のひも）", "braid, the upper cord"),
        ),
        (0.5 * (upper + lower) + 1.6, gap.as_str()),
        (
            lower + 3.2,
            pick("下のひもをからめる", "the lower cord around each"),
        ),
        (foot - 4.0, pick("葉", "leaves")),
    ] {
        sheet.text([aside + 4.0, y], text, &LABEL, Align::Left);
    }
}
