//! `lole dance --dancers`: a group in one film, each dancer in her own measures.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use anyhow::Result;
use lole_costume::document::{self, Design};
use lole_costume::roster::RosterDancer;
use lole_export::counts::counts_csv;
use lole_export::group::group_json;
use lole_export::video::{Mp4Writer, Song};
use lole_files::OutputFolder;
use lole_language::{Bilingual as _, Language, Sentence};
use lole_picture::film::FRAMES_PER_PICTURE;
use lole_picture::group::{Ensemble, MOST_DANCERS, Member, MemberError};
use lole_render::{Image, Renderer, Size};
use lole_stage::{Danced, Performance};
use lole_study::{Stopwatch, figures};
use rayon::prelude::*;

use super::{Files, backend, frame_count, open_film, place_of, still_frame};
use crate::args::DanceArgs;
use crate::clock::SystemClock;
use crate::order::{nobody_listed, of_file, read_roster};
use crate::patience::{check, progress_bar, stop_flag};
use crate::source::Source;
use crate::{Failure, output, summary};

/// Size of the stills: a group is wider than high.
const STILL_SIZE: Size = Size {
    width: 1920,
    height: 1080,
};

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
    // Dancers share nothing, so every core has one.
    let cores = || std::thread::available_parallelism().map_or(1, usize::from);
    let threads = args.threads.map_or_else(cores, usize::from);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(Failure::error)?;
    let members = pool.install(|| dressed((&roster.dancers, list), source, (&stop, language)))?;
    let folder = output::create(&args.out).map_err(Failure::Usage)?;
    let run = Run {
        args,
        language,
        stop: &stop,
        design: &source.design,
    };
    let (formation, spacing) = (args.group.formation, args.group.spacing);
    let paths = pool.install(|| {
        let group = Ensemble::new(members, formation, spacing);
        let mut group = group.map_err(|refused| {
            let (name, error) = *refused;
            source.located(place_of(&error), named(&name, &Sentence::of(&error)))
        })?;
        let taken = run.film(&mut group, song, &folder)?;
        run.write(&group, taken, folder)
    })?;
    let seconds = started.read().wall_seconds;
    summary::print_group(&paths, (count, seconds), language);
    Ok(())
}

fn how_many(count: usize) -> Sentence {
    if count == 0 {
        return nobody_listed();
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
    (dancers, list): (&[RosterDancer], &Path),
    source: &Source,
    (stop, language): (&AtomicBool, Language),
) -> Result<Vec<Member>, Failure> {
    let count = u32::try_from(dancers.len()).unwrap_or(u32::MAX);
    let bar = progress_bar(count, language.pick("着せる", "dressing"));
    let members = dancers.par_iter().map(|dancer| {
        check(stop)?;
        let member = Member::new(&dancer.name, &dancer.design(&source.design));
        bar.inc(1);
        member.map_err(|error| match error {
            MemberError::Stage(error) => {
                let sentence = named(&dancer.name, &Sentence::of(&error));
                let place = place_of(&error);
                if place.table == "dancer" {
                    // Her measures stand in the list, not in the design.
                    return Failure::usage(of_file(list, &in_line(dancer.line, &sentence)));
                }
                source.located(place, sentence)
            }
            MemberError::Look(error) => Failure::error(error),
        })
    });
    let members: Vec<Result<Member, Failure>> = members.collect();
    bar.finish_and_clear();
    members.into_iter().collect()
}

/// A sentence about a line of the list.
fn in_line(line: u32, sentence: &Sentence) -> Sentence {
    Sentence::new(
        format!("{line} 行目、{}", sentence.japanese()),
        format!("line {line}, {sentence}"),
    )
}

/// A sentence about one dancer.
fn named(name: &str, sentence: &Sentence) -> Sentence {
    Sentence::new(
        format!("{name}: {}", sentence.japanese()),
        format!("{name}: {sentence}"),
    )
}

/// What a film of a group is made with.
struct Run<'a> {
    args: &'a DanceArgs,
    language: Language,
    stop: &'a AtomicBool,
    design: &'a Design,
}

/// What the camera has taken.
struct Taken {
    film: Mp4Writer,
    stills: Vec<Image>,
}

impl Run<'_> {
    /// Lets what everybody wears hang down, and dances.
    fn film(
        &self,
        group: &mut Ensemble,
        song: Option<&Song>,
        folder: &OutputFolder,
    ) -> Result<Taken, Failure> {
        let (width, height) = self.args.size;
        let size = Size::new(width, height);
        let mut renderer = Renderer::new(backend(self.args), size).map_err(Failure::error)?;
        let whole = danced(group).and_then(|dance| dance.whole(self.design.motion.repeat));
        let frame_count = frame_count(self.design.duration_s(whole));
        let still_frame = still_frame(self.design, frame_count);
        let film = open_film([width, height], (frame_count, song), folder);
        let mut film = film.map_err(Failure::error)?;
        self.settle(group)?;
        let bar = progress_bar(frame_count, self.language.pick("踊る", "dancing"));
        group.look();
        let camera = group.camera();
        let mut stills = Vec::new();
        for frame in 0..frame_count {
            check(self.stop)?;
            if frame % FRAMES_PER_PICTURE == 0 {
                group.look();
                let view = group.view(&camera, size);
                let image = group.film(view, &mut renderer).map_err(Failure::error)?;
                film.push_frame(&image.pixels).map_err(Failure::error)?;
            } else {
                group.pass();
            }
            if frame == still_frame {
                stills = take_stills(group, &mut renderer).map_err(Failure::error)?;
                renderer.resize(size).map_err(Failure::error)?;
            }
            advance(group)?;
            bar.inc(1);
        }
        group.look();
        bar.finish_and_clear();
        Ok(Taken { film, stills })
    }

    fn settle(&self, group: &mut Ensemble) -> Result<(), Failure> {
        let count = Performance::settle_frame_count();
        let bar = progress_bar(count, self.language.pick("布をなじませる", "settling"));
        while group.is_settling() {
            check(self.stop)?;
            advance(group)?;
            bar.inc(1);
        }
        bar.finish_and_clear();
        Ok(())
    }

    fn write(
        &self,
        group: &Ensemble,
        taken: Taken,
        mut folder: OutputFolder,
    ) -> Result<Vec<PathBuf>, Failure> {
        let mut files = Files::default();
        files.add_film(&mut folder, taken.film)?;
        files.add_stills(&mut folder, &taken.stills)?;
        if let Some(Danced::Step(dance)) = danced(group) {
            let counts = counts_csv(&dance.counts(self.design.duration_s(dance.duration())));
            files.add(&mut folder, "counts.csv", counts.as_bytes(), "")?;
        }
        let text = document::to_toml(self.design);
        files.add(&mut folder, "design.lole", text.as_bytes(), "")?;
        let json = group_json(&group.report()).map_err(Failure::error)?;
        files.add(&mut folder, "group.json", json.as_bytes(), "")?;
        folder.finish().map_err(Failure::error)
    }
}

/// What all of them dance.
fn danced(group: &Ensemble) -> Option<&Danced> {
    let first = group.members().first()?;
    Some(&first.performance().production().dance)
}

/// A frame of everybody.
fn advance(group: &mut Ensemble) -> Result<(), Failure> {
    group.advance().map_err(|(place, found)| {
        let member = &group.members()[place];
        let production = member.performance().production();
        let said = figures::explain(&found, production, &production.design);
        let sentence = Sentence::new(said.sentence_ja, said.sentence);
        Failure::Diverged(named(member.name(), &sentence))
    })
}

/// The stills of a moment in which everybody is posed.
fn take_stills(group: &mut Ensemble, renderer: &mut Renderer) -> Result<Vec<Image>> {
    group.look();
    renderer.resize(STILL_SIZE)?;
    let cameras = group.still_cameras(STILL_SIZE).into_iter();
    let stills = cameras.map(|camera| group.photograph(camera, renderer));
    Ok(stills.collect::<Result<_, _>>()?)
}
