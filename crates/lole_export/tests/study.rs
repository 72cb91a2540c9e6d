//! The study's files: well formed, complete, and free of what is not a number.

use lole_export::report::Remark;
use lole_export::study::{
    CapsulesEntry, CauseEntry, Finding, IntegratorEntry, RunEntry, StepEntry, StudyReport,
    study_csv, study_html, study_json,
};

fn run(outcome: &str) -> RunEntry {
    let mut run = RunEntry {
        outcome: outcome.to_owned(),
        diverged_at_s: (outcome == "diverged").then_some(0.25),
        diverged_particle: (outcome == "diverged").then_some(7),
        steps_per_frame: 102,
        ..RunEntry::default()
    };
    run.series.time_s = vec![0.0, 0.5, 1.0];
    run.series.energy_j = vec![0.1, 1e12, f64::INFINITY];
    run.series.strain_p99_pct = vec![1.0, 50.0, f64::NAN];
    run.series.penetration_mm = vec![0.0, 1.0, 2.0];
    run
}

fn study() -> StudyReport {
    let remark = Remark {
        sentence: "measured <so> & so".to_owned(),
        sentence_ja: "測った".to_owned(),
    };
    let mut report = StudyReport {
        dance_step: "kaholo".to_owned(),
        causes: vec![CauseEntry {
            name: "printed-stage-4".to_owned(),
            what: remark.clone(),
            same_step: run("penetrating"),
        }],
        steps: vec![StepEntry {
            method: "euler".to_owned(),
            phase: 0.1,
            run: run("diverged"),
        }],
        capsules: [1, 13]
            .map(|count| CapsulesEntry {
                body: "capsules".to_owned(),
                count,
                ..CapsulesEntry::default()
            })
            .to_vec(),
        findings: vec![Finding {
            paper: "the skirt \"flew\"".to_owned(),
            agrees: true,
            measured: remark,
        }],
        ..StudyReport::default()
    };
    for (name, outcome) in [
        ("euler", "diverged"),
        ("fb-euler", "stable"),
        ("rk4", "stable"),
    ] {
        let entry = IntegratorEntry {
            same_step: run(outcome),
            ..IntegratorEntry::default()
        };
        report.integrators.insert(name.to_owned(), entry);
    }
    report
}

#[test]
fn every_line_of_the_table_has_every_column() {
    let csv = study_csv(&study());
    let mut lines = csv.lines();
    let head = lines.next().map_or(0, |line| line.split(',').count());
    assert_eq!(head, 19);
    let rest: Vec<_> = lines.collect();
    // Three at the same step, none at their own, a cause, a step size, two bodies.
    assert_eq!(rest.len(), 3 + 1 + 1 + 2);
    for line in rest {
        assert_eq!(line.split(',').count(), head, "{line}");
    }
}

#[test]
fn the_numbers_have_an_entry_for_each_integrator_and_null_for_what_is_none() {
    let json = study_json(&study()).unwrap();
    let value: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(
        value["integrators"]["euler"]["same_step"]["outcome"],
        "diverged"
    );
    assert_eq!(
        value["integrators"]["euler"]["same_step"]["diverged_particle"],
        7
    );
    assert!(value["integrators"]["rk4"]["same_step"]["series"]["energy_j"][2].is_null());
}

#[test]
fn the_page_stands_alone_in_two_languages() {
    let page = study_html(&study(), b"jpeg");
    assert!(
        !page.contains("NaN") && !page.contains("inf<"),
        "not a number"
    );
    assert!(!page.contains("src=\"http") && !page.contains("href=\"http"));
    assert!(page.contains("measured &lt;so&gt; &amp; so") && page.contains("測った"));
    assert_eq!(
        page.matches("lang=\"en\"").count(),
        page.matches("lang=\"ja\"").count() - 1
    );
    for tag in ["table", "figure", "svg", "div", "ul", "tr"] {
        let opened = page.matches(&format!("<{tag}")).count();
        assert_eq!(opened, page.matches(&format!("</{tag}>")).count(), "{tag}");
    }
}
