//! Every change of a file meets a full disk, a lost permission and a kill: earlier results stay whole, nothing
//! half-written is seen, and the next run does what is asked.
#![cfg(target_os = "linux")]
#![expect(
    clippy::unwrap_used,
    clippy::print_stderr,
    reason = "a test that cannot be set up has failed; where there is no C compiler it says so"
)]

mod failing_disk;

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use failing_disk::{Mode, Seen, Shim, Trial, fill};
use lole_files::{OutputFolder, write_folder, write_whole};

/// What the program under test is to do, where this test is run by [`program`].
const TASK: &str = "LOLE_FAULT_TASK";
/// Where.
const PLACE: &str = "LOLE_FAULT_PLACE";

/// The names and bytes of results; long enough that a half of them is none.
fn results() -> Vec<(String, Vec<u8>)> {
    ["a.pdf", "b.json", "c.svg"]
        .map(|name| {
            (
                name.to_owned(),
                format!("new {name} ").repeat(4000).into_bytes(),
            )
        })
        .into()
}

/// The program under test: this file again, which does nothing unless it is told.
#[test]
fn program() {
    let (Ok(task), Ok(place)) = (env::var(TASK), env::var(PLACE)) else {
        return;
    };
    let place = PathBuf::from(place);
    let done = match task.as_str() {
        "results" => OutputFolder::create(&place).and_then(|mut output| {
            for sentence in output.found() {
                eprintln!("{sentence}");
            }
            for (name, bytes) in results() {
                output.write(&name, &bytes)?;
            }
            output.finish().map(|_| ())
        }),
        "look" => OutputFolder::create(&place).map(drop),
        "folder" => write_folder(&place, &results()),
        "design" => write_whole(&place.join("mine.lole"), &results()[0].1),
        other => panic!("{other}"),
    };
    if let Err(sentence) = done {
        eprintln!("sentence: {sentence}");
        std::process::exit(1);
    }
}

fn told(task: &str, place: &Path) -> Command {
    let mut command = Command::new(env::current_exe().unwrap());
    command
        .args(["--exact", "program", "--nocapture", "--test-threads=1"])
        .env(TASK, task)
        .env(PLACE, place);
    command
}

fn seen(files: &[(String, Vec<u8>)]) -> Seen {
    Seen {
        files: files.iter().cloned().collect(),
        hidden: Vec::new(),
    }
}

/// A scratch folder that is removed when the test ends, and a failing disk for `out` in it.
struct Scratch {
    folder: PathBuf,
    out: PathBuf,
    shim: Option<Shim>,
}

impl Scratch {
    fn new(name: &str) -> Self {
        let folder = env::temp_dir().join(format!("lole-faults-{name}-{}", std::process::id()));
        drop(fs::remove_dir_all(&folder));
        fs::create_dir_all(&folder).unwrap();
        let out = folder.join("out");
        let shim = Shim::build(&folder, &out);
        if shim.is_none() {
            eprintln!("there is no C compiler here: nothing was tried");
        }
        Self { folder, out, shim }
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        drop(fs::remove_dir_all(&self.folder));
    }
}

/// Fails every change of a task in every way; from `before` it makes `after`.
fn fail_everywhere(task: &str, before: &Seen, after: &Seen, found: Option<&str>) {
    let scratch = Scratch::new(&format!("{task}-{}", before.files.len()));
    let folder = scratch.out.clone();
    let Some(shim) = &scratch.shim else {
        return;
    };
    fill(&folder, before);
    let (output, changes) = shim.changes(told(task, &folder));
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    assert_eq!(Seen::of(&folder), *after);
    // What is promised is on the disk before it has its name.
    let first = |name: &str| changes.iter().position(|change| change == name);
    assert!(first("fsync") < first("rename"), "{changes:?}");
    assert!(first("fsync").is_some(), "{changes:?}");
    let trial = Trial {
        shim,
        folder: &folder,
        before,
        after,
        command: &|| told(task, &folder),
        voice: "sentence: ",
        found,
    };
    for mode in Mode::ALL {
        for (index, change) in changes.iter().enumerate() {
            trial.check(mode, index + 1, change);
        }
    }
}

/// The results of an earlier run: two of the new names, and one of its own.
fn earlier() -> Seen {
    let old = ["a.pdf", "c.svg", "mine.txt"];
    seen(&old.map(|name| (name.to_owned(), format!("old {name}").into_bytes())))
}

/// Earlier results with the new ones over them.
fn over(earlier: &Seen) -> Seen {
    let mut seen = earlier.clone();
    seen.files.extend(results());
    seen
}

#[test]
fn results_replace_those_of_an_earlier_run_all_or_none() {
    fail_everywhere(
        "results",
        &earlier(),
        &over(&earlier()),
        Some("an earlier run was stopped"),
    );
    fail_everywhere("folder", &earlier(), &over(&earlier()), None);
}

#[test]
fn results_of_a_first_run_are_there_all_or_none() {
    let none = Seen::default();
    fail_everywhere(
        "results",
        &none,
        &over(&none),
        Some("an earlier run was stopped"),
    );
}

/// Whoever comes next finds one run's results, even if it makes none itself.
#[test]
fn results_of_two_runs_never_stay_mixed() {
    let scratch = Scratch::new("mixed");
    let Some(shim) = &scratch.shim else {
        return;
    };
    let (before, after) = (earlier(), over(&earlier()));
    fill(&scratch.out, &before);
    let (_, changes) = shim.changes(told("results", &scratch.out));
    let (mut kept, mut ended) = (0, 0);
    for (index, change) in changes.iter().enumerate() {
        fill(&scratch.out, &before);
        let killed = shim.fail(told("results", &scratch.out), Mode::Kill, index + 1);
        assert!(!killed.status.success());
        let looked = told("look", &scratch.out).output().unwrap();
        assert!(looked.status.success());
        let seen = Seen::of(&scratch.out);
        let place = index + 1;
        assert!(
            seen == before || seen == after,
            "killed at change {place}, {change}"
        );
        kept += u32::from(seen == before);
        ended += u32::from(seen == after);
    }
    // Both come about: before the results are whole, and after.
    assert!(10 < kept && 3 < ended, "{kept} kept, {ended} ended");
}

#[test]
fn a_design_is_the_old_or_the_new_one() {
    let old = seen(&[("mine.lole".to_owned(), b"lole = 1".to_vec())]);
    let new = seen(&[("mine.lole".to_owned(), results()[0].1.clone())]);
    fail_everywhere("design", &old, &new, None);
}
