//! Dependencies point up the table and nowhere else, and every external crate has a reason.

use std::path::Path;
use std::process::Command;

use anyhow::{Context as _, ensure};
use serde_json::Value;

use super::TextFile;

/// Each crate with the workspace crates it may use. `lole_cloth`, `lole_body`, `lole_pattern` and
/// `lole_render` never see each other.
const TABLE: &[(&str, &[&str])] = &[
    ("lole_golden", &[]),
    ("lole_language", &[]),
    ("lole_geom", &[]),
    ("lole_cloth", &["lole_geom", "lole_golden"]),
    ("lole_body", &["lole_language", "lole_geom"]),
    ("lole_hula", &["lole_language", "lole_geom", "lole_body"]),
    (
        "lole_motion",
        &["lole_language", "lole_geom", "lole_body", "lole_hula"],
    ),
    (
        "lole_avatar",
        &[
            "lole_language",
            "lole_geom",
            "lole_body",
            "lole_hula",
            "lole_motion",
        ],
    ),
    (
        "lole_pattern",
        &["lole_language", "lole_geom", "lole_golden"],
    ),
    (
        "lole_print",
        &["lole_language", "lole_geom", "lole_pattern"],
    ),
    ("lole_render", &["lole_geom"]),
    (
        "lole_garment",
        &[
            "lole_language",
            "lole_geom",
            "lole_golden",
            "lole_cloth",
            "lole_body",
            "lole_pattern",
        ],
    ),
    (
        "lole_costume",
        &[
            "lole_language",
            "lole_geom",
            "lole_cloth",
            "lole_body",
            "lole_hula",
            "lole_pattern",
            "lole_print",
            "lole_garment",
        ],
    ),
    (
        "lole_exchange",
        &[
            "lole_language",
            "lole_geom",
            "lole_body",
            "lole_pattern",
            "lole_garment",
        ],
    ),
    (
        "lole_files",
        &[
            "lole_language",
            "lole_geom",
            "lole_avatar",
            "lole_print",
            "lole_garment",
            "lole_exchange",
            "lole_costume",
        ],
    ),
    (
        "lole_stage",
        &[
            "lole_language",
            "lole_geom",
            "lole_golden",
            "lole_cloth",
            "lole_body",
            "lole_hula",
            "lole_motion",
            "lole_avatar",
            "lole_print",
            "lole_pattern",
            "lole_garment",
            "lole_costume",
        ],
    ),
    (
        "lole_export",
        &[
            "lole_language",
            "lole_geom",
            "lole_cloth",
            "lole_body",
            "lole_hula",
            "lole_motion",
            "lole_avatar",
            "lole_print",
            "lole_pattern",
            "lole_garment",
            "lole_costume",
            "lole_stage",
        ],
    ),
    (
        "lole_picture",
        &[
            "lole_geom",
            "lole_cloth",
            "lole_body",
            "lole_hula",
            "lole_avatar",
            "lole_render",
            "lole_garment",
            "lole_print",
            "lole_costume",
            "lole_stage",
            "lole_export",
        ],
    ),
    (
        "lole_study",
        &[
            "lole_language",
            "lole_geom",
            "lole_cloth",
            "lole_body",
            "lole_avatar",
            "lole_costume",
            "lole_stage",
            "lole_export",
            "lole_render",
            "lole_picture",
        ],
    ),
    (
        "lole_batch",
        &[
            "lole_language",
            "lole_geom",
            "lole_cloth",
            "lole_costume",
            "lole_files",
            "lole_stage",
        ],
    ),
    (
        "lole_studio",
        &[
            "lole_language",
            "lole_geom",
            "lole_cloth",
            "lole_body",
            "lole_hula",
            "lole_avatar",
            "lole_print",
            "lole_pattern",
            "lole_garment",
            "lole_render",
            "lole_costume",
            "lole_files",
            "lole_stage",
            "lole_export",
            "lole_picture",
        ],
    ),
    ("lole_web", &["lole_stage", "lole_studio"]),
    (
        "lole",
        &[
            "lole_language",
            "lole_geom",
            "lole_cloth",
            "lole_body",
            "lole_hula",
            "lole_motion",
            "lole_avatar",
            "lole_print",
            "lole_pattern",
            "lole_garment",
            "lole_render",
            "lole_costume",
            "lole_exchange",
            "lole_files",
            "lole_stage",
            "lole_export",
            "lole_picture",
            "lole_study",
            "lole_batch",
        ],
    ),
    (
        "lole_python",
        &[
            "lole_language",
            "lole_geom",
            "lole_body",
            "lole_costume",
            "lole_files",
            "lole_stage",
            "lole_batch",
        ],
    ),
    ("xtask", &[]),
];

/// Where the sentence on each external crate stands.
const REASONS: &str = "DESIGN.md";

pub(crate) fn check(repository: &Path, files: &[TextFile]) -> anyhow::Result<Vec<String>> {
    let output = Command::new(env!("CARGO"))
        .current_dir(repository)
        .args(["metadata", "--no-deps", "--format-version", "1"])
        .output()
        .context("cannot run cargo metadata")?;
    ensure!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let metadata: Value = serde_json::from_slice(&output.stdout)?;
    let reasons = files
        .iter()
        .find(|file| file.path == REASONS)
        .map_or("", |file| &file.text);
    Ok(findings(&metadata, reasons))
}

fn findings(metadata: &Value, reasons: &str) -> Vec<String> {
    let mut findings = Vec::new();
    for package in list(metadata, "packages") {
        let name = text(package, "name");
        let manifest = format!("crates/{name}/Cargo.toml");
        let Some((_, allowed)) = TABLE.iter().find(|(row, _)| *row == name) else {
            findings.push(format!(
                "{manifest}:1: {name} has no row in the dependency table"
            ));
            continue;
        };
        for dependency in list(package, "dependencies") {
            let used = text(dependency, "name");
            let ours = TABLE.iter().any(|(row, _)| *row == used);
            if ours && !allowed.contains(&used) {
                findings.push(format!("{manifest}:1: {name} may not use {used}"));
            }
            if !ours && !reasons.contains(&format!("`{used}`")) {
                findings.push(format!(
                    "{manifest}:1: {REASONS} has no sentence on `{used}`"
                ));
            }
        }
    }
    findings
}

fn list<'v>(value: &'v Value, key: &str) -> &'v [Value] {
    value[key].as_array().map_or(&[], Vec::as_slice)
}

fn text<'v>(value: &'v Value, key: &str) -> &'v str {
    value[key].as_str().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn metadata(name: &str, used: &str) -> Value {
        serde_json::json!({"packages": [{"name": name, "dependencies": [{"name": used}]}]})
    }

    #[test]
    fn arrows_point_up_the_table_only() {
        assert!(findings(&metadata("lole_stage", "lole_cloth"), "").is_empty());
        for (name, used) in [
            ("lole_cloth", "lole_body"),
            ("lole_pattern", "lole_cloth"),
            ("lole_export", "lole_render"),
            ("lole_geom", "lole_geom"),
            ("lole_body", "lole_stage"),
        ] {
            assert_eq!(
                findings(&metadata(name, used), "").len(),
                1,
                "{name} → {used}"
            );
        }
    }

    #[test]
    fn strangers_need_a_sentence() {
        assert_eq!(findings(&metadata("lole_geom", "glam"), "").len(), 1);
        assert!(findings(&metadata("lole_geom", "glam"), "- `glam`: vectors.").is_empty());
        assert_eq!(findings(&metadata("lole_new", "glam"), "`glam`").len(), 1);
    }

    #[test]
    fn the_table_has_no_cycle() {
        for (index, (name, allowed)) in TABLE.iter().enumerate() {
            for used in *allowed {
                let above = TABLE.iter().position(|(row, _)| row == used);
                assert!(above.is_some_and(|above| above < index), "{name} → {used}");
            }
        }
    }
}
