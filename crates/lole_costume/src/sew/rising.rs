//! How an elastic goes up where a thigh is raised against it.
//!
//! When she sits down or squats, the top of her thigh comes up to where the lowest elastic lies.
//! A real band slides up over the belly then; one that stayed would hang inside of the thigh, and cloth that
//! must come out of it right below would be crumpled.

use glam::{Affine3A, Vec2, Vec3};
use lole_body::Bone;
use lole_geom::Surfel;

/// Skin faces up whose normal does so at least so much (a cosine).
const FACING_UP: f32 = 0.4;

/// Skin over an elastic no farther to the side of it than this [m] raises it.
const BESIDE: f32 = 0.02;

/// Kept between raised skin and an elastic [m].
pub(super) const CLEARANCE: f32 = 0.008;

/// Farthest that an elastic goes up [m]: what is raised farther goes through it there.
const HIGHEST: f32 = 0.08;

/// Share of their distance by which elastics come nearer to each other: the cloth between bulges.
const SHUT: f32 = 0.25;

/// What of the skin can come up: that of legs, where it does not face up in the bind pose.
pub(super) struct Raised {
    bind_from_world: Vec<Affine3A>,
}

impl Raised {
    pub(super) fn new(world_from_bind: &[Affine3A]) -> Self {
        Self {
            bind_from_world: world_from_bind.iter().map(Affine3A::inverse).collect(),
        }
    }

    /// Whether skin of a bone has turned to face up: its normal in the world, and as the band sees it.
    pub(super) fn has(&self, bone: Bone, surfel: &Surfel, seen: Vec3) -> bool {
        let is_leg = Bone::LEGS.iter().any(|leg| leg.contains(&bone));
        is_leg && FACING_UP < seen.y && {
            let in_bind = self.bind_from_world[bone.index()].transform_vector3(surfel.normal);
            in_bind.y < FACING_UP
        }
    }
}

/// How far raised skin brings an elastic up that lies at a place, both as the band sees them [m].
pub(super) fn rise(skin: Vec3, elastic: Vec3) -> f32 {
    let beside = Vec2::new(skin.x - elastic.x, skin.z - elastic.z);
    let up = skin.y + CLEARANCE - elastic.y;
    if beside.length_squared() < BESIDE * BESIDE {
        up.clamp(0.0, HIGHEST)
    } else {
        0.0
    }
}

/// Lets elastics push those above them up, and none come up without those below it; `heights` [m] are how
/// high they are without, of all from the highest to the lowest.
pub(super) fn even_out(heights: &[f32], rises: &mut [f32]) {
    for lower in (1..rises.len()).rev() {
        let between = (heights[lower - 1] - heights[lower]).max(0.0);
        rises[lower - 1] = rises[lower - 1].max(rises[lower] - SHUT * between);
    }
    for lower in 1..rises.len() {
        rises[lower] = rises[lower].max(rises[lower - 1]);
    }
}

/// Where a point is that goes up by `rise` [m] over those above it, from itself to the highest [m].
pub(super) fn climbed(mut points: impl Iterator<Item = Vec3>, rise: f32) -> Option<Vec3> {
    let mut at = points.next()?;
    let mut left = rise;
    for above in points {
        let height = above.y - at.y;
        if left < height {
            return Some(at.lerp(above, left / height));
        }
        left -= height.max(0.0);
        at = above;
    }
    Some(at + Vec3::Y * left)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_raised_beside_an_elastic_leaves_it_and_what_is_far_above_goes_through() {
        let at = Vec3::new(0.1, 1.0, 0.1);
        assert_eq!(rise(at + Vec3::new(0.03, 0.02, 0.0), at), 0.0);
        assert_eq!(rise(at - Vec3::Y * 0.02, at), 0.0);
        assert!((rise(at + Vec3::Y * 0.02, at) - 0.028).abs() < 1.0e-6);
        assert_eq!(rise(at + Vec3::Y * 0.5, at), HIGHEST);
    }

    #[test]
    fn elastics_keep_their_order_and_most_of_their_distance() {
        let heights = [1.06, 1.03, 1.0];
        let mut rises = [0.0, 0.0, 0.04];
        even_out(&heights, &mut rises);
        for (rise, wanted) in rises.iter().zip([0.025, 0.0325, 0.04]) {
            assert!((rise - wanted).abs() < 1.0e-6, "{rises:?}");
        }
        let mut rises = [0.02, 0.0, 0.0];
        even_out(&heights, &mut rises);
        assert_eq!(rises, [0.02; 3]);
    }

    #[test]
    fn a_point_climbs_along_the_band_and_over_it() {
        let points = [
            Vec3::ZERO,
            Vec3::new(0.01, 0.02, 0.0),
            Vec3::new(0.01, 0.04, 0.02),
        ];
        let at = |rise| climbed(points.into_iter(), rise).unwrap();
        assert_eq!(at(0.0), points[0]);
        assert!(at(0.01).distance(Vec3::new(0.005, 0.01, 0.0)) < 1.0e-6);
        assert!(at(0.03).distance(Vec3::new(0.01, 0.03, 0.01)) < 1.0e-6);
        assert!(at(0.05).distance(Vec3::new(0.01, 0.05, 0.02)) < 1.0e-6);
        assert_eq!(climbed(std::iter::empty(), 0.1), None);
    }
}
