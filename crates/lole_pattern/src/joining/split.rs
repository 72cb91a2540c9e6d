//! A piece cut in two along a line of its grain: its edges, its marks, and the new edge that joins both.

use kurbo::{BezPath, Line, ParamCurve as _, ParamCurveArclen as _, PathEl, PathSeg, Point};
use lole_geom::Length;

use crate::Piece;
use crate::piece::{CutCount, Edge, Finish, Mark};

/// Cloth outside of a join [m].
pub(super) const ALLOWANCE: f64 = 0.01;
/// How exactly lengths along edges are taken [m].
const ACCURACY: f64 = 1.0e-6;
/// Marked curves are followed this closely [m].
const TOLERANCE: f64 = 1.0e-4;
/// What is shorter than this is left over by rounding [m].
const NOTHING: f64 = 1.0e-6;

/// A straight line across a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Across {
    /// At this `x`, upright.
    Upright(f64),
    /// At this `y`, level.
    Level(f64),
}

/// A stretch of an edge on one side of the line.
struct Run {
    edge: usize,
    /// Where it begins along its edge [m].
    start: f64,
    segments: Vec<PathSeg>,
    is_over: bool,
}

impl Across {
    /// How far over the line a point lies [m].
    fn over(self, point: Point) -> f64 {
        match self {
            Self::Upright(x) => point.x - x,
            Self::Level(y) => point.y - y,
        }
    }

    fn line(self) -> Line {
        /// Farther than any cloth reaches [m].
        const FAR: f64 = 1.0e3;
        match self {
            Self::Upright(x) => Line::new((x, -FAR), (x, FAR)),
            Self::Level(y) => Line::new((-FAR, y), (FAR, y)),
        }
    }

    /// The line as far as it lies within a piece.
    pub(super) fn within(self, piece: &Piece) -> Option<BezPath> {
        let [under, _] = split(piece, self)?;
        let join = under.edges.last()?;
        let mut path = BezPath::new();
        path.move_to(join.segments.first()?.start());
        path.line_to(join.segments.last()?.end());
        Some(path)
    }
}

/// The parts of a piece under and over a line, each with a last edge that joins it to the other; `None`
/// where the line does not cut the piece in exactly two.
pub(super) fn split(piece: &Piece, across: Across) -> Option<[Piece; 2]> {
    let mut runs = runs(piece, across);
    let changes = |runs: &[Run]| {
        let next = |index: usize| runs[(index + 1) % runs.len()].is_over;
        (0..runs.len())
            .filter(|&index| runs[index].is_over != next(index))
            .collect::<Vec<_>>()
    };
    let found = changes(&runs);
    let &[first, second] = found.as_slice() else {
        return None;
    };
    // From the first change on the runs of one side follow each other, and then those of the other.
    runs.rotate_left(first + 1);
    let (one, other) = runs.split_at(second - first);
    let parts = [one, other].map(|runs| part(piece, runs, across));
    let [one_part, other_part] = parts;
    let (one_part, other_part) = (one_part?, other_part?);
    Some(if one[0].is_over {
        [other_part, one_part]
    } else {
        [one_part, other_part]
    })
}

/// All edges of a piece, cut where they cross the line.
fn runs(piece: &Piece, across: Across) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for (index, edge) in piece.edges.iter().enumerate() {
        let mut along = 0.0;
        for segment in &edge.segments {
            let crossings = segment.intersect_line(across.line());
            let mut stops: Vec<f64> = crossings.iter().map(|one| one.segment_t).collect();
            stops.extend([0.0, 1.0]);
            stops.sort_by(f64::total_cmp);
            for pair in stops.windows(2) {
                let own = stretch(segment, [pair[0], pair[1]]);
                let long = own.arclen(ACCURACY);
                if long < NOTHING {
                    continue;
                }
                let is_over = 0.0 < across.over(own.eval(0.5));
                match runs.last_mut() {
                    Some(run) if run.edge == index && run.is_over == is_over => {
                        run.segments.push(own);
                    }
                    _ => runs.push(Run {
                        edge: index,
                        start: along,
                        segments: vec![own],
                        is_over,
                    }),
                }
                along += long;
            }
        }
    }
    runs
}

/// A stretch of a segment, whose ends stay where they are to the bit.
fn stretch(segment: &PathSeg, [from, to]: [f64; 2]) -> PathSeg {
    let mut own = segment.subsegment(from..to);
    let (start, end) = (segment.start(), segment.end());
    let [first, last] = match &mut own {
        PathSeg::Line(line) => [&mut line.p0, &mut line.p1],
        PathSeg::Quad(quad) => [&mut quad.p0, &mut quad.p2],
        PathSeg::Cubic(cubic) => [&mut cubic.p0, &mut cubic.p3],
    };
    if from <= 0.0 {
        *first = start;
    }
    if 1.0 <= to {
        *last = end;
    }
    own
}

/// The part that these runs go around; they follow each other and the join closes them.
fn part(piece: &Piece, runs: &[Run], across: Across) -> Option<Piece> {
    let start = runs.first()?.segments.first()?.start();
    let end = runs.last()?.segments.last()?.end();
    let mut edges: Vec<Edge> = (runs.iter())
        .map(|run| Edge {
            segments: run.segments.clone(),
            ..piece.edges[run.edge].clone()
        })
        .collect();
    let join = Edge::straight("join", end, start, Finish::Seam);
    edges.push(join.with_allowance(Length::from_m(ALLOWANCE)));
    let is_over = runs.first()?.is_over;
    let marks = (piece.marks.iter()).filter_map(|mark| match mark {
        Mark::Notch {
            edge,
            along,
            is_double,
        } => notch_on(runs, *edge, *along).map(|(edge, along)| Mark::Notch {
            edge,
            along,
            is_double: *is_double,
        }),
        Mark::Line { kind, path } => {
            let path = clipped(path, across, if is_over { 1.0 } else { -1.0 });
            (!path.elements().is_empty()).then_some(Mark::Line { kind: *kind, path })
        }
        Mark::Point { at, .. } => ((0.0 < across.over(*at)) == is_over).then(|| mark.clone()),
    });
    let marks = marks.collect();
    let had_fold = piece.edges.iter().any(|edge| edge.finish == Finish::Fold);
    let has_fold = edges.iter().any(|edge| edge.finish == Finish::Fold);
    Some(Piece {
        edges,
        marks,
        // What lies beside the middle is there on both sides of it.
        cut: match piece.cut {
            CutCount::Alike(count) if had_fold && !has_fold => CutCount::Pairs(count),
            cut => cut,
        },
        ..piece.clone()
    })
}

/// The run that a notch lies in, and how far from its beginning.
fn notch_on(runs: &[Run], edge: usize, along: f64) -> Option<(usize, f64)> {
    runs.iter().enumerate().find_map(|(index, run)| {
        let long: f64 = run.segments.iter().map(|one| one.arclen(ACCURACY)).sum();
        let own = along - run.start;
        let is_within = -NOTHING <= own && own <= long + NOTHING;
        (run.edge == edge && is_within).then(|| (index, own.clamp(0.0, long)))
    })
}

/// What of a marked line lies over the line, or under it where `sign` is negative.
fn clipped(path: &BezPath, across: Across, sign: f64) -> BezPath {
    let mut kept = BezPath::new();
    let mut last = Point::ZERO;
    let mut is_drawing = false;
    let mut stretch = |from: Point, to: Point, is_drawing: &mut bool| {
        if NOTHING < from.distance(to) {
            if !*is_drawing {
                kept.move_to(from);
            }
            kept.line_to(to);
            *is_drawing = true;
        }
    };
    kurbo::flatten(
        path.elements().iter().copied(),
        TOLERANCE,
        |element| match element {
            PathEl::MoveTo(point) => {
                last = point;
                is_drawing = false;
            }
            PathEl::LineTo(point) => {
                let [from, to] = [last, point].map(|point| sign * across.over(point));
                let middle = last.lerp(point, (from / (from - to)).clamp(0.0, 1.0));
                match (0.0 <= from, 0.0 <= to) {
                    (true, true) => stretch(last, point, &mut is_drawing),
                    (true, false) => {
                        stretch(last, middle, &mut is_drawing);
                        is_drawing = false;
                    }
                    (false, true) => stretch(middle, point, &mut is_drawing),
                    (false, false) => is_drawing = false,
                }
                last = point;
            }
            _ => {}
        },
    );
    kept
}

#[cfg(test)]
mod tests {
    use kurbo::Shape as _;
    use lole_language::words;

    use super::*;
    use crate::piece::{ClothRole, LineKind};

    fn rectangle() -> Piece {
        let [a, b, c, d] = [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (0.0, 1.0)].map(Point::from);
        let mut line = BezPath::new();
        line.move_to((0.0, 0.5));
        line.line_to((4.0, 0.5));
        Piece {
            id: "cloth",
            name: words("布", "cloth"),
            edges: vec![
                Edge::straight("hem", a, b, Finish::Hem),
                Edge::straight("left", b, c, Finish::Seam),
                Edge::straight("top", c, d, Finish::Seam),
                Edge::straight("right", d, a, Finish::Seam),
            ],
            grain: (1.0, 0.0).into(),
            marks: vec![
                Mark::Line {
                    kind: LineKind::Placement,
                    path: line,
                },
                Mark::Notch {
                    edge: 2,
                    along: 1.0,
                    is_double: false,
                },
            ],
            cloth: ClothRole::Main,
            cut: CutCount::Alike(1),
        }
    }

    #[test]
    fn parts_have_the_area_the_marks_and_the_edges_of_the_whole() {
        for across in [Across::Upright(1.25), Across::Level(0.75)] {
            let whole = rectangle();
            let parts = split(&whole, across).unwrap_or_else(|| panic!("{across:?}"));
            let area = |piece: &Piece| piece.stitching_polygon(1e-4).signed_area();
            assert!((area(&parts[0]) + area(&parts[1]) - 4.0).abs() < 1e-9);
            let notches = |piece: &Piece| {
                let marks = piece.marks.iter();
                marks
                    .filter(|mark| matches!(mark, Mark::Notch { .. }))
                    .count()
            };
            assert_eq!(notches(&parts[0]) + notches(&parts[1]), 1);
            let long: f64 = (parts.iter().flat_map(|part| &part.marks))
                .filter_map(|mark| match mark {
                    Mark::Line { path, .. } => Some(path.perimeter(1e-6)),
                    _ => None,
                })
                .sum();
            assert!((long - 4.0).abs() < 1e-9, "{long}");
            let joins = parts.map(|part| part.edges.last().map_or(0.0, Edge::length));
            assert!((joins[0] - joins[1]).abs() < 1e-12);
        }
    }

    #[test]
    fn a_line_beside_a_piece_cuts_nothing() {
        assert!(split(&rectangle(), Across::Upright(4.5)).is_none());
    }
}
