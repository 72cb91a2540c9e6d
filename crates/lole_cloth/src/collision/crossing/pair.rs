//! Where the edges of one patch cross the triangles of another: first what a plane parts, then what
//! is left by the signs of volumes.

use glam::Vec3;

use super::Crossing;
use crate::collision::exact::goes_through;
use crate::collision::grid::each_hit;
use crate::collision::surface::{PATCH_EDGES, PATCH_TRIANGLES, Surface, SurfaceNow};

/// What lies nearer than this to a triangle [m] may cross it, and is asked exactly: ten times what rounding
/// hides at 2 m from the origin.
const TOUCHING_REACH: f32 = 1.0e-6;

#[inline(always)]
pub(super) fn corners_of(now: SurfaceNow<'_>, patch: u32) -> [Vec3; 4] {
    let SurfaceNow { surface, positions } = now;
    let [a, b, c, d] = surface.patches[patch as usize].corners;
    [
        positions[a as usize],
        positions[b as usize],
        positions[c as usize],
        positions[d as usize],
    ]
}

/// Whether a plane across the line between the middles, or a plane of the first, parts them.
fn are_parted([one, other]: [[Vec3; 4]; 2]) -> bool {
    let across = (other[0] + other[3] + other[1] + other[2]) - (one[0] + one[3] + one[1] + one[2]);
    let [a, b, c, d] = one.map(|corner| corner.dot(across));
    let [e, f, g, h] = other.map(|corner| corner.dot(across));
    if a.max(b).max(c.max(d)) + reach(across) < e.min(f).min(g.min(h)) {
        return true;
    }
    is_beside(one, other) || is_beside(other, one)
}

/// Whether all corners of `other` lie on one side of each triangle of `one`.
fn is_beside([a, b, c, d]: [Vec3; 4], other: [Vec3; 4]) -> bool {
    let diagonal = d - a;
    let is_one_sided = |normal: Vec3| {
        let [p, q, r, s] = other.map(|corner| (corner - a).dot(normal));
        reach(normal) < p.min(q).min(r.min(s)) || p.max(q).max(r.max(s)) < -reach(normal)
    };
    is_one_sided((b - a).cross(diagonal)) && is_one_sided(diagonal.cross(c - a))
}

/// [`TOUCHING_REACH`] along a direction of any length, or a little more.
#[inline(always)]
fn reach(direction: Vec3) -> f32 {
    let [x, y, z] = direction.to_array();
    TOUCHING_REACH * (x.abs() + y.abs() + z.abs())
}

/// Adds every crossing of two patches that may be parted by a plane.
#[inline(always)]
pub(super) fn look_at_pair(now: SurfaceNow<'_>, pair: [u32; 2], crossings: &mut Vec<Crossing>) {
    let corners = [corners_of(now, pair[0]), corners_of(now, pair[1])];
    if !are_parted(corners) {
        cross(now.surface, pair, corners, crossings);
    }
}

/// Adds every crossing of two patches.
#[cold]
#[inline(never)]
pub(super) fn cross(
    surface: &Surface,
    pair: [u32; 2],
    corners: [[Vec3; 4]; 2],
    crossings: &mut Vec<Crossing>,
) {
    for side in [0, 1] {
        let (cut, cutter) = (
            &surface.patches[pair[side] as usize],
            &surface.patches[pair[1 - side] as usize],
        );
        let [cut_seams, seams] =
            [cut, cutter].map(|patch| patch.corners.map(|corner| surface.seam_of(corner)));
        for triangle in PATCH_TRIANGLES {
            let places = triangle.map(|corner| corners[1 - side][corner]);
            let cut_corners = triangle.map(|corner| cutter.corners[corner]);
            // A patch of one triangle has no second.
            if cut_corners[0] == cut_corners[2] {
                continue;
            }
            let at_seams = triangle.map(|corner| seams[corner]);
            let shared = bits(cut_seams, |corner| at_seams.contains(&corner));
            let plane = Plane::new(places);
            let [above, near] = plane.bits(corners[side]);
            let met = BETWEEN[above] | TOUCHING[near];
            let edges = cut.owned_edges() & met & !TOUCHING[shared];
            for edge in each_hit(u64::from(edges), PATCH_EDGES.len()) {
                let ends = PATCH_EDGES[edge];
                let segment = ends.map(|corner| corners[side][corner]);
                let weights = weights_on_line(segment, places);
                let weights = weights.filter(|_| goes_through(segment, places));
                crossings.extend(weights.map(|weights| Crossing {
                    ends: ends.map(|corner| cut.corners[corner]),
                    along: plane.share(segment),
                    corners: cut_corners,
                    weights,
                }));
            }
        }
    }
}

/// By corners of a patch, as bits: its edges from one of them to one that is none of them.
const BETWEEN: [u8; 16] = edges_where(1);

/// And the edges that end at one of them.
const TOUCHING: [u8; 16] = edges_where(2);

/// By corners of a patch, as bits: its edges of which an end is among them, one end alone where
/// `most` is 1.
const fn edges_where(most: usize) -> [u8; 16] {
    let mut table = [0; 16];
    let mut corners = 0;
    while corners < 16 {
        let mut edge = 0;
        while edge < PATCH_EDGES.len() {
            let [start, end] = PATCH_EDGES[edge];
            let count = ((corners >> start) & 1) + ((corners >> end) & 1);
            if 0 < count && count <= most {
                table[corners] |= 1 << edge;
            }
            edge += 1;
        }
        corners += 1;
    }
    table
}

/// For which of four corners something holds, by bits.
#[inline(always)]
fn bits<T>(corners: [T; 4], holds: impl Fn(T) -> bool) -> usize {
    let [a, b, c, d] = corners.map(|corner| usize::from(holds(corner)));
    a | b << 1 | c << 2 | d << 3
}

/// The plane of a triangle.
#[derive(Clone, Copy)]
struct Plane {
    on: Vec3,
    normal: Vec3,
    /// How near to it is on it, times the length of the normal.
    reach: f32,
}

impl Plane {
    #[inline(always)]
    fn new([a, b, c]: [Vec3; 3]) -> Self {
        let normal = (b - a).cross(c - a);
        Self {
            on: a,
            normal,
            reach: reach(normal),
        }
    }

    /// Height over it, times the length of the normal.
    #[inline(always)]
    fn height(&self, place: Vec3) -> f32 {
        (place - self.on).dot(self.normal)
    }

    /// Which corners lie above it, and which on it, by bits.
    #[inline(always)]
    fn bits(&self, corners: [Vec3; 4]) -> [usize; 2] {
        let heights = corners.map(|corner| self.height(corner));
        [
            bits(heights, |height| 0.0 < height),
            bits(heights, |height| height.abs() <= self.reach),
        ]
    }

    /// Share of a segment, whose ends are on both sides or on the plane, up to it.
    #[inline(always)]
    fn share(&self, segment: [Vec3; 2]) -> f32 {
        let [start, end] = segment.map(|end| self.height(end));
        let share = start / (start - end);
        if share.is_finite() {
            share.clamp(0.0, 1.0)
        } else {
            0.5
        }
    }
}

/// Weights of a triangle's corners where a segment is not beside it and its line goes through it, or past one
/// of its sides no farther than [`TOUCHING_REACH`]: by the sides on which that line passes the lines of the
/// triangle's, which is one question for both triangles at a side (Plücker coordinates).
#[inline(always)]
fn weights_on_line([start, end]: [Vec3; 2], [a, b, c]: [Vec3; 3]) -> Option<Vec3> {
    let along = end - start;
    let (mut lowest, mut highest) = (0.0_f32, 0.0_f32);
    let volumes = [[b, c], [c, a], [a, b]].map(|[from, to]| {
        let across = along.cross(to - from);
        let (volume, reach) = (across.dot(from - start), reach(across));
        lowest = lowest.min(volume + reach);
        highest = highest.max(volume - reach);
        volume
    });
    // Beyond one side, and not beyond another: past the triangle.
    if lowest < 0.0 && 0.0 < highest {
        return None;
    }
    if are_apart([start, end], [a, b, c]) {
        return None;
    }
    let sign = if lowest < 0.0 { -1.0 } else { 1.0 };
    let weights = Vec3::from_array(volumes.map(|volume| (sign * volume).max(0.0)));
    let sum = weights.element_sum();
    Some(if 0.0 < sum {
        weights / sum
    } else {
        Vec3::splat(1.0 / 3.0)
    })
}

/// Whether a segment lies beside a triangle, seen across the triangle's plane: where both lie in that plane
/// every line in it passes all others.
fn are_apart(segment: [Vec3; 2], corners: [Vec3; 3]) -> bool {
    let [a, b, c] = corners;
    let normal = (b - a).cross(c - a);
    [b - a, c - b, a - c, segment[1] - segment[0]]
        .into_iter()
        .any(|line| {
            let axis = normal.cross(line);
            let [start, end] = segment.map(|place| (place - a).dot(axis));
            let [p, q, r] = corners.map(|place| (place - a).dot(axis));
            let room = reach(axis);
            start.max(end) + room < p.min(q).min(r) || p.max(q).max(r) + room < start.min(end)
        })
}

/// Share of a segment and weights of a triangle's corners where they cross (Möller and Trumbore
/// 1997).
pub(crate) fn crossing_point([start, end]: [Vec3; 2], [a, b, c]: [Vec3; 3]) -> Option<(f32, Vec3)> {
    let direction = end - start;
    let (ab, ac) = (b - a, c - a);
    let p = direction.cross(ac);
    let determinant = ab.dot(p);
    if determinant == 0.0 {
        return None;
    }
    let from_a = start - a;
    let u = from_a.dot(p) / determinant;
    let q = from_a.cross(ab);
    let v = direction.dot(q) / determinant;
    let along = ac.dot(q) / determinant;
    let is_inside = 0.0 <= u && 0.0 <= v && u + v <= 1.0 && (0.0..=1.0).contains(&along);
    is_inside.then(|| (along, Vec3::new(1.0 - u - v, u, v)))
}
