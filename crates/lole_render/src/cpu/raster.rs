//! Which triangle is nearest at each of the four samples of each pixel of a tile.

use super::tiles::{TILE, TileGrid};
use crate::camera::NEAR;
use crate::frame::Frame;
use crate::prepare::Geometry;
use crate::{Sides, whole};
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use wide::f32x4;

/// Samples of a pixel, across: the pattern that graphics adapters use too, so that edges look
/// alike.
pub(super) const SAMPLE_X: [f32; 4] = [0.375, 0.875, 0.125, 0.625];
/// Samples of a pixel, down.
pub(super) const SAMPLE_Y: [f32; 4] = [0.125, 0.375, 0.625, 0.875];
/// No triangle.
pub(super) const NOTHING: u32 = u32::MAX;

/// A vertex on the screen.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    /// Where [pixel], y down; meaningless behind the near plane.
    pub(super) at: Vec2,
    /// [`NEAR`] over the distance along the view: 1 at the near plane, 0 at infinity.
    pub(super) depth: f32,
    /// Clip coordinates x, y and w, for triangles that cross the near plane.
    clip: Vec3,
    /// Picture size, half [pixel].
    half_size: Vec2,
}

impl Corner {
    fn new(clip: Vec3, half_size: Vec2) -> Self {
        let per_w = 1.0 / clip.z;
        Self {
            at: Vec2::new(1.0 + clip.x * per_w, 1.0 - clip.y * per_w) * half_size,
            depth: NEAR * per_w,
            clip,
            half_size,
        }
    }

    fn is_before_near(self) -> bool {
        self.clip.z >= NEAR
    }
}

/// All vertices on the screen.
pub(super) fn screen_corners(geometry: &Geometry, frame: &Frame) -> Vec<Corner> {
    let half_size = Vec2::new(frame.ray_right.w, frame.ray_down.w) * 0.5;
    geometry
        .positions
        .par_iter()
        .map(|&position| {
            let clip = frame.clip_from_world * position.extend(1.0);
            Corner::new(Vec3::new(clip.x, clip.y, clip.w), half_size)
        })
        .collect()
}

/// At most two triangles: what the near plane leaves of one.
pub(super) struct Pieces {
    pieces: [[Corner; 3]; 2],
    count: usize,
}

impl Pieces {
    pub(super) fn as_slice(&self) -> &[[Corner; 3]] {
        &self.pieces[..self.count]
    }
}

/// The part of a triangle beyond the near plane.
pub(super) fn screen_pieces(points: [Corner; 3]) -> Pieces {
    let kept = points.map(Corner::is_before_near);
    let pieces = |pieces, count| Pieces { pieces, count };
    let [a, b, c] = points;
    match kept {
        [true, true, true] => pieces([points; 2], 1),
        [false, false, false] => pieces([points; 2], 0),
        [true, false, false] => one_left(a, b, c),
        [false, true, false] => one_left(b, c, a),
        [false, false, true] => one_left(c, a, b),
        [false, true, true] => two_left(b, c, a),
        [true, false, true] => two_left(c, a, b),
        [true, true, false] => two_left(a, b, c),
    }
}

fn one_left(kept: Corner, next: Corner, last: Corner) -> Pieces {
    let piece = [kept, at_near(kept, next), at_near(kept, last)];
    Pieces {
        pieces: [piece; 2],
        count: 1,
    }
}

fn two_left(kept: Corner, next: Corner, lost: Corner) -> Pieces {
    let (beside_next, beside_kept) = (at_near(next, lost), at_near(kept, lost));
    Pieces {
        pieces: [[kept, next, beside_next], [kept, beside_next, beside_kept]],
        count: 2,
    }
}

/// Where the way from `kept` to `lost` meets the near plane.
fn at_near(kept: Corner, lost: Corner) -> Corner {
    let part = (kept.clip.z - NEAR) / (kept.clip.z - lost.clip.z);
    let mut clip = kept.clip.lerp(lost.clip, part);
    clip.z = NEAR;
    Corner::new(clip, kept.half_size)
}

/// Twice the area on the screen [pixel²], positive where the face is seen.
pub(super) fn doubled_area([a, b, c]: &[Corner; 3]) -> f32 {
    // The screen's y points down, which turns the sense of rotation.
    -(b.at - a.at).perp_dot(c.at - a.at)
}

/// Samples of one tile: the nearest triangle and its depth.
pub(super) struct Samples {
    depths: Vec<f32x4>,
    /// Triangle by pixel and sample, [`NOTHING`] where none.
    pub(super) triangles: Vec<[u32; 4]>,
}

/// Draws the triangles of a tile.
pub(super) fn draw_tile(
    grid: &TileGrid,
    tile: usize,
    geometry: &Geometry,
    corners: &[Corner],
) -> Samples {
    let mut samples = Samples {
        depths: vec![f32x4::ZERO; TILE * TILE],
        triangles: vec![[NOTHING; 4]; TILE * TILE],
    };
    let origin = grid.origin(tile);
    for &triangle in grid.triangles(tile) {
        let sides = geometry.parts[geometry.part_of(triangle)].sides;
        let points = geometry.triangles[triangle as usize].map(|vertex| corners[vertex as usize]);
        for piece in screen_pieces(points).as_slice() {
            let local = piece.map(|corner| (corner.at - origin).extend(corner.depth));
            samples.cover(local, triangle, sides);
        }
    }
    samples
}

/// `x · across + y · down + offset`, positive on the inner side of an edge.
#[derive(Clone, Copy)]
struct Edge {
    across: f32,
    down: f32,
    offset: f32,
    at_samples: f32x4,
}

impl Edge {
    /// The edge from `a` to `b`. It is worked out from the same end whichever triangle asks, so
    /// that the two triangles at an edge get exactly opposite numbers and leave no gap.
    fn new(a: Vec3, b: Vec3, sign: f32) -> Self {
        let swapped = (b.y, b.x) < (a.y, a.x);
        let (start, end, sign) = if swapped { (b, a, -sign) } else { (a, b, sign) };
        let across = sign * (start.y - end.y);
        let down = sign * (end.x - start.x);
        let offset = sign * (start.x * end.y - start.y * end.x);
        Self {
            across,
            down,
            offset,
            at_samples: f32x4::new(SAMPLE_X) * across + f32x4::new(SAMPLE_Y) * down,
        }
    }

    fn at(&self, x: f32, y: f32) -> f32x4 {
        f32x4::splat(self.across * x + self.down * y + self.offset) + self.at_samples
    }
}

impl Samples {
    /// Enters a triangle (x, y [pixel] in the tile, depth) where it is nearest.
    fn cover(&mut self, [a, b, c]: [Vec3; 3], triangle: u32, sides: Sides) {
        let area = (b - a).truncate().perp_dot((c - a).truncate());
        // Seen from behind where positive: y points down.
        if area == 0.0 || !area.is_finite() || (sides == Sides::Outward && area > 0.0) {
            return;
        }
        let low = a.min(b).min(c);
        let high = a.max(b).max(c);
        let limit = (TILE - 1) as f32;
        if high.x < 0.0 || high.y < 0.0 || low.x > TILE as f32 || low.y > TILE as f32 {
            return;
        }
        let first_x = whole::index(low.x.min(limit));
        let last_x = whole::index(high.x.min(limit));
        let first_y = whole::index(low.y.min(limit));
        let last_y = whole::index(high.y.min(limit));
        let sign = area.signum();
        let edges = [
            Edge::new(a, b, sign),
            Edge::new(b, c, sign),
            Edge::new(c, a, sign),
        ];
        let (ab, ac) = (b - a, c - a);
        let slope_x = (ab.z * ac.y - ac.z * ab.y) / area;
        let slope_y = (ac.z * ab.x - ab.z * ac.x) / area;
        let depth_at_samples = f32x4::new(SAMPLE_X) * slope_x + f32x4::new(SAMPLE_Y) * slope_y;
        let (least, most) = (f32x4::splat(low.z), f32x4::splat(high.z));
        for y in first_y..=last_y {
            for x in first_x..=last_x {
                let (x_at, y_at) = (x as f32, y as f32);
                let [e0, e1, e2] = [0, 1, 2].map(|edge| edges[edge].at(x_at, y_at));
                let inside = e0.fast_min(e1).fast_min(e2).simd_ge(f32x4::ZERO);
                if !inside.any() {
                    continue;
                }
                let flat = a.z + slope_x * (x_at - a.x) + slope_y * (y_at - a.y);
                let depth = f32x4::splat(flat) + depth_at_samples;
                let depth = depth.fast_max(least).fast_min(most);
                let depth = inside.bitselect(depth, -f32x4::ONE);
                self.enter(y * TILE + x, depth, triangle);
            }
        }
    }

    /// Enters a triangle at the samples of a pixel where it is nearest; a negative depth is not
    /// covered.
    fn enter(&mut self, pixel: usize, depth: f32x4, triangle: u32) {
        let nearer = depth.simd_gt(self.depths[pixel]);
        self.depths[pixel] = nearer.bitselect(depth, self.depths[pixel]);
        let mask = nearer.to_bitmask();
        for (sample, seen) in self.triangles[pixel].iter_mut().enumerate() {
            if mask & (1 << sample) != 0 {
                *seen = triangle;
            }
        }
    }
}
