//! An order with pictures: who cannot be cut for has none, and what was photographed once is not again.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot be set up has failed"
)]

mod support;

use std::fs;
use std::path::Path;
use std::process::Output;
use std::time::SystemTime;

use support::{Scratch, lole};

fn order(scratch: &Scratch) -> Output {
    lole()
        .args(["order", "list.csv", "a.lole", "--out", "o"])
        .current_dir(&scratch.0)
        .output()
        .unwrap()
}

/// Names of the pictures with the time when each was written.
fn pictures(out: &Path) -> Vec<(String, SystemTime)> {
    let files = fs::read_dir(out.join("pictures")).unwrap();
    let mut found: Vec<_> = files
        .map(|file| {
            let file = file.unwrap();
            let name = file.file_name().to_string_lossy().into_owned();
            (name, file.metadata().unwrap().modified().unwrap())
        })
        .collect();
    found.sort();
    found
}

#[test]
fn a_picture_belongs_to_its_dancer_and_is_taken_once() {
    let scratch = Scratch::new("order-pictures");
    // The second is too large for a cloth that has no room for a seam.
    let design =
        "lole = 1\n[skirt]\nworn = \"no\"\n[[garment]]\nkind = \"malo\"\n[fabric]\nwidth_cm = 60\n";
    fs::write(scratch.0.join("a.lole"), design).unwrap();
    let list = "name,stature,hip\nNani,150,85\nNobody,150,30\nLei,160,100\n";
    fs::write(scratch.0.join("list.csv"), list).unwrap();
    let first = order(&scratch);
    let said = String::from_utf8_lossy(&first.stderr).into_owned();
    assert_eq!(first.status.code(), Some(1), "{said}");
    assert!(said.contains("30"), "{said}");
    let out = scratch.0.join("o");
    let taken = pictures(&out);
    let starts: Vec<&str> = taken.iter().map(|(name, _)| &name[..4]).collect();
    assert_eq!(starts, ["001-", "002-"], "{said}");
    let json = fs::read_to_string(out.join("order.json")).unwrap();
    assert!(taken.iter().all(|(name, _)| json.contains(name)), "{json}");
    assert_eq!(order(&scratch).status.code(), Some(1));
    assert_eq!(pictures(&out), taken);
    // Of two rows changed places each keeps her measures; the pictures are taken anew under their places.
    let list = "name,stature,hip\nLei,160,100\nNani,150,85\n";
    fs::write(scratch.0.join("list.csv"), list).unwrap();
    assert_eq!(order(&scratch).status.code(), Some(0));
    let now = pictures(&out);
    assert_eq!(now.len(), 2);
    assert!(
        now.iter()
            .all(|(name, _)| taken.iter().all(|(old, _)| old != name))
    );
}
