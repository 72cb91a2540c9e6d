//! Warping a body to the tape: heights by segments, then girths until every re-cut section has
//! its girth.
//!
//! Lengths keep radii and move levels: feet and head keep their size, legs stretch to the inseam,
//! the trunk to the rest; arms ride along unstretched. Girths scale each level horizontally, the
//! trunk about its axis and each leg about its own, which keeps breadth to depth.

use glam::Vec3;
use lole_geom::trig;

use super::half::is_on_plane;
use super::pchip::Pchip;
use super::section::{convex_hull, cut_points, perimeter};
use lole_language::Sentence;

use crate::sections::{Sections, Tube};
use crate::{BodyError, Figure, Measure, Measurements};

/// Share of the way from crotch to crown where a woman's waist lies (97.5 of 158 with inseam 71 cm).
const WAIST_SHARE: f32 = 0.3046;
/// Share of the way from crotch to crown where a man's waist lies (103 of 171 with inseam 78.4 cm).
const WAIST_SHARE_OF_MAN: f32 = 0.2657;
/// Share of the stature where the front points of the hip bones lie (ASIS .537 H).
const ASIS_SHARE: f32 = 0.537;
/// Sections may differ from the tape by this much [m]; half of what the tape itself repeats to.
const GIRTH_TOLERANCE: f32 = 0.0005;
const PASS_LIMIT: usize = 30;
/// Inner thighs stay this far from the mirror plane [m].
const THIGH_GAP: f32 = 0.002;

/// Smooth step of `x` from 0 to 1.
pub(crate) fn smooth_step(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// Girths in the order of [`Girths`], each with the level of the sections where its tape runs and
/// the girth it goes least well with.
const TAPES: [(Measure, &str, Measure); 9] = [
    (Measure::Bust, "bust", Measure::Underbust),
    (Measure::Waist, "waist", Measure::HighHip),
    (Measure::Hip, "hip", Measure::Thigh),
    (Measure::Thigh, "thigh", Measure::Hip),
    (Measure::Knee, "knee", Measure::Calf),
    (Measure::Calf, "calf", Measure::Knee),
    (Measure::Ankle, "ankle", Measure::Calf),
    (Measure::Underbust, "underbust", Measure::Bust),
    (Measure::HighHip, "high_hip", Measure::Hip),
];
const BUST: usize = 0;
const WAIST: usize = 1;
const HIP: usize = 2;
const THIGH: usize = 3;
const KNEE: usize = 4;
const CALF: usize = 5;
const ANKLE: usize = 6;
const UNDERBUST: usize = 7;
const HIGH_HIP: usize = 8;

/// Whether a tape runs around the trunk rather than one leg.
const fn is_of_trunk(tape: usize) -> bool {
    !matches!(tape, THIGH | KNEE | CALF | ANKLE)
}

/// Moves heights: floor, ankle, crotch, waist, neck base and crown.
pub(crate) struct Heights {
    curve: Pchip,
    shoulder: Vec3,
}

impl Heights {
    /// From the body's own crotch and crown [m] to the measured ones.
    pub(crate) fn new(body: &Sections, crotch: f32, crown: f32, tape: &Measurements) -> Self {
        #[expect(clippy::cast_possible_truncation, reason = "a body to 0.1 µm")]
        let [stature, inseam] = [tape.stature, tape.inseam_length].map(|x| x.to_m() as f32);
        let foot = body.joint("leftFoot").y;
        let neck = body.level("neckbase");
        let waist = body.tape_level("waist");
        let waist_share = match tape.figure {
            Figure::Child => (waist - crotch) / (crown - crotch),
            Figure::Man => WAIST_SHARE_OF_MAN,
            Figure::OfStature | Figure::Woman => WAIST_SHARE,
        };
        #[expect(clippy::cast_possible_truncation, reason = "a body to 0.1 µm")]
        let waist_height = (tape.waist_height).map_or_else(
            || inseam + waist_share * (stature - inseam),
            |height| height.to_m() as f32,
        );
        let curve = Pchip::new(&[
            [0.0, 0.0],
            [0.5 * foot, 0.5 * foot],
            [foot, foot],
            [crotch, inseam],
            [waist, waist_height],
            [neck, neck + stature - crown],
            [crown, stature],
        ]);
        Self {
            curve,
            shoulder: body.joint("leftUpperArm"),
        }
    }

    pub(crate) fn at(&self, height: f32) -> f32 {
        self.curve.at(height)
    }

    /// A point of the body; `arm` in `0..=1` says how far it rides with the shoulder.
    pub(crate) fn carry(&self, point: Vec3, arm: f32) -> Vec3 {
        let stretched = self.at(point.y);
        let ridden = point.y + self.at(self.shoulder.y) - self.shoulder.y;
        Vec3::new(point.x, stretched + (ridden - stretched) * arm, point.z)
    }

    /// The whole table of sections with every level, joint and ring carried.
    pub(crate) fn carry_sections(&self, body: &Sections) -> Sections {
        let mut carried = body.clone();
        for level in carried.tape.values_mut() {
            *level = self.at(*level);
        }
        for (name, level) in &mut carried.levels {
            if !name.ends_with("_x") && !name.ends_with("_z") {
                *level = self.at(*level);
            }
        }
        for (name, joint) in &mut carried.joints {
            *joint = self.carry(*joint, arm_share(name));
        }
        for tube in &mut carried.tubes {
            let arm = if tube.tube.is_arm() { 1.0 } else { 0.0 };
            for ring in &mut tube.rings {
                ring.center = self.carry(ring.center, arm);
            }
        }
        carried.head.center = self.carry(carried.head.center, 0.0);
        carried.height = self.at(body.height);
        carried
    }
}

/// 1 for joints of the arm below the shoulder joint, else 0.
pub(crate) fn arm_share(joint: &str) -> f32 {
    const FREE: [&str; 8] = [
        "LowerArm", "Hand", "Thumb", "Index", "Middle", "Ring", "Little", "tip_",
    ];
    if FREE.iter().any(|part| joint.contains(part)) {
        1.0
    } else {
        0.0
    }
}

/// Scales at the tape levels and what they act on.
pub(crate) struct Girths {
    /// `None` where the sections decide.
    targets: [Option<f32>; 9],
    scales: [f32; 9],
    levels: [f32; 9],
    armpit: f32,
    shoulder: f32,
    crotch: f32,
    stature: f32,
    trunk_z: Pchip,
    leg_x: Pchip,
    leg_z: Pchip,
}

/// The curves of one set of scales.
struct Scales {
    trunk: Pchip,
    leg: Pchip,
    hip_shift: f32,
}

impl Girths {
    /// `body` has its final heights, with the crotch at `crotch`.
    pub(crate) fn new(body: &Sections, crotch: f32, tape: &Measurements) -> Self {
        let axis = |tube: Tube, pick: fn(Vec3) -> f32| {
            let knots: Vec<[f32; 2]> = (body.tube(tube).rings.iter())
                .map(|ring| [ring.center.y, pick(ring.center)])
                .collect();
            Pchip::new(&knots)
        };
        #[expect(clippy::cast_possible_truncation, reason = "a girth to 0.1 µm")]
        let targets = TAPES.map(|(measure, ..)| Some(tape.get(measure)?.to_m() as f32));
        Self {
            targets,
            scales: [1.0; 9],
            levels: TAPES.map(|(_, level, _)| body.tape_level(level)),
            armpit: body.level("armpit"),
            shoulder: body.level("shoulder"),
            crotch,
            stature: body.height,
            trunk_z: axis(Tube::Torso, |center| center.z),
            leg_x: axis(Tube::Leg, |center| center.x),
            leg_z: axis(Tube::Leg, |center| center.z),
        }
    }

    /// Re-cuts and rescales until every girth is the measured one. `arms` is the share of each
    /// vertex that belongs to the arm. Returns the warped positions.
    pub(crate) fn fit(
        &mut self,
        positions: &[Vec3],
        triangles: &[[u32; 3]],
        arms: &[f32],
    ) -> Result<Vec<Vec3>, BodyError> {
        let bands: Vec<(usize, f32, Band)> = (0..TAPES.len())
            .filter_map(|tape| {
                let band = || Band::new(self.levels[tape], positions, triangles, arms);
                self.targets[tape].map(|target| (tape, target, band()))
            })
            .collect();
        let mut worst = (0, f32::INFINITY);
        for _ in 0..PASS_LIMIT {
            worst = (0, 0.0);
            let scales = self.scales;
            let girths: Vec<f32> = (bands.iter())
                .map(|(tape, _, band)| {
                    let warped = self.warp(&band.positions, &band.arms);
                    girth(&warped, &band.triangles, *tape, self.levels[*tape])
                })
                .collect();
            for (&(tape, target, _), girth) in bands.iter().zip(girths) {
                let error = (girth - target).abs();
                if error > worst.1 {
                    worst = (tape, error);
                }
                if girth > 0.0 {
                    self.scales[tape] *= target / girth;
                }
            }
            if worst.1 < GIRTH_TOLERANCE {
                let better = std::mem::replace(&mut self.scales, scales);
                let warped = self.warp(positions, arms);
                self.scales = better;
                return Ok(warped);
            }
        }
        let (measure, _, against) = TAPES[worst.0];
        let (tape, off_cm) = (measure.words(), worst.1 * 100.0);
        Err(BodyError::Unbuildable {
            reason: Sentence::new(
                format!("{}が {off_cm:.1} cm 合いません", tape.japanese),
                format!("the {} stays {off_cm:.1} cm off", tape.english),
            ),
            check: tape,
            against: against.words(),
        })
    }

    /// Warped positions at the present scales; vertices on the mirror plane stay there.
    pub(crate) fn warp(&self, positions: &[Vec3], arms: &[f32]) -> Vec<Vec3> {
        let scales = self.curves();
        (positions.iter().zip(arms))
            .map(|(&position, &arm)| {
                let mut warped = self.carry(&scales, position, arm);
                if is_on_plane(position) {
                    warped.x = 0.0;
                } else if position.y < self.crotch {
                    warped.x = warped.x.max(THIGH_GAP.min(position.x));
                }
                warped
            })
            .collect()
    }

    /// One point, such as a joint; `arm` is the share that rides with the arm.
    pub(crate) fn warp_point(&self, point: Vec3, arm: f32) -> Vec3 {
        self.carry(&self.curves(), point, arm)
    }

    fn curves(&self) -> Scales {
        let s = &self.scales;
        // What was not measured lies between its neighbors.
        let or_between = |tape: usize, a: usize, b: usize| match self.targets[tape] {
            Some(_) => s[tape],
            None => (s[a] * s[b]).sqrt(),
        };
        let logarithms = |knots: &[[f32; 2]]| {
            let knots: Vec<[f32; 2]> = knots.iter().map(|&[y, g]| [y, trig::ln(g)]).collect();
            Pchip::new(&knots)
        };
        let trunk = logarithms(&[
            [self.levels[HIP], s[HIP]],
            [self.levels[HIGH_HIP], or_between(HIGH_HIP, HIP, WAIST)],
            [self.levels[WAIST], s[WAIST]],
            [self.levels[UNDERBUST], or_between(UNDERBUST, WAIST, BUST)],
            [self.levels[BUST], s[BUST]],
            [
                self.armpit + 0.02 * self.stature,
                1.0 + 0.4 * (s[BUST] - 1.0),
            ],
            [self.shoulder + 0.01 * self.stature, 1.0],
            [self.stature, 1.0],
        ]);
        let leg = logarithms(&[
            [0.0, 1.0 + 0.2 * (s[ANKLE] - 1.0)],
            [0.03 * self.stature, 1.0 + 0.55 * (s[ANKLE] - 1.0)],
            [0.05 * self.stature, 1.0 + 0.85 * (s[ANKLE] - 1.0)],
            [self.levels[ANKLE], s[ANKLE]],
            [self.levels[CALF], s[CALF]],
            [self.levels[KNEE], s[KNEE]],
            [self.levels[THIGH], s[THIGH]],
            [self.levels[HIP], s[HIP]],
        ]);
        Scales {
            trunk,
            leg,
            hip_shift: (s[HIP] - 1.0) * self.leg_x.at(self.crotch),
        }
    }

    fn carry(&self, scales: &Scales, point: Vec3, arm: f32) -> Vec3 {
        let y = point.y;
        let trunk = trig::exp(scales.trunk.at(y)) - 1.0;
        let leg = trig::exp(scales.leg.at(y)) - 1.0;
        let trunk_share =
            smooth_step((y - (self.crotch - 0.035 * self.stature)) / (0.06 * self.stature));
        let knee = self.levels[KNEE];
        let shift = scales.hip_shift * smooth_step((y - knee) / (self.crotch - knee));
        let side = if point.x < 0.0 { -1.0 } else { 1.0 };
        let by_trunk = Vec3::new(point.x, 0.0, point.z - self.trunk_z.at(y)) * trunk;
        let by_leg = Vec3::new(
            ((point.x.abs() - self.leg_x.at(y)) * leg + shift) * side,
            0.0,
            (point.z - self.leg_z.at(y)) * leg,
        );
        point + (by_leg + (by_trunk - by_leg) * trunk_share) * (1.0 - arm)
    }
}

/// The triangles that one tape cuts, with their own vertices: the warp is horizontal, so they stay
/// the same whatever the scales, and each pass warps only them.
struct Band {
    positions: Vec<Vec3>,
    arms: Vec<f32>,
    triangles: Vec<[u32; 3]>,
}

impl Band {
    fn new(height: f32, positions: &[Vec3], triangles: &[[u32; 3]], arms: &[f32]) -> Self {
        let is_under = |vertex: u32| positions[vertex as usize].y < height;
        let mut band = Self {
            positions: Vec::new(),
            arms: Vec::new(),
            triangles: Vec::new(),
        };
        for &triangle in triangles {
            let under = triangle.map(is_under);
            let is_cut = under[0] != under[1] || under[0] != under[2];
            if is_cut && triangle.iter().all(|&vertex| arms[vertex as usize] < 0.5) {
                band.triangles.push(triangle.map(|vertex| {
                    band.positions.push(positions[vertex as usize]);
                    band.arms.push(arms[vertex as usize]);
                    u32::try_from(band.positions.len() - 1).unwrap_or(u32::MAX)
                }));
            }
        }
        band
    }
}

/// Girth [m] of a cut of the left half: of the trunk with its mirror image, or of the left leg.
fn girth(positions: &[Vec3], triangles: &[[u32; 3]], tape: usize, height: f32) -> f32 {
    let mut cuts = cut_points(positions, triangles.iter().copied(), height);
    if is_of_trunk(tape) {
        for index in 0..cuts.len() {
            let mut mirrored = cuts[index];
            mirrored.point.x = -mirrored.point.x;
            cuts.push(mirrored);
        }
    }
    perimeter(&convex_hull(cuts))
}

/// Level of the hip bones' front points before lengths are carried [m].
pub(crate) fn asis_level(body: &Sections) -> f32 {
    ASIS_SHARE * body.height
}
