//! What no push has parted goes only a part of its way: the last means against crossings.

use fearless_simd::dispatch;
use glam::Vec3;

use super::{CrossingRepair, Fixed, crossed_at};
use crate::collision::crossing::CrossingFinder;
use crate::collision::impact_zone::{Pins, STILL, Ways};
use crate::lanes::{Points, narrow};

/// Rounds after those of parting in which what still crosses is held together in zones.
const ZONE_ROUNDS: usize = 48;

/// From this round on what is held grows by rings.
const GROWING_ROUND: usize = 16;

/// After so many rounds of growing, a ring at first and four times as many every time, all of the cloth
/// goes slower, as one, whether its pieces hang together or not.
const SLOWING_ROUND: usize = 4;

/// Rounds in which the whole goes as slowly, the first included: in the others only what still crosses goes
/// slower than that.
const SLOW_ROUNDS: usize = 6;

/// So many rounds are taken even when the repair has done as much as it may: a few hundred particles that
/// are held back cost less than all of the cloth.
const SPARED_ROUND: usize = 6;

/// From this round on pins give way too, where what they do cannot be done without a crossing.
const YIELDING_ROUND: usize = 1;

/// Pairs that may be looked at for each patch while what is left is held back, before all of the cloth is
/// slowed.
const HOLDING_EFFORT: usize = 4;

/// Crossings that a tangle may have more while it is drawn out, beside a quarter of what it had.
const TANGLE_ROOM: usize = 8;

impl CrossingRepair {
    /// Holds back what has come to cross: it goes only a part of its way from where the cloth drifts around it,
    /// then none of it, until no more crosses than may.
    /// In the end there is one zone that moves as a rigid body, and that is so; where it is hopeless from the
    /// start, all of the cloth is slowed first.
    pub(super) fn hold_together(
        &mut self,
        fixed: Fixed<'_>,
        (starts, is_hopeless): (&[Vec3], bool),
    ) {
        self.zones.clear(narrow(starts.len()));
        let ceiling = self.ceiling_at(fixed, starts);
        self.ceiling = Some(ceiling);
        let is_pinned = |particle| Self::inv_mass(fixed, particle) <= 0.0;
        if is_hopeless {
            self.drift.fit_whole(starts, &self.positions, is_pinned);
        } else {
            self.drift.fit(starts, &self.positions, is_pinned);
        }
        let (drift, mut goals) = (
            std::mem::take(&mut self.drift),
            std::mem::take(&mut self.goals),
        );
        goals.clone_from(&self.positions);
        if ceiling == 0 {
            let most = HOLDING_EFFORT * fixed.surface.patches.len();
            self.effort_max = (self.effort_max).max(self.effort + self.finder.effort + most);
        }
        let ways = Ways {
            starts,
            goals: &goals,
            motion: |start| drift.apply(start),
        };
        self.hold_in_rounds(fixed, &ways, (ceiling, is_hopeless));
        (self.drift, self.goals) = (drift, goals);
    }

    /// Holds it back round by round, further and more of it, until at most `ceiling` cross.
    fn hold_in_rounds<M: Fn(Vec3) -> Vec3>(
        &mut self,
        fixed: Fixed<'_>,
        ways: &Ways<'_, M>,
        (ceiling, is_hopeless): (usize, bool),
    ) {
        let starts = ways.starts;
        let mut spent = 0_usize;
        for round in 0..ZONE_ROUNDS {
            if self.finder.crossings.len() <= ceiling {
                return;
            }
            if !is_hopeless || 0 < round {
                self.hold_back(fixed, ways);
            }
            spent += usize::from(SPARED_ROUND <= round && self.is_spent());
            let late = if is_hopeless {
                SLOWING_ROUND + round
            } else if 0 < spent {
                // Rings would be looked at in vain.
                SLOWING_ROUND + spent - 1
            } else {
                round.saturating_sub(GROWING_ROUND)
            };
            if !self.slow(fixed, ways, late) {
                break;
            }
            let pins = if is_hopeless || YIELDING_ROUND <= round {
                Pins::Yield
            } else {
                Pins::Stay
            };
            let inv_mass = |particle| Self::inv_mass(fixed, particle);
            (self.zones).carry((starts, &mut self.positions), inv_mass, pins);
            for index in 0..self.zones.members.len() {
                self.shift(self.zones.members[index], Vec3::ZERO);
            }
            self.look_again(fixed);
        }
        self.carry_all(fixed, ways);
    }

    /// Holds back further what has come to cross, and what lies around it.
    fn hold_back<M: Fn(Vec3) -> Vec3>(&mut self, fixed: Fixed<'_>, ways: &Ways<'_, M>) {
        for crossing in &self.finder.crossings {
            if !crossed_at(ways.starts, crossing) {
                self.zones.hold(crossing, ways);
            }
        }
        self.zones.spread(fixed.surface, ways);
    }

    /// Holds back ring by ring what is around what crosses, then slows down all of the cloth, so that it goes on
    /// opening; `late` counts the rounds of that. Whether there is more to try.
    fn slow<M: Fn(Vec3) -> Vec3>(
        &mut self,
        fixed: Fixed<'_>,
        ways: &Ways<'_, M>,
        late: usize,
    ) -> bool {
        for _ in 0..(1_u32 << (2 * late.min(SLOWING_ROUND))) >> 2 {
            if self.zones.members.len() < ways.starts.len() {
                self.zones.grow(fixed.surface, ways);
            }
        }
        let Some(slower) = late.checked_sub(SLOWING_ROUND) else {
            return true;
        };
        if 0 < slower % SLOW_ROUNDS {
            return true;
        }
        if self.zones.is_one_and_still() {
            return false;
        }
        self.zones
            .join_all(ways, narrow(2 * (slower / SLOW_ROUNDS) + 2));
        true
    }

    /// Crossings that a step may leave: a tangle that is drawn out crosses by some more for a while.
    fn ceiling_at(&self, fixed: Fixed<'_>, starts: &[Vec3]) -> usize {
        self.ceiling.unwrap_or_else(|| {
            let mut finder = CrossingFinder::default();
            let then = fixed.surface.at(starts);
            dispatch!(fixed.level, simd => finder.find_all(simd, then));
            with_room(finder.crossings.len())
        })
    }

    /// The last resort: everything goes as one rigid body. What crosses then lay in one place with something else
    /// at the start, and crossed there but for rounding: from here on it is drawn out as a tangle.
    fn carry_all<M: Fn(Vec3) -> Vec3>(&mut self, fixed: Fixed<'_>, ways: &Ways<'_, M>) {
        self.zones.join_all(ways, STILL);
        let inv_mass = |particle| Self::inv_mass(fixed, particle);
        let moving = (ways.starts, &mut self.positions[..]);
        self.zones.carry(moving, inv_mass, Pins::Yield);
        for particle in 0..narrow(ways.starts.len()) {
            self.shift(particle, Vec3::ZERO);
        }
        self.look_again(fixed);
        let found = self.finder.crossings.len();
        self.ceiling = self.ceiling.map(|least| least.max(with_room(found)));
    }

    /// What was held back goes on as fast as it came, or it would cross again in the next step.
    pub(super) fn slow_down(&self, fixed: Fixed<'_>, starts: &[Vec3], velocities: &mut [Points]) {
        if self.held_back.is_empty() {
            return;
        }
        for &member in &self.zones.members {
            let particle = member as usize;
            let (vector, lane) = fixed.layout.slot(particle);
            let velocity = (self.positions[particle] - starts[particle]) / fixed.dt;
            velocities[vector].set(lane, velocity);
        }
    }
}

/// Crossings that so many may become while they are drawn out.
const fn with_room(count: usize) -> usize {
    match count {
        0 => 0,
        _ => count + count / 4 + TANGLE_ROOM,
    }
}
