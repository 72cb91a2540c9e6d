//! Where there is no room: what the skin may ask of cloth.
//!
//! Two limbs in one place, a thigh that is raised through a band: nothing lies outside of both, or so far
//! out. There the body gives way, and not the cloth.

use glam::Vec3;
use lole_geom::Surfel;

use super::Cloth;
use crate::lanes::Points;

/// Share of the cloth between two pins by which the body may bring what is stretched between them out of
/// the line: it is 5 % longer then.
const SAGGING: f32 = 0.3;

/// Cloth below a pin [m] that lies as it is gathered there, and the share of it by which the body may
/// bring it out: folds turn within millimeters and stretch when they are pushed along the cloth.
const GATHERED: f32 = 0.1;
const PUCKERED: f32 = 0.5;

/// Share of the cloth farther below a pin by which the body may bring it out: as much as cloth may be
/// stretched.
const TAUT: f32 = 1.03;

/// Cloth that is stretched by so much is pushed no farther.
pub(crate) const TORN: f32 = 0.3;

/// From what a particle hangs: a pin, or the line between two of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Anchor {
    /// Vectors and lanes; the same one twice where there is one.
    pub(crate) pins: [(usize, usize); 2],
    /// Share of the way from the first to the second.
    pub(crate) share: f32,
    /// Cloth between the particle and the nearer one [m].
    pub(crate) length: f32,
}

/// How the particles of a cloth hang together.
pub(crate) trait Hanging: Sync {
    /// From what the particle of a vector and lane hangs.
    fn anchor(&self, slot: (usize, usize)) -> Option<Anchor>;

    /// How far the cloth at a particle is stretched, at most, as a share of its length.
    fn stretch_at(&self, positions: &[Points], slot: (usize, usize)) -> f32;
}

impl Anchor {
    /// How far beyond where it hangs [m] the body may bring the particle.
    fn reach(&self) -> f32 {
        let [one, other] = self.pins;
        if one != other {
            return SAGGING * self.length;
        }
        PUCKERED * self.length + (TAUT - PUCKERED) * (self.length - GATHERED).max(0.0)
    }

    /// The distance to keep from a surfel, known at the start and at the end of a step [m]: `offset`, or
    /// less where the cloth does not reach there.
    pub(super) fn within(&self, cloth: Cloth<'_>, ends: [&Surfel; 2], offset: f32) -> f32 {
        let place = |of: &[Points]| {
            let [one, other] = self.pins.map(|(vector, lane)| of[vector].get(lane));
            one.lerp(other, self.share)
        };
        let start = place(cloth.positions);
        let end = start + place(cloth.velocities) * cloth.dt;
        let out = |surfel: &Surfel, from: Vec3| (surfel.position - from).dot(surfel.normal);
        let farthest = out(ends[0], start).max(out(ends[1], end));
        offset.min(self.reach() - farthest)
    }
}

/// Whether the cloth at a particle is stretched so far that the skin gives way to it.
pub(super) fn is_torn(cloth: Cloth<'_>, slot: (usize, usize)) -> bool {
    cloth.torn < cloth.hanging.stretch_at(cloth.positions, slot)
}

/// How far a place is outside of skin that keeps a distance [m], in the middle of a step.
pub(super) fn room(at: Vec3, [before, after]: [&Surfel; 2], offset: f32) -> f32 {
    let middle = (before.position + after.position) * 0.5;
    let normal = (before.normal + after.normal) * 0.5;
    (at - middle).dot(normal) - offset
}
