//! `lole dance --dancers`: a group in one film, each dancer in her own measures.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use anyhow::Result;
use glam::Vec3;
use lole_costume::document::{self, Design};
use lole_costume::roster::RosterDancer;
use lole_export::counts::counts_csv;
use lole_export::group::{GroupDancer, GroupReport, group_json};
use lole_export::video::{Mp4Writer, Song, VideoSettings};
use lole_files::OutputFolder;
use lole_language::{Bilingual as _, Language, Sentence};
use lole_picture::Lamps;
use lole_picture::film::{self, FilmCamera, Placed};
use lole_picture::studio::{PhotoStudio, group_still_cameras, shoot_group};
use lole_render::{Camera, Image, Renderer, Size};
use lole_stage::{Danced, Performance, Production};
use lole_study::{Stopwatch, figures};
use rayon::prelude::*;

use super::{
    FILM_RATE, FRAMES_PER_PICTURE, Files, backend, frame_count, place_of, still_frame, thread_count,
};
use crate::args::{DanceArgs, GroupArgs};
use crate::clock::SystemClock;
use crate::order::{of_file, read_roster};
use crate::patience::{check, progress_bar, stop_flag};
use crate::source::Source;
use crate::{Failure, output, summary};

/// Most dancers of one film: each takes as much time as a film of her alone.
const MOST_DANCERS: usize = 24;
/// Free air between the hands of neighbors [m].
const BETWEEN_HANDS: f32 = 0.1;
/// Size of the stills: a group is wider than high.
const STILL_SIZE: Size = Size {
    width: 1920,
    height: 1080,
};

/// One dancer of the group.
struct Member {
    name: String,
    performance: Performance,
    studio: PhotoStudio,
    at: Vec3,
    worst: Worst,
}

/// The worst of all pictures of a dancer.
#[derive(Debug, Clone, Copy, Default)]
struct Worst {
    /// Strain (p99).
    strain: f32,
    /// Depth in the skin [m].
    depth: f32,
}

impl Member {
    /// A frame; what is to be said where her cloth has come apart.
    fn advance(&mut self) -> Option<Sentence> {
        let found = self.performance.advance().err()?;
        let production = self.performance.production();
        let said = figures::explain(&found, production, &production.design);
        let name = &self.name;
        Some(Sentence::new(
            format!("{name}: {}", said.sentence_ja),
            format!("{name}: {}", said.sentence),
        ))
    }

    fn report(&self) -> GroupDancer {
        GroupDancer {
            name: self.name.clone(),
            place_m: [self.at.x, self.at.z],
            particles: self.performance.cloth_positions().len(),
            strain_p99_pct: 100.0 * self.worst.strain,
            below_skin_mm: 1000.0 * self.worst.depth,
            state_hash: format!("{:016x}", self.performance.state_hash()),
        }
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
        self.worst.strain = self.worst.strain.max(seen.strain.p99);
        self.worst.depth = self.worst.depth.max(seen.skin.worst_depth);
    }
}

/// Dances a design with everybody of a list and writes what is made of it.
pub(super) fn run(
    (args, list): (&DanceArgs, &Path),
    source: &Source,
    song: Option<&Song>,
    language: Language,
) -> Result<(), Failure> {
    let stop = stop_flag().map_err(Failure::error)?;
    let roster = read_roster(list)?;
    if let Some(problem) = roster.problems.first() {
        return Err(Failure::usage(of_file(list, &problem.sentence())));
    }
    let count = roster.dancers.len();
    if count == 0 || MOST_DANCERS < count {
        return Err(Failure::usage(of_file(list, &how_many(count))));
    }
    summary::print_lines(&roster.notes, language);
    let clock = SystemClock::start();
    let started = Stopwatch::start(&clock);
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let threads = args
        .threads
        .map_or_else(|| thread_count(None).max(cores), usize::from);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(Failure::error)?;
    let members = pool.install(|| dressed(&roster.dancers, source, (&stop, language)))?;
    let folder = output::create(&args.out).map_err(Failure::Usage)?;
    let stage = Stage {
        args,
        language,
        stop: &stop,
        pool: &pool,
        design: &source.design,
    };
    let mut members = stage.placed(members, &args.group);
    let shots = stage.film(&mut members, song)?;
    let paths = stage.write(&members, &shots, folder)?;
    let seconds = started.read().wall_seconds;
    summary::print_group(&paths, (count, seconds), language);
    Ok(())
}

fn how_many(count: usize) -> Sentence {
    if count == 0 {
        return Sentence::new(
            "名簿に踊り手がいません。見出しの下に一人一行で書いてください",
            "the list has no dancers; write one a line below the heads",
        );
    }
    Sentence::new(
        format!(
            "{count} 人います。ひとつの動画には {MOST_DANCERS} 人までです。名簿を分けてください"
        ),
        format!(
            "{count} dancers are listed, and a film holds {MOST_DANCERS} at most; split the list"
        ),
    )
}

/// Everybody dressed, in the order of the list.
fn dressed(
    dancers: &[RosterDancer],
    source: &Source,
    (stop, language): (&AtomicBool, Language),
) -> Result<Vec<Member>, Failure> {
    let count = u32::try_from(dancers.len()).unwrap_or(u32::MAX);
    let bar = progress_bar(count, language.pick("着せる", "dressing"));
    let members = dancers.par_iter().map(|dancer| {
        check(stop)?;
        let design = dancer.design(&source.design);
        let refused = |error: &lole_stage::StageError| {
            let place = place_of(error);
            let sentence = Sentence::of(error);
            let named = Sentence::new(
                format!("{}: {}", dancer.name, sentence.japanese()),
                format!("{}: {sentence}", dancer.name),
            );
            source.located(place, named)
        };
        let production = Production::new(&design).map_err(|error| refused(&error))?;
        let performance = Performance::new(production).map_err(|error| refused(&error))?;
        let studio = PhotoStudio::new(&performance).map_err(Failure::error)?;
        bar.inc(1);
        Ok(Member {
            name: dancer.name.clone(),
            performance,
            studio,
            at: Vec3::ZERO,
            worst: Worst::default(),
        })
    });
    let members: Vec<Result<Member, Failure>> = members.collect();
    bar.finish_and_clear();
    members.into_iter().collect()
}

/// What a film of a group is made with.
struct Stage<'a> {
    args: &'a DanceArgs,
    language: Language,
    stop: &'a AtomicBool,
    pool: &'a rayon::ThreadPool,
    design: &'a Design,
}

/// What the camera has taken.
struct Shots {
    film: Vec<u8>,
    stills: Vec<Image>,
}

impl Stage<'_> {
    /// Puts everybody where she stands.
    fn placed(&self, mut members: Vec<Member>, group: &GroupArgs) -> Vec<Member> {
        let room = group.spacing.unwrap_or_else(|| {
            let performances: Vec<&Performance> =
                members.iter().map(|it| &it.performance).collect();
            film::room(&performances) + BETWEEN_HANDS
        });
        let places = group.formation.places(members.len(), room);
        for (member, at) in members.iter_mut().zip(places) {
            member.at = at;
        }
        members
    }

    /// Lets what everybody wears hang down, and dances.
    fn film(&self, members: &mut [Member], song: Option<&Song>) -> Result<Shots, Failure> {
        let (width, height) = self.args.size;
        let size = Size::new(width, height);
        let mut renderer = Renderer::new(backend(self.args), size).map_err(Failure::error)?;
        let mut film = Mp4Writer::new([width, height], FILM_RATE, VideoSettings::default())
            .map_err(Failure::error)?;
        if let Some(song) = song {
            film.set_song(song.clone());
        }
        self.settle(members)?;
        let dance = &members[0].performance.production().dance;
        let whole = dance.whole(self.design.motion.repeat);
        let frame_count = frame_count(self.design.duration_s(whole));
        let still_frame = still_frame(self.design, frame_count);
        let bar = progress_bar(frame_count, self.language.pick("踊る", "dancing"));
        self.pool
            .install(|| members.par_iter_mut().for_each(Member::look));
        let camera = FilmCamera::of_group(&placed(members));
        let mut stills = Vec::new();
        for frame in 0..frame_count {
            check(self.stop)?;
            if frame % FRAMES_PER_PICTURE == 0 {
                self.pool
                    .install(|| members.par_iter_mut().for_each(Member::look));
                let view = camera.group_view(&placed(members), size);
                let view = (view, Lamps::Still);
                let image = picture(members, view, &mut renderer).map_err(Failure::error)?;
                film.push_frame(&image.pixels).map_err(Failure::error)?;
            }
            if frame == still_frame {
                self.pool
                    .install(|| members.par_iter_mut().for_each(Member::look));
                stills = take_stills(members, &mut renderer).map_err(Failure::error)?;
                renderer.resize(size).map_err(Failure::error)?;
            }
            self.advance(members)?;
            bar.inc(1);
        }
        bar.finish_and_clear();
        Ok(Shots {
            film: film.finish().map_err(Failure::error)?,
            stills,
        })
    }

    fn settle(&self, members: &mut [Member]) -> Result<(), Failure> {
        let count = Performance::settle_frame_count();
        let bar = progress_bar(count, self.language.pick("布をなじませる", "settling"));
        while members.iter().any(|it| it.performance.time() < 0.0) {
            check(self.stop)?;
            self.advance_some(members, |it| it.performance.time() < 0.0)?;
            bar.inc(1);
        }
        bar.finish_and_clear();
        Ok(())
    }

    fn advance(&self, members: &mut [Member]) -> Result<(), Failure> {
        self.advance_some(members, |_| true)
    }

    /// A frame of those who are to move.
    fn advance_some(
        &self,
        members: &mut [Member],
        moves: impl Fn(&Member) -> bool + Sync,
    ) -> Result<(), Failure> {
        let stopped: Vec<Sentence> = self.pool.install(|| {
            let moving = members.par_iter_mut().filter(|it| moves(it));
            moving.filter_map(Member::advance).collect()
        });
        let first = stopped.into_iter().next();
        first.map_or(Ok(()), |sentence| Err(Failure::Diverged(sentence)))
    }

    fn write(
        &self,
        members: &[Member],
        shots: &Shots,
        mut folder: OutputFolder,
    ) -> Result<Vec<PathBuf>, Failure> {
        let mut files = Files::default();
        files.add(&mut folder, "dance.mp4", &shots.film, "")?;
        files.add_stills(&mut folder, &shots.stills)?;
        if let Danced::Step(dance) = &members[0].performance.production().dance {
            let counts = counts_csv(&dance.counts(self.design.duration_s(dance.duration())));
            files.add(&mut folder, "counts.csv", counts.as_bytes(), "")?;
        }
        let text = document::to_toml(self.design);
        files.add(&mut folder, "design.lole", text.as_bytes(), "")?;
        let report = GroupReport {
            formation: self.args.group.formation.id().to_owned(),
            dancers: members.iter().map(Member::report).collect(),
        };
        let json = group_json(&report).map_err(Failure::error)?;
        files.add(&mut folder, "group.json", json.as_bytes(), "")?;
        folder.finish().map_err(Failure::error)
    }
}

/// Everybody where she stands.
fn placed(members: &[Member]) -> Vec<Placed<'_>> {
    members.iter().map(Member::placed).collect()
}

fn picture(
    members: &[Member],
    (camera, lamps): (Camera, Lamps),
    renderer: &mut Renderer,
) -> Result<Image> {
    let group: Vec<_> = members.iter().map(|it| (&it.studio, it.placed())).collect();
    Ok(shoot_group(&group, (camera, lamps), renderer)?)
}

/// The stills of a moment in which everybody is posed.
fn take_stills(members: &[Member], renderer: &mut Renderer) -> Result<Vec<Image>> {
    renderer.resize(STILL_SIZE)?;
    group_still_cameras(&placed(members), STILL_SIZE)
        .into_iter()
        .map(|camera| picture(members, (camera, Lamps::WithCamera), renderer))
        .collect()
}
