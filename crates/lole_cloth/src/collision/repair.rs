//! The last word of a step: what has come to cross is taken back, and what crossed before is drawn
//! out.
//!
//! An edge and a triangle that did not cross at the start of the step are brought back to their
//! sides of a plane that lay between them then; along that plane they keep what they did. What
//! crossed already is pushed so that the contour along which the surface intersects itself becomes
//! shorter (Volino and Magnenat-Thalmann 2006, "Resolving surface collisions through intersection
//! contour minimization"), at a limited speed.

mod hold;
mod leave;
pub(crate) mod limit;
mod tangle;

use std::ops::Range;

use fearless_simd::{Level, dispatch};
use glam::Vec3;

use crate::collision::crossing::{Crossing, CrossingFinder, Marked};
use crate::collision::drift::Drift;
use crate::collision::exact::goes_through;
use crate::collision::guards::Guards;
use crate::collision::impact_zone::ImpactZones;
use crate::collision::outside::Outside;
use crate::collision::placement::Placement;
use crate::collision::separation::Separation;
use crate::collision::surface::Surface;
use crate::collision::surfel::room::TORN;
use crate::lanes::{Points, Scalars, SlotSet, narrow};

/// Rounds of looking and bringing apart at most: a repair may make something else cross.
const PARTING_ROUNDS: u8 = 8;

/// Where more than one in so many patches is crossed, folds are so much faster than they are apart that parting
/// them one by one is in vain. Not in two steps on end, or it might never open.
const HOPELESS: usize = 15;

/// Steps for which skin yields to stretched cloth after a hopeless one, and from which stretch on.
const SOFT_STEPS: u32 = 15;
const SOFT_TORN: f32 = 0.1;

/// Pairs that a repair may look at for each patch of the cloth before it comes to an end: it then holds
/// together what it has not parted.
const EFFORT_MAX: usize = 6;

/// Pairs that it may look at for each patch where something crossed before, holding back included: what is
/// drawn out takes longer.
const TANGLE_EFFORT: usize = 8;

/// Sweeps over all repairs in a round.
const SWEEP_COUNT: usize = 4;

/// Kept between an edge and a triangle that were brought back to their sides [m].
const CLEARANCE: f32 = 0.2e-3;

/// Farthest that a repair takes a particle [m], beside what it travelled in the step: planes that
/// nearly face each other would pass it along the wedge between them for meters.
const REPAIR_REACH: f32 = 0.03;

/// Rounds in which tangles are drawn out.
const UNTANGLING_ROUNDS: u8 = 4;

/// What does not change while a repair goes on.
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
        let now = fixed.surface.at(&self.positions);
        dispatch!(fixed.level, simd => finder.find_all(simd, now));
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
        self.start_moving();
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

    /// Starts with nothing moved yet.
    fn start_moving(&mut self) {
        let count = self.positions.len();
        self.moved.clear();
        self.moved_places.clear();
        self.moved_places.resize(count, 0);
        self.looked.clone_from(&self.positions);
        self.has_moved.clear();
        self.has_moved.resize(count, false);
        self.before.clear();
    }

    /// Whether the repair has done as much as it may.
    const fn is_spent(&self) -> bool {
        self.effort_max < self.effort + self.finder.effort
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
        let now = fixed.surface.at(positions);
        dispatch!(fixed.level, simd => finder.find_again(simd, now, has_moved, marked));
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

    fn store(&self, fixed: Fixed<'_>, positions: &mut [Points], velocities: &mut [Points]) {
        self.store_moved(fixed, positions);
        for separation in &self.separations {
            self.stop_approach(fixed, separation, velocities);
        }
    }

    fn store_moved(&self, fixed: Fixed<'_>, positions: &mut [Points]) {
        for &particle in &self.moved {
            let (vector, lane) = fixed.layout.slot(particle as usize);
            positions[vector].set(lane, self.positions[particle as usize]);
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

/// Whether what crosses now did so at `starts` [m].
fn crossed_at(starts: &[Vec3], crossing: &Crossing) -> bool {
    let segment = crossing.ends.map(|end| starts[end as usize]);
    let triangle = crossing.corners.map(|corner| starts[corner as usize]);
    goes_through(segment, triangle)
}
