//! A tape laid around the trunk: where elastic and waistbands sit.

use glam::{Affine3A, Vec3};

use crate::skin::blend;

/// One point of a tape, carried by the skin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TapePoint {
    /// Where it lies in the bind pose [m].
    pub bind_position: Vec3,
    /// Unit horizontal direction out of the body, in the bind pose.
    pub outward: Vec3,
    /// Bones that carry it, as in [`crate::SkinnedMesh::joints`].
    pub joints: [u16; 4],
    /// Their shares.
    pub weights: [f32; 4],
}

impl TapePoint {
    /// Its place in the world [m].
    #[must_use]
    pub fn posed(&self, world_from_bind: &[Affine3A]) -> Vec3 {
        blend(world_from_bind, self.joints, self.weights).transform_point3(self.bind_position)
    }

    /// Its outward direction in the world, unit length.
    #[must_use]
    pub fn posed_outward(&self, world_from_bind: &[Affine3A]) -> Vec3 {
        blend(world_from_bind, self.joints, self.weights)
            .transform_vector3(self.outward)
            .normalize_or_zero()
    }
}
