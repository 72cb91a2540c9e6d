//! Rewrites the goldens by running the tests that own them, and lists what changed.
//!
//! A test that compares with a golden rewrites it instead where `LOLE_GOLDEN` is `write`; its name begins with
//! `golden_` (see `lole_golden`).
//! `tests/golden/` has one folder for each crate that owns goldens.

use std::path::Path;
use std::process::{Command, ExitCode};

use anyhow::{Context as _, ensure};

const GOLDENS: &str = "tests/golden";

pub(crate) fn run(repository: &Path) -> anyhow::Result<ExitCode> {
    let folder = repository.join(GOLDENS);
    let mut crates = Vec::new();
    for entry in std::fs::read_dir(&folder).with_context(|| format!("cannot list {GOLDENS}"))? {
        crates.push(entry?.file_name().to_string_lossy().into_owned());
    }
    crates.sort();

    let mut test = Command::new(env!("CARGO"));
    test.current_dir(repository)
        .env("LOLE_GOLDEN", "write")
        // The whole workspace, as the README's test command: with some crates only, their dependencies would be
        // built once more with other features.
        .args([
            "test",
            "--workspace",
            "--lib",
            "--tests",
            "--quiet",
            "--",
            "golden_",
        ]);
    let status = test.status().context("cannot run cargo test")?;
    ensure!(
        status.success(),
        "tests of {} failed; mend them first",
        crates.join(", ")
    );

    let git = Command::new("git")
        .current_dir(repository)
        .args([
            "status",
            "--porcelain",
            "--untracked-files=all",
            "--",
            GOLDENS,
        ])
        .output()
        .context("cannot ask git what changed")?;
    ensure!(
        git.status.success(),
        "git status failed: {}",
        String::from_utf8_lossy(&git.stderr)
    );
    let changes = String::from_utf8_lossy(&git.stdout);
    if changes.is_empty() {
        println!("goldens of {} are as committed", crates.join(", "));
    } else {
        print!("changed goldens; explain each in the commit:\n{changes}");
    }
    Ok(ExitCode::SUCCESS)
}
