//! Where a surface has gone through itself: edges that cross triangles.
//!
//! Patches near each other are found by their boxes, in vectors. What a plane between two patches
//! or the plane of one of them parts is sorted out first; patches that share a particle are looked
//! at only where the surface turns by more than a right angle around it.

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::Vec3;
use rayon::prelude::*;

use crate::collision::grid::{CellGrid, Entry, each_hit};
use crate::collision::surface::{ABSENT, PATCH_EDGES, PATCH_TRIANGLES, Surface};
use crate::lanes::LANES;

/// Half of the size of a cell over half of that of a patch on the mean: few patches are larger.
const USUAL_SIZE: f32 = 2.0;

/// Cosine of the angle with their sum within which all normals around a particle lie where the
/// surface is flat enough not to cross there.
const FLAT_COSINE: f32 = 0.2;

/// Pairs that one thread looks at in one go.
const PAIRS_TOGETHER: usize = 2048;

/// An edge that crosses a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Crossing {
    /// Edge of the surface.
    pub(crate) edge: u32,
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
    }

    fn has(&self, patch: u32) -> bool {
        self.is_marked[patch as usize]
    }

    /// Memory that it holds [byte].
    pub(crate) const fn byte_count(&self) -> usize {
        self.is_marked.len() + size_of_val(self.patches.as_slice())
    }
}

/// Boxes around patches in the order of the cells, and room for a vector beyond the last.
#[derive(Debug, Clone, Default, PartialEq)]
struct Boxes {
    centers: [Vec<f32>; 3],
    /// Half of the extents [m].
    halves: [Vec<f32>; 3],
}

/// Finds crossings, and keeps what it needs to look again.
#[derive(Debug, Clone, Default)]
pub(crate) struct CrossingFinder {
    centers: Vec<Vec3>,
    halves: Vec<Vec3>,
    cells: CellGrid,
    boxes: Boxes,
    /// Half of the size of a cell [m]; what is larger stands in `large`, by entries.
    usual: f32,
    large: Vec<u32>,
    /// Last patch of which every patch was found to be a neighbor.
    stamps: Vec<u32>,
    /// Room for a mark for patches that are not where they were sorted, and for their order along x.
    along_x: Vec<(f32, u32)>,
    is_apart: Vec<bool>,
    /// Of both triangles of every patch.
    normals: Vec<[Vec3; 2]>,
    /// Pairs of patches that share no particle and may come to cross.
    near: Vec<[u32; 2]>,
    /// Pairs of patches that share a particle around which the surface folds.
    folded: Vec<[u32; 2]>,
    pub(crate) crossings: Vec<Crossing>,
}

impl CrossingFinder {
    /// Memory that it holds [byte].
    pub(crate) fn byte_count(&self) -> usize {
        size_of_val(&self.centers[..])
            + size_of_val(&self.halves[..])
            + self.cells.byte_count()
            + 6 * size_of_val(&self.boxes.centers[0][..])
            + size_of_val(&self.near[..])
            + size_of_val(&self.folded[..])
    }

    /// Lists the patches that come as near each other as `margin` [m]; `positions` are finite.
    #[inline(always)]
    pub(crate) fn look_around<S: Simd>(
        &mut self,
        simd: S,
        surface: &Surface,
        positions: &[Vec3],
        margin: f32,
    ) {
        self.find_boxes(surface, positions, margin);
        let Self {
            cells,
            boxes,
            near,
            stamps,
            ..
        } = self;
        near.clear();
        stamps.clear();
        stamps.resize(surface.patches.len(), u32::MAX);
        for index in 0..cells.entries.len() {
            let first = cells.entries[index].particle;
            for &neighbor in surface.neighbors(first) {
                stamps[neighbor as usize] = first;
            }
            let own = OwnBox::splat(simd, boxes, index);
            cells.following_runs(
                index,
                #[inline(always)]
                |start, run| {
                    for from in (0..run.len()).step_by(LANES) {
                        let hits = own.overlaps(simd, boxes, start + from);
                        let rest = &run[from..];
                        let strangers =
                            hits_of(hits, rest).filter(|&patch| stamps[patch as usize] != first);
                        near.extend(strangers.map(|patch| [first, patch]));
                    }
                },
            );
        }
        let large = self.large.clone();
        self.list_near(surface, &large, 0.0);
    }

    /// Looks anew for what is near the marked patches, which have moved.
    pub(crate) fn look_at(
        &mut self,
        surface: &Surface,
        (positions, margin): (&[Vec3], f32),
        marked: &Marked,
    ) {
        let mut shift = 0.0_f32;
        for &patch in &marked.patches {
            let place = patch as usize;
            let before = self.centers[place];
            self.set_box(surface, positions, (patch, margin));
            shift = shift.max((self.centers[place] - before).abs().max_element());
        }
        self.near
            .retain(|pair| !pair.iter().any(|&patch| marked.has(patch)));
        self.list_near(surface, &marked.patches, shift);
    }

    /// Lists what is near some patches, which are not where they were sorted: they and their
    /// neighbors may have moved by `shift` [m] since, and be larger than cells.
    fn list_near(&mut self, surface: &Surface, patches: &[u32], shift: f32) {
        if patches.is_empty() {
            return;
        }
        let Self {
            centers,
            halves,
            cells,
            near,
            along_x,
            is_apart,
            usual,
            large,
            ..
        } = self;
        is_apart.clear();
        is_apart.resize(centers.len(), false);
        for &patch in patches {
            is_apart[patch as usize] = true;
        }
        let mut add = |pair: [u32; 2]| {
            let [one, other] = pair.map(|patch| patch as usize);
            let apart = (centers[other] - centers[one]).abs();
            if apart.cmple(halves[one] + halves[other]).all() && !surface.share_particle(pair) {
                near.push(pair);
            }
        };
        for &patch in patches {
            let center = centers[patch as usize];
            let reach = halves[patch as usize] + Vec3::splat(*usual + shift);
            cells.runs_within([center - reach, center + reach], |run| {
                for other in run
                    .iter()
                    .filter(|other| !is_apart[other.particle as usize])
                {
                    add([patch, other.particle]);
                }
            });
            for &other in large.iter().filter(|&&other| !is_apart[other as usize]) {
                add([patch, other]);
            }
        }
        along_x.clear();
        let low = |&patch: &u32| (centers[patch as usize].x - halves[patch as usize].x, patch);
        along_x.extend(patches.iter().map(low));
        along_x.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
        for (place, &(_, patch)) in along_x.iter().enumerate() {
            let high = centers[patch as usize].x + halves[patch as usize].x;
            let beside = along_x[place + 1..].iter();
            for &(_, other) in beside.take_while(|&&(low, _)| low <= high) {
                add([patch, other]);
            }
        }
    }

    /// Sorts the boxes around all patches. The larger ones are told apart: `boxes` has nothing in
    /// their place.
    fn find_boxes(&mut self, surface: &Surface, positions: &[Vec3], margin: f32) {
        let count = surface.patches.len();
        self.centers.resize(count, Vec3::ZERO);
        self.halves.resize(count, Vec3::ZERO);
        let mut sum = 0.0;
        for patch in 0..narrow(count) {
            self.set_box(surface, positions, (patch, margin));
            sum += self.halves[patch as usize].max_element();
        }
        #[expect(clippy::cast_precision_loss, reason = "patches are fewer than 2^24")]
        let usual = USUAL_SIZE * sum / count.max(1) as f32;
        self.usual = usual;
        self.cells.sort(&self.centers, 1, 2.0 * usual);
        let (entries, halves, boxes) = (&self.cells.entries, &self.halves, &mut self.boxes);
        let columns = boxes.centers.iter_mut().zip(&mut boxes.halves);
        for (axis, (center, half)) in columns.enumerate() {
            center.clear();
            center.extend(entries.iter().map(|entry| entry.position[axis]));
            center.resize(count + LANES, f32::INFINITY);
            half.clear();
            half.extend(
                entries
                    .iter()
                    .map(|entry| halves[entry.particle as usize][axis]),
            );
            half.resize(count + LANES, 0.0);
        }
        self.large.clear();
        for (index, entry) in entries.iter().enumerate() {
            if usual < halves[entry.particle as usize].max_element() {
                self.large.push(entry.particle);
                boxes.centers[0][index] = f32::INFINITY;
            }
        }
    }

    fn set_box(&mut self, surface: &Surface, positions: &[Vec3], (patch, margin): (u32, f32)) {
        let [a, b, c, d] = corners_of(surface, positions, patch);
        let low = a.min(b).min(c.min(d));
        let high = a.max(b).max(c.max(d));
        self.centers[patch as usize] = (low + high) * 0.5;
        self.halves[patch as usize] = (high - low) * 0.5 + Vec3::splat(0.5 * margin);
    }

    /// Finds the crossings at `positions` among the patches that were near, `within` those marked.
    pub(crate) fn find(&mut self, surface: &Surface, positions: &[Vec3], within: Option<&Marked>) {
        self.crossings.clear();
        self.find_folded(surface, positions, within);
        let look = |pairs: &[[u32; 2]], crossings: &mut Vec<Crossing>| {
            for &pair in pairs {
                if within.is_none_or(|marked| pair.iter().any(|&patch| marked.has(patch))) {
                    look_at_pair(surface, positions, pair, crossings);
                }
            }
        };
        if rayon::current_num_threads() == 1 {
            look(&self.near, &mut self.crossings);
        } else {
            // Found in pieces and put together in the order of the pairs.
            let pieces: Vec<_> = (self.near.par_chunks(PAIRS_TOGETHER))
                .map(|pairs| {
                    let mut crossings = Vec::new();
                    look(pairs, &mut crossings);
                    crossings
                })
                .collect();
            self.crossings.extend(pieces.into_iter().flatten());
        }
        for &pair in &self.folded {
            let corners = pair.map(|patch| corners_of(surface, positions, patch));
            cross(surface, pair, corners, &mut self.crossings);
        }
    }

    /// Lists the patches around every particle where normals do not lie in one half-space.
    fn find_folded(&mut self, surface: &Surface, positions: &[Vec3], within: Option<&Marked>) {
        self.folded.clear();
        if let Some(marked) = within {
            for &patch in &marked.patches {
                self.normals[patch as usize] = normals_of(surface, positions, patch);
            }
            let corners = |&patch: &u32| surface.patches[patch as usize].corners;
            let mut particles: Vec<u32> = marked.patches.iter().flat_map(corners).collect();
            particles.sort_unstable();
            particles.dedup();
            for particle in particles {
                self.find_folded_at(surface.star(particle as usize));
            }
        } else {
            self.normals.clear();
            let patches = 0..narrow(surface.patches.len());
            (self.normals).extend(patches.map(|patch| normals_of(surface, positions, patch)));
            for particle in 0..surface.particle_count() {
                self.find_folded_at(surface.star(particle));
            }
        }
        self.folded.sort_unstable();
        self.folded.dedup();
    }

    fn find_folded_at(&mut self, star: &[u32]) {
        if !self.is_flat(star) {
            for (place, &one) in star.iter().enumerate() {
                let others = star[place + 1..].iter();
                self.folded.extend(others.map(|&other| [one, other]));
            }
        }
    }

    /// Whether the normals of all patches lie in one half-space, and well within it.
    fn is_flat(&self, star: &[u32]) -> bool {
        let normals = || star.iter().flat_map(|&patch| self.normals[patch as usize]);
        let sum: Vec3 = normals().sum();
        let limit = FLAT_COSINE * FLAT_COSINE * sum.length_squared();
        normals().all(|normal| {
            let along = sum.dot(normal);
            0.0 <= along && limit * normal.length_squared() <= along * along
        })
    }
}

/// Normals of both triangles of a patch, as long as twice their areas [m²].
fn normals_of(surface: &Surface, positions: &[Vec3], patch: u32) -> [Vec3; 2] {
    let [a, b, c, d] = corners_of(surface, positions, patch);
    let diagonal = d - a;
    [(b - a).cross(diagonal), diagonal.cross(c - a)]
}

/// Patches of the entries whose bits are set.
#[inline(always)]
fn hits_of(hits: u64, run: &[Entry]) -> impl Iterator<Item = u32> {
    each_hit(hits, run.len()).map(|place| run[place].particle)
}

/// The box of one patch in every lane.
struct OwnBox<S: Simd> {
    center: [f32x16<S>; 3],
    half: [f32x16<S>; 3],
}

impl<S: Simd> OwnBox<S> {
    #[inline(always)]
    fn splat(simd: S, boxes: &Boxes, index: usize) -> Self {
        let [x, y, z] = &boxes.centers;
        let [u, v, w] = &boxes.halves;
        Self {
            center: [
                f32x16::splat(simd, x[index]),
                f32x16::splat(simd, y[index]),
                f32x16::splat(simd, z[index]),
            ],
            half: [
                f32x16::splat(simd, u[index]),
                f32x16::splat(simd, v[index]),
                f32x16::splat(simd, w[index]),
            ],
        }
    }

    /// Which of the boxes from `start` on overlap with it, by bits.
    #[inline(always)]
    fn overlaps(&self, simd: S, boxes: &Boxes, start: usize) -> u64 {
        let mut overlaps = u64::MAX;
        for axis in 0..3 {
            let center = f32x16::from_slice(simd, &boxes.centers[axis][start..start + LANES]);
            let half = f32x16::from_slice(simd, &boxes.halves[axis][start..start + LANES]);
            let apart = (center - self.center[axis]).abs();
            overlaps &= apart.simd_le(half + self.half[axis]).to_bitmask();
        }
        overlaps
    }
}

#[inline(always)]
fn corners_of(surface: &Surface, positions: &[Vec3], patch: u32) -> [Vec3; 4] {
    surface.patches[patch as usize]
        .corners
        .map(|corner| positions[corner as usize])
}

/// Whether a plane across the line between the middles, or a plane of the first, parts them.
fn are_parted([one, other]: [[Vec3; 4]; 2]) -> bool {
    let across = (other[0] + other[3] + other[1] + other[2]) - (one[0] + one[3] + one[1] + one[2]);
    let [a, b, c, d] = one.map(|corner| corner.dot(across));
    let [e, f, g, h] = other.map(|corner| corner.dot(across));
    if a.max(b).max(c.max(d)) < e.min(f).min(g.min(h)) {
        return true;
    }
    is_beside(one, other) || is_beside(other, one)
}

/// Whether all corners of `other` lie on one side of each triangle of `one`.
fn is_beside([a, b, c, d]: [Vec3; 4], other: [Vec3; 4]) -> bool {
    let diagonal = d - a;
    let is_one_sided = |normal: Vec3| {
        let [p, q, r, s] = other.map(|corner| (corner - a).dot(normal));
        0.0 < p.min(q).min(r.min(s)) || p.max(q).max(r.max(s)) < 0.0
    };
    is_one_sided((b - a).cross(diagonal)) && is_one_sided(diagonal.cross(c - a))
}

/// Adds every crossing of two patches that may be parted by a plane.
#[inline(always)]
fn look_at_pair(
    surface: &Surface,
    positions: &[Vec3],
    pair: [u32; 2],
    crossings: &mut Vec<Crossing>,
) {
    let corners = pair.map(|patch| corners_of(surface, positions, patch));
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
        for (ends, &edge) in PATCH_EDGES.iter().zip(&cut.edges) {
            if edge == ABSENT {
                continue;
            }
            let particles = ends.map(|corner| cut.corners[corner]);
            let segment = ends.map(|corner| corners[side][corner]);
            let is_turned = surface.edges[edge as usize].ends != particles;
            crossings.extend(PATCH_TRIANGLES.into_iter().filter_map(|triangle| {
                let cut_corners = triangle.map(|corner| cutter.corners[corner]);
                if particles.iter().any(|end| cut_corners.contains(end)) {
                    return None;
                }
                let places = triangle.map(|corner| corners[1 - side][corner]);
                let (along, weights) = crossing_point(segment, places)?;
                Some(Crossing {
                    edge,
                    along: if is_turned { 1.0 - along } else { along },
                    corners: cut_corners,
                    weights,
                })
            }));
        }
    }
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

#[expect(
    clippy::cast_possible_truncation,
    reason = "a surface has fewer than 2^32 patches"
)]
const fn narrow(value: usize) -> u32 {
    value as u32
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};
    use glam::DVec3;

    use super::*;
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

    fn found(finder: &CrossingFinder) -> Vec<(u32, [u32; 3])> {
        let mut found: Vec<_> = (finder.crossings.iter())
            .map(|crossing| {
                let mut corners = crossing.corners;
                corners.sort_unstable();
                (crossing.edge, corners)
            })
            .collect();
        found.sort_unstable();
        found
    }

    #[test]
    fn every_crossing_is_found_once_and_again_after_a_move() {
        let grid = Grid {
            column_count: 32,
            row_count: 16,
            topology: Topology::Tube,
            spacing: [0.01; 2],
        };
        let surface = Surface::from_grid(&grid);
        for amount in [0.0, 0.002, 0.006, 0.015] {
            let mut positions = crumpled(&grid, amount);
            let mut finder = CrossingFinder::default();
            let level = Level::new();
            dispatch!(level, simd => finder.look_around(simd, &surface, &positions, 0.001));
            finder.find(&surface, &positions, None);
            let count = diagnose::self_crossings(&grid, &positions);
            assert_eq!(Some(finder.crossings.len()), count, "crumpled by {amount}");
            // One row is pulled across the tube.
            let moved = (0..grid.column_count).map(|column| grid.index(7, column));
            let moved: Vec<u32> = moved.map(narrow).collect();
            for &particle in &moved {
                positions[particle as usize].x += 0.03;
            }
            let mut marks = Marked::default();
            marks.set(&surface, &moved);
            finder.look_at(&surface, (&positions, 0.001), &marks);
            finder.find(&surface, &positions, Some(&marks));
            let moved = found(&finder);
            dispatch!(level, simd => finder.look_around(simd, &surface, &positions, 0.001));
            finder.find(&surface, &positions, None);
            let mut all = found(&finder);
            assert_eq!(Some(all.len()), diagnose::self_crossings(&grid, &positions));
            all.retain(|crossing| moved.contains(crossing));
            assert_eq!(all, moved, "no crossing is found twice");
        }
    }
}
