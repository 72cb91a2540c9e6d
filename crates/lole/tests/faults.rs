//! The command on a disk that fails: one sentence, an exit code, earlier results as they were, and a next run that
//! goes well and says what it found.
#![cfg(target_os = "linux")]
#![expect(
    clippy::unwrap_used,
    clippy::print_stderr,
    reason = "a test that cannot be set up has failed; where there is no C compiler it says so"
)]

#[path = "../../lole_files/tests/failing_disk/mod.rs"]
mod failing_disk;
mod support;

use std::fs;
use std::path::Path;
use std::process::Command;

use failing_disk::{Mode, Seen, Shim, Trial, fill};
use support::{Scratch, in_english};

fn lole(arguments: &[&str], paths: &[&Path]) -> Command {
    let mut command = support::lole();
    command.args(arguments).args(paths);
    command
}

/// Fails every change of a command, or each `every`-th, in every way.
fn fail_changes(scratch: &Path, command: &dyn Fn() -> Command, every: usize) {
    let folder = scratch.join("out");
    let Some(shim) = Shim::build(scratch, &folder) else {
        eprintln!("there is no C compiler here: nothing was tried");
        return;
    };
    let (output, changes) = shim.changes(command());
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{said}");
    assert!(
        changes.iter().any(|change| change == "fsync"),
        "{changes:?}"
    );
    let after = Seen::of(&folder);
    assert!(
        !after.files.is_empty() && after.hidden.is_empty(),
        "{after:?}"
    );
    // An earlier run made other files of the same names.
    let mut before = after.clone();
    for (name, bytes) in &mut before.files {
        *bytes = format!("earlier {name}").into_bytes();
    }
    fill(&folder, &before);
    let (output, changes) = shim.changes(command());
    assert!(output.status.success());
    let trial = Trial {
        shim: &shim,
        folder: &folder,
        before: &before,
        after: &after,
        command,
        voice: "lole: ",
        found: Some("an earlier run was stopped"),
    };
    for (index, change) in changes.iter().enumerate().step_by(every) {
        for mode in Mode::ALL {
            trial.check(mode, index + 1, change);
        }
    }
}

#[test]
fn a_page_is_written_or_the_earlier_one_stays() {
    let scratch = Scratch::new("faults-form");
    let out = scratch.0.join("out").join("form.pdf");
    fail_changes(&scratch.0, &|| lole(&["form", "--out"], &[&out]), 1);
}

#[test]
fn a_folder_of_patterns_is_written_or_the_earlier_one_stays() {
    let scratch = Scratch::new("faults-pattern");
    let design = scratch.0.join("costume.lole");
    fs::write(&design, "lole = 1\n").unwrap();
    let out = scratch.0.join("out");
    // Every change of such a folder is tried beside the code that writes it; here the command's own part.
    fail_changes(
        &scratch.0,
        &|| lole(&["pattern", "--out"], &[&out, &design]),
        17,
    );
}

/// What is said of a folder that is full: `ulimit -f` lets no file grow over so many blocks.
#[test]
fn a_file_that_may_not_grow_is_one_sentence() {
    let scratch = Scratch::new("faults-limit");
    let out = scratch.0.join("out");
    let output = in_english(Command::new("sh"))
        .args([
            "-c",
            "trap '' XFSZ; ulimit -f 8; exec \"$0\" form --out \"$1\"",
        ])
        .arg(env!("CARGO_BIN_EXE_lole"))
        .arg(out.join("form.pdf"))
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert_eq!(
        said.lines()
            .filter(|line| line.starts_with("lole: "))
            .count(),
        1,
        "{said}"
    );
    assert!(said.contains("form.pdf"), "{said}");
    assert!(!out.exists(), "{said}");
}
