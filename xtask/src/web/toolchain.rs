//! The compiler for a page: rustup's target where it is there, and else the compiler and sources that Debian
//! ships together. Nothing is installed; what is missing is named.

use std::path::{Path, PathBuf};
use std::process::Command;

/// What a page runs on.
pub(super) const TARGET: &str = "wasm32-unknown-unknown";
/// The usual instructions and vectors of 128 bits; relaxed vectors give other bits on other machines.
const FLAGS: &str = "-C target-feature=+simd128";
/// Where Debian's packages `rustc-web`, `cargo-web` and `rust-web-src` lie.
const DEBIAN: [&str; 3] = [
    "/usr/bin/rustc",
    "/usr/bin/cargo",
    "/usr/lib/rustlib/src/rust/library/std",
];

/// Who compiles.
pub(super) enum Toolchain {
    /// The compiler in use, whose target is installed.
    Rustup,
    /// Debian's pair, which builds the standard library itself with this linker.
    Debian(PathBuf),
}

/// Looks for a compiler and for `wasm-bindgen`.
///
/// # Errors
/// One sentence that says what is missing and how it is installed.
pub(super) fn find(repository: &Path) -> Result<Toolchain, String> {
    let wanted = locked_version(repository, "wasm-bindgen").unwrap_or_default();
    let found = output("wasm-bindgen", &["--version"]).unwrap_or_default();
    if found.split_whitespace().nth(1) != Some(&wanted) {
        return Err(format!(
            "wasm-bindgen {wanted} is missing; install it with: cargo install wasm-bindgen-cli --version {wanted}"
        ));
    }
    let sysroot = output("rustc", &["--print", "sysroot"]).unwrap_or_default();
    let target = Path::new(sysroot.trim()).join("lib/rustlib").join(TARGET);
    if target.join("lib").is_dir() {
        return Ok(Toolchain::Rustup);
    }
    let linkers = (14..30).rev().map(|version| format!("wasm-ld-{version}"));
    let linker = linkers
        .chain(["wasm-ld".to_owned()])
        .map(|name| Path::new("/usr/bin").join(name));
    let linker = linker.into_iter().find(|path| path.exists());
    match linker {
        Some(linker) if DEBIAN.iter().all(|part| Path::new(part).exists()) => {
            Ok(Toolchain::Debian(linker))
        }
        _ => Err(format!(
            "no compiler for pages is here; install one with: rustup target add {TARGET} (or on Debian: \
             apt-get install rustc-web cargo-web rust-web-src lld-19)"
        )),
    }
}

impl Toolchain {
    /// The command that builds a package as a library for a page.
    pub(super) fn cargo(&self, repository: &Path, target: &Path, package: &str) -> Command {
        let mut cargo = match self {
            Self::Rustup => Command::new("cargo"),
            Self::Debian(linker) => {
                let mut cargo = Command::new(DEBIAN[1]);
                cargo.env("RUSTC", DEBIAN[0]);
                // Its standard library is built with the program, which stable compilers must be allowed to.
                cargo
                    .env("RUSTC_BOOTSTRAP", "1")
                    .env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", linker);
                cargo
            }
        };
        // What Cargo set for this command is not meant for the other compiler.
        cargo.env_remove("CARGO").env_remove("RUSTUP_TOOLCHAIN");
        cargo
            .env("RUSTFLAGS", FLAGS)
            .env("CARGO_TARGET_DIR", target);
        cargo.current_dir(repository).args([
            "build",
            "--lib",
            "--profile",
            "web",
            "--target",
            TARGET,
            "-p",
            package,
        ]);
        if let Self::Debian(_) = self {
            cargo.arg("-Zbuild-std=std,panic_abort");
        }
        cargo
    }
}

/// The version of a crate that the lock file names.
fn locked_version(repository: &Path, name: &str) -> Option<String> {
    let lock = std::fs::read_to_string(repository.join("Cargo.lock")).ok()?;
    let (_, rest) = lock.split_once(&format!("name = \"{name}\"\nversion = \""))?;
    rest.split('"').next().map(str::to_owned)
}

fn output(program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).output().ok()?;
    String::from_utf8(output.stdout).ok()
}
