//! Two-bone inverse kinematics in closed form: where the middle joint of a limb is.

use glam::Vec3;

/// A limb of two bones solved for one target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoBone {
    /// Unit direction of the upper bone, from the root to the middle joint.
    pub upper: Vec3,
    /// Unit direction of the lower bone, from the middle joint to the end.
    pub lower: Vec3,
    /// Unit axis of the hinge, `lower × upper`-wise: the limb bends about it toward the pole.
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
    let bend = (pole - axis * pole.dot(axis))
        .try_normalize()
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
