//! Pieces of free shape for tests: a gore of a skirt, a front on the fold, a sleeve, a hollow one.
#![allow(
    dead_code,
    reason = "every test file takes the shapes that it needs, and none takes all"
)]

use kurbo::{CubicBez, PathSeg, Point, Vec2};
use lole_geom::Length;
use lole_language::words;
use lole_pattern::pattern::{Seam, SeamKind, SeamSide};
use lole_pattern::piece::{ClothRole, CutCount, Edge, Finish, Mark, Piece};
use lole_pattern::{Pattern, piece::LineKind};

fn at(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

fn cm(edge: Edge, centimeters: f64) -> Edge {
    edge.with_allowance(Length::from_cm(centimeters))
}

fn curve(id: &'static str, points: [(f64, f64); 4], finish: Finish) -> Edge {
    let [p0, p1, p2, p3] = points.map(Point::from);
    Edge {
        segments: vec![PathSeg::Cubic(CubicBez::new(p0, p1, p2, p3))],
        ..Edge::straight(id, p0, p3, finish)
    }
}

fn piece(id: &'static str, japanese: &'static str, edges: Vec<Edge>, cut: CutCount) -> Piece {
    Piece {
        id,
        name: words(japanese, id),
        edges,
        grain: Vec2::new(0.0, 1.0),
        marks: Vec::new(),
        cloth: ClothRole::Main,
        cut,
    }
}

/// A gore: `top` and `bottom` wide, `height` high [m], straight sides, hem of `hem_cm`.
pub(crate) fn gore(top: f64, bottom: f64, height: f64, hem_cm: f64) -> Piece {
    let [a, b] = [at(-0.5 * bottom, 0.0), at(0.5 * bottom, 0.0)];
    let [c, d] = [at(0.5 * top, height), at(-0.5 * top, height)];
    let edges = vec![
        cm(Edge::straight("hem", a, b, Finish::Hem), hem_cm),
        cm(Edge::straight("left_side", b, c, Finish::Seam), 1.5),
        cm(Edge::straight("waist", c, d, Finish::Seam), 1.0),
        cm(Edge::straight("right_side", d, a, Finish::Seam), 1.5),
    ];
    let mut gore = piece("gore", "まち", edges, CutCount::Alike(4));
    gore.marks.push(Mark::Notch {
        edge: 1,
        along: 0.2,
        is_double: false,
    });
    gore
}

/// The wearer's left half of a bodice front, its middle on the fold.
pub(crate) fn front() -> Piece {
    let edges = vec![
        cm(
            curve(
                "hem",
                [(0.0, 0.0), (0.08, 0.0), (0.16, 0.004), (0.24, 0.012)],
                Finish::Hem,
            ),
            3.0,
        ),
        cm(
            Edge::straight("side", at(0.24, 0.012), at(0.255, 0.30), Finish::Seam),
            1.5,
        ),
        cm(
            curve(
                "armhole",
                [(0.255, 0.30), (0.19, 0.30), (0.185, 0.38), (0.20, 0.47)],
                Finish::Seam,
            ),
            1.0,
        ),
        cm(
            Edge::straight("shoulder", at(0.20, 0.47), at(0.08, 0.51), Finish::Seam),
            1.5,
        ),
        cm(
            curve(
                "neck",
                [(0.08, 0.51), (0.075, 0.45), (0.05, 0.42), (0.0, 0.42)],
                Finish::Seam,
            ),
            1.0,
        ),
        Edge::straight("middle", at(0.0, 0.42), at(0.0, 0.0), Finish::Fold),
    ];
    let mut front = piece("front", "前身頃", edges, CutCount::Alike(1));
    front.marks.push(Mark::Notch {
        edge: 2,
        along: 0.1,
        is_double: false,
    });
    let mut dart = kurbo::BezPath::new();
    dart.move_to(at(0.247, 0.22));
    dart.line_to(at(0.14, 0.25));
    dart.line_to(at(0.248, 0.25));
    front.marks.push(Mark::Line {
        kind: LineKind::Dart,
        path: dart,
    });
    front.marks.push(Mark::Point {
        name: words("バストポイント", "bust point"),
        at: at(0.10, 0.26),
    });
    front
}

/// The left one of a pair of sleeves: its cap is hollow at both ends.
pub(crate) fn sleeve() -> Piece {
    let edges = vec![
        cm(
            Edge::straight("hem", at(-0.15, 0.0), at(0.15, 0.0), Finish::Hem),
            2.5,
        ),
        cm(
            Edge::straight("inner", at(0.15, 0.0), at(0.19, 0.12), Finish::Seam),
            1.0,
        ),
        cm(
            curve(
                "front_cap",
                [(0.19, 0.12), (0.10, 0.13), (0.09, 0.25), (0.01, 0.25)],
                Finish::Seam,
            ),
            1.0,
        ),
        cm(
            curve(
                "back_cap",
                [(0.01, 0.25), (-0.08, 0.25), (-0.09, 0.14), (-0.19, 0.12)],
                Finish::Seam,
            ),
            1.0,
        ),
        cm(
            Edge::straight("outer", at(-0.19, 0.12), at(-0.15, 0.0), Finish::Seam),
            1.0,
        ),
    ];
    let mut sleeve = piece("sleeve", "袖", edges, CutCount::Pairs(1));
    for (edge, along, is_double) in [(2, 0.08, false), (3, 0.12, true)] {
        sleeve.marks.push(Mark::Notch {
            edge,
            along,
            is_double,
        });
    }
    sleeve
}

/// A yoke whose neck is hollow, tighter than its wide allowance.
pub(crate) fn hollow() -> Piece {
    let edges = vec![
        cm(
            Edge::straight("base", at(-0.2, 0.0), at(0.2, 0.0), Finish::Seam),
            1.0,
        ),
        cm(
            Edge::straight("left", at(0.2, 0.0), at(0.2, 0.12), Finish::Seam),
            1.0,
        ),
        cm(
            Edge::straight("left_top", at(0.2, 0.12), at(0.03, 0.12), Finish::Raw),
            0.5,
        ),
        cm(
            curve(
                "neck",
                [(0.03, 0.12), (0.025, 0.05), (-0.025, 0.05), (-0.03, 0.12)],
                Finish::Seam,
            ),
            2.4,
        ),
        cm(
            Edge::straight("right_top", at(-0.03, 0.12), at(-0.2, 0.12), Finish::Raw),
            0.5,
        ),
        cm(
            Edge::straight("right", at(-0.2, 0.12), at(-0.2, 0.0), Finish::Seam),
            1.0,
        ),
    ];
    piece("yoke", "ヨーク", edges, CutCount::Alike(2))
}

/// A strip, upright rectangle of this size with 1 cm around it, its warp along its length.
pub(crate) fn strip(length: f64, height: f64) -> Piece {
    let corners = [
        at(0.0, 0.0),
        at(length, 0.0),
        at(length, height),
        at(0.0, height),
    ];
    let edges = (0..4).map(|index| {
        let ends = [corners[index], corners[(index + 1) % 4]];
        cm(Edge::straight("edge", ends[0], ends[1], Finish::Seam), 1.0)
    });
    Piece {
        grain: Vec2::new(1.0, 0.0),
        ..piece("strip", "帯", edges.collect(), CutCount::Alike(2))
    }
}

/// All of them as one garment that nobody wears.
pub(crate) fn pattern() -> Pattern {
    let side = |piece, copy, edge| SeamSide {
        piece,
        copy,
        edge,
        between: [0.0, 1.0],
    };
    Pattern {
        pieces: vec![
            gore(0.20, 0.34, 0.60, 4.0),
            front(),
            sleeve(),
            hollow(),
            strip(0.9, 0.06),
        ],
        seams: vec![Seam {
            flat: side(0, 0, 1),
            full: side(0, 1, 3),
            kind: SeamKind::Plain,
        }],
        drawn_in: Vec::new(),
        notions: Vec::new(),
        steps: Vec::new(),
        warnings: Vec::new(),
        finished: Vec::new(),
    }
}
