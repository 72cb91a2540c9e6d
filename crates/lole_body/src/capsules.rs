//! The capsules of the lower body, 13 unless asked otherwise: what the cloth collides with.
//!
//! Of 13, five cover pelvis, belly and waist, four each leg. They are fitted to the skin by weighted
//! least squares: each skin point belongs to the capsule it is nearest to or deepest in, and a
//! point left outside weighs more than one covered too thickly, because cloth must not sink into
//! the drawn skin.

mod fit;

use glam::{Affine3A, Vec3};
use lole_geom::Capsule;

use crate::Bone;
pub(crate) use fit::fit_capsules;

/// How many capsules stand for the lower body, and how.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CapsuleLayout {
    /// As many as this, 1 to [`CapsuleLayout::MOST`], fitted to the skin.
    Fitted(u32),
    /// Two upright cylinders, one for each leg with its half of the pelvis, as in the paper's
    /// earlier body (its figures 2 and 7).
    TwoCylinders,
}

impl CapsuleLayout {
    /// The most capsules of a fitted layout.
    pub const MOST: u32 = 40;
}

impl Default for CapsuleLayout {
    /// The paper's 13.
    fn default() -> Self {
        Self::Fitted(fit::PAPER_COUNT)
    }
}

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
