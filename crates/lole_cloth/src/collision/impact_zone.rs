//! Particles that move as one because nothing else keeps them from crossing.
//!
//! Provot 1997, "Collision and self-collision handling in cloth model dedicated to design
//! garments": a zone has the shape in which it began the step, which did not cross.

use glam::Vec3;

use crate::collision::crossing::Crossing;
use crate::collision::surface::Surface;

/// Mass of a pinned particle in the mean of its zone [kg]: all that counts.
const PINNED_MASS: f32 = 1.0e6;

/// Zones of a step.
#[derive(Debug, Clone, Default)]
pub(crate) struct ImpactZones {
    /// Another particle of the same zone, or the particle itself.
    parents: Vec<u32>,
    /// Particles of zones.
    pub(crate) members: Vec<u32>,
    is_member: Vec<bool>,
}

impl ImpactZones {
    /// Memory that it holds [byte].
    pub(crate) const fn byte_count(&self) -> usize {
        size_of_val(self.parents.as_slice())
            + size_of_val(self.members.as_slice())
            + size_of_val(self.is_member.as_slice())
    }

    /// Lets every one of so many particles move by itself.
    pub(crate) fn clear(&mut self, particle_count: u32) {
        self.parents.clear();
        self.parents.extend(0..particle_count);
        self.members.clear();
        self.is_member.clear();
        self.is_member.resize(particle_count as usize, false);
    }

    /// Joins what crosses and the patches around it, with the zones in which they are already:
    /// with what crosses alone, the zone would next cross its neighbors.
    pub(crate) fn join(&mut self, surface: &Surface, crossing: &Crossing) {
        let [start, end] = crossing.ends;
        let [a, b, c] = crossing.corners;
        for particle in [start, end, a, b, c] {
            for corner in surface.ring(particle) {
                self.join_pair(start, corner);
            }
        }
    }

    fn join_pair(&mut self, one: u32, other: u32) {
        if !self.is_member[other as usize] {
            self.is_member[other as usize] = true;
            self.members.push(other);
        }
        let [one, other] = [one, other].map(|particle| first_of(&mut self.parents, particle));
        self.parents[one.max(other) as usize] = one.min(other);
    }

    /// Gives all particles of a zone the mean displacement from `starts` [m].
    pub(crate) fn carry(
        &mut self,
        starts: &[Vec3],
        positions: &mut [Vec3],
        inv_mass: impl Fn(u32) -> f32,
    ) {
        let Self {
            parents, members, ..
        } = self;
        members.sort_unstable_by_key(|&member| (first_of(parents, member), member));
        let zones =
            members.chunk_by(|&one, &other| parents[one as usize] == parents[other as usize]);
        for zone in zones {
            let mut mass = 0.0;
            let mut travel = Vec3::ZERO;
            for &member in zone {
                let inv_mass = inv_mass(member);
                let one = if 0.0 < inv_mass {
                    1.0 / inv_mass
                } else {
                    PINNED_MASS
                };
                mass += one;
                travel += (positions[member as usize] - starts[member as usize]) * one;
            }
            for &member in zone {
                if 0.0 < inv_mass(member) {
                    positions[member as usize] = starts[member as usize] + travel / mass;
                }
            }
        }
    }
}

/// The first particle of a zone, which becomes the parent of `particle`.
fn first_of(parents: &mut [u32], particle: u32) -> u32 {
    let mut first = particle;
    while parents[first as usize] != first {
        let above = parents[parents[first as usize] as usize];
        parents[first as usize] = above;
        first = above;
    }
    parents[particle as usize] = first;
    first
}
