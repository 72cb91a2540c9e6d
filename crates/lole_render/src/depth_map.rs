//! What a far light sees first: depth along one direction, seen without perspective.

use crate::prepare::Geometry;
use glam::{Vec2, Vec3, Vec4};

/// Depth of a texel that nothing covers [m]; a finite number, so that shaders can hold it.
pub(crate) const EMPTY: f32 = 1.0e30;
/// Free texels around the meshes, so that samples at their rim stay inside.
const BORDER: f32 = 3.0;
/// Texels are not made smaller than this [m]: finer than any thread shows.
const LEAST_TEXEL: f32 = 4.0e-4;

/// Nearest and farthest surface along an axis for each texel of a plane across it.
#[derive(Debug, Clone)]
pub(crate) struct DepthMap {
    /// Columns.
    pub(crate) width: usize,
    /// Rows.
    pub(crate) height: usize,
    /// Texel column of a world point `p`: `dot(texel_u, (p, 1))`.
    pub(crate) texel_u: Vec4,
    /// Texel row of a world point.
    pub(crate) texel_v: Vec4,
    /// Unit vector towards the light; depth of a point is its distance along it [m].
    pub(crate) axis: Vec3,
    /// Size of a texel [m].
    pub(crate) texel: f32,
    /// Greatest depth of a surface in each texel: what the light at `+axis` sees; `-EMPTY` for
    /// none.
    pub(crate) nearest: Vec<f32>,
    /// Least depth: what a light at `-axis` sees; `EMPTY` for none, no texels where not asked for.
    pub(crate) farthest: Vec<f32>,
}

/// Which layers of a map are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Layers {
    /// Only what the light at `+axis` sees.
    Nearest,
    /// What the lights at `+axis` and at `-axis` see.
    Both,
}

impl DepthMap {
    /// Draws all triangles as seen along unit `axis`, the longer side at most `side` texels.
    pub(crate) fn draw(geometry: &Geometry, axis: Vec3, side: usize, layers: Layers) -> Self {
        let (right, up) = axis.any_orthonormal_pair();
        let mut low = Vec2::INFINITY;
        let mut high = Vec2::NEG_INFINITY;
        for point in &geometry.positions {
            let across = Vec2::new(point.dot(right), point.dot(up));
            low = low.min(across);
            high = high.max(across);
        }
        if geometry.positions.is_empty() {
            (low, high) = (Vec2::ZERO, Vec2::ZERO);
        }
        let texel = ((high - low).max_element() / (side as f32 - 2.0 * BORDER)).max(LEAST_TEXEL);
        let texels = (high - low) / texel + 2.0 * BORDER;
        let (width, height) = (texels.x.ceil() as usize, texels.y.ceil() as usize);
        let scale = 1.0 / texel;
        let mut map = Self {
            width,
            height,
            texel_u: (right * scale).extend(BORDER - low.x * scale),
            texel_v: (up * scale).extend(BORDER - low.y * scale),
            axis,
            texel,
            nearest: vec![-EMPTY; width * height],
            farthest: Vec::new(),
        };
        if layers == Layers::Both {
            map.farthest = vec![EMPTY; width * height];
        }
        let projected: Vec<Vec3> = geometry.positions.iter().map(|&p| map.project(p)).collect();
        for triangle in &geometry.triangles {
            map.cover(triangle.map(|index| projected[index as usize]));
        }
        map
    }

    /// Texel column, texel row and depth [m] of a world point.
    pub(crate) fn project(&self, point: Vec3) -> Vec3 {
        Vec3::new(
            point.dot(self.texel_u.truncate()) + self.texel_u.w,
            point.dot(self.texel_v.truncate()) + self.texel_v.w,
            point.dot(self.axis),
        )
    }

    /// Enters a triangle (columns, rows, depth) at the centers of the texels that it covers.
    fn cover(&mut self, [a, b, c]: [Vec3; 3]) {
        let low = a.min(b).min(c);
        let high = a.max(b).max(c);
        // Texel (x, y) has its center at (x + 0.5, y + 0.5).
        let x_first = (low.x - 0.5).ceil().max(0.0) as usize;
        let y_first = (low.y - 0.5).ceil().max(0.0) as usize;
        let x_end = ((high.x - 0.5).floor() + 1.0).clamp(0.0, self.width as f32) as usize;
        let y_end = ((high.y - 0.5).floor() + 1.0).clamp(0.0, self.height as f32) as usize;
        if x_first >= x_end || y_first >= y_end {
            return;
        }
        let (ab, ac) = (b - a, c - a);
        let area = ab.x * ac.y - ab.y * ac.x;
        if area == 0.0 {
            return;
        }
        let per_area = 1.0 / area;
        let slope_x = (ab.z * ac.y - ac.z * ab.y) * per_area;
        let slope_y = (ac.z * ab.x - ab.z * ac.x) * per_area;
        for y in y_first..y_end {
            for x in x_first..x_end {
                let (dx, dy) = (x as f32 + 0.5 - a.x, y as f32 + 0.5 - a.y);
                let beta = (dx * ac.y - dy * ac.x) * per_area;
                let gamma = (dy * ab.x - dx * ab.y) * per_area;
                // A hair wider than the triangle: neighbors share their edge.
                if beta >= -1.0e-4 && gamma >= -1.0e-4 && beta + gamma <= 1.0001 {
                    let depth = a.z + slope_x * dx + slope_y * dy;
                    self.enter(y * self.width + x, depth.clamp(low.z, high.z));
                }
            }
        }
    }

    fn enter(&mut self, texel: usize, depth: f32) {
        let nearest = &mut self.nearest[texel];
        *nearest = nearest.max(depth);
        if let Some(farthest) = self.farthest.get_mut(texel) {
            *farthest = farthest.min(depth);
        }
    }

    /// Share of the four texels around a projected point, bilinear, in which the light at
    /// `+axis` sees nothing before it.
    pub(crate) fn seen_from_front(&self, at: Vec3) -> f32 {
        self.share(&self.nearest, at, |surface, depth| surface <= depth)
    }

    /// The same for a light at `-axis`.
    pub(crate) fn seen_from_behind(&self, at: Vec3) -> f32 {
        self.share(&self.farthest, at, |surface, depth| surface >= depth)
    }

    /// What the light at `+axis` sees first at a texel; `-EMPTY` outside the map.
    pub(crate) fn nearest_at(&self, u: f32, v: f32) -> f32 {
        let inside = u >= 0.0 && v >= 0.0 && u < self.width as f32 && v < self.height as f32;
        if inside {
            self.nearest[v as usize * self.width + u as usize]
        } else {
            -EMPTY
        }
    }

    fn share(&self, layer: &[f32], at: Vec3, is_free: impl Fn(f32, f32) -> bool) -> f32 {
        let (u, v) = (at.x - 0.5, at.y - 0.5);
        let (u_floor, v_floor) = (u.floor(), v.floor());
        let inside = u_floor >= 0.0
            && v_floor >= 0.0
            && u_floor < (self.width - 1) as f32
            && v_floor < (self.height - 1) as f32;
        if !inside {
            return 1.0;
        }
        let start = v_floor as usize * self.width + u_floor as usize;
        let free = |texel: usize| f32::from(u8::from(is_free(layer[texel], at.z)));
        let (u_part, v_part) = (u - u_floor, v - v_floor);
        let top = free(start) * (1.0 - u_part) + free(start + 1) * u_part;
        let bottom =
            free(start + self.width) * (1.0 - u_part) + free(start + self.width + 1) * u_part;
        top * (1.0 - v_part) + bottom * v_part
    }
}
