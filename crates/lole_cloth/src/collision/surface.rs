//! A surface made of triangles, cut into patches of two: what contact and crossings are looked for
//! in, whether it is one grid of cloth, several layers or any other mesh.

use glam::Vec3;

use crate::Grid;
use crate::lanes::{LANES, narrow};

/// Both triangles of a patch, by corners.
pub(crate) const PATCH_TRIANGLES: [[usize; 3]; 2] = [[0, 1, 3], [0, 3, 2]];

/// The five edges of a patch, by corners; the third is the one that both triangles share.
pub(crate) const PATCH_EDGES: [[usize; 2]; 5] = [[0, 1], [0, 2], [0, 3], [1, 3], [2, 3]];

/// Two triangles that share an edge, or one: then the third corner is the first once more.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Patch {
    pub(crate) corners: [u32; 4],
    /// Which of [`PATCH_EDGES`] are its own, by bits: every edge belongs to one patch.
    owned: u8,
}

impl Patch {
    /// Which of [`PATCH_EDGES`] are its own, by bits.
    pub(crate) const fn owned_edges(&self) -> u8 {
        self.owned
    }
}

/// Topology of a surface; it never changes.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Surface {
    pub(crate) patches: Vec<Patch>,
    /// First entry of every particle in `star_patches`, and one more.
    star_starts: Vec<u32>,
    star_patches: Vec<u32>,
    /// First entry of every leaf in `adjacent`, those that it shares particles with, and one more.
    adjacent_starts: Vec<u32>,
    adjacent: Vec<Adjacent>,
    /// By particle, the first of those that are sewn to each other; empty where nothing is sewn.
    sewn_to: Vec<u32>,
}

/// A leaf, sixteen patches that follow each other, beside another or the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Adjacent {
    leaf: u32,
    /// By patch of the first leaf, which patches of this one share a particle with it.
    shared: [u16; LANES],
}

/// A surface as it lies at one moment.
#[derive(Clone, Copy)]
pub(crate) struct SurfaceNow<'a> {
    pub(crate) surface: &'a Surface,
    /// By particle [m].
    pub(crate) positions: &'a [Vec3],
}

impl Surface {
    /// The surface with its particles at these positions [m].
    pub(crate) const fn at<'a>(&'a self, positions: &'a [Vec3]) -> SurfaceNow<'a> {
        SurfaceNow {
            surface: self,
            positions,
        }
    }

    /// The triangles of a grid, every cell cut from upper left to lower right: sixteen columns of
    /// it from top to bottom, then the next.
    pub(crate) fn from_grid(grid: &Grid) -> Self {
        let triangles = grid.triangles();
        let (cells, rest) = triangles.as_chunks::<2>();
        debug_assert!(rest.is_empty(), "every cell has two triangles");
        let mut cells: Vec<_> = cells.iter().collect();
        let place = |cell: &[[u32; 3]; 2]| {
            let column = cell[0][0] % grid.column_count;
            (column / narrow(LANES), cell[0][0])
        };
        cells.sort_by_key(|cell| place(cell));
        let triangles: Vec<[u32; 3]> = cells.into_iter().flatten().copied().collect();
        Self::new(grid.particle_count(), &triangles)
    }

    /// A surface over particles `0..particle_count`; triangles that follow each other are best
    /// close to each other, in sixteens and in powers of sixteen.
    pub(crate) fn new(particle_count: usize, triangles: &[[u32; 3]]) -> Self {
        let (edges, triangle_edges) = find_edges(triangles);
        let mut surface = Self {
            patches: pair_triangles(triangles, &triangle_edges, &edges),
            ..Self::default()
        };
        surface.find_stars(particle_count);
        surface.find_adjacent();
        surface
    }

    /// Several surfaces as one, their particles one after the other.
    pub(crate) fn join(parts: &[&Self]) -> Self {
        let mut whole = Self::default();
        let mut particle_count = 0;
        for part in parts {
            let first = narrow(particle_count);
            whole.patches.extend(part.patches.iter().map(|patch| Patch {
                corners: patch.corners.map(|corner| first + corner),
                owned: patch.owned,
            }));
            particle_count += part.particle_count();
        }
        whole.find_stars(particle_count);
        whole.find_adjacent();
        whole
    }

    /// Sews particles to each other: what meets in a seam is beside each other like triangles of one
    /// piece, and does not cross there.
    pub(crate) fn sew(&mut self, pairs: impl IntoIterator<Item = [u32; 2]>) {
        let mut pairs = pairs.into_iter().peekable();
        if pairs.peek().is_none() {
            return;
        }
        if self.sewn_to.is_empty() {
            self.sewn_to = (0..narrow(self.particle_count())).collect();
        }
        let first_of = |sewn_to: &[u32], mut particle: u32| {
            while sewn_to[particle as usize] != particle {
                particle = sewn_to[particle as usize];
            }
            particle
        };
        for pair in pairs {
            let [one, other] = pair.map(|particle| first_of(&self.sewn_to, particle));
            self.sewn_to[one.max(other) as usize] = one.min(other);
        }
        for particle in 0..self.sewn_to.len() {
            // Those before it are done, and it hangs on one of them.
            self.sewn_to[particle] = self.sewn_to[self.sewn_to[particle] as usize];
        }
    }

    /// The first of those that a particle is sewn to, itself where it is sewn to none.
    pub(crate) fn seam_of(&self, particle: u32) -> u32 {
        let sewn = self.sewn_to.get(particle as usize);
        sewn.copied().unwrap_or(particle)
    }

    /// Patches that have this particle for a corner, ascending.
    pub(crate) fn star(&self, particle: usize) -> &[u32] {
        let [start, end] = [particle, particle + 1].map(|place| self.star_starts[place] as usize);
        &self.star_patches[start..end]
    }

    /// The other corners of a patch's triangles at a particle, in their order.
    pub(crate) fn sides_at(&self, patch: u32, particle: u32) -> impl Iterator<Item = [u32; 2]> {
        let corners = self.patches[patch as usize].corners;
        let triangles = PATCH_TRIANGLES.map(|triangle| triangle.map(|corner| corners[corner]));
        triangles.into_iter().filter_map(move |[a, b, c]| {
            let sides = match particle {
                _ if a == c => return None,
                it if it == a => [b, c],
                it if it == b => [c, a],
                it if it == c => [a, b],
                _ => return None,
            };
            Some(sides)
        })
    }

    /// By patch of the first leaf, which patches of the second share a particle with it; `None`
    /// where none does. The first is not the later of the two.
    #[inline(always)]
    pub(crate) fn adjacent(&self, [leaf, other]: [u32; 2]) -> Option<&[u16; LANES]> {
        let place = leaf as usize;
        let [start, end] = [place, place + 1].map(|place| self.adjacent_starts[place] as usize);
        (self.adjacent[start..end].iter())
            .find(|adjacent| adjacent.leaf == other)
            .map(|adjacent| &adjacent.shared)
    }

    /// Third corner of each triangle at an edge, of two at most.
    pub(crate) fn opposites(&self, ends: [u32; 2]) -> [Option<u32>; 2] {
        let star = self.star(ends[0] as usize).iter();
        let triangles = star.flat_map(|&patch| {
            let corners = self.patches[patch as usize].corners;
            PATCH_TRIANGLES.map(|triangle| triangle.map(|corner| corners[corner]))
        });
        let at_edge = triangles.filter(|triangle| ends.iter().all(|end| triangle.contains(end)));
        let mut opposites = at_edge
            .filter_map(|triangle| triangle.into_iter().find(|corner| !ends.contains(corner)));
        [opposites.next(), opposites.next()]
    }

    /// Corners of the patches around a particle, some more than once, the particle among them.
    pub(crate) fn ring(&self, particle: u32) -> impl Iterator<Item = u32> {
        self.star(particle as usize)
            .iter()
            .flat_map(|&patch| self.patches[patch as usize].corners)
    }

    /// Whether two patches have a corner in common.
    pub(crate) fn share_particle(&self, pair: [u32; 2]) -> bool {
        let [one, other] = pair.map(|patch| self.patches[patch as usize].corners);
        let [a, b, c, d] = other;
        one.into_iter()
            .any(|corner| corner == a || corner == b || corner == c || corner == d)
    }

    /// Particles that it was made for.
    pub(crate) const fn particle_count(&self) -> usize {
        self.star_starts.len().saturating_sub(1)
    }

    /// Memory that it holds [byte].
    pub(crate) const fn byte_count(&self) -> usize {
        size_of_val(self.patches.as_slice())
            + size_of_val(self.star_starts.as_slice())
            + size_of_val(self.star_patches.as_slice())
            + size_of_val(self.adjacent_starts.as_slice())
            + size_of_val(self.adjacent.as_slice())
            + size_of_val(self.sewn_to.as_slice())
    }

    fn find_adjacent(&mut self) {
        let split = |patch: u32| (patch / narrow(LANES), patch % narrow(LANES));
        let mut pairs = Vec::new();
        for (patch, corners) in (0u32..).zip(self.patches.iter().map(|patch| patch.corners)) {
            let (leaf, lane) = split(patch);
            let stars = corners
                .into_iter()
                .flat_map(|corner| self.star(corner as usize));
            let beside = stars.map(|&other| split(other));
            let later = beside.filter(|&(other, _)| leaf <= other);
            pairs.extend(later.map(|(other, bit)| (leaf, other, lane, bit)));
        }
        pairs.sort_unstable();
        self.adjacent_starts = vec![0];
        for of_both in pairs.chunk_by(|one, next| (one.0, one.1) == (next.0, next.1)) {
            let (leaf, other, ..) = of_both[0];
            self.adjacent_starts
                .resize(leaf as usize + 1, narrow(self.adjacent.len()));
            let mut shared = [0; LANES];
            for &(_, _, lane, bit) in of_both {
                shared[lane as usize] |= 1 << bit;
            }
            self.adjacent.push(Adjacent {
                leaf: other,
                shared,
            });
        }
        let leaf_count = self.patches.len().div_ceil(LANES);
        self.adjacent_starts
            .resize(leaf_count + 1, narrow(self.adjacent.len()));
    }

    fn find_stars(&mut self, particle_count: usize) {
        let mut members = Vec::with_capacity(4 * self.patches.len());
        for (index, patch) in (0u32..).zip(&self.patches) {
            members.extend(patch.corners.map(|corner| (corner, index)));
        }
        members.sort_unstable();
        members.dedup();
        self.star_starts = vec![0; particle_count + 1];
        for &(corner, _) in &members {
            self.star_starts[corner as usize + 1] += 1;
        }
        for particle in 0..particle_count {
            self.star_starts[particle + 1] += self.star_starts[particle];
        }
        self.star_patches = members.into_iter().map(|(_, patch)| patch).collect();
    }
}

/// Every edge once, ascending by its ends, and the three edges of every triangle: the one that
/// starts at each corner.
fn find_edges(triangles: &[[u32; 3]]) -> (Vec<[u32; 2]>, Vec<[u32; 3]>) {
    let mut sides = Vec::with_capacity(3 * triangles.len());
    for (index, triangle) in triangles.iter().enumerate() {
        for side in 0..3 {
            let [one, other] = [0, 1].map(|step| triangle[(side + step) % 3]);
            sides.push(([one.min(other), one.max(other)], index, side));
        }
    }
    sides.sort_unstable();
    let mut edges: Vec<[u32; 2]> = Vec::new();
    let mut triangle_edges = vec![[0; 3]; triangles.len()];
    for (ends, triangle, side) in sides {
        if edges.last() != Some(&ends) {
            edges.push(ends);
        }
        triangle_edges[triangle][side] = narrow(edges.len() - 1);
    }
    (edges, triangle_edges)
}

/// Joins every triangle with the next one that shares an edge and is still alone.
fn pair_triangles(
    triangles: &[[u32; 3]],
    triangle_edges: &[[u32; 3]],
    edges: &[[u32; 2]],
) -> Vec<Patch> {
    let mut owners = vec![[usize::MAX; 2]; edges.len()];
    for (index, sides) in triangle_edges.iter().enumerate() {
        for &side in sides {
            let owner = &mut owners[side as usize];
            owner[usize::from(owner[0] != usize::MAX)] = index;
        }
    }
    let mut is_taken = vec![false; triangles.len()];
    let mut has_owner = vec![false; edges.len()];
    let mut patches = Vec::with_capacity(triangles.len().div_ceil(2));
    for (index, (triangle, sides)) in triangles.iter().zip(triangle_edges).enumerate() {
        if is_taken[index] {
            continue;
        }
        is_taken[index] = true;
        let partner = (0..3)
            .filter_map(|side| {
                let other = owners[sides[side] as usize]
                    .into_iter()
                    .find(|&o| o != index)?;
                let is_free = other != usize::MAX && !is_taken[other];
                is_free.then_some((other, side))
            })
            .min();
        // The shared edge runs from corner 3 to corner 0, or any edge of a triangle alone.
        let side = partner.map_or(2, |(_, side)| side);
        let [last, first, middle] = [0, 1, 2].map(|step| triangle[(side + step) % 3]);
        let far = partner.map_or(first, |(other, _)| {
            is_taken[other] = true;
            let is_far = |corner: &u32| *corner != first && *corner != last;
            triangles[other].into_iter().find(is_far).unwrap_or(first)
        });
        let corners = [first, middle, far, last];
        let known = [index].into_iter().chain(partner.map(|(other, _)| other));
        let mut owned = 0;
        for side in known.flat_map(|triangle| triangle_edges[triangle]) {
            let place = PATCH_EDGES.iter().position(|pair| {
                let [one, other] = pair.map(|corner| corners[corner]);
                [one.min(other), one.max(other)] == edges[side as usize]
            });
            if let Some(place) = place
                && !has_owner[side as usize]
            {
                has_owner[side as usize] = true;
                owned |= 1 << place;
            }
        }
        patches.push(Patch { corners, owned });
    }
    patches
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Topology;
    use crate::collision::grid::each_hit;

    /// Every edge is owned by one patch, and there as long as the patch's corners say.
    fn check(surface: &Surface, triangles: &[[u32; 3]]) {
        let mut owned = Vec::new();
        let mut covered = Vec::new();
        for patch in &surface.patches {
            let edges = each_hit(u64::from(patch.owned_edges()), PATCH_EDGES.len());
            owned.extend(edges.map(|edge| {
                let mut ends = PATCH_EDGES[edge].map(|corner| patch.corners[corner]);
                ends.sort_unstable();
                ends
            }));
            for triangle in PATCH_TRIANGLES {
                let mut corners = triangle.map(|corner| patch.corners[corner]);
                corners.sort_unstable();
                if corners[0] != corners[1] && corners[1] != corners[2] {
                    covered.push(corners);
                }
            }
        }
        owned.sort_unstable();
        assert_eq!(owned, find_edges(triangles).0);
        for ends in owned {
            let mut opposites = triangles
                .iter()
                .filter(|triangle| ends.iter().all(|end| triangle.contains(end)))
                .flatten()
                .copied()
                .filter(|corner| !ends.contains(corner))
                .collect::<Vec<_>>();
            opposites.sort_unstable();
            let mut found: Vec<u32> = surface.opposites(ends).into_iter().flatten().collect();
            found.sort_unstable();
            assert_eq!(found, opposites);
        }
        let mut expected = triangles.to_vec();
        expected
            .iter_mut()
            .for_each(|corners| corners.sort_unstable());
        expected.sort_unstable();
        covered.sort_unstable();
        assert_eq!(covered, expected);
    }

    #[test]
    fn patches_hold_every_triangle_and_every_edge_once() {
        for topology in [Topology::Sheet, Topology::Tube] {
            let grid = Grid {
                column_count: 7,
                row_count: 5,
                topology,
                spacing: [0.01; 2],
                flounce: None,
                crimp: None,
            };
            let surface = Surface::from_grid(&grid);
            let triangles = grid.triangles();
            check(&surface, &triangles);
            // A grid is cut into its cells.
            assert_eq!(surface.patches.len() * 2, triangles.len());
        }
        let fan: Vec<[u32; 3]> = (1..6).map(|rim| [0, rim, rim + 1]).collect();
        check(&Surface::new(7, &fan), &fan);
        let lone = [[2, 0, 1]];
        check(&Surface::new(3, &lone), &lone);
    }

    #[test]
    fn a_star_holds_the_patches_of_a_particle() {
        let grid = Grid {
            column_count: 4,
            row_count: 3,
            topology: Topology::Sheet,
            spacing: [0.01; 2],
            flounce: None,
            crimp: None,
        };
        let surface = Surface::from_grid(&grid);
        assert_eq!(surface.star(grid.index(1, 1)), [0, 1, 3, 4]);
        assert_eq!(surface.star(grid.index(0, 0)), [0]);
        // Of the six patches the first shares particles with itself and these.
        let adjacent = surface.adjacent([0, 0]).expect("a leaf is beside itself");
        assert_eq!(adjacent[0], 0b01_1011);
        assert!(surface.share_particle([0, 4]) && !surface.share_particle([0, 2]));
    }
}
