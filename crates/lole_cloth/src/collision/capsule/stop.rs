//! Contact for methods whose substeps are much shorter than contacts need: the tangent planes of
//! the capsules, kept for a few substeps, stop what flies through them.
//!
//! Nothing of the way out becomes velocity, as it does in the real-time method, and a particle that
//! is found behind its plane keeps no velocity along the normal, not even outwards: either would
//! feed the springs. For the same reason planes act in every substep. Acting in every fourth, they
//! drive the springs at a frequency that these have, and the cloth flies apart.

use fearless_simd::{Simd, f32x16, prelude::*};

use super::{DEGENERATE_DISTANCE, MovingCapsule};
use crate::collision::response::DEGENERATE_SLIP;
use crate::lanes::{Points, Scalars, Vectors, larger, smaller};

/// Particles that are nearer to a capsule than this [m] have a plane: farther than cloth at 8 m/s
/// comes in the time for which planes are kept.
const REACH: f32 = 0.006;

/// Where the particles of one vector may not be: behind the planes `normal · x = level`, which move
/// along their normals with the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Planes {
    vector: u32,
    normal: Points,
    /// [m]
    level: Scalars,
    /// Velocity of the surface [m/s].
    surface: Points,
}

/// The tangent planes of all that is near a capsule.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct TangentPlanes(Vec<Planes>);

/// What planes do to those behind them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct StopLaw {
    /// Coulomb friction coefficient.
    pub(crate) friction: f32,
    /// Fastest that a particle found inside is pushed out [m/s].
    pub(crate) depenetration_speed: f32,
    /// Duration of a substep [s].
    pub(crate) h: f32,
    /// Time since the planes were found [s].
    pub(crate) age: f32,
}

/// A capsule whose tangent planes are kept for a while.
#[derive(Debug, Clone, Copy)]
pub(crate) struct KeptCapsule<'a> {
    pub(crate) capsule: &'a MovingCapsule,
    /// How far inside of it particles may stay [m].
    pub(crate) held: f32,
    /// In which it moves by its displacement [s].
    pub(crate) time: f32,
}

/// What flies and may be stopped: all vectors of a cloth.
pub(crate) struct Flying<'a> {
    pub(crate) positions: &'a mut [Points],
    pub(crate) velocities: &'a mut [Points],
    pub(crate) inv_masses: &'a [Scalars],
}

impl TangentPlanes {
    /// Forgets all planes.
    pub(crate) fn clear(&mut self) {
        self.0.clear();
    }

    /// Memory that they hold [byte].
    pub(crate) const fn byte_count(&self) -> usize {
        self.0.capacity() * size_of::<Planes>()
    }

    /// Adds the planes of a capsule for the vectors of a row, which begins with vector `first`.
    #[inline(always)]
    pub(crate) fn add<S: Simd>(
        &mut self,
        simd: S,
        first: usize,
        row: &[Points],
        kept: KeptCapsule<'_>,
    ) {
        for (vector, points) in (first..).zip(row) {
            let position = Vectors::load(simd, points);
            if (kept.capsule).may_touch(simd, position, kept.held - REACH) {
                self.0.push(Planes::new(simd, vector, position, kept));
            }
        }
    }

    /// Stops what is behind the planes.
    #[inline(always)]
    pub(crate) fn stop<S: Simd>(&self, simd: S, flying: &mut Flying<'_>, law: StopLaw) {
        for planes in &self.0 {
            planes.stop(simd, flying, law);
        }
    }
}

impl Planes {
    #[inline(always)]
    fn new<S: Simd>(simd: S, vector: usize, position: Vectors<S>, kept: KeptCapsule<'_>) -> Self {
        let KeptCapsule {
            capsule,
            held,
            time,
        } = kept;
        let one = f32x16::splat(simd, 1.0);
        let start = Vectors::splat(simd, capsule.start);
        let from_start = position.sub(start);
        let s = capsule.foot(simd, from_start);
        let foot = Vectors::splat(simd, capsule.axis).scale(s);
        let normal = from_start.sub(foot);
        let distance = normal.dot(normal).sqrt();
        let on_axis = distance.simd_lt(f32x16::splat(simd, DEGENERATE_DISTANCE));
        let inv_distance = one / larger(distance, f32x16::splat(simd, DEGENERATE_DISTANCE));
        let mut normal = normal.scale(inv_distance);
        normal.z = on_axis.select(one, normal.z);
        let radius = s * capsule.radii[1] + (capsule.radii[0] - held);
        let level = start.add(foot).dot(normal) + larger(radius, f32x16::splat(simd, 0.0));
        let surface = Vectors::splat(simd, capsule.displacement / time)
            .add(Vectors::splat(simd, capsule.stretch / time).scale(s));
        #[expect(
            clippy::cast_possible_truncation,
            reason = "vectors are counted in u32"
        )]
        let mut planes = Self {
            vector: vector as u32,
            normal: Points::default(),
            level: Scalars(level.to_array()),
            surface: Points::default(),
        };
        normal.store(&mut planes.normal);
        surface.store(&mut planes.surface);
        planes
    }

    #[inline(always)]
    fn stop<S: Simd>(&self, simd: S, flying: &mut Flying<'_>, law: StopLaw) {
        let vector = self.vector as usize;
        let positions = &mut flying.positions[vector];
        let velocities = &mut flying.velocities[vector];
        let inv_mass = &flying.inv_masses[vector];
        let zero = f32x16::splat(simd, 0.0);
        let one = f32x16::splat(simd, 1.0);
        let position = Vectors::load(simd, positions);
        let normal = Vectors::load(simd, &self.normal);
        let surface = Vectors::load(simd, &self.surface);
        let level = f32x16::load_array_ref(simd, &self.level.0) + surface.dot(normal) * law.age;
        let depth = level - position.dot(normal);
        let free = zero.simd_lt(f32x16::load_array_ref(simd, &inv_mass.0));
        let inside = zero.simd_lt(depth) & free;
        if !inside.any_true() {
            return;
        }
        let velocity = Vectors::load(simd, velocities);
        let slip = velocity.sub(surface);
        let rise = slip.dot(normal);
        let pushed = inside.select(larger(zero - rise, zero), zero);
        let depth = smaller(depth, (pushed + law.depenetration_speed) * law.h);
        let depth = inside.select(depth, zero);
        let sliding = slip.sub(normal.scale(rise));
        let speed = sliding.dot(sliding).sqrt() + DEGENERATE_SLIP;
        let braked = sliding.scale(smaller(pushed * law.friction / speed, one));
        position
            .add(normal.scale(depth))
            .sub(braked.scale(f32x16::splat(simd, law.h)))
            .store(positions);
        velocity
            .sub(normal.scale(inside.select(rise, zero)))
            .sub(braked)
            .store(velocities);
    }
}
