//! Film and 3D file: the dance of the design once more from its beginning, at its own pace, so that what
//! is written does not depend on how fast this machine shows it.

use lole_export::video::{Mp4Writer, VideoSettings};
use lole_picture::baked::{self, Keys};
use lole_picture::studio::{FilmCamera, PhotoStudio};
use lole_render::{Backend, LightRig, Renderer, Size};
use lole_stage::{FRAME_SECONDS, FRAMES_PER_SECOND, Performance, Production};

use super::paper::said;
use super::{Line, Unmade, Wish, flew_apart};

/// Pictures of the film per second.
const FILM_RATE: u32 = 30;
/// Keys of the 3D file per second.
const KEY_RATE: u32 = 15;
/// Size of the film.
const FILM_SIZE: Size = Size {
    width: 1280,
    height: 720,
};

/// The film as the bytes of an MP4.
pub(super) fn film(wish: &Wish, line: &Line<'_>) -> Result<Vec<u8>, Unmade> {
    let mut performance = performance(wish)?;
    let photo = PhotoStudio::new(&performance).map_err(|error| Unmade::of(&error))?;
    let renderer = Renderer::new(Backend::Auto, FILM_SIZE);
    let mut renderer = renderer.map_err(|error| Unmade::of(&error))?;
    let size = [FILM_SIZE.width, FILM_SIZE.height];
    let film = Mp4Writer::new(size, FILM_RATE, VideoSettings::default());
    let mut film = film.map_err(|error| Unmade::of(&error))?;
    let mut camera = None;
    let every = FRAMES_PER_SECOND / FILM_RATE;
    let dt = FRAME_SECONDS * every as f32;
    dance(&mut performance, line, every, |performance| {
        let camera = camera.get_or_insert_with(|| FilmCamera::new(performance));
        let view = camera.advance(performance, dt, FILM_SIZE);
        let image = photo.shoot(performance, view, LightRig::default(), &mut renderer);
        let image = image.map_err(|error| Unmade::of(&error))?;
        let pushed = film.push_frame(&image.pixels);
        pushed.map_err(|error| Unmade::of(&error))
    })?;
    film.finish().map_err(|error| Unmade::of(&error))
}

/// The dancer with her dance as the bytes of a GLB.
pub(super) fn model(wish: &Wish, line: &Line<'_>) -> Result<Vec<u8>, Unmade> {
    let mut performance = performance(wish)?;
    let photo = PhotoStudio::new(&performance).map_err(|error| Unmade::of(&error))?;
    let mut keys = Keys::default();
    let every = FRAMES_PER_SECOND / KEY_RATE;
    dance(&mut performance, line, every, |performance| {
        keys.keep(performance);
        Ok(())
    })?;
    let bytes = baked::dancer_glb(&performance, &keys, photo.covers());
    bytes.map_err(|error| Unmade::of(&error))
}

fn performance(wish: &Wish) -> Result<Performance, Unmade> {
    let production = Production::new(&wish.design).map_err(|error| said(&error))?;
    Performance::new(production).map_err(|error| said(&error))
}

/// Lets the cloth come to rest and dances the whole dance; `look` is called before every so manyth
/// frame, with her body posed.
fn dance(
    performance: &mut Performance,
    line: &Line<'_>,
    every: u32,
    mut look: impl FnMut(&Performance) -> Result<(), Unmade>,
) -> Result<(), Unmade> {
    // Half of the processor: the window dances on.
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads((cores / 2).max(1))
        .build()
        .map_err(|error| Unmade::of(&error))?;
    let design = &performance.production().design;
    let whole = (performance.production().dance).whole(design.motion.repeat);
    let danced = frame_count(design.duration_s(whole));
    let settled = Performance::settle_frame_count();
    let all = (settled + danced).max(1) as f32;
    for frame in 0..settled + danced {
        line.goes_on(frame as f32 / all)?;
        if settled <= frame && (frame - settled).is_multiple_of(every) {
            performance.pose_body();
            look(performance)?;
        }
        pool.install(|| performance.advance())
            .map_err(|found| Unmade::Failed(flew_apart(Some(found.time))))?;
    }
    performance.pose_body();
    Ok(())
}

/// Frames of a dance of `seconds`.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a document allows minutes, not years"
)]
fn frame_count(seconds: f64) -> u32 {
    (seconds * f64::from(FRAMES_PER_SECOND)).round() as u32
}
