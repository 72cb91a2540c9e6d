//! A piece as it is drawn, whatever the file: polygons and lines in the piece's plane.

use kurbo::{ParamCurve as _, ParamCurveArclen as _, Point, Vec2};
use lole_geom::Length;
use lole_language::Words;

use super::cut_line::tangent;
use super::{Edge, Finish, LineKind, Mark, Piece};
use crate::polygon::{Polygon, SAME_POINT, crossing_parts};

/// A piece as it is drawn. All in meters.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    /// The line to cut along, counterclockwise.
    pub cut: Polygon,
    /// The stitching line, edge by edge.
    pub stitches: Vec<DrawnStitches>,
    /// Lines to crease, stitch or gather along.
    pub lines: Vec<DrawnLine>,
    /// Short cuts into the allowance.
    pub notches: Vec<DrawnNotch>,
    /// Points to mark.
    pub points: Vec<(Words, Point)>,
    /// The arrow along the warp, inside the piece.
    pub grain: [Point; 2],
    /// Where a label has the most room.
    pub label: Point,
    /// Radius of the largest circle around the label inside the piece.
    pub label_room: f64,
    /// Width along `x` and height along `y` of a piece that is cut as an upright rectangle: it needs
    /// no paper, only a ruler.
    pub rectangle: Option<[Length; 2]>,
}

/// The stitching line of one edge.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnStitches {
    /// Along the edge.
    pub points: Vec<Point>,
    /// What becomes of the edge.
    pub finish: Finish,
    /// Cloth outside of it.
    pub allowance: Length,
}

/// A marked line.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnLine {
    /// What it is for.
    pub kind: LineKind,
    /// Along it.
    pub points: Vec<Point>,
}

/// A notch on the cut line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawnNotch {
    /// On the cut line.
    pub at: Point,
    /// Into the cloth, unit length.
    pub inward: Vec2,
    /// Cut twice side by side.
    pub is_double: bool,
}

/// The grain arrow spans this part of the piece.
const ARROW_PART: f64 = 0.6;

impl Piece {
    /// The piece as it is drawn; lines stay within `tolerance` [m] of their curves.
    #[must_use]
    pub fn drawing(&self, tolerance: f64) -> Drawing {
        let cut = self.cut_polygon(tolerance);
        let (label, label_room) = cut.roomiest_point();
        let stitches = self.edges.iter().map(|edge| DrawnStitches {
            points: edge.points(tolerance),
            finish: edge.finish,
            allowance: edge.allowance,
        });
        let lines = self.marks.iter().flat_map(|mark| match mark {
            Mark::Line { kind, path } => lines(*kind, path, tolerance),
            _ => Vec::new(),
        });
        let notches = self.marks.iter().filter_map(|mark| match mark {
            Mark::Notch {
                edge,
                along,
                is_double,
            } => {
                let (at, outward) = self.edges.get(*edge)?.place(*along)?;
                Some(DrawnNotch {
                    at: at + outward * way_out(&cut, at, outward),
                    inward: -outward,
                    is_double: *is_double,
                })
            }
            _ => None,
        });
        let points = self.marks.iter().filter_map(|mark| match mark {
            Mark::Point { name, at } => Some((*name, *at)),
            _ => None,
        });
        Drawing {
            stitches: stitches.collect(),
            lines: lines.collect(),
            notches: notches.collect(),
            points: points.collect(),
            grain: arrow(&cut, label, self.grain),
            label,
            label_room,
            rectangle: rectangle(&cut),
            cut,
        }
    }
}

impl Piece {
    /// Width along `x` and height along `y` of a piece that is cut as an upright rectangle, its curves lines within
    /// `tolerance` [m]: [`Drawing::rectangle`] without the rest of the drawing, which takes far longer.
    #[must_use]
    pub fn rectangle(&self, tolerance: f64) -> Option<[Length; 2]> {
        rectangle(&self.cut_polygon(tolerance))
    }
}

impl Edge {
    /// The point at a distance [m] from the beginning along the stitching line, and the direction out
    /// of the cloth there; `None` for an edge without segments.
    #[must_use]
    pub fn place(&self, along: f64) -> Option<(Point, Vec2)> {
        let mut left = along.max(0.0);
        let last = self.segments.len().checked_sub(1)?;
        for (index, segment) in self.segments.iter().enumerate() {
            let length = segment.arclen(PLACE_ACCURACY);
            if left <= length || index == last {
                let part = segment.inv_arclen(left.min(length), PLACE_ACCURACY);
                let along = tangent(segment, part);
                return Some((segment.eval(part), Vec2::new(along.y, -along.x)));
            }
            left -= length;
        }
        None
    }
}

/// A hundredth of a millimeter [m], as [`Edge::length`] is.
const PLACE_ACCURACY: f64 = 1.0e-5;

/// A marked path as lines, one for each of its stretches.
fn lines(kind: LineKind, path: &kurbo::BezPath, tolerance: f64) -> Vec<DrawnLine> {
    let mut lines: Vec<DrawnLine> = Vec::new();
    kurbo::flatten(path, tolerance, |element| match element {
        kurbo::PathEl::MoveTo(point) => lines.push(DrawnLine {
            kind,
            points: vec![point],
        }),
        kurbo::PathEl::LineTo(point) => {
            if let Some(line) = lines.last_mut() {
                line.points.push(point);
            }
        }
        kurbo::PathEl::ClosePath => {
            if let Some(line) = lines.last_mut()
                && let Some(first) = line.points.first().copied()
            {
                line.points.push(first);
            }
        }
        kurbo::PathEl::QuadTo(..) | kurbo::PathEl::CurveTo(..) => {}
    });
    lines.retain(|line| 1 < line.points.len());
    lines
}

/// From a point to where a ray first leaves the polygon [m]; nothing where it never does.
fn way_out(polygon: &Polygon, from: Point, direction: Vec2) -> f64 {
    let ray = [from, from + direction];
    let ways = polygon.sides().filter_map(|side| {
        let [way, part] = crossing_parts(ray, side)?;
        let is_ahead = -SAME_POINT <= way && (-1e-9..=1.0 + 1e-9).contains(&part);
        is_ahead.then_some(way.max(0.0))
    });
    let nearest = ways.fold(f64::INFINITY, f64::min);
    if nearest.is_finite() { nearest } else { 0.0 }
}

/// The middle part of the line through the label along the grain.
fn arrow(cut: &Polygon, label: Point, grain: Vec2) -> [Point; 2] {
    let ahead = way_out(cut, label, grain);
    let behind = way_out(cut, label, -grain);
    let middle = label + grain * (0.5 * (ahead - behind));
    let half = grain * (0.5 * ARROW_PART * (ahead + behind));
    [middle - half, middle + half]
}

/// Size of an upright rectangle.
fn rectangle(cut: &Polygon) -> Option<[Length; 2]> {
    let bounds = cut.bounds();
    let corners = [
        (bounds.x0, bounds.y0),
        (bounds.x1, bounds.y0),
        (bounds.x1, bounds.y1),
        (bounds.x0, bounds.y1),
    ];
    let is_corner =
        |point: &Point| (corners.iter()).any(|corner| point.distance(Point::from(*corner)) < RULER);
    let is_rectangle = cut.points.len() == 4 && cut.points.iter().all(is_corner);
    is_rectangle.then(|| [bounds.width(), bounds.height()].map(Length::from_m))
}

/// What nobody sees beside a ruler [m].
const RULER: f64 = 1.0e-4;
