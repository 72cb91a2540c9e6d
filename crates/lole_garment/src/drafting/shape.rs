//! Lines, curves and pieces as a drafter draws them, in meters.

use kurbo::{
    BezPath, CubicBez, Line, ParamCurve as _, ParamCurveArclen as _, PathSeg, Point, Vec2,
};
use lole_geom::Length;
use lole_language::Words;

use lole_pattern::piece::{ClothRole, CutCount, Edge, Finish, LineKind, Mark, Piece};

/// One centimeter [m]: drafting rules are written in centimeters.
pub(crate) const CM: f64 = 0.01;

/// How exactly lengths of curves are taken [m].
const ACCURACY: f64 = 1.0e-7;

pub(crate) const fn at(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

pub(crate) fn line(from: Point, to: Point) -> PathSeg {
    PathSeg::Line(Line::new(from, to))
}

/// A curve that leaves `from` along `out` and comes to `to` along `into`; the vectors' lengths are the
/// handles'.
pub(crate) fn curve(from: Point, out: Vec2, into: Vec2, to: Point) -> PathSeg {
    PathSeg::Cubic(CubicBez::new(from, from + out, to - into, to))
}

/// Length of a way [m].
pub(crate) fn length(segments: &[PathSeg]) -> f64 {
    segments.iter().map(|one| one.arclen(ACCURACY)).sum()
}

/// The point of a way at a distance from its beginning [m]; its end where it is shorter.
pub(crate) fn point_along(segments: &[PathSeg], distance: f64) -> Point {
    let mut left = distance;
    for segment in segments {
        let own = segment.arclen(ACCURACY);
        if left <= own {
            return segment.eval(segment.inv_arclen(left.max(0.0), ACCURACY));
        }
        left -= own;
    }
    segments.last().map_or(Point::ZERO, PathSeg::end)
}

/// An edge along a way.
pub(crate) fn edge(id: &'static str, way: Vec<PathSeg>, finish: Finish, allowance: f64) -> Edge {
    Edge {
        id,
        segments: way,
        allowance: Length::from_m(allowance),
        finish,
    }
}

/// What a piece is called and cut from.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Label {
    pub(crate) id: &'static str,
    pub(crate) name: Words,
    pub(crate) cloth: ClothRole,
    pub(crate) cut: CutCount,
}

impl Label {
    pub(crate) const fn main(id: &'static str, name: Words, cut: CutCount) -> Self {
        Self {
            id,
            name,
            cloth: ClothRole::Main,
            cut,
        }
    }

    /// The piece with these edges, its warp along `grain`.
    pub(crate) fn piece(self, mut edges: Vec<Edge>, grain: Vec2, marks: Vec<Mark>) -> Piece {
        join(&mut edges);
        Piece {
            id: self.id,
            name: self.name,
            edges,
            grain,
            marks,
            cloth: self.cloth,
            cut: self.cut,
        }
    }
}

/// Closes what rounding left between segments, so that each begins where the last one ended, to the bit.
fn join(edges: &mut [Edge]) {
    let last = edges.last().and_then(|edge| edge.segments.last());
    let Some(mut end) = last.map(PathSeg::end) else {
        return;
    };
    for segment in edges.iter_mut().flat_map(|edge| &mut edge.segments) {
        debug_assert!(
            segment.start().distance(end) < 1.0e-6,
            "{segment:?} {end:?}"
        );
        match segment {
            PathSeg::Line(line) => line.p0 = end,
            PathSeg::Quad(quad) => quad.p0 = end,
            PathSeg::Cubic(cubic) => cubic.p0 = end,
        }
        end = segment.end();
    }
}

/// Warp down the body.
pub(crate) const DOWN: Vec2 = Vec2::new(0.0, 1.0);
/// Warp around the body.
pub(crate) const AROUND: Vec2 = Vec2::new(1.0, 0.0);

/// An edge of a rectangle: its name, what becomes of it, its allowance [m].
pub(crate) type Side = (&'static str, Finish, f64);

/// A rectangle from the origin, its edges in the order lower, left of the wearer, upper, right.
pub(crate) fn rectangle(
    label: Label,
    [width, height]: [f64; 2],
    sides: [Side; 4],
    grain: Vec2,
) -> Piece {
    let corners = [
        at(0.0, 0.0),
        at(width, 0.0),
        at(width, height),
        at(0.0, height),
    ];
    let edges = (0..4)
        .map(|index| {
            let (id, finish, allowance) = sides[index];
            let way = vec![line(corners[index], corners[(index + 1) % 4])];
            edge(id, way, finish, allowance)
        })
        .collect();
    label.piece(edges, grain, Vec::new())
}

/// A marked line through points.
pub(crate) fn marked(kind: LineKind, points: &[Point]) -> Mark {
    let mut path = BezPath::new();
    for (index, &point) in points.iter().enumerate() {
        if index == 0 {
            path.move_to(point);
        } else {
            path.line_to(point);
        }
    }
    Mark::Line { kind, path }
}

/// A line straight across a piece.
pub(crate) fn across(kind: LineKind, y: f64, [from, to]: [f64; 2]) -> Mark {
    marked(kind, &[at(from, y), at(to, y)])
}

/// A line along an edge, moved to the inside by `inset` [m], between two distances along it.
pub(crate) fn beside(kind: LineKind, edge: &Edge, inset: f64, between: [f64; 2]) -> Mark {
    /// Points of the line: a curved edge of a hand's breadth is followed to a hair.
    const POINTS: u32 = 24;
    let points: Vec<Point> = (0..=POINTS)
        .map(|index| {
            let share = f64::from(index) / f64::from(POINTS);
            let distance = between[0] + (between[1] - between[0]) * share;
            let here = point_along(&edge.segments, distance);
            let total = edge.length();
            let step = 1.0e-4;
            let before = point_along(&edge.segments, (distance - step).max(0.0));
            let after = point_along(&edge.segments, (distance + step).min(total));
            let along = after - before;
            let inward = Vec2::new(-along.y, along.x) / along.hypot().max(1.0e-12);
            here + inward * inset
        })
        .collect();
    marked(kind, &points)
}

/// A notch.
pub(crate) const fn notch(edge: usize, along: f64) -> Mark {
    Mark::Notch {
        edge,
        along,
        is_double: false,
    }
}

/// A double notch, as on backs.
pub(crate) const fn back_notch(edge: usize, along: f64) -> Mark {
    Mark::Notch {
        edge,
        along,
        is_double: true,
    }
}
