//! Pictures of a dance, and the viewpoints of its stills.

use glam::Vec3;
use lole_render::{Camera, Image, RenderError, Renderer, Size, View};
use lole_stage::Performance;

use crate::film::cues::{Cues, lit};
use crate::film::shutter::Shutter;
use crate::film::title;
use crate::{Cover, Lamps, LookError, Looks, Moment};

/// Everything that pictures of one production share.
pub struct PhotoStudio {
    looks: Looks,
    shutter: Shutter,
    cues: Cues,
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
            looks: Looks::photographed(&production.design, production)?,
            shutter: Shutter::new(production.design.stage.motion_blur),
            cues: Cues::of(production),
        })
    }

    /// How she and all that she wears look.
    pub(crate) const fn looks(&self) -> &Looks {
        &self.looks
    }

    /// How everything that is worn looks, surface by surface.
    #[must_use]
    pub fn covers(&self) -> &[Cover] {
        &self.looks.worn
    }

    /// A still of the performance's current frame; its body must be posed.
    ///
    /// # Errors
    /// A size that cannot be drawn, or an adapter that fails.
    pub fn photograph(
        &self,
        performance: &Performance,
        camera: Camera,
        renderer: &mut Renderer,
    ) -> Result<Image, RenderError> {
        let moment = Moment::photographed(performance, &self.looks);
        let scene = (self.looks).scene(&moment.dancer(), camera, Lamps::WithCamera);
        renderer.render(&scene)
    }

    /// What the film's shutter sees between two pictures: to be called in every frame of the dance that has none.
    pub fn pass(&mut self, performance: &mut Performance) {
        if self.shutter.smears() {
            performance.pose_body();
            let moment = Moment::of(performance);
            self.shutter.keep(performance.time(), vec![moment]);
        }
    }

    /// The film's picture of the performance's current frame; its body must be posed. The lamps of a film stand
    /// still while the camera moves.
    ///
    /// # Errors
    /// A size that cannot be drawn, or an adapter that fails.
    pub fn film(
        &mut self,
        performance: &Performance,
        camera: Camera,
        renderer: &mut Renderer,
    ) -> Result<Image, RenderError> {
        let moment = Moment::of(performance);
        self.shutter.keep(performance.time(), vec![moment]);
        let size = renderer.size();
        let mut image = lit((&self.cues, performance.time()), size, |scenery| {
            self.shutter.expose((&camera, size), |moments, room| {
                let dancers = moments.iter().map(|moment| (&self.looks, moment.dancer()));
                let dancers: Vec<_> = dancers.collect();
                let stage = (scenery, Lamps::Still);
                renderer.render_lit(&Looks::stage(&dancers, stage, camera), room)
            })
        })?;
        let stage = &performance.production().design.stage;
        title::write(&mut image, &stage.title, performance.time())?;
        Ok(image)
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
