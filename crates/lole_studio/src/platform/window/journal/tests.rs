//! Work that outlives its window, also one that is killed.

use std::io::{BufRead as _, BufReader};
use std::process::{Command, Stdio};
use std::time::Duration;

use lole_costume::document::Design;
use lole_language::Language;

use super::*;
use crate::Studio;

/// Tells the process that is killed where to work.
const FOLDER: &str = "LOLE_TEST_WORK_FOLDER";
/// What it says when it has worked.
const WORKED: &str = "the work is done";

fn fresh(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("lole-work-{name}-{}", std::process::id()));
    drop(fs::remove_dir_all(&folder));
    folder
}

/// Work of three changes, of which one was taken back.
fn worked() -> Studio {
    let mut studio = Studio::new(Language::Japanese, Design::default(), None);
    for height in [25.0, 30.0, 35.0] {
        studio.change(|design| design.skirt.hem_height_cm = height);
        studio.rest();
    }
    studio.undo();
    studio
}

/// Waits until `folder` holds work.
fn wait_for_work(folder: &Path) {
    for _ in 0..1000 {
        if folder.join("window-1.work").exists() {
            return;
        }
        thread::sleep(Duration::from_millis(5));
    }
    panic!("nothing was written");
}

/// The process that is killed: it works, says so and never ends. Run by itself it does nothing.
#[test]
#[expect(clippy::print_stdout, reason = "the other process waits for the line")]
fn a_process_that_works_until_it_is_killed() {
    let Some(folder) = std::env::var_os(FOLDER).map(PathBuf::from) else {
        return;
    };
    let (journal, leftover) = Journal::open(&folder).unwrap();
    assert!(leftover.is_none());
    journal.keep(worked().work());
    wait_for_work(&folder);
    println!("{WORKED}");
    loop {
        thread::sleep(Duration::from_secs(60));
    }
}

#[test]
fn a_killed_process_leaves_its_work_and_every_step_back_to_the_next_window() {
    let folder = fresh("killed");
    let this = "platform::window::journal::tests::a_process_that_works_until_it_is_killed";
    let mut process = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", this, "--nocapture"])
        .env(FOLDER, &folder)
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(process.stdout.take().unwrap()).lines();
    assert!(lines.any(|line| line.unwrap().contains(WORKED)));
    // While it lives, its work is its own.
    let (other, leftover) = Journal::open(&folder).unwrap();
    assert!(leftover.is_none());
    drop(other);

    process.kill().unwrap();
    process.wait().unwrap();

    let (journal, leftover) = Journal::open(&folder).unwrap();
    let leftover = leftover.unwrap();
    let mut studio = Studio::new(Language::Japanese, Design::default(), None);
    studio.resume(leftover.work.clone());
    assert_eq!(studio.work(), worked().work());
    let height = |studio: &Studio| studio.design().skirt.hem_height_cm.to_string();
    assert_eq!(height(&studio), "30");
    studio.redo();
    assert_eq!(height(&studio), "35");
    for _ in 0..3 {
        studio.undo();
    }
    assert_eq!(*studio.design(), Design::default());

    leftover.discard();
    drop(journal);
    assert!(Journal::open(&folder).unwrap().1.is_none());
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn saved_work_leaves_nothing_and_two_windows_do_not_meet() {
    let folder = fresh("two");
    let (first, _) = Journal::open(&folder).unwrap();
    let (second, _) = Journal::open(&folder).unwrap();
    first.keep(worked().work());
    second.keep(worked().work());
    first.clear();
    drop((first, second));
    let left = |name: &str| folder.join(name).exists();
    assert!(!left("window-1.work") && left("window-2.work"));
    // A damaged copy is not offered.
    fs::write(folder.join("window-2.work"), b"lole-work 9").unwrap();
    assert!(Journal::open(&folder).unwrap().1.is_none());
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_disk_that_takes_nothing_is_told_in_a_sentence() {
    let folder = fresh("full");
    let (journal, _) = Journal::open(&folder).unwrap();
    // A folder cannot be replaced by a file.
    fs::create_dir_all(folder.join("window-1.work/inside")).unwrap();
    journal.keep(worked().work());
    let mut sentence = None;
    for _ in 0..1000 {
        sentence = journal.trouble();
        if sentence.is_some() {
            break;
        }
        thread::sleep(Duration::from_millis(5));
    }
    assert!(sentence.unwrap().english.contains("window-1.work"));
    drop(journal);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn data_lies_where_the_system_keeps_it_and_nowhere_without_a_home() {
    let home = if cfg!(windows) { "C:\\u" } else { "/u" };
    let folder = folder(|name| {
        let known = ["HOME", "LOCALAPPDATA"].contains(&name);
        known.then(|| home.into())
    });
    let folder = folder.unwrap();
    assert!(folder.starts_with(home) && folder.ends_with("work"));
    assert_eq!(super::folder(|_| None), None);
    assert_eq!(super::folder(|_| Some("relative".into())), None);
}
