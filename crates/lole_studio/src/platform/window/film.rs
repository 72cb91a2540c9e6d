//! The film, by an encoder in C++, which a page has no room for.

use lole_export::video::{Mp4Writer, VideoSettings};
use lole_language::Sentence;
use lole_picture::film::{FILM_RATE, FRAMES_PER_PICTURE, FilmCamera};
use lole_picture::group::{Ensemble, MOST_DANCERS, Member, MemberError};
use lole_picture::studio::PhotoStudio;
use lole_render::{Backend, Renderer, Size};

use crate::making::dance::{dance, danced, performance};
use crate::making::paper::said;
use crate::making::{Line, Unmade, Wish, flew_apart};

/// Size of the film.
const FILM_SIZE: Size = Size {
    width: 1280,
    height: 720,
};

/// The film as the bytes of an MP4.
pub(crate) fn film(wish: &Wish, line: &Line<'_>) -> Result<Vec<u8>, Unmade> {
    let mut performance = performance(wish)?;
    let mut photo = PhotoStudio::new(&performance).map_err(|error| Unmade::of(&error))?;
    let renderer = Renderer::new(Backend::Auto, FILM_SIZE);
    let mut renderer = renderer.map_err(|error| Unmade::of(&error))?;
    let size = [FILM_SIZE.width, FILM_SIZE.height];
    let film = Mp4Writer::new(size, FILM_RATE, VideoSettings::default());
    let mut film = film.map_err(|error| Unmade::of(&error))?;
    let mut camera = None;
    dance(&mut performance, line, |performance, frame| {
        if !frame.is_multiple_of(FRAMES_PER_PICTURE) {
            photo.pass(performance);
            return Ok(());
        }
        performance.pose_body();
        let camera = camera.get_or_insert_with(|| FilmCamera::new(performance));
        let view = camera.view(performance, FILM_SIZE);
        let image = photo.film(performance, view, &mut renderer);
        let image = image.map_err(|error| Unmade::of(&error))?;
        let pushed = film.push_frame(&image.pixels);
        pushed.map_err(|error| Unmade::of(&error))
    })?;
    film.finish().map_err(|error| Unmade::of(&error))
}

/// The film of everybody of a list, each in her own measures.
pub(crate) fn group_film(wish: &Wish, line: &Line<'_>) -> Result<Vec<u8>, Unmade> {
    // Half of the processor: the window dances on.
    let pool = super::pool((super::cores() / 2).max(1));
    let (list, formation) = wish.group.as_ref().ok_or_else(|| nobody(0))?;
    let count = list.dancers.len();
    if count == 0 || MOST_DANCERS < count {
        return Err(nobody(count));
    }
    // Dressing takes as long as so much of the dance.
    let all = |share: f32| DRESSING + (1.0 - DRESSING) * share;
    let mut members = Vec::new();
    for (done, dancer) in list.dancers.iter().enumerate() {
        line.goes_on(DRESSING * done as f32 / count as f32)?;
        let design = dancer.design(&wish.design);
        let member = Member::new(&dancer.name, &design);
        members.push(member.map_err(|error| refused(&dancer.name, &error))?);
    }
    let group = Ensemble::new(members, *formation, None);
    let mut group = group.map_err(|why| {
        let (name, error) = *why;
        refused(&name, &MemberError::Stage(error))
    })?;
    let renderer = Renderer::new(Backend::Auto, FILM_SIZE);
    let mut renderer = renderer.map_err(|error| Unmade::of(&error))?;
    let size = [FILM_SIZE.width, FILM_SIZE.height];
    let film = Mp4Writer::new(size, FILM_RATE, VideoSettings::default());
    let mut film = film.map_err(|error| Unmade::of(&error))?;
    let advance = |group: &mut Ensemble| {
        let moved = within(pool.as_ref(), || group.advance());
        moved.map_err(|(place, found)| {
            let name = group.members()[place].name();
            Unmade::Failed(named(name, &flew_apart(Some(found.time))))
        })
    };
    while group.is_settling() {
        line.goes_on(all(0.0))?;
        advance(&mut group)?;
    }
    within(pool.as_ref(), || group.look());
    let camera = group.camera();
    let frames = danced(group.members()[0].performance());
    for frame in 0..frames {
        line.goes_on(all(frame as f32 / frames.max(1) as f32))?;
        if frame.is_multiple_of(FRAMES_PER_PICTURE) {
            within(pool.as_ref(), || group.look());
            let view = group.view(&camera, FILM_SIZE);
            let image = group.film(view, &mut renderer);
            let image = image.map_err(|error| Unmade::of(&error))?;
            let pushed = film.push_frame(&image.pixels);
            pushed.map_err(|error| Unmade::of(&error))?;
        } else {
            within(pool.as_ref(), || group.pass());
        }
        advance(&mut group)?;
    }
    film.finish().map_err(|error| Unmade::of(&error))
}

/// Work in a pool, where there is one.
fn within<R: Send>(pool: Option<&rayon::ThreadPool>, work: impl FnOnce() -> R + Send) -> R {
    match pool {
        Some(pool) => pool.install(work),
        None => work(),
    }
}

/// Share of the work that is dressing everybody.
const DRESSING: f32 = 0.1;

/// A list of too few or too many.
fn nobody(count: usize) -> Unmade {
    Unmade::Failed(if count == 0 {
        Sentence::new(
            "名簿に踊り手がいません。名簿を選んでください。",
            "The list has no dancers; choose another.",
        )
    } else {
        Sentence::new(
            format!(
                "{count} 人います。ひとつの動画には {MOST_DANCERS} 人までです。名簿を分けてください。"
            ),
            format!(
                "{count} dancers are listed, and a film holds {MOST_DANCERS} at most; split the list."
            ),
        )
    })
}

/// Who cannot come on, and why.
fn refused(name: &str, error: &MemberError) -> Unmade {
    let why = match error {
        MemberError::Stage(error) => said(error),
        MemberError::Look(error) => Unmade::of(error),
    };
    match why {
        Unmade::Failed(why) => Unmade::Failed(named(name, &why)),
        Unmade::CalledOff => why,
    }
}

/// A sentence about one dancer.
fn named(name: &str, sentence: &Sentence) -> Sentence {
    Sentence::new(
        format!("{name}: {}", sentence.japanese),
        format!("{name}: {}", sentence.english),
    )
}
