//! What a study found, as plain numbers.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::report::{MeanPercentileMax, MedianPercentile, Remark};

/// The whole study.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct StudyReport {
    /// Version of the program that ran.
    pub lole: String,
    /// Whether it was the short one.
    pub quick: bool,
    /// Threads the cloth was computed on.
    pub threads: usize,
    /// Name of the dance step.
    pub dance_step: String,
    /// Counts per minute.
    pub bpm: f64,
    /// The small skirt of the paper's kind on which the methods are compared.
    pub skirt: SkirtOfStudy,
    /// The gathered skirt on which bodies of capsules are compared.
    pub capsule_skirt: SkirtOfStudy,
    /// The film's skirt, whose cost is extrapolated.
    pub film_skirt: SkirtOfStudy,
    /// By name: `euler`, `fb-euler`, `rk4`, `rk-as-printed`, `rk-double-counted`.
    pub integrators: BTreeMap<String, IntegratorEntry>,
    /// The switches of the print, one at a time.
    pub causes: Vec<CauseEntry>,
    /// What becomes of Euler's and the printed method as the step shrinks.
    pub steps: Vec<StepEntry>,
    /// The body by number of capsules, and as two cylinders.
    pub capsules: Vec<CapsulesEntry>,
    /// What the paper says beside what was measured.
    pub findings: Vec<Finding>,
    /// How long it all took [s].
    pub seconds: f64,
}

/// A skirt in numbers.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct SkirtOfStudy {
    /// Mass points.
    pub particles: usize,
    /// Springs and bending terms.
    pub springs: usize,
    /// Damping `c` [1/s] of equation (3), per mass.
    pub damping_per_s: f64,
    /// Highest angular frequency [rad/s] of the flat cloth: measured by its highest mode, of the
    /// film's a bound from above.
    pub highest_frequency_rad_per_s: f64,
}

/// One integrator.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct IntegratorEntry {
    /// Order of accuracy in theory, without and with damping.
    pub order: [u32; 2],
    /// Evaluations of all forces in one step.
    pub evaluations_per_step: u32,
    /// The largest stable step.
    pub threshold: Threshold,
    /// At the step that all share, a sixth of what keeps `fb-euler` stable.
    pub same_step: RunEntry,
    /// At its own stable step.
    pub own_step: RunEntry,
    /// Extrapolated, not run: processor time of one frame of the film's skirt at its own stable
    /// step [ms].
    pub film_frame_ms_extrapolated: f64,
    /// Extrapolated, not run: the step for it [s].
    pub film_step_s_extrapolated: f64,
    /// What the paper says of it; empty where it says nothing.
    pub paper: String,
}

/// The largest stable step of one integrator on the small skirt.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Threshold {
    /// Damping over frequency, `c / ω`, at which it was measured.
    pub damping_ratio: f64,
    /// Formula of the theory.
    pub formula: String,
    /// `ω Δt` in theory; `None` where no step is stable.
    pub theory: Option<f64>,
    /// `ω Δt` measured by the growth of the highest mode.
    pub measured: Option<f64>,
}

/// One run.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct RunEntry {
    /// `stable`, `penetrating` or `diverged`.
    pub outcome: String,
    /// When it diverged, from the start of the dance [s].
    pub diverged_at_s: Option<f64>,
    /// The first particle that left.
    pub diverged_particle: Option<usize>,
    /// The step [s].
    pub step_s: f64,
    /// Steps of one frame.
    pub steps_per_frame: u32,
    /// Frames that were computed.
    pub frames: usize,
    /// Absolute strain of structural edges, worst over the run [%].
    pub strain_pct: MeanPercentileMax,
    /// Deepest particle in a capsule over the run [mm].
    pub penetration_mm: f64,
    /// Most particles deeper than half a millimeter in a capsule at one moment.
    pub penetrating_particles: usize,
    /// Deepest cloth in the drawn body over the run [mm].
    pub skin_mm: f64,
    /// Processor time of a frame [ms].
    pub frame_ms: MedianPercentile,
    /// Processor time of a step [ms].
    pub step_ms: f64,
    /// Evaluations of all forces in the run.
    pub force_evaluations: u64,
    /// Cost of a step over that of `fb-euler` on the same skirt.
    pub cost_of_step: f64,
    /// The run frame by frame.
    pub series: RunCurves,
}

/// A run frame by frame.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct RunCurves {
    /// From the start of the dance [s].
    pub time_s: Vec<f64>,
    /// Energy of motion, springs, bending and height [J].
    pub energy_j: Vec<f64>,
    /// 99th percentile of the strain [%].
    pub strain_p99_pct: Vec<f64>,
    /// Deepest particle in a capsule [mm].
    pub penetration_mm: Vec<f64>,
}

/// One switch of the print.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct CauseEntry {
    /// Name for programs, such as `printed-stage-4`.
    pub name: String,
    /// What was switched.
    pub what: Remark,
    /// At the step that all share.
    pub same_step: RunEntry,
}

/// One method at one step.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct StepEntry {
    /// Name of the method.
    pub method: String,
    /// The step times the highest frequency of the skirt.
    pub phase: f64,
    /// The run.
    pub run: RunEntry,
}

/// One body of capsules.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct CapsulesEntry {
    /// `capsules`, `two-cylinders` or `skin`.
    pub body: String,
    /// Capsules.
    pub count: usize,
    /// Deepest cloth in the drawn body over the run [mm].
    pub skin_mm: f64,
    /// Mean over the frames of the deepest cloth in the drawn body [mm].
    pub skin_mean_mm: f64,
    /// Most vertices that lie wrongly at one moment: cloth in the body, or body outside the cloth.
    pub wrong_vertices: u32,
    /// Processor time of a frame [ms].
    pub frame_ms: MedianPercentile,
}

/// What the paper says beside what was measured.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Finding {
    /// What the paper says.
    pub paper: String,
    /// Whether the measurement agrees.
    pub agrees: bool,
    /// What was measured, and the cause where it differs.
    pub measured: Remark,
}
