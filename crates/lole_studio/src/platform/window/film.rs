//! The film, by an encoder in C++, which a page has no room for.

use lole_export::video::{Mp4Writer, VideoSettings};
use lole_picture::Lamps;
use lole_picture::film::FilmCamera;
use lole_picture::studio::PhotoStudio;
use lole_render::{Backend, Renderer, Size};
use lole_stage::FRAMES_PER_SECOND;

use crate::making::dance::{dance, performance};
use crate::making::{Line, Unmade, Wish};

/// Pictures of the film per second.
const FILM_RATE: u32 = 30;
/// Size of the film.
const FILM_SIZE: Size = Size {
    width: 1280,
    height: 720,
};

/// The film as the bytes of an MP4.
pub(crate) fn film(wish: &Wish, line: &Line<'_>) -> Result<Vec<u8>, Unmade> {
    let mut performance = performance(wish)?;
    let photo = PhotoStudio::new(&performance).map_err(|error| Unmade::of(&error))?;
    let renderer = Renderer::new(Backend::Auto, FILM_SIZE);
    let mut renderer = renderer.map_err(|error| Unmade::of(&error))?;
    let size = [FILM_SIZE.width, FILM_SIZE.height];
    let film = Mp4Writer::new(size, FILM_RATE, VideoSettings::default());
    let mut film = film.map_err(|error| Unmade::of(&error))?;
    let mut camera = None;
    let every = FRAMES_PER_SECOND / FILM_RATE;
    dance(&mut performance, line, every, |performance| {
        let camera = camera.get_or_insert_with(|| FilmCamera::new(performance));
        let view = camera.view(performance, FILM_SIZE);
        let image = photo.shoot(performance, view, Lamps::Still, &mut renderer);
        let image = image.map_err(|error| Unmade::of(&error))?;
        let pushed = film.push_frame(&image.pixels);
        pushed.map_err(|error| Unmade::of(&error))
    })?;
    film.finish().map_err(|error| Unmade::of(&error))
}
