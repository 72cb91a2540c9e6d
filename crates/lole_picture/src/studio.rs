//! Viewpoints of a dance, and pictures from them: the stills, and the film's camera.

use glam::Vec3;
use lole_body::Bone;
use lole_geom::trig;
use lole_render::{Bounds, Camera, Image, RenderError, Renderer, Size, View};
use lole_stage::Performance;

use crate::{Cover, Lamps, LookError, Looks, Moment};

/// Everything that pictures of one production share.
pub struct PhotoStudio {
    looks: Looks,
}

/// One named still.
pub struct StillView {
    /// Name of its file.
    pub file: &'static str,
    /// What stands below it, in English.
    pub caption_en: &'static str,
    /// What stands below it, in Japanese.
    pub caption_ja: &'static str,
    /// From where it is seen.
    pub view: View,
}

/// The stills of every run, the poster first.
pub const STILLS: [StillView; 4] = [
    StillView {
        file: "three-quarter.png",
        caption_en: "Three-quarter",
        caption_ja: "斜め前",
        view: View::ThreeQuarter,
    },
    StillView {
        file: "front.png",
        caption_en: "Front",
        caption_ja: "正面",
        view: View::Front,
    },
    StillView {
        file: "side.png",
        caption_en: "Side",
        caption_ja: "横",
        view: View::Side,
    },
    StillView {
        file: "back.png",
        caption_en: "Back",
        caption_ja: "後ろ",
        view: View::Back,
    },
];

impl PhotoStudio {
    /// Draws print and face once.
    ///
    /// # Errors
    /// A picture that was not read or cannot be a texture.
    pub fn new(performance: &Performance) -> Result<Self, LookError> {
        let production = performance.production();
        Ok(Self {
            looks: Looks::new(&production.design, production)?,
        })
    }

    /// How everything that is worn looks, surface by surface.
    #[must_use]
    pub fn covers(&self) -> &[Cover] {
        &self.looks.worn
    }

    /// The picture of the performance's current frame; its body must be posed.
    ///
    /// # Errors
    /// A size that cannot be drawn, or an adapter that fails.
    pub fn shoot(
        &self,
        performance: &Performance,
        camera: Camera,
        lamps: Lamps,
        renderer: &mut Renderer,
    ) -> Result<Image, RenderError> {
        let moment = Moment::of(performance);
        let scene = self.looks.scene(&moment.dancer(), camera, lamps);
        renderer.render(&scene)
    }
}

/// The cameras of the stills, in their order: the whole dancer with what she wears, in all at the same
/// scale, so that lengths can be compared from picture to picture.
#[must_use]
pub fn still_cameras(performance: &Performance, size: Size) -> Vec<Camera> {
    let mut points = performance.body_positions().to_vec();
    points.extend(performance.cloth_positions());
    cameras_around(&points, size)
}

/// A camera for each still that has all the points in view, all at the same distance.
#[must_use]
pub fn cameras_around(points: &[Vec3], size: Size) -> Vec<Camera> {
    let cameras: Vec<Camera> = STILLS
        .iter()
        .map(|still| Camera::framing_points(points, still.view, size.aspect()))
        .collect();
    let farthest = cameras.iter().map(Camera::distance).fold(0.0, f32::max);
    cameras
        .into_iter()
        .map(|camera| camera.at_distance(farthest))
        .collect()
}

/// The film's camera: it follows the hips softly, as a hand would, and drifts from the front to
/// the dancer's side and back.
pub struct FilmCamera {
    center: Vec3,
    velocity: Vec3,
    /// What the dance reaches up to [m].
    top: f32,
}

/// Free air above the crown or the highest finger's root [m].
const HEADROOM: f32 = 0.12;
/// Moments of a dance at which its reach is looked at.
const REACH_MOMENTS: u16 = 48;

/// How quickly the camera follows [1/s]: it lags by half a second.
const FOLLOW_RATE: f32 = 2.0;
/// Largest drift to either side [rad].
const DRIFT: f32 = 0.6;
/// Time of one drift from side to side and back [s].
const DRIFT_PERIOD: f32 = 16.0;

impl FilmCamera {
    /// Looks at the hips where they are.
    #[must_use]
    pub fn new(performance: &Performance) -> Self {
        Self {
            center: hips(performance),
            velocity: Vec3::ZERO,
            top: top_of_dance(performance),
        }
    }

    /// Moves on by `dt` [s] and gives the view at the performance's time (critically damped).
    pub fn advance(&mut self, performance: &Performance, dt: f32, size: Size) -> Camera {
        let pull = (hips(performance) - self.center) * FOLLOW_RATE * FOLLOW_RATE;
        self.velocity += (pull - self.velocity * (2.0 * FOLLOW_RATE)) * dt;
        self.center += self.velocity * dt;
        let stature = performance.production().dancer.landmarks.crown_height;
        let reach = 0.56 * stature;
        let middle = Vec3::new(self.center.x, 0.0, self.center.z);
        let bounds = Bounds {
            min: middle + Vec3::new(-reach, 0.0, -0.20),
            max: middle + Vec3::new(reach, self.top, 0.20),
        };
        let phase = std::f32::consts::TAU * performance.time() / DRIFT_PERIOD;
        Camera::framing(
            bounds,
            View::Turned(DRIFT * trig::sin(phase)),
            size.aspect(),
        )
    }
}

/// Highest joint of head and hands over one round of the dance, with headroom [m].
fn top_of_dance(performance: &Performance) -> f32 {
    let production = performance.production();
    let (skeleton, dance) = (&production.dancer.skeleton, &production.dance);
    let crown = production.dancer.landmarks.crown_height - skeleton.joint(Bone::Head).y;
    let length = dance.lead_in() + dance.period();
    let highest = (0..REACH_MOMENTS)
        .flat_map(|moment| {
            let time = length * f32::from(moment) / f32::from(REACH_MOMENTS);
            let world = skeleton.world_from_bind(&dance.pose_at(time));
            [
                (Bone::Head, crown - 0.7 * HEADROOM),
                (Bone::LeftMiddleProximal, 0.0),
                (Bone::RightMiddleProximal, 0.0),
            ]
            .map(|(bone, above)| {
                world[bone.index()].transform_point3(skeleton.joint(bone)).y + above
            })
        })
        .fold(0.0, f32::max);
    highest + HEADROOM
}

fn hips(performance: &Performance) -> Vec3 {
    let joint = performance.production().dancer.skeleton.joint(Bone::Hips);
    performance.world_from_bind()[Bone::Hips.index()].transform_point3(joint)
}
