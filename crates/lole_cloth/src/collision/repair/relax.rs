//! How cloth that was parted or held back keeps its lengths.
//!
//! What is brought to its sides of planes, or goes only a part of its way, is strained against what lies around
//! it: a repair that parts a hundred crossings alone leaves a thousand edges longer or shorter by a fifth. So
//! while it parts, and after it has held back, it brings edges towards the lengths that the solver gave them
//! (strain limiting: Provot 1995, "Deformation constraints in a mass-spring model to describe rigid cloth
//! behavior"), as far as nothing comes to cross by that.

use glam::Vec3;

use super::{CrossingRepair, Fixed};
use crate::collision::surface::{PATCH_EDGES, Surface};

/// How much longer or shorter an edge may be than the solver has left it, as a share.
const LIMIT: f32 = 0.03;

/// Where fewer than one in so many patches is parted, or has an edge that is strained, the springs of the next
/// step do it.
const FEW: usize = 100;

/// Rings around what is parted that share its way.
const RINGS: usize = 2;

/// Sweeps over what is parted there in a round: more than usual, because lengths pull against planes.
pub(super) const PARTING_SWEEP_COUNT: usize = 6;

/// Times that what was held back is relaxed, each time but where that crossed before, and sweeps over its edges
/// in each.
const PASSES: usize = 2;
const SWEEP_COUNT: usize = 16;

/// Rounds of taking back what came to cross by it, and from which on the ring around goes back too.
const TAKING_BACK_ROUNDS: usize = 8;
const RING_ROUND: usize = 2;

/// Pairs that may be looked at meanwhile for each patch.
const RELAXING_EFFORT: usize = 2;

/// So many edges of a sweep take as long as a pair of patches that is looked at.
const EDGES_OF_A_PAIR: usize = 16;

/// Edges at what a repair moves.
#[derive(Debug, Clone, Default)]
pub(super) struct Edges {
    all: Vec<Edge>,
    /// Room for the patches to which they belong.
    patches: Vec<u32>,
}

#[derive(Debug, Clone, Copy)]
struct Edge {
    ends: [u32; 2],
    /// As the solver has left it [m].
    length: f32,
    /// How much of a change each end makes: 1 in sum.
    shares: [f32; 2],
}

impl Edges {
    /// Memory that it holds [byte].
    pub(super) const fn byte_count(&self) -> usize {
        size_of_val(self.all.as_slice()) + size_of_val(self.patches.as_slice())
    }

    /// Finds the edges of all patches at `particles`, as long as between the places where those were [m]; only what
    /// is free moves.
    fn find(
        &mut self,
        surface: &Surface,
        particles: &[u32],
        place: impl Fn(u32) -> Vec3,
        is_free: impl Fn(u32) -> bool,
    ) {
        let Self { all, patches } = self;
        patches.clear();
        patches.extend(
            (particles.iter()).flat_map(|&particle| surface.star(particle as usize).iter()),
        );
        patches.sort_unstable();
        patches.dedup();
        all.clear();
        for &patch in &*patches {
            let patch = &surface.patches[patch as usize];
            let owned = PATCH_EDGES.iter().enumerate();
            let owned = owned.filter(|(bit, _)| patch.owned_edges() >> bit & 1 == 1);
            for (_, ends) in owned {
                let ends = ends.map(|corner| patch.corners[corner]);
                let shares = match ends.map(&is_free) {
                    [true, true] => [0.5, 0.5],
                    [true, false] => [1.0, 0.0],
                    [false, true] => [0.0, 1.0],
                    [false, false] => continue,
                };
                let [one, other] = ends.map(&place);
                all.push(Edge {
                    ends,
                    length: one.distance(other),
                    shares,
                });
            }
        }
    }

    /// Brings each edge once to within [`LIMIT`] of its length.
    fn sweep(&self, positions: &mut [Vec3]) {
        for edge in &self.all {
            let [one, other] = edge.ends.map(|end| end as usize);
            let way = positions[other] - positions[one];
            let now = way.length();
            let wanted = now.clamp((1.0 - LIMIT) * edge.length, (1.0 + LIMIT) * edge.length);
            if wanted != now && 0.0 < now {
                let change = way * ((now - wanted) / now);
                positions[one] += change * edge.shares[0];
                positions[other] -= change * edge.shares[1];
            }
        }
    }

    /// How many edges are longer or shorter by more than twice [`LIMIT`].
    fn strained(&self, positions: &[Vec3]) -> usize {
        let is_strained = |edge: &&Edge| {
            let [one, other] = edge.ends.map(|end| positions[end as usize]);
            2.0 * LIMIT * edge.length < (one.distance(other) - edge.length).abs()
        };
        self.all.iter().filter(is_strained).count()
    }

    /// What a sweep costs, as pairs of patches that are looked at.
    const fn effort(&self) -> usize {
        self.all.len() / EDGES_OF_A_PAIR
    }
}

impl CrossingRepair {
    /// Finds the edges around what is to be parted from `known` on, where that is so much that it strains the cloth;
    /// whether it is.
    pub(super) fn find_strained(&mut self, fixed: Fixed<'_>, known: usize) -> bool {
        if !fixed.is_strained || self.separations.len() * FEW <= fixed.surface.patches.len() {
            return false;
        }
        let new = &self.separations[known..];
        let mut around: Vec<u32> = (new.iter())
            .flat_map(|it| it.ends.into_iter().chain(it.corners))
            .collect();
        for _ in 0..RINGS {
            around = (around.iter())
                .flat_map(|&it| fixed.surface.ring(it))
                .collect();
            around.sort_unstable();
            around.dedup();
        }
        for particle in around {
            self.shift(particle, Vec3::ZERO);
        }
        let Self {
            edges,
            moved,
            moved_places,
            before,
            positions,
            ..
        } = self;
        let place = |particle: u32| match moved_places[particle as usize].checked_sub(1) {
            Some(place) => before[place as usize],
            None => positions[particle as usize],
        };
        let is_free = |particle: u32| {
            0 < moved_places[particle as usize] && 0.0 < Self::inv_mass(fixed, particle)
        };
        edges.find(fixed.surface, moved, place, is_free);
        true
    }

    /// Brings the edges around what is parted towards their lengths once.
    pub(super) fn keep_lengths(&mut self) {
        self.edges.sweep(&mut self.positions);
        self.effort += self.edges.effort();
    }

    /// Brings what was held back towards the lengths that it had at `goals` [m], but where that would cross.
    pub(super) fn relax(&mut self, fixed: Fixed<'_>, goals: &[Vec3]) {
        let members = std::mem::take(&mut self.zones.members);
        let is_all = goals.len() < 2 * members.len();
        if self.ceiling == Some(0) && self.finder.crossings.is_empty() && !is_all {
            // What comes after it may do as much as without it.
            let (known, most) = (self.effort + self.finder.effort, self.effort_max);
            self.relax_members(fixed, &members, goals);
            self.effort_max = most + self.effort + self.finder.effort - known;
        }
        self.zones.members = members;
    }

    fn relax_members(&mut self, fixed: Fixed<'_>, members: &[u32], goals: &[Vec3]) {
        let most = RELAXING_EFFORT * fixed.surface.patches.len();
        self.effort_max = self.effort + self.finder.effort + most;
        let mut held = vec![None; goals.len()];
        for &member in members {
            held[member as usize] = Some(self.positions[member as usize]);
        }
        let is_free =
            |particle| held[particle as usize].is_some() && 0.0 < Self::inv_mass(fixed, particle);
        (self.edges).find(fixed.surface, members, |it| goals[it as usize], is_free);
        if self.edges.strained(&self.positions) * FEW <= fixed.surface.patches.len() {
            return;
        }
        for _ in 0..PASSES {
            if self.is_spent() {
                return;
            }
            for _ in 0..SWEEP_COUNT {
                self.edges.sweep(&mut self.positions);
            }
            self.effort += SWEEP_COUNT * self.edges.effort();
            for &member in members {
                self.shift(member, Vec3::ZERO);
            }
            self.look_again(fixed);
            for round in 0..TAKING_BACK_ROUNDS {
                if self.finder.crossings.is_empty() || self.is_spent() {
                    break;
                }
                self.take_back_to(fixed.surface, &held, round);
                self.look_again(fixed);
            }
            if !self.finder.crossings.is_empty() {
                for &member in members {
                    let place = held[member as usize];
                    self.positions[member as usize] = place.unwrap_or(goals[member as usize]);
                }
                self.look_again(fixed);
                return;
            }
        }
    }

    /// Brings what crosses to where it was held, and in later rounds what lies around it too.
    fn take_back_to(&mut self, surface: &Surface, held: &[Option<Vec3>], round: usize) {
        let crossed = (self.finder.crossings.iter())
            .flat_map(|crossing| crossing.ends.into_iter().chain(crossing.corners));
        for particle in crossed {
            let ring = (surface.ring(particle)).filter(|_| RING_ROUND <= round);
            for back in std::iter::once(particle).chain(ring) {
                let place = &mut self.positions[back as usize];
                *place = held[back as usize].unwrap_or(*place);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Grid;

    /// Particles of a sheet of 9 by 9, 1 cm apart.
    fn sheet() -> (Surface, Vec<Vec3>) {
        let grid = Grid::sheet(9, 9, [0.01; 2]);
        let places = (0..81_u8).map(|it| Vec3::new(f32::from(it % 9), 0.0, f32::from(it / 9)));
        (
            Surface::from_grid(&grid),
            places.map(|it| it * 0.01).collect(),
        )
    }

    fn worst(edges: &Edges, places: &[Vec3]) -> f32 {
        let strain = |edge: &Edge| {
            let [one, other] = edge.ends.map(|end| places[end as usize]);
            (one.distance(other) / edge.length - 1.0).abs()
        };
        edges.all.iter().map(strain).fold(0.0, f32::max)
    }

    #[test]
    fn what_was_pushed_shares_its_way_with_what_is_free_around_it() {
        let (surface, flat) = sheet();
        let particles: Vec<u32> = (0..81).collect();
        let is_free = |it: u32| 8 < it;
        let mut edges = Edges::default();
        edges.find(&surface, &particles, |it| flat[it as usize], is_free);
        assert_eq!(
            edges.all.len(),
            8 * 9 * 2 + 64 - 8,
            "each once, and none between what is not free"
        );
        let mut places = flat.clone();
        places[40] += Vec3::X * 0.004;
        assert!(0.3 < worst(&edges, &places));
        for _ in 0..SWEEP_COUNT {
            edges.sweep(&mut places);
        }
        assert!(worst(&edges, &places) < 1.5 * LIMIT);
        assert_eq!(places[..9], flat[..9], "what is not free stays");
        let share = |it: usize| places[it].x - flat[it].x;
        assert!(
            1.0e-4 < share(41) && 1.0e-4 < share(39),
            "and is pushed too"
        );
        let calm = places.clone();
        edges.sweep(&mut places);
        let most = calm.iter().zip(&places).map(|(a, b)| a.distance(*b));
        assert!(most.fold(0.0, f32::max) < 1.0e-4, "it comes to rest");
    }
}
