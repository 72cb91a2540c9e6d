//! How what was moved leaves the body again.

use glam::Vec3;

use super::{CrossingRepair, Fixed};
use crate::collision::surface::Surface;

/// Pairs that may be looked at for each patch while what the repair has left in the body is brought out: where
/// cloth is pressed from both sides it moves nothing.
const LEAVING_EFFORT: usize = 3;

/// Rounds of bringing out of the body what can leave it without crossing.
const LEAVING_ROUNDS: u8 = 8;

impl CrossingRepair {
    /// Brings all that was moved to where the body is not.
    pub(super) fn leave_body(&mut self, fixed: Fixed<'_>) {
        for &particle in &self.moved {
            let position = &mut self.positions[particle as usize];
            *position = outside_body(fixed, particle, *position);
        }
    }

    /// Brings out of the body what the repair has left in it, with what lies on it, as far as
    /// nothing comes to cross by that.
    pub(super) fn leave_body_at_last(&mut self, fixed: Fixed<'_>, starts: &[Vec3]) {
        self.effort_max = self
            .effort_max
            .min(self.effort + self.finder.effort + LEAVING_EFFORT * fixed.surface.patches.len());
        let known = self.finder.crossings.len();
        let moved = self
            .moved
            .iter()
            .map(|&particle| self.positions[particle as usize]);
        self.before.clear();
        self.before.extend(moved);
        self.is_outside.clear();
        self.is_outside.resize(starts.len(), false);
        for round in 0..LEAVING_ROUNDS {
            if self.is_spent() || !self.seat_outside(fixed) {
                if round == 0 {
                    return;
                }
                break;
            }
            self.look_again(fixed);
            for _ in 0..LEAVING_ROUNDS {
                if self.finder.crossings.len() <= known || self.is_spent() {
                    break;
                }
                self.separate_new(starts);
                for index in 0..self.separations.len() {
                    self.part(fixed, self.separations[index]);
                }
                self.effort += self.separations.len() + self.moved.len();
                self.restrain(starts);
                self.look_again(fixed);
            }
        }
        self.is_outside.clear();
        for _ in 0..LEAVING_ROUNDS {
            if self.finder.crossings.len() <= known {
                return;
            }
            self.take_back(fixed.surface, Back::Around);
            self.look_again(fixed);
        }
        if known < self.finder.crossings.len() {
            self.take_moved_back();
            self.look_again(fixed);
        }
    }

    /// Brings what is in the body to its surface and lets it stay there; whether there was any.
    fn seat_outside(&mut self, fixed: Fixed<'_>) -> bool {
        let mut any = false;
        for &particle in &self.moved {
            let position = &mut self.positions[particle as usize];
            let outside = outside_body(fixed, particle, *position);
            if outside != *position {
                *position = outside;
                self.is_outside[particle as usize] = true;
                any = true;
            }
        }
        any
    }

    /// Brings what was moved and crosses to where it was `before`.
    pub(super) fn take_back(&mut self, surface: &Surface, back: Back) {
        let crossed = (self.finder.crossings.iter())
            .flat_map(|crossing| crossing.ends.into_iter().chain(crossing.corners));
        let goes_back = crossed.flat_map(|particle| {
            let around = surface.ring(particle);
            around.filter(move |&it| back == Back::Around || it == particle)
        });
        for particle in goes_back {
            let moved = self.moved_places[particle as usize].checked_sub(1);
            if let Some(place) = moved {
                self.positions[particle as usize] = self.before[place as usize];
            }
        }
    }

    /// Brings all that was moved to where it was `before`.
    pub(super) fn take_moved_back(&mut self) {
        for (&particle, &before) in self.moved.iter().zip(&self.before) {
            self.positions[particle as usize] = before;
        }
    }
}

/// What goes back where something crosses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Back {
    /// What crosses.
    Crossed,
    /// What is near that, too.
    Around,
}

/// Where the nearest point outside the body is [m], the particle's own if it is there.
pub(super) fn outside_body(fixed: Fixed<'_>, particle: u32, position: Vec3) -> Vec3 {
    let (vector, lane) = fixed.layout.slot(particle as usize);
    if fixed.inv_masses[vector].0[lane] <= 0.0 {
        return position;
    }
    fixed.body.outside((vector, lane), position)
}
