//! Tethers: no particle may be farther from a pinned one than the cloth between them is long.
//!
//! The length is that of the shortest way within the flat piece: straight where the piece lets it,
//! and around the corners of a neckline or a slit where it does not.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use fearless_simd::{f32x16, prelude::*};
use glam::{Vec2, Vec3};

use crate::constraint::pull::Pull;
use crate::lanes::{LANES, Scalars, Vectors};
use crate::mesh::build::Shape;
use crate::mesh::particles::{BASE_STEP, Gathered, WIDTH, gather_far};
use crate::mesh::rest::Rest;
use crate::mesh::topology::Topology;

/// Pins that every particle is tethered to; each costs one pass. Where there are more, every
/// particle hangs from its nearest as well.
const ANCHOR_COUNT_MAX: usize = 4;

/// A slot that holds no particle.
#[expect(clippy::cast_possible_truncation, reason = "4,095 fits")]
const FILLER: u32 = BASE_STEP as u32 - 1;

/// One tether for every particle.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tethers {
    anchors: Anchors,
    /// Inverse squares of the lengths [1/m²]; 0 for what hangs from nothing.
    pub(crate) inv_squares: Vec<Scalars>,
}

/// What particles hang from, as slots.
#[derive(Debug, Clone, PartialEq)]
enum Anchors {
    /// All particles hang from the same pin.
    One(u32),
    /// Each particle hangs from a pin of its own; by vector of sixteen.
    Each(Vec<[u32; LANES]>),
}

/// By particle, its pin and the length [m]; infinite where no way leads there.
type Pass = Vec<(u32, f32)>;

/// The tethers of a piece, in terms of particles.
pub(crate) fn tether_passes(shape: Shape<'_>, pins: &[u32]) -> Vec<Pass> {
    let Shape { topology, rest } = shape;
    if pins.is_empty() {
        return Vec::new();
    }
    let count = if ANCHOR_COUNT_MAX < pins.len() {
        pins.len()
    } else {
        1
    };
    let passes = pins.chunks(count);
    match rest {
        Rest::Plane(flat) => {
            let ways = Ways::new(flat, topology);
            passes.map(|pins| ways.from(pins)).collect()
        }
        Rest::Welded(welded) => passes
            .map(|pins| welded.ways_from(topology, pins))
            .collect(),
    }
}

/// Shortest ways within the flat piece.
pub(crate) struct Ways<'a> {
    flat: &'a [Vec2],
    topology: &'a Topology,
    /// By particle, its triangles.
    fans: Vec<Vec<u32>>,
}

impl<'a> Ways<'a> {
    pub(crate) fn new(flat: &'a [Vec2], topology: &'a Topology) -> Self {
        let mut fans = vec![Vec::new(); flat.len()];
        for (triangle, corners) in (0_u32..).zip(&topology.triangles) {
            for &corner in corners {
                fans[corner as usize].push(triangle);
            }
        }
        Self {
            flat,
            topology,
            fans,
        }
    }

    /// For every particle, the pin it is nearest to and how far that is [m].
    ///
    /// Dijkstra 1959 over the edges; a way is drawn straight from where it last turned, when that
    /// is in sight (Nash, Daniel, Koenig and Felner 2007, "Theta*").
    fn from(&self, pins: &[u32]) -> Vec<(u32, f32)> {
        let count = self.flat.len();
        let mut best = vec![(pins[0], f32::INFINITY); count];
        let mut turns: Vec<u32> = (0_u32..).take(count).collect();
        let mut done = vec![false; count];
        let mut queue = BinaryHeap::new();
        for &pin in pins {
            best[pin as usize] = (pin, 0.0);
            queue.push(Reverse((0_u32, pin)));
        }
        while let Some(Reverse((_, particle))) = queue.pop() {
            let here = particle as usize;
            if std::mem::replace(&mut done[here], true) {
                continue;
            }
            for &next in &self.topology.neighbors[here] {
                if done[next as usize] {
                    continue;
                }
                let (pin, length) = best[here];
                let turn = turns[here];
                let beyond =
                    |from: u32| self.flat[from as usize].distance(self.flat[next as usize]);
                let straight = best[turn as usize].1 + beyond(turn);
                let (candidate, from) = if straight < best[next as usize].1 && self.sees(turn, next)
                {
                    (straight, turn)
                } else {
                    (length + beyond(particle), particle)
                };
                if candidate < best[next as usize].1 {
                    best[next as usize] = (pin, candidate);
                    turns[next as usize] = from;
                    // Bits of a number that is not negative have its order.
                    queue.push(Reverse((candidate.to_bits(), next)));
                }
            }
        }
        best
    }

    /// Whether the straight line between two particles stays in the piece.
    pub(crate) fn sees(&self, from: u32, to: u32) -> bool {
        let (start, end) = (self.flat[from as usize], self.flat[to as usize]);
        let side = |particle: u32| (end - start).perp_dot(self.flat[particle as usize] - start);
        let mut here = from;
        // Corners of the edge that the line crosses next, left and right of it.
        'fan: loop {
            let Some((mut triangle, [mut left, mut right])) = self.leaving(here, to, &side) else {
                // Along an edge, or out of the piece.
                return match self.along(here, to) {
                    Some(next) if next == to => true,
                    Some(next) => {
                        here = next;
                        continue 'fan;
                    }
                    None => false,
                };
            };
            loop {
                let Some((next, corner)) = self.across(triangle, [left, right]) else {
                    return false;
                };
                if corner == to {
                    return true;
                }
                let s = side(corner);
                if s == 0.0 {
                    here = corner;
                    continue 'fan;
                }
                if 0.0 < s {
                    left = corner;
                } else {
                    right = corner;
                }
                triangle = next;
            }
        }
    }

    /// The triangle of `here`'s fan that the line towards `to` goes into, and the corners left and
    /// right of it.
    fn leaving(&self, here: u32, to: u32, side: &impl Fn(u32) -> f32) -> Option<(u32, [u32; 2])> {
        let direction = self.flat[to as usize] - self.flat[here as usize];
        self.fans[here as usize].iter().find_map(|&triangle| {
            let corners = self.topology.triangles[triangle as usize];
            let place = corners.iter().position(|&corner| corner == here)?;
            let (right, left) = (corners[(place + 1) % 3], corners[(place + 2) % 3]);
            let ahead =
                |p: u32| 0.0 < direction.dot(self.flat[p as usize] - self.flat[here as usize]);
            let between = side(right) < 0.0 && 0.0 < side(left) && (ahead(left) || ahead(right));
            between.then_some((triangle, [left, right]))
        })
    }

    /// The neighbor of `here` that lies on the line towards `to`.
    fn along(&self, here: u32, to: u32) -> Option<u32> {
        let (start, end) = (self.flat[here as usize], self.flat[to as usize]);
        let direction = end - start;
        let neighbors = self.topology.neighbors[here as usize].iter().copied();
        neighbors.into_iter().find(|&next| {
            let offset = self.flat[next as usize] - start;
            let along = direction.dot(offset);
            0.0 < along
                && direction.perp_dot(offset).abs() <= 1.0e-4 * along
                && along <= direction.length_squared() * 1.0001
        })
    }

    /// The triangle beyond an edge of `triangle`, and its corner across that edge.
    fn across(&self, triangle: u32, [left, right]: [u32; 2]) -> Option<(u32, u32)> {
        self.fans[left as usize].iter().find_map(|&next| {
            let corners = self.topology.triangles[next as usize];
            let shares = next != triangle && corners.contains(&right);
            let corner = corners
                .iter()
                .find(|&&corner| corner != left && corner != right);
            shares.then_some((next, *corner?))
        })
    }
}

/// Where sixteen particles are pulled back to, which are farther from their anchors than the tether times
/// the scale whose inverse square is given.
#[inline(always)]
pub(crate) fn pulled<S: Simd>(
    simd: S,
    sixteen: Gathered<S>,
    anchor: Vectors<S>,
    inv_square: f32x16<S>,
) -> Vectors<S> {
    let Gathered { place, inv_mass } = sixteen;
    let zero = f32x16::splat(simd, 0.0);
    let one = f32x16::splat(simd, 1.0);
    let pull = Pull::new(1.0);
    let offset = place.sub(anchor);
    let squared = offset.dot(offset) * inv_square;
    let taut = one.simd_lt(squared) & zero.simd_lt(inv_mass);
    let factor = taut.select(pull.taut_factor(simd, squared), zero);
    place.sub(offset.scale(factor))
}

impl Tethers {
    /// Brings one pass into slots: `slots` by particle.
    pub(crate) fn new(pass: &[(u32, f32)], slots: &[u32], vector_count: usize) -> Self {
        let mut anchors = vec![[FILLER; LANES]; vector_count];
        let mut inv_squares = vec![Scalars::default(); vector_count];
        for (&(pin, length), &slot) in pass.iter().zip(slots) {
            let (vector, lane) = (slot as usize / LANES, slot as usize % LANES);
            anchors[vector][lane] = slots[pin as usize];
            if 0.0 < length && length.is_finite() {
                inv_squares[vector].0[lane] = 1.0 / (length * length);
            }
        }
        let anchors = match pass.split_first() {
            Some((&(pin, _), others)) if others.iter().all(|&(other, _)| other == pin) => {
                Anchors::One(slots[pin as usize])
            }
            _ => Anchors::Each(anchors),
        };
        Self {
            anchors,
            inv_squares,
        }
    }

    /// Where the particles of a vector hang.
    #[inline(always)]
    pub(crate) fn anchor<S: Simd>(&self, simd: S, particles: &[f32], vector: usize) -> Vectors<S> {
        match &self.anchors {
            Anchors::One(slot) => {
                let place = Vec3::from_slice(&particles[*slot as usize * WIDTH..]);
                Vectors::splat(simd, place)
            }
            Anchors::Each(anchors) => gather_far(simd, particles, &anchors[vector]).place,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Fabric;
    use crate::mesh::MeshSpec;

    const FABRIC: Fabric = Fabric {
        areal_density: 0.1,
        thickness: 3e-4,
        stretch: [1e3, 1e3],
        shear: 50.0,
        bend: [1e-5, 1e-5],
        twist: 1e-5,
        hysteresis: crate::Hysteresis::NONE,
        friction: 0.3,
        cloth_friction: 0.3,
        drag_rate: 0.0,
    };

    /// A square of 2 m with a slit from the middle of one side to its center.
    fn slit_square() -> MeshSpec {
        let side = 9_u32;
        let mut flat: Vec<Vec2> = (0..side * side)
            .map(|k| Vec2::new((k % side) as f32, (k / side) as f32) * 0.25)
            .collect();
        // The lower lip of the slit, y = 1 and x < 1, gets particles of its own.
        let lip = |k: u32| k / side == 4 && k % side < 4;
        let first_copy = side * side;
        let copies: Vec<Vec2> = (0..4).map(|x| Vec2::new(x as f32 * 0.25, 1.0)).collect();
        flat.extend(copies);
        let mut triangles = Vec::new();
        for cell in 0..(side - 1) * (side - 1) {
            let (row, column) = (cell / (side - 1), cell % (side - 1));
            let a = row * side + column;
            let is_below = |k: u32| row == 4 && lip(k);
            let below = |k: u32| {
                if is_below(k) {
                    first_copy + k % side
                } else {
                    k
                }
            };
            let corners = [a, a + 1, a + side, a + side + 1].map(below);
            triangles.push([corners[0], corners[1], corners[3]]);
            triangles.push([corners[0], corners[3], corners[2]]);
        }
        MeshSpec::new(flat, triangles, FABRIC)
    }

    #[test]
    fn the_shortest_way_goes_straight_and_around_a_slit() {
        let spec = slit_square();
        let (topology, _) = Topology::new(&spec).expect("a surface");
        let ways = Ways::new(&spec.flat_positions, &topology);
        // From (0, 0.5), above the slit, to everywhere.
        let pin = 2 * 9;
        let lengths = ways.from(&[pin]);
        let start = spec.flat_positions[pin as usize];
        let tip = Vec2::new(1.0, 1.0);
        for (particle, &place) in spec.flat_positions.iter().enumerate() {
            // Below the line through the pin and the slit's tip, left of it, the slit is in the way.
            let is_copy = 81 <= particle;
            let hidden = is_copy || 1.0 < place.y && 0.0 < (tip - start).perp_dot(place - start);
            let expected = if hidden {
                start.distance(tip) + tip.distance(place)
            } else {
                start.distance(place)
            };
            let found = lengths[particle].1;
            assert!(
                (found / expected - 1.0).abs() < 0.01 || expected == 0.0,
                "{place}: {found} {expected}"
            );
            assert!(expected * 0.999 <= found, "{place}: too short");
        }
    }
}
