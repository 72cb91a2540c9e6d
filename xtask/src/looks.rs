//! Draws the situations in which a look is judged, holds them against the sheet that is kept, and keeps the new one
//! when it was looked at.

use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode};

use anyhow::{Context as _, ensure};

/// The sheet that is kept, from the repository's root.
const KEPT: &str = "docs/looks.jpg";

pub(crate) fn run(repository: &Path, arguments: &[&str]) -> anyhow::Result<ExitCode> {
    let keeps = arguments.contains(&"--keep");
    let names: Vec<&&str> = arguments.iter().filter(|name| **name != "--keep").collect();
    ensure!(
        !keeps || names.is_empty(),
        "--keep keeps the whole sheet; leave the names out"
    );
    let out = super::web::target(repository).join("looks");
    let mut cargo = Command::new("cargo");
    cargo
        .current_dir(repository)
        .args(["run", "--quiet", "--release", "-p", "lole_picture"])
        .args(["--example", "looks", "--"])
        .arg(&out)
        .args(names);
    let status = cargo.status().context("cargo cannot be run")?;
    ensure!(status.success(), "the situations were not drawn");
    if keeps {
        fs::copy(out.join("looks.jpg"), repository.join(KEPT))?;
        println!("kept as {KEPT}");
    } else {
        println!(
            "they are in {}; look at them, then: cargo xtask looks --keep",
            out.display()
        );
    }
    Ok(ExitCode::SUCCESS)
}
