//! Goldens: small texts under `tests/golden/`, one folder for each crate, that tests compare with.
//!
//! Names of tests that own one begin with `golden_`, so that `cargo xtask golden` finds them, which runs them
//! with `LOLE_GOLDEN=write` and says what changed.

use std::path::PathBuf;

/// Compares a text with the golden of this name of the crate whose test runs; rewrites it where `LOLE_GOLDEN`
/// is `write`.
///
/// # Panics
/// When they differ, or the golden cannot be written.
pub fn check(name: &str, text: &str) {
    let path = path_of(name);
    if std::env::var_os("LOLE_GOLDEN").is_some_and(|mode| mode == "write") {
        let written = std::fs::write(&path, text);
        written.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
    let golden = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(
        golden, text,
        "{name} changed; explain it, then run `cargo xtask golden`"
    );
}

/// Where a golden of the crate lies whose test runs.
fn path_of(name: &str) -> PathBuf {
    // As Cargo says when it runs: a build folder that several clones share keeps what one of them was.
    let of_cargo = |key: &str| {
        std::env::var_os(key)
            .map_or_else(|| panic!("Cargo runs tests and says {key}"), PathBuf::from)
    };
    let (own, package) = (of_cargo("CARGO_MANIFEST_DIR"), of_cargo("CARGO_PKG_NAME"));
    own.join("../../tests/golden").join(package).join(name)
}
