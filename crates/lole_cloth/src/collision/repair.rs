//! The last word of a step: what has come to cross is taken back, and what crossed before is drawn
//! out.
//!
//! An edge and a triangle that did not cross at the start of the step are brought back to their
//! sides of a plane that lay between them then; along that plane they keep what they did. What
//! crossed already is pushed so that the contour along which the surface intersects itself becomes
//! shorter (Volino and Magnenat-Thalmann 2006, "Resolving surface collisions through intersection
//! contour minimization"), at a limited speed.

use std::ops::Range;

use fearless_simd::{Level, dispatch};
use glam::Vec3;

use crate::collision::crossing::{Crossing, CrossingFinder, Marked};
use crate::collision::drift::Drift;
use crate::collision::exact::goes_through;
use crate::collision::guards::Guards;
use crate::collision::impact_zone::{ImpactZones, Pins, Ways};
use crate::collision::outside::Outside;
use crate::collision::parting::FARTHEST_LEVER;
use crate::collision::placement::Placement;
use crate::collision::separation::Separation;
use crate::collision::surface::Surface;
use crate::collision::surfel::room::TORN;
use crate::lanes::{Points, Scalars, SlotSet, narrow};

/// Rounds of looking and bringing apart at most: a repair may make something else cross.
const PARTING_ROUNDS: u8 = 8;

/// After those, rounds in which what still crosses is held together in zones.
const ZONE_ROUNDS: usize = 48;

/// From this round on what is held grows by rings.
const GROWING_ROUND: usize = 16;

/// After so many rounds of growing, a ring at first and four times as many every time, all of the cloth
/// goes slower, as one, whether its pieces hang together or not.
const SLOWING_ROUND: usize = 4;

/// Rounds in which the whole goes as slowly, the first included: in the others only what still crosses goes
/// slower than that.
const SLOW_ROUNDS: usize = 6;

/// Where more than one in so many patches is crossed, folds are so much faster than they are apart that parting
/// them one by one is in vain. Not in two steps on end, or it might never open.
const HOPELESS: usize = 10;

/// Steps for which skin yields to stretched cloth after that, and from which stretch on.
const SOFT_STEPS: u32 = 15;
const SOFT_TORN: f32 = 0.1;

/// So many rounds are taken even when the repair has done as much as it may: a few hundred particles that
/// are held back cost less than all of the cloth.
const SPARED_ROUND: usize = 6;

/// From this round on pins give way too, where what they do cannot be done without a crossing.
const YIELDING_ROUND: usize = 1;

/// Pairs that a repair may look at for each patch of the cloth before it comes to an end: it then holds
/// together what it has not parted.
const EFFORT_MAX: usize = 6;

/// The same where something crossed before, holding back included: what is drawn out takes longer.
const TANGLE_EFFORT: usize = 8;

/// The same for holding back what is left then, before all of the cloth is slowed.
const HOLDING_EFFORT: usize = 4;

/// The same for bringing out of the body what the repair has left in it: where cloth is pressed from both sides
/// it moves nothing.
const LEAVING_EFFORT: usize = 3;

/// Sweeps over all repairs in a round.
const SWEEP_COUNT: usize = 4;

/// Kept between an edge and a triangle that were brought back to their sides [m].
const CLEARANCE: f32 = 0.2e-3;

/// Farthest that a repair takes a particle [m], beside what it travelled in the step: planes that
/// nearly face each other would pass it along the wedge between them for meters.
const REPAIR_REACH: f32 = 0.03;

/// Rounds of bringing out of the body what can leave it without crossing.
const LEAVING_ROUNDS: u8 = 8;

/// Rounds in which tangles are drawn out.
const UNTANGLING_ROUNDS: u8 = 4;

/// Crossings that a tangle may have more while it is drawn out, beside a quarter of what it had.
const TANGLE_ROOM: usize = 8;

/// Speed at which a tangle is drawn out [m/s].
const UNTANGLING_SPEED: f32 = 0.2;

/// What never changes.
#[derive(Clone, Copy)]
pub(crate) struct Fixed<'a> {
    pub(crate) level: Level,
    pub(crate) surface: &'a Surface,
    pub(crate) layout: &'a dyn Placement,
    pub(crate) inv_masses: &'a [Scalars],
    pub(crate) body: &'a dyn Outside,
    /// Duration of the step [s].
    pub(crate) dt: f32,
}

/// Finds and repairs crossings.
#[derive(Debug, Clone, Default)]
pub(crate) struct CrossingRepair {
    finder: CrossingFinder,
    /// Row-major.
    positions: Vec<Vec3>,
    separations: Vec<Separation>,
    zones: ImpactZones,
    drift: Drift,
    /// Where everything would go that is not held back [m].
    goals: Vec<Vec3>,
    /// What was done in this repair beside looking for crossings.
    effort: usize,
    /// What may be done, that included.
    effort_max: usize,
    /// Crossings that may be left: none where there were none; `None` where nobody has looked.
    ceiling: Option<usize>,
    /// Particles that the repair has moved, and, by particle, its place among them counted from 1.
    moved: Vec<u32>,
    moved_places: Vec<u32>,
    /// Where everything was when crossings were looked for the last time [m], which particles have moved since,
    /// as they were moved and by particle, and the patches around them.
    looked: Vec<Vec3>,
    since: Vec<u32>,
    has_moved: Vec<bool>,
    moved_patches: Marked,
    /// Where they were before the repair, then before the last of them left the body [m].
    before: Vec<Vec3>,
    /// Which particles have left the body.
    is_outside: Vec<bool>,
    /// What was parted and is kept apart.
    pub(crate) guards: Guards,
    /// Particles near what still crosses at the end of a step; empty where nothing does.
    pub(crate) is_tangled: Vec<bool>,
    /// What was held back in this step.
    pub(crate) held_back: SlotSet,
    /// Steps until the skin is firm again.
    soft_steps: u32,
    /// Whether what it says of its piece is what the repair of all pieces has found.
    pub(crate) is_part: bool,
}

impl CrossingRepair {
    /// Memory that it holds [byte].
    pub(crate) fn byte_count(&self) -> usize {
        self.finder.byte_count()
            + size_of_val(&self.positions[..])
            + size_of_val(&self.separations[..])
            + self.zones.byte_count()
            + self.drift.byte_count()
            + size_of_val(&self.goals[..])
            + size_of_val(&self.moved[..])
            + size_of_val(&self.moved_places[..])
            + size_of_val(&self.looked[..])
            + size_of_val(&self.since[..])
            + size_of_val(&self.has_moved[..])
            + size_of_val(&self.before[..])
            + size_of_val(&self.is_outside[..])
            + size_of_val(&self.is_tangled[..])
            + self.held_back.byte_count()
            + self.moved_patches.byte_count()
            + self.guards.byte_count()
    }

    /// Stretch from which skin lets through what hangs in it: less where a step was hopeless shortly before, so
    /// that the cloth can open again.
    pub(crate) const fn torn(&self) -> f32 {
        if 0 < self.soft_steps { SOFT_TORN } else { TORN }
    }

    /// Forgets what it has done in the steps before.
    pub(crate) fn forget(&mut self) {
        self.is_tangled.clear();
        self.held_back.clear();
        self.guards.clear();
        self.soft_steps = 0;
        self.ceiling = None;
        self.is_part = false;
    }

    /// Says of one piece what the repair of all pieces has found there.
    pub(crate) fn become_part(
        &mut self,
        whole: &Self,
        (vectors, particles): (Range<usize>, Range<usize>),
    ) {
        self.held_back.take_part(&whole.held_back, vectors);
        self.is_tangled.clear();
        let tangled = whole.is_tangled.get(particles).unwrap_or(&[]);
        self.is_tangled.extend_from_slice(tangled);
        self.soft_steps = whole.soft_steps;
        self.is_part = true;
    }

    /// Repairs what came to cross since the particles were at `starts`, row-major [m].
    pub(crate) fn repair(
        &mut self,
        fixed: Fixed<'_>,
        starts: &[Vec3],
        positions: &mut [Points],
        velocities: &mut [Points],
    ) {
        fixed.layout.gather_points(positions, &mut self.positions);
        if !self.positions.iter().all(|position| position.is_finite()) {
            return;
        }
        let finder = &mut self.finder;
        dispatch!(fixed.level, simd => finder.find_all(simd, fixed.surface, &self.positions));
        self.separations.clear();
        self.held_back.clear();
        self.soft_steps = self.soft_steps.saturating_sub(1);
        let found = self.finder.crossings.len();
        if 0 < found {
            self.work(fixed, starts);
            self.leave_body_at_last(fixed, starts);
            if found < self.finder.crossings.len() {
                self.undo(fixed, positions);
            }
            self.store(fixed, positions, velocities);
            self.slow_down(fixed, starts, velocities);
        }
        if self.finder.crossings.is_empty() {
            self.ceiling = Some(0);
        }
        self.remember_tangles(fixed.surface);
        let tangled = &self.is_tangled;
        (self.guards).renew(&self.separations, &self.positions, tangled);
    }

    /// Leaves everything as it came: what was done has made more cross than there was.
    fn undo(&mut self, fixed: Fixed<'_>, positions: &[Points]) {
        fixed.layout.gather_points(positions, &mut self.positions);
        self.separations.clear();
        self.held_back.clear();
        self.look_again(fixed);
    }

    /// Marks what still crosses and the patches around it.
    fn remember_tangles(&mut self, surface: &Surface) {
        self.is_tangled.clear();
        if self.finder.crossings.is_empty() {
            return;
        }
        self.is_tangled.resize(surface.particle_count(), false);
        for crossing in &self.finder.crossings {
            for particle in crossing.ends.into_iter().chain(crossing.corners) {
                for corner in surface.ring(particle) {
                    self.is_tangled[corner as usize] = true;
                }
            }
        }
    }

    fn work(&mut self, fixed: Fixed<'_>, starts: &[Vec3]) {
        self.separations.clear();
        self.moved.clear();
        self.moved_places.clear();
        self.moved_places.resize(starts.len(), 0);
        self.looked.clone_from(&self.positions);
        self.has_moved.clear();
        self.has_moved.resize(starts.len(), false);
        self.before.clear();
        self.effort = 0;
        let effort_max = match self.ceiling {
            Some(0) => EFFORT_MAX,
            _ => TANGLE_EFFORT,
        };
        self.effort_max = effort_max * fixed.surface.patches.len();
        // A tangle that was there from the start is drawn out, however large.
        let is_hopeless = self.ceiling == Some(0)
            && self.soft_steps < SOFT_STEPS - 1
            && fixed.surface.patches.len() < HOPELESS * self.finder.crossings.len();
        if is_hopeless {
            self.soft_steps = SOFT_STEPS;
        }
        for round in 0..PARTING_ROUNDS {
            if is_hopeless || self.is_spent() {
                break;
            }
            let known = self.separations.len();
            self.separate_new(starts);
            let draws_out = round < UNTANGLING_ROUNDS && self.draw_out_tangles(fixed, starts);
            if UNTANGLING_ROUNDS <= round && self.separations.len() == known {
                break;
            }
            for _ in 0..SWEEP_COUNT {
                for index in 0..self.separations.len() {
                    self.part(fixed, self.separations[index]);
                }
                self.restrain(starts);
                self.leave_body(fixed);
            }
            self.effort += SWEEP_COUNT * self.separations.len();
            let found = self.finder.crossings.len();
            self.look_again(fixed);
            if self.finder.crossings.is_empty() {
                return;
            }
            let is_slow = 1 <= round && found < 2 * self.finder.crossings.len();
            if is_slow && !draws_out {
                // What is pressed from both sides is parted by no number of planes.
                break;
            }
        }
        self.hold_together(fixed, (starts, is_hopeless));
        for &member in &self.zones.members {
            let slot = fixed.layout.slot(member as usize);
            self.held_back.insert(slot, fixed.inv_masses.len());
        }
    }

    /// Whether the repair has done as much as it may.
    const fn is_spent(&self) -> bool {
        self.effort_max < self.effort + self.finder.effort
    }

    /// Holds back what has come to cross: it goes only a part of its way from where the cloth drifts around it,
    /// then none of it, until no more crosses than may.
    /// In the end there is one zone that moves as a rigid body, and that is so; where it is hopeless from the
    /// start, all of the cloth is slowed first.
    fn hold_together(&mut self, fixed: Fixed<'_>, (starts, is_hopeless): (&[Vec3], bool)) {
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
            } else {
                round.saturating_sub(GROWING_ROUND).max(spent)
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
        self.take_all_back(fixed, starts);
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
            dispatch!(fixed.level, simd => finder.find_all(simd, fixed.surface, starts));
            match finder.crossings.len() {
                0 => 0,
                count => count + count / 4 + TANGLE_ROOM,
            }
        })
    }

    /// The last resort: where even a rigid motion crosses, by rounding, everything stays where it was.
    fn take_all_back(&mut self, fixed: Fixed<'_>, starts: &[Vec3]) {
        for (particle, &start) in (0..).zip(starts) {
            self.shift(particle, Vec3::ZERO);
            self.positions[particle as usize] = start;
        }
        if self.ceiling == Some(0) {
            // That nothing crossed there is known.
            self.finder.crossings.clear();
        } else {
            self.look_again(fixed);
        }
    }

    /// Finds what crosses now that particles have moved since the last look.
    fn look_again(&mut self, fixed: Fixed<'_>) {
        let (positions, looked) = (&self.positions, &mut self.looked);
        let is_new = |&particle: &u32| {
            let place = particle as usize;
            positions[place] != looked[place]
        };
        self.since.clear();
        self.since.extend(self.moved.iter().copied().filter(is_new));
        for &particle in &self.since {
            let place = particle as usize;
            looked[place] = positions[place];
            self.has_moved[place] = true;
        }
        let (marked, finder, has_moved) = (
            &mut self.moved_patches,
            &mut self.finder,
            &mut self.has_moved,
        );
        marked.set(fixed.surface, &self.since);
        let cloth = (fixed.surface, &positions[..]);
        dispatch!(fixed.level, simd => finder.find_again(simd, cloth, has_moved, marked));
        for &particle in &self.since {
            has_moved[particle as usize] = false;
        }
    }

    /// Makes a separation of every crossing that was none at the start.
    fn separate_new(&mut self, starts: &[Vec3]) {
        // What nothing can move is looked at again too, or it would be taken for parted.
        for index in 0..self.finder.crossings.len() {
            let Crossing { ends, corners, .. } = self.finder.crossings[index];
            for particle in ends.into_iter().chain(corners) {
                self.shift(particle, Vec3::ZERO);
            }
        }
        let new = self.finder.crossings.iter().filter_map(|crossing| {
            if crossed_at(starts, crossing) {
                return None;
            }
            Separation::between(crossing.ends, crossing.corners, starts)
        });
        self.separations.extend(new);
    }

    /// Draws out what crossed at the start already; whether there is any.
    fn draw_out_tangles(&mut self, fixed: Fixed<'_>, starts: &[Vec3]) -> bool {
        let mut any = false;
        for index in 0..self.finder.crossings.len() {
            let crossing = self.finder.crossings[index];
            if crossed_at(starts, &crossing) {
                self.draw_out(fixed, &crossing);
                any = true;
            }
        }
        any
    }

    /// Inverse mass [1/kg]; 0 of what stays where it is.
    fn mobility(&self, fixed: Fixed<'_>, particle: u32) -> f32 {
        if self.is_outside.get(particle as usize) == Some(&true) {
            return 0.0;
        }
        Self::inv_mass(fixed, particle)
    }

    fn inv_mass(fixed: Fixed<'_>, particle: u32) -> f32 {
        let (vector, lane) = fixed.layout.slot(particle as usize);
        fixed.inv_masses[vector].0[lane]
    }

    fn shift(&mut self, particle: u32, by: Vec3) {
        let place = particle as usize;
        if self.moved_places[place] == 0 {
            self.moved.push(particle);
            self.moved_places[place] = narrow(self.moved.len());
            self.before.push(self.positions[place]);
        }
        self.positions[place] += by;
    }

    fn part(&mut self, fixed: Fixed<'_>, separation: Separation) {
        for _ in 0..3 {
            let (end, corner, gap) = separation.closest(&self.positions);
            let inv_masses = [end, corner].map(|particle| self.mobility(fixed, particle));
            let sum = inv_masses[0] + inv_masses[1];
            if CLEARANCE <= gap || sum <= 0.0 {
                return;
            }
            let push = separation.normal * ((CLEARANCE - gap) / sum);
            self.shift(end, push * inv_masses[0]);
            self.shift(corner, -push * inv_masses[1]);
        }
    }

    /// Keeps what was moved within [`REPAIR_REACH`].
    fn restrain(&mut self, starts: &[Vec3]) {
        for (&particle, &before) in self.moved.iter().zip(&self.before) {
            let place = particle as usize;
            let position = self.positions[place];
            let reach = REPAIR_REACH + before.distance(starts[place]);
            let moved = position - before;
            if reach * reach < moved.length_squared() {
                self.positions[place] = before + moved.clamp_length_max(reach);
            }
        }
    }

    fn draw_out(&mut self, fixed: Fixed<'_>, crossing: &Crossing) {
        let opposites = fixed.surface.opposites(crossing.ends);
        let Some(direction) = contour_gradient(&self.positions, crossing, opposites) else {
            return;
        };
        let weights = [
            1.0 - crossing.along,
            crossing.along,
            -crossing.weights.x,
            -crossing.weights.y,
            -crossing.weights.z,
        ];
        let [a, b, c] = crossing.corners;
        let particles = [crossing.ends[0], crossing.ends[1], a, b, c];
        let inv_masses = particles.map(|particle| Self::inv_mass(fixed, particle));
        let (mut sum, mut most) = (0.0, 0.0_f32);
        for (weight, inv_mass) in weights.iter().zip(inv_masses) {
            sum += weight * weight * inv_mass;
            most = most.max(weight.abs() * inv_mass);
        }
        let sum = sum.max(most / FARTHEST_LEVER);
        if sum <= 0.0 {
            return;
        }
        let push = direction * (UNTANGLING_SPEED * fixed.dt / (f32::from(UNTANGLING_ROUNDS) * sum));
        for ((particle, weight), inv_mass) in particles.into_iter().zip(weights).zip(inv_masses) {
            self.shift(particle, push * (weight * inv_mass));
        }
    }

    fn leave_body(&mut self, fixed: Fixed<'_>) {
        for &particle in &self.moved {
            let position = &mut self.positions[particle as usize];
            *position = outside_body(fixed, particle, *position);
        }
    }

    /// Brings out of the body what the repair has left in it, with what lies on it, as far as
    /// nothing comes to cross by that.
    fn leave_body_at_last(&mut self, fixed: Fixed<'_>, starts: &[Vec3]) {
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
            self.take_back(fixed.surface);
            self.look_again(fixed);
        }
        if known < self.finder.crossings.len() {
            for (&particle, &before) in self.moved.iter().zip(&self.before) {
                self.positions[particle as usize] = before;
            }
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

    /// Brings what crosses and what is near that to where it was before the last of the body was
    /// left.
    fn take_back(&mut self, surface: &Surface) {
        for crossing in &self.finder.crossings {
            let [start, end] = crossing.ends;
            let [a, b, c] = crossing.corners;
            for corner in [start, end, a, b, c]
                .into_iter()
                .flat_map(|it| surface.ring(it))
            {
                let moved = self.moved_places[corner as usize].checked_sub(1);
                if let Some(place) = moved {
                    self.positions[corner as usize] = self.before[place as usize];
                }
            }
        }
    }

    fn store(&self, fixed: Fixed<'_>, positions: &mut [Points], velocities: &mut [Points]) {
        for &particle in &self.moved {
            let (vector, lane) = fixed.layout.slot(particle as usize);
            positions[vector].set(lane, self.positions[particle as usize]);
        }
        for separation in &self.separations {
            self.stop_approach(fixed, separation, velocities);
        }
    }

    /// What was held back goes on as fast as it came, or it would cross again in the next step.
    fn slow_down(&self, fixed: Fixed<'_>, starts: &[Vec3], velocities: &mut [Points]) {
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

    /// Takes from an end and a corner what of their approach would bring them together in the next step.
    fn stop_approach(&self, fixed: Fixed<'_>, separation: &Separation, velocities: &mut [Points]) {
        let (end, corner, gap) = separation.closest(&self.positions);
        let slots = [end, corner].map(|particle| fixed.layout.slot(particle as usize));
        let inv_masses = slots.map(|(vector, lane)| fixed.inv_masses[vector].0[lane]);
        let sum = inv_masses[0] + inv_masses[1];
        let speeds = slots.map(|(vector, lane)| velocities[vector].get(lane));
        let allowed = (gap - CLEARANCE).max(0.0) / fixed.dt;
        let approach = (speeds[1] - speeds[0]).dot(separation.normal) - allowed;
        if 0.0 < sum && 0.0 < approach {
            let change = separation.normal * (approach / sum);
            let [end, corner] = slots;
            velocities[end.0].set(end.1, speeds[0] + change * inv_masses[0]);
            velocities[corner.0].set(corner.1, speeds[1] - change * inv_masses[1]);
        }
    }
}

/// Where the nearest point outside the body is [m], the particle's own if it is there.
fn outside_body(fixed: Fixed<'_>, particle: u32, position: Vec3) -> Vec3 {
    let (vector, lane) = fixed.layout.slot(particle as usize);
    if fixed.inv_masses[vector].0[lane] <= 0.0 {
        return position;
    }
    fixed.body.outside((vector, lane), position)
}

/// Whether what crosses now did so at `starts` [m].
fn crossed_at(starts: &[Vec3], crossing: &Crossing) -> bool {
    let segment = crossing.ends.map(|end| starts[end as usize]);
    let triangle = crossing.corners.map(|corner| starts[corner as usize]);
    goes_through(segment, triangle)
}

/// Unit vector along which the edge must move against the triangle for the contour of the
/// intersection to become shorter: the sum over the faces of the edge of `R - 2 (E·R) / (E·N) N`,
/// with the direction `R` of the contour into the face, the edge's `E` and the triangle's normal
/// `N`.
fn contour_gradient(
    positions: &[Vec3],
    crossing: &Crossing,
    opposites: [Option<u32>; 2],
) -> Option<Vec3> {
    let [start, end] = crossing.ends.map(|end| positions[end as usize]);
    let [a, b, c] = crossing.corners.map(|corner| positions[corner as usize]);
    let edge = (end - start).normalize_or_zero();
    let normal = (b - a).cross(c - a).normalize_or_zero();
    let steepness = edge.dot(normal);
    let mut gradient = Vec3::ZERO;
    for opposite in opposites.into_iter().flatten() {
        let into_face = positions[opposite as usize] - start;
        let face_normal = edge.cross(into_face);
        let mut contour = face_normal.cross(normal).normalize_or_zero();
        let inward = into_face - edge * into_face.dot(edge);
        if contour.dot(inward) < 0.0 {
            contour = -contour;
        }
        gradient += contour * steepness - normal * (2.0 * edge.dot(contour));
    }
    let gradient = if steepness < 0.0 { -gradient } else { gradient };
    gradient.try_normalize()
}
