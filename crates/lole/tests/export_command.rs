//! `lole export`: what it writes opens in the programs of others, and a recording that was stopped goes on.
//!
//! Blender and OpenUSD are asked through Python (`LOLE_PYTHON`, else `python3`), the Khronos validator through Node
//! (`NODE_MODULES` says where its packages are); what is not installed is printed as skipped.
#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test that cannot be set up has failed, and what is not tested is said"
)]

mod support;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;
use support::{Scratch, in_english, lole};

/// A coarse double skirt under a blouse, with a lei: gathered cloth, sewn cloth, and strands.
const LAYERS: &str = "lole = 1\n[skirt]\ncolumn_count = 96\nrow_count = 40\nhem_height_cm = 34\n\
    [[garment]]\nkind = \"pau-skirt\"\ncolumn_count = 96\nrow_count = 40\nhem_height_cm = 40\n\
    [[garment]]\nkind = \"blouse\"\n[[garment]]\nkind = \"lei\"\n";
/// A single coarse skirt.
const SKIRT: &str = "lole = 1\n[skirt]\ncolumn_count = 96\nrow_count = 40\n";

fn export(source: &Path, out: &Path, more: &[&str]) -> Output {
    let mut command = lole();
    command.arg("export").arg(source).arg("--out").arg(out);
    command.args(["--json"]).args(more).output().unwrap()
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn told(output: &Output) -> Value {
    assert!(output.status.success(), "{}", said(output));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn tool(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../tools")
        .join(name)
}

#[test]
fn a_dance_opens_in_the_programs_of_others_where_it_was_danced() {
    let scratch = Scratch::new("export-all");
    let design = scratch.write("layers.lole", LAYERS);
    let out = scratch.path("out");
    let formats = "glb,npz,pc2,mdd,obj,csv,usd,usdz";
    let wishes = ["--seconds", "0.5", "--fps", "30", "--format", formats];
    let told = told(&export(&design, &out, &wishes));
    assert_eq!(told["frames"], 15);
    assert_eq!(told["frame_rate"], 30);
    for file in told["files"].as_array().unwrap() {
        assert!(Path::new(file.as_str().unwrap()).is_file(), "{file}");
    }
    let python = std::env::var("LOLE_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let numpy = Command::new(&python).args(["-c", "import numpy"]).output();
    if numpy.is_ok_and(|output| output.status.success()) {
        let checked = Command::new(&python)
            .arg(tool("take_check.py"))
            .arg(&out)
            .output()
            .unwrap();
        let text = String::from_utf8_lossy(&checked.stdout);
        println!("{text}");
        assert!(checked.status.success(), "{text}{}", said(&checked));
    } else {
        println!("skipped: no NumPy for {python} (pip install numpy usd-core bpy)");
    }
    ask_node("gltf_check.mjs", &out.join("dance.glb"));
}

/// Asks a tool of Node about a file; what is not installed is printed.
fn ask_node(script: &str, file: &Path) {
    let Ok(checked) = Command::new("node").arg(tool(script)).arg(file).output() else {
        println!("skipped: no Node here");
        return;
    };
    let text = String::from_utf8_lossy(&checked.stdout);
    println!("{text}");
    let said = said(&checked);
    assert!(matches!(checked.status.code(), Some(0 | 3)), "{text}{said}");
}

#[test]
fn a_costume_is_an_avatar_whose_skirt_swings() {
    let scratch = Scratch::new("vrm");
    let design = scratch.write("layers.lole", LAYERS);
    let out = scratch.path("out");
    let mut command = lole();
    command.arg("vrm").arg(&design).arg("--out").arg(&out);
    let wishes = [
        "--seconds",
        "1",
        "--author",
        "Mele",
        "--author",
        "Kai",
        "--json",
    ];
    let told = told(&command.args(wishes).output().unwrap());
    let number = |key: &str| told[key].as_f64().unwrap();
    assert!(number("mean_mm") <= number("worst_mm"), "{told}");
    // Chains stand for sectors of a skirt 60 cm long, not for its folds.
    assert!((0.1..60.0).contains(&number("mean_mm")), "{told}");
    assert!((0.0..=1.0).contains(&number("leg_share")), "{told}");
    let file = out.join("costume.vrm");
    // Our own reader, which knows nothing of the writer.
    let read = lole()
        .arg("inspect")
        .arg(&file)
        .arg("--json")
        .output()
        .unwrap();
    assert!(read.status.success(), "{}", said(&read));
    assert!(String::from_utf8_lossy(&read.stdout).contains("Mele"));
    ask_node("gltf_check.mjs", &file);
    ask_node("vrm_check.mjs", &file);
}

#[test]
fn a_recording_that_was_cut_off_goes_on_to_the_same_bits() {
    let scratch = Scratch::new("export-resume");
    let design = scratch.write("skirt.lole", SKIRT);
    let wishes = ["--seconds", "0.5", "--fps", "20", "--format", "csv"];
    let out = scratch.path("out");
    told(&export(&design, &out, &wishes));
    let whole = fs::read(out.join("dance.take")).unwrap();
    let table = fs::read(out.join("pau_skirt.csv")).unwrap();
    let cut = scratch.path("cut");
    fs::create_dir_all(&cut).unwrap();
    fs::write(cut.join("unfinished.take"), &whole[..whole.len() * 2 / 3]).unwrap();
    let output = export(&design, &cut, &wishes);
    assert!(
        said(&output).contains("frames are recorded"),
        "{}",
        said(&output)
    );
    told(&output);
    assert!(fs::read(cut.join("dance.take")).unwrap() == whole);
    assert!(fs::read(cut.join("pau_skirt.csv")).unwrap() == table);
    assert!(!cut.join("unfinished.take").exists());
    // From the take alone, and then nothing can be wished of the dance.
    let again = scratch.path("again");
    told(&export(
        &out.join("dance.take"),
        &again,
        &["--format", "csv"],
    ));
    assert!(fs::read(again.join("pau_skirt.csv")).unwrap() == table);
    let refused = export(&out.join("dance.take"), &again, &wishes);
    assert_eq!(refused.status.code(), Some(2));
    assert!(said(&refused).contains("--fps"), "{}", said(&refused));
}

/// A limit on the size of files stands for a disk without room.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_frames_that_were_whole() {
    let scratch = Scratch::new("export-full");
    let design = scratch.write("skirt.lole", SKIRT);
    let out = scratch.path("out");
    let wishes = "--seconds 0.5 --fps 20 --format csv --json";
    let shell = |limit: &str| {
        let line = format!(
            "trap '' XFSZ; {limit}; exec '{}' export '{}' --out '{}' {wishes}",
            env!("CARGO_BIN_EXE_lole"),
            design.display(),
            out.display()
        );
        let mut command = in_english(Command::new("sh"));
        command.args(["-c", &line]).output().unwrap()
    };
    // Blocks have 512 bytes, in some shells 1,024: a few frames of ten either way.
    let full = shell("ulimit -f 2000");
    assert_eq!(full.status.code(), Some(1), "{}", said(&full));
    assert!(said(&full).contains("frames are whole"), "{}", said(&full));
    assert_eq!(
        fs::read_dir(&out).unwrap().count(),
        1,
        "the recording alone"
    );
    let unfinished = out.join("unfinished.take");
    let some = told(&export(
        &unfinished,
        &scratch.path("some"),
        &["--format", "csv"],
    ));
    let frames = some["frames"].as_u64().unwrap();
    assert!((1..10).contains(&frames), "{frames}");
    // With room again it goes on.
    let told = told(&shell("true"));
    assert_eq!(told["frames"], 10);
}

#[test]
fn what_is_no_take_is_refused_in_a_sentence() {
    let scratch = Scratch::new("export-no-take");
    let out = scratch.path("out");
    for text in ["", "LOLETAKE", "lole = 1\n"] {
        let junk = scratch.write("junk.take", text);
        let output = export(&junk, &out, &["--format", "csv"]);
        assert_eq!(output.status.code(), Some(2));
        assert!(said(&output).contains("junk.take: "), "{}", said(&output));
        assert!(!out.exists());
    }
}

#[cfg(unix)]
#[test]
fn a_recording_that_is_stopped_says_what_it_keeps() {
    let scratch = Scratch::new("export-stopped");
    let design = scratch.write("skirt.lole", SKIRT);
    let out = scratch.path("out");
    let errors = scratch.path("errors");
    let kept = || fs::metadata(out.join("unfinished.take")).map_or(0, |it| it.len());
    // Interrupted when that is true; what it says.
    let stopped = |is_time: &dyn Fn() -> bool| {
        let mut command = in_english(lole());
        command.arg("export").arg(&design).arg("--out").arg(&out);
        command.args(["--seconds", "600", "--format", "npz"]);
        command.stderr(fs::File::create(&errors).unwrap());
        let mut child = command.spawn().unwrap();
        while !is_time() {
            assert!(child.try_wait().unwrap().is_none(), "it ended by itself");
            std::thread::sleep(std::time::Duration::from_millis(20));
        }
        let interrupt = Command::new("kill")
            .args(["-INT", &child.id().to_string()])
            .status();
        assert!(interrupt.unwrap().success());
        assert_eq!(child.wait().unwrap().code(), Some(130));
        fs::read_to_string(&errors).unwrap()
    };
    // Before a frame is danced there is only a header of some kilobytes.
    let said = stopped(&|| 0 < kept());
    assert!(said.contains("nothing half-written"), "{said}");
    assert_eq!(kept(), 0);
    // A frame of 3,840 particles and the dancer is more than 60 kB.
    let said = stopped(&|| 1 << 20 < kept());
    assert!(said.contains("unfinished.take keeps"), "{said}");
    assert!(!said.contains("nothing half-written"), "{said}");
    // Again, while the cloth comes to rest: the frames are still there, and it says so.
    let before = kept();
    let is_found = || fs::read_to_string(&errors).is_ok_and(|it| it.contains("unfinished.take"));
    let said = stopped(&is_found);
    assert!(said.contains("unfinished.take keeps"), "{said}");
    assert!(before <= kept());
}
