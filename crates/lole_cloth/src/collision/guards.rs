//! What a repair has parted stays parted in the substeps of the steps that follow.
//!
//! Where folds are pressed together, springs drive the same edge through the same triangle in every step,
//! and a repair at the end of each would stretch the cloth a little more every time. So an edge and a
//! triangle that were parted are guarded: in all substeps of the next steps they keep to their sides of a
//! plane between them, and springs find their rest with that.

use glam::Vec3;

use crate::collision::face_contact::Moving;
use crate::collision::parting::Touching;
use crate::collision::placement::Placement;
use crate::collision::separation::Separation;
use crate::lanes::{LANES, Scalars};

/// Kept between an edge and a triangle that are guarded [m]: more than a repair leaves between them.
const GAP: f32 = 0.5e-3;

/// Guarded until they are farther apart than this at the end of a step [m].
const LET_GO: f32 = 1.5e-3;

/// Passes over one pair: first the nearest end and corner part, then those that are nearest by then.
const PASS_COUNT: usize = 2;

/// An edge and a triangle, in the engine's own order.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Guard {
    ends: [u32; 2],
    corners: [u32; 3],
    /// Inverse masses of ends and corners [1/kg].
    inv_masses: [f32; 5],
    /// Unit vector from the triangle to the edge.
    normal: Vec3,
}

/// What is guarded.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Guards {
    /// By particle, ascending.
    pairs: Vec<([u32; 2], [u32; 3])>,
    guards: Vec<Guard>,
}

impl Guards {
    /// Memory that it holds [byte].
    pub(crate) const fn byte_count(&self) -> usize {
        size_of_val(self.pairs.as_slice()) + size_of_val(self.guards.as_slice())
    }

    /// Guards nothing any more.
    pub(crate) fn clear(&mut self) {
        self.pairs.clear();
        self.guards.clear();
    }

    /// How many pairs are guarded.
    pub(crate) const fn count(&self) -> usize {
        self.pairs.len()
    }

    /// Whether there is nothing to guard.
    pub(crate) const fn is_empty(&self) -> bool {
        self.guards.is_empty()
    }

    /// Finds the planes between all pairs at the start of a step, where the particles are at `starts` [m].
    pub(crate) fn prepare(
        &mut self,
        starts: &[Vec3],
        layout: &dyn Placement,
        inv_masses: &[Scalars],
    ) {
        let slot = |particle: u32| {
            let (vector, lane) = layout.slot(particle as usize);
            crate::lanes::narrow(vector * LANES + lane)
        };
        let inv_mass = |slot: u32| {
            let slot = slot as usize;
            inv_masses[slot / LANES].0[slot % LANES]
        };
        self.guards.clear();
        for &(ends, corners) in &self.pairs {
            let Some(separation) = Separation::between(ends, corners, starts) else {
                continue;
            };
            let (ends, corners) = (ends.map(slot), corners.map(slot));
            let [a, b] = ends.map(inv_mass);
            let [c, d, e] = corners.map(inv_mass);
            self.guards.push(Guard {
                ends,
                corners,
                inv_masses: [a, b, c, d, e],
                normal: separation.normal,
            });
        }
    }

    /// Keeps all pairs apart in a substep of `h` [s].
    pub(crate) fn solve<M: Moving + ?Sized>(&self, cloth: &mut M, friction: f32, h: f32) {
        for guard in &self.guards {
            for _ in 0..PASS_COUNT {
                if !guard.part(cloth, friction, h) {
                    break;
                }
            }
        }
    }

    /// Guards what is still near at the end of a step, and what was parted in it; but nothing around a
    /// tangle, whose contour must be free to move until it is gone.
    pub(crate) fn renew(&mut self, parted: &[Separation], positions: &[Vec3], is_tangled: &[bool]) {
        let is_free = |&(ends, corners): &([u32; 2], [u32; 3])| {
            let mut particles = ends.into_iter().chain(corners);
            !particles.any(|it| is_tangled.get(it as usize) == Some(&true))
        };
        let is_near = |&(ends, corners): &([u32; 2], [u32; 3])| {
            Separation::distance(ends, corners, positions) < LET_GO
        };
        self.pairs.retain(|pair| is_near(pair) && is_free(pair));
        let parted = parted.iter().map(|it| (it.ends, it.corners));
        self.pairs.extend(parted.filter(is_free));
        self.pairs.sort_unstable();
        self.pairs.dedup();
    }
}

impl Guard {
    /// Moves the end that lies lowest and the corner that lies highest apart; whether they had to.
    fn part<M: Moving + ?Sized>(&self, cloth: &mut M, friction: f32, h: f32) -> bool {
        let height = |slot: u32| cloth.place(0, slot as usize).dot(self.normal);
        let [one, other] = self.ends.map(height);
        let (end, low) = if other < one { (1, other) } else { (0, one) };
        let (mut corner, mut high) = (0, f32::NEG_INFINITY);
        for (place, &slot) in self.corners.iter().enumerate() {
            let height = height(slot);
            if high < height {
                (corner, high) = (place, height);
            }
        }
        let gap = low - high;
        let inv_masses = [self.inv_masses[2 + corner], self.inv_masses[end]];
        let sum = inv_masses[0] + inv_masses[1];
        if GAP <= gap || sum <= 0.0 {
            return false;
        }
        let slots = [self.corners[corner] as usize, self.ends[end] as usize];
        let places = slots.map(|slot| cloth.place(0, slot));
        let travels = [0, 1].map(|side| places[side] - cloth.start(0, slots[side], h));
        let slip = travels[1] - travels[0];
        let touching = Touching {
            gap: self.normal * gap,
            slip,
            side: self.normal,
            diameter: GAP,
        };
        let Some(parting) = touching.part(friction, h) else {
            return false;
        };
        for (side, sign) in [(0, -1.0), (1, 1.0)] {
            let share = sign * inv_masses[side] / sum;
            let quiet = parting.normal * (parting.quiet * share);
            let place = places[side] + parting.change * share;
            cloth.put(0, slots[side], place, quiet);
        }
        true
    }
}
