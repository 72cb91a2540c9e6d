//! One document danced from its first to its last frame, and measured.

use lole_costume::document::{self, Design};
use lole_language::Sentence;
use lole_stage::{
    Divergence, FRAMES_PER_SECOND, FrameMetrics, Garment, HoldWatch, Performance, Production,
    RunMetrics,
};

use crate::hem::{Folds, SwayWatch, folds};
use crate::npy;
use crate::plan::Run;
use crate::record::{Figures, Record};
use crate::sweep::FileKind;

/// Frames between two measurements: 30 a second, as `lole dance` has them.
const FRAMES_PER_LOOK: u32 = 2;

/// Files of a run: what they are and their bytes.
pub type Files = Vec<(FileKind, Vec<u8>)>;

/// A run that ended.
pub struct Performed {
    /// What it leaves behind; its processor time is the caller's to fill in.
    pub record: Record,
    /// The files that were asked for.
    pub files: Files,
}

/// Dances a run. `design` is its document with the files that it names, or why they cannot be read;
/// `goes_on` is asked before every frame. The calling thread does all of it where its pool has one thread,
/// and the bits are the same with any.
///
/// Returns `None` where it was called off.
#[must_use]
pub fn perform(
    run: &Run,
    design: Result<&Design, Sentence>,
    files: &[FileKind],
    goes_on: &dyn Fn() -> bool,
) -> Option<Performed> {
    let mut performed = Performed {
        record: Record {
            lole: env!("CARGO_PKG_VERSION").to_owned(),
            document: run.document.clone(),
            figures: None,
            error: None,
            process_seconds: 0.0,
        },
        files: Vec::new(),
    };
    if files.contains(&FileKind::Design) {
        let text = run.document.clone().into_bytes();
        performed.files.push((FileKind::Design, text));
    }
    let begun = design.and_then(|design| {
        let production = Production::new(design).and_then(Performance::new);
        production.map_err(|error| Sentence::of(&error))
    });
    match begun {
        Err(why) => performed.record.error = Some(why.into()),
        Ok(performance) => dance(performance, files, goes_on, &mut performed)?,
    }
    Some(performed)
}

/// The design of a run, its own mistakes as its error; the files it names are not read.
///
/// # Errors
/// Values that do not go together.
pub fn design(run: &Run) -> Result<Design, Sentence> {
    document::parse(&run.document, &run.id).map_err(|error| {
        // The text is the program's own, and its lines mean nothing to anyone.
        Sentence::of(&document::DesignError {
            line: None,
            ..error
        })
    })
}

/// What is watched while she dances.
struct Watched {
    metrics: Vec<FrameMetrics>,
    hold: Option<HoldWatch>,
    rest: Option<Folds>,
    sway: SwayWatch,
    folds: Vec<Folds>,
    series: String,
}

fn dance(
    mut performance: Performance,
    files: &[FileKind],
    goes_on: &dyn Fn() -> bool,
    performed: &mut Performed,
) -> Option<()> {
    let mut divergence = None;
    while performance.time() < 0.0 && divergence.is_none() {
        if !goes_on() {
            return None;
        }
        divergence = performance.advance().err();
    }
    let design = &performance.production().design;
    let whole = (performance.production().dance).whole(design.motion.repeat);
    let frame_count = frame_count(design.duration_s(whole));
    let mut watched = Watched::new(&performance);
    let mut frame = 0;
    while divergence.is_none() && frame < frame_count {
        if !goes_on() {
            return None;
        }
        if frame % FRAMES_PER_LOOK == 0 {
            watched.look(&mut performance);
        }
        divergence = performance.advance().err();
        if let Some(hold) = &mut watched.hold {
            hold.look(&performance);
        }
        frame += 1;
    }
    if divergence.is_none() {
        watched.look(&mut performance);
    }
    performed.record.figures = Some(watched.figures(&performance, frame));
    performed.record.error = divergence.map(|it| diverged(&it).into());
    if files.contains(&FileKind::Series) {
        let series = watched.series.into_bytes();
        performed.files.push((FileKind::Series, series));
    }
    if files.contains(&FileKind::Positions) && divergence.is_none() {
        let particles: Vec<_> = performance.particles().copied().collect();
        performed
            .files
            .push((FileKind::Positions, npy::points(&particles)));
    }
    Some(())
}

fn diverged(found: &Divergence) -> Sentence {
    let Divergence {
        time, row, column, ..
    } = found;
    Sentence::new(
        format!(
            "{time:.2} 秒に {row} 行 {column} 列で布の計算が発散しました。method.substep_count を増やすか、motion.tempo_bpm を下げてください"
        ),
        format!(
            "the cloth diverged at {time:.2} s at row {row} column {column}; raise method.substep_count, or lower motion.tempo_bpm"
        ),
    )
}

/// The garment whose hem is watched.
fn hung(performance: &Performance) -> Option<&Garment> {
    let production = performance.production();
    production.skirt().or_else(|| production.garments.first())
}

/// Hem and belt of a garment: its last row, and its lowest elastic.
fn hem_and_belt<'p>(performance: &'p Performance, garment: &Garment) -> [&'p [glam::Vec3]; 2] {
    let places = performance.garment_positions(garment);
    let columns = garment.sewn.spec.grid.column_count as usize;
    let belt = garment
        .sewn
        .elastic_rows
        .last()
        .map_or(0, |&row| row as usize)
        * columns;
    [
        &places[places.len() - columns..],
        &places[belt..belt + columns],
    ]
}

impl Watched {
    fn new(performance: &Performance) -> Self {
        let rest = hung(performance).map(|it| folds(hem_and_belt(performance, it)[0]));
        Self {
            metrics: Vec::new(),
            hold: HoldWatch::new(performance),
            rest,
            sway: SwayWatch::default(),
            folds: Vec::new(),
            series: "time_s,strain_p99_pct,hem_height_cm,offset_x_cm,offset_z_cm,fold_count,fold_depth_cm\n"
                .to_owned(),
        }
    }

    fn look(&mut self, performance: &mut Performance) {
        performance.pose_body();
        let metrics = performance.measure();
        self.metrics.push(metrics);
        // Strain in percent has the same factor.
        let centimeters = |meters: f64| 100.0 * meters;
        let mut rest = ",,,".to_owned();
        if let Some(garment) = hung(performance) {
            let [hem, belt] = hem_and_belt(performance, garment);
            self.sway.look(belt, hem);
            let folds = folds(hem);
            self.folds.push(folds);
            let [x, z] = self.sway.last().unwrap_or_default().map(centimeters);
            rest = format!("{x},{z},{},{}", folds.count, centimeters(folds.depth));
        }
        let strain = centimeters(f64::from(metrics.strain.p99));
        let height = centimeters(f64::from(metrics.hem_height));
        let line = format!("{},{strain},{height},{rest}\n", metrics.time);
        self.series.push_str(&line);
    }

    fn figures(&self, performance: &Performance, frames: u32) -> Figures {
        let worst = RunMetrics::of(&self.metrics);
        let percent = |share: f32| 100.0 * f64::from(share);
        let count = self.metrics.len().max(1) as f64;
        let mean_strain = self.metrics.iter().map(|it| f64::from(it.strain.mean));
        let mean = |value: fn(&Folds) -> f64| {
            let all = self.folds.iter().map(value);
            (!self.folds.is_empty()).then(|| all.sum::<f64>() / self.folds.len() as f64)
        };
        let sway = self.rest.map(|_| self.sway.seen());
        let hold = (self.hold.as_ref()).and_then(|hold| hold.seen(performance));
        Figures {
            frames,
            dance_s: f64::from(frames) / f64::from(FRAMES_PER_SECOND),
            particles: performance.production().moving_count() as u64,
            strain_mean_pct: 100.0 * mean_strain.sum::<f64>() / count,
            strain_p99_worst_pct: percent(worst.strain.p99),
            strain_worst_pct: percent(worst.strain.max),
            skin_depth_worst_mm: 1e3 * f64::from(worst.skin.worst_depth),
            hem_low_cm: percent(worst.hem_height[0]),
            hem_mean_cm: percent(worst.hem_height[1]),
            hem_high_cm: percent(worst.hem_height[2]),
            sway_cm: sway.map(|it| 100.0 * it.amplitude),
            sway_worst_cm: sway.map(|it| 100.0 * it.farthest),
            rest_fold_count: self.rest.map(|it| u64::from(it.count)),
            rest_fold_depth_cm: self.rest.map(|it| 100.0 * it.depth),
            fold_count: mean(|it| f64::from(it.count)),
            fold_depth_cm: mean(|it| 100.0 * it.depth),
            hem_radius_cm: mean(|it| 100.0 * it.radius),
            pull_n: hold.map(|it| it.pull),
            held_n: hold.map(|it| it.held),
            slip_ratio: (hold.filter(|it| 0.0 < it.held)).map(|it| it.pull / it.held),
            state_hash: format!("{:016x}", performance.state_hash()),
        }
    }
}

/// Simulated frames of a dance of `seconds`.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a dance has at most 600 seconds"
)]
fn frame_count(seconds: f64) -> u32 {
    (seconds * f64::from(FRAMES_PER_SECOND)).round() as u32
}
