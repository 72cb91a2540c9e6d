//! How what was moved leaves the body again.

use glam::Vec3;

use super::{CrossingRepair, Fixed};
use crate::collision::surface::Surface;
use crate::lanes::narrow;

/// Pairs that may be looked at for each patch while what the repair has left in the body is brought out: where
/// cloth is pressed from both sides it moves nothing.
const LEAVING_EFFORT: usize = 3;

/// Rounds of bringing out of the body what can leave it without crossing.
const LEAVING_ROUNDS: u8 = 8;

/// Swells of space by which what was held back is brought out of the body.
const SWELLS: usize = 48;

/// Depth in the body that is left [m].
const SHALLOW: f32 = 0.3e-3;

/// Radius of a swell [m], and that many times the way in its middle at least: it presses space together by a
/// quarter at most, and what lies beside each other stays so.
const SWELL_RADIUS: f32 = 0.03;
const SWELL_SLOPE: f32 = 6.0;

impl CrossingRepair {
    /// Brings all that was moved to where the body is not.
    pub(super) fn leave_body(&mut self, fixed: Fixed<'_>) {
        for &particle in &self.moved {
            let position = &mut self.positions[particle as usize];
            *position = outside_body(fixed, particle, *position);
        }
    }

    /// Brings out of the body what the repair has left in it, with what lies on it, as far as
    /// nothing comes to cross by that.
    pub(super) fn leave_body_at_last(&mut self, fixed: Fixed<'_>, starts: &[Vec3]) {
        self.effort_max = self
            .effort_max
            .min(self.effort + self.finder.effort + LEAVING_EFFORT * fixed.surface.patches.len());
        let known = self.finder.crossings.len();
        let moved = self
            .moved
            .iter()
            .map(|&particle| self.positions[particle as usize]);
        self.before.clear();
        self.before.extend(moved);
        self.is_outside.clear();
        self.is_outside.resize(starts.len(), false);
        let has_swelled = !self.held_back.is_empty() && self.swell_out(fixed);
        if has_swelled {
            self.part_new(fixed, starts, known);
        }
        for round in 0..LEAVING_ROUNDS {
            if self.is_spent() || !self.seat_outside(fixed) {
                if round == 0 && !has_swelled {
                    return;
                }
                break;
            }
            self.look_again(fixed);
            self.part_new(fixed, starts, known);
        }
        self.is_outside.clear();
        for _ in 0..LEAVING_ROUNDS {
            if self.finder.crossings.len() <= known {
                return;
            }
            self.take_back(fixed.surface, Back::Around);
            self.look_again(fixed);
        }
        if known < self.finder.crossings.len() {
            self.take_moved_back();
            self.look_again(fixed);
        }
    }

    /// Parts what has come to cross while it left the body, until no more than `known` do.
    fn part_new(&mut self, fixed: Fixed<'_>, starts: &[Vec3], known: usize) {
        for _ in 0..LEAVING_ROUNDS {
            if self.finder.crossings.len() <= known || self.is_spent() {
                break;
            }
            self.separate_new(starts);
            for index in 0..self.separations.len() {
                self.part(fixed, self.separations[index]);
            }
            self.effort += self.separations.len() + self.moved.len();
            self.restrain(starts);
            self.look_again(fixed);
        }
    }

    /// Brings what is in the body out of it together with all that lies around it, folds and all: space swells
    /// smoothly around what is deepest, along its way out, until nothing is deep. Whether anything was.
    fn swell_out(&mut self, fixed: Fixed<'_>) -> bool {
        let held: Vec<u32> = self.moved.clone();
        let (mut near, mut reach) = (Vec::new(), 0.0);
        for _ in 0..SWELLS {
            let ways = held.iter().map(|&particle| {
                let position = self.positions[particle as usize];
                (position, outside_body(fixed, particle, position) - position)
            });
            let deepest = ways
                .max_by(|one, other| one.1.length_squared().total_cmp(&other.1.length_squared()));
            let Some((middle, way)) = deepest.filter(|it| SHALLOW < it.1.length()) else {
                break;
            };
            let radius = SWELL_RADIUS.max(SWELL_SLOPE * way.length());
            // The first one is around what is deepest, and most later ones reach no farther; by twice its radius,
            // because the others move what they are around.
            if reach < radius {
                reach = radius;
                near = self.around(fixed, &held, 2.0 * radius);
            }
            for &particle in &near {
                let away = self.positions[particle as usize].distance_squared(middle);
                let rest = 1.0 - away / (radius * radius);
                if 0.0 < rest {
                    self.shift(particle, way * (rest * rest));
                }
            }
        }
        let has_swelled = 0.0 < reach;
        if has_swelled {
            self.look_again(fixed);
        }
        has_swelled
    }

    /// What is free and at most so far [m] from the box around some particles.
    fn around(&self, fixed: Fixed<'_>, particles: &[u32], reach: f32) -> Vec<u32> {
        let places = particles.iter().map(|&it| self.positions[it as usize]);
        let (low, high) = places.fold((Vec3::MAX, Vec3::MIN), |(low, high), place| {
            (low.min(place), high.max(place))
        });
        let (low, high) = (low - reach, high + reach);
        let is_near = |&it: &u32| {
            let place = self.positions[it as usize];
            place.cmpge(low).all() && place.cmple(high).all() && 0.0 < Self::inv_mass(fixed, it)
        };
        (0..narrow(self.positions.len())).filter(is_near).collect()
    }

    /// Brings what is in the body to its surface and lets it stay there; whether there was any.
    fn seat_outside(&mut self, fixed: Fixed<'_>) -> bool {
        let mut any = false;
        for &particle in &self.moved {
            let position = &mut self.positions[particle as usize];
            let outside = outside_body(fixed, particle, *position);
            if outside != *position {
                *position = outside;
                self.is_outside[particle as usize] = true;
                any = true;
            }
        }
        any
    }

    /// Brings what was moved and crosses to where it was `before`.
    pub(super) fn take_back(&mut self, surface: &Surface, back: Back) {
        let crossed = (self.finder.crossings.iter())
            .flat_map(|crossing| crossing.ends.into_iter().chain(crossing.corners));
        let goes_back = crossed.flat_map(|particle| {
            let around = surface.ring(particle);
            around.filter(move |&it| back == Back::Around || it == particle)
        });
        for particle in goes_back {
            let moved = self.moved_places[particle as usize].checked_sub(1);
            if let Some(place) = moved {
                self.positions[particle as usize] = self.before[place as usize];
            }
        }
    }

    /// Brings all that was moved to where it was `before`.
    pub(super) fn take_moved_back(&mut self) {
        for (&particle, &before) in self.moved.iter().zip(&self.before) {
            self.positions[particle as usize] = before;
        }
    }
}

/// What goes back where something crosses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Back {
    /// What crosses.
    Crossed,
    /// What is near that, too.
    Around,
}

/// Where the nearest point outside the body is [m], the particle's own if it is there.
pub(super) fn outside_body(fixed: Fixed<'_>, particle: u32, position: Vec3) -> Vec3 {
    let (vector, lane) = fixed.layout.slot(particle as usize);
    if fixed.inv_masses[vector].0[lane] <= 0.0 {
        return position;
    }
    fixed.body.outside((vector, lane), position)
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::*;
    use crate::collision::outside::Outside;
    use crate::{ClothModel, ClothSpec, Fabric, Grid};

    /// A hill that a body has pushed into cloth from below, 8 mm high.
    struct Hill;

    impl Hill {
        fn height(place: Vec3) -> f32 {
            0.008 - 4.0 * (place.x * place.x + place.z * place.z)
        }
    }

    impl Outside for Hill {
        fn outside(&self, _: (usize, usize), place: Vec3) -> Vec3 {
            Vec3::new(place.x, place.y.max(Self::height(place)), place.z)
        }
    }

    #[test]
    fn folds_that_are_held_back_leave_a_body_together_and_in_their_order() {
        // A sheet folded in four, its layers a millimeter apart, 21 by 21 particles each.
        let grid = Grid::sheet(21, 84, [0.005; 2]);
        let at = |row: u32, column: u32| {
            let (layer, along) = (row / 21, row % 21);
            let along = if layer % 2 == 0 { along } else { 20 - along };
            let [x, z, layer] =
                [column, along, layer].map(|it| f32::from(u16::try_from(it).unwrap()));
            Vec3::new(0.005 * x - 0.05, 0.001 * layer, 0.005 * z - 0.05)
        };
        let places: Vec<Vec3> = (0..84 * 21).map(|it| at(it / 21, it % 21)).collect();
        let surface = Surface::from_grid(&grid);
        let model = ClothModel::new(&ClothSpec::new(grid, Fabric::COTTON)).unwrap();
        let fixed = Fixed {
            level: Level::new(),
            surface: &surface,
            layout: &model.layout,
            inv_masses: &model.inv_masses,
            body: &Hill,
            dt: 1.0 / 60.0,
        };
        let mut repair = CrossingRepair {
            positions: places,
            ..CrossingRepair::default()
        };
        let (finder, now) = (&mut repair.finder, surface.at(&repair.positions));
        dispatch!(fixed.level, simd => finder.find_all(simd, now));
        assert!(repair.finder.crossings.is_empty());
        repair.start_moving();
        for particle in 0..21 * 42 {
            repair.shift(particle, Vec3::ZERO);
        }
        assert!(repair.swell_out(fixed));
        assert!(repair.finder.crossings.is_empty());
        for particle in 0..21 * 42_usize {
            let place = repair.positions[particle];
            let depth = Hill::height(place) - place.y;
            assert!(depth <= 1.01 * SHALLOW, "{particle}: {depth} m deep");
        }
        let (mut finder, now) = (
            std::mem::take(&mut repair.finder),
            surface.at(&repair.positions),
        );
        dispatch!(fixed.level, simd => finder.find_all(simd, now));
        assert!(finder.crossings.is_empty(), "{}", finder.crossings.len());
        // What was not held is carried along: the layers above.
        let middle = 21 * 52 + 10;
        assert!(0.006 < repair.positions[middle].y);
    }
}
