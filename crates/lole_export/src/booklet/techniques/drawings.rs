//! The drawings of techniques: cloth with its right side light and its wrong side gray, thread in red.

use kurbo::{BezPath, Circle, Point, Shape as _};
use lole_geom::trig64;

use crate::booklet::style::{ACCENT, CLOTH, INSIDE, SEWN};
use crate::canvas::Canvas;
use crate::cutting::draw::arrow;
use crate::pdf::{Color, Rect, Stroke};

const EDGE: Stroke = Stroke::solid(0.3);
/// An elastic.
const ELASTIC: Color = Color(244, 244, 240);

/// A place in a drawing, shares of its width and height.
fn at(canvas: &Canvas<'_>, x: f64, y: f64) -> Point {
    let rect = canvas.rect;
    Point::new(rect.x + x * rect.width, rect.y + y * rect.height)
}

/// A line through places, shares of the drawing.
fn line(canvas: &Canvas<'_>, places: &[[f64; 2]]) -> BezPath {
    let mut path = BezPath::new();
    for (index, [x, y]) in places.iter().enumerate() {
        let place = at(canvas, *x, *y);
        if index == 0 {
            path.move_to(place);
        } else {
            path.line_to(place);
        }
    }
    path
}

/// A piece of cloth between corners, shares of the drawing.
fn cloth(canvas: &mut Canvas<'_>, corners: &[[f64; 2]], color: Color) {
    let mut path = line(canvas, corners);
    path.close_path();
    canvas.sheet.path(path, Some(color), Some(EDGE));
}

/// Thread through places, shares of the drawing.
fn thread(canvas: &mut Canvas<'_>, places: &[[f64; 2]]) {
    let path = line(canvas, places);
    let stroke = Stroke::solid(0.5).with_color(SEWN);
    canvas.sheet.path(path, None, Some(stroke));
}

/// A row of stitches between two places: so many, each of which covers a share of its way.
fn stitches(canvas: &mut Canvas<'_>, [from, to]: [[f64; 2]; 2], count: u32, long: f64) {
    let between = |share: f64| [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * share);
    for stitch in 0..count {
        let [begins, ends] = [0.0, long].map(|part| (f64::from(stitch) + part) / f64::from(count));
        thread(canvas, &[between(begins), between(ends)]);
    }
}

/// A zigzag along a level.
fn zigzag(canvas: &mut Canvas<'_>, [from, to]: [f64; 2], [top, bottom]: [f64; 2], count: u32) {
    let places: Vec<[f64; 2]> = (0..=count)
        .map(|index| {
            let x = from + (to - from) * f64::from(index) / f64::from(count);
            [x, if index % 2 == 0 { top } else { bottom }]
        })
        .collect();
    thread(canvas, &places);
}

/// An arrow of the hand.
fn hand(canvas: &mut Canvas<'_>, from: [f64; 2], to: [f64; 2]) {
    let [tail, head] = [from, to].map(|[x, y]| at(canvas, x, y));
    let mut path = BezPath::new();
    path.move_to(tail);
    path.line_to(head);
    let along = (head - tail) / (head - tail).hypot().max(1e-9);
    let side = kurbo::Vec2::new(-along.y, along.x);
    path.move_to(head - along * 2.4 + side * 1.1);
    path.line_to(head);
    path.line_to(head - along * 2.4 - side * 1.1);
    let stroke = Stroke::solid(0.7).with_color(ACCENT);
    canvas.sheet.path(path, None, Some(stroke));
}

/// A needle with its point towards the right.
fn needle(canvas: &mut Canvas<'_>, from: [f64; 2], to: [f64; 2]) {
    let [eye, tip] = [from, to].map(|[x, y]| at(canvas, x, y));
    let stroke = Stroke::solid(0.9).with_color(Color(96, 96, 104));
    canvas.sheet.line([eye.x, eye.y], [tip.x, tip.y], stroke);
}

/// A safety pin that lies level.
fn safety_pin(canvas: &mut Canvas<'_>, [x, y]: [f64; 2]) {
    let steel = Stroke::solid(0.6).with_color(Color(96, 96, 104));
    let middle = at(canvas, x, y);
    for rise in [-1.1, 1.1] {
        let [from, to] = [-6.0, 5.0].map(|aside| [middle.x + aside, middle.y + rise]);
        canvas.sheet.line(from, to, steel.clone());
    }
    let coil = Circle::new((middle.x - 6.0, middle.y), 1.1).to_path(0.01);
    canvas.sheet.path(coil, None, Some(steel.clone()));
    let cap = Rect {
        x: middle.x + 4.4,
        y: middle.y - 1.7,
        width: 2.6,
        height: 3.4,
    };
    canvas
        .sheet
        .rect(cap, Some(Color(180, 180, 186)), Some(steel));
}

pub(super) fn backstitch(canvas: &mut Canvas<'_>) {
    cloth(
        canvas,
        &[[0.0, 0.1], [1.0, 0.1], [1.0, 0.9], [0.0, 0.9]],
        CLOTH,
    );
    stitches(canvas, [[0.06, 0.5], [0.66, 0.5]], 6, 0.94);
    // It comes up one stitch ahead, and goes down where the last one ends.
    thread(canvas, &[[0.76, 0.5], [0.72, 0.36], [0.66, 0.5]]);
    needle(canvas, [0.66, 0.5], [0.92, 0.62]);
    hand(canvas, [0.76, 0.24], [0.67, 0.24]);
}

pub(super) fn dart(canvas: &mut Canvas<'_>) {
    // Folded, with the wrong side out: the fold is above.
    cloth(
        canvas,
        &[[0.04, 0.22], [0.96, 0.22], [0.96, 0.95], [0.04, 0.95]],
        INSIDE,
    );
    stitches(canvas, [[0.04, 0.62], [0.78, 0.23]], 16, 0.7);
    thread(canvas, &[[0.78, 0.23], [0.84, 0.14], [0.88, 0.08]]);
    thread(canvas, &[[0.78, 0.23], [0.87, 0.18], [0.94, 0.15]]);
    hand(canvas, [0.14, 0.42], [0.34, 0.315]);
}

pub(super) fn gathers(canvas: &mut Canvas<'_>) {
    cloth(
        canvas,
        &[[0.0, 0.16], [0.44, 0.16], [0.44, 0.92], [0.0, 0.92]],
        CLOTH,
    );
    for level in [0.27, 0.39] {
        stitches(canvas, [[0.02, level], [0.42, level]], 9, 0.6);
    }
    // What is drawn together is narrow at the top and full below.
    let folds = 9;
    let place = |index: u32, [left, right]: [f64; 2]| {
        left + (right - left) * f64::from(index) / f64::from(folds)
    };
    let top = (0..=folds).map(|index| {
        let deep = if index % 2 == 0 { 0.15 } else { 0.2 };
        [place(index, [0.64, 0.86]), deep]
    });
    let bottom = (0..=folds).rev().map(|index| {
        let deep = 0.9 + 0.03 * trig64::sin(3.0 * f64::from(index));
        [place(index, [0.55, 0.97]), deep]
    });
    let outline: Vec<[f64; 2]> = top.chain(bottom).collect();
    cloth(canvas, &outline, CLOTH);
    for index in 1..folds {
        let [from, to] = [
            at(canvas, place(index, [0.64, 0.86]), 0.42),
            at(canvas, place(index, [0.57, 0.95]), 0.78),
        ];
        canvas
            .sheet
            .line([from.x, from.y], [to.x, to.y], Stroke::solid(0.25));
    }
    for level in [0.27, 0.39] {
        thread(canvas, &[[0.63, level], [0.98, level]]);
    }
    hand(canvas, [0.88, 0.1], [1.0, 0.1]);
}

pub(super) fn pressed_open(canvas: &mut Canvas<'_>) {
    // The wrong side, with the seam in the middle and an allowance to either side.
    cloth(
        canvas,
        &[[0.0, 0.08], [1.0, 0.08], [1.0, 0.92], [0.0, 0.92]],
        INSIDE,
    );
    cloth(
        canvas,
        &[[0.3, 0.08], [0.5, 0.08], [0.5, 0.92], [0.3, 0.92]],
        CLOTH,
    );
    cloth(
        canvas,
        &[[0.5, 0.08], [0.7, 0.08], [0.7, 0.92], [0.5, 0.92]],
        CLOTH,
    );
    for [inner, outer] in [[0.33, 0.295], [0.67, 0.705]] {
        let places: Vec<[f64; 2]> = (0..=16)
            .map(|index| {
                let y = 0.1 + 0.05 * f64::from(index);
                [if index % 2 == 0 { inner } else { outer }, y]
            })
            .collect();
        thread(canvas, &places);
    }
    hand(canvas, [0.46, 0.5], [0.24, 0.5]);
    hand(canvas, [0.54, 0.5], [0.76, 0.5]);
}

pub(super) fn clipped(canvas: &mut Canvas<'_>) {
    let (cx, cy) = (0.5, -0.55);
    let curve = |turn: f64, radius: f64| {
        let (sin, cos) = trig64::sin_cos(turn);
        // Even on the page, whose drawing is wider than high.
        [cx + 0.55 * radius * cos, cy + radius * sin]
    };
    let turns: Vec<f64> = (0..=24)
        .map(|index| 0.42 + 0.096 * f64::from(index))
        .collect();
    let mut outline: Vec<[f64; 2]> = turns.iter().map(|&turn| curve(turn, 0.8)).collect();
    outline.extend(turns.iter().rev().map(|&turn| curve(turn, 1.42)));
    cloth(canvas, &outline, INSIDE);
    let seam: Vec<[f64; 2]> = turns.iter().map(|&turn| curve(turn, 1.02)).collect();
    for pair in seam.windows(2) {
        stitches(canvas, [pair[0], pair[1]], 2, 0.6);
    }
    for index in 1..8 {
        let turn = 0.42 + 0.288 * f64::from(index);
        let [from, to] = [0.8, 0.97].map(|radius| {
            let [x, y] = curve(turn, radius);
            at(canvas, x, y)
        });
        canvas
            .sheet
            .line([from.x, from.y], [to.x, to.y], Stroke::solid(0.8));
    }
}

pub(super) fn bound(canvas: &mut Canvas<'_>) {
    // In section: the cloth from the left, the strip around its edge.
    cloth(
        canvas,
        &[[0.0, 0.44], [0.8, 0.44], [0.8, 0.54], [0.0, 0.54]],
        CLOTH,
    );
    let strip = Stroke::solid(2.0).with_color(Color(206, 178, 128));
    let places = [
        [0.56, 0.62],
        [0.5, 0.7],
        [0.8, 0.7],
        [0.92, 0.5],
        [0.8, 0.3],
        [0.5, 0.3],
        [0.62, 0.38],
    ];
    let path = line(canvas, &places);
    canvas.sheet.path(path, None, Some(strip));
    thread(canvas, &[[0.64, 0.24], [0.64, 0.56]]);
    thread(canvas, &[[0.52, 0.74], [0.52, 0.5]]);
    hand(canvas, [0.98, 0.24], [0.98, 0.76]);
}

pub(super) fn hem(canvas: &mut Canvas<'_>) {
    // The wrong side, with its lower edge folded twice.
    cloth(
        canvas,
        &[[0.0, 0.06], [1.0, 0.06], [1.0, 0.94], [0.0, 0.94]],
        INSIDE,
    );
    cloth(
        canvas,
        &[[0.0, 0.56], [1.0, 0.56], [1.0, 0.94], [0.0, 0.94]],
        CLOTH,
    );
    // What lies inside of the fold.
    let hidden = Stroke::dashed(0.3, 1.2);
    let [from, to] = [at(canvas, 0.0, 0.86), at(canvas, 1.0, 0.86)];
    canvas.sheet.line([from.x, from.y], [to.x, to.y], hidden);
    stitches(canvas, [[0.03, 0.61], [0.48, 0.61]], 9, 0.65);
    // Slanting stitches that catch the cloth above.
    for index in 0..5_u32 {
        let x = 0.54 + 0.09 * f64::from(index);
        thread(canvas, &[[x, 0.6], [x + 0.05, 0.52], [x + 0.06, 0.52]]);
    }
}

pub(super) fn threaded(canvas: &mut Canvas<'_>) {
    cloth(
        canvas,
        &[[0.0, 0.1], [1.0, 0.1], [1.0, 0.94], [0.0, 0.94]],
        CLOTH,
    );
    for level in [0.32, 0.68] {
        stitches(canvas, [[0.0, level], [1.0, level]], 22, 0.65);
    }
    cloth(
        canvas,
        &[[0.0, 0.4], [0.6, 0.4], [0.6, 0.6], [0.0, 0.6]],
        ELASTIC,
    );
    safety_pin(canvas, [0.62, 0.5]);
    hand(canvas, [0.78, 0.5], [0.94, 0.5]);
}

pub(super) fn joined(canvas: &mut Canvas<'_>) {
    cloth(
        canvas,
        &[[0.0, 0.34], [0.64, 0.34], [0.64, 0.62], [0.0, 0.62]],
        ELASTIC,
    );
    cloth(
        canvas,
        &[[0.36, 0.38], [1.0, 0.38], [1.0, 0.66], [0.36, 0.66]],
        ELASTIC,
    );
    for [top, bottom] in [[0.4, 0.47], [0.53, 0.6]] {
        zigzag(canvas, [0.4, 0.6], [top, bottom], 12);
    }
    thread(canvas, &[[0.39, 0.4], [0.39, 0.6]]);
    thread(canvas, &[[0.61, 0.4], [0.61, 0.6]]);
    let stroke = Stroke::solid(0.4).with_color(ACCENT);
    let ends = [at(canvas, 0.36, 0.78), at(canvas, 0.64, 0.78)];
    arrow(canvas.sheet, ends, &stroke);
}

pub(super) fn ladder(canvas: &mut Canvas<'_>) {
    cloth(
        canvas,
        &[[0.0, 0.06], [1.0, 0.06], [1.0, 0.42], [0.0, 0.42]],
        CLOTH,
    );
    cloth(
        canvas,
        &[[0.0, 0.58], [1.0, 0.58], [1.0, 0.94], [0.0, 0.94]],
        CLOTH,
    );
    let (up, down) = (0.39, 0.61);
    let mut places = vec![[0.06, down]];
    for index in 0..4_u32 {
        let x = 0.06 + 0.2 * f64::from(index);
        places.extend([[x, up], [x + 0.1, up], [x + 0.1, down], [x + 0.2, down]]);
    }
    thread(canvas, &places);
    needle(canvas, [0.8, 0.61], [0.98, 0.74]);
}
