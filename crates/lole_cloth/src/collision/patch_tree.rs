//! Boxes around the patches of a surface, sixteen to a node, and boxes around the nodes: which
//! patches come near each other.
//!
//! The tree is that of the surface and never changes; only its boxes move with the cloth. Patches
//! that follow each other in a surface lie beside each other on it, so boxes stay small however
//! the cloth folds, and a large patch costs what it costs alone.

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::Vec3;
use rayon::prelude::*;

use crate::collision::grid::each_hit;
use crate::collision::surface::{Surface, SurfaceNow};
use crate::lanes::{LANES, Points, Scalars, Vectors, larger, narrow, smaller};

/// Leaves of which one thread finds the neighbors in one go.
const LEAVES_TOGETHER: usize = 64;

/// Sixteen boxes.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Boxes {
    low: [Scalars; 3],
    high: [Scalars; 3],
}

/// A box that nothing meets.
const NOWHERE: Boxes = Boxes {
    low: [Scalars([f32::INFINITY; LANES]); 3],
    high: [Scalars([f32::NEG_INFINITY; LANES]); 3],
};

/// One box.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Bound {
    low: Vec3,
    high: Vec3,
}

impl Boxes {
    #[inline(always)]
    fn get(&self, lane: usize) -> Bound {
        let ([x, y, z], [u, v, w]) = (&self.low, &self.high);
        Bound {
            low: Vec3::new(x.0[lane], y.0[lane], z.0[lane]),
            high: Vec3::new(u.0[lane], v.0[lane], w.0[lane]),
        }
    }

    fn set(&mut self, lane: usize, bound: Bound) {
        for axis in 0..3 {
            self.low[axis].0[lane] = bound.low[axis];
            self.high[axis].0[lane] = bound.high[axis];
        }
    }

    /// The box around all.
    #[inline(always)]
    fn bound(&self) -> Bound {
        let lower = |one: f32, other: f32| if other < one { other } else { one };
        let upper = |one: f32, other: f32| if one < other { other } else { one };
        Bound {
            low: Vec3::from_array(self.low.map(|sides| folded(sides.0, lower))),
            high: Vec3::from_array(self.high.map(|sides| folded(sides.0, upper))),
        }
    }

    /// Which of them meet a box, by bits.
    #[inline(always)]
    fn meet<S: Simd>(&self, simd: S, bound: Bound) -> u64 {
        let mut hits = u64::MAX;
        for axis in 0..3 {
            let low = f32x16::load_array_ref(simd, &self.low[axis].0);
            let high = f32x16::load_array_ref(simd, &self.high[axis].0);
            let begins = low.simd_le(f32x16::splat(simd, bound.high[axis]));
            let ends = f32x16::splat(simd, bound.low[axis]).simd_le(high);
            hits &= begins.to_bitmask() & ends.to_bitmask();
        }
        hits
    }
}

/// One of sixteen values, half and half, so that it takes four vector instructions.
#[inline(always)]
fn folded(mut values: [f32; LANES], choose: impl Fn(f32, f32) -> f32) -> f32 {
    let mut width = LANES / 2;
    while 0 < width {
        for lane in 0..width {
            values[lane] = choose(values[lane], values[lane + width]);
        }
        width /= 2;
    }
    values[0]
}

/// The boxes of a surface at one moment.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct PatchTree {
    /// From the patches up: node `n` of a level holds the nodes, or patches, `16 n` to `16 n + 15`
    /// of the one below. The last level has one node.
    levels: Vec<Vec<Boxes>>,
    /// Both normals of every patch, as long as twice the areas of its triangles [m²].
    normals: Vec<[Points; 2]>,
}

impl PatchTree {
    /// Memory that it holds [byte].
    pub(crate) fn byte_count(&self) -> usize {
        let levels = self.levels.iter().map(|level| size_of_val(&level[..]));
        levels.sum::<usize>() + size_of_val(&self.normals[..])
    }

    /// Normals of a patch, as long as twice the areas of its triangles [m²].
    pub(crate) fn normals(&self, patch: u32) -> [Vec3; 2] {
        let (leaf, lane) = (patch as usize / LANES, patch as usize % LANES);
        let [first, second] = &self.normals[leaf];
        [first.get(lane), second.get(lane)]
    }

    /// Fits all boxes.
    #[inline(always)]
    pub(crate) fn fit<S: Simd>(&mut self, simd: S, now: SurfaceNow<'_>) {
        let leaf_count = now.surface.patches.len().div_ceil(LANES);
        self.levels.resize(level_count(leaf_count), Vec::new());
        let mut count = leaf_count;
        for level in &mut self.levels {
            level.resize(count, NOWHERE);
            count = count.div_ceil(LANES);
        }
        self.normals.resize(leaf_count, <[Points; 2]>::default());
        self.fit_leaves(simd, now);
        for level in 1..self.levels.len() {
            for node in 0..self.levels[level - 1].len() {
                self.carry_up(level, node);
            }
        }
    }

    /// Fits the boxes of some leaves, ascending, and what is above them.
    #[inline(always)]
    pub(crate) fn fit_some<S: Simd>(&mut self, simd: S, now: SurfaceNow<'_>, leaves: &[u32]) {
        for &leaf in leaves {
            let place = leaf as usize;
            let leaves = Leaves {
                first: place,
                boxes: &mut self.levels[0][place..=place],
                normals: &mut self.normals[place..=place],
            };
            leaves.fit(simd, now);
            let mut node = leaf as usize;
            for level in 1..self.levels.len() {
                self.carry_up(level, node);
                node /= LANES;
            }
        }
    }

    /// Tells a level the box around a node of the one below.
    fn carry_up(&mut self, level: usize, node: usize) {
        let bound = self.levels[level - 1][node].bound();
        self.levels[level][node / LANES].set(node % LANES, bound);
    }

    #[inline(always)]
    fn fit_leaves<S: Simd>(&mut self, simd: S, now: SurfaceNow<'_>) {
        let (boxes, normals) = (&mut self.levels[0][..], &mut self.normals[..]);
        if rayon::current_num_threads() == 1 {
            let leaves = Leaves {
                first: 0,
                boxes,
                normals,
            };
            leaves.fit(simd, now);
            return;
        }
        let level = simd.level();
        let starts = (0..).step_by(LEAVES_TOGETHER);
        let boxes = boxes.chunks_mut(LEAVES_TOGETHER);
        let parts = boxes.zip(normals.chunks_mut(LEAVES_TOGETHER)).zip(starts);
        let parts: Vec<_> = parts
            .map(|((boxes, normals), first)| Leaves {
                first,
                boxes,
                normals,
            })
            .collect();
        parts.into_par_iter().for_each(|leaves| {
            fearless_simd::dispatch!(level, simd => leaves.fit(simd, now));
        });
    }

    /// Lists every pair of patches that share no particle and whose boxes meet.
    #[inline(always)]
    pub(crate) fn list_pairs<S: Simd>(
        &self,
        simd: S,
        surface: &Surface,
        pairs: &mut Vec<[u32; 2]>,
    ) {
        let leaves = 0..self.levels.first().map_or(0, Vec::len);
        let mut search = Search::default();
        if rayon::current_num_threads() == 1 {
            for leaf in leaves {
                self.list_pairs_of(simd, surface, leaf, &mut search);
            }
            pairs.append(&mut search.pairs);
            return;
        }
        let level = simd.level();
        let starts: Vec<usize> = leaves.clone().step_by(LEAVES_TOGETHER).collect();
        let pieces: Vec<_> = (starts.into_par_iter())
            .map(|start| {
                let some = start..leaves.end.min(start + LEAVES_TOGETHER);
                fearless_simd::dispatch!(level, simd => self.pairs_of_some(simd, surface, some))
            })
            .collect();
        pairs.extend(pieces.into_iter().flatten());
    }

    #[inline(always)]
    fn pairs_of_some<S: Simd>(
        &self,
        simd: S,
        surface: &Surface,
        leaves: std::ops::Range<usize>,
    ) -> Vec<[u32; 2]> {
        let mut search = Search::default();
        for leaf in leaves {
            self.list_pairs_of(simd, surface, leaf, &mut search);
        }
        search.pairs
    }

    /// Lists the pairs of the patches of a leaf with those of itself and of later leaves.
    #[inline(always)]
    fn list_pairs_of<S: Simd>(&self, simd: S, surface: &Surface, leaf: usize, search: &mut Search) {
        let bound = self.leaf_bound(leaf);
        self.list_leaves(simd, bound, leaf, search);
        for index in 0..search.leaves.len() {
            let other = search.leaves[index];
            self.list_pairs_between(simd, surface, [leaf, other], &mut search.pairs);
        }
    }

    /// Lists the leaves, from `first` on, that a box meets.
    #[inline(always)]
    fn list_leaves<S: Simd>(&self, simd: S, bound: Bound, first: usize, search: &mut Search) {
        let Search { nodes, leaves, .. } = search;
        leaves.clear();
        nodes.clear();
        nodes.push((self.levels.len() - 1, 0));
        while let Some((level, node)) = nodes.pop() {
            if level == 0 {
                leaves.push(node);
                continue;
            }
            let hits = self.levels[level][node].meet(simd, bound);
            // Leaves below a child of this level.
            let width = LANES.pow(narrow(level) - 1);
            for lane in each_hit(hits, LANES) {
                let child = LANES * node + lane;
                if first < (child + 1) * width {
                    nodes.push((level - 1, child));
                }
            }
        }
    }

    /// The box around a leaf, which the level above it has.
    #[inline(always)]
    fn leaf_bound(&self, leaf: usize) -> Bound {
        match self.levels.get(1) {
            Some(above) => above[leaf / LANES].get(leaf % LANES),
            None => self.levels[0][leaf].bound(),
        }
    }

    #[inline(always)]
    fn list_pairs_between<S: Simd>(
        &self,
        simd: S,
        surface: &Surface,
        [leaf, other]: [usize; 2],
        pairs: &mut Vec<[u32; 2]>,
    ) {
        let (own, others) = (&self.levels[0][leaf], &self.levels[0][other]);
        let adjacent = surface.adjacent([narrow(leaf), narrow(other)]);
        let first = narrow(leaf * LANES);
        for lane in each_hit(own.meet(simd, self.leaf_bound(other)), LANES) {
            let mut hits = others.meet(simd, own.get(lane));
            if leaf == other {
                hits &= u64::MAX << (lane + 1);
            }
            if let Some(adjacent) = adjacent {
                hits &= !u64::from(adjacent[lane]);
            }
            for place in each_hit(hits, LANES) {
                pairs.push([first + narrow(lane), narrow(other * LANES + place)]);
            }
        }
    }

    /// Lists what one patch is near to and shares no particle with.
    #[inline(always)]
    pub(crate) fn list_near<S: Simd>(
        &self,
        simd: S,
        surface: &Surface,
        patch: u32,
        search: &mut Search,
    ) {
        let (leaf, lane) = (patch as usize / LANES, patch as usize % LANES);
        let bound = self.levels[0][leaf].get(lane);
        self.list_leaves(simd, bound, 0, search);
        for &other in &search.leaves {
            let hits = self.levels[0][other].meet(simd, bound);
            for place in each_hit(hits, LANES) {
                let pair = [patch, narrow(other * LANES + place)];
                if !surface.share_particle(pair) {
                    search.pairs.push(pair);
                }
            }
        }
    }
}

/// Leaves that follow each other, from one on, and the normals of their patches.
struct Leaves<'a> {
    first: usize,
    boxes: &'a mut [Boxes],
    normals: &'a mut [[Points; 2]],
}

impl Leaves<'_> {
    /// Fits their boxes, and works out their normals.
    #[inline(always)]
    fn fit<S: Simd>(self, simd: S, now: SurfaceNow<'_>) {
        for ((leaf, boxes), normals) in (self.first..).zip(self.boxes).zip(self.normals) {
            let [a, b, c, d] = &corners_of_leaf(now, leaf);
            let (a, b) = (Vectors::load(simd, a), Vectors::load(simd, b));
            let (c, d) = (Vectors::load(simd, c), Vectors::load(simd, d));
            let diagonal = d.sub(a);
            b.sub(a).cross(diagonal).store(&mut normals[0]);
            diagonal.cross(c.sub(a)).store(&mut normals[1]);
            let sides = [
                [a.x, b.x, c.x, d.x],
                [a.y, b.y, c.y, d.y],
                [a.z, b.z, c.z, d.z],
            ];
            for (axis, [a, b, c, d]) in sides.into_iter().enumerate() {
                let low = smaller(smaller(a, b), smaller(c, d));
                let high = larger(larger(a, b), larger(c, d));
                low.store_array(&mut boxes.low[axis].0);
                high.store_array(&mut boxes.high[axis].0);
            }
            let count = now.surface.patches.len();
            for lane in count - (leaf * LANES).min(count)..LANES {
                boxes.set(lane, NOWHERE.get(lane));
            }
        }
    }
}

/// Room for a search.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Search {
    nodes: Vec<(usize, usize)>,
    leaves: Vec<usize>,
    pub(crate) pairs: Vec<[u32; 2]>,
}

/// Levels of a tree of so many leaves.
fn level_count(leaf_count: usize) -> usize {
    let (mut levels, mut count) = (1, leaf_count);
    while 1 < count {
        count = count.div_ceil(LANES);
        levels += 1;
    }
    levels
}

/// Corners of the patches of a leaf, those of the last patch where there are no more.
fn corners_of_leaf(now: SurfaceNow<'_>, leaf: usize) -> [Points; 4] {
    let mut corners = [Points::default(); 4];
    let patches = &now.surface.patches[leaf * LANES..];
    for lane in 0..LANES {
        let patch = &patches[lane.min(patches.len() - 1)];
        for (points, corner) in corners.iter_mut().zip(patch.corners) {
            points.set(lane, now.positions[corner as usize]);
        }
    }
    corners
}
