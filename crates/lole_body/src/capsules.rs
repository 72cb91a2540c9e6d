//! The 13 capsules of the lower body: what the cloth collides with.
//!
//! Five cover pelvis, belly and waist, four each leg. They are fitted to the skin by weighted
//! least squares: each skin point belongs to the capsule it is nearest to or deepest in, and a
//! point left outside weighs more than one covered too thickly, because cloth must not sink into
//! the drawn skin.

mod fit;

use glam::{Affine3A, Vec3};
use lole_geom::Capsule;

use crate::Bone;
pub(crate) use fit::fit_capsules;

/// One capsule whose ends are carried by bones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyCapsule {
    /// What it covers, such as `left upper thigh`.
    pub name: &'static str,
    /// Bone and bind position [m] of each end of the axis.
    pub ends: [(Bone, Vec3); 2],
    /// Radius at each end [m].
    pub radii: [f32; 2],
}

impl BodyCapsule {
    /// The capsule in the world.
    #[must_use]
    pub fn posed(&self, world_from_bind: &[Affine3A]) -> Capsule {
        Capsule {
            ends: self
                .ends
                .map(|(bone, end)| world_from_bind[bone.index()].transform_point3(end)),
            radii: self.radii,
        }
    }
}
