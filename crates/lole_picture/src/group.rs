//! Several dancers on one stage: everybody dances as she would alone, and they meet in the picture.

use glam::{Vec2, Vec3};
use lole_costume::document::Design;
use lole_export::group::{GroupDancer, GroupReport};
use lole_render::{Camera, Image, RenderError, Renderer, Scene, Size};
use lole_stage::{Divergence, Formation, Performance, Production, StageError, assign_places};
use rayon::prelude::*;

use crate::film::cues::{Cues, lit};
use crate::film::shutter::Shutter;
use crate::film::{self, FilmCamera, Placed, title};
use crate::studio::{PhotoStudio, cameras_around};
use crate::{Lamps, LookError, Looks, Moment, Scenery};

/// How far apart the clocks are that dancers blink by [s]: nobody blinks with her neighbor.
const BLINKS_APART: f32 = 11.3;
/// Most dancers of one film: each takes as much time as a film of her alone.
pub const MOST_DANCERS: usize = 24;
/// Free air between the hands of neighbors [m].
const BETWEEN_HANDS: f32 = 0.1;

/// Why somebody cannot come on.
#[derive(Debug, thiserror::Error)]
pub enum MemberError {
    /// She cannot be dressed.
    #[error(transparent)]
    Stage(#[from] StageError),
    /// She cannot be drawn.
    #[error(transparent)]
    Look(#[from] LookError),
}

/// One dancer of a group.
pub struct Member {
    name: String,
    performance: Performance,
    studio: PhotoStudio,
    at: Vec3,
    /// Strain (p99) in the worst look.
    strain: f32,
    /// Deepest cloth in the skin in any look [m].
    depth: f32,
}

impl Member {
    /// Dresses her.
    ///
    /// # Errors
    /// A design that she cannot wear, and pictures that cannot be made.
    pub fn new(name: &str, design: &Design) -> Result<Self, MemberError> {
        let performance = Performance::new(Production::new(design)?)?;
        let studio = PhotoStudio::new(&performance)?;
        Ok(Self {
            name: name.to_owned(),
            performance,
            studio,
            at: Vec3::ZERO,
            strain: 0.0,
            depth: 0.0,
        })
    }

    /// As the list has it.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Her dance, as if she were alone.
    #[must_use]
    pub const fn performance(&self) -> &Performance {
        &self.performance
    }

    const fn placed(&self) -> Placed<'_> {
        Placed {
            performance: &self.performance,
            at: self.at,
        }
    }

    fn look(&mut self) {
        self.performance.pose_body();
        let seen = self.performance.measure();
        self.strain = self.strain.max(seen.strain.p99);
        self.depth = self.depth.max(seen.skin.worst_depth);
    }

    fn report(&self) -> GroupDancer {
        GroupDancer {
            name: self.name.clone(),
            place_m: [self.at.x, self.at.z],
            particles: self.performance.cloth_positions().len(),
            strain_p99_pct: 100.0 * self.strain,
            below_skin_mm: 1000.0 * self.depth,
            state_hash: format!("{:016x}", self.performance.state_hash()),
        }
    }
}

/// How far everybody gets in every part of the choreography of the first [m]; nothing where it names no formation.
fn ways(members: &[Member], places: &[Vec3], room: f32) -> Vec<Vec<Vec2>> {
    let parts = members.first().map(|it| {
        let motion = &it.performance.production().design.motion;
        motion.parts.iter().filter(|_| motion.file.is_none())
    });
    let named: Vec<Option<Formation>> =
        parts.into_iter().flatten().map(|it| it.formation).collect();
    if named.iter().all(Option::is_none) {
        return Vec::new();
    }
    let mut at = places.to_vec();
    let mut ways = vec![Vec::new(); members.len()];
    for formation in named {
        let next = formation.map_or_else(|| at.clone(), |it| it.places(at.len(), room));
        let goes = assign_places(&at, &next);
        for ((at, ways), place) in at.iter_mut().zip(&mut ways).zip(goes) {
            let way = next[place] - *at;
            ways.push(Vec2::new(way.x, way.z));
            *at = next[place];
        }
    }
    ways
}

/// Dancers on one stage. Its work is shared among the threads of the pool that it is called in.
pub struct Ensemble {
    members: Vec<Member>,
    formation: Formation,
    shutter: Shutter,
    cues: Cues,
}

impl Ensemble {
    /// Places everybody, from one to the next of a row by `spacing` [m], or so far that no hand reaches a neighbor, and
    /// sends her to the formations that the choreography names.
    ///
    /// # Errors
    /// A part too short for somebody's way, with her name.
    pub fn new(
        mut members: Vec<Member>,
        formation: Formation,
        spacing: Option<f32>,
    ) -> Result<Self, Box<(String, StageError)>> {
        let room = spacing.unwrap_or_else(|| {
            let performances = members.iter().map(|it| &it.performance);
            film::room(&performances.collect::<Vec<_>>()) + BETWEEN_HANDS
        });
        let places = formation.places(members.len(), room);
        let ways = ways(&members, &places, room);
        for (place, (member, at)) in members.iter_mut().zip(places).enumerate() {
            member.at = at;
            if let Some(ways) = ways.get(place) {
                let walks = member.performance.walk(ways);
                walks.map_err(|error| Box::new((member.name.clone(), error)))?;
            }
        }
        let first = members.first().map(|it| it.performance.production());
        let blur = first.map_or_else(Default::default, |it| it.design.stage.motion_blur);
        let cues = first.map_or_else(Cues::default, Cues::of);
        Ok(Self {
            members,
            formation,
            shutter: Shutter::new(blur),
            cues,
        })
    }

    /// Everybody.
    #[must_use]
    pub fn members(&self) -> &[Member] {
        &self.members
    }

    /// Whether somebody's cloth still comes to rest before the dance.
    #[must_use]
    pub fn is_settling(&self) -> bool {
        self.members.iter().any(|it| it.performance.time() < 0.0)
    }

    /// Moves on by a frame; who is ready waits for those whose cloth still comes to rest.
    ///
    /// # Errors
    /// The first of the list whose cloth has come apart: her place in it, and where.
    pub fn advance(&mut self) -> Result<(), (usize, Divergence)> {
        let is_settling = self.is_settling();
        let members = self.members.par_iter_mut();
        let moved = members.map(|it| {
            let waits = is_settling && 0.0 <= it.performance.time();
            if waits {
                Ok(())
            } else {
                it.performance.advance()
            }
        });
        let moved: Vec<Result<(), Divergence>> = moved.collect();
        let lost = moved.into_iter().enumerate();
        let mut lost = lost.filter_map(|(place, moved)| Some((place, moved.err()?)));
        lost.next().map_or(Ok(()), Err)
    }

    /// Poses everybody for a picture, and looks at her cloth.
    pub fn look(&mut self) {
        self.members.par_iter_mut().for_each(Member::look);
    }

    /// A camera that sees all of them through the whole dance; look at them first.
    #[must_use]
    pub fn camera(&self) -> FilmCamera {
        FilmCamera::of_group(&self.placed())
    }

    /// What it sees now.
    #[must_use]
    pub fn view(&self, camera: &FilmCamera, size: Size) -> Camera {
        camera.group_view(&self.placed(), size)
    }

    /// The cameras of the stills, as of one dancer.
    #[must_use]
    pub fn still_cameras(&self, size: Size) -> Vec<Camera> {
        let points = self.members.iter().flat_map(|it| {
            let body = it.performance.body_positions().iter();
            let all = body.chain(it.performance.cloth_positions());
            all.map(|place| place + it.at)
        });
        cameras_around(&points.collect::<Vec<Vec3>>(), size)
    }

    /// What the film's shutter sees between two pictures: to be called in every frame of the dance that has none.
    pub fn pass(&mut self) {
        if self.shutter.smears() {
            (self.members.par_iter_mut()).for_each(|it| it.performance.pose_body());
            self.keep();
        }
    }

    /// The film's picture of the frame that was looked at last, in the set of the first dancer.
    ///
    /// # Errors
    /// A size that cannot be drawn, or an adapter that fails.
    pub fn film(&mut self, camera: Camera, renderer: &mut Renderer) -> Result<Image, RenderError> {
        self.keep();
        let (size, first) = (renderer.size(), self.members.first());
        let time = first.map_or(0.0, |it| it.performance.time());
        let mut image = lit((&self.cues, time), size, |scenery| {
            self.shutter.expose((&camera, size), |moments, room| {
                let stage = (scenery, Lamps::Still);
                renderer.render_lit(&self.scene(moments, camera, stage), room)
            })
        })?;
        if let Some(first) = first.map(|it| it.performance.production()) {
            title::write(&mut image, &first.design.stage.title, time)?;
        }
        Ok(image)
    }

    /// A still of the frame that was looked at last, in the set of the first dancer.
    ///
    /// # Errors
    /// A size that cannot be drawn, or an adapter that fails.
    pub fn photograph(
        &self,
        camera: Camera,
        renderer: &mut Renderer,
    ) -> Result<Image, RenderError> {
        let members = self.members.par_iter();
        let moments = members.map(|it| Moment::still(&it.performance).moved(it.at));
        let moments: Vec<Moment> = moments.collect();
        let first = self.members.first().map(|it| it.studio.looks().scenery);
        let stage = (first.unwrap_or_default(), Lamps::WithCamera);
        renderer.render(&self.scene(&moments, camera, stage))
    }

    /// Lets the shutter see everybody as she is posed.
    fn keep(&mut self) {
        let members = self.members.par_iter().enumerate();
        let moments = members.map(|(place, it)| {
            Moment::among(&it.performance, BLINKS_APART * place as f32).moved(it.at)
        });
        let moments: Vec<Moment> = moments.collect();
        let time = (self.members.first()).map_or(0.0, |first| first.performance.time());
        self.shutter.keep(time, moments);
    }

    /// What is seen of moments of everybody.
    fn scene<'a>(
        &'a self,
        moments: &'a [Moment],
        camera: Camera,
        stage: (Scenery, Lamps),
    ) -> Scene<'a> {
        let dancers = self.members.iter().zip(moments);
        let dancers: Vec<_> = dancers
            .map(|(it, moment)| (it.studio.looks(), moment.dancer()))
            .collect();
        Looks::stage(&dancers, stage, camera)
    }

    /// Who stands where, and how her costume danced.
    #[must_use]
    pub fn report(&self) -> GroupReport {
        GroupReport {
            formation: self.formation.id().to_owned(),
            dancers: self.members.iter().map(Member::report).collect(),
        }
    }

    fn placed(&self) -> Vec<Placed<'_>> {
        self.members.iter().map(Member::placed).collect()
    }
}
