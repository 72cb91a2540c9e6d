//! What a far light sees first: depth along one direction, seen without perspective.

use crate::prepare::Geometry;
use crate::shade::BELL;
use crate::whole;
use glam::{Vec2, Vec3, Vec4};
use rayon::prelude::*;
use wide::f32x4;

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

/// The cone of a lamp begins this wide [texel]: what always counts, and one of rounding.
const FOOT: usize = 4;
/// Middles of four texels in a row.
const LANES: f32x4 = f32x4::new([0.5, 1.5, 2.5, 3.5]);

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
    /// Greatest depths of squares of texels, each level half as fine as the one before, the first
    /// half as fine as `nearest`; none but for a map of the nearest surfaces alone.
    pub(crate) coarser: Vec<Vec<f32>>,
}

/// Levels beyond the finest that a map of the nearest surfaces alone has.
pub(crate) const COARSER_LEVELS: usize = 5;

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
        let mut sides = [texels.x, texels.y].map(|side| whole::index(side.ceil()));
        if layers == Layers::Nearest {
            // The coarser levels cover the finest to its rim.
            sides = sides.map(|side| side.next_multiple_of(1 << COARSER_LEVELS));
        }
        let [width, height] = sides;
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
            coarser: Vec::new(),
        };
        if layers == Layers::Both {
            map.farthest = vec![EMPTY; width * height];
        }
        let projected: Vec<Vec3> = geometry.positions.iter().map(|&p| map.project(p)).collect();
        for triangle in &geometry.triangles {
            map.cover(triangle.map(|index| projected[index as usize]));
        }
        if layers == Layers::Nearest {
            map.add_coarser();
        }
        map
    }

    /// Works out the coarser levels: the greatest of the four texels that each covers.
    fn add_coarser(&mut self) {
        for level in 1..=COARSER_LEVELS {
            let finer = self.coarser.last().unwrap_or(&self.nearest);
            let width = self.width >> (level - 1);
            let texels = finer
                .chunks_exact(2 * width)
                .flat_map(|rows| {
                    let (top, bottom) = rows.split_at(width);
                    (top.chunks_exact(2).zip(bottom.chunks_exact(2)))
                        .map(|(a, b)| a[0].max(a[1]).max(b[0]).max(b[1]))
                })
                .collect();
            self.coarser.push(texels);
        }
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
            let row = y.unsigned_abs() as usize * self.width;
            for x in (start..=end).step_by(4) {
                // Four texels at once; the last four of a row where fewer are left.
                let x = x.min(last_of(self.width) - 3);
                let dx = LANES + (x as f32 - a.x);
                let (beta_at, gamma_at) = (dx * beta.x + at_a[0], dx * gamma.x + at_a[1]);
                // A hair wider than the triangle: neighbors share their edge.
                let alpha_at = f32x4::ONE - beta_at - gamma_at;
                let least = beta_at.fast_min(gamma_at).fast_min(alpha_at);
                let depth = dx * slope.x + (a.z + slope.y * dy);
                let depth = depth
                    .fast_max(f32x4::splat(low.z))
                    .fast_min(f32x4::splat(high.z));
                let inside = least.simd_ge(f32x4::splat(-RIM));
                self.enter(row + x.unsigned_abs() as usize, inside, depth);
            }
        }
    }

    /// Enters the depths of four texels where `inside` says so.
    #[inline]
    fn enter(&mut self, texel: usize, inside: f32x4, depth: f32x4) {
        if let Some(nearest) = self.nearest[texel..].first_chunk_mut::<4>() {
            let before = f32x4::new(*nearest);
            *nearest = inside.bitselect(before.fast_max(depth), before).to_array();
        }
        let farthest = self.farthest.get_mut(texel..);
        if let Some(farthest) = farthest.and_then(|rest| rest.first_chunk_mut::<4>()) {
            let before = f32x4::new(*farthest);
            *farthest = inside.bitselect(before.fast_min(depth), before).to_array();
        }
    }

    /// Share of the four texels around a projected point, bilinear, in which the light at
    /// `+axis` sees nothing before it.
    pub(crate) fn seen_from_front(&self, at: Vec3) -> f32 {
        self.share(&self.nearest, at, |surface, depth| surface <= depth)
    }

    /// Share of the four texels around a projected point, bilinear, in which the light at `-axis` sees
    /// nothing before it.
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

    /// What the light at `+axis` sees at eight neighbors in a row of a level; `-EMPTY` outside the
    /// map.
    #[inline]
    pub(crate) fn eight(&self, level: usize, [first, row]: [i32; 2]) -> [f32x4; 2] {
        let texels = match level.checked_sub(1) {
            None => &self.nearest,
            Some(coarser) => &self.coarser[coarser],
        };
        let (width, height) = (self.width >> level, self.height >> level);
        let row = match usize::try_from(row) {
            Ok(row) if row < height => &texels[row * width..(row + 1) * width],
            _ => return [f32x4::splat(-EMPTY); 2],
        };
        let inside = usize::try_from(first).ok();
        let eight = inside.and_then(|first| row.get(first..)?.first_chunk::<8>());
        if let Some(&[a, b, c, d, e, f, g, h]) = eight {
            return [f32x4::new([a, b, c, d]), f32x4::new([e, f, g, h])];
        }
        let at = |node: i32| {
            let column = usize::try_from(first + node).unwrap_or(usize::MAX);
            row.get(column).copied().unwrap_or(-EMPTY)
        };
        [0, 4].map(|node| f32x4::new([at(node), at(node + 1), at(node + 2), at(node + 3)]))
    }

    /// What the light at `+axis` sees at eight texels of the finest level, `stride` apart in a row and
    /// each lowered by its own shift; `-EMPTY` outside the map.
    #[inline]
    pub(crate) fn eight_shifted(
        &self,
        [first, row]: [i32; 2],
        stride: i32,
        down: &[i32; 8],
    ) -> [f32x4; 2] {
        let at = |node: u8| {
            let column = (first + i32::from(node) * stride).cast_unsigned() as usize;
            let row = (row + down[usize::from(node)]).cast_unsigned() as usize;
            if column < self.width && row < self.height {
                self.nearest[row * self.width + column]
            } else {
                -EMPTY
            }
        };
        [0, 4].map(|node| f32x4::new([at(node), at(node + 1), at(node + 2), at(node + 3)]))
    }

    /// For each texel, the depth above which nothing is in the way of a lamp at `+axis` that is
    /// seen under `tangent`: no surface rises out of the cone towards the lamp.
    ///
    /// The cone is taken a little wider than it is, as a pyramid, so that two sweeps along each
    /// side of the map find it.
    pub(crate) fn clear_above(&self, tangent: f32) -> Vec<f32> {
        let slope = std::f32::consts::FRAC_1_SQRT_2 * self.texel / (tangent.max(1.0e-3) * BELL);
        let mut bound = self.nearest.clone();
        bound.par_chunks_mut(self.width).for_each(|row| {
            widen(row);
            for x in 1..row.len() {
                row[x] = row[x].max(row[x - 1] - slope);
            }
            for x in (1..row.len()).rev() {
                row[x - 1] = row[x - 1].max(row[x] - slope);
            }
        });
        let rows = bound.clone();
        let width = self.width;
        bound
            .par_chunks_mut(width)
            .enumerate()
            .for_each(|(y, row)| {
                let first = y.saturating_sub(FOOT);
                let last = (y + FOOT).min(self.height - 1);
                for other in rows[first * width..(last + 1) * width].chunks_exact(width) {
                    raise(row, other, 0.0);
                }
            });
        for y in 1..self.height {
            let (before, after) = bound.split_at_mut(y * width);
            raise(&mut after[..width], &before[(y - 1) * width..], slope);
        }
        for y in (1..self.height).rev() {
            let (before, after) = bound.split_at_mut(y * width);
            raise(&mut before[(y - 1) * width..], &after[..width], slope);
        }
        bound
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

/// Raises each value to that of the other row less `drop`.
fn raise(row: &mut [f32], other: &[f32], drop: f32) {
    for (value, &other) in row.iter_mut().zip(other) {
        *value = value.max(other - drop);
    }
}

/// Raises each value of a row to the greatest within [`FOOT`] places.
fn widen(row: &mut [f32]) {
    let before = row.to_vec();
    for shift in 1..=FOOT.min(row.len()) {
        raise(&mut row[shift..], &before, 0.0);
        raise(row, &before[shift..], 0.0);
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
