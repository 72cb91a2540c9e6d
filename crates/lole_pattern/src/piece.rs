//! A flat piece: its stitching line edge by edge, what is added around it, and what is marked on it.
//!
//! A piece lies as it is worn and seen from the front: `+x` to the wearer's left, `+y` up, in meters.
//! So backs are seen through the body, and a pair's left piece lies where it is worn. Left sleeves are
//! seen from outside, their front towards `-x`.
//! Its edges run counterclockwise around it, so that the cloth is always on their left; the cut line
//! lies outside of them by each edge's allowance.

mod cut_line;
mod drawing;
mod unfold;

use kurbo::{BezPath, PathSeg, Point, Vec2};
use lole_geom::Length;
use lole_language::Words;

pub use drawing::{Drawing, DrawnLine, DrawnNotch, DrawnStitches};

/// A flat piece of a garment.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// Identifier within its pattern, such as `"front"`.
    pub id: &'static str,
    /// What it is called on the label and in the steps.
    pub name: Words,
    /// The stitching line, counterclockwise and closed: each edge begins where the last one ended.
    pub edges: Vec<Edge>,
    /// Direction of the warp, which runs along the selvages; unit length.
    pub grain: Vec2,
    /// What is marked on the cloth, inside the cut line.
    pub marks: Vec<Mark>,
    /// What it is cut from.
    pub cloth: ClothRole,
    /// How often it is cut.
    pub cut: CutCount,
}

/// One edge of a piece, from corner to corner.
#[derive(Debug, Clone, PartialEq)]
pub struct Edge {
    /// Identifier within its piece, such as `"side"`.
    pub id: &'static str,
    /// The stitching line: at least one segment, each beginning where the last one ended [m].
    pub segments: Vec<PathSeg>,
    /// Cloth outside of the stitching line.
    pub allowance: Length,
    /// What becomes of the edge.
    pub finish: Finish,
}

/// What becomes of an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Finish {
    /// It is sewn to another edge, or to itself.
    Seam,
    /// Its allowance is folded to the inside and stitched.
    Hem,
    /// It lies on the fold of the doubled cloth: the piece goes on as its own mirror image.
    Fold,
    /// It is the woven edge of the cloth and does not fray.
    Selvage,
    /// It stays as it is cut.
    Raw,
}

/// Which cloth of the garment a piece is cut from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ClothRole {
    /// The garment's own cloth.
    Main,
    /// A plain cloth beside it.
    Contrast,
    /// Cloth between the garment and the skin.
    Lining,
    /// What stiffens a part from inside.
    Interfacing,
}

/// How often a piece is cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutCount {
    /// As often as it says, all alike.
    Alike(u32),
    /// As pairs of a left and a right one; the drawing is the wearer's left.
    Pairs(u32),
}

impl CutCount {
    /// Pieces of cloth, a pair being two.
    #[must_use]
    pub const fn pieces(self) -> u32 {
        match self {
            Self::Alike(count) => count,
            Self::Pairs(count) => 2 * count,
        }
    }
}

/// What is marked on the cloth.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// A line to crease, stitch or gather along.
    Line {
        /// What it is for.
        kind: LineKind,
        /// The line, in the piece's plane [m].
        path: BezPath,
    },
    /// A short cut into the allowance that meets another one.
    Notch {
        /// Index into [`Piece::edges`].
        edge: usize,
        /// Distance from the edge's beginning along the stitching line [m].
        along: f64,
        /// Cut twice side by side, as on backs.
        is_double: bool,
    },
    /// A point to mark with chalk.
    Point {
        /// What it is for.
        name: Words,
        /// In the piece's plane [m].
        at: Point,
    },
}

/// What a marked line is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineKind {
    /// Crease of a turned edge.
    TurnUnder,
    /// The finished upper edge, where the cloth is folded to the inside.
    TopFold,
    /// Stitches along the upper edge of a casing.
    CasingTop,
    /// Stitches along the lower edge of a casing.
    CasingBottom,
    /// The finished lower edge.
    HemFold,
    /// Two rows of long stitches that are pulled up.
    Gather,
    /// A leg of a dart, or of a pleat: it meets its twin.
    Dart,
    /// Where another piece is laid.
    Placement,
    /// Slit to cut.
    Slit,
    /// Where parts meet that a piece is joined of.
    Join,
    /// Where a piece is cut open and spread, or folded, to be longer or shorter.
    Adjust,
}

impl LineKind {
    /// What the line is called on a cutting plan.
    #[must_use]
    pub const fn name(self) -> Words {
        use lole_language::words;
        match self {
            Self::TurnUnder => words("折り代の折り線", "crease of the turned edge"),
            Self::TopFold => words("上の折り山", "top fold"),
            Self::CasingTop => words("ゴム通しの上の縫い線", "casing, upper stitches"),
            Self::CasingBottom => words("ゴム通しの下の縫い線", "casing, lower stitches"),
            Self::HemFold => words("裾の折り線", "hem fold"),
            Self::Gather => words("ギャザー", "gathers"),
            Self::Dart => words("ダーツ", "dart"),
            Self::Placement => words("付け位置", "placement"),
            Self::Slit => words("切り込み", "slit"),
            Self::Join => words("はぎ", "join"),
            Self::Adjust => words("丈を変えるならここで", "lengthen or shorten here"),
        }
    }
}

impl Edge {
    /// A straight edge.
    #[must_use]
    pub fn straight(id: &'static str, from: Point, to: Point, finish: Finish) -> Self {
        Self {
            id,
            segments: vec![PathSeg::Line(kurbo::Line::new(from, to))],
            allowance: Length::ZERO,
            finish,
        }
    }

    /// The same edge with this much cloth outside of it.
    #[must_use]
    pub fn with_allowance(mut self, allowance: Length) -> Self {
        self.allowance = allowance;
        self
    }

    /// Its first point and its last one [m]; both at zero for an edge without segments.
    #[must_use]
    pub fn ends(&self) -> [Point; 2] {
        use kurbo::ParamCurve as _;
        let (first, last) = (self.segments.first(), self.segments.last());
        [
            first.map_or(Point::ZERO, PathSeg::start),
            last.map_or(Point::ZERO, PathSeg::end),
        ]
    }

    /// Length of the stitching line [m], to a hundredth of a millimeter.
    #[must_use]
    pub fn length(&self) -> f64 {
        use kurbo::ParamCurveArclen as _;
        (self.segments.iter())
            .map(|segment| segment.arclen(1e-5))
            .sum()
    }
}

/// A hem is turned under by this at its raw edge, where it is more than twice as deep.
const HEM_TURN: Length = Length::from_cm(1.0);

/// How far the allowance of a hem is folded to the wrong side, first at the raw edge and then again: by
/// halves where it is narrow.
#[must_use]
pub fn hem_turns(depth: Length) -> [Length; 2] {
    let turn = if depth <= HEM_TURN * 2.0 {
        depth * 0.5
    } else {
        HEM_TURN
    };
    [turn, depth - turn]
}

impl Piece {
    /// Whether it is cut on the bias, at 45° to the selvage.
    #[must_use]
    pub fn is_on_bias(&self) -> bool {
        (self.grain.x.abs() - self.grain.y.abs()).abs() < 0.1
    }

    /// The edge of this name.
    #[must_use]
    pub fn edge(&self, id: &str) -> Option<&Edge> {
        self.edges.iter().find(|edge| edge.id == id)
    }

    /// The stitching line as one closed path [m].
    #[must_use]
    pub fn stitching_line(&self) -> BezPath {
        use kurbo::ParamCurve as _;
        let segments = self.edges.iter().flat_map(|edge| edge.segments.iter());
        let mut path = BezPath::new();
        for (index, segment) in segments.enumerate() {
            if index == 0 {
                path.move_to(segment.start());
            }
            path.push(segment.as_path_el());
        }
        path.close_path();
        path
    }
}
