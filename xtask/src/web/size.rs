//! How large the page is, part by part, against the budget in the repository.

use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use anyhow::{Context as _, bail};

/// Bytes that each part may have when it is sent compressed, a line each; `first` is of all that the first picture
/// needs.
const BUDGET: &str = "crates/lole_web/budget.txt";

/// Parts that are fetched when they are wanted, and kept for visits without a network; not of the first picture.
const LATER: [&str; 3] = ["paper-regular.otf", "paper-bold.otf", "offline.js"];

/// Prints every part, raw and compressed; whether each is within its budget.
pub(super) fn report(repository: &Path, folder: &Path) -> anyhow::Result<bool> {
    let budget = fs::read_to_string(repository.join(BUDGET)).context(BUDGET)?;
    let allowed = |name: &str| -> Option<usize> {
        let mut lines = budget.lines().filter(|line| !line.starts_with('#'));
        let line = lines.find(|line| line.split_whitespace().next() == Some(name))?;
        line.split_whitespace().nth(1)?.parse().ok()
    };
    let mut names: Vec<String> = fs::read_dir(folder)?
        .map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()))
        .collect::<anyhow::Result<_>>()?;
    names.sort();
    let (mut is_within, mut total) = (true, [0, 0]);
    println!(
        "{:24} {:>10} {:>12} {:>10}",
        "part", "bytes", "compressed", "budget"
    );
    let mut print = |name: &str, sizes: [usize; 2]| {
        let most = allowed(name);
        let is_over = most.is_some_and(|most| most < sizes[1]);
        is_within &= !is_over;
        let most = most.map_or_else(String::new, |most| most.to_string());
        let note = if is_over { "  over its budget" } else { "" };
        println!("{name:24} {:10} {:12} {most:>10}{note}", sizes[0], sizes[1]);
    };
    for name in names {
        let bytes = fs::read(folder.join(&name))?;
        let sizes = [bytes.len(), compressed(&bytes)?];
        if !LATER.contains(&name.as_str()) {
            total = [total[0] + sizes[0], total[1] + sizes[1]];
        }
        print(&name, sizes);
    }
    print("first", total);
    Ok(is_within)
}

/// Length of what is sent, by Brotli where it is installed, else by gzip.
fn compressed(bytes: &[u8]) -> anyhow::Result<usize> {
    for (program, arguments) in [
        ("brotli", ["-q", "11", "-c", "-"]),
        ("gzip", ["-9", "-c", "-n", "-q"]),
    ] {
        let child = Command::new(program)
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn();
        let Ok(mut child) = child else { continue };
        let mut input = child.stdin.take().context("no input")?;
        let sent = bytes.to_vec();
        // Both ends at once: what it answers may fill the pipe before all is sent.
        let writer = std::thread::spawn(move || input.write_all(&sent));
        let output = child.wait_with_output()?;
        let written = writer.join().is_ok_and(|written| written.is_ok());
        if written && output.status.success() {
            return Ok(output.stdout.len());
        }
    }
    bail!("neither brotli nor gzip is installed; install one to measure what is sent")
}
