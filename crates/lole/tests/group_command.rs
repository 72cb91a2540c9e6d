//! A group in one film, as a user meets it.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot be set up has failed"
)]

mod support;

use std::fs;
use std::process::Output;

use serde_json::Value;
use support::{Scratch, lole};

const SMALL: &str = "lole = 1\n[skirt]\ncolumn_count = 112\nrow_count = 20\n";
const LIST: &str = "name,stature,bust,waist,hip\nHanako,158,83,66,91\nʻIolana,170,96,80,104\n";

/// Dances a group for a moment.
fn group(scratch: &Scratch, list: &str, out: &str, more: &[&str]) -> Output {
    let design = scratch.write("small.lole", SMALL);
    let list = scratch.write("list.csv", list);
    lole()
        .arg("dance")
        .arg(design)
        .arg("--out")
        .arg(scratch.path(out))
        .arg("--dancers")
        .arg(list)
        .args(["--cpu", "--seconds", "0.5", "--size", "160x90"])
        .args(more)
        .output()
        .unwrap()
}

fn report(scratch: &Scratch, out: &str) -> Value {
    serde_json::from_slice(&fs::read(scratch.path(out).join("group.json")).unwrap()).unwrap()
}

#[test]
fn a_group_dances_in_one_film_and_everybody_as_she_would_alone() {
    let scratch = Scratch::new("group");
    let output = group(&scratch, LIST, "rows", &["--threads", "2"]);
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{text}");
    let names = [
        "dance.mp4",
        "front.png",
        "side.png",
        "back.png",
        "three-quarter.png",
        "counts.csv",
        "design.lole",
        "group.json",
    ];
    for name in names {
        let size = fs::metadata(scratch.path("rows").join(name)).unwrap().len();
        assert!(50 < size, "{name} has {size} bytes");
    }
    let files = fs::read_dir(scratch.path("rows")).unwrap().count();
    assert_eq!(files, names.len());
    let two = report(&scratch, "rows");
    assert_eq!(two["dancers"][0]["name"], "Hanako");
    assert_eq!(two["dancers"][1]["name"], "ʻIolana");
    let apart = |axis: usize| {
        let at = |place: usize| two["dancers"][place]["place_m"][axis].as_f64().unwrap();
        at(1) - at(0)
    };
    assert!(1.0 < apart(0) * apart(0) + apart(1) * apart(1));
    assert_ne!(
        two["dancers"][0]["state_hash"],
        two["dancers"][1]["state_hash"]
    );

    let alone = LIST.lines().take(2).collect::<Vec<_>>().join("\n");
    let output = group(
        &scratch,
        &alone,
        "alone",
        &["--formation", "circle", "--threads", "1"],
    );
    assert_eq!(output.status.code(), Some(0));
    let one = report(&scratch, "alone");
    assert_eq!(one["dancers"][0]["place_m"], serde_json::json!([0.0, 0.0]));
    assert_eq!(
        one["dancers"][0]["state_hash"], two["dancers"][0]["state_hash"],
        "nobody changes how another dances, and no number of threads does"
    );
}

#[test]
fn a_group_that_cannot_dance_is_refused_in_a_sentence() {
    let scratch = Scratch::new("no-group");
    let many: String = (0..25).map(|it| format!("{it},158,83,66,91\n")).collect();
    let many = format!("name,stature,bust,waist,hip\n{many}");
    let heads = "name,stature,bust,waist,hip\n";
    let cases: [(&str, &[&str], &str); 7] = [
        (
            "name,stature,bust,waist,hip\nHanako,158,83,66,91\nMele,100,140,120,140\n",
            &[],
            "list.csv: line 3, Mele: bust girth",
        ),
        (&many, &[], "25 dancers are listed, and a film holds 24"),
        (heads, &[], "no dancers"),
        ("name,hip\nHanako,x\n", &[], "line 2"),
        (
            LIST,
            &["--formation", "spiral"],
            "choose one of rows, line, wedge, circle",
        ),
        (LIST, &["--spacing", "10"], "from 60 to 500"),
        (LIST, &["--json"], "do not go together"),
    ];
    for (list, more, said) in cases {
        let output = group(&scratch, list, "none", more);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(text.contains(said), "{text}");
        assert!(!scratch.path("none").exists(), "{text}");
    }
    let output = lole()
        .args(["dance", "--formation", "line"])
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{text}");
    assert!(text.contains("--dancers"), "{text}");
}
