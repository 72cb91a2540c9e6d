//! Contact with the body: projection out of moving capsules with Coulomb friction.

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::Vec3;
use lole_geom::Capsule;

use crate::lanes::{Points, Vectors, larger, smaller};

/// A row nearer to a capsule than this [m] is tested against it in every substep of the step,
/// whatever its speed: 3 cm let cloth through in the first frames of the skirt scene.
const CULL_MARGIN: f32 = 0.06;

/// How much farther than its speed promises a particle may come in one step.
const SPEED_MARGIN: f32 = 1.5;

/// Below this squared axis length [m²] a capsule is a sphere (a thread is 1e-4 m thick).
const DEGENERATE_AXIS_SQUARED: f32 = 1.0e-12;

/// Below this distance [m] from the axis a contact has no direction.
const DEGENERATE_DISTANCE: f32 = 1.0e-7;

/// Below this slip [m] in a substep friction has no direction; it keeps the quotient finite.
const DEGENERATE_SLIP: f32 = 1.0e-12;

/// Passes over the capsules of a row where one pushes into another.
const PASS_COUNT_MAX: u32 = 12;

/// A capsule at the end of a substep, with what it did during it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MovingCapsule {
    start: Vec3,
    axis: Vec3,
    /// `1 / |axis|²` [1/m²]; 0 for a sphere.
    inv_length_squared: f32,
    /// Radius and contact offset at the start, and what the end has more [m].
    radii: [f32; 2],
    /// Displacement of the start during the substep, and what the end moved more [m].
    displacement: Vec3,
    stretch: Vec3,
}

impl MovingCapsule {
    /// The capsule a `fraction` of the way from `before` to `after`, having come there in
    /// `substep_fraction` of the way, with a skin of `contact_offset` [m].
    pub(crate) fn new(
        [before, after]: [&Capsule; 2],
        fraction: f32,
        substep_fraction: f32,
        contact_offset: f32,
    ) -> Self {
        let capsule = before.lerp(after, fraction);
        let axis = capsule.ends[1] - capsule.ends[0];
        let length_squared = axis.length_squared();
        let moved = [0, 1].map(|end| (after.ends[end] - before.ends[end]) * substep_fraction);
        let is_sphere = length_squared < DEGENERATE_AXIS_SQUARED;
        Self {
            start: capsule.ends[0],
            axis,
            inv_length_squared: if is_sphere { 0.0 } else { 1.0 / length_squared },
            radii: [
                capsule.radii[0] + contact_offset,
                capsule.radii[1] - capsule.radii[0],
            ],
            displacement: moved[0],
            stretch: moved[1] - moved[0],
        }
    }
}

/// What a contact needs to know besides where things are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContactLaw {
    /// Coulomb friction coefficient.
    pub(crate) friction: f32,
    /// Farthest that a particle is pushed out in a substep beyond undoing its own approach [m].
    pub(crate) depenetration: f32,
}

/// Projects one vector of particles out of `capsules`.
///
/// `travel` is what the particles did in this substep: friction acts on the part of it that is
/// tangential to the surface, relative to the surface's own motion, and is at most `friction`
/// times the depth projected. Particles may stay `held` [m] inside.
#[inline(always)]
pub(crate) fn project<S: Simd>(
    simd: S,
    position: &mut Vectors<S>,
    before: Vectors<S>,
    (inv_mass, held): (f32x16<S>, f32x16<S>),
    (capsules, indices): (&[MovingCapsule], &[u32]),
    law: ContactLaw,
) {
    for _ in 0..PASS_COUNT_MAX {
        let mut is_touched = false;
        for &index in indices {
            let capsule = &capsules[index as usize];
            is_touched |= project_out(simd, position, before, (inv_mass, held), (capsule, law));
        }
        // Leaving one capsule may enter another: where they meet, once is not enough.
        if !is_touched || indices.len() < 2 {
            break;
        }
    }
}

/// Projects one vector of particles out of one capsule; whether any was inside.
#[inline(always)]
fn project_out<S: Simd>(
    simd: S,
    position: &mut Vectors<S>,
    before: Vectors<S>,
    (inv_mass, held): (f32x16<S>, f32x16<S>),
    (capsule, law): (&MovingCapsule, ContactLaw),
) -> bool {
    let zero = f32x16::splat(simd, 0.0);
    let one = f32x16::splat(simd, 1.0);
    let axis = Vectors::splat(simd, capsule.axis);
    let from_start = position.sub(Vectors::splat(simd, capsule.start));
    let s = smaller(
        larger(from_start.dot(axis) * capsule.inv_length_squared, zero),
        one,
    );
    let normal = from_start.sub(axis.scale(s));
    let squared = normal.dot(normal);
    let radius = larger(s * capsule.radii[1] + capsule.radii[0] - held, zero);
    let touching = squared.simd_lt(radius * radius) & zero.simd_lt(inv_mass);
    if !touching.any_true() {
        return false;
    }
    let distance = squared.sqrt();
    let on_axis = distance.simd_lt(f32x16::splat(simd, DEGENERATE_DISTANCE));
    let inv_distance = one / larger(distance, f32x16::splat(simd, DEGENERATE_DISTANCE));
    let mut normal = normal.scale(inv_distance);
    normal.z = on_axis.select(one, normal.z);
    let surface = Vectors::splat(simd, capsule.displacement)
        .add(Vectors::splat(simd, capsule.stretch).scale(s));
    let slip = position.sub(before).sub(surface);
    let approach = slip.dot(normal);
    let depth = smaller(
        radius - distance,
        // What an earlier pass has pushed counts: the limit holds for all passes together.
        larger(f32x16::splat(simd, law.depenetration) - approach, zero),
    );
    let depth = touching.select(depth, zero);
    if !zero.simd_lt(depth).any_true() {
        return false;
    }
    let tangential = slip.sub(normal.scale(approach));
    let slip_length = tangential.dot(tangential).sqrt() + DEGENERATE_SLIP;
    let held = smaller(depth * law.friction / slip_length, one);
    *position = position
        .add(normal.scale(depth))
        .sub(tangential.scale(held));
    true
}

/// Which capsules each row may touch during a step: list of capsule indices for every row.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct RowContacts {
    /// First entry of every row in `capsule_indices`, and one more.
    starts: Vec<u32>,
    capsule_indices: Vec<u32>,
}

impl RowContacts {
    pub(crate) fn row(&self, row: usize) -> &[u32] {
        &self.capsule_indices[self.starts[row] as usize..self.starts[row + 1] as usize]
    }

    /// Finds them anew for a step of `dt` [s] in which capsules go from `before` to `after`.
    pub(crate) fn find<S: Simd>(
        &mut self,
        simd: S,
        rows: (&[Points], &[Points], usize),
        [before, after]: [&[Capsule]; 2],
        (contact_offset, speed_gain, dt): (f32, f32, f32),
    ) {
        let (positions, velocities, width) = rows;
        self.starts.clear();
        self.capsule_indices.clear();
        self.starts.push(0);
        for (row, speeds) in positions
            .chunks_exact(width)
            .zip(velocities.chunks_exact(width))
        {
            let travel = (fastest(simd, speeds) + speed_gain) * dt;
            for (index, (before, after)) in (0u32..).zip(before.iter().zip(after)) {
                let moved = (after.ends[0] - before.ends[0])
                    .length()
                    .max((after.ends[1] - before.ends[1]).length());
                let reach = (SPEED_MARGIN * (travel + moved)).max(CULL_MARGIN) + contact_offset;
                let grown = Capsule {
                    ends: before.ends,
                    radii: [0, 1].map(|end| before.radii[end].max(after.radii[end]) + reach),
                };
                if touches(
                    simd,
                    row,
                    &MovingCapsule::new([&grown, &grown], 1.0, 0.0, 0.0),
                ) {
                    self.capsule_indices.push(index);
                }
            }
            self.starts
                .push(u32::try_from(self.capsule_indices.len()).unwrap_or(u32::MAX));
        }
    }
}

/// Largest speed in a row.
#[inline(always)]
fn fastest<S: Simd>(simd: S, velocities: &[Points]) -> f32 {
    let mut squared = f32x16::splat(simd, 0.0);
    for velocity in velocities {
        let velocity = Vectors::load(simd, velocity);
        squared = larger(squared, velocity.dot(velocity));
    }
    squared.to_array().into_iter().fold(0.0, f32::max).sqrt()
}

/// Whether any particle of a row lies inside `capsule`.
#[inline(always)]
fn touches<S: Simd>(simd: S, row: &[Points], capsule: &MovingCapsule) -> bool {
    let zero = f32x16::splat(simd, 0.0);
    let one = f32x16::splat(simd, 1.0);
    let axis = Vectors::splat(simd, capsule.axis);
    let start = Vectors::splat(simd, capsule.start);
    row.iter().any(
        #[inline(always)]
        |points| {
            let from_start = Vectors::load(simd, points).sub(start);
            let s = smaller(
                larger(from_start.dot(axis) * capsule.inv_length_squared, zero),
                one,
            );
            let normal = from_start.sub(axis.scale(s));
            let radius = s * capsule.radii[1] + capsule.radii[0];
            normal.dot(normal).simd_lt(radius * radius).any_true()
        },
    )
}
