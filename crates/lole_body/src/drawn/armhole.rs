//! The armholes of the drawn body's leotard are cut once more, along lines that are smooth while she dances.
//!
//! The skin that cloth meets is cut with its arms lowered, where the skin under the arm is folded: what is a smooth line
//! there is jagged as soon as an arm rises and its triangles stretch. She dances with her arms raised.

use glam::{Affine3A, Quat, Vec3};

use crate::skin_build::Half;
use crate::surface::Shape;
use crate::surface::regions::Regions;
use crate::surface::slice::{Cut, slice};
use crate::{Bone, PartKind, Pose, Skeleton};

/// Where an arm points for which the armhole is cut: at the height of the shoulder, between aside and ahead.
const RAISED: Vec3 = Vec3::new(0.92, 0.0, 0.39);

/// Cuts leotard from skin by the raised arm.
pub(super) fn cut(half: &mut Half, shape: &Shape, skeleton: &Skeleton) {
    let regions = Regions::new(&shape.body, shape.crotch, shape.head_size);
    let [shoulder, elbow] =
        [Bone::LeftUpperArm, Bone::LeftLowerArm].map(|bone| skeleton.joint(bone));
    let mut pose = Pose::default();
    let raised = Quat::from_rotation_arc(
        (elbow - shoulder).normalize_or_zero(),
        RAISED.normalize_or_zero(),
    );
    pose.rotate(Bone::LeftUpperArm, raised);
    let world_from_bind = skeleton.world_from_bind(&pose);
    let values: Vec<f32> = (half.positions.iter().zip(&half.rows))
        .map(|(&place, row)| regions.raised_armhole(carried(&world_from_bind, row, place)))
        .collect();
    let sliced = slice(&half.triangles, &values);
    for cut in &sliced.vertices[values.len()..] {
        if let Cut::Between(a, b, share) = *cut {
            half.add_between([a, b], share);
        }
    }
    let pieces = sliced.parents.iter().zip(&sliced.is_positive);
    half.kinds = (pieces.zip(&sliced.triangles))
        .map(|((&parent, &is_covered), triangle)| {
            let beside = triangle.map(|corner| half.positions[corner as usize]);
            if !beside.iter().all(|&place| regions.is_beside_armhole(place)) {
                half.kinds[parent as usize]
            } else if is_covered {
                PartKind::Leotard
            } else {
                PartKind::Skin
            }
        })
        .collect();
    half.triangles = sliced.triangles;
}

/// A place as bones with these shares carry it.
fn carried(world_from_bind: &[Affine3A], row: &[f32; Bone::COUNT], place: Vec3) -> Vec3 {
    let shares = world_from_bind.iter().zip(row);
    let shares = shares.filter(|(_, share)| 0.0 < **share);
    shares
        .map(|(bone, &share)| bone.transform_point3(place) * share)
        .sum()
}
