//! The command as a user meets it: exit codes, sentences, files, and the same bits every time.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot be set up has failed"
)]

mod support;

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use serde_json::Value;
use support::{Scratch, lole};

/// A skirt coarse enough that a run takes seconds; everything else as by default.
const SMALL: &str = "lole = 1\n[skirt]\ncolumn_count = 96\nrow_count = 40\n";

fn dance(design: &Path, out: &Path, more: &[&str]) -> Output {
    let small = ["--cpu", "--seconds", "0.5", "--size", "128x72", "--json"];
    lole()
        .arg("dance")
        .arg(design)
        .arg("--out")
        .arg(out)
        .args(small)
        .args(more)
        .output()
        .unwrap()
}

fn sentence(output: &Output) -> String {
    let text = String::from_utf8(output.stderr.clone()).unwrap();
    let lines: Vec<&str> = text
        .lines()
        .filter(|line| line.starts_with("lole: "))
        .collect();
    assert_eq!(lines.len(), 1, "one sentence, not: {text}");
    lines[0].to_owned()
}

#[test]
fn a_wrong_document_is_one_sentence_with_its_line_and_writes_nothing() {
    let scratch = Scratch::new("wrong");
    let out = scratch.path("out");
    let cases = [
        (
            "lole = 1\n[skirt]\nhem_hight_cm = 20\n",
            ":3",
            "hem_height_cm",
        ),
        (
            "lole = 1\n[skirt]\nhem_height_cm = \"low\"\n",
            ":3",
            "number",
        ),
        ("lole = 1\n[dancer]\n\nhip_cm = -91\n", ":4", "55"),
        ("lole = 1\n[dancer]\nstature_cm = 1e99\n", ":3", "195"),
        ("lole = 1\n[motion]\nstep = \"kaholoo\"\n", ":3", "kaholo"),
        ("lole = 2\n", ":1", "lole"),
        ("[skirt]\n", "", "lole = 1"),
        ("lole = 1\n[skirt\n", ":2", "TOML"),
    ];
    for (text, line, remedy) in cases {
        let design = scratch.write("wrong.lole", text);
        let output = dance(&design, &out, &[]);
        let found = sentence(&output);
        assert_eq!(output.status.code(), Some(2), "{text}: {found}");
        assert!(
            found.contains(&format!("wrong.lole{line}")),
            "{text}: {found}"
        );
        assert!(found.contains(remedy), "{text}: {found}");
        assert!(!out.exists(), "{text}");
    }
}

/// A coarse double skirt with a top.
const LAYERS: &str = "lole = 1\n[skirt]\ncolumn_count = 96\nrow_count = 40\nhem_height_cm = 34\ngather_ratio = 2\n\
    [[garment]]\nkind = \"pau-skirt\"\ncolumn_count = 96\nrow_count = 40\n\
    [[garment]]\nkind = \"pau-top\"\ncolumn_count = 96\nrow_count = 24\n";

#[test]
fn a_double_skirt_and_a_top_are_three_named_meshes_in_the_file() {
    let scratch = Scratch::new("layers");
    let design = scratch.write("layers.lole", LAYERS);
    let out = scratch.path("out");
    let output = dance(&design, &out, &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["particles"], 2 * 96 * 40 + 96 * 24);
    let glb = fs::read(out.join("dancer.glb")).unwrap();
    // Header of 12 bytes, then the length and the kind of the chunk of JSON.
    let length = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
    let scene: Value = serde_json::from_slice(&glb[20..20 + length]).unwrap();
    let names: Vec<&str> = (scene["meshes"].as_array().unwrap().iter())
        .filter_map(|mesh| mesh["name"].as_str())
        .filter(|name| name.starts_with("pau_"))
        .collect();
    assert_eq!(names, ["pau_underskirt", "pau_skirt", "pau_top"]);
    let again = fs::read_to_string(out.join("design.lole")).unwrap();
    assert_eq!(again.matches("[[garment]]").count(), 2);
}

#[test]
fn wrong_usage_is_refused_before_anything_is_computed() {
    let scratch = Scratch::new("usage");
    let design = scratch.write("small.lole", SMALL);
    let out = scratch.path("out");
    let file = scratch.write("file", "in the way");
    let missing = scratch.path("missing.lole");
    let inside = file.join("out");
    let cases: [(&Path, &Path, &[&str], &str); 6] = [
        (&missing, &out, &[], "missing.lole"),
        (&scratch.0, &out, &[], "no ordinary file"),
        (&design, &inside, &[], "--out"),
        (
            &design,
            &out,
            &["--step", "kaholoo"],
            "did you mean kaholo?",
        ),
        (&design, &out, &["--bpm", "nan"], "tempo_bpm"),
        (&design, &out, &["--method", "fb_eular"], "fb-euler"),
    ];
    for (design, out, more, part) in cases {
        let output = dance(design, out, more);
        let found = sentence(&output);
        assert_eq!(output.status.code(), Some(2), "{found}");
        assert!(found.contains(part), "{found}");
        assert!(!scratch.path("out").exists(), "{found}");
    }
    let output = lole().args(["dance", "--seconds", "-1"]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn a_run_writes_every_file_and_the_same_bits_on_any_number_of_threads() {
    let scratch = Scratch::new("run");
    let design = scratch.write("small.lole", SMALL);
    let run = |design: &Path, name: &str, threads: &str| -> Value {
        let out = scratch.path(name);
        let output = dance(design, &out, &["--threads", threads]);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{text}");
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let one = run(&design, "one", "1");
    for name in [
        "dance.mp4",
        "front.png",
        "side.png",
        "back.png",
        "three-quarter.png",
        "dancer.glb",
        "counts.csv",
        "design.lole",
        "report.html",
        "report.json",
    ] {
        let size = fs::metadata(scratch.path("one").join(name)).unwrap().len();
        assert!(50 < size, "{name} has {size} bytes");
    }
    assert_eq!(fs::read_dir(scratch.path("one")).unwrap().count(), 10);
    assert_eq!(one["finite"], true);
    assert_eq!(one["particles"], 96 * 40);
    assert_eq!(one["frames"], 30);
    assert!(one["strain_pct"]["max"].as_f64().unwrap().is_finite());
    let two = run(&scratch.path("one").join("design.lole"), "two", "2");
    let three = run(&design, "three", "3");
    assert_eq!(
        one["state_hash"], two["state_hash"],
        "the written design repeats the run"
    );
    assert_eq!(one["state_hash"], three["state_hash"]);
}

#[test]
fn a_garment_tells_which_piece_lies_outside() {
    let scratch = Scratch::new("outside");
    let text = "lole = 1\n[skirt]\nworn = \"no\"\n[[garment]]\nkind = \"malo\"\n";
    let design = scratch.write("malo.lole", text);
    let output = dance(&design, &scratch.path("out"), &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    let malo = &report["garments"][0];
    let over = malo["over"].as_array().unwrap();
    let places = over.iter().map(|it| it["places"].as_u64().unwrap());
    assert!(100 < places.clone().sum::<u64>(), "{malo}");
    assert_eq!(malo["overlapping_places"], places.sum::<u64>());
    assert_eq!(malo["inverted_places"]["worst"], 0);
    let page = fs::read_to_string(scratch.path("out").join("report.html")).unwrap();
    for piece in [&over[0]["outer"], &over[0]["outer_ja"]] {
        assert!(page.contains(piece.as_str().unwrap()), "{piece}");
    }
}

#[test]
fn a_run_that_diverges_says_so_and_still_reports() {
    let scratch = Scratch::new("diverges");
    let text = format!("{SMALL}[method]\nname = \"fb-euler\"\nsubstep_count = 1\n");
    let design = scratch.write("wild.lole", &text);
    let out = scratch.path("out");
    let output = dance(&design, &out, &[]);
    let found = sentence(&output);
    assert_eq!(output.status.code(), Some(1), "{found}");
    assert!(
        found.contains("diverged") && found.contains("substep_count"),
        "{found}"
    );
    let report = fs::read_to_string(out.join("report.json")).unwrap();
    let report: Value = serde_json::from_str(&report).unwrap();
    assert_eq!(report["finite"], false);
    assert!(report["divergence"]["particle"].is_u64(), "{report}");
    assert!(!out.join("dance.mp4").exists());
}

#[test]
fn a_validation_prints_its_rows_and_writes_its_page() {
    let scratch = Scratch::new("validate");
    let out = scratch.path("out");
    let output = lole()
        .args(["validate", "--only", "pendulum", "--json", "--out"])
        .arg(&out)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", sentence(&output));
    let rows: Value = serde_json::from_slice(&output.stdout).unwrap();
    let rows = rows.as_array().unwrap();
    assert_eq!(rows.len(), 8, "four amplitudes by two methods");
    for row in rows {
        assert_eq!(row["name"], "pendulum");
        assert_eq!(row["pass"], true, "{row}");
        let [error, gate] = ["error_pct", "gate_pct"].map(|key| row[key].as_f64().unwrap());
        assert!(error.abs() <= gate, "{row}");
        let [measured, reference] = ["measured", "reference"].map(|key| row[key].as_f64().unwrap());
        assert!((100.0 * (measured / reference - 1.0) - error).abs() < 1e-9);
    }
    let page = fs::read_to_string(out.join("validation.html")).unwrap();
    assert_eq!(page.matches("<circle").count(), 8);
    let written = fs::read(out.join("validation.json")).unwrap();
    let written: Value = serde_json::from_slice(&written).unwrap();
    assert_eq!(&written, &Value::from(rows.clone()));
}

#[test]
fn a_bench_refuses_what_does_not_go_together_and_prints_its_rows() {
    for (words, part) in [
        (["--scene", "hang-46"].as_slice(), "did you mean hang-64?"),
        (&["--seed", "3"], "--soak"),
        (&["--sizes", "--pareto"], "--sizes"),
        (&["--soak", "many"], "whole number"),
        (&["--soak", "9", "--scene", "pau-fine"], "choose one of"),
    ] {
        let output = lole().arg("bench").args(words).output().unwrap();
        let found = sentence(&output);
        assert_eq!(output.status.code(), Some(2), "{found}");
        assert!(found.contains(part), "{found}");
    }
    let rows = |words: &[&str]| -> Value {
        let output = lole()
            .args(["bench", "--json", "--scene", "hang-64"])
            .args(words)
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(0), "{words:?}");
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let table = rows(&["--method", "xpbd"]);
    assert_eq!(table.as_array().unwrap().len(), 1);
    assert_eq!(table[0]["scene"], "hang-64");
    assert_eq!(table[0]["spring_roofline"], Value::Null);
    assert!(0.0 < table[0]["ratio_to_reference"].as_f64().unwrap());
    let soaked = rows(&["--soak", "120", "--seed", "5"]);
    assert_eq!(soaked[0]["frames"], 120);
    assert_eq!(soaked[0]["violations"], Value::Array(Vec::new()));
    assert_eq!(
        soaked,
        rows(&["--soak", "120", "--seed", "5", "--threads", "3"])
    );
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_no_file() {
    let scratch = Scratch::new("interrupted");
    let design = scratch.write("small.lole", SMALL);
    let out = scratch.path("out");
    let mut child = lole()
        .args(["dance", "--cpu", "--seconds", "600", "--size", "128x72"])
        .arg(&design)
        .arg("--out")
        .arg(&out)
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    while !out.exists() {
        assert!(
            child.try_wait().unwrap().is_none(),
            "ended before it was interrupted"
        );
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    // The handler is set right after the folder is made.
    std::thread::sleep(std::time::Duration::from_millis(500));
    let killed = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status()
        .unwrap();
    assert!(killed.success());
    let status = child.wait().unwrap();
    assert_eq!(status.code(), Some(130));
    assert!(!out.exists());
}

#[test]
fn a_dancer_is_shown_from_four_sides_with_the_tape_on_her_body() {
    let scratch = Scratch::new("dancer");
    let tape = "lole = 1\n[dancer]\nstature_cm = 165\nhip_cm = 104\nwaist_cm = 84\n";
    let design = scratch.write("her.lole", tape);
    let out = scratch.path("out");
    let run = |design: &Path, more: &[&str]| {
        let mut command = lole();
        command.arg("dancer").arg(design).args(["--cpu", "--json"]);
        command.arg("--out").arg(&out).args(more).output().unwrap()
    };
    let output = run(&design, &[]);
    assert!(output.status.success(), "{}", sentence(&output));
    let sheet: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(
        sheet["worst_difference_cm"].as_f64().unwrap() < 0.3,
        "{sheet}"
    );
    let given = |measure: &&Value| measure["given_cm"].is_f64();
    let measures = sheet["measures"].as_array().unwrap();
    assert_eq!(measures.iter().filter(given).count(), 3);
    assert_eq!(sheet["capsules"].as_array().unwrap().len(), 13);
    for file in ["front.png", "side.png", "back.png", "three-quarter.png"] {
        assert!(out.join(file).exists(), "{file}");
    }
    let glb = fs::read(out.join("dancer.glb")).unwrap();
    assert_eq!(&glb[..4], b"glTF");

    // What the command line names is not looked for in the document.
    let nobody = scratch.write("nobody.vrm", "not an avatar");
    let refused = run(&design, &["--avatar", nobody.to_str().unwrap()]);
    assert_eq!(refused.status.code(), Some(2));
    let said = sentence(&refused);
    assert!(
        said.contains("nobody.vrm") && !said.contains("her.lole"),
        "{said}"
    );
}

#[test]
fn messages_repeat_little_of_what_was_given_and_no_control_characters() {
    let long = format!("a\u{1b}[2J\u{202e}b{}", "c".repeat(50_000));
    for words in [
        vec!["fabric", &long],
        vec!["bench", "--scene", &long],
        vec![&long],
        vec!["dance", "--seconds", &long],
        vec!["cost", &long],
    ] {
        let output = lole().args(&words).output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_ne!(output.status.code(), Some(0), "{said}");
        let is_plain =
            |letter: char| letter == '\n' || !letter.is_control() && letter != '\u{202e}';
        assert!(said.chars().all(is_plain), "{said:?}");
        assert!(said.chars().count() < 1500, "{said}");
    }
}

/// What other commands read is told which, in one sentence.
#[test]
fn inspect_says_what_reads_a_design_or_a_take() {
    let scratch = Scratch::new("inspect");
    for (name, command) in [("a.lole", "lole dance"), ("a.take", "lole export")] {
        let file = scratch.write(name, "lole = 1\n");
        let output = lole().arg("inspect").arg(&file).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(command), "{said}");
    }
}

#[cfg(unix)]
#[test]
fn the_name_of_a_file_does_not_steer_the_terminal() {
    let scratch = Scratch::new("names");
    let list = scratch.write("a\u{1b}]0;x\u{7}.bvh", "");
    let output = lole().arg("inspect").arg(&list).output().unwrap();
    let out = scratch.path("b\u{1b}[2J");
    let form = lole()
        .arg("form")
        .arg("--out")
        .arg(out.join("form.pdf"))
        .output();
    for output in [output, form.unwrap()] {
        let all = [output.stdout, output.stderr].concat();
        assert!(!all.is_empty() && !all.contains(&0x1b), "{all:?}");
    }
}

#[cfg(unix)]
#[test]
fn only_ordinary_files_are_read() {
    let scratch = Scratch::new("ordinary");
    let design = |text: &str| scratch.write("design.lole", &format!("lole = 1\n{text}\n"));
    let out = scratch.path("out");
    let refused = |design: &Path| {
        let command = lole()
            .arg("pattern")
            .arg(design)
            .arg("--out")
            .arg(&out)
            .output();
        let output = command.unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains("no ordinary file"), "{said}");
        assert!(!out.exists());
    };
    // A device that has no end, and one in which there is nothing.
    refused(&design("[dancer]\nfile = \"/dev/zero\""));
    refused(&design("[print]\nfile = \"/dev/null\""));
    refused(Path::new("/dev/zero"));
    let list = lole()
        .args(["order", "/dev/zero"])
        .arg("--out")
        .arg(&out)
        .output();
    assert_eq!(list.unwrap().status.code(), Some(2));
    let avatar = lole().args(["inspect", "/dev/zero"]).output();
    assert_eq!(avatar.unwrap().status.code(), Some(2));
}

#[cfg(target_os = "linux")]
#[test]
fn an_output_that_is_lost_is_a_failure_and_one_that_nobody_reads_is_none() {
    let full = fs::OpenOptions::new()
        .write(true)
        .open("/dev/full")
        .unwrap();
    let output = lole()
        .args(["fabric", "--json"])
        .stdout(full)
        .output()
        .unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("could not be written"), "{said}");
    let mut child = lole().arg("fabric").stdout(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    assert_eq!(child.wait().unwrap().code(), Some(0));
}

#[test]
fn lists_and_avatars_that_would_fill_the_memory_are_refused() {
    let scratch = Scratch::new("large");
    let design = scratch.write("design.lole", "lole = 1\n");
    for (text, expected) in [
        (
            format!("name,hip\n{}", "\n".repeat(4_000_000)),
            "no dancers",
        ),
        (
            format!("name,hip\n{}", "a,90\n".repeat(100_000)),
            "at most 1000",
        ),
        (",".repeat(1_000_000), "500 cells"),
    ] {
        let list = scratch.write("list.csv", &text);
        let order = lole()
            .arg("order")
            .arg(&list)
            .arg(&design)
            .arg("--out")
            .arg(scratch.path("out"))
            .output();
        let said = String::from_utf8(order.unwrap().stderr).unwrap();
        assert!(said.contains(expected), "{said}");
    }
    for key in ["nodes", "materials", "extras"] {
        let items = "{},".repeat(600_000);
        let text = format!("{{\"asset\":{{\"version\":\"2.0\"}},\"{key}\":[{items}{{}}]}}");
        let avatar = scratch.write("avatar.gltf", &text);
        let output = lole().arg("inspect").arg(&avatar).output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains("500000"), "{said}");
    }
}
