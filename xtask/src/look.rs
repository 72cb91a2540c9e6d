//! Looks at the files of a `lole dance`: all there, of their kind, and the report complete.

use std::path::Path;
use std::process::ExitCode;

use anyhow::Context as _;
use serde_json::Value;

/// Files of a run with the bytes they hold from an offset on, which tell their kind.
const FILES: &[(&str, usize, &[u8])] = &[
    ("dance.mp4", 4, b"ftyp"),
    ("dancer.glb", 0, b"glTF"),
    ("front.png", 0, b"\x89PNG"),
    ("side.png", 0, b"\x89PNG"),
    ("back.png", 0, b"\x89PNG"),
    ("three-quarter.png", 0, b"\x89PNG"),
    ("counts.csv", 0, b"time_s,"),
    ("design.lole", 0, b"lole = 1"),
    ("report.html", 0, b"<!"),
    ("report.json", 0, b"{"),
];

/// Numbers that the report must hold, as JSON pointers.
const NUMBERS: &[&str] = &[
    "/particles",
    "/springs",
    "/substeps",
    "/threads",
    "/frames",
    "/frame_ms/median",
    "/frame_ms/p99",
    "/frame_wall_ms/median",
    "/frame_wall_ms/p99",
    "/realtime_factor",
    "/strain_pct/mean",
    "/strain_pct/p99",
    "/strain_pct/max",
    "/strain_end_pct/mean",
    "/strain_end_pct/p99",
    "/strain_end_pct/max",
    "/capsule_penetration_mm/worst",
    "/skin_penetration_mm/worst",
    "/skin_penetration_vertices/worst",
    "/hem_height_cm/min",
    "/hem_height_cm/mean",
    "/hem_height_cm/max",
];

pub(crate) fn run(folder: &Path) -> anyhow::Result<ExitCode> {
    let mut findings = Vec::new();
    for (name, offset, expected) in FILES {
        match std::fs::read(folder.join(name)) {
            Ok(bytes)
                if bytes
                    .get(*offset..)
                    .is_some_and(|rest| rest.starts_with(expected)) => {}
            Ok(bytes) => findings.push(format!(
                "{name}: {} bytes that are no such file",
                bytes.len()
            )),
            Err(error) => findings.push(format!("{name}: {error}")),
        }
    }
    let report = std::fs::read(folder.join("report.json")).context("report.json")?;
    let report: Value = serde_json::from_slice(&report).context("report.json")?;
    findings.extend(report_findings(&report));
    for file in report["files"].as_array().into_iter().flatten() {
        let name = file["name"].as_str().unwrap_or_default();
        let listed = file["bytes"].as_u64();
        let size = std::fs::metadata(folder.join(name))
            .map(|metadata| metadata.len())
            .ok();
        // The report cannot know its own size before it is written.
        if !name.starts_with("report.") && listed != size {
            findings.push(format!(
                "{name}: listed with {listed:?} bytes, found {size:?}"
            ));
        }
    }
    for finding in &findings {
        println!("{}: {finding}", folder.display());
    }
    if findings.is_empty() {
        println!("look: {} files, and the report is complete", FILES.len());
        return Ok(ExitCode::SUCCESS);
    }
    Ok(ExitCode::FAILURE)
}

fn report_findings(report: &Value) -> Vec<String> {
    let mut findings = Vec::new();
    for pointer in NUMBERS {
        if !report.pointer(pointer).is_some_and(Value::is_number) {
            findings.push(format!("report.json: {pointer} is not a number"));
        }
    }
    if report["finite"] != Value::Bool(true) {
        findings.push("report.json: finite is not true".to_owned());
    }
    for key in ["method", "state_hash"] {
        if report[key].as_str().is_none_or(str::is_empty) {
            findings.push(format!("report.json: {key} is not a text"));
        }
    }
    if report["files"].as_array().is_none_or(Vec::is_empty) {
        findings.push("report.json: files is not a list".to_owned());
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_empty_report_lacks_everything() {
        let findings = report_findings(&serde_json::json!({"finite": false}));
        assert_eq!(findings.len(), NUMBERS.len() + 4, "{findings:?}");
    }
}
