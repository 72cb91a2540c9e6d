//! Contact with the skinned body itself: what is drawn is what is touched.
//!
//! The body is given as surfels, so many that the nearest one's tangent plane stands for the skin.
//! Once a step every particle that may get there takes the plane of the surfel nearest to it in the
//! middle of the step; in the substeps the plane moves and turns with the skin. Nothing is kept from
//! step to step but how far the skin has receded where it would tear the cloth.

mod cells;
mod facing;
mod nearness;
mod planes;
pub(crate) mod room;
mod search;
mod yielding;

use std::ops::Range;

use fearless_simd::{Level, Simd, f32x16, prelude::*};
use glam::Vec3;
use lole_geom::Surfel;

use crate::collision::placement::Placement;
use crate::collision::response::{Contact, ContactRow};
use crate::lanes::{LANES, Points, SlotSet, Vectors, smaller};
use crate::step::Progress;
pub(crate) use cells::SurfelCells;
use planes::{PlaneField, PlanesNow};
use room::Hanging;
use search::SurfelSearch;
use yielding::Yielding;

/// A particle that comes nearer to a surfel than this [m], besides what both may travel, takes its
/// plane.
pub(crate) const REACH: f32 = 0.012;

/// Farthest surfel that is looked for [m], whatever the speeds.
pub(crate) const REACH_MAX: f32 = 0.06;

/// Farthest that a particle is believed to fly on in a step, beside what the body does [m]: what
/// trembles between elastics does not.
const FORESIGHT: f32 = 0.016;

/// Particles nearer than this to a surfel [m] may be pinched between it and another.
const PINCH_REACH: f32 = 0.02;

/// Columns nearer together than this [m] share surfels.
const CLOSE: f32 = 0.008;

/// How much farther than its speed promises a particle may come in half a step.
const SPEED_MARGIN: f32 = 1.5;

/// Skin that gives way by less than this [m] is not worth a word.
const NOTICED: f32 = 0.001;

/// How much more than is missing both sides give way where cloth has no room between them: half would
/// leave it none to move in.
const GIVING: f32 = 4.0;

/// Cloth this far inside of the distance that it keeps from the skin [m], and stretched, hangs on something:
/// what is only pulled tight over a knee lies on it.
const HOOKED: f32 = 0.01;

/// Farthest that cloth and skin may move towards each other from one search to the next [m]: less than half as
/// thick as a wrist is, so that the plane of the nearest surfel is that of the side from which cloth comes.
const TRAVEL_MAX: f32 = 0.04;

/// The skin near each particle during one step.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct SurfelContacts {
    /// Planes of the nearest surfels.
    nearest: PlaneField,
    /// Planes of the nearest surfels that face the other way, where cloth is pinched between two limbs.
    opposite: PlaneField,
    /// Parts of a step, each with a search of its own, and the substeps of the present one.
    part_count: u32,
    part: Range<u32>,
    /// The skin at the ends of a part, where there are several.
    ends: [Vec<Surfel>; 2],
    cells: SurfelCells,
    search: SurfelSearch,
    yielding: Yielding,
    /// What lies deeper in the body than surfels are looked for: known to the caller for the next step, and in
    /// this one; and its planes.
    pub(crate) deep_next: Vec<Deep>,
    deep_now: Vec<Deep>,
    deep: PlaneField,
    /// What had no room outside of the skin when this step began: told, and nothing follows from it.
    pub(crate) without_room: SlotSet,
}

/// A particle deep in a body, and the skin through which it comes out at the start and the end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Deep {
    /// Vector and lane.
    pub(crate) slot: (usize, usize),
    pub(crate) ends: [Surfel; 2],
}

/// The skin during one step.
#[derive(Clone, Copy)]
pub(crate) struct Skin<'a> {
    /// At the start, and at the end, in the same order.
    pub(crate) before: &'a [Surfel],
    pub(crate) after: &'a [Surfel],
    /// Distance kept from it [m].
    pub(crate) offset: f32,
}

/// The cloth at the start of a step.
#[derive(Clone, Copy)]
pub(crate) struct Cloth<'a> {
    pub(crate) layout: &'a dyn Placement,
    pub(crate) positions: &'a [Points],
    pub(crate) velocities: &'a [Points],
    /// By row, how far inside the skin's offset its particles may stay [m].
    pub(crate) held: &'a [f32],
    /// Of its columns [m]; infinite where neighbors in a row are none on the cloth.
    pub(crate) spacing: f32,
    /// What gravity adds to a speed in the step [m/s], and the step [s].
    pub(crate) speed_gain: f32,
    pub(crate) dt: f32,
    /// What a repair has held back in the step before: skin yields to it.
    pub(crate) held_back: &'a SlotSet,
    /// Stretch from which it yields to what hangs in it.
    pub(crate) torn: f32,
    /// From which pins its particles hang, and how far it is stretched.
    pub(crate) hanging: &'a dyn Hanging,
}

/// A cloth and the skin that it may touch in a step.
#[derive(Clone, Copy)]
pub(crate) struct Encounter<'a> {
    pub(crate) cloth: Cloth<'a>,
    pub(crate) skin: Skin<'a>,
}

impl Encounter<'_> {
    /// Where a particle is in the middle of the step if it flies on, and how far from there it may
    /// come to touch the skin [m].
    fn flight(&self, (vector, lane): (usize, usize), cells: &SurfelCells) -> (Vec3, f32) {
        let cloth = &self.cloth;
        let common = cells.mean_motion();
        let away = cloth.velocities[vector].get(lane) * cloth.dt - common;
        let travel = away.length() + cells.spread() + cloth.speed_gain * cloth.dt;
        let reach = REACH + self.skin.offset + SPEED_MARGIN * 0.5 * travel;
        let flown = (common + away.clamp_length_max(FORESIGHT)) * 0.5;
        let middle = cloth.positions[vector].get(lane) + flown;
        (middle, reach.min(REACH_MAX))
    }
}

impl SurfelContacts {
    /// Memory that it holds [byte].
    pub(crate) fn byte_count(&self) -> usize {
        self.nearest.byte_count()
            + self.opposite.byte_count()
            + self.cells.byte_count()
            + self.search.byte_count()
            + self.yielding.byte_count()
            + self.without_room.byte_count()
            + self.deep.byte_count()
    }

    /// Lets all skin be where it is: the cloth is another.
    pub(crate) fn forget(&mut self) {
        self.yielding = Yielding::default();
        self.without_room.clear();
        self.deep_next.clear();
    }

    /// Plans a step of so many substeps: where something is fast, the nearest surfels are looked for
    /// several times.
    #[inline(never)]
    pub(crate) fn plan(&mut self, encounter: Encounter<'_>, substep_count: u32) {
        let Encounter { cloth, skin } = encounter;
        self.nearest.clear(0);
        self.deep.clear(0);
        std::mem::swap(&mut self.deep_now, &mut self.deep_next);
        self.deep_next.clear();
        self.part = 0..0;
        self.without_room.clear();
        self.yielding.come_back(cloth.dt);
        if skin.after.is_empty() {
            self.part_count = 0;
            return;
        }
        self.cells
            .sort(skin, bounds(cloth.positions), REACH_MAX + skin.offset);
        let mean = self.cells.mean_motion() / cloth.dt;
        let fastest = (cloth.velocities.iter())
            .flat_map(|points| (0..LANES).map(|lane| points.get(lane)))
            .map(|velocity| velocity.distance_squared(mean))
            .fold(0.0, f32::max);
        let travel = (fastest.sqrt() + cloth.speed_gain) * cloth.dt + self.cells.spread();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "as many as there are substeps at most"
        )]
        let part_count = (travel / TRAVEL_MAX).ceil().min(1024.0) as u32;
        self.part_count = part_count.clamp(1, substep_count);
    }

    /// Finds the planes anew if a part of the step begins with a substep.
    pub(crate) fn begin_substep(
        &mut self,
        level: Level,
        (index, substep_count): (u32, u32),
        encounter: Encounter<'_>,
    ) {
        if self.part_count == 0 || self.part.contains(&index) {
            return;
        }
        let part = index * self.part_count / substep_count;
        let start_of = |part: u32| (part * substep_count).div_ceil(self.part_count);
        self.part = start_of(part)..start_of(part + 1);
        let Encounter { cloth, skin } = encounter;
        let shares = [self.part.start, self.part.end].map(|end| ratio(end, substep_count));
        self.set_deep(shares, cloth.positions.len(), skin.offset);
        if self.part_count == 1 {
            self.find(level, encounter);
            return;
        }
        let mut ends = std::mem::take(&mut self.ends);
        for (end, share) in ends.iter_mut().zip(shares) {
            end.clear();
            let pairs = skin.before.iter().zip(skin.after);
            end.extend(pairs.map(|(before, after)| before.lerp(after, share)));
        }
        let cloth = Cloth {
            dt: cloth.dt * (shares[1] - shares[0]),
            ..cloth
        };
        let skin = Skin {
            before: &ends[0],
            after: &ends[1],
            ..skin
        };
        self.cells
            .sort(skin, bounds(cloth.positions), REACH_MAX + skin.offset);
        self.find(level, Encounter { cloth, skin });
        self.ends = ends;
    }

    /// Gives what is deep its planes between two shares of the step.
    fn set_deep(&mut self, shares: [f32; 2], vector_count: usize, offset: f32) {
        if self.deep_now.is_empty() {
            return;
        }
        self.deep.clear(vector_count);
        for deep in &self.deep_now {
            let [before, after] = &deep.ends;
            let [start, end] = shares.map(|share| before.lerp(after, share));
            self.deep.set(deep.slot, [&start, &end], offset);
        }
    }

    /// How far the present part of the step has come at the end of a substep.
    pub(crate) fn progress(&self, index: u32) -> Progress {
        if self.part.is_empty() {
            return Progress::after(1, 1);
        }
        let count = self.part.end - self.part.start;
        Progress::after(index + 1 - self.part.start, count)
    }

    /// Finds the planes anew, the cells being sorted. Not inlined into vector code: it would change
    /// kinds of instructions.
    #[inline(never)]
    fn find(&mut self, level: Level, encounter: Encounter<'_>) {
        let Encounter { cloth, skin } = encounter;
        let Self {
            cells,
            search,
            nearest,
            opposite,
            yielding,
            without_room,
            part,
            ..
        } = self;
        nearest.clear(cloth.positions.len());
        opposite.clear(cloth.positions.len());
        search.find(level, cells, encounter);
        let ends = |place: usize| {
            let surfel = cells.surfel(place);
            [&skin.before[surfel], &skin.after[surfel]]
        };
        let is_first = part.start == 0;
        let common = cells.mean_motion();
        search.each(cloth, |slot, row, place, against| {
            let at = cloth.positions[slot.0].get(slot.1);
            let wanted = skin.offset - cloth.held[row];
            if is_first {
                let [start, end] = ends(place);
                let out = |at: Vec3, surfel: &Surfel| (at - surfel.position).dot(surfel.normal);
                // Nor is it pushed on in the step: a knee that is raised goes on.
                let deep = wanted - out(at, start).min(out(at + common, end));
                let is_held = cloth.held_back.contains(slot);
                if is_held || HOOKED < deep && room::is_torn(cloth, slot) {
                    yielding.recede(slot, cloth.positions.len(), deep);
                }
            }
            let wanted = wanted - yielding.depth(slot);
            let anchor = cloth.hanging.anchor(slot);
            let within = |place: usize| match anchor {
                Some(anchor) => anchor.within(cloth, ends(place), wanted),
                None => wanted,
            };
            let offset = within(place);
            // What the skin does not reach has no need of room.
            let is_in = room::room(at, ends(place), wanted) < -NOTICED;
            if is_first && is_in && offset < wanted - NOTICED {
                without_room.insert(slot, cloth.positions.len());
            }
            let mut give = 0.0;
            if let Some(other) = against {
                let other_offset = within(other);
                let gap =
                    room::room(at, ends(place), offset) + room::room(at, ends(other), other_offset);
                give = GIVING * (-gap).max(0.0);
                if is_first && NOTICED < give {
                    without_room.insert(slot, cloth.positions.len());
                }
                opposite.set(slot, ends(other), other_offset - give);
            }
            nearest.set(slot, ends(place), offset - give);
        });
    }

    /// Where the particle of a vector and lane is that was at `position` [m] at the end of the step and
    /// leaves the skin if it is in it.
    pub(crate) fn outside(&self, (vector, lane): (usize, usize), position: Vec3) -> Vec3 {
        let mut position = position;
        let mut room = f32::INFINITY;
        for field in [&self.nearest, &self.opposite] {
            if let Some((normal, level)) = field.at_end(vector, lane) {
                let overlap = level - normal.dot(position);
                // Where there is too little room for both, it stays in the middle.
                let overlap = overlap.min(0.5 * (overlap + room)).max(0.0);
                position += normal * overlap;
                room = normal.dot(position) - level;
            }
        }
        position
    }

    /// Whether no particle comes near the skin.
    pub(crate) const fn is_empty(&self) -> bool {
        self.nearest.is_empty() && self.deep.is_empty()
    }
}

impl ContactRow<'_> {
    /// Projects the row out of the skin as it is when the step, or the part of it for which planes
    /// were found, has come so far.
    #[inline(always)]
    pub(crate) fn project_out_of_skin<S: Simd>(
        &mut self,
        simd: S,
        contacts: &SurfelContacts,
        progress: Progress,
    ) {
        if !contacts.deep.is_empty() {
            self.project_out_of_depth(simd, &contacts.deep, progress);
        }
        for index in 0..self.positions.len() {
            let vector = self.first + index;
            let Some(plane) = contacts.nearest.now(simd, vector, progress) else {
                continue;
            };
            let position = Vectors::load(simd, &self.positions[index]);
            let overlap = plane.level - plane.normal.dot(position);
            self.meet_planes(simd, index, &plane, overlap);
            let Some(other) = contacts.opposite.now(simd, vector, progress) else {
                continue;
            };
            let position = Vectors::load(simd, &self.positions[index]);
            let overlap = other.level - other.normal.dot(position);
            // Where there is too little room for both, the cloth stays in the middle.
            let room = plane.normal.dot(position) - plane.level;
            let overlap = smaller(overlap, (overlap + room) * 0.5);
            self.meet_planes(simd, index, &other, overlap);
        }
    }

    /// Projects what lies deep in the body towards where it comes out.
    #[inline(always)]
    fn project_out_of_depth<S: Simd>(&mut self, simd: S, deep: &PlaneField, progress: Progress) {
        for index in 0..self.positions.len() {
            let Some(plane) = deep.now(simd, self.first + index, progress) else {
                continue;
            };
            let position = Vectors::load(simd, &self.positions[index]);
            let overlap = plane.level - plane.normal.dot(position);
            self.meet_planes(simd, index, &plane, overlap);
        }
    }

    /// Pushes the particles of a vector out of the planes that they overlap, so far [m].
    #[inline(always)]
    fn meet_planes<S: Simd>(
        &mut self,
        simd: S,
        index: usize,
        planes: &PlanesNow<'_, S>,
        overlap: f32x16<S>,
    ) {
        let zero = f32x16::splat(simd, 0.0);
        let inv_mass = f32x16::load_array_ref(simd, &self.inv_masses[index].0);
        let touching = zero.simd_lt(smaller(overlap, inv_mass));
        if !touching.any_true() {
            return;
        }
        let contact = Contact {
            touching,
            normal: planes.normal,
            overlap,
            surface: planes.motion(simd),
        };
        let position = Vectors::load(simd, &self.positions[index]);
        self.push_out::<S, true>(simd, index, position, &contact);
    }
}

/// Box around all particles.
fn bounds(positions: &[Points]) -> [Vec3; 2] {
    let mut low = Vec3::INFINITY;
    let mut high = Vec3::NEG_INFINITY;
    for points in positions {
        for lane in 0..LANES {
            low = low.min(points.get(lane));
            high = high.max(points.get(lane));
        }
    }
    [low, high]
}

#[expect(clippy::cast_precision_loss, reason = "substeps are few")]
const fn ratio(part: u32, whole: u32) -> f32 {
    part as f32 / whole as f32
}
