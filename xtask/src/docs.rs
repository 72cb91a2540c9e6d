//! Builds the documentation and checks its links, except those that are units.
//!
//! The house writes units in brackets, `[m]`, and rustdoc takes a bracketed word for a link. So the
//! workspace allows unresolved links, and here they are forced to be reported and sorted out.

use std::path::Path;
use std::process::{Command, ExitCode};

use anyhow::Context as _;
use serde_json::Value;

/// Bracketed words that are units and no links. Those with a sign, such as `[m/s]`, rustdoc leaves
/// alone.
const UNITS: &[&str] = &[
    "1",
    "m",
    "m²",
    "cm",
    "mm",
    "yd",
    "s",
    "ms",
    "years",
    "ns",
    "min",
    "tick",
    "kg",
    "g",
    "N",
    "J",
    "W",
    "Pa",
    "rad",
    "deg",
    "degrees",
    "counts",
    "statures",
    "diameters",
    "byte",
    "bytes",
    "bit",
    "pixel",
    "point",
    "pixels",
    "pixel²",
    "px",
    "pt",
    "em",
    "letter",
    "texel",
    "texel²",
    "fps",
];

const LINK_LINT: &str = "rustdoc::broken_intra_doc_links";

pub(crate) fn run(repository: &Path) -> anyhow::Result<ExitCode> {
    let output = Command::new(env!("CARGO"))
        .current_dir(repository)
        .env(
            "RUSTDOCFLAGS",
            format!("-D warnings --force-warn {LINK_LINT}"),
        )
        .args([
            "doc",
            "--workspace",
            "--no-deps",
            "--document-private-items",
        ])
        // With the examples come the features that tests and Clippy build dependencies with, so
        // that none is built once more for the documentation.
        .args(["--lib", "--bins", "--examples"])
        .args(["--quiet", "--message-format", "json"])
        .output()
        .context("cannot run cargo doc")?;
    let mut findings = Vec::new();
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        let message: Value = serde_json::from_str(line).unwrap_or_default();
        findings.extend(finding(&message["message"]));
    }
    findings.sort();
    findings.dedup();
    for finding in &findings {
        println!("{finding}");
    }
    if output.status.success() && findings.is_empty() {
        println!("docs: built, and every link leads somewhere");
        return Ok(ExitCode::SUCCESS);
    }
    print!("{}", String::from_utf8_lossy(&output.stderr));
    println!("docs: {} findings", findings.len());
    Ok(ExitCode::FAILURE)
}

/// The sentence for a message of the compiler, unless it only takes a unit for a link.
fn finding(message: &Value) -> Option<String> {
    let text = message["message"].as_str()?;
    let level = message["level"].as_str().unwrap_or_default();
    if message["code"]["code"] == LINK_LINT {
        let target = text.split('`').nth(1).unwrap_or_default();
        if UNITS.contains(&target) {
            return None;
        }
    } else if level != "error" {
        return None;
    }
    let span = &message["spans"][0];
    let file = span["file_name"].as_str().unwrap_or("workspace");
    let line = span["line_start"].as_u64().unwrap_or(1);
    Some(format!("{file}:{line}: {text}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn link(target: &str) -> Option<String> {
        finding(&serde_json::json!({
            "level": "warning",
            "message": format!("unresolved link to `{target}`"),
            "code": {"code": LINK_LINT},
            "spans": [{"file_name": "a.rs", "line_start": 3}],
        }))
    }

    #[test]
    fn units_are_no_links_and_lost_names_are() {
        assert_eq!(link("m"), None);
        assert_eq!(
            link("Grid::lost").as_deref(),
            Some("a.rs:3: unresolved link to `Grid::lost`")
        );
    }
}
