//! Particles that are held back because nothing else keeps them from crossing: they move with the space around
//! them, and as one where that is not enough.
//!
//! Provot 1997, "Collision and self-collision handling in cloth model dedicated to design
//! garments": a zone has the shape in which it began the step, which did not cross.

use std::collections::VecDeque;

use glam::{DQuat, DVec3, Quat, Vec3};
use lole_geom::trig64;

use crate::collision::crossing::Crossing;
use crate::collision::surface::Surface;
use crate::lanes::narrow;

/// Mass of a pinned particle in the mean of its zone [kg]: all that counts.
const PINNED_MASS: f32 = 1.0e6;

/// Times that the way of a particle is halved before it is held fast in its zone.
const HALVINGS: u8 = 2;

/// Times that the way of a particle is halved in a zone of everything before it is held fast.
const MOST_HALVINGS: u8 = 8;

/// So many halvings leave nothing of a way in a zone of everything.
pub(crate) const STILL: u32 = MOST_HALVINGS as u32 + 1;

/// Farthest that a zone carries a particle beyond the way of the one that would go farthest [m].
const LEVER_REACH: f32 = 0.03;

/// How much farther from where the space around it brings it a particle may go than its neighbors that are held
/// back, as a share of the cloth between: the strain that holding back may add.
const SLOPE: f32 = 0.2;

/// What is held back of a particle.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Held {
    /// Where it would go, and where the space around it brings it [m].
    goal: Vec3,
    base: Vec3,
    /// How often its way from there to its goal was halved, and how far it goes of it at most [m].
    halvings: u8,
    reach: f32,
}

/// Where everything was, would go, and is brought by the space around it.
pub(crate) struct Ways<'a, M: Fn(Vec3) -> Vec3> {
    /// At the start of the step [m].
    pub(crate) starts: &'a [Vec3],
    /// At its end, if nothing is held back [m].
    pub(crate) goals: &'a [Vec3],
    pub(crate) motion: M,
}

/// Whether what is pinned is held back too.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pins {
    /// A pin stays where the body has it.
    Stay,
    /// A pin stays behind where it would cross.
    Yield,
}

/// Zones of a step.
#[derive(Debug, Clone, Default)]
pub(crate) struct ImpactZones {
    /// Another particle of the same zone, or the particle itself.
    parents: Vec<u32>,
    /// Particles of zones, as they were taken up.
    pub(crate) members: Vec<u32>,
    /// How many of them have all around them in their zone.
    grown: usize,
    /// Members, zone after zone.
    sorted: Vec<u32>,
    /// By particle, its place among those that were taken up, counted from 1; 0 of others.
    places: Vec<u32>,
    /// In the order in which they were taken up.
    held: Vec<Held>,
    /// Room for particles whose neighbors are to be looked at.
    waiting: VecDeque<u32>,
    /// How often a way is halved at most.
    most_halvings: u8,
}

impl ImpactZones {
    /// Memory that it holds [byte].
    pub(crate) fn byte_count(&self) -> usize {
        size_of_val(self.parents.as_slice())
            + size_of_val(self.members.as_slice())
            + size_of_val(self.sorted.as_slice())
            + size_of_val(self.places.as_slice())
            + size_of_val(self.held.as_slice())
            + self.waiting.capacity() * size_of::<u32>()
    }

    /// Lets every one of so many particles move by itself.
    pub(crate) fn clear(&mut self, particle_count: u32) {
        self.parents.clear();
        self.parents.extend(0..particle_count);
        self.members.clear();
        self.grown = 0;
        self.most_halvings = HALVINGS;
        self.held.clear();
        self.places.clear();
        self.places.resize(particle_count as usize, 0);
    }

    /// Holds what crosses back further, and joins it where all of it is held fast already.
    pub(crate) fn hold<M: Fn(Vec3) -> Vec3>(&mut self, crossing: &Crossing, ways: &Ways<'_, M>) {
        let [start, end] = crossing.ends;
        let [a, b, c] = crossing.corners;
        let particles = [start, end, a, b, c];
        let mut is_fast = true;
        for particle in particles {
            let place = self.take_up(particle, ways);
            let held = &mut self.held[place];
            is_fast &= self.most_halvings < held.halvings;
            held.halvings = held.halvings.saturating_add(1);
            let reach = if self.most_halvings < held.halvings {
                0.0
            } else {
                held.base.distance(held.goal) / f32::from(1_u16 << held.halvings)
            };
            held.reach = held.reach.min(reach);
            self.waiting.push_back(particle);
        }
        if is_fast {
            for particle in particles {
                self.join(start, particle);
            }
        }
    }

    /// Holds back what lies around what is held, so that no cloth between is strained by more than
    /// [`SLOPE`] for it.
    pub(crate) fn spread<M: Fn(Vec3) -> Vec3>(&mut self, surface: &Surface, ways: &Ways<'_, M>) {
        let way_of = |particle: u32| {
            let base = (ways.motion)(ways.starts[particle as usize]);
            base.distance(ways.goals[particle as usize])
        };
        while let Some(particle) = self.waiting.pop_front() {
            let reach = self.held[self.places[particle as usize] as usize - 1].reach;
            let start = ways.starts[particle as usize];
            for corner in surface.ring(particle) {
                let far = reach + SLOPE * start.distance(ways.starts[corner as usize]);
                let known = (self.places[corner as usize] as usize).checked_sub(1);
                let own = known.map_or_else(|| way_of(corner), |place| self.held[place].reach);
                if far < own {
                    let place = self.take_up(corner, ways);
                    self.held[place].reach = far;
                    self.waiting.push_back(corner);
                }
            }
        }
    }

    /// Makes a particle a member, if it is none; its place among them.
    fn take_up<M: Fn(Vec3) -> Vec3>(&mut self, particle: u32, ways: &Ways<'_, M>) -> usize {
        let place = &mut self.places[particle as usize];
        if *place == 0 {
            self.members.push(particle);
            let goal = ways.goals[particle as usize];
            let base = (ways.motion)(ways.starts[particle as usize]);
            self.held.push(Held {
                goal,
                base,
                halvings: 0,
                reach: base.distance(goal),
            });
            *place = narrow(self.held.len());
        }
        *place as usize - 1
    }

    fn join(&mut self, one: u32, other: u32) {
        let [one, other] = [one, other].map(|particle| first_of(&mut self.parents, particle));
        self.parents[one.max(other) as usize] = one.min(other);
    }

    /// Takes up what lies around the members, a ring of patches, and holds all fast.
    pub(crate) fn grow<M: Fn(Vec3) -> Vec3>(&mut self, surface: &Surface, ways: &Ways<'_, M>) {
        let members = self.grown..self.members.len();
        self.grown = members.end;
        for place in members {
            let member = self.members[place];
            for corner in surface.ring(member) {
                self.take_up(corner, ways);
            }
        }
        for held in &mut self.held {
            held.halvings = held.halvings.max(HALVINGS + 1);
            held.reach = 0.0;
        }
    }

    /// Makes one zone of everything, in which each goes its way halved so often: slower, but not still.
    pub(crate) fn join_all<M: Fn(Vec3) -> Vec3>(&mut self, ways: &Ways<'_, M>, halvings: u32) {
        for particle in 0..narrow(ways.starts.len()) {
            self.take_up(particle, ways);
            self.join(0, particle);
        }
        self.most_halvings = MOST_HALVINGS;
        let halvings = u8::try_from(halvings).unwrap_or(u8::MAX);
        for held in &mut self.held {
            held.halvings = halvings;
        }
    }

    /// Whether everything is one zone that goes none of its way: further rounds would repeat it.
    pub(crate) fn is_one_and_still(&self) -> bool {
        let is_one = HALVINGS < self.most_halvings;
        is_one && (self.held.iter()).all(|held| self.most_halvings < held.halvings)
    }

    /// Moves every zone from `starts` [m] as the space around it moves, what is joined as a rigid body, and every
    /// particle as far from there towards where it would go as it may; pinned ones stay where they are but
    /// where they yield.
    pub(crate) fn carry(
        &mut self,
        (starts, positions): (&[Vec3], &mut [Vec3]),
        inv_mass: impl Fn(u32) -> f32,
        pins: Pins,
    ) {
        let Self {
            parents,
            members,
            sorted,
            places,
            held,
            most_halvings,
            ..
        } = self;
        sorted.clone_from(members);
        sorted.sort_unstable_by_key(|&member| (first_of(parents, member), member));
        let zones =
            sorted.chunk_by(|&one, &other| parents[one as usize] == parents[other as usize]);
        for zone in zones {
            let held = |member: u32| held[places[member as usize] as usize - 1];
            let way = |&member: &u32| (member, starts[member as usize], held(member).base);
            let rigid = match zone {
                [_] => None,
                _ => Some(joined(zone.iter().map(way), &inv_mass)),
            };
            for &member in zone {
                if pins == Pins::Stay && inv_mass(member) <= 0.0 {
                    continue;
                }
                let held = held(member);
                let base = rigid.map_or(held.base, |rigid| rigid.apply(starts[member as usize]));
                let way = held.goal - base;
                positions[member as usize] = if *most_halvings < held.halvings {
                    base
                } else if HALVINGS < *most_halvings {
                    base + way * (1.0 / f32::from(1_u16 << held.halvings))
                } else {
                    base + way.clamp_length_max(held.reach)
                };
            }
        }
    }
}

/// The rigid motion of a zone that is nearest to how the space around it moves: its particles, where they start,
/// and where that brings them [m].
fn joined(
    zone: impl Iterator<Item = (u32, Vec3, Vec3)> + Clone,
    inv_mass: impl Fn(u32) -> f32,
) -> Rigid {
    let mass = |member: u32| {
        let inv_mass = inv_mass(member);
        if 0.0 < inv_mass {
            1.0 / inv_mass
        } else {
            PINNED_MASS
        }
    };
    let moved = zone.clone();
    let rigid = Rigid::fit(moved.map(|(member, start, base)| (mass(member), start, base)));
    let (mut farthest, mut turned) = (0.0_f32, 0.0_f32);
    for (_, start, base) in zone {
        farthest = farthest.max(start.distance(base));
        turned = turned.max(start.distance(rigid.apply(start)));
    }
    if farthest + LEVER_REACH < turned {
        rigid.unturned()
    } else {
        rigid
    }
}

/// A turn about a center, and where that goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rigid {
    turn: Quat,
    from: Vec3,
    to: Vec3,
}

impl Rigid {
    /// The one that brings points with these masses nearest from their first places to their second ones
    /// [m]: by least squares, and of all those the one that turns least (Müller, Bender, Chentanez and
    /// Macklin 2016, "A Robust Method to Extract the Rotational Part of Deformations").
    pub(crate) fn fit(points: impl Iterator<Item = (f32, Vec3, Vec3)> + Clone) -> Self {
        const PASS_COUNT: usize = 60;
        let (mut mass, mut from, mut to) = (0.0_f64, DVec3::ZERO, DVec3::ZERO);
        for (m, start, end) in points.clone() {
            let m = f64::from(m);
            mass += m;
            from += start.as_dvec3() * m;
            to += end.as_dvec3() * m;
        }
        let (from, to) = (
            from / mass.max(f64::MIN_POSITIVE),
            to / mass.max(f64::MIN_POSITIVE),
        );
        // Columns of Σ m (end - to) (start - from)ᵀ.
        let mut columns = [DVec3::ZERO; 3];
        for (m, start, end) in points {
            let (start, end) = (start.as_dvec3() - from, end.as_dvec3() - to);
            for (column, along) in columns.iter_mut().zip(start.to_array()) {
                *column += end * (along * f64::from(m));
            }
        }
        let mut turn = DQuat::IDENTITY;
        for _ in 0..PASS_COUNT {
            let axes = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| turn * axis);
            let (mut torque, mut size) = (DVec3::ZERO, 0.0);
            for (axis, column) in axes.into_iter().zip(columns) {
                torque += axis.cross(column);
                size += axis.dot(column);
            }
            let by = torque / (f64::abs(size) + f64::MIN_POSITIVE);
            let angle = by.length();
            if !(1.0e-9 < angle && angle.is_finite()) {
                break;
            }
            let (sin, cos) = trig64::sin_cos(0.5 * angle.min(1.0));
            let axis = by / angle * sin;
            turn = (DQuat::from_xyzw(axis.x, axis.y, axis.z, cos) * turn).normalize();
        }
        Self {
            turn: turn.as_quat(),
            from: from.as_vec3(),
            to: to.as_vec3(),
        }
    }

    /// This motion without its turn, which carries a long zone far when little is known of it.
    const fn unturned(self) -> Self {
        Self {
            turn: Quat::IDENTITY,
            ..self
        }
    }

    /// From where it brings something to a point [m].
    pub(crate) fn unapply(&self, point: Vec3) -> Vec3 {
        self.from + self.turn.inverse() * (point - self.to)
    }

    /// Where it brings a point [m].
    pub(crate) fn apply(&self, point: Vec3) -> Vec3 {
        self.to + self.turn * (point - self.from)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rigid_motion_is_found_however_few_points_show_it() {
        let turn = Quat::from_rotation_y(0.3) * Quat::from_rotation_x(-0.2);
        let shift = Vec3::new(0.1, -0.4, 2.0);
        let corner = |index: u8| {
            let bit = |place: u8| f32::from((index >> place) & 1);
            Vec3::new(bit(0), bit(1), bit(2)) + Vec3::new(5.0, 1.0, -3.0)
        };
        for count in [4_u8, 8] {
            let points = (0..count).map(|index| {
                let start = corner(index);
                (1.0 + f32::from(index), start, turn * start + shift)
            });
            let motion = Rigid::fit(points.clone());
            for (_, start, end) in points {
                assert!(motion.apply(start).distance(end) < 1.0e-5, "{count}");
            }
        }
        // A line turns about itself no more than it must, and a point not at all.
        let line = [(1.0, Vec3::X, Vec3::Y), (1.0, -Vec3::X, -Vec3::Y)];
        let motion = Rigid::fit(line.into_iter());
        assert!(motion.apply(Vec3::Z).distance(Vec3::Z) < 1.0e-5);
        let point = Rigid::fit([(2.0, Vec3::X, Vec3::Z)].into_iter());
        assert!(point.apply(Vec3::X + Vec3::Y).distance(Vec3::Z + Vec3::Y) < 1.0e-6);
    }
}
