//! Pins: particles that go where somebody has them, and how those catch up that had to stay behind.

use glam::Vec3;

use crate::collision::placement::Placement;
use crate::lanes::Points;

/// Part of the way to its target that a pin which was held back catches up in a step, and when it has
/// [m].
const CATCHING_UP: f32 = 0.2;
const CAUGHT_UP: f32 = 0.5e-3;

/// The pinned particles of a cloth.
#[derive(Clone, Copy)]
pub(crate) struct PinSlots<'a> {
    pub(crate) layout: &'a dyn Placement,
    /// Which particles they are.
    pub(crate) indices: &'a [u32],
}

impl PinSlots<'_> {
    /// Vector and lane of each.
    fn slots(&self) -> impl Iterator<Item = (usize, usize)> {
        let indices = self.indices.iter();
        indices.map(|&pin| self.layout.slot(pin as usize))
    }
}

/// Where pins go in a step.
#[derive(Debug, Clone, Default)]
pub(crate) struct PinGoals {
    /// In the order of the pins [m].
    goals: Vec<Vec3>,
}

impl PinGoals {
    /// Memory that it holds [byte].
    pub(crate) const fn byte_count(&self) -> usize {
        size_of_val(self.goals.as_slice())
    }

    /// To their `targets`, or, where a repair has held them back from where they were sent `before`, with
    /// the body and a part of the way on.
    pub(crate) fn set(
        &mut self,
        pins: PinSlots<'_>,
        before: &[Vec3],
        targets: &[Vec3],
        positions: &[Points],
    ) {
        self.goals.clear();
        for (index, ((vector, lane), &target)) in pins.slots().zip(targets).enumerate() {
            let start = positions[vector].get(lane);
            let behind = before
                .get(index)
                .map_or(Vec3::ZERO, |&before| before - start);
            self.goals
                .push(if behind.length_squared() <= CAUGHT_UP * CAUGHT_UP {
                    target
                } else {
                    target - behind * (1.0 - CATCHING_UP)
                });
        }
    }

    /// Pinned particles fly straight to their goals, so every substep finds them on the way.
    pub(crate) fn start(
        &self,
        pins: PinSlots<'_>,
        positions: &[Points],
        velocities: &mut [Points],
        dt: f32,
    ) {
        for ((vector, lane), &goal) in pins.slots().zip(&self.goals) {
            let start = positions[vector].get(lane);
            velocities[vector].set(lane, (goal - start) / dt);
        }
    }

    /// Rounding has moved the pins a little off their goals.
    pub(crate) fn finish(&self, pins: PinSlots<'_>, positions: &mut [Points]) {
        for ((vector, lane), &goal) in pins.slots().zip(&self.goals) {
            positions[vector].set(lane, goal);
        }
    }
}
