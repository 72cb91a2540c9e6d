//! What `lole study` found: numbers for programs, a table for spreadsheets, a page for people.

mod html;
mod model;

use std::fmt::Write as _;

pub use model::{
    CapsulesEntry, CauseEntry, Finding, IntegratorEntry, RunCurves, RunEntry, SkirtOfStudy,
    StepEntry, StudyReport, Threshold,
};

use lole_language::visible;

use crate::ExportError;

/// `study.json`: indented; a number that is not finite becomes `null`.
///
/// # Errors
/// [`ExportError::Encoding`] when it cannot be written as JSON.
pub fn study_json(report: &StudyReport) -> Result<String, ExportError> {
    serde_json::to_string_pretty(report)
        .map(|text| text + "\n")
        .map_err(|error| ExportError::Encoding {
            file: "study.json",
            cause: error.to_string(),
        })
}

/// `study.html`: one self-contained page in Japanese and English; `picture_jpeg` shows the skirts
/// side by side.
#[must_use]
pub fn study_html(report: &StudyReport, picture_jpeg: &[u8]) -> String {
    html::page(report, picture_jpeg)
}

/// `study.csv`: one line a run, RFC 4180 with a head line; empty where there is no value.
#[must_use]
pub fn study_csv(report: &StudyReport) -> String {
    let mut csv = String::from(
        "part,name,outcome,diverged_at_s,diverged_particle,step_s,steps_per_frame,frames,\
         strain_mean_pct,strain_p99_pct,strain_max_pct,penetration_mm,penetrating_particles,\
         skin_mm,frame_ms,frame_ms_p99,step_ms,force_evaluations,cost_of_step\r\n",
    );
    for (name, entry) in &report.integrators {
        append_run(&mut csv, "same step", name, &entry.same_step);
        append_run(&mut csv, "own step", name, &entry.own_step);
    }
    for cause in &report.causes {
        append_run(&mut csv, "cause", &cause.name, &cause.same_step);
    }
    for step in &report.steps {
        append_run(&mut csv, "step size", &step.method, &step.run);
    }
    for body in &report.capsules {
        let line = format!(
            "capsules,{},,,,,,,,,,,{},{},{},{},,,\r\n",
            cell(&format!("{} {}", body.count, body.body)),
            body.wrong_vertices,
            body.skin_mm,
            body.frame_ms.median,
            body.frame_ms.p99,
        );
        csv.push_str(&line);
    }
    csv
}

/// A text as one cell of a table: in quotation marks, and behind an apostrophe where a spreadsheet would compute it.
fn cell(text: &str) -> String {
    let text = visible(text);
    let is_computed = text.starts_with(['=', '+', '-', '@', '\t', '\n']);
    let apostrophe = if is_computed { "'" } else { "" };
    let is_plain = !is_computed && !text.contains([',', '"', '\n']);
    if is_plain {
        return text;
    }
    format!("\"{apostrophe}{}\"", text.replace('"', "\"\""))
}

/// One line of the table; a run that was not made leaves none.
fn append_run(csv: &mut String, part: &str, name: &str, run: &RunEntry) {
    if run.outcome.is_empty() {
        return;
    }
    let (part, name, outcome) = (cell(part), cell(name), cell(&run.outcome));
    let or_empty = |value: Option<String>| value.unwrap_or_default();
    let written = write!(
        csv,
        "{part},{name},{outcome},{},{},{:e},{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n",
        or_empty(run.diverged_at_s.map(|time| time.to_string())),
        or_empty(run.diverged_particle.map(|particle| particle.to_string())),
        run.step_s,
        run.steps_per_frame,
        run.frames,
        run.strain_pct.mean,
        run.strain_pct.p99,
        run.strain_pct.max,
        run.penetration_mm,
        run.penetrating_particles,
        run.skin_mm,
        run.frame_ms.median,
        run.frame_ms.p99,
        run.step_ms,
        run.force_evaluations,
        run.cost_of_step,
    );
    debug_assert!(written.is_ok(), "writing to a string cannot fail");
}
