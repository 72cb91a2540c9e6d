//! What a run of a piece is judged by.

use glam::{Vec2, Vec3};

use crate::diagnose::{StrainSummary, crossing_count, summarize};
use crate::mesh::model::MeshModel;

/// Absolute strain along warp and weft of every triangle at `positions` [m], triangles pinned all
/// around left out.
#[must_use]
pub fn strain(model: &MeshModel, positions: &[Vec3]) -> StrainSummary {
    let pinned = &model.spec().pinned;
    let free = (model.triangles().iter().enumerate())
        .filter(|(_, triangle)| !triangle.iter().all(|&particle| pinned[particle as usize]));
    let strains = free.flat_map(|(index, _)| {
        let [along_warp, along_weft] = deformation_of(model, index, positions);
        [along_warp, along_weft].map(|column| (column.length() - 1.0).abs())
    });
    summarize(strains.collect())
}

/// Pairs of an edge and a triangle of the piece that cross at `positions` [m] and share no particle:
/// 0 where no fold has gone through another. Where positions are not all finite there is no answer.
#[must_use]
pub fn self_crossings(model: &MeshModel, positions: &[Vec3]) -> Option<usize> {
    let edges = model.topology().edges.iter().map(|edge| edge.ends);
    crossing_count((model.triangles(), edges), positions, model.spacing())
}

/// What becomes of the unit vectors along warp and weft in one of a flat model's triangles, with its
/// particles at `positions` [m]: the columns of the deformation gradient.
///
/// # Panics
/// When the model is of welded pieces: of those [`deformation_of`] tells.
#[must_use]
pub fn deformation(model: &MeshModel, triangle: [u32; 3], positions: &[Vec3]) -> [Vec3; 2] {
    let flat = triangle.map(|p| model.spec().flat_positions[p as usize]);
    columns(flat, triangle, positions)
}

/// What becomes of the unit vectors along warp and weft in the triangle with an index, of any model, with
/// its particles at `positions` [m]: the columns of the deformation gradient.
#[must_use]
pub fn deformation_of(model: &MeshModel, triangle: usize, positions: &[Vec3]) -> [Vec3; 2] {
    let flat = model.flat_corners(triangle);
    columns(flat, model.triangles()[triangle], positions)
}

fn columns(
    [origin, first, second]: [Vec2; 3],
    triangle: [u32; 3],
    positions: &[Vec3],
) -> [Vec3; 2] {
    let (e1, e2) = (first - origin, second - origin);
    let [x0, x1, x2] = triangle.map(|particle| positions[particle as usize]);
    let (d1, d2) = (x1 - x0, x2 - x0);
    let doubled_area = e1.perp_dot(e2);
    [
        (d1 * e2.y - d2 * e1.y) / doubled_area,
        (d2 * e1.x - d1 * e2.x) / doubled_area,
    ]
}
