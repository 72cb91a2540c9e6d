//! Builds the studio as a page: one folder that any static server can serve.

mod exports;
mod serve;
mod size;
mod toolchain;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use anyhow::{Context as _, ensure};

pub(crate) use serve::run as serve;

/// The crate that becomes the page.
const PACKAGE: &str = "lole_web";
/// Files that are shipped as they are, from the repository's root.
const SITE: &str = "crates/lole_web/site";
/// Fonts of printed pages, fetched when paper is made: their place in the repository and in the folder.
const PAPER_FONTS: [[&str; 2]; 2] = [
    [
        "crates/lole_export/data/fonts/NotoSansJP-Regular.otf",
        "paper-regular.otf",
    ],
    [
        "crates/lole_export/data/fonts/NotoSansJP-Bold.otf",
        "paper-bold.otf",
    ],
];
/// What the offline worker calls its build until it is built.
const BUILD: &str = "lole-BUILD";

/// The folder that is built, under Cargo's own.
pub(crate) fn folder(repository: &Path) -> PathBuf {
    target(repository).join("web/page")
}

/// Cargo's folder for what is built.
pub(crate) fn target(repository: &Path) -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| repository.join("target"), PathBuf::from)
}

/// Builds it, and holds its size against the budget.
pub(crate) fn run(repository: &Path) -> anyhow::Result<ExitCode> {
    let tools = match toolchain::find(repository) {
        Ok(tools) => tools,
        Err(sentence) => {
            println!("{sentence}");
            return Ok(ExitCode::FAILURE);
        }
    };
    let target = target(repository).join("web");
    let status = tools.cargo(repository, &target, PACKAGE).status();
    let status = status.context("cargo cannot be run")?;
    ensure!(status.success(), "the page was not built");
    let folder = folder(repository);
    // What an earlier build left is no part of this one.
    drop(fs::remove_dir_all(&folder));
    fs::create_dir_all(&folder)?;
    let wasm = target.join(format!("{}/web/{PACKAGE}.wasm", toolchain::TARGET));
    let bound = Command::new("wasm-bindgen")
        // Names serve debuggers alone.
        .args([
            "--target",
            "web",
            "--no-typescript",
            "--remove-name-section",
            "--out-dir",
        ])
        .args([&folder, &wasm])
        .status()
        .context("wasm-bindgen cannot be run")?;
    ensure!(bound.success(), "wasm-bindgen failed");
    shrink(&folder.join(format!("{PACKAGE}_bg.wasm")))?;
    for entry in fs::read_dir(repository.join(SITE))? {
        let entry = entry?;
        fs::copy(entry.path(), folder.join(entry.file_name()))?;
    }
    for [font, name] in PAPER_FONTS {
        fs::copy(repository.join(font), folder.join(name))?;
    }
    name_build(&folder)?;
    let is_within = size::report(repository, &folder)?;
    println!("the page is in {}", folder.display());
    println!("cargo xtask serve    shows it on this machine");
    Ok(if is_within {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}

/// Makes the program smaller where Binaryen is installed; without it the page works as well.
fn shrink(wasm: &Path) -> anyhow::Result<()> {
    let smaller = wasm.with_extension("small");
    let features = [
        "--enable-simd",
        "--enable-bulk-memory",
        "--enable-nontrapping-float-to-int",
        "--enable-sign-ext",
        "--enable-mutable-globals",
        "--enable-reference-types",
        "--enable-multivalue",
    ];
    // No option of it may reorder floating-point arithmetic: `-O2` does not.
    let run = Command::new("wasm-opt")
        .arg("-O2")
        .args(features)
        .arg(wasm)
        .arg("-o")
        .arg(&smaller)
        .output();
    match run {
        Ok(output) if output.status.success() => {
            if exports::tables(&fs::read(&smaller)?) == exports::tables(&fs::read(wasm)?) {
                fs::rename(&smaller, wasm)?;
            } else {
                fs::remove_file(&smaller)?;
                println!(
                    "wasm-opt names the program's tables wrongly, as version 108 does: the program stays larger; \
                     a newer binaryen is needed"
                );
            }
        }
        Ok(output) => {
            let reason = String::from_utf8_lossy(&output.stderr);
            let reason = reason.lines().next().unwrap_or_default();
            println!("wasm-opt could not make it smaller: {reason}");
        }
        Err(_) => {
            println!("wasm-opt is not installed (package binaryen): the program stays larger");
        }
    }
    Ok(())
}

/// Names the build by what it holds, so that the offline worker tells one from another.
fn name_build(folder: &Path) -> anyhow::Result<()> {
    let mut files: Vec<PathBuf> = fs::read_dir(folder)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<_, _>>()?;
    files.sort();
    // FNV-1a, 64 bits.
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for file in &files {
        for byte in fs::read(file)? {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
    let worker = folder.join("offline.js");
    let text = fs::read_to_string(&worker)?;
    fs::write(&worker, text.replace(BUILD, &format!("lole-{hash:016x}")))?;
    Ok(())
}
