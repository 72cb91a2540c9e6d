//! The cut line: the stitching line moved outward by each edge's own allowance.
//!
//! Where two allowances meet, their cut lines are run on until they cross. At a hem they are not: its
//! allowance is folded up and has to lie flat on the cloth beside the side seam, so the side's cut
//! line goes on below the hem as its own mirror image.
//!
//! ```text
//!       │ side         \ side
//!       │               \
//!  ─────┤ hem      ──────\ hem
//!       │               /
//!   ────┘ cut      ────/ cut
//! ```

use kurbo::{ParamCurve as _, ParamCurveDeriv as _, PathSeg, Point, Vec2};

use super::unfold::reflection;
use super::{Edge, Finish, Piece};
use crate::polygon::{Polygon, SAME_POINT, crossing_parts};

/// A point of two cut lines is cut off where it would stick out farther than this, over the larger
/// allowance: nobody wants a thorn of cloth in a seam.
const MITER_LIMIT: f64 = 3.0;

/// A corner inside an edge turns this much at most before its miter is cut off: `1 / cos 76°`.
const BEND_LIMIT: f64 = 4.0;

impl Edge {
    /// The stitching line as points, nowhere farther than `tolerance` [m] from the curve.
    #[must_use]
    pub fn points(&self, tolerance: f64) -> Vec<Point> {
        let path = kurbo::BezPath::from_path_segments(self.segments.iter().copied());
        let mut points: Vec<Point> = Vec::new();
        kurbo::flatten(path, tolerance, |element| {
            if let kurbo::PathEl::MoveTo(point) | kurbo::PathEl::LineTo(point) = element
                && (points.last()).is_none_or(|last| SAME_POINT < last.distance(point))
            {
                points.push(point);
            }
        });
        points
    }
}

impl Piece {
    /// The stitching line as a polygon, nowhere farther than `tolerance` [m] from its curves.
    #[must_use]
    pub fn stitching_polygon(&self, tolerance: f64) -> Polygon {
        let edges = self.edges.iter();
        Polygon::new(edges.flat_map(|edge| edge.points(tolerance)))
    }

    /// The line to cut along, counterclockwise, nowhere farther than about `tolerance` [m] from the
    /// exact one.
    #[must_use]
    pub fn cut_polygon(&self, tolerance: f64) -> Polygon {
        let edges: Vec<&Edge> = (self.edges.iter())
            .filter(|edge| SAME_POINT < edge.length())
            .collect();
        let mut lines: Vec<Vec<Point>> = (edges.iter())
            .map(|edge| offset(&edge.points(tolerance), edge))
            .collect();
        let count = edges.len();
        if let ([edge], [line]) = (&edges[..], &mut lines[..]) {
            meet_itself(edge, line);
            return without_loops(Polygon::new(lines.concat())).without_straight_corners();
        }
        for index in 0..count {
            let next = (index + 1) % count;
            let mut before = std::mem::take(&mut lines[index]);
            let mut after = std::mem::take(&mut lines[next]);
            meet([edges[index], edges[next]], &mut before, &mut after);
            lines[index] = before;
            lines[next] = after;
        }
        without_loops(Polygon::new(lines.concat())).without_straight_corners()
    }
}

/// The points of an edge moved outward by its allowance, bends mitered.
fn offset(points: &[Point], edge: &Edge) -> Vec<Point> {
    let distance = edge.allowance.to_m();
    let right = |along: Vec2| Vec2::new(along.y, -along.x);
    let sides: Vec<Vec2> = (points.windows(2))
        .map(|pair| right((pair[1] - pair[0]).normalize()))
        .collect();
    let last = points.len() - 1;
    (points.iter().enumerate())
        .map(|(index, point)| {
            // The first chord of a curve leaves its corner in another direction than the curve does,
            // and with it the corner of the cut line would move.
            if index == 0 || index == last {
                let along = edge.direction_at(if index == 0 { End::First } else { End::Last });
                return *point + right(along) * distance;
            }
            let sum = sides[index - 1] + sides[index];
            // |sum| is twice the cosine of half the bend.
            let scale = (2.0 / sum.hypot2().max(1e-12)).min(0.5 * BEND_LIMIT * BEND_LIMIT);
            *point + sum * scale * distance
        })
        .collect()
}

/// One end of an edge.
#[derive(Debug, Clone, Copy)]
enum End {
    First,
    Last,
}

impl Edge {
    /// Unit direction of the stitching line at one of its ends.
    fn direction_at(&self, end: End) -> Vec2 {
        let (segment, part) = match end {
            End::First => (self.segments.first(), 0.0),
            End::Last => (self.segments.last(), 1.0),
        };
        segment.map_or(Vec2::ZERO, |segment| tangent(segment, part))
    }
}

/// Unit direction of a segment at a parameter.
pub(super) fn tangent(segment: &PathSeg, part: f64) -> Vec2 {
    let along = match segment {
        PathSeg::Line(line) => line.p1 - line.p0,
        PathSeg::Quad(quad) => quad.deriv().eval(part).to_vec2(),
        PathSeg::Cubic(cubic) => cubic.deriv().eval(part).to_vec2(),
    };
    if SAME_POINT < along.hypot() {
        return along.normalize();
    }
    // A control point on the end of its curve: a thousandth further the direction is there.
    let inside = part + if part < 0.5 { 1.0e-3 } else { -1.0e-3 };
    let along = (segment.eval(inside) - segment.eval(part)) * (inside - part).signum();
    along / along.hypot().max(f64::MIN_POSITIVE)
}

/// Makes the cut line of one edge end where that of the next one begins.
fn meet(edges: [&Edge; 2], before: &mut Vec<Point>, after: &mut Vec<Point>) {
    let (Some(last), Some(first), Some(corner)) = (
        before.last().copied(),
        after.first().copied(),
        corner(edges[1]),
    ) else {
        return;
    };
    if last.distance(first) <= SAME_POINT {
        return;
    }
    let directions = [
        edges[0].direction_at(End::Last),
        edges[1].direction_at(End::First),
    ];
    before.push(last + directions[0] * RUN_ON);
    after.insert(0, first - directions[1] * RUN_ON);
    let is_hem = edges.map(|edge| edge.finish == Finish::Hem && 0.0 < edge.allowance.to_m());
    let is_side =
        edges.map(|edge| matches!(edge.finish, Finish::Seam | Finish::Raw | Finish::Selvage));
    let allowances = edges.map(|edge| edge.allowance.to_m());
    if is_side[0] && is_hem[1] {
        fold_over(before, [corner, corner + directions[1]], allowances[1]);
    } else if is_hem[0] && is_side[1] {
        // The same seen from the other side.
        after.reverse();
        fold_over(after, [corner, corner + directions[0]], allowances[0]);
        after.reverse();
    }
    if join(before, after, corner, allowances[0].max(allowances[1])).is_none() {
        // They go on side by side: a step leads from one allowance to the other.
        before.pop();
        after.remove(0);
    }
}

/// Makes the cut line of an edge that goes all around end where it begins.
fn meet_itself(edge: &Edge, line: &mut Vec<Point>) {
    let middle = line.len() / 2;
    let mut before = line.split_off(middle);
    // Both parts keep the point between them, so that each has a direction.
    line.extend(before.first().copied());
    meet([edge, edge], &mut before, line);
    line.pop();
    line.append(&mut before);
}

/// A cut line is run on at its ends this far [m], for its direction.
const RUN_ON: f64 = 1.0e-4;

/// Where an edge begins on the stitching line.
fn corner(edge: &Edge) -> Option<Point> {
    edge.segments.first().map(PathSeg::start)
}

/// Ends a side's cut line at the line of the hem and runs its mirror image on below it, to the depth
/// of the hem [m].
fn fold_over(side: &mut Vec<Point>, hem_line: [Point; 2], depth: f64) {
    let normal = (hem_line[1] - hem_line[0]).turn_90();
    // The side comes from the cloth, on one side of the hem line, and its allowance may have carried
    // it beyond.
    let height = |point: Point| (point - hem_line[0]).dot(normal);
    let Some(first) = side.first().map(|point| height(*point)) else {
        return;
    };
    let sign = if first < 0.0 { -1.0 } else { 1.0 };
    while 2 < side.len() && sign * height(side[side.len() - 2]) <= SAME_POINT {
        side.pop();
    }
    let [.., before_last, last] = side.as_slice() else {
        return;
    };
    let Some([part, _]) = crossing_parts([*before_last, *last], hem_line) else {
        return;
    };
    let fold = before_last.lerp(*last, part);
    side.pop();
    side.push(fold);
    let mirror = reflection(hem_line);
    let mut folded = Vec::new();
    for pair in side.windows(2).rev() {
        let [upper, lower] = [pair[0], pair[1]];
        let [top, bottom] = [upper, lower].map(|point| sign * height(point));
        if depth <= top {
            folded.push(mirror * lower.lerp(upper, (depth - bottom) / (top - bottom)));
            break;
        }
        folded.push(mirror * upper);
    }
    side.append(&mut folded);
}

/// Runs two lines on until they cross, or cuts them off where they cross already; `None` where they do
/// not cross.
fn join(
    before: &mut Vec<Point>,
    after: &mut Vec<Point>,
    corner: Point,
    allowance: f64,
) -> Option<()> {
    let found = nearest_crossing(before, after)?;
    let limit = MITER_LIMIT * allowance;
    let is_thorn = found.is_outside && SAME_POINT < limit && limit < found.at.distance(corner);
    if is_thorn {
        let (last, first) = (*before.last()?, *after.first()?);
        before.push(last + (found.at - last).normalize() * allowance);
        after.insert(0, first + (found.at - first).normalize() * allowance);
        return Some(());
    }
    before.truncate(found.sides[0] + 1);
    before.push(found.at);
    after.drain(..=found.sides[1]);
    after.insert(0, found.at);
    Some(())
}

/// Where two lines that follow each other cross.
struct Meeting {
    /// Index of the side of each.
    sides: [usize; 2],
    at: Point,
    /// Beyond the ends of both.
    is_outside: bool,
}

/// The crossing that cuts off least, the last side of the one and the first of the other running on
/// without end.
fn nearest_crossing(before: &[Point], after: &[Point]) -> Option<Meeting> {
    let mut best: Option<(f64, Meeting)> = None;
    let last = before.len().checked_sub(2)?;
    let lengths = |points: &[Point]| -> Vec<f64> {
        (points.windows(2))
            .map(|pair| pair[0].distance(pair[1]))
            .collect()
    };
    let (before_lengths, after_lengths) = (lengths(before), lengths(after));
    let mut cut_before = 0.0;
    for first_side in (0..=last).rev() {
        let mut cut_after = 0.0;
        for (second_side, pair) in after.windows(2).enumerate() {
            let one = [before[first_side], before[first_side + 1]];
            let parts = crossing_parts(one, [pair[0], pair[1]]);
            if let Some([s, t]) = parts
                && 0.0 <= s
                && (s <= 1.0 || first_side == last)
                && t <= 1.0
                && (0.0 <= t || second_side == 0)
            {
                let cut = cut_before
                    + (1.0 - s).max(0.0) * before_lengths[first_side]
                    + cut_after
                    + t.max(0.0) * after_lengths[second_side];
                if best.as_ref().is_none_or(|(least, _)| cut < *least) {
                    let meeting = Meeting {
                        sides: [first_side, second_side],
                        at: one[0].lerp(one[1], s),
                        is_outside: 1.0 < s && t < 0.0,
                    };
                    best = Some((cut, meeting));
                }
            }
            cut_after += after_lengths[second_side];
        }
        cut_before += before_lengths[first_side];
    }
    best.map(|(_, meeting)| meeting)
}

/// Without the small loops that an allowance makes where the stitching line is hollow and its curve
/// tighter than the allowance is wide: they run the wrong way around.
fn without_loops(mut polygon: Polygon) -> Polygon {
    while let Some(crossing) = polygon.first_crossing() {
        let [first, second] = crossing.sides;
        let inner = polygon.points[first + 1..=second].iter().copied();
        let inner = Polygon::new(inner.chain([crossing.at]));
        let ahead = polygon.points[..=first].iter().copied();
        let behind = polygon.points[second + 1..].iter().copied();
        let outer = Polygon::new(ahead.chain([crossing.at]).chain(behind));
        polygon = if inner.signed_area() < outer.signed_area() {
            outer
        } else {
            inner
        };
    }
    polygon
}
