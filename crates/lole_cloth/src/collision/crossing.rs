//! Where a surface has gone through itself: edges that cross triangles.
//!
//! Patches near each other are found by a tree of boxes. What a plane between two patches or the
//! plane of one of them parts is sorted out first; patches that share a particle are looked at only
//! where the surface turns by more than a right angle around it.

mod fold;
mod pair;

use fearless_simd::{Simd, dispatch};
use glam::Vec3;
use rayon::prelude::*;

use crate::collision::patch_tree::{PatchTree, Search};
use crate::collision::surface::{Surface, SurfaceNow};
use crate::lanes::{LANES, narrow};
use fold::{Stars, Turning, list_folded};
pub(crate) use pair::crossing_point;
use pair::{corners_of, cross, look_at_pair};

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

    /// Finds every crossing of a surface whose positions are finite.
    #[inline(always)]
    pub(crate) fn find_all<S: Simd>(&mut self, simd: S, now: SurfaceNow<'_>) {
        self.tree.fit(simd, now);
        self.near.clear();
        self.tree.list_pairs(simd, now.surface, &mut self.near);
        self.fold_all(simd, now);
        self.effort = 0;
        self.crossings.clear();
        self.look(now);
    }

    /// Lists the patches around all particles where the surface folds.
    #[inline(always)]
    fn fold_all<S: Simd>(&mut self, simd: S, now: SurfaceNow<'_>) {
        self.folded.clear();
        let count = now.surface.particle_count();
        let tree = &self.tree;
        if rayon::current_num_threads() == 1 {
            let turning = Turning { now, tree };
            (self.stars).fold(simd, turning, 0..count, &mut self.folded);
            return;
        }
        let level = simd.level();
        let starts: Vec<usize> = (0..count).step_by(PARTICLES_TOGETHER).collect();
        let pieces: Vec<_> = (starts.into_par_iter())
            .map(|start| {
                let (mut stars, mut folded) = (Stars::default(), Vec::new());
                let some = start..count.min(start + PARTICLES_TOGETHER);
                let turning = Turning { now, tree };
                dispatch!(level, simd => stars.fold(simd, turning, some, &mut folded));
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
        now: SurfaceNow<'_>,
        has_moved: &[bool],
        marked: &Marked,
    ) {
        let surface = now.surface;
        self.tree.fit_some(simd, now, &marked.leaves);
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
            let tree = &self.tree;
            let folds = self.stars.folds(simd, Turning { now, tree }, some);
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
        self.look(now);
        // A patch around what has moved has edges that have not.
        let mut place = 0;
        self.crossings.retain(|crossing| {
            place += 1;
            place <= kept || is_moved(crossing)
        });
    }

    /// Looks at the pairs that were listed, and at the folds, and adds what crosses.
    fn look(&mut self, now: SurfaceNow<'_>) {
        let look = |pairs: &[[u32; 2]], crossings: &mut Vec<Crossing>| {
            for &pair in pairs {
                look_at_pair(now, pair, crossings);
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
            let corners = pair.map(|patch| corners_of(now, patch));
            cross(now.surface, pair, corners, &mut self.crossings);
        }
    }
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
            crimp: None,
        };
        let surface = Surface::from_grid(&grid);
        for amount in [0.0, 0.002, 0.006, 0.015] {
            let mut positions = crumpled(&grid, amount);
            let mut finder = CrossingFinder::default();
            let level = Level::new();
            dispatch!(level, simd => finder.find_all(simd, surface.at(&positions)));
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
            let now = surface.at(&positions);
            dispatch!(level, simd => finder.find_again(simd, now, &has_moved, &marks));
            let again = found(&finder);
            dispatch!(level, simd => finder.find_all(simd, surface.at(&positions)));
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
            dispatch!(Level::new(), simd => finder.find_all(simd, surface.at(&positions)));
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
            dispatch!(Level::new(), simd => finder.find_all(simd, surface.at(&positions)));
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
