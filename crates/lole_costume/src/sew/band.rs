//! Elastics around a body that somebody gave: rings that go with one bone and give way to what comes out
//! below them.
//!
//! The skin of a built dancer carries her elastics. Skin of somebody else may be trousers that open over
//! a belt, a leg that carries the side of the hip, or boxes that turn through each other: carried by it,
//! the points of an elastic would change places. So there the whole band goes with the bone that has most
//! of it, as a ring that keeps its order, and every frame each elastic is as much wider as skin has come
//! out in that direction, and as much higher as a thigh is raised there.

use glam::{Affine3A, Vec2, Vec3};
use lole_body::{Bone, TapePoint};
use lole_geom::{Surfel, trig};

use super::ring::Ring;
use super::rising::{self, Raised};

/// Directions around the body that are told apart.
const SECTORS: usize = 96;
/// Sectors on either side over which what pushes an elastic out is spread: 22°.
const SPREAD: usize = 6;
/// Skin so far above or below an elastic [m] lies under it.
const HALF_WIDTH: f32 = 0.01;
/// Skin pushes an elastic out that faces it at least so much (a cosine): what lies across it, as a thigh
/// does when she sits, does not.
const LEAST_FACING: f32 = 0.4;
/// Farthest that an elastic gives way [m]: what comes out farther goes through it.
const FARTHEST: f32 = 0.03;
/// Fastest that it gives way or comes back, and that it goes up or down [m/s].
const FASTEST: f32 = 0.3;
const FASTEST_UP: f32 = 0.6;
/// Skin farther from all elastics in the bind pose [m] never comes below one.
const NEAR: f32 = 0.35;

/// The elastics of a garment on somebody given.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    bone: Bone,
    elastics: Vec<Elastic>,
    /// How much farther an elastic may come out than the next, over their distance along the body.
    slope: f32,
}

/// One of them, in the bind pose.
#[derive(Debug, Clone, PartialEq)]
struct Elastic {
    axis: Vec2,
    /// By sector, a point of it [m] and the way out there.
    points: Vec<[Vec3; 2]>,
    /// Lowest and highest of the points [m].
    heights: [f32; 2],
}

/// How far each elastic of a band has given way [m], by elastic and sector.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Lifts {
    out: Vec<Vec<f32>>,
    up: Vec<Vec<f32>>,
}

/// A surfel of the skin that may come below a band, and the bone that carries it most.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Watched {
    /// Its place among all.
    pub surfel: u32,
    /// The bone.
    pub bone: Bone,
}

impl Band {
    /// Of the rings on which elastics lie, all carried by one bone; `taut` over 1 is how much longer than
    /// the rings are apart the cloth between them is.
    pub(super) fn new(rings: &[&Ring], bone: Bone, taut: f32) -> Self {
        Self {
            bone,
            elastics: rings.iter().map(|ring| Elastic::new(ring)).collect(),
            slope: (taut * taut - 1.0).max(0.0).sqrt(),
        }
    }

    /// The bone that most of some rings go with.
    pub(super) fn carrier(rings: &[Ring]) -> Bone {
        let mut shares = [0.0_f32; Bone::ALL.len()];
        for point in rings.iter().flat_map(Ring::points) {
            for (&joint, weight) in point.joints.iter().zip(point.weights) {
                shares[trunk_of(joint).index()] += weight;
            }
        }
        let most =
            (0..shares.len()).max_by(|&a, &b| shares[a].total_cmp(&shares[b]).then(b.cmp(&a)));
        most.map_or(Bone::Hips, |most| Bone::ALL[most])
    }

    /// Which of some places of the skin may come below it: `places` are the bones that carry them, and
    /// where they are in the bind pose [m].
    pub fn watched(&self, places: impl Iterator<Item = (Bone, Vec3)>) -> Vec<Watched> {
        let heights = || self.elastics.iter().map(|elastic| elastic.heights);
        let low = heights().fold(f32::INFINITY, |low, it| low.min(it[0]));
        let high = heights().fold(f32::NEG_INFINITY, |high, it| high.max(it[1]));
        let near = low - NEAR..high + NEAR;
        (0..)
            .zip(places)
            .filter(|(_, (bone, at))| is_trunk_or_leg(*bone) && near.contains(&at.y))
            .map(|(surfel, (bone, _))| Watched { surfel, bone })
            .collect()
    }

    /// How far skin, with the bones that carry it, has pushed each elastic out and up.
    pub fn lifts(
        &self,
        world_from_bind: &[Affine3A],
        surfels: impl Iterator<Item = (Surfel, Bone)>,
    ) -> Lifts {
        let bind_from_world = world_from_bind[self.bone.index()].inverse();
        let raised = Raised::new(world_from_bind);
        let none = vec![vec![0.0_f32; SECTORS]; self.elastics.len()];
        let (mut lifts, mut rises) = (none.clone(), none);
        for (surfel, bone) in surfels {
            if surfel.is_withdrawn() {
                continue;
            }
            let place = bind_from_world.transform_point3(surfel.position);
            let normal = bind_from_world.transform_vector3(surfel.normal);
            let is_raised = raised.has(bone, &surfel, normal);
            for ((elastic, lifts), rises) in self.elastics.iter().zip(&mut lifts).zip(&mut rises) {
                let [low, high] = elastic.heights;
                if is_raised && low < place.y + rising::CLEARANCE {
                    let sector = elastic.sector(place);
                    let rise = rising::rise(place, elastic.points[sector][0]);
                    rises[sector] = rises[sector].max(rise);
                }
                // Most skin is far below: its direction need not be known.
                let near = low - 2.0 * HALF_WIDTH..high + 2.0 * HALF_WIDTH;
                if !near.contains(&place.y) {
                    continue;
                }
                let sector = elastic.sector(place);
                let [at, outward] = elastic.points[sector];
                if HALF_WIDTH < (place.y - at.y).abs() || normal.dot(outward) < LEAST_FACING {
                    continue;
                }
                lifts[sector] = lifts[sector].max((place - at).dot(outward));
            }
        }
        for lifts in &mut lifts {
            spread(lifts, FARTHEST);
        }
        for rises in &mut rises {
            spread(rises, f32::INFINITY);
        }
        self.even_out(&mut lifts);
        self.even_out_rises(&mut rises);
        Lifts {
            out: lifts,
            up: rises,
        }
    }

    /// Lets no elastic go up through the next.
    fn even_out_rises(&self, rises: &mut [Vec<f32>]) {
        for sector in 0..SECTORS {
            let heights = self
                .elastics
                .iter()
                .map(|elastic| elastic.points[sector][0].y);
            let heights: Vec<f32> = heights.collect();
            let mut those: Vec<f32> = rises.iter().map(|rises| rises[sector]).collect();
            rising::even_out(&heights, &mut those);
            for (rises, rise) in rises.iter_mut().zip(those) {
                rises[sector] = rise;
            }
        }
    }

    /// Lets no elastic come out so much farther than the next that the cloth between them were too short.
    fn even_out(&self, lifts: &mut [Vec<f32>]) {
        let pairs = (1..lifts.len()).map(|lower| [lower - 1, lower]);
        for [one, other] in pairs.clone().chain(pairs.rev().map(|[a, b]| [b, a])) {
            let ways = [one, other].map(|it| self.elastics[it].points.iter().map(|[at, _]| at));
            let [from, to] = ways;
            let least: Vec<f32> = (lifts[one].iter().zip(from.zip(to)))
                .map(|(lift, (from, to))| lift - self.slope * from.distance(*to))
                .collect();
            for (lift, least) in lifts[other].iter_mut().zip(least) {
                *lift = lift.max(least);
            }
        }
    }

    /// Where a point of the cloth is in the world [m] that is so far outside (a lift) where it was sewn.
    pub(super) fn posed(&self, world_from_bind: &[Affine3A], point: &TapePoint, lift: f32) -> Vec3 {
        let place = point.bind_position + point.outward * lift;
        world_from_bind[self.bone.index()].transform_point3(place)
    }

    /// How far out an elastic has given way where a point of the cloth lies [m].
    pub(super) fn lift(&self, at: (usize, &TapePoint), lifts: &Lifts) -> f32 {
        self.value_at(at, &lifts.out)
    }

    /// How far it has gone up there [m].
    pub(super) fn rise(&self, at: (usize, &TapePoint), lifts: &Lifts) -> f32 {
        self.value_at(at, &lifts.up)
    }

    fn value_at(&self, (elastic, point): (usize, &TapePoint), values: &[Vec<f32>]) -> f32 {
        values.get(elastic).map_or(0.0, |values| {
            let (sector, share) = self.elastics[elastic].place(point.bind_position);
            let next = (sector + 1) % SECTORS;
            values[sector] + (values[next] - values[sector]) * share
        })
    }
}

impl Lifts {
    /// The same, so much farther out [m] on all sides.
    #[must_use]
    pub fn widened(&self, by: f32) -> Self {
        let widened = |lifts: &Vec<f32>| lifts.iter().map(|lift| lift + by).collect();
        Self {
            out: self.out.iter().map(widened).collect(),
            up: self.up.clone(),
        }
    }

    /// The same where nothing has gone up yet.
    #[must_use]
    pub fn lowered(mut self) -> Self {
        self.up.iter_mut().flatten().for_each(|rise| *rise = 0.0);
        self
    }

    /// Gives way towards where skin pushes, as fast as an elastic does in `dt` [s].
    pub fn approach(&mut self, wanted: &Self, dt: f32) {
        if self.out.len() != wanted.out.len() {
            self.clone_from(wanted);
            return;
        }
        for (now, wanted, fastest) in [
            (&mut self.out, &wanted.out, FASTEST),
            (&mut self.up, &wanted.up, FASTEST_UP),
        ] {
            let step = fastest * dt;
            for (now, wanted) in now.iter_mut().flatten().zip(wanted.iter().flatten()) {
                *now += (wanted - *now).clamp(-step, step);
            }
        }
    }
}

impl Elastic {
    fn new(ring: &Ring) -> Self {
        let points = ring.points();
        let sum: Vec3 = points.iter().map(|point| point.bind_position).sum();
        let axis = sum / points.len().max(1) as f32;
        let axis = Vec2::new(axis.x, axis.z);
        let way = |sector: usize| {
            let (sin, cos) = trig::sin_cos(sector as f32 / SECTORS as f32 * std::f32::consts::TAU);
            Vec2::new(cos, sin)
        };
        let farthest = |way: Vec2| {
            let along = |point: &TapePoint| {
                let arm = Vec2::new(point.bind_position.x, point.bind_position.z) - axis;
                arm.dot(way) / arm.length().max(f32::MIN_POSITIVE)
            };
            let nearest = points.iter().max_by(|a, b| along(a).total_cmp(&along(b)));
            nearest.map_or([Vec3::ZERO, Vec3::X], |point| {
                [point.bind_position, point.outward]
            })
        };
        let points: Vec<[Vec3; 2]> = (0..SECTORS).map(|sector| farthest(way(sector))).collect();
        let heights = || points.iter().map(|[at, _]| at.y);
        Self {
            axis,
            heights: [
                heights().fold(f32::INFINITY, f32::min),
                heights().fold(f32::NEG_INFINITY, f32::max),
            ],
            points,
        }
    }

    /// The sector before a place of the bind pose, and the share of the way to the next.
    fn place(&self, at: Vec3) -> (usize, f32) {
        let arm = Vec2::new(at.x, at.z) - self.axis;
        let turn = trig::atan2(arm.y, arm.x) / std::f32::consts::TAU;
        let place = (turn - turn.floor()) * SECTORS as f32;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and the number of sectors"
        )]
        let sector = place as usize;
        (sector % SECTORS, place - place.floor())
    }

    /// The sector whose middle is nearest.
    fn sector(&self, at: Vec3) -> usize {
        let (sector, share) = self.place(at);
        (sector + usize::from(0.5 <= share)) % SECTORS
    }
}

/// Spreads what pushes, up to `most`, over the directions around it, in one even shape.
fn spread(values: &mut [f32], most: f32) {
    let widest: Vec<f32> = (0..SECTORS)
        .map(|sector| around(values, sector).fold(0.0, f32::max).min(most))
        .collect();
    for (sector, value) in values.iter_mut().enumerate() {
        *value = around(&widest, sector).sum::<f32>() / (2 * SPREAD + 1) as f32;
    }
}

/// The values around one on a closed line, itself among them.
fn around(values: &[f32], at: usize) -> impl Iterator<Item = f32> {
    (0..=2 * SPREAD).map(move |step| values[(at + values.len() + step - SPREAD) % values.len()])
}

/// The bone of the trunk that stands for one that carries skin.
fn trunk_of(joint: u16) -> Bone {
    let bone = Bone::ALL[usize::from(joint)];
    if Bone::LEGS.iter().any(|leg| leg.contains(&bone)) {
        Bone::Hips
    } else {
        bone
    }
}

/// Whether a bone is of the trunk or the legs: arms and head are never below an elastic.
fn is_trunk_or_leg(bone: Bone) -> bool {
    let is_arm = (bone.lineage()).any(|it| matches!(it, Bone::LeftShoulder | Bone::RightShoulder));
    !is_arm && !matches!(bone, Bone::Neck | Bone::Head)
}

#[cfg(test)]
mod tests {
    use super::*;

    const RADIUS: f32 = 0.15;

    fn ring(height: f32) -> Ring {
        let points = (0_u16..720).map(|index| {
            let (sin, cos) = trig::sin_cos(f32::from(index) / 720.0 * std::f32::consts::TAU);
            let outward = Vec3::new(cos, 0.0, sin);
            TapePoint {
                bind_position: outward * RADIUS + Vec3::Y * height,
                outward,
                joints: [u16::try_from(Bone::LeftUpperLeg.index()).unwrap(); 4],
                weights: [0.25; 4],
            }
        });
        Ring::of(points.collect())
    }

    fn band(taut: f32) -> (Band, [Ring; 2]) {
        let rings = [ring(1.04), ring(1.0)];
        let bone = Band::carrier(&rings);
        (Band::new(&[&rings[0], &rings[1]], bone, taut), rings)
    }

    fn surfel(out: f32, turn: f32, height: f32) -> Surfel {
        let (sin, cos) = trig::sin_cos(turn);
        let normal = Vec3::new(cos, 0.0, sin);
        Surfel {
            position: normal * (RADIUS + out) + Vec3::Y * height,
            normal,
        }
    }

    fn carried(skin: &[Surfel]) -> impl Iterator<Item = (Surfel, Bone)> + '_ {
        skin.iter().map(|&surfel| (surfel, Bone::Hips))
    }

    #[test]
    fn an_elastic_gives_way_to_what_comes_out_below_it_and_the_next_one_follows() {
        let (band, rings) = band(1.02);
        assert_eq!(band.bone, Bone::Hips, "legs go with the hips");
        let still = vec![Affine3A::IDENTITY; Bone::ALL.len()];
        let turn = std::f32::consts::TAU / 6.0;
        let skin = [surfel(0.02, turn, 1.0), surfel(-0.01, 4.0, 1.04)];
        let lifts = band.lifts(&still, carried(&skin));
        let place = |elastic: usize, point: usize| {
            let at = &rings[elastic].points()[point];
            band.lift((elastic, at), &lifts)
        };
        // At the bump, a sixth of the way around, and across from it.
        let (bump, away) = (120, 480);
        assert!((place(1, bump) - 0.02).abs() < 1.0e-4, "{}", place(1, bump));
        assert!(place(1, away).abs() < 1.0e-6);
        let slope = (1.02_f32 * 1.02 - 1.0).sqrt();
        assert!((place(0, bump) - (0.02 - slope * 0.04)).abs() < 1.0e-4);
    }

    #[test]
    fn an_elastic_keeps_the_order_of_its_points_whatever_comes_out() {
        let (band, rings) = band(1.02);
        let still = vec![Affine3A::IDENTITY; Bone::ALL.len()];
        let mut chance = lole_geom::Chance::new(7);
        for _ in 0..40 {
            let skin: Vec<Surfel> = (0..200)
                .map(|_| {
                    let height = chance.between(0.98, 1.06);
                    surfel(chance.between(-0.1, 0.5), chance.between(0.0, 6.3), height)
                })
                .collect();
            let lifts = band.lifts(&still, carried(&skin));
            let points = rings[1].points();
            let posed: Vec<Vec3> = (points.iter())
                .map(|point| band.posed(&still, point, band.lift((1, point), &lifts)))
                .collect();
            for (at, place) in posed.iter().enumerate() {
                let next = posed[(at + 1) % posed.len()];
                assert!(place.cross(next).y < 0.0, "{at}: {place} {next}");
                let out = place.with_y(0.0).length() - RADIUS;
                assert!((-1.0e-5..FARTHEST + 1.0e-4).contains(&out), "{out}");
            }
        }
    }

    #[test]
    fn lifts_come_and_go_no_faster_than_elastic_does() {
        let of = |value: f32| Lifts {
            out: vec![vec![value; SECTORS]],
            up: vec![vec![value; SECTORS]],
        };
        let (mut lifts, wanted) = (of(0.0), of(0.02));
        lifts.approach(&wanted, 1.0 / 60.0);
        let first = [(lifts.out[0][0], FASTEST), (lifts.up[0][0], FASTEST_UP)];
        for (value, fastest) in first {
            assert!((value - fastest / 60.0).abs() < 1.0e-6);
        }
        for _ in 0..60 {
            lifts.approach(&wanted, 1.0 / 60.0);
        }
        assert_eq!(lifts, wanted);
        let mut first = Lifts::default();
        first.approach(&wanted, 1.0 / 60.0);
        assert_eq!(first, wanted, "she starts as she stands");
    }
}
