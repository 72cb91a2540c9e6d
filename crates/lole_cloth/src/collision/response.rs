//! What a particle does that has got into a body: out along the normal, held back by friction.

use fearless_simd::{Select as _, Simd, f32x16, mask32x16, prelude::*};

use crate::lanes::{Points, Scalars, Vectors, larger, smaller};

/// Below this slip [m] in a substep friction has no direction; it keeps the quotient finite.
pub(crate) const DEGENERATE_SLIP: f32 = 1.0e-12;

/// What a contact needs to know besides where things are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContactLaw {
    /// Coulomb friction coefficient.
    pub(crate) friction: f32,
    /// Farthest that a particle is pushed out in a substep beyond undoing its own approach [m].
    pub(crate) depenetration: f32,
}

/// Particles of one row in a substep.
pub(crate) struct ContactRow<'a> {
    /// First vector of the row in the cloth.
    pub(crate) first: usize,
    pub(crate) positions: &'a mut [Points],
    /// Positions predicted at the start of the substep [m].
    pub(crate) predicted: &'a mut [Points],
    /// Velocities that led there [m/s].
    pub(crate) velocities: &'a [Points],
    pub(crate) inv_masses: &'a [Scalars],
    /// Duration of the substep [s].
    pub(crate) h: f32,
    /// How far inside the body particles may stay [m].
    pub(crate) held: f32,
    pub(crate) law: ContactLaw,
}

/// Where particles of one vector touch a surface.
pub(crate) struct Contact<S: Simd> {
    /// Lanes that are inside and free.
    pub(crate) touching: mask32x16<S>,
    /// Unit normals, out of the body.
    pub(crate) normal: Vectors<S>,
    /// How deep inside [m].
    pub(crate) overlap: f32x16<S>,
    /// What the surface did in this substep [m].
    pub(crate) surface: Vectors<S>,
}

impl ContactRow<'_> {
    /// Pushes the touching particles of a vector of the row, at `position` [m], out; whether any moved.
    ///
    /// Friction acts on the part of what a particle did in this substep that is tangential to the
    /// surface, relative to the surface's own motion, and is at most `friction` times the depth
    /// projected. A `QUIET` push gives speed only as far as it stops the particle from coming in: what
    /// got in otherwise, pressed by other cloth for example, leaves without popping.
    #[inline(always)]
    pub(crate) fn push_out<S: Simd, const QUIET: bool>(
        &mut self,
        simd: S,
        index: usize,
        position: Vectors<S>,
        contact: &Contact<S>,
    ) -> bool {
        let law = self.law;
        let zero = f32x16::splat(simd, 0.0);
        let one = f32x16::splat(simd, 1.0);
        let normal = contact.normal;
        let flown = Vectors::load(simd, &self.velocities[index]).scale(f32x16::splat(simd, self.h));
        let predicted = Vectors::load(simd, &self.predicted[index]);
        let before = predicted.sub(flown);
        let slip = position.sub(before).sub(contact.surface);
        let approach = slip.dot(normal);
        let depth = smaller(
            contact.overlap,
            // What an earlier pass has pushed counts: the limit holds for all passes together.
            larger(f32x16::splat(simd, law.depenetration) - approach, zero),
        );
        let depth = contact.touching.select(depth, zero);
        if !zero.simd_lt(depth).any_true() {
            return false;
        }
        let tangential = slip.sub(normal.scale(approach));
        let slip_length = tangential.dot(tangential).sqrt() + DEGENERATE_SLIP;
        // Only what stops a particle presses on it.
        let quiet = if QUIET {
            larger(depth - larger(zero - approach, zero), zero)
        } else {
            zero
        };
        let held = smaller((depth - quiet) * law.friction / slip_length, one);
        position
            .add(normal.scale(depth))
            .sub(tangential.scale(held))
            .store(&mut self.positions[index]);
        if QUIET {
            let predicted = predicted.add(normal.scale(quiet));
            predicted.store(&mut self.predicted[index]);
        }
        true
    }
}
