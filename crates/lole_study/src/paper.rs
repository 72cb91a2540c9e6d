//! The paper's experiment with numbers.
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
    ContactEvaluation, Counting, Integrator, LastStage, RungeKutta, StageDamping, stability_limit,
};
use lole_cloth::method::reference::ReferenceModel;
use lole_costume::document::{Design, MethodName};
use lole_export::report::Remark;
use lole_export::study::{CauseEntry, IntegratorEntry, SkirtOfStudy, StepEntry, StudyReport};
use lole_language::{Words, words};
use lole_stage::{FRAME_SECONDS, FRAMES_PER_SECOND, Performance, Production};

use crate::{Clock, StudyError};
use methods::{METHODS, Method};
pub use picture::{ComparedPanel, draw};
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
pub const MOST_THREADS: usize = 2;

/// Who waits for the study: is told how far it is, and may call it off.
pub trait Audience {
    /// A part of so many runs begins.
    fn begin(&self, part: Words, run_count: usize);
    /// One run of the part is done.
    fn advance(&self);
    /// The part is done.
    fn end(&self);
    /// Whether the study shall go on.
    fn waits(&self) -> bool;
}

/// How much of the study is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// Every part as long as its figures need: several minutes.
    Full,
    /// Shorter parts: under a minute.
    Quick,
}

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

/// Runs the study on the threads of `pool`; what was found, but for the time it took, and what is drawn of it.
///
/// # Errors
/// A study that was called off, or whose skirt cannot be built.
pub fn perform(
    pool: &rayon::ThreadPool,
    audience: &dyn Audience,
    clock: &dyn Clock,
    extent: Extent,
) -> Result<(StudyReport, Vec<ComparedPanel>), StudyError> {
    let study = Study {
        runner: Runner {
            pool,
            audience,
            clock,
        },
        extent,
    };
    let (mut report, panels) = study.perform()?;
    report.findings = findings::of(&report);
    Ok((report, panels))
}

struct Study<'a> {
    runner: Runner<'a>,
    extent: Extent,
}

impl Study<'_> {
    const fn lengths(&self) -> &'static Lengths {
        match self.extent {
            Extent::Full => &FULL,
            Extent::Quick => &QUICK,
        }
    }

    /// Everything but the findings; and what is drawn.
    fn perform(&self) -> Result<(StudyReport, Vec<ComparedPanel>), StudyError> {
        let (design, audience) = (design(), self.runner.audience);
        audience.begin(words("布をなじませる", "settling"), 1);
        let settled = self.runner.settled(&design)?;
        audience.end();
        let (mode, skirt) = thresholds::highest_mode(&settled)?;
        let stable_steps = settled.substep_count();
        let shared_steps = SHARED_STEPS * stable_steps;
        let film = film_skirt()?;
        let mut report = StudyReport {
            lole: env!("CARGO_PKG_VERSION").to_owned(),
            quick: self.extent == Extent::Quick,
            threads: self.runner.pool.current_num_threads(),
            dance_step: design.motion.step.id().to_owned(),
            bpm: design.motion.tempo_bpm,
            film_skirt: film,
            ..StudyReport::default()
        };
        audience.begin(words("安定の限界", "limits"), METHODS.len());
        for method in &METHODS {
            self.runner.check_stop()?;
            let entry = IntegratorEntry {
                order: method.order,
                evaluations_per_step: method.integrator().evaluations_per_step(),
                threshold: thresholds::measure(&settled, &mode, method)?,
                paper: method.paper.to_owned(),
                ..IntegratorEntry::default()
            };
            report
                .integrators
                .insert(method.name.id().to_owned(), entry);
            audience.advance();
        }
        audience.end();
        let panels = self.at_shared_step(&settled, shared_steps, &mut report)?;
        report.skirt = skirt;
        self.at_own_step(&settled, stable_steps, &mut report)?;
        self.causes(&settled, shared_steps, &mut report)?;
        self.by_step(&settled, stable_steps, &mut report)?;
        audience.begin(words("カプセルの数", "capsules"), capsules::BODIES.len());
        for body in &capsules::BODIES {
            let (entry, skirt) = capsules::measure(&self.runner, *body, self.lengths().capsules)?;
            report.capsules.push(entry);
            report.capsule_skirt = skirt;
            audience.advance();
        }
        audience.end();
        cost_ratios(&mut report);
        Ok((report, panels))
    }

    /// Every method at the same step.
    fn at_shared_step(
        &self,
        settled: &Performance,
        steps: u32,
        report: &mut StudyReport,
    ) -> Result<Vec<ComparedPanel>, StudyError> {
        let audience = self.runner.audience;
        audience.begin(words("同じ刻み", "same step"), METHODS.len());
        let mut panels = Vec::new();
        for method in &METHODS {
            let run = self.run(settled, method.integrator(), steps, self.lengths().shared)?;
            if let Some(entry) = report.integrators.get_mut(method.name.id()) {
                entry.same_step = run.entry.clone();
            }
            panels.push(ComparedPanel {
                method: method.name,
                paper: method.paper,
                entry: run.entry,
                performance: run.last,
            });
            audience.advance();
        }
        audience.end();
        Ok(panels)
    }

    /// Every method at a step that it can bear, and what the film's skirt would cost.
    fn at_own_step(
        &self,
        settled: &Performance,
        stable_steps: u32,
        report: &mut StudyReport,
    ) -> Result<(), StudyError> {
        let audience = self.runner.audience;
        audience.begin(words("自分の刻み", "own step"), METHODS.len());
        let (skirt, film) = (report.skirt.clone(), report.film_skirt.clone());
        for method in &METHODS {
            let own_steps = |skirt: &SkirtOfStudy| {
                let limit = own_limit(method, skirt)?;
                Some(whole(f64::from(FRAME_SECONDS) / (OWN_SHARE * limit)))
            };
            let Some(steps) = own_steps(&skirt) else {
                continue;
            };
            let steps = if method.name == MethodName::FbEuler {
                stable_steps
            } else {
                steps
            };
            let run = self.run(settled, method.integrator(), steps, self.lengths().own)?;
            if let Some(entry) = report.integrators.get_mut(method.name.id()) {
                if let Some(film_steps) = own_steps(&film) {
                    let size = film.particles as f64 / skirt.particles as f64;
                    let steps = f64::from(film_steps);
                    entry.film_frame_ms_extrapolated = run.entry.step_ms * size * steps;
                    entry.film_step_s_extrapolated = f64::from(FRAME_SECONDS) / steps;
                }
                entry.own_step = run.entry;
            }
            audience.advance();
        }
        audience.end();
        Ok(())
    }

    /// The classical method with the departures of the print, one at a time and together.
    fn causes(
        &self,
        settled: &Performance,
        steps: u32,
        report: &mut StudyReport,
    ) -> Result<(), StudyError> {
        let audience = self.runner.audience;
        audience.begin(words("原因", "causes"), CAUSES.len());
        for cause in &CAUSES {
            let setup = Setup {
                integrator: Integrator::RungeKutta(cause.method),
                contact_evaluation: cause.contact,
                steps_per_frame: whole_steps(steps / cause.steps_over),
            };
            let run = self.runner.run(settled, setup, self.lengths().shared)?;
            report.causes.push(CauseEntry {
                name: cause.name.to_owned(),
                what: Remark {
                    sentence: cause.what.english.to_owned(),
                    sentence_ja: cause.what.japanese.to_owned(),
                },
                same_step: run.entry,
            });
            audience.advance();
        }
        audience.end();
        Ok(())
    }

    /// Euler's and the printed method at ever smaller steps.
    fn by_step(
        &self,
        settled: &Performance,
        stable_steps: u32,
        report: &mut StudyReport,
    ) -> Result<(), StudyError> {
        let audience = self.runner.audience;
        let methods = METHODS
            .iter()
            .filter(|method| matches!(method.name, MethodName::Euler | MethodName::RkAsPrinted));
        audience.begin(words("刻みと発散", "step sizes"), 2 * STEP_RATIOS.len());
        for method in methods {
            for ratio in STEP_RATIOS {
                let steps = ratio * stable_steps;
                let run = self.run(settled, method.integrator(), steps, self.lengths().steps)?;
                report.steps.push(StepEntry {
                    method: method.name.id().to_owned(),
                    phase: report.skirt.highest_frequency_rad_per_s * run.entry.step_s,
                    run: run.entry,
                });
                audience.advance();
            }
        }
        audience.end();
        Ok(())
    }

    fn run(
        &self,
        settled: &Performance,
        integrator: Integrator,
        steps: u32,
        frames: u32,
    ) -> Result<Run, StudyError> {
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

/// The film's skirt, of which only its size and its frequency are needed.
fn film_skirt() -> Result<SkirtOfStudy, StudyError> {
    let production = Production::new(&Design::default())?;
    let skirt = production.skirt().ok_or(StudyError::NoSkirt)?;
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
