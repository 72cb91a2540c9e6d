//! Strain limiting: what a step has left too long or too short is brought to its lengths.
//!
//! Contact and the repair move cloth against what lies around it, and springs bring it back only in later steps.
//! So edges are brought to within a limit of their lengths at rest (Provot 1995, "Deformation constraints in a
//! mass-spring model to describe rigid cloth behavior"), outside of the skin. Where there is no room for that the
//! body gives way and not the cloth: they are brought there in the skin, and what is in it leaves it as far as
//! lengths allow. What has come to cross goes back to where it was.

use glam::Vec3;

use super::leave::{Back, outside_body};
use super::{CrossingRepair, Fixed};
use crate::collision::surface::Surface;
use crate::lanes::{Points, narrow};

/// Strain from which an edge is brought back, and what is left of it: within the tenth that cloth which is
/// whole may have.
pub(crate) const TOO_FAR: f32 = 0.09;
const LIMIT: f32 = 0.07;

/// One edge of so many may be, and so far outside of the skin before the skin gives way.
pub(crate) const FEW: usize = 100;
const ENOUGH: f32 = 0.08;

/// Rings around such edges that share their way.
const RINGS: usize = 3;

/// Sweeps over the edges at most, outside of the skin and again where that is not enough.
const SWEEP_COUNT: usize = 60;

/// Sweeps from one time that what moves leaves the skin to the next.
const SWEEPS_TO_LEAVE: usize = 4;

/// Passes over what is in the skin, and shares of its way out that are tried in each.
const LEAVING_PASSES: usize = 6;
const LEAVING_SHARES: [f32; 3] = [1.0, 0.5, 0.25];

/// Rounds of taking back what came to cross by it, and from which on the ring around goes back too.
const TAKING_BACK_ROUNDS: usize = 8;
const RING_ROUND: usize = 2;

/// Calls with both ends of every edge of a cloth and the length that it has at rest [m].
pub(crate) type EachEdge<'a> = &'a dyn Fn(&mut dyn FnMut([usize; 2], f32));

/// Edges at what is strained too far, and around it.
#[derive(Debug)]
struct Edges {
    all: Vec<Edge>,
    /// Edges of the whole cloth.
    all_count: usize,
    /// What is free at them, and an edge of it, in order.
    stars: Vec<(u32, u32)>,
}

#[derive(Debug, Clone, Copy)]
struct Edge {
    ends: [u32; 2],
    /// At rest [m].
    length: f32,
    /// How much of a change each end makes: 1 in sum.
    shares: [f32; 2],
}

impl Edge {
    fn is_within(self, length: f32, limit: f32) -> bool {
        ((1.0 - limit) * self.length..=(1.0 + limit) * self.length).contains(&length)
    }
}

impl Edges {
    /// Finds them among edges whose ends are at `positions` [m]; only what is free moves.
    fn find(
        surface: &Surface,
        positions: &[Vec3],
        each_edge: EachEdge<'_>,
        is_free: &dyn Fn(usize) -> bool,
    ) -> Self {
        let (mut all_count, mut new) = (0, Vec::new());
        each_edge(&mut |ends, length| {
            let edge = Edge {
                ends: ends.map(narrow),
                length,
                shares: [0.5; 2],
            };
            all_count += 1;
            let now = positions[ends[0]].distance(positions[ends[1]]);
            if ends.into_iter().any(is_free) && !edge.is_within(now, TOO_FAR) {
                new.extend(edge.ends);
            }
        });
        let mut is_near = vec![false; positions.len()];
        for _ in 0..=RINGS {
            new.sort_unstable();
            new.dedup();
            for &particle in &new {
                is_near[particle as usize] = true;
            }
            let around = new.iter().flat_map(|&particle| surface.ring(particle));
            new = around.filter(|&it| !is_near[it as usize]).collect();
        }
        let (mut all, mut stars) = (Vec::new(), Vec::new());
        each_edge(&mut |ends, length| {
            let moves = ends.map(|end| is_near[end] && is_free(end));
            let shares = match moves {
                [true, true] => [0.5, 0.5],
                [true, false] => [1.0, 0.0],
                [false, true] => [0.0, 1.0],
                [false, false] => return,
            };
            let ends = ends.map(narrow);
            let moved = ends.into_iter().zip(moves).filter(|(_, moves)| *moves);
            stars.extend(moved.map(|(end, _)| (end, narrow(all.len()))));
            all.push(Edge {
                ends,
                length,
                shares,
            });
        });
        stars.sort_unstable();
        Self {
            all,
            all_count,
            stars,
        }
    }

    /// What moves, each once.
    fn particles(&self) -> impl Iterator<Item = u32> {
        let stars = self.stars.chunk_by(|one, other| one.0 == other.0);
        stars.map(|star| star[0].0)
    }

    /// Brings each edge once to within [`LIMIT`] of its length; whether any was beyond it by more than rounding.
    fn sweep(&self, positions: &mut [Vec3]) -> bool {
        let mut any = false;
        for edge in &self.all {
            let [one, other] = edge.ends.map(|end| end as usize);
            let way = positions[other] - positions[one];
            let now = way.length();
            let wanted = now.clamp((1.0 - LIMIT) * edge.length, (1.0 + LIMIT) * edge.length);
            if wanted != now && 0.0 < now {
                let change = way * ((now - wanted) / now);
                positions[one] += change * edge.shares[0];
                positions[other] -= change * edge.shares[1];
                any |= !edge.is_within(now, 1.01 * LIMIT);
            }
        }
        any
    }

    /// Brings edges to their lengths and what moves by that out of the skin, in turn.
    fn keep_out(&self, positions: &mut [Vec3], outside: impl Fn(u32, Vec3) -> Vec3) {
        for sweep in 1..=SWEEP_COUNT {
            self.sweep(positions);
            if sweep % SWEEPS_TO_LEAVE == 0 {
                for particle in self.particles() {
                    let position = &mut positions[particle as usize];
                    *position = outside(particle, *position);
                }
            }
        }
    }

    /// Brings edges to their lengths, be that in the skin; what can leave it then does.
    fn give_way(&self, positions: &mut [Vec3], outside: impl Fn(u32, Vec3) -> Vec3) {
        for _ in 0..SWEEP_COUNT {
            if !self.sweep(positions) {
                break;
            }
        }
        for _ in 0..LEAVING_PASSES {
            self.leave(positions, &outside);
        }
    }

    /// Whether more of all edges than may be are strained still.
    fn are_torn(&self, positions: &[Vec3]) -> bool {
        let is_torn = |edge: &&Edge| {
            let [one, other] = edge.ends.map(|end| positions[end as usize]);
            !edge.is_within(one.distance(other), ENOUGH)
        };
        let torn = self.all.iter().filter(is_torn).count();
        self.all_count < FEW * torn
    }

    /// Brings what `outside` brings elsewhere there, as far as no edge is strained more by that than it may be.
    fn leave(&self, positions: &mut [Vec3], outside: impl Fn(u32, Vec3) -> Vec3) {
        for star in self.stars.chunk_by(|one, other| one.0 == other.0) {
            let particle = star[0].0;
            let now = positions[particle as usize];
            let out = outside(particle, now);
            if out == now {
                continue;
            }
            let ways = LEAVING_SHARES.map(|share| now.lerp(out, share));
            if let Some(place) = ways
                .into_iter()
                .find(|&place| self.allow(star, positions, place))
            {
                positions[particle as usize] = place;
            }
        }
    }

    /// Whether a particle with these edges may go to a place: none of them is strained more by that than it may be.
    fn allow(&self, star: &[(u32, u32)], positions: &[Vec3], place: Vec3) -> bool {
        star.iter().all(|&(particle, edge)| {
            let Edge { ends, length, .. } = self.all[edge as usize];
            let other = ends[usize::from(ends[0] == particle)];
            let strained = |at: Vec3| (at.distance(positions[other as usize]) - length).abs();
            strained(place) <= strained(positions[particle as usize]).max(LIMIT * length)
        })
    }
}

impl CrossingRepair {
    /// Limits the strain of cloth that does not cross: its particles at `positions`, its edges by `each_edge`.
    pub(crate) fn limit_strain(
        &mut self,
        fixed: Fixed<'_>,
        positions: &mut [Points],
        each_edge: EachEdge<'_>,
    ) {
        if self.ceiling != Some(0) || !self.finder.crossings.is_empty() {
            return;
        }
        fixed.layout.gather_points(positions, &mut self.positions);
        let is_free = |particle: usize| 0.0 < Self::inv_mass(fixed, narrow(particle));
        let edges = Edges::find(fixed.surface, &self.positions, each_edge, &is_free);
        self.start_moving();
        for particle in edges.particles() {
            self.shift(particle, Vec3::ZERO);
        }
        let outside = |particle, position| outside_body(fixed, particle, position);
        edges.keep_out(&mut self.positions, outside);
        self.take_crossings_back(fixed);
        if edges.are_torn(&self.positions) {
            self.take_moved_back();
            edges.give_way(&mut self.positions, outside);
            self.take_crossings_back(fixed);
        }
        self.store_moved(fixed, positions);
    }

    /// Takes back what has come to cross since nothing had moved, or else everything.
    fn take_crossings_back(&mut self, fixed: Fixed<'_>) {
        self.look_again(fixed);
        for round in 0..TAKING_BACK_ROUNDS {
            if self.finder.crossings.is_empty() {
                return;
            }
            let back = if round < RING_ROUND {
                Back::Crossed
            } else {
                Back::Around
            };
            self.take_back(fixed.surface, back);
            self.look_again(fixed);
        }
        if !self.finder.crossings.is_empty() {
            self.take_moved_back();
            self.look_again(fixed);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ClothSpec, Fabric, Grid, diagnose};

    /// A sheet of 9 by 9, 1 cm apart, whose first row is held.
    struct Sheet {
        surface: Surface,
        spec: ClothSpec,
        flat: Vec<Vec3>,
    }

    impl Sheet {
        fn new() -> Self {
            let grid = Grid::sheet(9, 9, [0.01; 2]);
            let places = (0..81_u8).map(|it| Vec3::new(f32::from(it % 9), 0.0, f32::from(it / 9)));
            Self {
                surface: Surface::from_grid(&grid),
                flat: places.map(|it| it * 0.01).collect(),
                spec: ClothSpec::new(grid, Fabric::COTTON),
            }
        }

        fn edges(&self, places: &[Vec3]) -> Edges {
            let each_edge = |edge: &mut dyn FnMut([usize; 2], f32)| {
                diagnose::each_structural_edge(&self.spec, edge);
            };
            Edges::find(&self.surface, places, &each_edge, &|it| 8 < it)
        }

        fn worst(&self, places: &[Vec3]) -> f32 {
            diagnose::strain(&self.spec, places).max
        }
    }

    #[test]
    fn what_was_pushed_shares_its_way_with_what_is_free_around_it() {
        let sheet = Sheet::new();
        assert!(
            sheet.edges(&sheet.flat).all.is_empty(),
            "nothing is strained"
        );
        let mut places = sheet.flat.clone();
        places[40] += Vec3::X * 0.004;
        let edges = sheet.edges(&places);
        assert!(0.3 < sheet.worst(&places));
        let sweeps = (0..SWEEP_COUNT).take_while(|_| edges.sweep(&mut places));
        assert!(sweeps.count() < SWEEP_COUNT, "it comes to rest");
        assert!(sheet.worst(&places) < 1.02 * LIMIT);
        assert_eq!(places[..9], sheet.flat[..9], "what is not free stays");
        let share = |it: usize| places[it].x - sheet.flat[it].x;
        assert!(
            1.0e-4 < share(41) && 1.0e-4 < share(39),
            "and is pushed too"
        );
    }

    #[test]
    fn what_is_in_the_skin_leaves_it_as_far_as_lengths_allow() {
        let sheet = Sheet::new();
        let mut places = sheet.flat.clone();
        places[40] += Vec3::X * 0.004;
        let edges = sheet.edges(&places);
        places[40] = sheet.flat[40];
        // All of the skin is that high above the sheet.
        for (height, is_out) in [(0.002, true), (0.2, false)] {
            let mut left = places.clone();
            for _ in 0..LEAVING_PASSES {
                edges.leave(&mut left, |_, place| Vec3::new(place.x, height, place.z));
            }
            assert_eq!(left[40].y == height, is_out, "{height}: {}", left[40].y);
            assert!(sheet.worst(&left) <= 1.001 * LIMIT);
        }
    }
}
