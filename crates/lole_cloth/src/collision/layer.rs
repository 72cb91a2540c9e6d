//! Layers of cloth whose order the garment knows: an underskirt stays under the skirt.
//!
//! What lies in another layer's way is not asked for but known, so contact is one-sided: the inner
//! garment leads, and the outer one meets its [`Envelope`] as it meets skin, within every substep.
//!
//! Gathers give way to what is worn over them without being simulated flatter: [`Press`] says where they
//! lie then.
//!
//! [`Orientation`] answers exactly on which side of a layer a point lies, and is what layers are
//! measured by.

mod envelope;
mod press;
mod shape;
mod wall;

use glam::Vec3;
use lole_geom::triangle_grid::{Nearest, TriangleGrid, blend};

pub use envelope::Envelope;
pub use press::{OuterCloth, Press};
pub use wall::Trunk;

/// Weight of a corner below which the nearest point lies on the opposite side of its triangle.
const ON_SIDE: f32 = 1.0e-4;

/// Cells of the search over the mean edge of a triangle, about.
const SEARCH_CELL: f32 = 2.0;

/// A surface with an inside and an outside.
#[derive(Debug, Clone, Copy)]
pub struct Layer<'a> {
    /// Corners, counterclockwise seen from the outside; shape `[triangle_count]`.
    pub triangles: &'a [[u32; 3]],
    /// Where its particles are [m], shape `[particle_count]`.
    pub positions: &'a [Vec3],
}

/// Outward normals of a layer, found once for many questions.
pub struct Orientation<'a> {
    layer: Layer<'a>,
    search: TriangleGrid<'a>,
    /// Sum of the normals of the triangles around every particle, unit length or zero.
    normals: Vec<Vec3>,
    /// Particles on the border of the layer.
    is_border: Vec<bool>,
}

/// A point seen from a layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight {
    /// Number of the nearest triangle.
    pub triangle: u32,
    /// Weights of its corners at the nearest point.
    pub weights: Vec3,
    /// Outward unit vector at the nearest point.
    pub normal: Vec3,
    /// Height above the nearest point along the normal [m]; negative inside.
    pub height: f32,
}

impl<'a> Orientation<'a> {
    /// Prepares `layer`, with a border where an edge belongs to one triangle alone.
    #[must_use]
    pub fn new(layer: Layer<'a>) -> Self {
        let (mut length, mut count) = (0.0, 0.0);
        for triangle in layer.triangles {
            let [a, b, _] = triangle.map(|corner| layer.positions[corner as usize]);
            length += a.distance(b);
            count += 1.0;
        }
        let mut normals = Vec::new();
        shape::write_normals(layer.triangles, layer.positions, &mut normals);
        let cell = SEARCH_CELL * length / f32::max(count, 1.0);
        Self {
            layer,
            search: TriangleGrid::new(layer.positions, layer.triangles, cell.max(1.0e-4)),
            normals,
            is_border: shape::border(layer.triangles, layer.positions.len()),
        }
    }

    /// The point of the layer nearest to `point` [m] within `reach` [m], and on which side of it the
    /// point lies. A point beyond the border of the layer is on neither side.
    #[must_use]
    pub fn sight(&self, point: Vec3, reach: f32) -> Option<Sight> {
        let nearest: Nearest = self.search.nearest(point, reach)?;
        let corners = self.layer.triangles[nearest.triangle as usize];
        let weights = nearest.barycentric;
        if is_on_border(&self.is_border, corners, weights) {
            return None;
        }
        let normals = corners.map(|corner| self.normals[corner as usize]);
        let normal = blend(normals, weights).try_normalize()?;
        let height = (point - nearest.point).dot(normal);
        Some(Sight {
            triangle: nearest.triangle,
            weights,
            normal,
            height,
        })
    }
}

/// Whether a point with these weights of its triangle's corners lies on an edge or corner of the
/// border.
fn is_on_border(is_border: &[bool], corners: [u32; 3], weights: Vec3) -> bool {
    let weights = weights.to_array();
    let is_inner = weights.into_iter().all(|weight| ON_SIDE < weight);
    let mut counted = corners.into_iter().zip(weights);
    !is_inner && counted.all(|(corner, weight)| weight <= ON_SIDE || is_border[corner as usize])
}
