//! The nearest surfels of sixteen particles at a time: they lie close together, so what is near one of them
//! is near the others, and is looked at once for all.

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::{IVec3, Vec3};

use super::SurfelCells;
use crate::lanes::{LANES, Points, Vectors};

/// Cells around all of them, over those around each, from which on each is looked after by itself.
const WORTH: i32 = 2;

/// A particle that asks for the surfel nearest to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Seeker {
    /// Where it is in the middle of the step, and within what distance it asks [m].
    pub(crate) point: Vec3,
    pub(crate) reach: f32,
    /// A surfel that may be it, by its place among the entries: a near one saves work and changes nothing.
    pub(crate) hint: Option<usize>,
}

/// The best so far of every lane. Places are counted as floats: surfels are fewer than 2²⁴.
struct Bests {
    points: Points,
    squared: [f32; LANES],
    places: [f32; LANES],
}

/// A lane that has none.
const NONE: f32 = -1.0;

impl SurfelCells {
    /// For each of at most sixteen particles, the surfel nearest to it as [`Self::nearest`] finds it.
    #[inline(always)]
    pub(crate) fn nearest_of_each<S: Simd>(
        &self,
        simd: S,
        seekers: &[Seeker],
        mut found: impl FnMut(usize, Option<usize>),
    ) {
        let mut bests = Bests {
            points: Points::default(),
            // Nothing is nearer than that: a lane that does not ask.
            squared: [0.0; LANES],
            places: [NONE; LANES],
        };
        let mut around: Option<[IVec3; 2]> = None;
        let mut own_cells = 0;
        for (lane, seeker) in seekers.iter().take(LANES).enumerate() {
            if !self.may_reach(seeker.point, seeker.reach) {
                continue;
            }
            let best = self.begin(seeker.point, seeker.reach, seeker.hint);
            let radius = best.squared.sqrt();
            let own = self.within(
                [seeker.point - radius, seeker.point + radius].map(|point| self.cell_of(point)),
            );
            own_cells += volume(own);
            around = Some(around.map_or(own, |[low, high]| [low.min(own[0]), high.max(own[1])]));
            bests.points.set(lane, seeker.point);
            bests.squared[lane] = best.squared;
            bests.places[lane] = best.place.map_or(NONE, as_float);
        }
        let Some(around) = around else {
            (0..seekers.len()).for_each(|lane| found(lane, None));
            return;
        };
        if WORTH * own_cells < volume(around) {
            for (lane, seeker) in seekers.iter().enumerate() {
                found(
                    lane,
                    self.nearest(simd, seeker.point, seeker.reach, seeker.hint),
                );
            }
            return;
        }
        self.look_together(simd, &mut bests, around);
        for (lane, &place) in bests.places[..seekers.len()].iter().enumerate() {
            found(lane, as_place(place));
        }
    }

    /// Holds every surfel of a box of cells against all of them, in the order of the places.
    #[inline(always)]
    fn look_together<S: Simd>(&self, simd: S, bests: &mut Bests, [low, high]: [IVec3; 2]) {
        let points = Vectors::load(simd, &bests.points);
        let mut squared = f32x16::load_array_ref(simd, &bests.squared);
        let mut places = f32x16::load_array_ref(simd, &bests.places);
        self.for_each_run_of(low, high, |run| {
            for place in run {
                let offset = points.sub(Vectors::splat(simd, self.position(place)));
                let own = offset.dot(offset);
                let place = f32x16::splat(simd, as_float(place));
                // Of equals the first: only what is known from the start may have one before it.
                let ties = own.simd_eq(squared) & place.simd_lt(places);
                let is_nearer = own.simd_lt(squared) | ties;
                squared = is_nearer.select(own, squared);
                places = is_nearer.select(place, places);
            }
        });
        places.store_array(&mut bests.places);
    }
}

/// How many cells a box has.
fn volume([low, high]: [IVec3; 2]) -> i32 {
    (high - low + IVec3::ONE).max(IVec3::ZERO).element_product()
}

#[expect(clippy::cast_precision_loss, reason = "surfels are fewer than 2^24")]
const fn as_float(place: usize) -> f32 {
    place as f32
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a place that was counted as a float"
)]
fn as_place(place: f32) -> Option<usize> {
    (0.0 <= place).then_some(place as usize)
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};
    use lole_geom::{Chance, Surfel};

    use super::*;
    use crate::collision::surfel::Skin;

    /// Two patches of skin at random beside each other, some of it at equal places.
    fn skin(chance: &mut Chance) -> Vec<Surfel> {
        let one = |chance: &mut Chance| {
            let [x, z] = [0; 2].map(|_| chance.between(-0.2, 0.2));
            let y = if chance.between(0.0, 1.0) < 0.5 {
                0.0
            } else {
                0.05
            };
            Surfel {
                position: Vec3::new(x, y, z),
                normal: Vec3::Y,
            }
        };
        let mut surfels: Vec<Surfel> = (0..900).map(|_| one(chance)).collect();
        surfels.extend_from_within(0..300);
        surfels
    }

    #[test]
    fn sixteen_find_what_each_finds_alone() {
        let mut chance = Chance::new(7);
        // Half of them have one.
        let hints: Vec<Option<usize>> = (0..1200).flat_map(|place| [Some(place), None]).collect();
        for round in 0_u16..200 {
            let surfels = skin(&mut chance);
            let skin = Skin {
                before: &surfels,
                after: &surfels,
                offset: 0.0,
            };
            let mut cells = SurfelCells::default();
            cells.sort(skin, [Vec3::splat(-0.3), Vec3::splat(0.3)], 0.06);
            // From close together to all over the skin.
            let spread = 0.002 * f32::from(round);
            let middle = Vec3::from_array([0; 3].map(|_| chance.between(-0.2, 0.2)));
            let seekers: Vec<Seeker> = (0..1 + usize::from(round % 16))
                .map(|_| {
                    let aside = Vec3::from_array([0; 3].map(|_| chance.between(-spread, spread)));
                    Seeker {
                        point: middle + aside,
                        reach: chance.between(0.004, 0.06),
                        hint: chance.choose(&hints).copied().flatten(),
                    }
                })
                .collect();
            let mut found = vec![None; seekers.len()];
            dispatch!(Level::new(), simd => {
                cells.nearest_of_each(simd, &seekers, |lane, place| found[lane] = place);
            });
            for (seeker, &found) in seekers.iter().zip(&found) {
                let alone = dispatch!(Level::new(), simd => {
                    cells.nearest(simd, seeker.point, seeker.reach, None)
                });
                assert_eq!(found, alone, "round {round}");
            }
        }
    }
}
