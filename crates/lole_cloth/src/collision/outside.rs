//! Where cloth would be that a repair has left in the body.

use glam::Vec3;
use lole_geom::Capsule;

use crate::collision::placement::Placement;
use crate::collision::surfel::SurfelContacts;

/// A body at the end of a step.
pub(crate) trait Outside {
    /// Where the particle of a vector and lane, at `position` [m], is outside the body: there, or on its
    /// surface.
    fn outside(&self, slot: (usize, usize), position: Vec3) -> Vec3;
}

/// The body around one cloth.
#[derive(Clone, Copy)]
pub(crate) struct Body<'a> {
    pub(crate) layout: &'a dyn Placement,
    /// Where the capsules are at the end of the step.
    pub(crate) capsules: &'a [Capsule],
    /// Distance kept from the capsules [m].
    pub(crate) contact_offset: f32,
    /// Where the particles may touch the skin.
    pub(crate) skin: &'a SurfelContacts,
    /// By row, how far inside the capsules particles may stay [m].
    pub(crate) held: &'a [f32],
}

impl Outside for Body<'_> {
    fn outside(&self, (vector, lane): (usize, usize), mut position: Vec3) -> Vec3 {
        let offset = self.contact_offset - self.held[self.layout.row_of(vector)];
        for capsule in self.capsules {
            let s = capsule.axis_parameter(position);
            let radius = capsule.radii[0] + (capsule.radii[1] - capsule.radii[0]) * s + offset;
            let foot = capsule.ends[0] + (capsule.ends[1] - capsule.ends[0]) * s;
            let from_axis = position - foot;
            let squared = from_axis.length_squared();
            if 0.0 < radius && squared < radius * radius {
                position = foot + from_axis.normalize_or(Vec3::Z) * radius;
            }
        }
        self.skin.outside((vector, lane), position)
    }
}
