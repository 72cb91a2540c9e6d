//! Where the particles of a cloth stand in the engine's own order: all that contact needs to know
//! of what kind of cloth it is.

use glam::Vec3;

use crate::lanes::{Layout, Points, SlotSet, narrow};

/// The engine's own order of a cloth's particles: vectors of sixteen lanes, and rows of vectors.
pub(crate) trait Placement: Sync {
    /// Vector and lane of a particle.
    fn slot(&self, particle: usize) -> (usize, usize);

    /// Rows there are. Neighbors in a row lie near each other.
    fn row_count(&self) -> usize;

    /// Row in which a vector stands.
    fn row_of(&self, vector: usize) -> usize;

    /// Adds vector and lane of every particle of a row to `slots`, in order.
    fn add_row_slots(&self, row: usize, slots: &mut Vec<(usize, usize)>);

    /// Writes points over `points` in the order of the particles.
    fn gather_points(&self, vectors: &[Points], points: &mut Vec<Vec3>);
}

impl Placement for Layout {
    fn slot(&self, particle: usize) -> (usize, usize) {
        Self::slot(self, particle)
    }

    fn row_count(&self) -> usize {
        self.row_count
    }

    fn row_of(&self, vector: usize) -> usize {
        vector / self.group_count
    }

    fn add_row_slots(&self, row: usize, slots: &mut Vec<(usize, usize)>) {
        slots.extend(self.row_slots(row));
    }

    fn gather_points(&self, vectors: &[Points], points: &mut Vec<Vec3>) {
        Self::gather_points(self, vectors, points);
    }
}

/// Those of `0..count` that are in one of some sets.
pub(crate) fn particles_of<const N: usize>(
    sets: [&SlotSet; N],
    layout: &dyn Placement,
    count: usize,
) -> Vec<u32> {
    if sets.iter().all(|set| set.is_empty()) {
        return Vec::new();
    }
    let is_in = |&particle: &u32| {
        let slot = layout.slot(particle as usize);
        sets.iter().any(|set| set.contains(slot))
    };
    (0..narrow(count)).filter(is_in).collect()
}
