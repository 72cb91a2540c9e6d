//! A dancer whose body is given instead of built: somebody's avatar. Her landmarks are found on her
//! skin and her tape is read off it, at the levels where a tape would be laid.
//!
//! | Level | Where |
//! |---|---|
//! | waist | the least trunk girth of the middle of the trunk |
//! | hip | the greatest from above the crotch to the waist |
//! | bust | the farthest to the front between waist and armpits |
//! | crotch | the lowest skin in the middle plane between the thighs |
//! | calf, ankle | the greatest and the least girth of the shank's parts |
//! | underbust, hip bones, thigh, knee | by the shares of the measured bodies between those |
//!
//! Tapes are laid with the arms lowered, whatever the bind pose: raised arms widen the chest.

mod leotard;
mod outer;

use std::ops::RangeInclusive;

use glam::{Quat, Vec2, Vec3};
use lole_geom::Length;
use lole_geom::mesh::vertex_normals;
use lole_language::words;

use crate::capsules::{CapsuleLayout, fit_capsules};
use crate::surface::section::{convex_hull, cut_points, perimeter};
use crate::tape::trunk;
use crate::{
    Appearance, BodyError, Bone, Dancer, Figure, Landmarks, Measure, Measurements, Pose, Skeleton,
    SkinnedMesh, Tape,
};

/// Levels that are tried between the ends of a search.
const LEVELS: u16 = 96;
/// Parts of the way from the hip joints to the shoulder joints among which the waist lies.
const WAIST: RangeInclusive<f32> = 0.18..=0.62;
/// Where it lies on a trunk that is nowhere narrowest between those.
const USUAL_WAIST: f32 = 0.42;
/// Parts of the way from the crotch to the waist among which the fullest hips lie: lower, the tape
/// would go around the thighs.
const HIP: RangeInclusive<f32> = 0.08..=0.8;
/// Parts of the way from the waist to the shoulder joints among which the bust lies.
const BUST: RangeInclusive<f32> = 0.42..=0.7;
/// Part of the way from the bust down to the waist where the tape under the bust lies.
const UNDERBUST: f32 = 0.4;
/// Part of the way from the hip joints up to the waist where the front points of the hip bones lie.
const ASIS: f32 = 0.39;
/// Crotch below the hip joints over the length of the thigh: usual, least and most.
const CROTCH: [f32; 3] = [0.22, 0.05, 0.45];
/// Thigh tape below the crotch, and knee tape below the knee joint, over the stature.
const BELOW_CROTCH: f32 = 0.015;
const BELOW_KNEE: f32 = 0.005;
/// Parts of the way from the ankle to the knee among which calf and ankle tape lie.
const CALF: RangeInclusive<f32> = 0.5..=0.85;
const ANKLE: RangeInclusive<f32> = 0.02..=0.35;
/// Direction of the measured bodies' upper arms, to the side and up: 47° below the horizontal.
const ARM: [f32; 2] = [0.681_998_4, -0.731_353_7];
/// Cosine of the greatest angle between a given normal and that of the outer surface.
const LEAST_AGREED: f32 = 0.7;
/// Least girth of a trunk over the stature; less is no trunk.
const LEAST_TRUNK: f32 = 0.15;

impl Dancer {
    /// The dancer of a given body in body space, in whatever bind pose: on the floor, front
    /// towards `+Z`. Its [`SkinnedMesh::surface`] is what is measured. One that is nothing but bare
    /// skin is drawn in the leotard.
    ///
    /// # Errors
    /// [`BodyError::Unmeasurable`] where a tape finds no trunk or no leg.
    pub fn of_skin(mut skeleton: Skeleton, mut skin: SkinnedMesh) -> Result<Self, BodyError> {
        meet_outer_surface(&mut skin, &skeleton);
        let landmarks = landmarks(&skeleton, &skin)?;
        let tapes = Tapes::new(&skeleton, &skin);
        skeleton.waist_side = tapes.side(landmarks.waist_height);
        leotard::dress(&mut skin, &skeleton, &landmarks, &tapes.positions);
        let capsules = fit_capsules(&skin, &skeleton, &landmarks, CapsuleLayout::default());
        let mut dancer = Self {
            drawn_body: None,
            measurements: Measurements::woman(),
            appearance: Appearance::default(),
            skeleton,
            skin,
            capsules,
            landmarks,
        };
        dancer.measurements = dancer.read_off();
        Ok(dancer)
    }

    /// What the tape reads on the given body.
    fn read_off(&self) -> Measurements {
        let taped = self.taped(&Tape::default());
        let on_body = |measure: Measure| {
            let mut all = taped.iter();
            let found = all.find(|taped| taped.measure == measure);
            found.map_or(Length::ZERO, |taped| taped.on_body)
        };
        Measurements {
            figure: Figure::OfStature,
            stature: on_body(Measure::Stature),
            bust_girth: on_body(Measure::Bust),
            underbust_girth: Some(on_body(Measure::Underbust)),
            waist_girth: on_body(Measure::Waist),
            high_hip_girth: Some(on_body(Measure::HighHip)),
            hip_girth: on_body(Measure::Hip),
            inseam_length: on_body(Measure::Inseam),
            thigh_girth: on_body(Measure::Thigh),
            knee_girth: on_body(Measure::Knee),
            calf_girth: on_body(Measure::Calf),
            ankle_girth: on_body(Measure::Ankle),
            waist_height: Some(on_body(Measure::WaistHeight)),
            shoulder_breadth: Some(on_body(Measure::ShoulderBreadth)),
            upper_arm_length: Some(on_body(Measure::UpperArmLength)),
        }
    }
}

/// Leaves of the surface what cloth can come to, with normals that look there.
fn meet_outer_surface(skin: &mut SkinnedMesh, skeleton: &Skeleton) {
    let middle_of = |vertex: u32| {
        let bone = skin.strongest_bone(vertex as usize);
        let start = skeleton.joint(bone);
        let place = skin.positions[vertex as usize];
        let next = (Bone::ALL.iter()).find(|next| next.parent() == Some(bone));
        let along = next.map_or(Vec3::Y, |&next| skeleton.joint(next) - start);
        let along = along.normalize_or(Vec3::Y);
        start + along * (place - start).dot(along)
    };
    skin.surface = outer::outer_surface(&skin.positions, &skin.surface, middle_of);
    let smooth = vertex_normals(&skin.positions, &skin.surface);
    for (normal, smooth) in skin.normals.iter_mut().zip(smooth) {
        if smooth != Vec3::ZERO && normal.dot(smooth) < LEAST_AGREED {
            *normal = smooth;
        }
    }
}

/// The skin as a tape meets it.
pub(crate) struct Tapes {
    /// Places of the skin with the arms lowered [m].
    positions: Vec<Vec3>,
    /// Triangles without the arms.
    trunk: Vec<[u32; 3]>,
}

impl Tapes {
    pub(crate) fn new(skeleton: &Skeleton, skin: &SkinnedMesh) -> Self {
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        let world_from_bind = skeleton.world_from_bind(&arms_lowered(skeleton));
        skin.pose(&world_from_bind, &mut positions, &mut normals);
        Self {
            positions,
            trunk: trunk(skin),
        }
    }

    /// How far to the front the trunk reaches at a height [m].
    fn front(&self, height: f32) -> f32 {
        let cuts = cut_points(&self.positions, self.trunk.iter().copied(), height);
        let fronts = cuts.iter().map(|cut| cut.point.y);
        fronts.fold(f32::NEG_INFINITY, f32::max)
    }

    /// The point of the trunk farthest to the left at a height [m].
    fn side(&self, height: f32) -> Vec3 {
        let cuts = cut_points(&self.positions, self.trunk.iter().copied(), height);
        let widest = (cuts.iter()).fold(Vec2::ZERO, |widest, cut| {
            if widest.x < cut.point.x {
                cut.point
            } else {
                widest
            }
        });
        Vec3::new(widest.x, height, widest.y)
    }

    /// Convex girth of everything but the arms at a height [m]; 0 where there is nothing.
    pub(crate) fn trunk(&self, height: f32) -> f32 {
        let trunk = self.trunk.iter().copied();
        perimeter(&convex_hull(cut_points(&self.positions, trunk, height)))
    }

    /// Convex girth of the left leg at a height [m] below the crotch.
    pub(crate) fn leg(&self, height: f32) -> f32 {
        let is_left = |triangle: &[u32; 3]| {
            let xs = triangle.map(|vertex| self.positions[vertex as usize].x);
            0.0 < xs.iter().sum::<f32>()
        };
        let left = self.trunk.iter().copied().filter(is_left);
        perimeter(&convex_hull(cut_points(&self.positions, left, height)))
    }

    /// Lowest point of the skin in the middle plane above `floor` [m].
    fn lowest_in_middle(&self, floor: f32) -> Option<f32> {
        let edges = self
            .trunk
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let cuts = edges.filter_map(|edge| {
            let [from, to] = edge.map(|vertex| self.positions[vertex as usize]);
            if (from.x < 0.0) == (to.x < 0.0) {
                return None;
            }
            Some(from.y + (to.y - from.y) * (from.x / (from.x - to.x)))
        });
        cuts.filter(|&y| floor < y).reduce(f32::min)
    }
}

/// The bind pose with the upper arms as the measured bodies hold theirs.
fn arms_lowered(skeleton: &Skeleton) -> Pose {
    let mut pose = Pose::default();
    for (upper, lower, side) in [
        (Bone::LeftUpperArm, Bone::LeftLowerArm, 1.0),
        (Bone::RightUpperArm, Bone::RightLowerArm, -1.0),
    ] {
        let arm = skeleton.joint(lower) - skeleton.joint(upper);
        let lowered = Vec3::new(side * ARM[0], ARM[1], 0.0);
        if let Some(arm) = arm.try_normalize() {
            pose.rotate(upper, Quat::from_rotation_arc(arm, lowered));
        }
    }
    pose
}

/// The level among [`LEVELS`] between two heights whose girth is best, and whether it is an end.
fn search(
    [low, high]: [f32; 2],
    girth: impl Fn(f32) -> f32,
    better: impl Fn(f32, f32) -> bool,
) -> (f32, bool) {
    let level = |step: u16| low + (high - low) * f32::from(step) / f32::from(LEVELS);
    let mut best = (0, girth(low));
    for step in 1..=LEVELS {
        let found = girth(level(step));
        if better(found, best.1) {
            best = (step, found);
        }
    }
    (level(best.0), best.0 == 0 || best.0 == LEVELS)
}

fn less(a: f32, b: f32) -> bool {
    0.0 < a && a < b
}

fn greater(a: f32, b: f32) -> bool {
    b < a
}

fn landmarks(skeleton: &Skeleton, skin: &SkinnedMesh) -> Result<Landmarks, BodyError> {
    let height = |bones: [Bone; 2]| {
        let [a, b] = bones.map(|bone| skeleton.joint(bone).y);
        0.5 * (a + b)
    };
    let hip_joint = height([Bone::LeftUpperLeg, Bone::RightUpperLeg]);
    let knee = height([Bone::LeftLowerLeg, Bone::RightLowerLeg]);
    let ankle = height([Bone::LeftFoot, Bone::RightFoot]);
    let shoulder = height([Bone::LeftUpperArm, Bone::RightUpperArm]);
    let between = |from: f32, to: f32, share: f32| from + (to - from) * share;
    let within = |from: f32, to: f32, shares: RangeInclusive<f32>| {
        [*shares.start(), *shares.end()].map(|share| between(from, to, share))
    };
    let crown = skin.surface_height();
    let unmeasurable = |what| BodyError::Unmeasurable { what };
    let in_order = [0.0, ankle, knee, hip_joint, shoulder, crown];
    if !in_order.is_sorted_by(|below, above| below < above) {
        return Err(unmeasurable(words(
            "関節の高さが足首・ひざ・股・肩・頭の順に並んでいません",
            "its ankles, knees, hips, shoulders and head do not lie above each other in the skin",
        )));
    }
    let tapes = Tapes::new(skeleton, skin);
    let trunk = |height| tapes.trunk(height);
    let leg = |height| tapes.leg(height);

    let [usual, least, most] = CROTCH.map(|share| between(hip_joint, knee, share));
    let crotch = tapes.lowest_in_middle(most).unwrap_or(usual).min(least);
    // A skirt or thighs that touch hide the crotch.
    let crotch = if most + 0.02 * (hip_joint - knee) < crotch {
        crotch
    } else {
        usual
    };
    let waist = match search(within(hip_joint, shoulder, WAIST), trunk, less) {
        (_, true) => between(hip_joint, shoulder, USUAL_WAIST),
        (level, false) => level,
    };
    let (hip, _) = search(within(crotch, waist, HIP), trunk, greater);
    let front = |height| tapes.front(height);
    let (bust, _) = search(within(waist, shoulder, BUST), front, greater);
    let thigh = crotch - BELOW_CROTCH * crown;
    let (calf, _) = search(within(ankle, knee, CALF), leg, greater);
    let (ankle_tape, _) = search(within(ankle, knee, ANKLE), leg, less);
    if trunk(waist).min(trunk(hip)).min(trunk(bust)) < LEAST_TRUNK * crown {
        return Err(unmeasurable(words(
            "胴の一周が測れません（胴のメッシュがありません）",
            "no tape goes around its trunk, because there is no skin where the bones say it is",
        )));
    }
    if leg(thigh) <= 0.0 || leg(calf) <= 0.0 {
        return Err(unmeasurable(words(
            "脚の一周が測れません（脚のメッシュがありません）",
            "no tape goes around its legs, because there is no skin where the bones say they are",
        )));
    }
    let asis = between(hip_joint, waist, ASIS);
    Ok(Landmarks {
        bust_height: bust,
        underbust_height: between(bust, waist, UNDERBUST),
        waist_height: waist,
        high_hip_height: asis,
        asis_height: asis,
        hip_height: hip,
        thigh_height: thigh,
        knee_tape_height: knee - BELOW_KNEE * crown,
        calf_height: calf,
        ankle_tape_height: ankle_tape,
        crotch_height: crotch,
        hip_joint_height: hip_joint,
        knee_height: knee,
        ankle_height: ankle,
        crown_height: crown,
    })
}
