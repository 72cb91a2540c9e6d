//! Where a surface has gone through itself: edges that cross triangles.
//!
//! Patches near each other are found by a tree of boxes. What a plane between two patches or the
//! plane of one of them parts is sorted out first; patches that share a particle are looked at only
//! where the surface turns by more than a right angle around it.

use std::ops::Range;

use fearless_simd::{Simd, dispatch, f32x16, prelude::*};
use glam::Vec3;
use rayon::prelude::*;

use crate::collision::exact::goes_through;
use crate::collision::grid::each_hit;
use crate::collision::patch_tree::{PatchTree, Search};
use crate::collision::surface::{PATCH_EDGES, PATCH_TRIANGLES, Surface};
use crate::lanes::{LANES, Points, Vectors, narrow};

/// Cosine of the angle with their sum within which all normals around a particle lie where the
/// surface is flat enough not to cross there.
const FLAT_COSINE: f32 = 0.2;

/// The same where the surface is so flat that it cannot wind around the particle twice either, unless the
/// angles there make up 1.4 full turns: a tilt widens an angle by no more than one over its cosine.
const SURELY_FLAT_COSINE: f32 = 0.7;

/// Quadrants of a full turn, and a little more for rounding.
const FULL_TURN: f32 = 4.0001;

/// What lies nearer than this to a triangle [m] may cross it, and is asked exactly: ten times what rounding
/// hides at 2 m from the origin.
const TOUCHING_REACH: f32 = 1.0e-6;

/// Pairs that one thread looks at in one go.
const PAIRS_TOGETHER: usize = 2048;

/// Particles around which one thread looks for folds in one go.
const PARTICLES_TOGETHER: usize = 2048;

/// An edge that crosses a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Crossing {
    /// Ends of the edge.
    pub(crate) ends: [u32; 2],
    /// Share of the edge up to the crossing, from its first end.
    pub(crate) along: f32,
    /// Corners of the triangle, and their weights at the crossing.
    pub(crate) corners: [u32; 3],
    pub(crate) weights: Vec3,
}

/// Some of the patches.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Marked {
    patches: Vec<u32>,
    is_marked: Vec<bool>,
    /// Leaves in which they lie, ascending.
    leaves: Vec<u32>,
}

impl Marked {
    /// Marks the patches around some particles, and no others.
    pub(crate) fn set(&mut self, surface: &Surface, particles: &[u32]) {
        self.is_marked.clear();
        self.is_marked.resize(surface.patches.len(), false);
        self.patches.clear();
        for &particle in particles {
            for &patch in surface.star(particle as usize) {
                if !self.is_marked[patch as usize] {
                    self.is_marked[patch as usize] = true;
                    self.patches.push(patch);
                }
            }
        }
        self.leaves.clear();
        let leaves = self.patches.iter().map(|patch| patch / narrow(LANES));
        self.leaves.extend(leaves);
        self.leaves.sort_unstable();
        self.leaves.dedup();
    }

    fn has(&self, patch: u32) -> bool {
        self.is_marked[patch as usize]
    }

    /// Memory that it holds [byte].
    pub(crate) const fn byte_count(&self) -> usize {
        self.is_marked.len()
            + size_of_val(self.patches.as_slice())
            + size_of_val(self.leaves.as_slice())
    }
}

/// Finds crossings, and keeps what it needs to look again.
#[derive(Debug, Clone, Default)]
pub(crate) struct CrossingFinder {
    tree: PatchTree,
    search: Search,
    /// Pairs of patches that share no particle and whose boxes meet: of all that were looked at last.
    near: Vec<[u32; 2]>,
    /// Pairs of patches that share a particle around which the surface folds.
    folded: Vec<[u32; 2]>,
    stars: Stars,
    pub(crate) crossings: Vec<Crossing>,
    /// Pairs and patches that were looked at since the last time that all were.
    pub(crate) effort: usize,
}

impl CrossingFinder {
    /// Memory that it holds [byte].
    pub(crate) fn byte_count(&self) -> usize {
        self.tree.byte_count()
            + size_of_val(&self.near[..])
            + size_of_val(&self.folded[..])
            + size_of_val(&self.crossings[..])
    }

    /// Finds every crossing at `positions`, which are finite.
    #[inline(always)]
    pub(crate) fn find_all<S: Simd>(&mut self, simd: S, surface: &Surface, positions: &[Vec3]) {
        self.tree.fit(simd, surface, positions);
        self.near.clear();
        self.tree.list_pairs(simd, surface, &mut self.near);
        self.fold_all(simd, surface, positions);
        self.effort = 0;
        self.crossings.clear();
        self.look(surface, positions);
    }

    /// Lists the patches around all particles where the surface folds.
    #[inline(always)]
    fn fold_all<S: Simd>(&mut self, simd: S, surface: &Surface, positions: &[Vec3]) {
        self.folded.clear();
        let count = surface.particle_count();
        if rayon::current_num_threads() == 1 {
            let stars = &mut self.stars;
            let cloth = (surface, &self.tree, positions);
            stars.fold(simd, cloth, 0..count, &mut self.folded);
            return;
        }
        let level = simd.level();
        let starts: Vec<usize> = (0..count).step_by(PARTICLES_TOGETHER).collect();
        let tree = &self.tree;
        let pieces: Vec<_> = (starts.into_par_iter())
            .map(|start| {
                let (mut stars, mut folded) = (Stars::default(), Vec::new());
                let some = start..count.min(start + PARTICLES_TOGETHER);
                let cloth = (surface, tree, positions);
                dispatch!(level, simd => stars.fold(simd, cloth, some, &mut folded));
                folded
            })
            .collect();
        self.folded.extend(pieces.into_iter().flatten());
    }

    /// Finds what crosses now that some particles have moved since the last time: `has_moved` by particle, and
    /// the patches around those. What else crossed is known and stays.
    #[inline(always)]
    pub(crate) fn find_again<S: Simd>(
        &mut self,
        simd: S,
        (surface, positions): (&Surface, &[Vec3]),
        has_moved: &[bool],
        marked: &Marked,
    ) {
        self.tree.fit_some(simd, surface, positions, &marked.leaves);
        self.near.clear();
        self.search.pairs.clear();
        for &patch in &marked.patches {
            self.tree.list_near(simd, surface, patch, &mut self.search);
        }
        let once = |pair: &&[u32; 2]| pair[0] < pair[1] || !marked.has(pair[1]);
        self.near.extend(self.search.pairs.iter().filter(once));
        self.folded.clear();
        let corners = |&patch: &u32| surface.patches[patch as usize].corners;
        let mut particles: Vec<u32> = marked.patches.iter().flat_map(corners).collect();
        particles.sort_unstable();
        particles.dedup();
        for some in particles.chunks(LANES) {
            let cloth = (surface, &self.tree, positions);
            let folds = self.stars.folds(simd, cloth, some);
            list_folded(surface, some, folds, &mut self.folded);
        }
        self.effort += marked.patches.len();
        let is_moved = |crossing: &Crossing| {
            let [a, b, c] = crossing.corners;
            let particles = [crossing.ends[0], crossing.ends[1], a, b, c];
            particles.iter().any(|&it| has_moved[it as usize])
        };
        self.crossings.retain(|crossing| !is_moved(crossing));
        let kept = self.crossings.len();
        self.look(surface, positions);
        // A patch around what has moved has edges that have not.
        let mut place = 0;
        self.crossings.retain(|crossing| {
            place += 1;
            place <= kept || is_moved(crossing)
        });
    }

    /// Looks at the pairs that were listed, and at the folds, and adds what crosses.
    fn look(&mut self, surface: &Surface, positions: &[Vec3]) {
        let look = |pairs: &[[u32; 2]], crossings: &mut Vec<Crossing>| {
            for &pair in pairs {
                look_at_pair(surface, positions, pair, crossings);
            }
        };
        let pairs = &self.near[..];
        if rayon::current_num_threads() == 1 || pairs.len() <= PAIRS_TOGETHER {
            look(pairs, &mut self.crossings);
        } else {
            // Found in pieces and put together in the order of the pairs.
            let pieces: Vec<_> = (pairs.par_chunks(PAIRS_TOGETHER))
                .map(|pairs| {
                    let mut crossings = Vec::new();
                    look(pairs, &mut crossings);
                    crossings
                })
                .collect();
            self.crossings.extend(pieces.into_iter().flatten());
        }
        self.folded.sort_unstable();
        self.folded.dedup();
        self.effort += self.near.len() + self.folded.len();
        for &pair in &self.folded {
            let corners = pair.map(|patch| corners_of(surface, positions, patch));
            cross(surface, pair, corners, &mut self.crossings);
        }
    }
}

/// Lists the patches around those particles whose bits are set.
fn list_folded(surface: &Surface, particles: &[u32], folds: u64, folded: &mut Vec<[u32; 2]>) {
    for lane in each_hit(folds, particles.len()) {
        let star = surface.star(particles[lane] as usize);
        for (place, &one) in star.iter().enumerate() {
            let others = star[place + 1..].iter();
            folded.extend(others.map(|&other| [one, other]));
        }
    }
}

/// Room for the normals around sixteen particles.
#[derive(Debug, Clone, Default, PartialEq)]
struct Stars(Vec<[Points; 2]>);

impl Stars {
    /// Lists the patches around those particles of a range where the surface folds.
    #[inline(always)]
    fn fold<S: Simd>(
        &mut self,
        simd: S,
        cloth: (&Surface, &PatchTree, &[Vec3]),
        particles: Range<usize>,
        folded: &mut Vec<[u32; 2]>,
    ) {
        for start in particles.clone().step_by(LANES) {
            let mut some = [0; LANES];
            let count = LANES.min(particles.end - start);
            for (particle, place) in (start..).zip(&mut some[..count]) {
                *place = narrow(particle);
            }
            let folds = self.folds(simd, cloth, &some[..count]);
            list_folded(cloth.0, &some[..count], folds, folded);
        }
    }

    /// Which of at most sixteen particles have normals around them that do not all lie in one
    /// half-space, and well within it, or cloth that winds around them more than once.
    #[inline(always)]
    fn folds<S: Simd>(
        &mut self,
        simd: S,
        (surface, tree, positions): (&Surface, &PatchTree, &[Vec3]),
        particles: &[u32],
    ) -> u64 {
        self.gather(surface, tree, particles);
        let mut sum = Vectors::splat(simd, Vec3::ZERO);
        for points in self.0.iter().flatten() {
            sum = sum.add(Vectors::load(simd, points));
        }
        let [limit, sure] = [FLAT_COSINE, SURELY_FLAT_COSINE]
            .map(|cosine| sum.dot(sum) * f32x16::splat(simd, cosine * cosine));
        let (mut flat, mut surely_flat) = (u64::MAX, u64::MAX);
        for points in self.0.iter().flatten() {
            let normal = Vectors::load(simd, points);
            let along = sum.dot(normal);
            let is_ahead = f32x16::splat(simd, 0.0).simd_le(along);
            let [is_within, is_sure] =
                [limit, sure].map(|limit| (limit * normal.dot(normal)).simd_le(along * along));
            flat &= is_ahead.to_bitmask() & is_within.to_bitmask();
            surely_flat &= is_sure.to_bitmask();
        }
        for lane in each_hit(flat & !surely_flat, particles.len()) {
            if winds_twice(surface, positions, particles[lane]) {
                flat &= !(1 << lane);
            }
        }
        !flat
    }

    /// Where a star has fewer patches than others, its last stands in their place.
    #[inline(never)]
    fn gather(&mut self, surface: &Surface, tree: &PatchTree, particles: &[u32]) {
        self.0.clear();
        for (lane, &particle) in particles.iter().enumerate() {
            let star = surface.star(particle as usize);
            let Some(&last) = star.last() else { continue };
            while self.0.len() < star.len() {
                // Earlier lanes have nothing to add here.
                let repeated = self.0.last().copied().unwrap_or_default();
                self.0.push(repeated);
            }
            for (place, points) in self.0.iter_mut().enumerate() {
                let patch = star.get(place).copied().unwrap_or(last);
                let normals = tree.normals(patch);
                points[0].set(lane, normals[0]);
                points[1].set(lane, normals[1]);
            }
        }
    }
}

/// Whether cloth whose normals around a particle lie in one half-space winds around it more than once: seen
/// along their sum, what its triangles turn through is more than a full turn.
#[cold]
#[inline(never)]
fn winds_twice(surface: &Surface, positions: &[Vec3], particle: u32) -> bool {
    let triangles = || {
        let star = surface.star(particle as usize).iter();
        star.flat_map(|&patch| surface.sides_at(patch, particle))
    };
    let at = positions[particle as usize];
    let sides = |[from, to]: [u32; 2]| [from, to].map(|corner| positions[corner as usize] - at);
    let sum: Vec3 = triangles()
        .map(sides)
        .map(|[from, to]| from.cross(to))
        .sum();
    let across = sum.any_orthogonal_vector();
    let axes = [across, sum.cross(across) / sum.length()];
    // Goes around with the angle, from 0 to 4, without the cost of one.
    let turned = |side: Vec3| {
        let [x, y] = axes.map(|axis| side.dot(axis));
        let share = y / (x.abs() + y.abs());
        if x < 0.0 { 2.0 - share } else { share }
    };
    let through = triangles().map(sides).map(|[from, to]| {
        let angle = turned(to) - turned(from);
        if angle < 0.0 { angle + 4.0 } else { angle }
    });
    // What has no direction folds.
    let is_once = through.sum::<f32>() <= FULL_TURN;
    !is_once
}

#[inline(always)]
fn corners_of(surface: &Surface, positions: &[Vec3], patch: u32) -> [Vec3; 4] {
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
fn look_at_pair(
    surface: &Surface,
    positions: &[Vec3],
    pair: [u32; 2],
    crossings: &mut Vec<Crossing>,
) {
    let corners = [
        corners_of(surface, positions, pair[0]),
        corners_of(surface, positions, pair[1]),
    ];
    if !are_parted(corners) {
        cross(surface, pair, corners, crossings);
    }
}

/// Adds every crossing of two patches.
#[cold]
#[inline(never)]
fn cross(
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

#[cfg(test)]
mod tests {
    use fearless_simd::Level;
    use glam::DVec3;
    use lole_geom::triangle_grid::blend;

    use super::*;
    use crate::collision::exact::goes_through;
    use crate::{Grid, Topology, diagnose};

    /// A tube that is crumpled at random, more and more, with some cells far larger than others.
    fn crumpled(grid: &Grid, amount: f32) -> Vec<Vec3> {
        let mut state = 11_u32;
        let mut noise = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / 8_388_608.0 - 1.0
        };
        let ring = crate::scenes::waved_ring(0.05, 0.32, grid.column_count, 5.0);
        let mut positions = Vec::new();
        for row in 0..grid.row_count {
            for &[x, z] in &ring {
                let jump = if noise() < -0.99 { 5.0 } else { 1.0 };
                let shift = Vec3::new(noise(), noise(), noise()) * (amount * jump);
                positions.push(DVec3::new(x, 0.01 * f64::from(row), z).as_vec3() + shift);
            }
        }
        positions
    }

    fn found(finder: &CrossingFinder) -> Vec<([u32; 2], [u32; 3])> {
        let mut found: Vec<_> = (finder.crossings.iter())
            .map(|crossing| {
                let mut corners = crossing.corners;
                corners.sort_unstable();
                (crossing.ends, corners)
            })
            .collect();
        found.sort_unstable();
        found
    }

    /// All that cross are found, once, and besides some that only touch.
    fn check_count(finder: &CrossingFinder, grid: &Grid, positions: &[Vec3]) {
        let count = diagnose::self_crossings(grid, positions).expect("finite");
        let mut all = found(finder);
        all.dedup();
        assert_eq!(all.len(), finder.crossings.len());
        let most = count + count / 200;
        assert!(
            (count..=most).contains(&all.len()),
            "{count}: {}",
            all.len()
        );
    }

    #[test]
    fn every_crossing_is_found_once_and_again_after_a_move() {
        let grid = Grid {
            column_count: 32,
            row_count: 16,
            topology: Topology::Tube,
            spacing: [0.01; 2],
            flounce: None,
        };
        let surface = Surface::from_grid(&grid);
        for amount in [0.0, 0.002, 0.006, 0.015] {
            let mut positions = crumpled(&grid, amount);
            let mut finder = CrossingFinder::default();
            let level = Level::new();
            dispatch!(level, simd => finder.find_all(simd, &surface, &positions));
            check_count(&finder, &grid, &positions);
            // One row is pulled across the tube.
            let moved = (0..grid.column_count).map(|column| grid.index(7, column));
            let moved: Vec<u32> = moved.map(narrow).collect();
            for &particle in &moved {
                positions[particle as usize].x += 0.03;
            }
            let mut marks = Marked::default();
            marks.set(&surface, &moved);
            let mut has_moved = vec![false; positions.len()];
            moved.iter().for_each(|&it| has_moved[it as usize] = true);
            let cloth = (&surface, &positions[..]);
            dispatch!(level, simd => finder.find_again(simd, cloth, &has_moved, &marks));
            let again = found(&finder);
            dispatch!(level, simd => finder.find_all(simd, &surface, &positions));
            check_count(&finder, &grid, &positions);
            assert_eq!(
                found(&finder),
                again,
                "each once, and what has not moved too"
            );
        }
    }

    #[test]
    fn what_goes_through_by_a_hair_is_found_whatever_rounding_says() {
        let surface = Surface::new(6, &[[0, 1, 2], [3, 4, 5]]);
        let mut chance = lole_geom::Chance::new(9);
        let mut point = |size: f32| Vec3::from_array([(); 3].map(|()| chance.between(-size, size)));
        let mut through = 0;
        for _ in 0..4000 {
            let middle = point(1.5);
            let corners = [(); 3].map(|()| middle + point(0.01));
            let weights = point(1.0).abs() + Vec3::splat(0.02);
            let weights = weights / weights.element_sum();
            // A vertex that lies on the triangle but for rounding, and two on either side.
            let on = blend(corners, weights) + point(2.0e-7);
            let positions = [
                corners.to_vec(),
                vec![on, on + point(0.01), on + point(0.01)],
            ]
            .concat();
            let mut finder = CrossingFinder::default();
            dispatch!(Level::new(), simd => finder.find_all(simd, &surface, &positions));
            for ends in [[3, 4], [3, 5]] {
                let segment = ends.map(|end| positions[end]);
                if goes_through(segment, corners) {
                    through += 1;
                    let ends = ends.map(narrow);
                    let is_found = finder.crossings.iter().any(|it| it.ends == ends);
                    assert!(is_found, "{segment:?} {corners:?}");
                }
            }
        }
        assert!(1000 < through, "{through}");
    }

    #[test]
    fn edges_that_end_in_a_seam_do_not_cross_what_they_are_sewn_to() {
        // Two pieces of a triangle each. An edge of the second goes through the first near its corner,
        // as it does beside a stitch that is not quite tight, and another one far from that.
        let positions = [
            Vec3::ZERO,
            Vec3::new(0.03, 0.0, 0.0),
            Vec3::new(0.0, 0.0, 0.03),
            Vec3::new(0.001, -0.0005, 0.001),
            Vec3::new(0.006, 0.02, 0.006),
            Vec3::new(0.012, -0.02, 0.012),
        ];
        let mut surface = Surface::new(6, &[[0, 1, 2], [3, 4, 5]]);
        let look = |surface: &Surface| {
            let mut finder = CrossingFinder::default();
            dispatch!(Level::new(), simd => finder.find_all(simd, surface, &positions));
            let cut = finder.crossings.iter().map(|crossing| crossing.ends);
            cut.collect::<Vec<_>>()
        };
        let mut apart = look(&surface);
        apart.sort_unstable();
        assert_eq!(apart, [[3, 4], [4, 5]]);
        surface.sew([[0, 3]]);
        assert_eq!(look(&surface), [[4, 5]]);
        // A stitch with a third particle sews all three.
        let mut row = Surface::new(9, &[[0, 1, 2], [3, 4, 5], [6, 7, 8]]);
        row.sew([[6, 3], [3, 0]]);
        assert_eq!(
            [0, 3, 6, 7].map(|particle| row.seam_of(particle)),
            [0, 0, 0, 7]
        );
    }
}
