//! Two-bone inverse kinematics in closed form: where the middle joint of a limb is.

use glam::Vec3;

/// A limb of two bones solved for one target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoBone {
    /// Unit direction of the upper bone, from the root to the middle joint.
    pub upper: Vec3,
    /// Unit direction of the lower bone, from the middle joint to the end.
    pub lower: Vec3,
    /// Unit axis of the hinge: pole side × (root to target). Square to both bones.
    pub hinge: Vec3,
}

/// Solves a limb with bones of `lengths` [m] (upper, lower) from `root` to `target` [m]; the middle
/// joint points to the side of `pole` (a direction).
///
/// The triangle of the two bones and the distance is solved by the law of cosines. A target out of
/// reach is pulled to the nearest reachable distance on the same line.
#[must_use]
pub fn two_bone(root: Vec3, target: Vec3, lengths: [f32; 2], pole: Vec3) -> TwoBone {
    let [upper_length, lower_length] = lengths;
    let reach = target - root;
    let axis = reach.try_normalize().unwrap_or(Vec3::NEG_Y);
    let shortest = (upper_length - lower_length).abs();
    let distance = reach
        .length()
        .clamp(shortest + 1e-6, upper_length + lower_length);
    let across = pole - axis * pole.dot(axis);
    // A pole along the limb tells nothing: any side will do.
    let bend = Some(across)
        .filter(|across| across.length_squared() > 1e-8 * pole.length_squared())
        .and_then(Vec3::try_normalize)
        .unwrap_or_else(|| axis.any_orthonormal_vector());
    let along = (upper_length * upper_length - lower_length * lower_length + distance * distance)
        / (2.0 * distance);
    let aside = (upper_length * upper_length - along * along)
        .max(0.0)
        .sqrt();
    let middle = axis * along + bend * aside;
    let upper = middle.try_normalize().unwrap_or(axis);
    let lower = (axis * distance - middle).try_normalize().unwrap_or(axis);
    TwoBone {
        upper,
        lower,
        hinge: bend.cross(axis),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LENGTHS: [f32; 2] = [0.36, 0.37];

    /// The end of the solved limb.
    fn end(root: Vec3, limb: &TwoBone, lengths: [f32; 2]) -> Vec3 {
        root + limb.upper * lengths[0] + limb.lower * lengths[1]
    }

    #[test]
    fn a_reachable_target_is_reached() {
        let root = Vec3::new(0.1, 0.8, 0.0);
        for i in 0..200 {
            let angle = 0.1 * i as f32;
            let distance = 0.05 + 0.0033 * i as f32;
            let (sin, cos) = lole_geom::trig::sin_cos(angle);
            let target = root + Vec3::new(cos, sin, 0.3).normalize_or_zero() * distance;
            let limb = two_bone(root, target, LENGTHS, Vec3::Z);
            let gap = end(root, &limb, LENGTHS).distance(target);
            assert!(gap < 1e-5, "{gap} at {distance}");
        }
    }

    #[test]
    fn a_square_limb_has_the_pythagorean_distance() {
        // 3-4-5: with a right angle at the middle joint the ends are 5 apart.
        let limb = two_bone(Vec3::ZERO, Vec3::NEG_Y * 5.0, [3.0, 4.0], Vec3::Z);
        assert!(limb.upper.dot(limb.lower).abs() < 1e-6);
        assert!((limb.upper - Vec3::new(0.0, -0.6, 0.8)).length() < 1e-6);
    }

    #[test]
    fn the_middle_joint_points_to_the_pole() {
        let limb = two_bone(
            Vec3::ZERO,
            Vec3::NEG_Y * 0.6,
            LENGTHS,
            Vec3::new(0.3, 5.0, 1.0),
        );
        let aside = limb.upper - Vec3::NEG_Y * limb.upper.dot(Vec3::NEG_Y);
        assert!(
            aside
                .normalize_or_zero()
                .dot(Vec3::new(0.3, 0.0, 1.0).normalize_or_zero())
                > 0.9999
        );
    }

    #[test]
    fn a_target_out_of_reach_straightens_the_limb_toward_it() {
        let limb = two_bone(Vec3::ZERO, Vec3::X * 3.0, LENGTHS, Vec3::Z);
        assert!((end(Vec3::ZERO, &limb, LENGTHS) - Vec3::X * 0.73).length() < 1e-4);
    }

    #[test]
    fn degenerate_targets_give_unit_directions() {
        for target in [Vec3::ZERO, Vec3::Z * 1e-20, Vec3::Z] {
            let limb = two_bone(Vec3::ZERO, target, LENGTHS, Vec3::Z);
            for direction in [limb.upper, limb.lower, limb.hinge] {
                assert!((direction.length() - 1.0).abs() < 1e-4, "{limb:?}");
            }
        }
    }
}
