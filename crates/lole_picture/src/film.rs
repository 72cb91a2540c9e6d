//! Where the film's camera stands: as near as the whole dance allows.

use glam::{Affine3A, Vec3};
use lole_body::{Bone, Dancer};
use lole_geom::trig;
use lole_render::{Camera, Size, View};
use lole_stage::{Performance, Production};

/// The film's camera: it goes with the dancer softly, as someone does who knows the dance, and drifts from the front
/// to her side and back. It stands as near as it can without losing a hand, a foot or the hem through the whole
/// dance.
pub struct FilmCamera {
    /// How far her skirt swings from her hips [m].
    skirt: f32,
    /// The outermost places of her and her skirt, from where the camera looks [m].
    reach: Vec<Vec3>,
}

/// Free air beyond the crown and the fingers' roots [m].
const HEADROOM: f32 = 0.12;
/// Fingers beyond their roots [m].
const FINGERS: f32 = 0.16;
/// How much farther than while she stands a skirt may swing.
const SWING: f32 = 1.15;
/// The camera looks at the mean of where she is at so many moments before, so many after, and now, so far apart [s].
const AROUND_COUNT: u8 = 9;
const AROUND_SECONDS: f32 = 0.09;
/// Looks at the dance from one of them to the next.
const LOOKS: u8 = 3;
/// Largest drift to either side [rad].
const DRIFT: f32 = 0.6;
/// Time of one drift from side to side and back [s].
const DRIFT_PERIOD: f32 = 16.0;

/// The mean of places around a moment, the nearer the more, so that the camera neither lags nor jerks.
fn smoothed(places: impl Iterator<Item = Vec3>) -> Vec3 {
    let (mut sum, mut weights) = (Vec3::ZERO, 0.0);
    for (step, place) in steps().zip(places) {
        let share = step / (f32::from(AROUND_COUNT) + 1.0);
        let weight = 1.0 + trig::cos(std::f32::consts::PI * share);
        sum += place * weight;
        weights += weight;
    }
    sum / weights
}

/// The moments around one, counted from it.
fn steps() -> impl Iterator<Item = f32> {
    let count = i16::from(AROUND_COUNT);
    (-count..=count).map(f32::from)
}

impl FilmCamera {
    /// Knows the dance that is performed.
    #[must_use]
    pub fn new(performance: &Performance) -> Self {
        let production = performance.production();
        let hips = Figure::of(&production.dancer, performance.world_from_bind(), 0.0).hips;
        let skirt = skirt_radius(performance, hips);
        Self {
            skirt,
            reach: reach(production, skirt),
        }
    }

    /// The view at the performance's time.
    #[must_use]
    pub fn view(&self, performance: &Performance, size: Size) -> Camera {
        let (production, time) = (performance.production(), performance.time());
        let times = steps().map(|step| time + step * AROUND_SECONDS);
        let middle = smoothed(times.map(|it| Figure::at(production, it, self.skirt).middle()));
        let phase = std::f32::consts::TAU * time / DRIFT_PERIOD;
        let azimuth = DRIFT * trig::sin(phase);
        let around: Vec<Vec3> = self.reach.iter().map(|&away| middle + away).collect();
        Camera::framing_points(&around, View::Turned(azimuth), size.aspect())
    }
}

/// The outermost places of the lead-in and one round of the dance, from where the camera looks [m].
fn reach(production: &Production, skirt: f32) -> Vec<Vec3> {
    let dance = &production.dance;
    let length = dance.lead_in() + dance.period();
    let dt = AROUND_SECONDS / f32::from(LOOKS);
    let [every, half] = [LOOKS, LOOKS * AROUND_COUNT].map(usize::from);
    // What the camera looks at lies before and after, too.
    let around = AROUND_SECONDS * f32::from(AROUND_COUNT);
    let figures = (0_u16..)
        .map(|look| dt * f32::from(look) - around)
        .take_while(|&time| time <= length + around)
        .map(|time| Figure::at(production, time, skirt));
    let figures: Vec<Figure> = figures.collect();
    let mut reach: Vec<(Vec3, Vec3)> = directions().map(|it| (it, Vec3::ZERO)).collect();
    for moments in figures.windows(2 * half + 1) {
        let middle = smoothed(moments.iter().step_by(every).map(Figure::middle));
        for (direction, farthest) in &mut reach {
            let away = moments[half].farthest(*direction) - middle;
            if farthest.dot(*direction) < away.dot(*direction) {
                *farthest = away;
            }
        }
    }
    // The floor that she stands on is seen, wherever her feet are.
    let floor = reach.iter().map(|(_, it)| Vec3::new(0.0, 0.0, it.z));
    let floor: Vec<Vec3> = floor.collect();
    reach.into_iter().map(|(_, it)| it).chain(floor).collect()
}

/// Directions all around, 15° apart along the horizon.
fn directions() -> impl Iterator<Item = Vec3> {
    (-3_i8..=3).flat_map(|up| {
        let (sin_up, cos_up) = trig::sin_cos(f32::from(up) * std::f32::consts::FRAC_PI_6);
        (0_u8..24).map(move |turn| {
            let (sin, cos) = trig::sin_cos(f32::from(turn) * std::f32::consts::PI / 12.0);
            Vec3::new(cos_up * sin, sin_up, cos_up * cos)
        })
    })
}

/// Ends of a dancer that must be seen, beside head and skirt.
const ENDS: [Bone; 6] = [
    Bone::LeftMiddleProximal,
    Bone::RightMiddleProximal,
    Bone::LeftLowerArm,
    Bone::RightLowerArm,
    Bone::LeftFoot,
    Bone::RightFoot,
];

/// Where a dancer is in one moment.
struct Figure {
    hips: Vec3,
    /// Her ends, and her head.
    ends: [Vec3; 7],
    /// Of her skirt around her hips [m].
    skirt: f32,
}

impl Figure {
    /// At a time of the dance [s].
    fn at(production: &Production, time: f32, skirt: f32) -> Self {
        let dancer = &production.dancer;
        let pose = production.dance.pose_at(time);
        Self::of(dancer, &dancer.skeleton.world_from_bind(&pose), skirt)
    }

    fn of(dancer: &Dancer, world_from_bind: &[Affine3A], skirt: f32) -> Self {
        let skeleton = &dancer.skeleton;
        let at = |bone: Bone| world_from_bind[bone.index()].transform_point3(skeleton.joint(bone));
        let crown = dancer.landmarks.crown_height - skeleton.joint(Bone::Head).y;
        let head = at(Bone::Head) + Vec3::Y * (crown - 0.7 * HEADROOM);
        let [a, b, c, d, e, f] = ENDS.map(at);
        let ends = [a, b, c, d, e, f, head];
        Self {
            hips: at(Bone::Hips),
            ends,
            skirt,
        }
    }

    /// Where a camera in front of her looks [m].
    fn middle(&self) -> Vec3 {
        let sides = self.ends.iter().map(|end| end.x);
        let sides = sides.chain([self.hips.x - self.skirt, self.hips.x + self.skirt]);
        let (low, high) = sides.fold((f32::MAX, f32::MIN), |(low, high), x| {
            (low.min(x), high.max(x))
        });
        Vec3::new(0.5 * (low + high), 0.0, self.hips.z)
    }

    /// The place of her that is farthest in a direction [m].
    fn farthest(&self, direction: Vec3) -> Vec3 {
        let level = Vec3::new(direction.x, 0.0, direction.z).normalize_or_zero();
        // Fingers are longer than the air above a head is high.
        let air = HEADROOM + (FINGERS - HEADROOM) * level.length();
        let ends = self.ends.iter().map(|end| end + direction * air);
        // A skirt hangs between the hips and the floor.
        let side = self.hips + level * self.skirt;
        let hem = Vec3::new(side.x, 0.0, side.z);
        let places = ends.chain([side, hem]);
        let by_direction =
            |one: &Vec3, other: &Vec3| one.dot(direction).total_cmp(&other.dot(direction));
        places.max_by(by_direction).unwrap_or(self.hips)
    }
}

/// How far what she wears hangs from her hips' joint, and swings [m].
fn skirt_radius(performance: &Performance, hips: Vec3) -> f32 {
    let away = |place: &Vec3| Vec3::new(place.x - hips.x, 0.0, place.z - hips.z).length();
    SWING
        * performance
            .cloth_positions()
            .iter()
            .map(away)
            .fold(0.0, f32::max)
}
