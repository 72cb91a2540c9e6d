//! Everything that acts on the particles at one moment.

use glam::DVec3;
use rayon::prelude::*;

use super::{BLOCK, ExplicitConfig, PARALLEL_FROM};
use crate::collision::penalty::{CapsuleShape, MovingCapsule, contact_force, friction_force};
use crate::method::paper;
use crate::method::reference::ReferenceModel;

/// Everything that acts on the particles at one moment.
pub(super) struct World<'a> {
    pub(super) model: &'a ReferenceModel,
    pub(super) config: &'a ExplicitConfig,
    pub(super) bodies: Vec<MovingCapsule>,
    /// Equation (4) [N].
    pub(super) wind: DVec3,
    /// Duration of the substep [s], for friction that stops what slides.
    pub(super) dt: f64,
}

/// What contact does to a block of particles.
#[derive(Clone, Copy)]
pub(super) enum BlockContact<'a> {
    /// Worked out from the capsules near the block.
    Near(&'a NearbyBodies<'a>),
    /// Forces [N] by particle, worked out earlier.
    Held(&'a [DVec3]),
}

impl World<'_> {
    /// Equation (7) of the particle `index` at `positions[index]`, moving at `velocity`.
    #[inline]
    pub(super) fn acceleration(
        &self,
        index: usize,
        positions: &[DVec3],
        velocity: DVec3,
        contact: BlockContact<'_>,
    ) -> DVec3 {
        let mass = self.model.masses()[index];
        let mut forces = self.forces(index, positions, velocity);
        forces.penalty = match contact {
            BlockContact::Held(penalties) => penalties[index],
            BlockContact::Near(nearby) if nearby.mask == 0 => DVec3::ZERO,
            BlockContact::Near(nearby) => {
                self.penalty(nearby, [positions[index], velocity], &forces, mass)
            }
        };
        paper::acceleration(mass, paper::total_force(&forces))
    }

    /// The forces of equation (6) but for contact.
    #[inline]
    fn forces(&self, index: usize, positions: &[DVec3], velocity: DVec3) -> paper::Forces {
        let mass = self.model.masses()[index];
        paper::Forces {
            gravity: paper::gravity_force(mass, self.config.gravity),
            damper: paper::damper_force(self.model.drag_rate() * mass, velocity),
            stretch: self.model.internal_force(index, positions),
            wind: self.wind,
            penalty: DVec3::ZERO,
        }
    }

    /// Equation (7) of every free particle into `out`; zero where pinned. Contact forces are
    /// `held` if given.
    pub(super) fn accelerations(
        &self,
        positions: &[DVec3],
        velocities: &[DVec3],
        held: Option<&[DVec3]>,
        out: &mut [DVec3],
    ) {
        for_blocks(out, |first, block| {
            let nearby = NearbyBodies::new(self, &positions[first..first + block.len()]);
            let contact = held.map_or(BlockContact::Near(&nearby), BlockContact::Held);
            for (index, acceleration) in (first..).zip(block) {
                *acceleration = if self.model.pinned()[index] {
                    DVec3::ZERO
                } else {
                    self.acceleration(index, positions, velocities[index], contact)
                };
            }
        });
    }

    /// Equation (14) [N] on every free particle into `out`; zero where pinned.
    pub(super) fn penalties(&self, positions: &[DVec3], velocities: &[DVec3], out: &mut [DVec3]) {
        for_blocks(out, |first, block| {
            let nearby = NearbyBodies::new(self, &positions[first..first + block.len()]);
            for (index, force) in (first..).zip(block) {
                *force = DVec3::ZERO;
                if nearby.mask != 0 && !self.model.pinned()[index] {
                    let moving = [positions[index], velocities[index]];
                    let forces = self.forces(index, positions, velocities[index]);
                    let mass = self.model.masses()[index];
                    *force = self.penalty(&nearby, moving, &forces, mass);
                }
            }
        });
    }

    /// Equation (14) with its direction, and friction, on the particle with this position and velocity
    /// under the other `forces`.
    fn penalty(
        &self,
        nearby: &NearbyBodies<'_>,
        [position, velocity]: [DVec3; 2],
        forces: &paper::Forces,
        mass: f64,
    ) -> DVec3 {
        let penalty = &self.config.penalty;
        let Some(contact) = contact_force(penalty, nearby.iter(), position, velocity) else {
            return DVec3::ZERO;
        };
        if penalty.friction <= 0.0 {
            return contact.force;
        }
        let driving = paper::total_force(forces) + contact.force;
        let next_velocity = velocity + driving * (self.dt / mass);
        let max_friction = penalty.friction * contact.force.length();
        contact.force
            + friction_force(
                &contact.deepest,
                max_friction,
                next_velocity,
                mass / self.dt,
            )
    }
}

/// Runs `work` on every block of `values` with the index of its first: on threads where there are
/// many.
fn for_blocks(values: &mut [DVec3], work: impl Fn(usize, &mut [DVec3]) + Sync) {
    if values.len() < PARALLEL_FROM {
        for (block, values) in values.chunks_mut(BLOCK).enumerate() {
            work(block * BLOCK, values);
        }
    } else {
        values
            .par_chunks_mut(BLOCK)
            .enumerate()
            .for_each(|(block, values)| work(block * BLOCK, values));
    }
}

/// The capsules whose bounding boxes touch that of a block of particles: exact, because a particle
/// inside a capsule lies inside its box. Infinite cylinders have no box and are all kept.
pub(super) struct NearbyBodies<'a> {
    bodies: &'a [MovingCapsule],
    mask: u64,
}

impl<'a> NearbyBodies<'a> {
    pub(super) fn new(world: &'a World<'_>, positions: &[DVec3]) -> Self {
        let bodies = world.bodies.as_slice();
        if world.config.penalty.shape == CapsuleShape::LiteralInfiniteCylinder {
            let mask = if bodies.is_empty() { 0 } else { u64::MAX };
            return Self { bodies, mask };
        }
        let mut mask = 0;
        if !bodies.is_empty() {
            let mut low = DVec3::INFINITY;
            let mut high = DVec3::NEG_INFINITY;
            for &position in positions {
                low = low.min(position);
                high = high.max(position);
            }
            for (slot, body) in bodies.iter().enumerate() {
                let radius = DVec3::splat(body.radii[0].max(body.radii[1]));
                let is_apart = high.cmplt(body.ends[0].min(body.ends[1]) - radius).any()
                    || (body.ends[0].max(body.ends[1]) + radius).cmplt(low).any();
                // Capsules beyond the mask share its last bit.
                mask |= u64::from(!is_apart) << slot.min(63);
            }
        }
        Self { bodies, mask }
    }

    fn iter(&self) -> impl Iterator<Item = &'a MovingCapsule> {
        let mask = self.mask;
        self.bodies
            .iter()
            .enumerate()
            .filter_map(move |(slot, body)| (mask >> slot.min(63) & 1 == 1).then_some(body))
    }
}
