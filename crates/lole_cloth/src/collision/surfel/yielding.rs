//! How the body yields: where there is no way past it, it gives way and not the cloth.
//!
//! A hand inside the hip, two legs in one place, a knee through the band: there is no place for cloth
//! between, and whatever pushes it out would tear it. A repair that finds no other way holds such cloth
//! back; the skin recedes there to where the cloth is, and comes back slowly, so that it slips out when
//! there is room.

use crate::lanes::{LANES, Scalars};

/// Speed at which skin comes back [m/s]: as slow as a hand that is careful.
const RETURNING: f32 = 0.1;

/// Farthest that it recedes [m]: what is deeper has left the reach of the skin.
const FARTHEST: f32 = super::REACH_MAX;

/// Farther than cloth is deep, so that it is not touched at once [m].
const ROOM: f32 = 0.001;

/// How far the skin has receded at every particle [m].
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Yielding {
    /// Empty where it has nowhere.
    depths: Vec<Scalars>,
}

impl Yielding {
    /// Memory that it holds [byte].
    pub(super) const fn byte_count(&self) -> usize {
        size_of_val(self.depths.as_slice())
    }

    /// How far the skin has receded at a particle [m].
    pub(super) fn depth(&self, (vector, lane): (usize, usize)) -> f32 {
        self.depths.get(vector).map_or(0.0, |depths| depths.0[lane])
    }

    /// Lets all skin come back as far as it does in `dt` [s].
    pub(super) fn come_back(&mut self, dt: f32) {
        let mut farthest = 0.0_f32;
        for depth in self.depths.iter_mut().flat_map(|depths| &mut depths.0) {
            *depth = (*depth - RETURNING * dt).max(0.0);
            farthest = farthest.max(*depth);
        }
        if farthest == 0.0 {
            self.depths.clear();
        }
    }

    /// Lets the skin recede to a particle, of so many vectors, that is so deep in it [m].
    pub(super) fn recede(
        &mut self,
        (vector, lane): (usize, usize),
        vector_count: usize,
        deep: f32,
    ) {
        if self.depths.is_empty() {
            self.depths.resize(vector_count, Scalars([0.0; LANES]));
        }
        let depth = &mut self.depths[vector].0[lane];
        *depth = depth.max(deep + ROOM).min(FARTHEST);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn skin_recedes_to_cloth_that_is_held_back_and_comes_back_slowly() {
        let mut yielding = Yielding::default();
        assert_eq!(yielding.depth((7, 3)), 0.0);
        yielding.recede((1, 3), 2, 0.02);
        assert_eq!(yielding.depth((1, 3)), 0.02 + ROOM);
        assert_eq!(yielding.depth((0, 3)), 0.0, "nowhere else");
        yielding.come_back(0.1);
        let depth = yielding.depth((1, 3));
        assert!(
            (depth - (0.02 + ROOM - 0.1 * RETURNING)).abs() < 1.0e-6,
            "{depth}"
        );
        yielding.recede((0, 0), 2, 5.0);
        assert_eq!(yielding.depth((0, 0)), FARTHEST);
        yielding.come_back(10.0);
        assert_eq!(yielding, Yielding::default());
    }
}
