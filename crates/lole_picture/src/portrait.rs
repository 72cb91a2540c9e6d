//! Pictures of dancers who stand in their costume, for paper: at rest, all of a group at one scale.

use glam::Vec3;
use lole_avatar::License;
use lole_body::Dancer;
use lole_costume::document::Design;
use lole_export::ImageView;
use lole_export::pdf::EncodedPicture;
use lole_export::still::encode_jpeg;
use lole_garment::dress::Division;
use lole_render::{Backend, Bounds, Camera, Renderer, Size, View};
use lole_stage::{Performance, Production};

use lole_export::booklet::Worn;

use crate::studio::{STILLS, still_cameras};
use crate::{Lamps, LookError, Looks, Moment, Scenery};

/// Size of one picture of a group [pixel]: as wide as her arms and skirt need, as tall as the tallest.
pub const STANDING: Size = Size {
    width: 478,
    height: 520,
};
/// What it shows to either side, and from the floor up [m]: outstretched arms of a tall dancer.
const STANDING_REACH: [f32; 2] = [0.92, 2.0];

/// Size of the pictures of a booklet [pixel], upright.
const COVER: Size = Size {
    width: 900,
    height: 1200,
};

/// Particles of cloth that hangs still in a small picture, around and down: more would not be seen.
const COARSE: [u32; 2] = [160, 24];
/// In how many steps of a frame they are moved by the real-time method.
const COARSE_SUBSTEPS: u32 = 8;

/// Frames in which cloth of a small picture comes to hang: what still sways after them would not be
/// seen.
const HANGING_FRAMES: u32 = 48;

/// Quality of the picture as JPEG.
const QUALITY: u8 = 90;

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum PortraitError {
    /// It was called off.
    #[error("called off")]
    CalledOff,
    /// The costume cannot be put on.
    #[error(transparent)]
    Stage(#[from] lole_stage::StageError),
    /// The cloth flew apart.
    #[error("the cloth diverged")]
    Diverged,
    /// Its cloth cannot be painted.
    #[error(transparent)]
    Look(#[from] LookError),
    /// It cannot be drawn.
    #[error(transparent)]
    Render(#[from] lole_render::RenderError),
    /// It cannot be encoded.
    #[error(transparent)]
    Export(#[from] lole_export::ExportError),
}

/// One dancer of a group in her costume, as the bytes of a JPEG of [`STANDING`]; `is_stopped` is asked
/// before every frame of the cloth.
///
/// # Errors
/// A costume that cannot be put on, or that it was called off.
pub fn standing(design: &Design, is_stopped: &dyn Fn() -> bool) -> Result<Vec<u8>, PortraitError> {
    standing_on(design, lole_stage::dancer(design)?, is_stopped)
}

/// The same of the design's [`lole_stage::dancer`], whom the caller has built to cut for her.
///
/// # Errors
/// As [`standing`].
pub fn standing_on(
    design: &Design,
    dancer: (Dancer, Option<License>),
    is_stopped: &dyn Fn() -> bool,
) -> Result<Vec<u8>, PortraitError> {
    let mut coarse = design.clone();
    coarse.skirt.column_count = coarse.skirt.column_count.min(COARSE[0]);
    coarse.skirt.row_count = coarse.skirt.row_count.min(COARSE[1]);
    let method = &mut coarse.method;
    if method.name.integrator().is_none() {
        method.substep_count = method.substep_count.or(Some(COARSE_SUBSTEPS));
    }
    let production = Production::divided_on(&coarse, dancer, Division::Half)?;
    let performance = stand(production, HANGING_FRAMES, is_stopped)?;
    // In a picture of five centimeters nobody sees a corner.
    let looks = paper_looks(&performance, Looks::from_afar)?;
    let moment = Moment::still(&performance);
    let image = shoot((&looks, &moment), standing_camera(STANDING), STANDING)?;
    let image = ImageView::new(image.width, image.height, &image.pixels)?;
    Ok(encode_jpeg(image, QUALITY)?)
}

/// The picture of such bytes for a page; `None` where they are no such picture.
#[must_use]
pub fn of_jpeg(bytes: Vec<u8>) -> Option<EncodedPicture> {
    EncodedPicture::of_jpeg(bytes, [STANDING.width, STANDING.height])
}

/// Puts the costume on and lets it come to rest, for so many frames at most; her body is posed.
///
/// # Errors
/// Cloth that flies apart, or that it was called off.
pub fn stand(
    production: Production,
    most_frames: u32,
    is_stopped: &dyn Fn() -> bool,
) -> Result<Performance, PortraitError> {
    let mut performance = Performance::new(production)?;
    let mut frames = 0;
    while performance.time() < 0.0 && frames < most_frames {
        frames += 1;
        if is_stopped() {
            return Err(PortraitError::CalledOff);
        }
        performance.advance().map_err(|_| PortraitError::Diverged)?;
    }
    performance.pose_body();
    Ok(performance)
}

/// Her pictures for a booklet, as she stands: the first of the stills large, then front and back.
///
/// # Errors
/// A print or a size that cannot be drawn.
pub fn of_booklet(performance: &Performance) -> Result<Worn, PortraitError> {
    let cameras = still_cameras(performance, COVER);
    let looks = paper_looks(performance, Looks::photographed)?;
    let moment = Moment::photographed(performance, &looks);
    let view = |wanted: View| {
        let place = STILLS.iter().position(|still| still.view == wanted);
        let camera = place.and_then(|place| cameras.get(place).copied());
        let camera = camera.unwrap_or_else(|| standing_camera(COVER));
        let image = shoot((&looks, &moment), camera, COVER)?;
        let image = ImageView::new(image.width, image.height, &image.pixels)?;
        Ok::<EncodedPicture, PortraitError>(EncodedPicture::photo(image)?)
    };
    Ok(Worn {
        cover: view(View::ThreeQuarter)?,
        front_and_back: Some([view(View::Front)?, view(View::Back)?]),
    })
}

/// The camera of a group's pictures.
#[must_use]
pub fn standing_camera(size: Size) -> Camera {
    let [side, top] = STANDING_REACH;
    let bounds = Bounds {
        min: Vec3::new(-side, 0.0, -0.2),
        max: Vec3::new(side, top, 0.2),
    };
    Camera::framing(bounds, View::Front, size.aspect())
}

/// How she and what she wears look on paper, where nothing is behind her.
///
/// # Errors
/// A print that cannot be drawn.
fn paper_looks(
    performance: &Performance,
    looks: impl Fn(&Design, &Production) -> Result<Looks, LookError>,
) -> Result<Looks, LookError> {
    let production = performance.production();
    Ok(Looks {
        scenery: Scenery::default(),
        ..looks(&production.design, production)?
    })
}

/// Her picture by the processor, whatever adapter there is: alike on every machine.
///
/// # Errors
/// A size that cannot be drawn.
fn shoot(
    (looks, moment): (&Looks, &Moment),
    camera: Camera,
    size: Size,
) -> Result<lole_render::Image, PortraitError> {
    let scene = looks.scene(&moment.dancer(), camera, Lamps::WithCamera);
    let mut renderer = Renderer::new(Backend::Cpu, size)?;
    Ok(renderer.render(&scene)?)
}
