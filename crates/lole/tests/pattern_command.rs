//! `lole pattern` as a user meets it: its files, its sentences, its exit codes.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot be set up has failed"
)]

mod support;

use std::fs;
use std::path::Path;
use std::process::Output;

use support::{Scratch, lole};

fn pattern(design: &Path, out: &Path, more: &[&str]) -> Output {
    lole()
        .arg("pattern")
        .arg(design)
        .arg("--out")
        .arg(out)
        .args(more)
        .output()
        .unwrap()
}

#[test]
fn a_double_skirt_is_written_with_plans_sheets_and_files_for_programs() {
    let scratch = Scratch::new("pattern-files");
    let design = scratch.0.join("double.lole");
    fs::write(&design, "lole = 1\n[[garment]]\nkind = \"pau-skirt\"\n").unwrap();
    let names = [
        "cut-plan.pdf",
        "cut-plan.svg",
        "pattern.json",
        "pau_skirt.dxf",
        "pau_skirt.svg",
        "pau_underskirt.dxf",
        "pau_underskirt.svg",
        "ruler.pdf",
    ];
    let read = |out: &Path| -> Vec<(String, Vec<u8>)> {
        let mut files: Vec<(String, Vec<u8>)> = (fs::read_dir(out).unwrap())
            .map(|entry| {
                let path = entry.unwrap().path();
                let name = path.file_name().unwrap().to_string_lossy().into_owned();
                (name, fs::read(path).unwrap())
            })
            .collect();
        files.sort();
        files
    };
    let [first, second] = ["one", "two"].map(|name| scratch.0.join(name));
    let output = pattern(&design, &first, &[]);
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(output.status.code(), Some(0), "{said}");
    assert!(said.contains("buy") && said.contains("yd"), "{said}");
    let files = read(&first);
    let found: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(found, names);
    let json = pattern(&design, &second, &["--json", "--paper", "a4"]);
    assert_eq!(read(&second), files, "the same design gives the same bytes");
    let value: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(value["garments"].as_array().unwrap().len(), 2);
}

#[test]
fn what_cannot_be_drafted_is_one_sentence_with_its_place_and_writes_nothing() {
    let scratch = Scratch::new("pattern-wrong");
    let out = scratch.0.join("out");
    for (text, part) in [
        ("lole = 1\n[skirt]\nhem_hight_cm = 20\n", "hem_height_cm"),
        ("lole = 1\n\n[skirt]\nhem_height_cm = 88\n", "wrong.lole:3"),
    ] {
        let design = scratch.0.join("wrong.lole");
        fs::write(&design, text).unwrap();
        let output = pattern(&design, &out, &[]);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(part), "{said}");
        assert!(!out.exists(), "{said}");
    }
}

#[test]
fn sheets_of_the_costume_before_go() {
    let scratch = Scratch::new("pattern-again");
    let out = scratch.path("out");
    let worn = ["[[garment]]\nkind = \"blouse\"\n", ""];
    let [before, after] = worn.map(|more| {
        let design = scratch.write("costume.lole", &format!("lole = 1\n{more}"));
        assert_eq!(pattern(&design, &out, &[]).status.code(), Some(0));
        let names = fs::read_dir(&out)
            .unwrap()
            .map(|entry| entry.unwrap().file_name());
        names.collect::<Vec<_>>()
    });
    let is_of_blouse = |name: &&std::ffi::OsString| name.to_string_lossy().starts_with("blouse");
    assert!(before.iter().any(|name| is_of_blouse(&name)), "{before:?}");
    assert!(!after.iter().any(|name| is_of_blouse(&name)), "{after:?}");
    // What patterns did not write stays.
    fs::write(out.join("blouse notes.txt"), "mine").unwrap();
    let design = scratch.write("costume.lole", "lole = 1\n");
    assert_eq!(pattern(&design, &out, &[]).status.code(), Some(0));
    assert!(out.join("blouse notes.txt").exists());
}

#[test]
fn what_to_look_at_is_told_beside_json_too() {
    let scratch = Scratch::new("pattern-told");
    let design = scratch.write("blouse.lole", "lole = 1\n[[garment]]\nkind = \"blouse\"\n");
    let wishes = ["--whole", "projector", "--sizes", "en"];
    let told = |more: &[&str]| {
        let out = scratch.path("out");
        let output = pattern(&design, &out, &[&wishes[..], more].concat());
        assert_eq!(output.status.code(), Some(0));
        output
    };
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let remarks = |text: String| -> Vec<String> {
        let lines = text.lines().filter(|line| line.starts_with("  ! "));
        lines.map(str::to_owned).collect()
    };
    let plain = remarks(text(&told(&[]).stdout));
    let output = told(&["--json"]);
    assert!(!plain.is_empty(), "this one has something to tell");
    assert_eq!(remarks(text(&output.stderr)), plain);
    let _: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
}
