//! What a far light sees first: depth along one direction, seen without perspective.

use crate::prepare::Geometry;
use crate::whole;
use glam::{Vec2, Vec3, Vec4};

/// Depth of a texel that nothing covers [m]; a finite number, so that shaders can hold it.
pub(crate) const EMPTY: f32 = 1.0e30;
/// Free texels around the meshes, so that samples at their rim stay inside.
const BORDER: f32 = 3.0;
/// Texels are not made smaller than this [m]: finer than any thread shows.
const LEAST_TEXEL: f32 = 4.0e-4;

/// The covered extent grows in steps of this [m].
const EXTENT_STEP: f32 = 0.1;
/// Corner weights down to minus this count as inside.
const RIM: f32 = 1.0e-4;
/// From this many texels on, it pays to work out where in a row a triangle begins and ends.
const WIDE_SPAN: i32 = 8;

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
        // In a film the meshes move: a texel that keeps its size and place keeps shadows calm.
        let extent = ((high - low).max_element() / EXTENT_STEP).ceil().max(1.0) * EXTENT_STEP;
        let texel = (extent / (side as f32 - 2.0 * BORDER - 1.0)).max(LEAST_TEXEL);
        low = (low / texel).floor() * texel;
        let texels = (high - low) / texel + 2.0 * BORDER;
        let (width, height) = (whole::index(texels.x.ceil()), whole::index(texels.y.ceil()));
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
        let x_first = whole::ceil(low.x - 0.5).max(0);
        let y_first = whole::ceil(low.y - 0.5).max(0);
        let x_last = whole::floor(high.x - 0.5).min(last_of(self.width));
        let y_last = whole::floor(high.y - 0.5).min(last_of(self.height));
        if x_first > x_last || y_first > y_last {
            return;
        }
        let (ab, ac) = (b - a, c - a);
        let area = ab.x * ac.y - ab.y * ac.x;
        if area == 0.0 {
            return;
        }
        let per_area = 1.0 / area;
        // Weights of the corners b and c, and depth, as planes over the map.
        let beta = Vec2::new(ac.y, -ac.x) * per_area;
        let gamma = Vec2::new(-ab.y, ab.x) * per_area;
        let slope = beta * ab.z + gamma * ac.z;
        let wide = x_last - x_first > WIDE_SPAN;
        for y in y_first..=y_last {
            let dy = y as f32 + 0.5 - a.y;
            let at_a = [beta.y * dy, gamma.y * dy];
            let (mut start, mut end) = (x_first, x_last);
            if wide {
                [start, end] = span([beta.x, gamma.x], at_a, a.x, [start, end]);
            }
            for x in start..=end {
                let dx = x as f32 + 0.5 - a.x;
                let (beta_at, gamma_at) = (at_a[0] + beta.x * dx, at_a[1] + gamma.x * dx);
                // A hair wider than the triangle: neighbors share their edge.
                let inside = beta_at >= -RIM && gamma_at >= -RIM && beta_at + gamma_at <= 1.0 + RIM;
                if inside {
                    let depth = a.z + slope.x * dx + slope.y * dy;
                    let texel = y.unsigned_abs() as usize * self.width + x.unsigned_abs() as usize;
                    self.enter(texel, depth.clamp(low.z, high.z));
                }
            }
        }
    }

    fn enter(&mut self, texel: usize, depth: f32) {
        let nearest = &mut self.nearest[texel];
        if depth > *nearest {
            *nearest = depth;
        }
        if let Some(farthest) = self.farthest.get_mut(texel)
            && depth < *farthest
        {
            *farthest = depth;
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
            self.nearest[whole::index(v) * self.width + whole::index(u)]
        } else {
            -EMPTY
        }
    }

    fn share(&self, layer: &[f32], at: Vec3, is_free: impl Fn(f32, f32) -> bool) -> f32 {
        let (u, v) = (at.x - 0.5, at.y - 0.5);
        let inside =
            u >= 0.0 && v >= 0.0 && u < (self.width - 1) as f32 && v < (self.height - 1) as f32;
        if !inside {
            return 1.0;
        }
        let (column, row) = (whole::index(u), whole::index(v));
        let start = row * self.width + column;
        let free = |texel: usize| f32::from(u8::from(is_free(layer[texel], at.z)));
        let (u_part, v_part) = (u - column as f32, v - row as f32);
        let top = free(start) * (1.0 - u_part) + free(start + 1) * u_part;
        let bottom =
            free(start + self.width) * (1.0 - u_part) + free(start + self.width + 1) * u_part;
        top * (1.0 - v_part) + bottom * v_part
    }
}

/// The highest index of `count` things.
fn last_of(count: usize) -> i32 {
    i32::try_from(count).unwrap_or(i32::MAX) - 1
}

/// The part of a row in which all three corner weights may be positive. `slopes` are the changes
/// of the weights of b and c by texel, `at_a` the weights below or above corner a at column `a_x`.
fn span(slopes: [f32; 2], at_a: [f32; 2], a_x: f32, [first, last]: [i32; 2]) -> [i32; 2] {
    let third = (-slopes[0] - slopes[1], 1.0 - at_a[0] - at_a[1]);
    let (mut low, mut high) = (first as f32, last as f32);
    for (slope, start) in [(slopes[0], at_a[0]), (slopes[1], at_a[1]), third] {
        let limit = (-RIM - start) / slope + a_x - 0.5;
        if slope > 0.0 {
            low = low.max(limit - 1.0);
        } else if slope < 0.0 {
            high = high.min(limit + 1.0);
        }
    }
    [whole::ceil(low).max(first), whole::floor(high).min(last)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Camera, Material, Scene, SceneMesh};

    fn slanted_plane() -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let corner = |x: f32, z: f32| Vec3::new(x, 0.3 * x - 0.2 * z, z);
        let positions = vec![
            corner(-1.0, -1.0),
            corner(-1.0, 1.0),
            corner(1.0, 1.0),
            corner(1.0, -1.0),
        ];
        (positions, vec![[0, 1, 2], [0, 2, 3]])
    }

    #[test]
    fn depths_of_a_plane_are_those_of_its_equation() {
        let (positions, triangles) = slanted_plane();
        let material = Material::default();
        let mut scene = Scene::studio(Camera {
            eye: Vec3::Z,
            target: Vec3::ZERO,
            vertical_fov: 0.5,
        });
        scene.meshes.push(SceneMesh {
            positions: &positions,
            normals: &[],
            uvs: &[],
            colors: &[],
            triangles: &triangles,
            material: &material,
        });
        let geometry = Geometry::of(&scene);
        let axis = Vec3::new(0.2, 0.9, 0.1).normalize_or_zero();
        let map = DepthMap::draw(&geometry, axis, 64, Layers::Both);
        for step in 0..100_u8 {
            let (x, z) = (f32::from(step % 10), f32::from(step / 10));
            let (x, z) = (x * 0.18 - 0.8, z * 0.18 - 0.8);
            let on = Vec3::new(x, 0.3 * x - 0.2 * z, z);
            let near = Vec3::new(0.0, 0.0, 0.05);
            assert!((map.seen_from_front(map.project(on) + near) - 1.0).abs() < 1e-6);
            assert!(map.seen_from_front(map.project(on) - near).abs() < 1e-6);
            assert!((map.seen_from_behind(map.project(on) - near) - 1.0).abs() < 1e-6);
            assert!(map.seen_from_behind(map.project(on) + near).abs() < 1e-6);
        }
    }
}
