//! Loops in a dance, and the way that the dancer drifts.

use glam::Vec3;
use lole_body::{Bone, Pose, Skeleton};

use crate::clip::{POSES_PER_SECOND, mixed};

/// Poses over which the end of a loop goes over into its beginning: 0.4 s.
const SEAM: usize = 24;
/// Shortest loop in poses: 1.5 s, two counts of a slow dance.
const SHORTEST: usize = 90;
/// Moments that are compared at most; longer dances are compared at fewer.
const MOST_MOMENTS: usize = 1500;
/// Poses between two moments of a short dance.
const STRIDE: usize = 3;
/// Of all loops that close nearly as well as the best, up to this factor, the longest is taken.
const AS_GOOD: f32 = 1.15;

/// Bones whose joints are compared.
const COMPARED: [Bone; 10] = [
    Bone::Hips,
    Bone::Head,
    Bone::LeftLowerArm,
    Bone::RightLowerArm,
    Bone::LeftHand,
    Bone::RightHand,
    Bone::LeftLowerLeg,
    Bone::RightLowerLeg,
    Bone::LeftFoot,
    Bone::RightFoot,
];

/// A part of a dance that comes back to where it began.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Loop {
    /// First pose, and the one that is like it.
    start: usize,
    end: usize,
}

/// Joints of one moment [m], over the floor below the hips, and how fast they move [m/s].
struct Moment {
    joints: [Vec3; COMPARED.len()],
    velocities: [Vec3; COMPARED.len()],
}

/// Finds the best loop of a dance; `None` where it is too short for any.
pub(crate) fn find(poses: &[Pose], skeleton: &Skeleton) -> Option<Loop> {
    let stride = STRIDE.max(poses.len().div_ceil(MOST_MOMENTS));
    let places: Vec<_> = poses.iter().map(|pose| joints(pose, skeleton)).collect();
    let moments: Vec<(usize, Moment)> = (SEAM..poses.len().saturating_sub(2))
        .step_by(stride)
        .map(|pose| (pose, moment(&places, pose)))
        .collect();
    let pairs = || {
        let firsts = moments.iter().enumerate();
        firsts.flat_map(|(index, first)| {
            let later = moments[index..].iter();
            let later = later.filter(move |later| first.0 + SHORTEST <= later.0);
            later.map(move |later| (first.0, later.0, difference(&first.1, &later.1)))
        })
    };
    let best = pairs().map(|(.., cost)| cost).fold(f32::INFINITY, f32::min);
    let good = pairs().filter(|(.., cost)| *cost <= AS_GOOD * best);
    let longest = good.max_by_key(|(start, end, _)| (end - start, usize::MAX - start));
    longest.map(|(start, end, _)| Loop { start, end })
}

fn joints(pose: &Pose, skeleton: &Skeleton) -> [Vec3; COMPARED.len()] {
    let world_from_bind = skeleton.world_from_bind(pose);
    COMPARED.map(|bone| world_from_bind[bone.index()].transform_point3(skeleton.joint(bone)))
}

fn moment(places: &[[Vec3; COMPARED.len()]], pose: usize) -> Moment {
    let floor = places[pose][0].with_y(0.0);
    let (before, after) = (&places[pose - 1], &places[pose + 1]);
    let mut moment = Moment {
        joints: places[pose].map(|joint| joint - floor),
        velocities: [Vec3::ZERO; COMPARED.len()],
    };
    let pairs = before.iter().zip(after);
    for (velocity, (&before, &after)) in moment.velocities.iter_mut().zip(pairs) {
        *velocity = (after - before) * (0.5 * POSES_PER_SECOND);
    }
    moment
}

/// Mean square of how far joints lie apart [m²], with where they will be in 0.15 s.
fn difference(a: &Moment, b: &Moment) -> f32 {
    const AHEAD: f32 = 0.15;
    let joints = a.joints.iter().zip(&b.joints);
    let apart: f32 = joints.map(|(a, b)| a.distance_squared(*b)).sum();
    let velocities = a.velocities.iter().zip(&b.velocities);
    let ahead: f32 = velocities.map(|(a, b)| a.distance_squared(*b)).sum();
    (apart + AHEAD * AHEAD * ahead) / COMPARED.len() as f32
}

impl Loop {
    /// Cuts the loop out of a dance, its end going over into its beginning, and takes its drift
    /// away, which it gives [m per pose].
    pub(crate) fn cut(self, poses: &mut Vec<Pose>) -> Vec3 {
        let count = self.end - self.start;
        let way = |pose: usize| poses[pose].hips_translation.with_y(0.0);
        let drift = (way(self.end) - way(self.start)) / count as f32;
        let placed = |pose: usize, since: f32| {
            let mut placed = poses[pose].clone();
            placed.hips_translation -= drift * since;
            placed
        };
        let cut = (0..count).map(|index| {
            let pose = placed(self.start + index, index as f32);
            let left = count - index;
            if SEAM < left {
                return pose;
            }
            // What led to the beginning, on the same way.
            let before = placed(self.start - left, -(left as f32));
            let share = 1.0 - left as f32 / SEAM as f32;
            mixed(&pose, &before, share * share * (3.0 - 2.0 * share))
        });
        *poses = cut.collect();
        drift
    }
}

/// Takes away the straight way from the first pose to the last, which it gives [m per pose].
pub(crate) fn remove_drift(poses: &mut [Pose]) -> Vec3 {
    let [first, .., last] = &*poses else {
        return Vec3::ZERO;
    };
    let way = (last.hips_translation - first.hips_translation).with_y(0.0);
    let drift = way / (poses.len() - 1) as f32;
    for (index, pose) in poses.iter_mut().enumerate() {
        pose.hips_translation -= drift * index as f32;
    }
    drift
}
