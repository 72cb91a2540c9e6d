//! Panels divided into triangles: a lattice of equal triangles inside, the border's own points around it.

use glam::{DVec2, Vec2};
use lole_pattern::Pattern;
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Point2, Triangulation as _};

use super::bodice::narrow;
use super::panel::Panels;

/// Points of the lattice keep this share of the spacing from the border.
const FROM_BORDER: f64 = 0.62;
/// Height of a triangle of the lattice over its side: √3 / 2.
const ROW: f64 = 0.866_025_403_784_438_6;
/// Panels lie this far apart in the flat mesh, in spacings.
const APART: f64 = 4.0;
/// A triangle flatter than this share of the spacing is none.
const FLATTEST: f64 = 0.02;

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

/// A point of the triangulation that knows its number.
#[derive(Debug, Clone, Copy)]
struct Numbered {
    at: DVec2,
    number: u32,
}

impl HasPosition for Numbered {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        Point2::new(self.at.x, self.at.y)
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
        let border_count = panel.border.len();
        let inner = lattice(&panel.border, spacing);
        let points: Vec<DVec2> = panel.border.iter().copied().chain(inner).collect();
        let triangles = triangulate(&points, border_count, spacing)?;
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

/// Corners of equal triangles within a border.
fn lattice(border: &[DVec2], spacing: f64) -> Vec<DVec2> {
    let low = border.iter().fold(DVec2::INFINITY, |low, p| low.min(*p));
    let high = border
        .iter()
        .fold(DVec2::NEG_INFINITY, |high, p| high.max(*p));
    let mut points = Vec::new();
    let mut row = 0_u32;
    loop {
        let y = low.y + f64::from(row) * ROW * spacing;
        if high.y < y {
            return points;
        }
        let mut column = 0_u32;
        loop {
            let half = if row.is_multiple_of(2) { 0.0 } else { 0.5 };
            let x = low.x + (f64::from(column) + half) * spacing;
            if high.x < x {
                break;
            }
            let point = DVec2::new(x, y);
            if is_inside(border, point) && FROM_BORDER * spacing < distance(border, point) {
                points.push(point);
            }
            column += 1;
        }
        row += 1;
    }
}

fn sides(border: &[DVec2]) -> impl Iterator<Item = [DVec2; 2]> {
    let next = border.iter().cycle().skip(1);
    border.iter().zip(next).map(|(&a, &b)| [a, b])
}

/// By the number of sides that are crossed on the way to the right.
fn is_inside(border: &[DVec2], point: DVec2) -> bool {
    let crossed = sides(border).filter(|[a, b]| {
        (a.y <= point.y) != (b.y <= point.y)
            && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)
    });
    crossed.count() % 2 == 1
}

fn distance(border: &[DVec2], point: DVec2) -> f64 {
    let to_side = sides(border).map(|[a, b]| {
        let along = b - a;
        let share = (point - a).dot(along) / along.length_squared().max(1.0e-18);
        (a + along * share.clamp(0.0, 1.0)).distance(point)
    });
    to_side.fold(f64::INFINITY, f64::min)
}

/// Triangles between points of which the first ones are a border; `None` where that crosses itself.
fn triangulate(points: &[DVec2], border_count: usize, spacing: f64) -> Option<Vec<[u32; 3]>> {
    let numbered: Vec<Numbered> = (0_u32..)
        .zip(points)
        .map(|(number, &at)| Numbered { at, number })
        .collect();
    let sides: Vec<[usize; 2]> = (0..border_count)
        .map(|from| [from, (from + 1) % border_count])
        .collect();
    let mut crosses = false;
    let found =
        ConstrainedDelaunayTriangulation::<Numbered>::try_bulk_load_cdt(numbered, sides, |_| {
            crosses = true;
        });
    let found = found.ok()?;
    if crosses || found.num_vertices() != points.len() {
        return None;
    }
    let border = &points[..border_count];
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for face in found.inner_faces() {
        let corners = face.vertices().map(|vertex| vertex.data().number);
        let [a, b, c] = corners.map(|corner| points[corner as usize]);
        let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
        let height = (b - a).perp_dot(c - a) / longest;
        if is_inside(border, (a + b + c) / 3.0) && FLATTEST * spacing < height {
            triangles.push(corners);
        }
    }
    triangles.sort_unstable();
    Some(triangles)
}
