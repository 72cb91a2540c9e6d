//! What is worn under a garment while that is put on: its outline, which goes with the hips.

use glam::{Affine3A, Vec3};
use lole_body::{Bone, Dancer, Pose};
use lole_cloth::collision::layer::{Envelope, Trunk};
use lole_geom::Surfel;

use super::{CONTACT_OFFSET, Dressed, LAYER_GAP, fit};

/// Cloth is laid this far outside of what is worn under it [m].
const LAID_OVER: f32 = 0.006;
/// Places farther inside than this lie on the other side of the dancer [m].
const FARTHEST: f32 = 0.30;

/// Garments in their places on the standing dancer.
pub(super) struct Under<'a> {
    inside: &'a [(&'a [[u32; 3]], &'a [Vec3])],
    stance_from_bind: Affine3A,
    hips: Vec3,
    envelope: Envelope,
    moved: Vec<Vec3>,
}

impl<'a> Under<'a> {
    pub(super) fn new(
        dancer: &Dancer,
        stance: &Pose,
        inside: &'a [(&'a [[u32; 3]], &'a [Vec3])],
    ) -> Self {
        let world_from_bind = dancer.skeleton.world_from_bind(stance);
        Self {
            inside,
            stance_from_bind: world_from_bind[Bone::Hips.index()],
            hips: dancer.skeleton.joint(Bone::Hips),
            envelope: Envelope::default(),
            moved: Vec::new(),
        }
    }

    /// Adds their outline to what cloth meets, in a pose; nothing where nothing is worn.
    pub(super) fn add(&mut self, world_from_bind: &[Affine3A], surfels: &mut Vec<Surfel>) {
        if self.inside.is_empty() {
            return;
        }
        let hips = world_from_bind[Bone::Hips.index()];
        let world_from_stance = hips * self.stance_from_bind.inverse();
        let forward = hips.transform_vector3(Vec3::Z).with_y(0.0);
        self.envelope.begin(Trunk {
            axis: hips.transform_point3(self.hips),
            forward: forward.try_normalize().unwrap_or(Vec3::Z),
        });
        for (triangles, positions) in self.inside {
            self.moved.clear();
            let moved = (positions.iter()).map(|place| world_from_stance.transform_point3(*place));
            self.moved.extend(moved);
            self.envelope.put_on(triangles, &self.moved);
        }
        self.envelope
            .add_surfels(CONTACT_OFFSET - LAYER_GAP, surfels);
    }

    /// How far a place is outside of them where they were added last [m].
    #[cfg(test)]
    pub(super) fn clearance(&self, place: Vec3) -> Option<f32> {
        Some(self.envelope.clearance(place)?.0)
    }

    /// Lays what is about to be sewn over them.
    pub(super) fn lay_over(&mut self, dancer: &Dancer, garment: &mut Dressed) {
        if self.inside.is_empty() {
            return;
        }
        let world_from_bind = dancer.skeleton.world_from_bind(&fit::fitting_pose());
        self.add(&world_from_bind, &mut Vec::new());
        let is_on_trunk = garment.on_trunk();
        for (place, _) in (garment.start.iter_mut().zip(is_on_trunk)).filter(|pair| pair.1) {
            let Some((clearance, outward)) = self.envelope.clearance(*place) else {
                continue;
            };
            if clearance < LAID_OVER && -FARTHEST < clearance {
                *place += outward * (LAID_OVER - clearance);
            }
        }
    }
}
