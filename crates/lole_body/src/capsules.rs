//! The capsules of the lower body, 13 unless asked otherwise: what the cloth collides with.
//!
//! Of 13, five cover pelvis, belly and waist, four each leg. They are fitted to the skin by weighted
//! least squares: each skin point belongs to the capsule it is nearest to or deepest in, and a
//! point left outside weighs more than one covered too thickly, because cloth must not sink into
//! the drawn skin.

mod fit;

use glam::{Affine3A, Vec3};
use lole_geom::Capsule;

use crate::{Bone, Dancer};
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

/// How well capsules stand for the skin between ankle and waist.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coverage {
    /// Share of the skin's area that lies from 8 mm inside to 3 mm outside a capsule.
    pub close: f32,
    /// Share that lies farther outside: what cloth could sink into.
    pub outside: f32,
    /// Farthest that skin lies outside [m].
    pub farthest: f32,
}

/// Skin that lies this far inside a capsule [m] is still close to it.
const CLOSE_INSIDE: f32 = 0.008;
/// Skin that lies this far outside a capsule [m] is still close to it.
const CLOSE_OUTSIDE: f32 = 0.003;

impl Dancer {
    /// How well her capsules stand for her skin in the bind pose.
    #[must_use]
    pub fn capsule_coverage(&self) -> Coverage {
        let capsules: Vec<Capsule> = (self.capsules.iter())
            .map(|capsule| Capsule {
                ends: capsule.ends.map(|(_, end)| end),
                radii: capsule.radii,
            })
            .collect();
        let levels = self.landmarks.ankle_height..=self.landmarks.waist_height;
        let (mut area, mut close, mut outside, mut farthest) = (0.0, 0.0, 0.0, 0.0_f32);
        for triangle in self.skin.body_triangles() {
            let [a, b, c] = triangle.map(|vertex| self.skin.positions[vertex as usize]);
            let middle = (a + b + c) / 3.0;
            let bone = usize::from(self.skin.joints[triangle[0] as usize][0]);
            if !(levels.contains(&middle.y) && fit::is_lower_body(bone)) {
                continue;
            }
            let share = (b - a).cross(c - a).length();
            let distances = capsules
                .iter()
                .map(|capsule| capsule.signed_distance(middle));
            let distance = distances.fold(f32::INFINITY, f32::min);
            area += share;
            if CLOSE_OUTSIDE < distance {
                outside += share;
            } else if -CLOSE_INSIDE <= distance {
                close += share;
            }
            farthest = farthest.max(distance);
        }
        let area = area.max(f32::MIN_POSITIVE);
        Coverage {
            close: close / area,
            outside: outside / area,
            farthest,
        }
    }
}
