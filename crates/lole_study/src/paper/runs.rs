//! One run of the study: a settled skirt, a method, a step, and what comes of it.

use std::num::NonZeroU32;

use glam::Vec3;
use lole_cloth::diagnose;
use lole_cloth::method::explicit::{ContactEvaluation, Integrator, Substeps};
use lole_costume::document::Design;
use lole_export::report::MeanPercentileMax;
use lole_export::study::{RunCurves, RunEntry};
use lole_stage::{FRAME_SECONDS, Performance, Production};

use super::Audience;
use crate::figures::{median_and_p99, percent};
use crate::{Clock, Stopwatch, StudyError};

/// Frames from one look at the skin to the next: looking takes longer than a frame.
const FRAMES_PER_LOOK: usize = 2;
/// Cloth deeper than this in capsule or skin [mm] is seen to penetrate: a soft contact on cells of
/// four centimeters leaves half of it.
const PENETRATING_MM: f64 = 10.0;
/// Depth [m] from which a particle counts as penetrating.
const COUNTED_DEPTH: f32 = 0.0005;

/// Cloth farther from the middle of the cloth than this [m] has flown out of the picture.
const SEEN_SPREAD: f32 = 1.4;

/// What runs share.
pub(crate) struct Runner<'a> {
    pub(crate) pool: &'a rayon::ThreadPool,
    pub(crate) audience: &'a dyn Audience,
    pub(crate) clock: &'a dyn Clock,
}

/// A method and its step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Setup {
    pub(crate) integrator: Integrator,
    pub(crate) contact_evaluation: ContactEvaluation,
    pub(crate) steps_per_frame: NonZeroU32,
}

/// What a run left.
pub(crate) struct Run {
    pub(crate) entry: RunEntry,
    /// The last moment at which all cloth was near its dancer.
    pub(crate) last: Performance,
}

impl Runner<'_> {
    /// The performance of `design` at the start of its dance, its skirt hanging still.
    pub(crate) fn settled(&self, design: &Design) -> Result<Performance, StudyError> {
        let production = Production::new(design)?;
        let mut performance = Performance::new(production)?;
        while performance.time() < 0.0 {
            self.check_stop()?;
            let advanced = self.pool.install(|| performance.advance());
            if advanced.is_err() {
                return Err(StudyError::Unsettled);
            }
        }
        Ok(performance)
    }

    /// Dances `frame_count` frames from `start`.
    pub(crate) fn run(
        &self,
        start: &Performance,
        setup: Setup,
        frame_count: u32,
    ) -> Result<Run, StudyError> {
        let mut performance = start.clone();
        performance.tune_explicit(|_, config| {
            config.integrator = setup.integrator;
            config.contact_evaluation = setup.contact_evaluation;
            config.substeps = Substeps::Fixed(setup.steps_per_frame);
        });
        let steps = setup.steps_per_frame.get();
        let mut log = Log::new(steps);
        let mut last = performance.clone();
        log.look(&mut last, 0.0);
        for frame in 0..frame_count as usize {
            self.check_stop()?;
            let watch = Stopwatch::start(self.clock);
            let advanced = self.pool.install(|| performance.advance());
            log.frame_ms.push(1e3 * watch.read().process_seconds);
            let time = (frame + 1) as f64 * f64::from(FRAME_SECONDS);
            if let Err(divergence) = advanced {
                let columns = performance.production().garments[0]
                    .sewn
                    .spec
                    .grid
                    .column_count;
                let particle = divergence.row * columns + divergence.column;
                log.entry.diverged_at_s = Some(time);
                log.entry.diverged_particle = Some(particle as usize);
                break;
            }
            if (frame + 1) % FRAMES_PER_LOOK == 0 {
                log.look(&mut performance, time);
            }
            if spread(&performance) < SEEN_SPREAD {
                last = performance.clone();
            }
        }
        let evaluations = u64::from(steps) * u64::from(setup.integrator.evaluations_per_step());
        last.pose_body();
        Ok(Run {
            entry: log.finish(evaluations),
            last,
        })
    }

    pub(crate) fn check_stop(&self) -> Result<(), StudyError> {
        if self.audience.waits() {
            Ok(())
        } else {
            Err(StudyError::CalledOff)
        }
    }
}

/// Distance [m] of the farthest particle from the middle of the capsules.
fn spread(performance: &Performance) -> f32 {
    let capsules = performance.capsules();
    let middle =
        capsules.iter().map(|capsule| capsule.ends[0]).sum::<Vec3>() / capsules.len().max(1) as f32;
    performance
        .cloth_positions()
        .iter()
        .map(|position| position.distance(middle))
        .fold(0.0, f32::max)
}

/// What a run is judged by, as it goes.
struct Log {
    entry: RunEntry,
    frame_ms: Vec<f64>,
}

impl Log {
    fn new(steps_per_frame: u32) -> Self {
        Self {
            entry: RunEntry {
                step_s: f64::from(FRAME_SECONDS) / f64::from(steps_per_frame),
                steps_per_frame,
                ..RunEntry::default()
            },
            frame_ms: Vec::new(),
        }
    }

    /// Measures the current frame at `time` [s].
    fn look(&mut self, performance: &mut Performance, time: f64) {
        performance.pose_body();
        let metrics = performance.measure();
        let spec = &performance.production().garments[0].sewn.spec;
        let count = diagnose::penetrating_count(
            spec,
            performance.cloth_positions(),
            performance.capsules(),
            COUNTED_DEPTH,
        );
        let entry = &mut self.entry;
        let strain = percent(metrics.strain);
        entry.strain_pct = MeanPercentileMax {
            mean: entry.strain_pct.mean.max(strain.mean),
            p99: entry.strain_pct.p99.max(strain.p99),
            max: entry.strain_pct.max.max(strain.max),
        };
        let penetration = 1e3 * f64::from(metrics.capsule_penetration);
        entry.penetration_mm = entry.penetration_mm.max(penetration);
        entry.penetrating_particles = entry.penetrating_particles.max(count);
        entry.skin_mm = entry.skin_mm.max(1e3 * f64::from(metrics.skin.worst_depth));
        let RunCurves {
            time_s,
            energy_j,
            strain_p99_pct,
            penetration_mm,
        } = &mut entry.series;
        time_s.push(time);
        energy_j.push(
            performance
                .energy()
                .map_or(f64::NAN, |energy| energy.total()),
        );
        strain_p99_pct.push(strain.p99);
        penetration_mm.push(penetration);
    }

    /// The whole run, of `evaluations` of the forces a frame.
    fn finish(mut self, evaluations: u64) -> RunEntry {
        let entry = &mut self.entry;
        entry.frames = self.frame_ms.len();
        entry.force_evaluations = evaluations * entry.frames as u64;
        entry.frame_ms = median_and_p99(&self.frame_ms);
        entry.step_ms = entry.frame_ms.median / f64::from(entry.steps_per_frame);
        let is_deep = PENETRATING_MM < entry.skin_mm.max(entry.penetration_mm);
        entry.outcome = match (entry.diverged_at_s, is_deep) {
            (Some(_), _) => "diverged",
            (None, true) => "penetrating",
            (None, false) => "stable",
        }
        .to_owned();
        self.entry
    }
}
