//! A tape laid around the trunk: where elastic and waistbands sit.

use std::collections::BTreeMap;

use glam::{Affine3A, Vec2, Vec3};

use crate::skin::blend;
use crate::surface::section::{CutPoint, convex_hull, cut_points};
use crate::{Bone, SkinnedMesh};

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

#[expect(clippy::cast_possible_truncation, reason = "a body has few bones")]
const UPPER_CHEST: u16 = Bone::UpperChest.index() as u16;

/// Triangles carried by the arm this far are no part of the trunk.
const LEAST_ARM_SHARE: f32 = 0.7;

/// The bone that carries a tape where this one carries the skin: an arm that is raised draws the skin
/// at its pit up and out, and a tape below it stays on the trunk.
fn carrier(joint: u16) -> u16 {
    let index = usize::from(joint);
    let is_between = |first: Bone, last: Bone| (first.index()..=last.index()).contains(&index);
    let is_arm = is_between(Bone::LeftShoulder, Bone::LeftLittleDistal)
        || is_between(Bone::RightShoulder, Bone::RightLittleDistal);
    if is_arm { UPPER_CHEST } else { joint }
}

/// A corner of the taut tape.
#[derive(Debug, Clone)]
struct Corner {
    point: Vec2,
    outward: Vec2,
    weights: BTreeMap<u16, f32>,
}

impl Corner {
    fn lerp(&self, other: &Self, share: f32) -> Self {
        let mut weights = BTreeMap::new();
        for (corner, part) in [(self, 1.0 - share), (other, share)] {
            for (&joint, &weight) in &corner.weights {
                *weights.entry(joint).or_insert(0.0) += weight * part;
            }
        }
        Self {
            point: self.point.lerp(other.point, share),
            outward: self.outward.lerp(other.outward, share),
            weights,
        }
    }

    fn on_tape(&self, height: f32) -> TapePoint {
        let mut order: Vec<(u16, f32)> = self.weights.iter().map(|(&j, &w)| (j, w)).collect();
        order.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        order.truncate(4);
        let sum: f32 = order.iter().map(|(_, weight)| weight).sum();
        let mut joints = [0; 4];
        let mut weights = [0.0; 4];
        for (slot, (joint, weight)) in order.into_iter().enumerate() {
            joints[slot] = joint;
            weights[slot] = weight / sum;
        }
        let outward = self.outward.normalize_or_zero();
        TapePoint {
            bind_position: Vec3::new(self.point.x, height, self.point.y),
            outward: Vec3::new(outward.x, 0.0, outward.y),
            joints,
            weights,
        }
    }
}

/// `count` points at equal arc length on the hull of the cut at `height`, from the back middle
/// over the left side.
pub(crate) fn ring(skin: &SkinnedMesh, height: f32, count: usize) -> Vec<TapePoint> {
    let trunk = trunk(skin).into_iter();
    let hull = convex_hull(cut_points(&skin.positions, trunk, height));
    let corners = from_back(&corners(skin, &hull));
    resample(&corners, count)
        .iter()
        .map(|corner| corner.on_tape(height))
        .collect()
}

/// Triangles carried by the arm this far do not meet what is wrapped below the arms.
const LEAST_WRAPPED_ARM_SHARE: f32 = 0.25;

/// Closed ways around the trunk at every `step` [m] from `top` down to `lowest` in the bind pose, as cloth
/// hangs that is wrapped at the top: around all of it from there down, and never closer than above. Corners
/// `(x, z)` [m], begun at the middle of the back and running over the left side.
pub(crate) fn hung_rings(skin: &SkinnedMesh, [top, lowest]: [f32; 2], step: f32) -> Vec<Vec<Vec2>> {
    let triangles = without_arms(skin, LEAST_WRAPPED_ARM_SHARE);
    let levels = std::iter::successors(Some(top), |level| Some(level - step));
    let levels = levels.take_while(|&level| lowest - step < level);
    let mut hull = Vec::new();
    levels
        .map(|level| {
            let mut cuts = std::mem::take(&mut hull);
            cuts.extend(cut_points(
                &skin.positions,
                triangles.iter().copied(),
                level,
            ));
            hull = convex_hull(cuts);
            let corners = from_back(&corners(skin, &hull));
            corners.iter().map(|corner| corner.point).collect()
        })
        .collect()
}

/// Triangles of the body without those of the arms.
pub(crate) fn trunk(skin: &SkinnedMesh) -> Vec<[u32; 3]> {
    without_arms(skin, LEAST_ARM_SHARE)
}

/// Triangles of the body without those that an arm carries by as much on average.
fn without_arms(skin: &SkinnedMesh, least_share: f32) -> Vec<[u32; 3]> {
    let arms: Vec<f32> = (skin.joints.iter().zip(&skin.weights))
        .map(|(joints, weights)| arm_share(*joints, *weights))
        .collect();
    let mut triangles = skin.body_triangles();
    triangles.retain(|triangle| {
        let sum: f32 = triangle.iter().map(|&vertex| arms[vertex as usize]).sum();
        sum < 3.0 * least_share
    });
    triangles
}

/// How far a vertex is carried by the arm below the shoulder joint.
fn arm_share(joints: [u16; 4], weights: [f32; 4]) -> f32 {
    (joints.iter().zip(weights))
        .filter(|(joint, _)| {
            let index = usize::from(**joint);
            let side = |first: Bone, last: Bone| (first.index()..=last.index()).contains(&index);
            side(Bone::LeftUpperArm, Bone::LeftLittleDistal)
                || side(Bone::RightUpperArm, Bone::RightLittleDistal)
        })
        .map(|(_, weight)| weight)
        .sum()
}

/// Hull corners with smooth outward directions and the skin's weights.
fn corners(skin: &SkinnedMesh, hull: &[CutPoint]) -> Vec<Corner> {
    let len = hull.len();
    (0..len)
        .map(|index| {
            let [before, here, after] =
                [index + len - 1, index, index + 1].map(|i| hull[i % len].point);
            // Counter-clockwise in (x, z): outward lies to the right of the way.
            let along = (here - before).normalize_or_zero() + (after - here).normalize_or_zero();
            let cut = &hull[index];
            let mut weights = BTreeMap::new();
            for (vertex, part) in cut.edge.into_iter().zip([1.0 - cut.share, cut.share]) {
                let vertex = vertex as usize;
                for (joint, weight) in skin.joints[vertex].into_iter().zip(skin.weights[vertex]) {
                    if weight > 0.0 {
                        *weights.entry(carrier(joint)).or_insert(0.0) += weight * part;
                    }
                }
            }
            Corner {
                point: here,
                outward: Vec2::new(along.y, -along.x),
                weights,
            }
        })
        .collect()
}

/// A closed way, begun where it crosses the middle of the back.
fn from_back(corners: &[Corner]) -> Vec<Corner> {
    let len = corners.len();
    for index in 0..len {
        let (a, b) = (&corners[index], &corners[(index + 1) % len]);
        // On the back the way runs from the right (-x) to the left (+x).
        if a.point.x < 0.0 && b.point.x >= 0.0 {
            let mut start = a.lerp(b, -a.point.x / (b.point.x - a.point.x));
            start.point.x = 0.0;
            let mut turned = vec![start];
            turned.extend((1..=len).map(|step| corners[(index + step) % len].clone()));
            return turned;
        }
    }
    corners.to_vec()
}

/// `count` points at equal arc length along a closed way.
fn resample(corners: &[Corner], count: usize) -> Vec<Corner> {
    let len = corners.len();
    if len < 3 {
        return Vec::new();
    }
    let gap = |index: usize| {
        corners[index]
            .point
            .distance(corners[(index + 1) % len].point)
    };
    let perimeter: f32 = (0..len).map(gap).sum();
    let mut points = Vec::with_capacity(count);
    let mut index = 0;
    let mut passed = 0.0;
    for point in 0..count {
        let wanted = perimeter * point as f32 / count as f32;
        while index + 1 < len && passed + gap(index) < wanted {
            passed += gap(index);
            index += 1;
        }
        let share = ((wanted - passed) / gap(index).max(1.0e-9)).clamp(0.0, 1.0);
        points.push(corners[index].lerp(&corners[(index + 1) % len], share));
    }
    points
}
