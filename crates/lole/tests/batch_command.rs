//! `lole batch` as a user and a queue meet it: the same table to the bit, however it came about.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot be set up has failed"
)]

mod support;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};
use std::thread;
use std::time::Duration;

use support::{Scratch, lole};

/// A skirt coarse enough that a run takes a second or two.
const SMALL: &str = "lole = 1\n[skirt]\ncolumn_count = 96\nrow_count = 40\n";
/// Five runs, of which the last cannot be sewn on her; its dancer is far too small for that hem.
const SWEEP: &str = "lole_sweep = 1\ndesign = \"small.lole\"\nkind = \"list\"\nfiles = [\"series\", \"positions\"]\n\
    [fixed]\n\"motion.duration_s\" = 0.5\n\
    [[axis]]\nkey = \"skirt.gather_ratio\"\nvalues = [2, 2.5, 3, 3.5, 4]\n\
    [[axis]]\nkey = \"skirt.hem_height_cm\"\nvalues = [20, 22, 24, 26, 100]\n";

fn batch(sweep: &Path, out: &Path, more: &[&str]) -> Output {
    let mut command = lole();
    command
        .arg("batch")
        .arg(sweep)
        .arg("--out")
        .arg(out)
        .args(more);
    command.output().unwrap()
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A scratch folder with the sweep in it.
fn swept(name: &str) -> (Scratch, PathBuf) {
    let scratch = Scratch::new(name);
    scratch.write("small.lole", SMALL);
    let sweep = scratch.write("sweep.toml", SWEEP);
    (scratch, sweep)
}

fn tables(out: &Path) -> [Vec<u8>; 2] {
    ["runs.csv", "runs.parquet"].map(|name| fs::read(out.join(name)).unwrap())
}

/// How many records there are.
fn records(out: &Path) -> usize {
    let folders = fs::read_dir(out.join("runs"))
        .into_iter()
        .flatten()
        .flatten();
    let files =
        folders.flat_map(|folder| fs::read_dir(folder.path()).into_iter().flatten().flatten());
    let names = files.map(|file| file.file_name().to_string_lossy().into_owned());
    names.filter(|name| name.ends_with(".json")).count()
}

#[test]
fn shares_threads_and_kills_end_in_the_same_table_to_the_bit() {
    let (scratch, sweep) = swept("batch");
    let whole = scratch.path("whole");
    let output = batch(&sweep, &whole, &["--threads", "1"]);
    assert!(output.status.success(), "{}", said(&output));
    let expected = tables(&whole);
    let csv = String::from_utf8(expected[0].clone()).unwrap();
    assert_eq!(csv.lines().count(), 6, "{csv}");
    let failed = csv.lines().last().unwrap();
    assert!(failed.contains("100") && !failed.ends_with(','), "{failed}");
    assert!(csv.lines().nth(1).unwrap().ends_with(','), "{csv}");

    // Killed in the middle, then run again with another number of threads.
    let killed = scratch.path("killed");
    let mut command = lole();
    command
        .arg("batch")
        .arg(&sweep)
        .arg("--out")
        .arg(&killed)
        .args(["--threads", "1"]);
    let mut child = command
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    while records(&killed) < 2 && child.try_wait().unwrap().is_none() {
        thread::sleep(Duration::from_millis(20));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(!killed.join("runs.csv").exists());
    let done = records(&killed);
    assert!((2..5).contains(&done), "{done}");
    let merged = batch(&sweep, &killed, &["--merge"]);
    assert_eq!(merged.status.code(), Some(1));
    assert!(said(&merged).contains("are missing"), "{}", said(&merged));
    let output = batch(&sweep, &killed, &["--threads", "3", "--json"]);
    let told: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(told["performed"], 5 - done);
    assert_eq!(told["failed"], 1);
    assert_eq!(tables(&killed), expected);

    // In shares, in folders of their own, put together.
    let shares: Vec<PathBuf> = (1..=3)
        .map(|share| scratch.path(&format!("share-{share}")))
        .collect();
    for (share, out) in (1..).zip(&shares) {
        let output = batch(&sweep, out, &["--shard", &format!("{share}/3")]);
        assert!(output.status.success(), "{}", said(&output));
        assert!(!out.join("runs.csv").exists());
    }
    let merged = scratch.path("merged");
    let from: Vec<&str> = shares
        .iter()
        .flat_map(|it| ["--from", it.to_str().unwrap()])
        .collect();
    let output = batch(&sweep, &merged, &[&["--merge"][..], &from].concat());
    assert!(output.status.success(), "{}", said(&output));
    assert_eq!(tables(&merged), expected);

    // Nothing is left to do, and nothing changes.
    let again = batch(&sweep, &whole, &["--json"]);
    let told: serde_json::Value = serde_json::from_slice(&again.stdout).unwrap();
    assert_eq!(told["performed"], 0);
    assert_eq!(tables(&whole), expected);
}

#[test]
fn equal_runs_are_performed_once_and_stand_in_the_table_as_often_as_asked() {
    let (scratch, _) = swept("batch-equal");
    let sweep = scratch.write(
        "equal.toml",
        "lole_sweep = 1\ndesign = \"small.lole\"\nkind = \"list\"\n[fixed]\n\"motion.duration_s\" = 0.5\n\
         [[axis]]\nkey = \"skirt.gather_ratio\"\nvalues = [2, 2, 2]\n",
    );
    let out = scratch.path("out");
    let output = batch(&sweep, &out, &["--threads", "3", "--json"]);
    let told: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(told["performed"], 1, "{}", said(&output));
    let csv = String::from_utf8(tables(&out)[0].clone()).unwrap();
    let rows: Vec<&str> = csv
        .lines()
        .skip(1)
        .map(|row| row.split_once(',').unwrap().1)
        .collect();
    assert_eq!(rows.len(), 3);
    assert!(rows.iter().all(|row| row == &rows[0]), "{csv}");
}

#[test]
fn a_hostile_sweep_is_one_sentence_and_leaves_nothing() {
    let scratch = Scratch::new("batch-hostile");
    scratch.write("small.lole", SMALL);
    scratch.write("broken.lole", "lole = 1\n[skirt]\nhem_hight_cm = 2\n");
    let axis = "[[axis]]\nkey = \"skirt.gather_ratio\"\nvalues = [2]\n";
    let cases = [
        (format!("design = \"nowhere.lole\"\nkind = \"grid\"\n{axis}"), "nowhere.lole: the file cannot be read"),
        (format!("design = \"broken.lole\"\nkind = \"grid\"\n{axis}"), "broken.lole:3"),
        (format!("design = \"small.lole\"\nkind = \"grid\"\n{axis}[[axis]]\nkey = \"motion.file\"\nvalues = [\"no.bvh\"]\n"), "no.bvh"),
        ("kind = \"grid\"\n[[axis]]\nkey = \"skirt.gather_ratoi\"\nvalues = [2]\n".to_owned(), "did you mean gather_ratio"),
        ("kind = \"grid\"\n[[axis]]\nkey = \"skirt.gather_ratio\"\nfrom = 1\nto = 5\ncount = 900000000\n".to_owned(), "count"),
        ("kind = \"grid\"\n[[axis]]\nkey = \"skirt.gather_ratio\"\nvalues = [nan]\n".to_owned(), "no value"),
    ];
    for (text, word) in cases {
        let sweep = scratch.write("sweep.toml", &format!("lole_sweep = 1\n{text}"));
        let out = scratch.path("out");
        let output = batch(&sweep, &out, &[]);
        assert_eq!(output.status.code(), Some(2), "{text}: {}", said(&output));
        assert!(said(&output).contains(word), "{text}: {}", said(&output));
        assert_eq!(said(&output).lines().count(), 1, "{}", said(&output));
        assert!(!out.exists(), "{text}");
    }
    let output = batch(
        &scratch.path("no.toml"),
        &scratch.path("out"),
        &["--shard", "3/2"],
    );
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output).contains("2/8"), "{}", said(&output));
}
