//! How the command behaves among others: pipes, silence, completions, manual pages.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot be set up has failed"
)]

mod support;

use std::fs;
use std::io::Write as _;
use std::process::{Output, Stdio};

use support::{Scratch, lole};

/// Runs the command with this on its standard input.
fn piped(arguments: &[&str], input: &str, scratch: &Scratch) -> Output {
    let mut child = lole()
        .args(arguments)
        .current_dir(&scratch.0)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(input.as_bytes())
        .unwrap();
    child.wait_with_output().unwrap()
}

#[test]
fn a_design_is_piped_in_and_its_booklet_out() {
    let scratch = Scratch::new("piped");
    let design = "lole = 1\n[skirt]\nhem_height_cm = 30\n";
    let asked = ["booklet", "-", "--no-pictures", "--language", "en", "--out"];
    let out = piped(&[&asked[..], &["-"]].concat(), design, &scratch);
    assert_eq!(out.status.code(), Some(0));
    assert!(out.stdout.starts_with(b"%PDF-"));
    assert!(fs::read_dir(&scratch.0).unwrap().next().is_none());
    let wrong = piped(
        &[&asked[..], &["-"]].concat(),
        "lole = 1\n[skrt]\n",
        &scratch,
    );
    assert_eq!(wrong.status.code(), Some(2));
    assert!(wrong.stdout.is_empty());
    assert!(String::from_utf8_lossy(&wrong.stderr).contains("-:2"));
}

#[test]
fn a_list_is_piped_in_and_letters_that_are_not_printed_are_told() {
    let scratch = Scratch::new("list-piped");
    fs::write(scratch.0.join("a.lole"), "lole = 1\n").unwrap();
    let list = "name,hip\n김 Kim,91\n";
    let asked = ["order", "-", "a.lole", "--no-pictures", "--out", "o"];
    let out = piped(&asked, list, &scratch);
    let said = String::from_utf8_lossy(&out.stdout).into_owned();
    assert_eq!(out.status.code(), Some(0), "{said}");
    assert!(
        said.contains("o/order.pdf") && said.contains('김'),
        "{said}"
    );
    let quiet = piped(&[&asked[..], &["--quiet"]].concat(), list, &scratch);
    let said = String::from_utf8_lossy(&quiet.stdout).into_owned();
    assert_eq!(quiet.status.code(), Some(0));
    // Warnings stay, and nothing else.
    assert!(!said.contains("order.pdf") && said.contains('김'), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
}

#[test]
fn shells_and_manuals_know_every_command() {
    let scratch = Scratch::new("handbook");
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let out = piped(&["completions", shell], "", &scratch);
        let script = String::from_utf8(out.stdout).unwrap();
        assert_eq!(out.status.code(), Some(0));
        assert!(
            script.contains("booklet") && script.contains("match-print"),
            "{shell}"
        );
    }
    let out = piped(&["man", "--out", "man"], "", &scratch);
    assert_eq!(out.status.code(), Some(0));
    let page = |name: &str| fs::read_to_string(scratch.0.join("man").join(name)).unwrap();
    assert!(page("lole.1").starts_with(".ie") || page("lole.1").contains(".TH lole"));
    assert!(page("lole-order.1").contains("no\\-pictures"));
}
