//! `lole dance`: drape, dance, draw, write.

mod group;

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use anyhow::Result;
use lole_avatar::AvatarError;
use lole_costume::document::{self, Design, MethodName, Place};
use lole_export::counts::counts_csv;
use lole_export::glb::{MOST_TARGETS, said_of};
use lole_export::report::{PageFilm, ReportFile};
use lole_export::video::{Mp4Writer, Song, VideoSettings};
use lole_export::{ImageView, still};
use lole_files::OutputFolder;
use lole_garment::dress::DressError;
use lole_hula::DanceStep;
use lole_language::{Bilingual as _, Language, Sentence, Words, words};
use lole_pattern::DraftError;
use lole_picture::baked::{self, Keys};
use lole_picture::film::{FILM_RATE, FRAMES_PER_PICTURE, FilmCamera};
use lole_picture::studio::{PhotoStudio, STILLS, still_cameras};
use lole_render::{Backend, Renderer, Size};
use lole_stage::{
    Danced, Divergence, FRAMES_PER_SECOND, FrameMetrics, HoldWatch, LayerWatch, Performance,
    Production, StageError,
};
use lole_study::figures::{self, RunFigures};
use lole_study::{Stopwatch, Timing};

use crate::args::DanceArgs;
use crate::clock::SystemClock;
use crate::output;
use crate::patience::{Watch, check, progress_bar, stop_flag};
use crate::source::{self, Source};
use crate::{Failure, summary};

/// Looks a second at which piece of a garment lies outside.
const LAYER_RATE: u32 = 5;
/// Size of the stills: upright, as a poster is.
const STILL_SIZE: Size = Size {
    width: 1080,
    height: 1440,
};
/// Simulated frames of a dance whose film is held in memory: a minute.
const HELD_FRAMES: u32 = 60 * FRAMES_PER_SECOND;
/// Largest film that the page holds itself [byte]: browsers open no page of hundreds of megabytes.
const LARGEST_HELD_FILM: u64 = 64 << 20;
/// The film's name.
const FILM: &str = "dance.mp4";
/// Threads the cloth is simulated on unless asked otherwise: more do not help a single skirt.
const MOST_THREADS: usize = 4;

/// What was recorded while dancing.
#[derive(Default)]
struct Recording {
    metrics: Vec<FrameMetrics>,
    timings: Vec<Timing>,
    keys: Keys,
    /// Which cloth lies outside, from the first frame on.
    layers: Option<LayerWatch>,
    /// How the skirt pulls at its elastics.
    hold: Option<HoldWatch>,
    divergence: Option<Divergence>,
}

impl Recording {
    /// Looks at the layers of what she wears, which were right in the first look; call
    /// [`Performance::pose_body`] first.
    fn watch_layers(&mut self, performance: &Performance) {
        match &mut self.layers {
            Some(layers) => layers.look(performance),
            None => self.layers = Some(LayerWatch::new(performance)),
        }
    }
}

/// Runs the command.
pub(crate) fn run(args: &DanceArgs, language: Language) -> Result<(), Failure> {
    let source = load(args)?;
    if let Some(list) = &args.group.dancers {
        let song = args.audio.as_deref().map(song).transpose()?;
        return group::run((args, list), &source, song.as_ref(), language);
    }
    perform(args, source, language)
}

/// Performs a design and writes what is made of it.
pub(crate) fn perform(args: &DanceArgs, source: Source, language: Language) -> Result<(), Failure> {
    let stop = stop_flag().map_err(Failure::error)?;
    let production = Production::new(&source.design)
        .map_err(|error| source.located(place_of(&error), Sentence::of(&error)))?;
    check(&stop)?;
    let song = args.audio.as_deref().map(song).transpose()?;
    if !args.json {
        tell(&production, language);
    }
    let output = output::create(&args.out).map_err(Failure::Usage)?;
    let run = Run {
        song,
        args,
        language,
        stop,
        clock: SystemClock::start(),
        design: source.design,
    };
    run.perform(production, output)
}

/// Says what the files of others' patterns leave open and how that was taken.
fn tell(production: &Production, language: Language) {
    for garment in &production.dressed {
        let design = &production.design.garments[garment.listed];
        let given = design.file.as_ref().and_then(|file| file.given.as_ref());
        let notes = given.map(|given| given.notes.iter());
        let notes = notes.map(|notes| notes.chain(&garment.dressed.pattern.warnings));
        let notes: Vec<Sentence> = notes.into_iter().flatten().cloned().collect();
        summary::print_lines(&notes, language);
    }
}

/// Reads the song of the command line.
fn song(path: &Path) -> Result<Song, Failure> {
    let file = lole_files::linked_file(path, "--audio").map_err(Failure::usage)?;
    Song::read(file.bytes.as_deref().unwrap_or_default()).map_err(|error| {
        let name = path.display();
        Failure::usage(Sentence::new(
            format!("{name}: {}", error.japanese()),
            format!("{name}: {error}"),
        ))
    })
}

/// Table and key of the document where a mistake that only reading other files, measuring, drafting or
/// sewing finds is mended.
pub(crate) fn place_of(error: &StageError) -> Place<'static> {
    let (table, key) = match error {
        StageError::Body(_) => ("dancer", ""),
        StageError::Avatar { .. } | StageError::AvatarNotRead { .. } => ("dancer", "file"),
        StageError::Motion(_) => ("motion", ""),
        StageError::Recording { error, .. }
            if matches!(**error, AvatarError::UnknownClip { .. }) =>
        {
            ("motion", "clip")
        }
        StageError::Recording { .. } | StageError::RecordingNotRead { .. } => ("motion", "file"),
        StageError::Draft(_) | StageError::Sew(_) => ("skirt", ""),
        StageError::Garment { error, .. } if tailored_key(error).is_some() => {
            ("dancer", tailored_key(error).unwrap_or_default())
        }
        StageError::Garment { .. } | StageError::Dress(_) | StageError::Strands(_) => {
            ("garment", "")
        }
        StageError::Build(_) => ("fabric", ""),
    };
    Place { table, key }
}

/// The key of `[dancer]` that is the cause, where what was taken of her is.
const fn tailored_key(error: &StageError) -> Option<&'static str> {
    match error {
        StageError::Dress(DressError::Draft(DraftError::Tailored { tailored, .. })) => {
            Some(tailored.key())
        }
        _ => None,
    }
}

struct Run<'a> {
    args: &'a DanceArgs,
    language: Language,
    stop: Arc<AtomicBool>,
    clock: SystemClock,
    design: Design,
    /// What is heard under the film.
    song: Option<Song>,
}

/// Reads the design and lays the command line's wishes over it.
fn load(args: &DanceArgs) -> Result<Source, Failure> {
    let mut source = source::read(args.design.as_deref())?;
    source.put(args.avatar.as_deref(), args.motion.as_deref())?;
    source.measure(args.measures.as_deref())?;
    lay_over(&mut source.design, args)?;
    Ok(source)
}

/// Lays the wishes for the dance over a design.
pub(crate) fn lay_over(design: &mut Design, args: &DanceArgs) -> Result<(), Failure> {
    if let Some(step) = &args.step {
        let ids = DanceStep::ALL.map(DanceStep::id);
        design.motion.step = DanceStep::from_id(step)
            .ok_or_else(|| unknown("--step", step, words("ステップ", "dance step"), &ids))?;
        // A choreography or a recording would be danced instead.
        design.motion.parts.clear();
        if args.motion.is_none() {
            design.motion.file = None;
        }
    }
    if let Some(method) = &args.method {
        let ids = MethodName::ALL.map(MethodName::id);
        design.method.name = MethodName::from_id(method)
            .ok_or_else(|| unknown("--method", method, words("方法", "method"), &ids))?;
    }
    design.motion.tempo_bpm = args.bpm.unwrap_or(design.motion.tempo_bpm);
    design.motion.duration_s = args.seconds.or(design.motion.duration_s);
    design.skirt.seed = args.seed.unwrap_or(design.skirt.seed);
    design.check("command line").map_err(|mut error| {
        // The document was sound before the command line was laid over it.
        for (key, option) in [("tempo_bpm", "--bpm"), ("seed", "--seed")] {
            if error.place.ends_with(key) {
                option.clone_into(&mut error.file_name);
            }
        }
        Failure::Usage(error.into())
    })
}

pub(crate) fn unknown(option: &str, word: &str, what: Words, choices: &[&str]) -> Failure {
    let list = choices.join(", ");
    let hint = match document::likely(word, choices) {
        Some(near) => Sentence::new(
            format!("{near} のことですか"),
            format!("did you mean {near}?"),
        ),
        None => Sentence::new(
            format!("{list} から選んでください"),
            format!("choose one of {list}"),
        ),
    };
    Failure::usage(Sentence::new(
        format!(
            "{option} {word}: このような{}はありません。{}",
            what.japanese, hint.japanese
        ),
        format!("{option} {word}: there is no such {}; {hint}", what.english),
    ))
}

/// The pictures of a run while they are being made.
struct Shoot {
    studio: PhotoStudio,
    renderer: Renderer,
    film: Mp4Writer,
    size: Size,
    stills: Vec<lole_render::Image>,
}

impl Run<'_> {
    fn perform(&self, production: Production, output: OutputFolder) -> Result<(), Failure> {
        let started = Stopwatch::start(&self.clock);
        let mut performance =
            Performance::new(production).map_err(|error| Failure::Usage(error.into()))?;
        let threads = thread_count(self.args.threads);
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .map_err(Failure::error)?;
        let mut shoot = self.shoot(&performance, &output).map_err(Failure::error)?;
        let divergence = settle_on(&mut performance, &pool, (&self.stop, self.language))?;
        let keys = self.keys(&performance, &output).map_err(Failure::error)?;
        let mut recording = Recording {
            divergence,
            keys,
            ..Recording::default()
        };
        if recording.divergence.is_none() {
            self.dance(&mut performance, &pool, &mut shoot, &mut recording)?;
        }
        let finished = Finished {
            performance: &performance,
            recording,
            shoot,
            threads,
        };
        self.write(finished, output, started)
    }

    /// Simulated frames of the dance.
    fn frame_count(&self, performance: &Performance) -> u32 {
        let whole = (performance.production().dance).whole(self.design.motion.repeat);
        frame_count(self.design.duration_s(whole))
    }

    /// Where what is worn is kept for the 3D file: in memory only what becomes morph targets.
    fn keys(&self, performance: &Performance, output: &OutputFolder) -> Result<Keys> {
        let frame_count = self.frame_count(performance);
        let count = frame_count.div_ceil(FRAMES_PER_SECOND / baked::key_rate(frame_count));
        Ok(if count as usize <= MOST_TARGETS + 1 {
            Keys::default()
        } else {
            Keys::in_file(output.scratch("keys")?)
        })
    }

    fn shoot(&self, performance: &Performance, output: &OutputFolder) -> Result<Shoot> {
        let (width, height) = self.args.size;
        let size = Size::new(width, height);
        let frame_count = self.frame_count(performance);
        let film = open_film([width, height], (frame_count, self.song.as_ref()), output)?;
        Ok(Shoot {
            studio: PhotoStudio::new(performance)?,
            renderer: Renderer::new(backend(self.args), size)?,
            film,
            size,
            stills: Vec::new(),
        })
    }

    /// Dances, drawing every second frame into the film.
    fn dance(
        &self,
        performance: &mut Performance,
        pool: &rayon::ThreadPool,
        shoot: &mut Shoot,
        recording: &mut Recording,
    ) -> Result<(), Failure> {
        let frame_count = self.frame_count(performance);
        let still_frame = still_frame(&self.design, frame_count);
        let key_stride = FRAMES_PER_SECOND / baked::key_rate(frame_count);
        let bar = progress_bar(frame_count, self.language.pick("踊る", "dancing"));
        let patience = Watch::over(&bar, self.language);
        performance.pose_body();
        let camera = FilmCamera::new(performance);
        recording.hold = HoldWatch::new(performance);
        for frame in 0..frame_count {
            check(&self.stop)?;
            if frame % FRAMES_PER_PICTURE == 0 {
                performance.pose_body();
                recording.metrics.push(performance.measure());
                if frame % (FRAMES_PER_SECOND / LAYER_RATE) == 0 {
                    recording.watch_layers(performance);
                }
                let view = camera.view(performance, shoot.size);
                shoot.take(performance, view).map_err(Failure::error)?;
            } else {
                shoot.studio.pass(performance);
            }
            if frame % key_stride == 0 {
                let kept = recording.keys.keep(performance);
                kept.map_err(Failure::error)?;
            }
            if frame == still_frame {
                shoot.take_stills(performance).map_err(Failure::error)?;
            }
            let watch = Stopwatch::start(&self.clock);
            let result = pool.install(|| performance.advance());
            recording.timings.push(watch.read());
            if let Err(divergence) = result {
                recording.divergence = Some(divergence);
                break;
            }
            if let Some(hold) = &mut recording.hold {
                hold.look(performance);
            }
            patience.tell(performance.pressed_count());
            bar.inc(1);
        }
        drop(patience);
        if recording.divergence.is_none() {
            performance.pose_body();
            recording.metrics.push(performance.measure());
            recording.watch_layers(performance);
        }
        bar.finish_and_clear();
        Ok(())
    }

    /// Writes when every count falls; a recording has none.
    fn write_counts(
        &self,
        performance: &Performance,
        output: &mut OutputFolder,
        files: &mut Files,
    ) -> Result<(), Failure> {
        let Danced::Step(dance) = &performance.production().dance else {
            return Ok(());
        };
        let counts = counts_csv(&dance.counts(self.design.duration_s(dance.duration())));
        files.add(
            output,
            "counts.csv",
            counts.as_bytes(),
            "When every count falls, in seconds of the film: a metronome for the music.",
        )
    }

    fn write_design(&self, output: &mut OutputFolder, files: &mut Files) -> Result<(), Failure> {
        let text = document::to_toml(&self.design);
        files.add(
            output,
            "design.lole",
            text.as_bytes(),
            "The design that was run: `lole dance design.lole` repeats it bit for bit.",
        )
    }

    fn write(
        &self,
        finished: Finished<'_>,
        mut output: OutputFolder,
        started: Stopwatch<'_>,
    ) -> Result<(), Failure> {
        let Finished {
            performance,
            recording,
            shoot,
            threads,
        } = finished;
        let bar = progress_bar(3, self.language.pick("書き出す", "writing"));
        let mut files = Files::default();
        let renderer = shoot.renderer.description().to_owned();
        bar.inc(1);
        let (mut film, mut stills) = (None, Vec::new());
        if recording.divergence.is_none() {
            film = Some(files.add_film(&mut output, shoot.film)?);
            stills = files.add_stills(&mut output, &shoot.stills)?;
            bar.inc(1);
            let glb = baked::dancer_glb(performance, &recording.keys, shoot.studio.covers())
                .map_err(Failure::error)?;
            let what = format!(
                "The dancer with her skeleton and dance, and what she wears with its baked motion: opens in Blender and 3D viewers.{}",
                said_of(&glb.fits).english
            );
            files.add(&mut output, "dancer.glb", &glb.bytes, &what)?;
        } else {
            drop(shoot.film);
        }
        bar.inc(1);
        self.write_counts(performance, &mut output, &mut files)?;
        self.write_design(&mut output, &mut files)?;
        // Some systems remove no folder with a file in it that is open, as those of film and keys may be.
        drop(recording.keys);
        let figures = RunFigures {
            design: &self.design,
            threads,
            renderer,
            metrics: &recording.metrics,
            timings: &recording.timings,
            divergence: recording.divergence,
            layers: (recording.layers).map_or_else(Vec::new, |layers| layers.seen(performance)),
            hold: (recording.hold).and_then(|hold| hold.seen(performance)),
            files: files.list,
        };
        let report = figures::report(performance, figures);
        let page = figures::page(&report, film.as_ref().map(shown), &stills);
        let json = lole_export::report::report_json(&report).map_err(Failure::error)?;
        output
            .write("report.html", page.as_bytes())
            .map_err(Failure::error)?;
        output
            .write("report.json", json.as_bytes())
            .map_err(Failure::error)?;
        let paths = output.finish().map_err(Failure::error)?;
        bar.finish_and_clear();
        if self.args.json {
            summary::print_json(&json);
        } else {
            let seconds = started.read().wall_seconds;
            summary::print_run(&report, &paths, seconds, self.language);
        }
        report.divergence.map_or(Ok(()), |found| {
            Err(Failure::Diverged(Sentence::new(
                found.sentence_ja,
                found.sentence,
            )))
        })
    }
}

/// A run whose last frame has been danced.
struct Finished<'a> {
    performance: &'a Performance,
    recording: Recording,
    shoot: Shoot,
    threads: usize,
}

impl Shoot {
    fn take(&mut self, performance: &Performance, camera: lole_render::Camera) -> Result<()> {
        let image = (self.studio).film(performance, camera, &mut self.renderer)?;
        Ok(self.film.push_frame(&image.pixels)?)
    }

    fn take_stills(&mut self, performance: &mut Performance) -> Result<()> {
        performance.pose_body();
        self.renderer.resize(STILL_SIZE)?;
        for camera in still_cameras(performance, STILL_SIZE) {
            let image = (self.studio).photograph(performance, camera, &mut self.renderer)?;
            self.stills.push(image);
        }
        self.renderer.resize(self.size)?;
        Ok(())
    }
}

/// Opens a film of so many simulated frames; a long one waits in the folder for its end.
fn open_film(
    size: [u32; 2],
    (frame_count, song): (u32, Option<&Song>),
    output: &OutputFolder,
) -> Result<Mp4Writer> {
    let mut film = Mp4Writer::new(size, FILM_RATE, VideoSettings::default())?;
    if HELD_FRAMES < frame_count {
        film.keep_in(output.scratch("film")?);
    }
    if let Some(song) = song {
        film.set_song(song.clone());
    }
    Ok(film)
}

/// How the page shows a film: itself, or, where its bytes were not given, from beside.
fn shown(film: &Option<Vec<u8>>) -> PageFilm<'_> {
    film.as_deref()
        .map_or(PageFilm::Beside(FILM), PageFilm::Held)
}

/// Files written so far, for the report.
#[derive(Default)]
struct Files {
    list: Vec<ReportFile>,
}

impl Files {
    /// Writes the stills and gives them back as JPEG, for the page.
    fn add_stills(
        &mut self,
        output: &mut OutputFolder,
        images: &[lole_render::Image],
    ) -> Result<Vec<Vec<u8>>, Failure> {
        let mut jpegs = Vec::new();
        for (still, image) in STILLS.iter().zip(images) {
            let image =
                ImageView::new(image.width, image.height, &image.pixels).map_err(Failure::error)?;
            let png = still::encode_png(image).map_err(Failure::error)?;
            self.add(
                output,
                still.file,
                &png,
                "A still at the full swing of the hips: opens in any viewer.",
            )?;
            jpegs.push(still::encode_jpeg(image, 88).map_err(Failure::error)?);
        }
        Ok(jpegs)
    }

    /// Closes and writes the film; gives its bytes where a page can hold them.
    fn add_film(
        &mut self,
        output: &mut OutputFolder,
        film: Mp4Writer,
    ) -> Result<Option<Vec<u8>>, Failure> {
        let what = "The film: plays in any video player and browser.";
        if film.byte_count() <= LARGEST_HELD_FILM {
            let bytes = film.finish().map_err(Failure::error)?;
            self.add(output, FILM, &bytes, what)?;
            return Ok(Some(bytes));
        }
        let mut file = output.begin(FILM).map_err(Failure::error)?;
        film.finish_into(&mut file).map_err(Failure::error)?;
        self.list.push(ReportFile {
            name: FILM.to_owned(),
            bytes: file.metadata().map_err(Failure::error)?.len(),
            what: what.to_owned(),
        });
        Ok(None)
    }

    fn add(
        &mut self,
        output: &mut OutputFolder,
        name: &str,
        bytes: &[u8],
        what: &str,
    ) -> Result<(), Failure> {
        output.write(name, bytes).map_err(Failure::error)?;
        self.list.push(ReportFile {
            name: name.to_owned(),
            bytes: bytes.len() as u64,
            what: what.to_owned(),
        });
        Ok(())
    }
}

/// What draws.
const fn backend(args: &DanceArgs) -> Backend {
    if args.cpu {
        Backend::Cpu
    } else {
        Backend::Auto
    }
}

/// The frame of the stills: on a count, past the middle, when the sway is in full swing.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a dance has at most 36,000 frames"
)]
fn still_frame(design: &Design, frame_count: u32) -> u32 {
    let beat = f64::from(FRAMES_PER_SECOND) * 60.0 / design.motion.tempo_bpm;
    let counts = (0.6 * f64::from(frame_count) / beat).round();
    ((counts * beat) as u32).min(frame_count - 1)
}

/// Threads the cloth is simulated on, as asked or as this machine has them.
pub(crate) fn thread_count(asked: Option<u16>) -> usize {
    let cores = || std::thread::available_parallelism().map_or(1, usize::from);
    asked.map_or_else(|| cores().min(MOST_THREADS), usize::from)
}

/// Lets what she wears hang down in the dancer's stance; gives where it diverged, if it did.
pub(crate) fn settle_on(
    performance: &mut Performance,
    pool: &rayon::ThreadPool,
    (stop, language): (&AtomicBool, Language),
) -> Result<Option<Divergence>, Failure> {
    let count = Performance::settle_frame_count();
    let bar = progress_bar(count, language.pick("布をなじませる", "settling"));
    let watch = Watch::over(&bar, language);
    let mut divergence = None;
    while performance.time() < 0.0 && divergence.is_none() {
        check(stop)?;
        divergence = pool.install(|| performance.advance()).err();
        watch.tell(performance.pressed_count());
        bar.inc(1);
    }
    drop(watch);
    bar.finish_and_clear();
    Ok(divergence)
}

/// Simulated frames of a dance of `seconds`.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the command line allows at most 600 seconds"
)]
pub(crate) fn frame_count(seconds: f64) -> u32 {
    (seconds * f64::from(FRAMES_PER_SECOND)).round() as u32
}
