//! Forearms beside a skirt: they press it towards the dancer, and never away from her.
//!
//! What hangs on hips and legs lies between them and the hands. A forearm that hangs down, or a hand
//! on the hip, meets it from outside only: the faces that look away from the body touch nothing, or a
//! skirt that came to lie around a hand would be dragged along by it. Where an arm comes so near to
//! the body that folded cloth finds no room in between, which recorded dancers in tight clothes and
//! bodies of other proportions do all the time, it touches nothing at all: the skirt keeps to the
//! body, and the arm lies in its folds. Upper arms are a body like the trunk: a top lies against
//! them.

use std::collections::BTreeMap;

use glam::Vec3;
use lole_body::{Bone, Dancer};
use lole_geom::{Capsule, MeshSurfels, Surfel};

/// Room that folded cloth takes between an arm and the body [m].
const FOLDS: f32 = 0.03;

/// An arm nearer than this to the body [m] may have the body's cloth around it.
const NEAR: f32 = 0.25;

/// Length of a slice of an arm [m], all of which touches cloth or does not.
const SLICE: f32 = 0.025;

/// Which surfels of the skin are the forearms' and hands'.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Forearms {
    /// Surfels of every slice.
    slices: Vec<Vec<u32>>,
}

impl Forearms {
    /// Cuts the forearms and hands of a dancer, whose skin is given as surfels, into slices.
    pub(crate) fn new(dancer: &Dancer, surfels: &MeshSurfels) -> Self {
        let mut slices = BTreeMap::<(Bone, u32), Vec<u32>>::new();
        for (surfel, corner) in (0..).zip(surfels.carriers()) {
            let corner = corner as usize;
            let bone = Bone::ALL[usize::from(dancer.skin.joints[corner][0])];
            let Some(forearm) = forearm_of(bone) else {
                continue;
            };
            let from_elbow = dancer.skin.positions[corner].distance(dancer.skeleton.joint(forearm));
            let key = (forearm, whole_slices(from_elbow));
            slices.entry(key).or_default().push(surfel);
        }
        Self {
            slices: slices.into_values().collect(),
        }
    }

    /// Copies them out of the surfels of the skin.
    pub(crate) fn copy_whole(&self, surfels: &[Surfel], out: &mut Vec<Surfel>) {
        out.clear();
        let all = self.slices.iter().flatten();
        out.extend(all.map(|&surfel| surfels[surfel as usize]));
    }

    /// Takes the normals of all of them.
    pub(crate) fn withdraw_all(&self, surfels: &mut [Surfel]) {
        for &surfel in self.slices.iter().flatten() {
            surfels[surfel as usize].normal = Vec3::ZERO;
        }
    }

    /// Takes the normals of those surfels that touch nothing beside a body, whose capsules from waist
    /// to ankle are given.
    pub(crate) fn withdraw(&self, body: &[Capsule], surfels: &mut [Surfel]) {
        for slice in &self.slices {
            withdraw_slice(slice, body, surfels);
        }
    }
}

fn withdraw_slice(slice: &[u32], body: &[Capsule], surfels: &mut [Surfel]) {
    let mut low = Vec3::INFINITY;
    let mut high = Vec3::NEG_INFINITY;
    for &surfel in slice {
        let position = surfels[surfel as usize].position;
        (low, high) = (low.min(position), high.max(position));
    }
    let around = ((low + high) * 0.5, 0.5 * low.distance(high));
    let positions = slice
        .iter()
        .map(|&surfel| surfels[surfel as usize].position);
    let gap = gap(around, positions, body);
    if NEAR < gap {
        return;
    }
    let outward = away_from(body, around.0);
    for &surfel in slice {
        let surfel = &mut surfels[surfel as usize];
        if gap < FOLDS || 0.0 < surfel.normal.dot(outward) {
            surfel.normal = Vec3::ZERO;
        }
    }
}

/// Distance from points, all in a ball, to a body [m]: right where it is less than [`FOLDS`], and
/// on the right side of [`NEAR`]. The ball alone says that of most capsules.
fn gap(
    (center, radius): (Vec3, f32),
    points: impl Iterator<Item = Vec3> + Clone,
    body: &[Capsule],
) -> f32 {
    let mut gap = f32::INFINITY;
    for capsule in body {
        let least = capsule.signed_distance(center) - radius;
        let is_told = NEAR < least || (FOLDS <= least && least + 2.0 * radius <= NEAR);
        if is_told {
            gap = gap.min(least);
        } else {
            let distances = points.clone().map(|point| capsule.signed_distance(point));
            gap = distances.fold(gap, f32::min);
        }
    }
    gap
}

/// Direction from the axis of the nearest capsule to a point.
fn away_from(capsules: &[Capsule], point: Vec3) -> Vec3 {
    let nearest = capsules
        .iter()
        .min_by(|a, b| (a.signed_distance(point)).total_cmp(&b.signed_distance(point)));
    let Some(capsule) = nearest else {
        return Vec3::ZERO;
    };
    let s = capsule.axis_parameter(point);
    (point - capsule.ends[0].lerp(capsule.ends[1], s)).normalize_or_zero()
}

/// The forearm that carries a bone, if one does.
fn forearm_of(bone: Bone) -> Option<Bone> {
    let is_forearm = |bone: &Bone| matches!(bone, Bone::LeftLowerArm | Bone::RightLowerArm);
    bone.lineage().find(is_forearm)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "an arm is some dozens of slices long"
)]
fn whole_slices(length: f32) -> u32 {
    (length / SLICE) as u32
}
