//! `lole study`: the paper's experiment with numbers.
//!
//! The paper compares three integrators by one picture and one sentence each. Here they dance on
//! one skirt of its kind (few mass points, soft springs) and are measured: where they are stable
//! in theory and on the cloth, what they do at the same step and at their own, which departure of
//! the print from the classical Runge-Kutta method makes its picture, and how many capsules a body
//! needs.

mod capsules;
mod findings;
mod methods;
mod picture;
mod runs;
mod thresholds;

use std::num::NonZeroU32;

use lole_cloth::method::explicit::{
    ContactEvaluation, Counting, HighestMode, Integrator, LastStage, RungeKutta, StageDamping,
    stability_limit,
};
use lole_cloth::method::reference::ReferenceModel;
use lole_costume::document::{Design, MethodName};
use lole_export::report::Remark;
use lole_export::still;
use lole_export::study::{
    CauseEntry, IntegratorEntry, SkirtOfStudy, StepEntry, StudyReport, study_csv, study_html,
    study_json,
};
use lole_language::{Language, Words, words};
use lole_stage::{FRAME_SECONDS, FRAMES_PER_SECOND, Performance, Production};

use crate::args::StudyArgs;
use crate::output::OutputFolder;
use crate::patience::{progress_bar, stop_flag};
use crate::stopwatch::Stopwatch;
use crate::{Failure, summary};
use methods::{METHODS, Method};
use picture::Panel;
use runs::{Run, Runner, Setup};

/// Steps of a frame at which all methods are compared: six for each that `fb-euler` needs. It is
/// then stable by a wide margin, Euler's method flies apart, and the printed method gains energy
/// as fast as folding cloth can swallow it: the paper's three pictures.
const SHARED_STEPS: u32 = 6;
/// Share of its limit at which each method runs by itself. Springs that are stretched or meet a
/// capsule are stiffer than those of the flat cloth that the limit is for.
const OWN_SHARE: f64 = 0.7;
/// Steps over a stable one at which Euler's and the printed method are shown as they fail.
const STEP_RATIOS: [u32; 7] = [1, 2, 4, 8, 16, 32, 64];
/// Threads of the study: its skirts are too small for more.
const MOST_THREADS: usize = 2;

/// Quality of the picture on the page, 1 to 100.
const PICTURE_QUALITY: u8 = 88;

/// How long the parts are, in frames.
struct Lengths {
    shared: u32,
    own: u32,
    steps: u32,
    capsules: u32,
}

const FULL: Lengths = Lengths {
    shared: 4 * FRAMES_PER_SECOND,
    own: FRAMES_PER_SECOND,
    steps: 2 * FRAMES_PER_SECOND,
    capsules: 4 * FRAMES_PER_SECOND,
};

const QUICK: Lengths = Lengths {
    shared: FRAMES_PER_SECOND,
    own: FRAMES_PER_SECOND / 6,
    steps: FRAMES_PER_SECOND / 4,
    capsules: FRAMES_PER_SECOND / 2,
};

/// The skirt on which methods are compared: of the paper's kind, with few mass points and springs
/// soft enough for its step, since the paper names no constant.
fn design() -> Design {
    let mut design = Design::default();
    design.skirt.gather_ratio = 1.3;
    design.skirt.column_count = 32;
    design.skirt.row_count = 18;
    design.fabric.stretch_warp_n_per_m = Some(60.0);
    design.fabric.stretch_weft_n_per_m = Some(60.0);
    design.fabric.shear_n_per_m = Some(20.0);
    design.fabric.drag_per_s = Some(10.0);
    design.method.name = MethodName::FbEuler;
    design
}

/// Runs the command.
pub(crate) fn run(args: &StudyArgs, language: Language) -> Result<(), Failure> {
    let stop = stop_flag().map_err(Failure::Run)?;
    let mut output = OutputFolder::create(&args.out).map_err(Failure::Usage)?;
    let started = Stopwatch::start();
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let threads = args
        .threads
        .map_or_else(|| cores.min(MOST_THREADS), usize::from);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(Failure::error)?;
    let study = Study {
        runner: Runner {
            pool: &pool,
            stop: &stop,
        },
        lengths: if args.quick { QUICK } else { FULL },
        is_quick: args.quick,
        language,
    };
    let (mut report, panels) = study.perform(threads)?;
    let bar = progress_bar(2, language.pick("描く", "drawing"));
    let picture = picture::draw(&panels).map_err(Failure::Run)?;
    bar.inc(1);
    report.findings = findings::of(&report);
    report.seconds = started.read().wall_seconds;
    let json = write(&mut output, &report, &picture)?;
    let paths = output.finish().map_err(Failure::Run)?;
    bar.finish_and_clear();
    if args.json {
        summary::print_json(&json);
    } else {
        summary::print_study(&report, &paths, language);
    }
    Ok(())
}

/// Writes the files of the study; what one of them holds as JSON.
fn write(
    output: &mut OutputFolder,
    report: &StudyReport,
    picture: &picture::Picture,
) -> Result<String, Failure> {
    let size = picture.size;
    let image =
        still::ImageView::new(size.width, size.height, &picture.pixels).map_err(Failure::error)?;
    let png = still::encode_png(image).map_err(Failure::error)?;
    let jpeg = still::encode_jpeg(image, PICTURE_QUALITY).map_err(Failure::error)?;
    let json = study_json(report).map_err(Failure::error)?;
    let page = study_html(report, &jpeg);
    let table = study_csv(report);
    let files: [(&str, &[u8]); 4] = [
        ("study.html", page.as_bytes()),
        ("study.json", json.as_bytes()),
        ("study.csv", table.as_bytes()),
        ("study.png", &png),
    ];
    for (name, bytes) in files {
        output.write(name, bytes).map_err(Failure::Run)?;
    }
    Ok(json)
}

struct Study<'a> {
    runner: Runner<'a>,
    lengths: Lengths,
    is_quick: bool,
    language: Language,
}

impl Study<'_> {
    /// Everything but the findings; and what is drawn.
    fn perform(&self, threads: usize) -> Result<(StudyReport, Vec<Panel>), Failure> {
        let design = design();
        let bar = self.bar(1, words("布をなじませる", "settling"));
        let settled = self.runner.settled(&design)?;
        bar.finish_and_clear();
        let (mode, skirt) = thresholds::highest_mode(&settled).map_err(Failure::Run)?;
        let stable_steps = settled.substep_count();
        let shared_steps = SHARED_STEPS * stable_steps;
        let film = film_skirt().map_err(Failure::Run)?;
        let mut report = StudyReport {
            lole: env!("CARGO_PKG_VERSION").to_owned(),
            quick: self.is_quick,
            threads,
            dance_step: design.motion.step.id().to_owned(),
            bpm: design.motion.tempo_bpm,
            film_skirt: film,
            ..StudyReport::default()
        };
        self.limits(&settled, &mode, &mut report)?;
        let panels = self.at_shared_step(&settled, shared_steps, &mut report)?;
        report.skirt = skirt;
        self.at_own_step(&settled, stable_steps, &mut report)?;
        self.causes(&settled, shared_steps, &mut report)?;
        self.by_step(&settled, stable_steps, &mut report)?;
        self.capsules(&mut report)?;
        cost_ratios(&mut report);
        Ok((report, panels))
    }

    /// How long a step each method takes before it bursts.
    fn limits(
        &self,
        settled: &Performance,
        mode: &HighestMode,
        report: &mut StudyReport,
    ) -> Result<(), Failure> {
        let bar = self.bar(METHODS.len(), words("安定の限界", "limits"));
        for method in &METHODS {
            self.runner.check_stop()?;
            let entry = IntegratorEntry {
                order: method.order,
                evaluations_per_step: method.integrator().evaluations_per_step(),
                threshold: thresholds::measure(settled, mode, method).map_err(Failure::Run)?,
                paper: method.paper.to_owned(),
                ..IntegratorEntry::default()
            };
            let id = method.name.id().to_owned();
            report.integrators.insert(id, entry);
            bar.inc(1);
        }
        bar.finish_and_clear();
        Ok(())
    }

    /// Bodies of more and more capsules.
    fn capsules(&self, report: &mut StudyReport) -> Result<(), Failure> {
        let bar = self.bar(capsules::BODIES.len(), words("カプセルの数", "capsules"));
        for body in &capsules::BODIES {
            let (entry, skirt) = capsules::measure(&self.runner, *body, self.lengths.capsules)?;
            report.capsules.push(entry);
            report.capsule_skirt = skirt;
            bar.inc(1);
        }
        bar.finish_and_clear();
        Ok(())
    }

    fn bar(&self, length: usize, message: Words) -> indicatif::ProgressBar {
        let length = u32::try_from(length).unwrap_or(u32::MAX);
        progress_bar(length, message.text(self.language))
    }

    /// Every method at the same step.
    fn at_shared_step(
        &self,
        settled: &Performance,
        steps: u32,
        report: &mut StudyReport,
    ) -> Result<Vec<Panel>, Failure> {
        let bar = self.bar(METHODS.len(), words("同じ刻み", "same step"));
        let mut panels = Vec::new();
        for method in &METHODS {
            let run = self.run(settled, method.integrator(), steps, self.lengths.shared)?;
            if let Some(entry) = report.integrators.get_mut(method.name.id()) {
                entry.same_step = run.entry.clone();
            }
            panels.push(Panel {
                method: method.name,
                paper: method.paper,
                entry: run.entry,
                performance: run.last,
            });
            bar.inc(1);
        }
        bar.finish_and_clear();
        Ok(panels)
    }

    /// Every method at a step that it can bear, and what the film's skirt would cost.
    fn at_own_step(
        &self,
        settled: &Performance,
        stable_steps: u32,
        report: &mut StudyReport,
    ) -> Result<(), Failure> {
        let bar = self.bar(METHODS.len(), words("自分の刻み", "own step"));
        let (skirt, film) = (report.skirt.clone(), report.film_skirt.clone());
        for method in &METHODS {
            let Some(steps) = own_steps(method, &skirt) else {
                continue;
            };
            let steps = if method.name == MethodName::FbEuler {
                stable_steps
            } else {
                steps
            };
            let run = self.run(settled, method.integrator(), steps, self.lengths.own)?;
            if let Some(entry) = report.integrators.get_mut(method.name.id()) {
                if let Some(film_steps) = own_steps(method, &film) {
                    let size = film.particles as f64 / skirt.particles as f64;
                    let steps = f64::from(film_steps);
                    entry.film_frame_ms_extrapolated = run.entry.step_ms * size * steps;
                    entry.film_step_s_extrapolated = f64::from(FRAME_SECONDS) / steps;
                }
                entry.own_step = run.entry;
            }
            bar.inc(1);
        }
        bar.finish_and_clear();
        Ok(())
    }

    /// The classical method with the departures of the print, one at a time and together.
    fn causes(
        &self,
        settled: &Performance,
        steps: u32,
        report: &mut StudyReport,
    ) -> Result<(), Failure> {
        let bar = self.bar(CAUSES.len(), words("原因", "causes"));
        for cause in &CAUSES {
            let setup = Setup {
                integrator: Integrator::RungeKutta(cause.method),
                contact_evaluation: cause.contact,
                steps_per_frame: whole_steps(steps / cause.steps_over),
            };
            let run = self.runner.run(settled, setup, self.lengths.shared)?;
            report.causes.push(CauseEntry {
                name: cause.name.to_owned(),
                what: Remark {
                    sentence: cause.what.english.to_owned(),
                    sentence_ja: cause.what.japanese.to_owned(),
                },
                same_step: run.entry,
            });
            bar.inc(1);
        }
        bar.finish_and_clear();
        Ok(())
    }

    /// Euler's and the printed method at ever smaller steps.
    fn by_step(
        &self,
        settled: &Performance,
        stable_steps: u32,
        report: &mut StudyReport,
    ) -> Result<(), Failure> {
        let methods = METHODS
            .iter()
            .filter(|method| matches!(method.name, MethodName::Euler | MethodName::RkAsPrinted));
        let bar = self.bar(2 * STEP_RATIOS.len(), words("刻みと発散", "step sizes"));
        for method in methods {
            for ratio in STEP_RATIOS {
                let steps = ratio * stable_steps;
                let run = self.run(settled, method.integrator(), steps, self.lengths.steps)?;
                report.steps.push(StepEntry {
                    method: method.name.id().to_owned(),
                    phase: report.skirt.highest_frequency_rad_per_s * run.entry.step_s,
                    run: run.entry,
                });
                bar.inc(1);
            }
        }
        bar.finish_and_clear();
        Ok(())
    }

    fn run(
        &self,
        settled: &Performance,
        integrator: Integrator,
        steps: u32,
        frames: u32,
    ) -> Result<Run, Failure> {
        let setup = Setup {
            integrator,
            contact_evaluation: ContactEvaluation::PerStage,
            steps_per_frame: whole_steps(steps),
        };
        self.runner.run(settled, setup, frames)
    }
}

/// One departure of the print from the classical method.
struct Cause {
    name: &'static str,
    what: Words,
    method: RungeKutta,
    contact: ContactEvaluation,
    /// The shared step is this many times as long.
    steps_over: u32,
}

const CAUSES: [Cause; 8] = [
    Cause {
        name: "classical",
        what: words(
            "古典的な4次のルンゲ・クッタ法",
            "the classical method, nothing switched",
        ),
        method: RungeKutta::CLASSICAL,
        contact: ContactEvaluation::PerStage,
        steps_over: 1,
    },
    Cause {
        name: "printed-stage-4",
        what: words("4段目を印刷のまま（kx₃/2）", "stage 4 as printed (kx₃ / 2)"),
        method: RungeKutta {
            last_stage: LastStage::Half,
            ..RungeKutta::CLASSICAL
        },
        contact: ContactEvaluation::PerStage,
        steps_over: 1,
    },
    Cause {
        name: "frozen-damping",
        what: words("減衰を v(t) に固定", "damping frozen at v(t)"),
        method: RungeKutta {
            damping: StageDamping::Frozen,
            ..RungeKutta::CLASSICAL
        },
        contact: ContactEvaluation::PerStage,
        steps_over: 1,
    },
    Cause {
        name: "double-counting",
        what: words(
            "重力と抵抗を二重に数える（11/6 g）",
            "gravity and resistance counted twice (11/6 g)",
        ),
        method: RungeKutta {
            counting: Counting::Twice,
            ..RungeKutta::CLASSICAL
        },
        contact: ContactEvaluation::PerStage,
        steps_over: 1,
    },
    Cause {
        name: "contact-once-a-step",
        what: words(
            "接触を1ステップに1回だけ調べる",
            "contact looked at once a step",
        ),
        method: RungeKutta::CLASSICAL,
        contact: ContactEvaluation::PerStep,
        steps_over: 1,
    },
    Cause {
        name: "longer-step",
        what: words(
            "刻みを6倍に（FB 法の限界）",
            "the step six times as long (the limit of FB Euler)",
        ),
        method: RungeKutta::CLASSICAL,
        contact: ContactEvaluation::PerStage,
        steps_over: SHARED_STEPS,
    },
    Cause {
        name: "as-printed",
        what: words(
            "印刷のまま、接触は各段で",
            "all as printed, contact in every stage",
        ),
        method: RungeKutta::AS_PRINTED,
        contact: ContactEvaluation::PerStage,
        steps_over: 1,
    },
    Cause {
        name: "as-printed-contact-once",
        what: words(
            "印刷のまま、接触は1回だけ",
            "all as printed, contact once a step",
        ),
        method: RungeKutta::AS_PRINTED,
        contact: ContactEvaluation::PerStep,
        steps_over: 1,
    },
];

/// The stable step of a method on a skirt in theory [s].
fn own_limit(method: &Method, skirt: &SkirtOfStudy) -> Option<f64> {
    stability_limit(
        method.integrator(),
        skirt.highest_frequency_rad_per_s,
        skirt.damping_per_s,
    )
}

/// Steps of a frame that a method needs on a skirt, with a margin; `None` where it bears no step.
fn own_steps(method: &Method, skirt: &SkirtOfStudy) -> Option<u32> {
    let limit = own_limit(method, skirt)?;
    Some(whole(f64::from(FRAME_SECONDS) / (OWN_SHARE * limit)))
}

/// The film's skirt, of which only its size and its frequency are needed.
fn film_skirt() -> anyhow::Result<SkirtOfStudy> {
    let production = Production::new(&Design::default())?;
    let skirt = (production.skirt()).ok_or_else(|| anyhow::anyhow!("no skirt is worn"))?;
    let model = ReferenceModel::new(&skirt.sewn.spec)?;
    Ok(SkirtOfStudy {
        particles: model.masses().len(),
        springs: model.spring_count(),
        damping_per_s: model.drag_rate(),
        highest_frequency_rad_per_s: model.largest_frequency_bound(),
    })
}

/// What a step costs against one of `fb-euler`.
fn cost_ratios(report: &mut StudyReport) {
    let unit = report
        .integrators
        .get(MethodName::FbEuler.id())
        .map_or(0.0, |entry| entry.same_step.step_ms);
    if unit <= 0.0 {
        return;
    }
    let runs = report
        .integrators
        .values_mut()
        .flat_map(|entry| [&mut entry.same_step, &mut entry.own_step])
        .chain(report.causes.iter_mut().map(|cause| &mut cause.same_step))
        .chain(report.steps.iter_mut().map(|step| &mut step.run));
    for run in runs {
        run.cost_of_step = run.step_ms / unit;
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "clamped to the range of u32"
)]
fn whole(count: f64) -> u32 {
    count.ceil().clamp(1.0, f64::from(u32::MAX)) as u32
}

fn whole_steps(count: u32) -> NonZeroU32 {
    NonZeroU32::new(count).unwrap_or(NonZeroU32::MIN)
}
