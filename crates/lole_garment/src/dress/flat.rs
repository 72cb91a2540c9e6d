//! Panels divided into triangles, beside each other on one cloth.

use glam::{DVec2, Vec2};
use lole_geom::narrow;
use lole_geom::polygon;
use lole_pattern::Pattern;

use super::panel::Panels;

/// Panels lie this far apart in the flat mesh, in spacings.
const APART: f64 = 4.0;

/// A garment in triangles, not yet on anybody.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct FlatMesh {
    /// Particles [m]: `x` along the warp, panels beside each other.
    pub(super) flat: Vec<Vec2>,
    /// The same in the plane of each panel's piece [m].
    pub(super) in_piece: Vec<DVec2>,
    /// Panel of every particle.
    pub(super) panel_of: Vec<usize>,
    /// Counterclockwise in the plane of the piece.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Particles that are sewn to each other.
    pub(super) stitches: Vec<[u32; 2]>,
    /// Particles that pucker between two stitches, the particles there, and the share of the way.
    pub(super) puckers: Vec<(u32, [u32; 2], f32)>,
    /// Lines asked for.
    pub(super) lines: Vec<Vec<u32>>,
    /// Particles of borders that nothing is sewn to: hems and bound edges.
    pub(super) hems: Vec<u32>,
}

impl FlatMesh {
    /// The particle nearest to a point of the piece [m].
    pub(super) fn nearest(&self, point: DVec2) -> u32 {
        let far = |at: &DVec2| at.distance_squared(point);
        let all = self.in_piece.iter().enumerate();
        let nearest = all.min_by(|a, b| far(a.1).total_cmp(&far(b.1)));
        nearest.map_or(0, |(index, _)| number(index))
    }
}

/// Divides all panels into triangles of about `spacing` [m]; `None` where a border crosses itself.
pub(super) fn mesh(pattern: &Pattern, panels: &Panels, spacing: f64) -> Option<FlatMesh> {
    let mut mesh = FlatMesh::default();
    let mut starts = Vec::new();
    let mut right = 0.0;
    for (index, panel) in panels.panels.iter().enumerate() {
        let start = mesh.flat.len();
        starts.push(start);
        let polygon::DividedPolygon { points, triangles } =
            polygon::divide(&panel.border, spacing)?;
        let grain = pattern.pieces[panel.piece].grain;
        let grain = DVec2::new(if panel.is_mirrored { -grain.x } else { grain.x }, grain.y);
        let on_cloth = |p: DVec2| DVec2::new(p.dot(grain), grain.perp_dot(p));
        let low = (points.iter()).fold(f64::INFINITY, |low, &p| low.min(on_cloth(p).x));
        let shift = right - low;
        for &point in &points {
            let cloth = on_cloth(point) + DVec2::new(shift, 0.0);
            right = f64::max(right, cloth.x + APART * spacing);
            mesh.flat.push(cloth.as_vec2());
            mesh.in_piece.push(point);
            mesh.panel_of.push(index);
        }
        let offset = number(start);
        mesh.triangles.extend(
            triangles
                .iter()
                .map(|corners| corners.map(|corner| corner + offset)),
        );
    }
    let place = |(panel, at): (usize, usize)| number(starts[panel] + at);
    let stitches = panels.stitches.iter().map(|pair| pair.map(place));
    mesh.stitches = stitches.filter(|[a, b]| a != b).collect();
    let puckers = panels.puckers.iter();
    let puckers = puckers.map(|&(at, ends, share)| (place(at), ends.map(place), narrow(share)));
    mesh.puckers = puckers.collect();
    let mut is_sewn = vec![false; mesh.flat.len()];
    for &particle in mesh.stitches.iter().flatten() {
        is_sewn[particle as usize] = true;
    }
    for (panel, &start) in panels.panels.iter().zip(&starts) {
        let border = start..start + panel.border.len();
        mesh.hems
            .extend(border.filter(|&at| !is_sewn[at]).map(number));
    }
    let lines = panels.lines.iter();
    mesh.lines = lines
        .map(|line| line.iter().map(|&point| place(point)).collect())
        .collect();
    Some(mesh)
}

pub(super) fn number(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(u32::MAX)
}
