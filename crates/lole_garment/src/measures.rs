//! What a tailor would measure of a built dancer, for [`lole_pattern`] to draft from.
//!
//! Girths run along the convex hull of a cut through the skin, as a taut tape does; lengths over the
//! trunk along the hull of an upright cut. What no tape finds on a standing surface follows by a
//! proportion, each with its source; those of the arm's eye and of the neck are estimates.

mod section;

use glam::{Vec2, Vec3};
use lole_body::{Bone, Dancer, Measure, Tape};
use lole_geom::Length;
use lole_pattern::Measures;
use lole_pattern::measures::TrunkGirth;

use section::{Plane, Skin, hull_length, taut};

/// Points of a tape around the trunk.
const TAPE_POINTS: usize = 360;
/// Distance between the tapes around the trunk [m].
const TAPE_STEP: f32 = 0.02;

/// Girth of the neck's root (36 cm on women of 158 cm) over the narrowest of the built neck, which is
/// slender (29.3 cm).
const NECK_ROOT: f32 = 1.23;
/// The neck's root over the stature, at most: a child's chin lies low. Estimated.
const WIDEST_NECK: f32 = 0.26;
/// Heads of 51 cm at a stature of 115 cm and 54.5 cm at 158 cm, where the built one is smaller.
const HEAD: [[f32; 2]; 2] = [[1.15, 0.51], [1.58, 0.545]];
/// Wrists of 12.5 cm and 15 cm at the same statures, where the built ones are thinner. Estimated.
const WRISTS: [[f32; 2]; 2] = [[1.15, 0.125], [1.58, 0.15]];
/// Where the head is measured, from the joint of the head to the crown: above the brows.
const BROWS: f32 = 0.25;
/// Where arms are measured, along their bones: below the armpit, and at the wrist.
const UPPER_ARM: f32 = 0.4;
const WRIST: f32 = 0.95;
/// The armpit lies this much of the stature below the shoulder joint: 0.765 and 0.794 of the stature on
/// the measured woman.
const ARMPIT_BELOW_JOINT: f32 = 0.029;
/// Half the breadth of the neck's root over its girth, as a drafter of blocks lays it out.
const HALF_NECK: f32 = 0.2;
/// The side of the neck over the nape, where no skin is found there: over the stature.
const NECK_OVER_NAPE: f32 = 0.010;
/// Shoulder drop over half the shoulder breadth beyond the neck, where no skin is found: 21 degrees.
const SHOULDER_SLOPE: f32 = 0.384;
/// Distance of the bust points over the bust girth: 18 cm to 83.5 cm in published blocks, and what it can
/// be on a body.
const BUST_POINTS: [f32; 2] = [0.17, 0.24];
/// Direction in which the left bust point is the farthest of the bust's cut, to the side and to the
/// front.
const TO_BUST_POINT: Vec2 = Vec2::new(0.35, 0.94);
/// Breadth that an arm takes of half the trunk's girth, over the arm's girth: published blocks leave it
/// 9.7 cm to an arm of 26 cm.
const ARM_BREADTH: f32 = 0.373;
/// Half of the back is this much broader than half of the chest [m].
const BACK_OVER_CHEST: f32 = 0.006;
/// Back and chest end this far inside the shoulder points [m] on each side, at least.
const INSIDE_SHOULDER: [f32; 2] = [0.010, 0.016];

/// Measures of a dancer, standing as she was built.
#[must_use]
pub fn measures(dancer: &Dancer) -> Measures {
    let body = Body::new(dancer);
    let levels = &dancer.landmarks;
    let at = |height: f32| Length::from_m(f64::from(height));
    let upper_arm_girth = body.limb(Bone::LeftUpperArm, Bone::LeftLowerArm, UPPER_ARM);
    let neck_girth = body.neck_girth();
    let neck = body.neck_side(neck_girth);
    let shoulder_breadth = body.tape(Measure::ShoulderBreadth);
    let [back_breadth, chest_breadth] = body.breadths(upper_arm_girth, shoulder_breadth);
    let elbow_to_wrist = body.distance(Bone::LeftLowerArm, Bone::LeftHand);
    let upper_arm_length = body.tape(Measure::UpperArmLength);
    let armpit = body.armpit_height();
    Measures {
        stature: at(levels.crown_height),
        bust_girth: dancer.measurements.bust_girth,
        underbust_girth: at(body.tape(Measure::Underbust)),
        waist_girth: dancer.measurements.waist_girth,
        hip_girth: dancer.measurements.hip_girth,
        neck_girth: at(neck_girth),
        head_girth: at(body.head_girth()),
        upper_arm_girth: at(upper_arm_girth),
        wrist_girth: at(body.wrist_girth()),
        ankle_girth: at(body.tape(Measure::Ankle)),
        crotch_length: at(body.crotch_length()),
        shoulder_breadth: at(shoulder_breadth),
        upper_arm_length: at(upper_arm_length),
        arm_length: at(upper_arm_length + elbow_to_wrist),
        back_length: at(body.back_length()),
        front_length: at(body.front_length(neck)),
        shoulder_drop: at(body.shoulder_drop(neck, shoulder_breadth)),
        back_breadth: at(back_breadth),
        chest_breadth: at(chest_breadth),
        bust_point_breadth: at(2.0 * body.half_bust_points()),
        neck_height: at(neck.y),
        bust_height: at(levels.bust_height),
        armpit_height: at(armpit),
        waist_height: at(levels.waist_height),
        hip_bone_height: at(levels.asis_height),
        hip_height: at(levels.hip_height),
        knee_height: at(levels.knee_tape_height),
        trunk: body.trunk(armpit),
    }
}

/// A dancer being measured.
struct Body<'a> {
    dancer: &'a Dancer,
    skin: Skin,
    taped: Vec<(Measure, f32)>,
}

impl<'a> Body<'a> {
    fn new(dancer: &'a Dancer) -> Self {
        let taped = dancer.taped(&Tape::default());
        Self {
            dancer,
            skin: Skin::new(&dancer.skin),
            taped: (taped
                .iter()
                .map(|line| (line.measure, line.on_body.to_m_f32())))
            .collect(),
        }
    }

    fn joint(&self, bone: Bone) -> Vec3 {
        self.dancer.skeleton.joint(bone)
    }

    fn distance(&self, from: Bone, to: Bone) -> f32 {
        self.joint(from).distance(self.joint(to))
    }

    fn stature(&self) -> f32 {
        self.dancer.landmarks.crown_height
    }

    /// What the tape finds.
    fn tape(&self, measure: Measure) -> f32 {
        let line = self.taped.iter().find(|(taped, _)| *taped == measure);
        line.map_or(0.0, |(_, meters)| *meters)
    }

    /// A taut tape around trunk, neck or head.
    fn girth(&self, height: f32) -> f32 {
        let ring = self.dancer.tape_ring(height, TAPE_POINTS);
        let next = ring.iter().cycle().skip(1);
        let gaps = ring.iter().zip(next);
        gaps.map(|(a, b)| a.bind_position.distance(b.bind_position))
            .sum()
    }

    fn trunk(&self, armpit: f32) -> Vec<TrunkGirth> {
        let crotch = self.dancer.landmarks.crotch_height;
        let mut tapes = Vec::new();
        let mut height = crotch;
        while height < armpit {
            let girth = f64::from(self.girth(height));
            tapes.push(TrunkGirth {
                height: Length::from_m(f64::from(height)),
                girth: Length::from_m(girth),
            });
            height += TAPE_STEP;
        }
        tapes
    }

    fn armpit_height(&self) -> f32 {
        self.joint(Bone::LeftUpperArm).y - ARMPIT_BELOW_JOINT * self.stature()
    }

    /// The narrowest cut between chest and head, made wider to the neck's root.
    fn neck_girth(&self) -> f32 {
        /// Cuts of the neck.
        const CUTS: usize = 9;
        let (low, high) = (self.joint(Bone::Neck).y, self.joint(Bone::Head).y);
        let cut = |index: usize| low + (high - low) * index as f32 / CUTS as f32;
        let girths = (0..=CUTS).map(|index| self.girth(cut(index)));
        let narrowest = girths
            .filter(|girth| 0.0 < *girth)
            .fold(f32::INFINITY, f32::min);
        (NECK_ROOT * narrowest).min(WIDEST_NECK * self.stature())
    }

    fn head_girth(&self) -> f32 {
        let joint = self.joint(Bone::Head).y;
        let built = self.girth(joint + BROWS * (self.stature() - joint));
        built.max(by_stature(HEAD, self.stature()))
    }

    fn wrist_girth(&self) -> f32 {
        let built = self.limb(Bone::LeftLowerArm, Bone::LeftHand, WRIST);
        built.max(by_stature(WRISTS, self.stature()))
    }

    /// A tape around a limb, at a share of the way from its joint to the next.
    fn limb(&self, from: Bone, to: Bone, share: f32) -> f32 {
        let (from_joint, to_joint) = (self.joint(from), self.joint(to));
        let center = from_joint.lerp(to_joint, share);
        let along = (to_joint - from_joint).normalize_or_zero();
        let plane = Plane::across(center, along);
        hull_length(self.skin.cut_left_arm(&plane))
    }

    /// The side of the neck's root.
    fn neck_side(&self, neck_girth: f32) -> Vec3 {
        let nape = self.joint(Bone::Neck);
        let x = HALF_NECK * neck_girth;
        let usual = nape.y + NECK_OVER_NAPE * self.stature();
        let highest = self.joint(Bone::Head).y;
        let found = self.skin.height_over(x, nape.z, highest);
        let near = found.filter(|height| (height - usual).abs() < 0.03 * self.stature());
        Vec3::new(x, near.unwrap_or(usual), nape.z)
    }

    fn shoulder_drop(&self, neck: Vec3, breadth: f32) -> f32 {
        let joint = self.joint(Bone::LeftUpperArm);
        let beyond = (0.5 * breadth - neck.x).max(0.01);
        let found = self.skin.height_over(0.5 * breadth, joint.z, neck.y);
        let drop = found.map_or(SHOULDER_SLOPE * beyond, |height| neck.y - height);
        // From 13 to 24 degrees, as published tables of shoulders go.
        drop.clamp(0.23 * beyond, 0.45 * beyond)
    }

    /// Back and chest between the arms.
    fn breadths(&self, arm_girth: f32, shoulder_breadth: f32) -> [f32; 2] {
        let half = 0.5 * self.tape(Measure::Bust) - ARM_BREADTH * arm_girth;
        let [of_back, of_chest] =
            [BACK_OVER_CHEST, -BACK_OVER_CHEST].map(|more| 0.5 * (half + more));
        let shoulder = 0.5 * shoulder_breadth;
        let least = |half: f32, inside: f32| 2.0 * half.min(shoulder - inside);
        [
            least(of_back, INSIDE_SHOULDER[0]),
            least(of_chest, INSIDE_SHOULDER[1]),
        ]
    }

    fn half_bust_points(&self) -> f32 {
        let ring = self
            .dancer
            .tape_ring(self.dancer.landmarks.bust_height, TAPE_POINTS);
        let places = ring.iter().map(|point| point.bind_position);
        let farthest = places.max_by(|a, b| {
            let reach = |place: &Vec3| Vec2::new(place.x, place.z).dot(TO_BUST_POINT);
            reach(a).total_cmp(&reach(b))
        });
        let bust = self.tape(Measure::Bust);
        let [least, most] = BUST_POINTS.map(|share| 0.5 * share * bust);
        farthest.map_or(0.5 * (least + most), |place| place.x.clamp(least, most))
    }

    /// From waist to waist between the legs, along the middle.
    fn crotch_length(&self) -> f32 {
        let waist = self.dancer.landmarks.waist_height;
        let crotch = self.dancer.landmarks.crotch_height;
        let plane = Plane::upright(MIDDLE);
        let cut = self.skin.cut(&plane, |place| {
            place.y <= waist && crotch - 0.05 < place.y && place.x.abs() < 0.05
        });
        let top = cut.iter().map(|point| point.y).fold(0.0, f32::max);
        let at_top = cut.iter().filter(|point| top - 0.02 < point.y);
        let sides = at_top.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], point| {
            [low.min(point.x), high.max(point.x)]
        });
        let across = (sides[1] - sides[0]).max(0.0);
        let length = hull_length(cut) - across;
        // Both ends of the tape lie at the waist, the cut ends up to a triangle below it.
        length + 2.0 * (waist - top).max(0.0)
    }

    /// From the nape down the middle of the back.
    fn back_length(&self) -> f32 {
        let (nape, waist) = (self.joint(Bone::Neck).y, self.dancer.landmarks.waist_height);
        let plane = Plane::upright(MIDDLE);
        let cut = self.skin.cut(&plane, |place| {
            waist <= place.y && place.y <= nape && place.z < self.joint(Bone::Chest).z
        });
        taut(cut, -1.0, [waist, nape])
    }

    /// From the side of the neck over the bust point.
    fn front_length(&self, neck: Vec3) -> f32 {
        let waist = self.dancer.landmarks.waist_height;
        let plane = Plane::upright(self.half_bust_points());
        let mut cut = self.skin.cut(&plane, |place| {
            waist <= place.y && place.y < neck.y && self.joint(Bone::Chest).z < place.z
        });
        cut.push(Vec2::new(neck.z, neck.y));
        taut(cut, 1.0, [waist, neck.y])
    }
}

/// A girth between two of `[stature, girth]`, along their line.
fn by_stature([low, high]: [[f32; 2]; 2], stature: f32) -> f32 {
    let share = (stature - low[0]) / (high[0] - low[0]);
    low[1] + share * (high[1] - low[1])
}

/// Where the middle of the body is cut [m]: beside its plane of symmetry, on which vertices lie.
const MIDDLE: f32 = 0.001;
