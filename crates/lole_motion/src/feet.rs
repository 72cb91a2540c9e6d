//! Feet on the floor: those that stand in the recording stand still, none goes below, and the legs
//! are bent to reach.
//!
//! A foot stands while its ball is low and slow. There its ball is held where it was on average and
//! its lowest point is put on the floor; between two stands the shift goes over from one to the
//! other, so that the leap or the step between them is kept.

use glam::{Quat, Vec3};
use lole_body::ik::two_bone;
use lole_body::{Bone, Pose, Skeleton};

use crate::clip::POSES_PER_SECOND;

/// Fastest ball of a foot that stands [m/s].
const SLOW: f32 = 0.3;
/// Highest ball of a foot that stands [m], over its lowest of the dance.
const LOW: f32 = 0.05;
/// Shortest stand in poses, and shortest break between two: 0.1 s.
const SHORTEST: usize = 6;
/// How far a ball may creep while it stands [m], before it is held elsewhere.
const CREEP: f32 = 0.05;
/// A drift that is taken away and is slower than this [m/s] is taken up by the legs; feet of a
/// faster one slide with it, as on a treadmill.
const TREADMILL: f32 = 0.08;
/// Part of the leg's length that it stretches to at most.
const STRETCH: f32 = 0.995;
/// Poses over which the hips give way where a leg is too short.
const GIVE: usize = 8;
/// The heel is about 1.35 times as far behind the ball as the ankle is; toes are half of that.
const HEEL_BEYOND_ANKLE: f32 = 1.35;
const TOES_BEYOND_BALL: f32 = 0.45;

/// Whose feet, and on what floor.
pub(crate) struct Planting<'a> {
    pub(crate) skeleton: &'a Skeleton,
    /// Way that was taken away from each pose to the next [m].
    pub(crate) drift: Vec3,
    /// Whether the last pose goes over into the first.
    pub(crate) closed: bool,
}

/// One foot in one pose.
#[derive(Debug, Clone, Copy)]
struct Sole {
    /// Place on the floor's side of the ball [m].
    ball: Vec3,
    /// Height of the lowest of heel, ball and toes [m].
    lowest: f32,
}

/// Puts the feet of a dance on the floor.
pub(crate) fn plant(poses: &mut Vec<Pose>, planting: &Planting<'_>) {
    if poses.is_empty() {
        return;
    }
    let count = poses.len();
    if planting.closed {
        // Three rounds, of which the middle one has a neighbor on either side.
        let round = poses.clone();
        poses.extend_from_slice(&round);
        poses.extend(round);
    }
    let soles = [0, 1].map(|side| {
        let each = poses.iter();
        each.map(|pose| sole(planting.skeleton, pose, side))
            .collect::<Vec<_>>()
    });
    let stands = [0, 1].map(|side| stands(&soles[side], planting.drift));
    let floor = floor(&soles, &stands);
    for pose in poses.iter_mut() {
        pose.hips_translation.y -= floor;
    }
    let shifts = [0, 1].map(|side| shifts(&soles[side], &stands[side], floor, planting.drift));
    let drops = drops(poses, planting.skeleton, &shifts);
    for (index, pose) in poses.iter_mut().enumerate() {
        let shifts = [shifts[0][index], shifts[1][index]];
        bend_legs(planting.skeleton, pose, drops[index], shifts);
    }
    if planting.closed {
        poses.drain(..count);
        poses.truncate(count);
    }
}

fn sole(skeleton: &Skeleton, pose: &Pose, side: usize) -> Sole {
    let [.., foot, toes] = Bone::LEGS[side];
    let (ankle, ball) = (skeleton.joint(foot), skeleton.joint(toes));
    let arm = ball - ankle;
    let on_floor = |point: Vec3| point.with_y(0.0);
    let heel = on_floor(ball - arm * HEEL_BEYOND_ANKLE);
    let tip = on_floor(ball + arm * TOES_BEYOND_BALL);
    let world_from_bind = skeleton.world_from_bind(pose);
    let [foot, toes] = [foot, toes].map(|bone| world_from_bind[bone.index()]);
    let heel = foot.transform_point3(heel);
    let ball = foot.transform_point3(on_floor(ball));
    let tip = toes.transform_point3(tip);
    Sole {
        ball,
        lowest: heel.y.min(ball.y).min(tip.y),
    }
}

/// A stand: its first pose, and the one after its last.
type Stand = [usize; 2];

/// When a foot stands. `drift` was taken away from the way of the body: what stood on the recorded
/// floor moves against it.
fn stands(soles: &[Sole], drift: Vec3) -> Vec<Stand> {
    let mut heights: Vec<f32> = soles.iter().map(|sole| sole.ball.y).collect();
    heights.sort_by(f32::total_cmp);
    let low = heights[heights.len() / 20] + LOW;
    let place = |index: usize| soles[index].ball + drift * index as f32;
    let standing = |index: usize| {
        let (before, after) = (index.saturating_sub(2), (index + 2).min(soles.len() - 1));
        let way = place(after).distance(place(before));
        let seconds = (after - before).max(1) as f32 / POSES_PER_SECOND;
        soles[index].ball.y < low && way < SLOW * seconds
    };
    let mut stands: Vec<Stand> = Vec::new();
    let mut begun: Option<usize> = None;
    for index in 0..=soles.len() {
        let stands_on = index < soles.len() && standing(index);
        let crept = begun.is_some_and(|begun| {
            index < soles.len() && CREEP < (place(index) - place(begun)).with_y(0.0).length()
        });
        match begun {
            None if stands_on => begun = Some(index),
            Some(first) if !stands_on || crept => {
                stands.push([first, index]);
                // The foot takes a moment to be held elsewhere.
                begun = None;
            }
            _ => {}
        }
    }
    stands.retain(|[first, end]| SHORTEST <= end - first);
    // Stands follow each other with room for the foot to go over.
    for i in 1..stands.len() {
        let room = stands[i][0] - stands[i - 1][1];
        let cut = SHORTEST.saturating_sub(room).div_ceil(2).min(2);
        stands[i][0] += cut;
        stands[i - 1][1] -= cut;
    }
    stands
}

/// Height of the recorded floor [m]: that of soles that stand, else of the lowest ones.
fn floor(soles: &[Vec<Sole>; 2], stands: &[Vec<Stand>; 2]) -> f32 {
    let standing = soles.iter().zip(stands).flat_map(|(soles, stands)| {
        let ranges = stands.iter().map(|&[first, end]| &soles[first..end]);
        ranges.flatten().map(|sole| sole.lowest)
    });
    let mut heights: Vec<f32> = standing.collect();
    let part = if heights.is_empty() {
        heights = soles.iter().flatten().map(|sole| sole.lowest).collect();
        20
    } else {
        2
    };
    heights.sort_by(f32::total_cmp);
    heights[heights.len() / part]
}

/// How far a foot is moved in each pose [m].
fn shifts(soles: &[Sole], stands: &[Stand], floor: f32, drift: Vec3) -> Vec<Vec3> {
    let belt = if drift.length() * POSES_PER_SECOND < TREADMILL {
        Vec3::ZERO
    } else {
        drift
    };
    let mut shifts = vec![Vec3::ZERO; soles.len()];
    for &[first, end] in stands {
        let place = |index: usize| (soles[index].ball + belt * index as f32).with_y(0.0);
        let held = (first..end).map(place).sum::<Vec3>() / (end - first) as f32;
        for (index, shift) in shifts.iter_mut().enumerate().take(end).skip(first) {
            *shift = (held - place(index)).with_y(floor - soles[index].lowest);
        }
    }
    for (i, gap) in gaps(stands, soles.len()).into_iter().enumerate() {
        let before = (i > 0).then(|| shifts[gap[0] - 1]);
        let after = (gap[1] < soles.len()).then(|| shifts[gap[1]]);
        let (from, to) = match (before, after) {
            (Some(before), Some(after)) => (before, after),
            (Some(only), None) | (None, Some(only)) => (only, only),
            (None, None) => (Vec3::ZERO, Vec3::ZERO),
        };
        let length = (gap[1] - gap[0] + 1) as f32;
        for index in gap[0]..gap[1] {
            let share = (index + 1 - gap[0]) as f32 / length;
            let eased = share * share * (3.0 - 2.0 * share);
            let shift = from.lerp(to, eased);
            shifts[index] = shift.with_y(shift.y.max(floor - soles[index].lowest));
        }
    }
    shifts
}

/// The poses before, between and after the stands.
fn gaps(stands: &[Stand], count: usize) -> Vec<Stand> {
    let starts = std::iter::once(0).chain(stands.iter().map(|stand| stand[1]));
    let ends = stands.iter().map(|stand| stand[0]).chain([count]);
    starts.zip(ends).map(|(start, end)| [start, end]).collect()
}

/// A leg in a pose [m].
struct Leg {
    hip: Vec3,
    knee: Vec3,
    ankle: Vec3,
    /// World turns of thigh, shank and foot.
    turns: [Quat; 3],
}

impl Leg {
    fn of(skeleton: &Skeleton, pose: &Pose, side: usize) -> Self {
        let [upper, lower, foot, _] = Bone::LEGS[side];
        let world_from_bind = skeleton.world_from_bind(pose);
        let at = |bone: Bone| world_from_bind[bone.index()].transform_point3(skeleton.joint(bone));
        let above = pose.rotation(Bone::Hips);
        let thigh = above * pose.rotation(upper);
        let shank = thigh * pose.rotation(lower);
        Self {
            hip: at(upper),
            knee: at(lower),
            ankle: at(foot),
            turns: [thigh, shank, shank * pose.rotation(foot)],
        }
    }

    fn lengths(&self) -> [f32; 2] {
        [self.hip.distance(self.knee), self.knee.distance(self.ankle)]
    }
}

/// How far the hips are lowered in each pose [m] for both legs to reach, softly.
fn drops(poses: &[Pose], skeleton: &Skeleton, shifts: &[Vec<Vec3>; 2]) -> Vec<f32> {
    let needed: Vec<f32> = poses
        .iter()
        .enumerate()
        .map(|(index, pose)| {
            let of_leg = |side: usize| {
                let leg = Leg::of(skeleton, pose, side);
                let [upper, lower] = leg.lengths();
                let reach = STRETCH * (upper + lower);
                let way = leg.ankle + shifts[side][index] - leg.hip;
                let aside = way.with_y(0.0).length_squared();
                let under = (reach * reach - aside).max(0.1 * reach * reach).sqrt();
                -way.y - under
            };
            of_leg(0).max(of_leg(1)).max(0.0)
        })
        .collect();
    // The mean of the largest ones nearby is nowhere less than what is needed.
    let around = |index: usize| index.saturating_sub(GIVE)..(index + GIVE + 1).min(needed.len());
    let largest: Vec<f32> = (0..needed.len())
        .map(|index| needed[around(index)].iter().copied().fold(0.0, f32::max))
        .collect();
    (0..needed.len())
        .map(|index| {
            let near = &largest[around(index)];
            near.iter().sum::<f32>() / near.len() as f32
        })
        .collect()
}

/// Lowers the hips and bends the legs so that each foot is shifted and keeps its turn.
fn bend_legs(skeleton: &Skeleton, pose: &mut Pose, drop: f32, shifts: [Vec3; 2]) {
    let recorded = [0, 1].map(|side| Leg::of(skeleton, pose, side));
    pose.hips_translation.y -= drop;
    for (side, (leg, shift)) in recorded.into_iter().zip(shifts).enumerate() {
        let [upper, lower, foot, _] = Bone::LEGS[side];
        let hip = leg.hip - Vec3::Y * drop;
        let ankle = leg.ankle + shift;
        let [thigh, shank, sole] = leg.turns;
        // A straight leg bends where the front of its thigh is.
        let chord = leg.ankle - leg.hip;
        let along = chord * ((leg.knee - leg.hip).dot(chord) / chord.length_squared().max(1e-9));
        let pole = leg.knee - leg.hip - along + thigh * Vec3::Z * 0.02;
        let solved = two_bone(hip, ankle, leg.lengths(), pole);
        let swing = |from: Vec3, to: Vec3| Quat::from_rotation_arc(from.normalize_or(to), to);
        let new_thigh = swing(leg.knee - leg.hip, solved.upper) * thigh;
        let new_shank = swing(leg.ankle - leg.knee, solved.lower) * shank;
        let hips = pose.rotation(Bone::Hips);
        pose.rotate(upper, (hips.inverse() * new_thigh).normalize());
        pose.rotate(lower, (new_thigh.inverse() * new_shank).normalize());
        pose.rotate(foot, (new_shank.inverse() * sole).normalize());
    }
}
