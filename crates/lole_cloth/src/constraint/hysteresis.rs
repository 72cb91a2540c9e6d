//! Internal friction: what yarns that rub on each other hold back when cloth bends and shears.
//!
//! Beside each elastic term stands a second spring in series with a slider (Jenkins 1962): while
//! the yarns stick it adds [`STICK_STIFFNESS`] of the elastic stiffness, and at most the force of
//! Coulomb friction that the fabric was measured to have. The force depends on the path and not on
//! the speed, so a frame of any length and a grid of any fineness have the same loop.
//!
//! What is remembered of a term is its *set*, the deformation at which the slider's spring is
//! relaxed. The set follows within half the width of the play, `w = r / stick`, where `r` is the
//! residual deformation that friction holds against the elastic term.
//!
//! Friction of bending acts along the second difference itself and that of shear along the
//! diagonals, so neither changes linear or angular momentum, and what turns or falls as a rigid
//! body feels nothing.

use fearless_simd::{Simd, f32x16, prelude::*, u32x16};

use crate::lanes::{Points, Scalars, Vectors, larger, smaller};

/// Stiffness of a term's yarns while they stick, over its elastic stiffness. KES curves of bending
/// turn over about `2HB / B` after a reversal, which is a ratio of 1 to 2. Estimated.
const STICK_STIFFNESS: f32 = 1.5;

/// A term solved once a substep may take this share of itself away: more would shake it.
const LARGEST_SHARE: f32 = 1.3;
/// However stiff a term is, its yarns stick at least so much: the play must have some width.
const LEAST_STICK: f32 = 0.3;

/// Friction of one family of terms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Friction {
    /// Added stiffness while the yarns stick, over the elastic one.
    stick: f32,
    /// Half the width of the play, in the unit of the deformation.
    play: f32,
}

impl Friction {
    /// Friction that holds a `residual` deformation against terms that take `share` of themselves
    /// away in a substep; `None` where there is none.
    pub(crate) fn new(residual: f32, share: f32) -> Option<Self> {
        if !(0.0 < residual && residual.is_finite()) {
            return None;
        }
        let stick = (LARGEST_SHARE / share - 1.0).clamp(LEAST_STICK, STICK_STIFFNESS);
        Some(Self {
            stick,
            play: residual / stick,
        })
    }

    /// How far the slider's spring is stretched: the way from the set, within the play.
    #[inline(always)]
    fn stretched<S: Simd>(&self, simd: S, way: f32x16<S>) -> f32x16<S> {
        let play = f32x16::splat(simd, self.play);
        larger(smaller(way, play), play * -1.0)
    }
}

/// What a family of bending terms adds to its elasticity.
pub(crate) trait BendFriction {
    /// What the second difference `curvature` of the vector of terms `index` is multiplied by, when
    /// elasticity alone multiplies it by `share`.
    fn share<S: Simd>(
        &mut self,
        simd: S,
        index: usize,
        curvature: Vectors<S>,
        share: f32x16<S>,
    ) -> f32x16<S>;
}

/// Nothing.
pub(crate) struct Frictionless;

impl BendFriction for Frictionless {
    #[inline(always)]
    fn share<S: Simd>(&mut self, _: S, _: usize, _: Vectors<S>, share: f32x16<S>) -> f32x16<S> {
        share
    }
}

/// Friction of the bending terms that start in one row.
pub(crate) struct BendSets<'a> {
    /// The second difference [m] at which each term's slider is relaxed.
    pub(crate) sets: &'a mut [Points],
    pub(crate) friction: Friction,
}

impl BendFriction for BendSets<'_> {
    #[inline(always)]
    fn share<S: Simd>(
        &mut self,
        simd: S,
        index: usize,
        curvature: Vectors<S>,
        share: f32x16<S>,
    ) -> f32x16<S> {
        let one = f32x16::splat(simd, 1.0);
        let square = curvature.dot(curvature);
        let inverse = inverse_root(simd, square);
        let set = Vectors::load(simd, &self.sets[index]);
        // The set turns with the term: of it counts what lies along the term now, so its sign
        // survives where the cloth bends through flat to the other side.
        let way = (square - curvature.dot(set)) * inverse;
        let stretched = self.friction.stretched(simd, way) * inverse;
        curvature
            .scale(one - stretched)
            .store(&mut self.sets[index]);
        share * (one + stretched * self.friction.stick)
    }
}

/// `1 / √square` within 5e-6, the same bits on every processor, without a root or a division:
/// Newton's iteration from the number whose exponent is minus half (Lomont 2003). Of zero it is
/// large and finite.
#[inline(always)]
fn inverse_root<S: Simd>(simd: S, square: f32x16<S>) -> f32x16<S> {
    let bits: u32x16<S> = square.bitcast();
    let guess: f32x16<S> = (u32x16::splat(simd, 0x5f37_59df) - (bits >> 1)).bitcast();
    let half = square * 0.5;
    let three_halves = f32x16::splat(simd, 1.5);
    let better = guess * (three_halves - half * guess * guess);
    better * (three_halves - half * better * better)
}

/// What cells add to the elasticity of their diagonals.
pub(crate) trait ShearFriction {
    /// Whether it adds anything.
    const ACTS: bool;

    /// What is added to the strain of the falling diagonal and taken from that of the rising one,
    /// in the vector of cells `index` with these squared lengths [m²] of both.
    fn strain<S: Simd>(&mut self, simd: S, index: usize, squares: [f32x16<S>; 2]) -> f32x16<S>;
}

impl ShearFriction for Frictionless {
    const ACTS: bool = false;

    #[inline(always)]
    fn strain<S: Simd>(&mut self, simd: S, _: usize, _: [f32x16<S>; 2]) -> f32x16<S> {
        f32x16::splat(simd, 0.0)
    }
}

/// Friction of the cells below one row.
pub(crate) struct ShearSets<'a> {
    /// The strain of the falling diagonal at which each cell's slider is relaxed.
    pub(crate) sets: &'a mut [Scalars],
    pub(crate) friction: Friction,
    /// One over four squared rest lengths of a diagonal [1/m²].
    pub(crate) inv_four_squares: f32,
}

impl ShearFriction for ShearSets<'_> {
    const ACTS: bool = true;

    #[inline(always)]
    fn strain<S: Simd>(
        &mut self,
        simd: S,
        index: usize,
        [falling, rising]: [f32x16<S>; 2],
    ) -> f32x16<S> {
        let strain = (falling - rising) * self.inv_four_squares;
        let set = f32x16::load_array_ref(simd, &self.sets[index].0);
        let stretched = self.friction.stretched(simd, strain - set);
        (strain - stretched).store_array(&mut self.sets[index].0);
        stretched * self.friction.stick
    }
}

/// Where the yarns of one cloth have been left: its memory of how it was bent and sheared. Empty in
/// a cloth without friction and before the first step.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Sets {
    /// Of bending along rows, by row and link, and down columns, by upper row and group [m].
    pub(crate) bend: [Vec<Points>; 2],
    /// Sets of shear, by upper row and link.
    pub(crate) shear: Vec<Scalars>,
}

impl Sets {
    /// Makes room for so many vectors of terms; new ones are flat and square, as cloth was woven.
    pub(crate) fn prepare(&mut self, bend_counts: [usize; 2], shear_count: usize) {
        for (sets, count) in self.bend.iter_mut().zip(bend_counts) {
            sets.resize(count, Points::default());
        }
        self.shear.resize(shear_count, Scalars::default());
    }

    /// Forgets everything: the cloth was put elsewhere.
    pub(crate) fn clear(&mut self) {
        *self = Self::default();
    }

    /// Memory that it holds [byte].
    pub(crate) fn byte_count(&self) -> usize {
        let bend = self.bend.iter().map(|sets| size_of_val(&sets[..]));
        bend.sum::<usize>() + size_of_val(&self.shear[..])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fearless_simd::{Level, dispatch};

    fn root(square: f32) -> f32 {
        dispatch!(Level::baseline(), simd => inverse_root(simd, f32x16::splat(simd, square)).to_array()[0])
    }

    #[test]
    fn the_inverse_root_is_one_over_the_root() {
        for exponent in -16..16_i16 {
            for mantissa in 0..40_i16 {
                let square =
                    10.0_f32.powi(i32::from(exponent)) * (1.0 + 0.25 * f32::from(mantissa));
                let error = root(square) * square.sqrt() - 1.0;
                assert!(error.abs() < 5e-6, "{square}: {error}");
            }
        }
        assert!(root(0.0).is_finite());
    }

    /// Share of `curvature` along `x` that the term takes away, by the path that it went.
    fn shares(path: &[f32]) -> Vec<f32> {
        let friction = Friction::new(0.2, 0.01).expect("a residual");
        let mut sets = [Points::default()];
        let mut terms = BendSets {
            sets: &mut sets,
            friction,
        };
        path.iter()
            .map(|&x| {
                dispatch!(Level::baseline(), simd => {
                    let curvature = Vectors::splat(simd, glam::Vec3::X * x);
                    let share = terms.share(simd, 0, curvature, f32x16::splat(simd, 1.0));
                    share.to_array()[0]
                })
            })
            .collect()
    }

    #[test]
    fn a_term_is_loaded_above_its_elasticity_and_unloaded_below_by_the_same_friction() {
        let path = [0.1, 0.5, 1.0, 0.9, 0.6, 0.3, -0.3, -1.0, -0.7];
        let moments: Vec<f32> = (shares(&path).iter().zip(path))
            .map(|(share, x)| share * x)
            .collect();
        // Friction is ±0.2 where the path is far enough from its last turn, and 1.5 times the
        // way from the set before.
        let expected = [0.25, 0.7, 1.2, 0.95, 0.4, 0.1, -0.5, -1.2, -0.5];
        for (found, expected) in moments.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-4, "{moments:?}");
        }
    }
}
