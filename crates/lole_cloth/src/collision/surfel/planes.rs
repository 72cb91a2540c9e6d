//! Tangent planes of the skin that particles may touch in a step.

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::Vec3;
use lole_geom::Surfel;

use crate::lanes::{LANES, Points, Scalars, Vectors, narrow};
use crate::step::Progress;

/// Planes that the particles of a vector may touch in a step: inside is where
/// `normal · x < level`. Lanes without one have a zero normal and a negative level.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Planes {
    /// At the start of the step: unit normal and level [m].
    normal: Points,
    level: Scalars,
    /// What the end of the step has more.
    normal_change: Points,
    level_change: Scalars,
}

const NOWHERE: Planes = Planes {
    normal: Points {
        x: [0.0; LANES],
        y: [0.0; LANES],
        z: [0.0; LANES],
    },
    level: Scalars([-1.0; LANES]),
    normal_change: Points {
        x: [0.0; LANES],
        y: [0.0; LANES],
        z: [0.0; LANES],
    },
    level_change: Scalars([0.0; LANES]),
};

/// A plane or none for every particle.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct PlaneField {
    /// Index into `planes` and one more for every vector, 0 where none of its particles has one.
    slots: Vec<u32>,
    planes: Vec<Planes>,
    /// What the surface does in the step [m], in the order of `planes`.
    motions: Vec<Points>,
}

/// The planes of a vector at the end of a substep.
pub(super) struct PlanesNow<'a, S: Simd> {
    /// Unit normals, out of the body; zero where there is no plane.
    pub(super) normal: Vectors<S>,
    /// What `normal · x` is on the plane [m].
    pub(super) level: f32x16<S>,
    /// What the surface does in all of the step [m], and the substep's share of it.
    motion: &'a Points,
    share: f32,
}

impl<S: Simd> PlanesNow<'_, S> {
    /// What the surface has done in the substep [m].
    #[inline(always)]
    pub(super) fn motion(&self, simd: S) -> Vectors<S> {
        Vectors::load(simd, self.motion).scale(f32x16::splat(simd, self.share))
    }
}

impl PlaneField {
    /// Memory that it holds [byte].
    pub(super) const fn byte_count(&self) -> usize {
        size_of_val(self.slots.as_slice())
            + size_of_val(self.planes.as_slice())
            + size_of_val(self.motions.as_slice())
    }

    /// Forgets all planes of so many vectors.
    pub(super) fn clear(&mut self, vector_count: usize) {
        self.slots.clear();
        self.slots.resize(vector_count, 0);
        self.planes.clear();
        self.motions.clear();
    }

    /// Whether no particle has one.
    pub(super) const fn is_empty(&self) -> bool {
        self.planes.is_empty()
    }

    /// Gives a particle the plane that lies `offset` [m] outside a surfel, known at the start and at
    /// the end of the step.
    pub(super) fn set(
        &mut self,
        (vector, lane): (usize, usize),
        [before, after]: [&Surfel; 2],
        offset: f32,
    ) {
        if self.slots[vector] == 0 {
            self.planes.push(NOWHERE);
            self.motions.push(Points::default());
            self.slots[vector] = narrow(self.planes.len());
        }
        let slot = self.slots[vector] as usize - 1;
        let planes = &mut self.planes[slot];
        let levels = [before, after].map(|surfel| surfel.normal.dot(surfel.position) + offset);
        planes.normal.set(lane, before.normal);
        planes.normal_change.set(lane, after.normal - before.normal);
        planes.level.0[lane] = levels[0];
        planes.level_change.0[lane] = levels[1] - levels[0];
        self.motions[slot].set(lane, after.position - before.position);
    }

    /// The planes of a vector when the step has come so far, if any of its particles has one.
    #[inline(always)]
    pub(super) fn now<S: Simd>(
        &self,
        simd: S,
        vector: usize,
        progress: Progress,
    ) -> Option<PlanesNow<'_, S>> {
        let slot = (self.slots[vector] as usize).checked_sub(1)?;
        let planes = &self.planes[slot];
        let fraction = f32x16::splat(simd, progress.fraction);
        let change = Vectors::load(simd, &planes.normal_change).scale(fraction);
        Some(PlanesNow {
            normal: Vectors::load(simd, &planes.normal).add(change),
            level: f32x16::load_array_ref(simd, &planes.level.0)
                + f32x16::load_array_ref(simd, &planes.level_change.0) * fraction,
            motion: &self.motions[slot],
            share: progress.share,
        })
    }

    /// Normal and level of a particle's plane at the end of the step, if it has one.
    pub(super) fn at_end(&self, vector: usize, lane: usize) -> Option<(Vec3, f32)> {
        let slot = self.slots.get(vector)?.checked_sub(1)?;
        let planes = &self.planes[slot as usize];
        let normal = planes.normal.get(lane) + planes.normal_change.get(lane);
        let level = planes.level.0[lane] + planes.level_change.0[lane];
        (normal != Vec3::ZERO).then_some((normal, level))
    }
}
