//! Files, dancers and cloth with names that mean something to a terminal, a shell, a spreadsheet or a browser: the
//! command writes its files as with any other names, and shows nothing that would be followed.
#![cfg(unix)]
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot be set up has failed"
)]

mod support;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Output;

use lole_language::is_unseen;
use support::Scratch;

/// A file may be called anything that holds no slash.
const FILE: &str = "=cmd|<img src=x onerror=alert(1)>\"'&\u{1b}[2J\u{202e}\n  0\n) \\.lole";

fn lole(arguments: &[&str], paths: &[&Path], out: &Path) -> Output {
    let output = support::lole()
        .args(arguments)
        .args(paths)
        .arg("--out")
        .arg(out)
        .output()
        .unwrap();
    for said in [&output.stdout, &output.stderr] {
        let said = String::from_utf8_lossy(said);
        let followed = |letter: &char| is_unseen(*letter) && *letter != '\n';
        assert_eq!(said.chars().find(followed), None, "{said:?}");
    }
    output
}

fn names(folder: &Path) -> BTreeSet<String> {
    let all = fs::read_dir(folder).unwrap();
    all.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .collect()
}

#[test]
fn the_name_of_a_design_is_only_a_name() {
    let scratch = Scratch::new("hostile-design");
    let text = "lole = 1\n[fabric]\nname = \"<script>alert(1)</script>\u{202e}\"\n";
    let [hostile, plain] = [FILE, "plain.lole"].map(|name| scratch.0.join(name));
    let [one, other] = ["one", "other"].map(|name| scratch.0.join(name));
    for (design, out) in [(&hostile, &one), (&plain, &other)] {
        fs::write(design, text).unwrap();
        let output = lole(&["pattern", "--json"], &[design], out);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{said}");
        let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(json["unit"], "cm");
    }
    assert_eq!(names(&one), names(&other));
    for name in names(&one).iter().filter(|name| name.ends_with(".svg")) {
        let drawing = fs::read_to_string(one.join(name)).unwrap();
        assert!(
            !drawing.contains("<script") && !drawing.contains("<img"),
            "{name}"
        );
    }
}

#[test]
fn names_of_dancers_are_only_names() {
    let scratch = Scratch::new("hostile-dancers");
    let design = scratch.0.join(FILE);
    fs::write(&design, "lole = 1\n").unwrap();
    let list = scratch.0.join("list.csv");
    let dancers = [
        "../../../../tmp/x",
        "\u{1b}]0;title\u{7}",
        "\u{202e}gnp.exe",
        "a\u{9b}2J",
        "$(touch x)",
        "<script>alert(1)</script>",
    ];
    let rows: String = dancers
        .iter()
        .map(|name| format!("\"{name}\",158,91\n"))
        .collect();
    fs::write(&list, format!("name,stature,hip\n{rows}")).unwrap();
    let out = scratch.0.join("out");
    let output = lole(
        &["order", "--no-pictures", "--json"],
        &[&list, &design],
        &out,
    );
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{said}");
    // What a program reads is what was written, though a terminal followed nothing of it.
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    for (index, name) in dancers.iter().enumerate() {
        assert_eq!(json["dancers"][index]["name"], *name);
    }
    let found = names(&out);
    let expected = ["booklet.pdf", "order.json", "order.pdf"].map(str::to_owned);
    assert_eq!(found, expected.into());
    let sheets = out.join("forms.pdf");
    let output = lole(&["form"], &[&list], &sheets);
    assert_eq!(output.status.code(), Some(0));
    assert!(sheets.is_file());
}
