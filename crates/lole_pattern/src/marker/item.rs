//! What is laid on the cloth: every copy of every piece, and how it may lie.

use kurbo::{Affine, Point, Vec2};
use lole_geom::trig64;

use super::{Border, Lay, MarkerWarning, Nap, TableCloth};
use crate::Piece;
use crate::piece::{CutCount, Finish};
use crate::polygon::Polygon;

/// Curves are flattened this finely [m]: less than scissors can follow.
const TOLERANCE: f64 = 2.0e-4;

/// A piece that is as wide as the cloth is not wider than it [m].
pub(super) const FITS: f64 = 1.0e-6;

/// One piece of cloth to be laid.
#[derive(Debug, Clone)]
pub(super) struct Item {
    pub(super) piece: usize,
    pub(super) copy: u32,
    pub(super) layers: u32,
    pub(super) is_on_fold: bool,
    /// The ways in which it may lie, its lower left corner at zero.
    pub(super) ways: Vec<Way>,
}

/// One way of lying.
#[derive(Debug, Clone)]
pub(super) struct Way {
    pub(super) cloth_from_piece: Affine,
    pub(super) outline: Polygon,
    /// From the outline's left end to the level that prints are matched at [m].
    pub(super) match_level: f64,
    /// It has to lie at `y = 0`: on the fold, or with its hem on the border.
    pub(super) is_at_edge: bool,
}

/// The copies of a piece, cut through two layers or one.
pub(super) struct CutList {
    pub(super) doubled: Vec<Item>,
    pub(super) single: Vec<Item>,
}

/// Every copy of a piece that is to be cut from a cloth.
pub(super) fn cut_list(
    index: usize,
    piece: &Piece,
    cloth: &TableCloth,
    warnings: &mut Vec<MarkerWarning>,
) -> CutList {
    let whole = piece.unfolded();
    let width = cloth.width.to_m();
    let mut list = CutList {
        doubled: Vec::new(),
        single: Vec::new(),
    };
    let item = |copy, layers, is_on_fold, ways| Item {
        piece: index,
        copy,
        layers,
        is_on_fold,
        ways,
    };
    let copies = piece.cut.pieces();
    let mut copy = 0;
    if cloth.lay == Lay::Folded {
        let half = 0.5 * width;
        let has_fold = piece.edges.iter().any(|edge| edge.finish == Finish::Fold);
        let on_fold = has_fold.then(|| on_fold(piece)).flatten();
        let in_two = ways(&whole, cloth.nap, Affine::IDENTITY);
        let fits = |way: &Way| way.outline.bounds().y1 <= half + FITS;
        if let Some(way) = on_fold.filter(fits) {
            while copy < copies {
                list.doubled.push(item(copy, 2, true, vec![way.clone()]));
                copy += 1;
            }
        } else if in_two.iter().all(fits) && (is_pair(piece) || is_symmetric(&in_two[0].outline)) {
            while copy + 1 < copies {
                list.doubled.push(item(copy, 2, false, in_two.clone()));
                copy += 2;
            }
        }
    }
    let mut are_warned = false;
    for copy in copy..copies {
        let turned = if is_pair(piece) && copy % 2 == 1 {
            Affine::FLIP_X
        } else {
            Affine::IDENTITY
        };
        let mut said = Vec::new();
        let ways = single_ways(&whole, cloth, turned, &mut said);
        if !are_warned {
            warnings.append(&mut said);
            are_warned = true;
        }
        list.single.push(item(copy, 1, false, ways));
    }
    list
}

/// Whether a piece lies within both selvages of single cloth.
pub(crate) fn fits_cloth(piece: &Piece, cloth: &TableCloth) -> bool {
    let whole = piece.unfolded();
    let ways = single_ways(&whole, cloth, Affine::IDENTITY, &mut Vec::new());
    let reach = |way: &Way| way.outline.bounds().y1;
    ways.iter()
        .all(|way| reach(way) <= cloth.width.to_m() + FITS)
}

/// Size of a piece along the warp and across it, allowances included [m].
pub(crate) fn size_on_cloth(piece: &Piece) -> [f64; 2] {
    let whole = piece.unfolded();
    let ways = ways(&whole, Nap::OneWay, Affine::IDENTITY);
    let bounds = ways[0].outline.bounds();
    [bounds.x1, bounds.y1]
}

const fn is_pair(piece: &Piece) -> bool {
    matches!(piece.cut, CutCount::Pairs(_))
}

/// How a piece may lie on single cloth; those that reach over both selvages only where none fits.
fn single_ways(
    piece: &Piece,
    cloth: &TableCloth,
    turned: Affine,
    warnings: &mut Vec<MarkerWarning>,
) -> Vec<Way> {
    let width = cloth.width.to_m();
    let centimeters = |meters: f64| 100.0 * meters;
    if let Some(way) = cloth
        .border
        .and_then(|border| on_border(piece, border, turned))
    {
        let across = way.outline.bounds().y1;
        if across <= width + FITS {
            return vec![way];
        }
        if way.is_turned_aside(piece, turned) {
            warnings.push(MarkerWarning::BorderTooNarrow {
                name: piece.name,
                across_cm: centimeters(across),
                width_cm: cloth.width.to_cm(),
            });
        }
    }
    let ways = ways(piece, cloth.nap, turned);
    let size = ways[0].outline.bounds();
    if width + FITS < size.y1 {
        warnings.push(MarkerWarning::WiderThanCloth {
            name: piece.name,
            across_cm: centimeters(size.y1),
            along_cm: centimeters(size.x1),
            width_cm: cloth.width.to_cm(),
        });
    }
    ways
}

/// With the grain along the cloth, and turned by half where that is allowed.
fn ways(piece: &Piece, nap: Nap, turned: Affine) -> Vec<Way> {
    let grain = turned * piece.grain.to_point() - Point::ORIGIN;
    let upright = quarter_exact(-trig64::atan2(grain.y, grain.x)) * turned;
    let mut ways = vec![Way::new(piece, upright, Vec2::new(1.0, 0.0))];
    if nap != Nap::OneWay {
        let upside_down = Affine::scale(-1.0) * upright;
        ways.push(Way::new(piece, upside_down, Vec2::new(-1.0, 0.0)));
    }
    ways
}

/// A rotation; by whole quarters without rounding, so that rectangles stay upright.
fn quarter_exact(angle: f64) -> Affine {
    let (sin, cos) = trig64::sin_cos(angle);
    let exact = |value: f64| {
        if (value - value.round()).abs() < 1e-12 {
            value.round()
        } else {
            value
        }
    };
    let (sin, cos) = (exact(sin), exact(cos));
    Affine::new([cos, sin, -sin, cos, 0.0, 0.0])
}

/// With the fold of the piece on that of the cloth.
fn on_fold(piece: &Piece) -> Option<Way> {
    let fold = piece
        .edges
        .iter()
        .find(|edge| edge.finish == Finish::Fold)?;
    let rotation = facing_edge(fold, Affine::IDENTITY)?;
    let mut way = Way::new(piece, rotation, Vec2::new(1.0, 0.0));
    way.is_at_edge = true;
    Some(way)
}

/// With its longest straight hem at `y = 0`, or farthest from it.
fn on_border(piece: &Piece, border: Border, turned: Affine) -> Option<Way> {
    let hems = piece.edges.iter().filter(|edge| {
        let is_line = |segment: &kurbo::PathSeg| matches!(segment, kurbo::PathSeg::Line(_));
        edge.finish == Finish::Hem && edge.segments.len() == 1 && edge.segments.iter().all(is_line)
    });
    // Of a rectangle hemmed all around the first one written is the lower one.
    let hem = hems.reduce(|longest, edge| {
        if longest.length() + FITS < edge.length() {
            edge
        } else {
            longest
        }
    })?;
    let rotation = match border {
        Border::Hem => facing_edge(hem, turned)?,
        Border::Hip => Affine::scale(-1.0) * facing_edge(hem, turned)?,
    };
    let mut way = Way::new(piece, rotation * turned, Vec2::new(1.0, 0.0));
    way.is_at_edge = true;
    Some(way)
}

/// The rotation after `turned` that lays a straight edge along `x` with the cloth above it.
fn facing_edge(edge: &crate::piece::Edge, turned: Affine) -> Option<Affine> {
    use kurbo::ParamCurve as _;
    let (first, last) = (edge.segments.first()?, edge.segments.last()?);
    let along = turned * last.end() - turned * first.start();
    // A mirrored edge has the cloth on its right.
    let along = if turned.determinant() < 0.0 {
        -along
    } else {
        along
    };
    Some(quarter_exact(-trig64::atan2(along.y, along.x)))
}

impl Way {
    /// The piece under a rotation, moved to zero. `up` is where the upper end of its warp points.
    fn new(piece: &Piece, rotation: Affine, up: Vec2) -> Self {
        let outline = piece.cut_polygon(TOLERANCE).transformed(rotation);
        let corner = outline.bounds().origin();
        let to_zero = Affine::translate(-corner.to_vec2());
        let stitched = (piece.stitching_polygon(TOLERANCE)).transformed(to_zero * rotation);
        let bounds = stitched.bounds();
        Self {
            cloth_from_piece: to_zero * rotation,
            outline: outline.transformed(to_zero),
            match_level: if up.x < 0.0 { bounds.x1 } else { bounds.x0 },
            is_at_edge: false,
        }
    }

    /// Whether it lies with its grain across the cloth.
    fn is_turned_aside(&self, piece: &Piece, turned: Affine) -> bool {
        let grain = turned * piece.grain.to_point();
        let on_cloth =
            self.cloth_from_piece * piece.grain.to_point() - self.cloth_from_piece * Point::ORIGIN;
        on_cloth.x.abs() < 0.5 && 0.5 < grain.to_vec2().hypot()
    }
}

/// Whether an outline is its own mirror image across the cloth: then two layers of doubled cloth give
/// the same piece.
fn is_symmetric(outline: &Polygon) -> bool {
    let bounds = outline.bounds();
    let flipped = Affine::translate((0.0, bounds.y0 + bounds.y1)) * Affine::FLIP_Y;
    let mirror = outline.transformed(flipped);
    let off = |point: &Point| outline.distance(*point);
    mirror.points.iter().map(off).fold(0.0, f64::max) < 5.0 * TOLERANCE
}
