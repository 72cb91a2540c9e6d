//! How many layers of cloth lie at each particle: allowances are folded under at hems, and pressed open at seams.

use glam::DVec2;
use kurbo::{ParamCurveNearest as _, PathSeg, Point, Rect, Shape as _};
use lole_geom::narrow;
use lole_pattern::Pattern;
use lole_pattern::piece::{Edge, Finish, Piece, hem_turns};

use super::flat::FlatMesh;
use super::panel::Panels;

/// How near the nearest place of an edge is found [m].
const ACCURACY: f64 = 1.0e-4;

/// A strip along an edge in which what is folded under lies.
struct Fold {
    segments: Vec<PathSeg>,
    /// Where it can be [m].
    bounds: Rect,
    /// How far it reaches into the piece [m].
    depth: f64,
    /// Layers beside that of the piece.
    more: f64,
}

impl Fold {
    /// What is folded under at an edge: a hem, turned in at its raw edge, lies on less cloth than its allowance
    /// is deep; one side of a seam is as deep as its allowance.
    fn at(edge: &Edge, spacing: f64) -> Option<Self> {
        let allowance = edge.allowance.to_m();
        let depth = match edge.finish {
            Finish::Hem => hem_turns(edge.allowance)[1].to_m(),
            Finish::Seam => allowance,
            Finish::Fold | Finish::Selvage | Finish::Raw => 0.0,
        };
        if depth <= 0.0 {
            return None;
        }
        let reach = depth + spacing;
        let bounds = edge.segments.iter().map(PathSeg::bounding_box);
        let bounds = bounds.reduce(|a, b| a.union(b))?.inflate(reach, reach);
        Some(Self {
            segments: edge.segments.clone(),
            bounds,
            depth,
            more: allowance / depth,
        })
    }

    /// Layers beside that of the piece, of the cloth half a `spacing` [m] around a point.
    fn more_at(&self, point: Point, spacing: f64) -> f64 {
        if !self.bounds.contains(point) {
            return 0.0;
        }
        let squares = self.segments.iter();
        let squares = squares.map(|segment| segment.nearest(point, ACCURACY).distance_sq);
        let distance = squares.fold(f64::INFINITY, f64::min).sqrt();
        // Of a particle of the border the half beyond it is not cloth.
        let near = (distance - 0.5 * spacing).max(0.0);
        let far = distance + 0.5 * spacing;
        self.more * (far.min(self.depth) - near).max(0.0) / (far - near)
    }
}

/// Layers at every particle of a mesh whose particles lie about `spacing` [m] apart.
pub(super) fn layers(
    pattern: &Pattern,
    (panels, mesh): (&Panels, &FlatMesh),
    spacing: f64,
) -> Vec<f32> {
    let folds = |piece: &Piece| -> Vec<Fold> {
        let whole = piece.unfolded();
        let edges = whole.edges.iter();
        edges.filter_map(|edge| Fold::at(edge, spacing)).collect()
    };
    let folds: Vec<Vec<Fold>> = pattern.pieces.iter().map(folds).collect();
    let particles = mesh.in_piece.iter().zip(&mesh.panel_of);
    let layers = particles.map(|(&point, &panel)| {
        let panel = &panels.panels[panel];
        let point = if panel.is_mirrored {
            DVec2::new(-point.x, point.y)
        } else {
            point
        };
        let point = Point::new(point.x, point.y);
        let more = folds[panel.piece].iter();
        let more: f64 = more.map(|fold| fold.more_at(point, spacing)).sum();
        narrow(1.0 + more)
    });
    layers.collect()
}
