//! Where the film's camera stands: as near as the whole dance allows.

pub(crate) mod cues;
mod reach;
mod shots;
pub(crate) mod shutter;
pub mod title;

use glam::{Affine3A, Vec3};
use lole_body::{Bone, Dancer};
use lole_geom::trig;
use lole_render::{Camera, Size, View};
use lole_stage::{FRAMES_PER_SECOND, Performance, Production};
use reach::Reach;
pub use shots::Framing;
use shots::Shots;

/// The film's camera: it goes with the dancer softly, as someone does who knows the dance, and drifts from the front
/// to her side and back. It stands as near as it can without losing a hand, a foot or the hem through the whole
/// dance. Of a group it sees everybody; where formations change, it goes away and comes near again with them.
pub struct FilmCamera {
    /// How far the skirt of each dancer swings from her hips [m].
    skirts: Vec<f32>,
    /// The outermost places of her and her skirt, from where the camera looks [m].
    reach: Reach,
    /// Height of the hips of the first [m].
    hips: f32,
    /// From where which phrase is seen.
    shots: Shots,
}

/// A dancer, and where she stands.
#[derive(Clone, Copy)]
pub struct Placed<'a> {
    /// Her dance, as if she were alone.
    pub performance: &'a Performance,
    /// Where she stands instead of in the middle of the stage [m].
    pub at: Vec3,
}

/// Pictures of a film per second.
pub const FILM_RATE: u32 = 30;
/// Simulated frames from one picture to the next.
pub const FRAMES_PER_PICTURE: u32 = FRAMES_PER_SECOND / FILM_RATE;
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
/// A shot from the hips up ends so far below them [m].
const BELOW_HIPS: f32 = 0.25;

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
        Self::of_group(&[alone(performance)])
    }

    /// Knows the dance of a group.
    #[must_use]
    pub fn of_group(group: &[Placed<'_>]) -> Self {
        let skirts: Vec<f32> = group
            .iter()
            .map(|it| skirt_radius(it.performance))
            .collect();
        Self {
            reach: Reach::of(group, &skirts),
            hips: group.first().map_or(0.0, |it| {
                let dancer = &it.performance.production().dancer;
                dancer.skeleton.joint(Bone::Hips).y
            }),
            shots: shots(group),
            skirts,
        }
    }

    /// The view at the performance's time.
    #[must_use]
    pub fn view(&self, performance: &Performance, size: Size) -> Camera {
        self.group_view(&[alone(performance)], size)
    }

    /// The view at the time of the group for which it was made.
    #[must_use]
    pub fn group_view(&self, group: &[Placed<'_>], size: Size) -> Camera {
        let time = group.first().map_or(0.0, |it| it.performance.time());
        let times = steps().map(|step| time + step * AROUND_SECONDS);
        let middle = smoothed(times.map(|it| Figures::at(group, it, &self.skirts).middle()));
        let (azimuth, framing) = self.shots.at(time);
        let lowest = match framing {
            Framing::Whole => f32::MIN,
            Framing::Upper => self.hips - BELOW_HIPS,
        };
        let around = self.reach.at(time).into_iter().map(|away| middle + away);
        let around: Vec<Vec3> = around
            .map(|place| place.with_y(place.y.max(lowest)))
            .collect();
        Camera::framing_points(&around, View::Turned(azimuth), size.aspect())
    }
}

/// When the film of a dance is cut to another shot [s], and what each shot shows: one more than cuts.
#[must_use]
pub fn cuts(performance: &Performance) -> (Vec<f32>, Vec<Framing>) {
    let shots = shots(&[alone(performance)]);
    let begins = std::iter::once(0.0).chain(shots.cuts().iter().copied());
    let framings = begins.map(|time| shots.at(time).1).collect();
    (shots.cuts().to_vec(), framings)
}

fn shots(group: &[Placed<'_>]) -> Shots {
    let first = group.first().map(|it| it.performance.production());
    first.map_or_else(Shots::default, |first| Shots::new(first, group.len()))
}

/// One dancer in the middle of the stage.
const fn alone(performance: &Performance) -> Placed<'_> {
    Placed {
        performance,
        at: Vec3::ZERO,
    }
}

/// From one dancer of a row to the next, so that no hand reaches a neighbor in any moment of the dance that all
/// share [m].
#[must_use]
pub fn room(performances: &[&Performance]) -> f32 {
    let group: Vec<Placed<'_>> = performances.iter().map(|it| alone(it)).collect();
    let skirts: Vec<f32> = performances.iter().map(|it| skirt_radius(it)).collect();
    let breadth = moments(&group, &skirts, 0.0).map(|figures| {
        let [right, left] = [Vec3::X, Vec3::NEG_X].map(|side| figures.farthest(side).dot(side));
        right + left
    });
    breadth.fold(0.0, f32::max)
}

/// Looks at the lead-in and one round of the dance, and so long before and after [s].
fn moments<'a>(
    group: &'a [Placed<'a>],
    skirts: &'a [f32],
    around: f32,
) -> impl Iterator<Item = Figures> + 'a {
    let dances = group.iter().map(|it| &it.performance.production().dance);
    let length = dances
        .map(|dance| dance.lead_in() + dance.period())
        .fold(0.0, f32::max);
    let dt = AROUND_SECONDS / f32::from(LOOKS);
    (0_u16..)
        .map(move |look| dt * f32::from(look) - around)
        .take_while(move |&time| time <= length + around)
        .map(move |time| Figures::at(group, time, skirts))
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

/// Where everybody is in one moment.
struct Figures(Vec<Figure>);

impl Figures {
    /// At a time of the dance [s].
    fn at(group: &[Placed<'_>], time: f32, skirts: &[f32]) -> Self {
        let figures = group.iter().zip(skirts).map(|(dancer, &skirt)| {
            let production = dancer.performance.production();
            Figure::at(production, time, skirt).moved(dancer.at)
        });
        Self(figures.collect())
    }

    /// Where a camera in front of them looks [m].
    fn middle(&self) -> Vec3 {
        let (mut low, mut high, mut depth) = (f32::MAX, f32::MIN, 0.0);
        for figure in &self.0 {
            let [left, right] = figure.sides();
            (low, high) = (low.min(left), high.max(right));
            depth += figure.hips.z / self.0.len() as f32;
        }
        Vec3::new(0.5 * (low + high), 0.0, depth)
    }

    /// The place of them that is farthest in a direction [m].
    fn farthest(&self, direction: Vec3) -> Vec3 {
        let places = self.0.iter().map(|figure| figure.farthest(direction));
        let by_direction =
            |one: &Vec3, other: &Vec3| one.dot(direction).total_cmp(&other.dot(direction));
        places.max_by(by_direction).unwrap_or(Vec3::ZERO)
    }
}

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

    /// As much elsewhere [m].
    fn moved(self, by: Vec3) -> Self {
        Self {
            hips: self.hips + by,
            ends: self.ends.map(|end| end + by),
            skirt: self.skirt,
        }
    }

    /// How far she reaches to her right and to her left [m].
    fn sides(&self) -> [f32; 2] {
        let sides = self.ends.iter().map(|end| end.x);
        let sides = sides.chain([self.hips.x - self.skirt, self.hips.x + self.skirt]);
        let (low, high) = sides.fold((f32::MAX, f32::MIN), |(low, high), x| {
            (low.min(x), high.max(x))
        });
        [low, high]
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
fn skirt_radius(performance: &Performance) -> f32 {
    let production = performance.production();
    let hips = Figure::of(&production.dancer, performance.world_from_bind(), 0.0).hips;
    let away = |place: &Vec3| Vec3::new(place.x - hips.x, 0.0, place.z - hips.z).length();
    SWING
        * performance
            .cloth_positions()
            .iter()
            .map(away)
            .fold(0.0, f32::max)
}
