//! A disk that fails: a program is run again and again, and at every change it makes below a folder the disk is
//! full, the permission is lost, or the program is killed.
#![allow(
    dead_code,
    reason = "each test that shares this file uses its own part of it"
)]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// How the disk fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mode {
    /// The process is killed before the change.
    Kill,
    /// The change fails, later ones do not.
    Once,
    /// From the change on, nothing can be made or grow; of what is written a half still fits.
    Full,
    /// From the change on, no name can be made, moved or removed.
    Denied,
}

impl Mode {
    pub(crate) const ALL: [Self; 4] = [Self::Kill, Self::Once, Self::Full, Self::Denied];

    const fn name(self) -> &'static str {
        match self {
            Self::Kill => "kill",
            Self::Once => "once",
            Self::Full => "full",
            Self::Denied => "denied",
        }
    }
}

/// The library that stands between a program and its disk.
pub(crate) struct Shim {
    library: PathBuf,
    log: PathBuf,
    /// The folder whose files it watches.
    under: PathBuf,
}

impl Shim {
    /// Builds it in `folder`, for what lies below `under`; `None` where there is no C compiler.
    pub(crate) fn build(folder: &Path, under: &Path) -> Option<Self> {
        let library = folder.join("failing_disk.so");
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join(SHIM);
        let built = Command::new("cc")
            .args(["-shared", "-fPIC", "-O1", "-o"])
            .arg(&library)
            .arg(&source)
            .arg("-ldl")
            .output()
            .ok()?;
        let said = String::from_utf8_lossy(&built.stderr);
        assert!(built.status.success(), "{said}");
        Some(Self {
            library,
            log: folder.join("changes"),
            under: under.to_owned(),
        })
    }

    /// Runs a command whose disk works; the names of the changes that it makes, in order.
    pub(crate) fn changes(&self, command: Command) -> (Output, Vec<String>) {
        let output = self.run(command, 0, "");
        let log = fs::read_to_string(&self.log).unwrap_or_default();
        (output, log.lines().map(str::to_owned).collect())
    }

    /// Runs a command whose disk fails at change number `at`, from 1.
    pub(crate) fn fail(&self, command: Command, mode: Mode, at: usize) -> Output {
        self.run(command, at, mode.name())
    }

    fn run(&self, mut command: Command, at: usize, mode: &str) -> Output {
        drop(fs::remove_file(&self.log));
        command
            .env("LD_PRELOAD", &self.library)
            .env("LOLE_FAULT_UNDER", &self.under)
            .env("LOLE_FAULT_LOG", &self.log)
            .env("LOLE_FAULT_AT", at.to_string())
            .env("LOLE_FAULT_MODE", mode)
            .output()
            .unwrap_or_else(|error| panic!("{error}"))
    }
}

/// The source of the library, from the crate of either test.
const SHIM: &str = "../lole_files/tests/failing_disk/shim.c";

/// What a folder shows: names and bytes of its files, and the names that nobody is meant to see.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Seen {
    pub(crate) files: BTreeMap<String, Vec<u8>>,
    pub(crate) hidden: Vec<String>,
}

impl Seen {
    pub(crate) fn of(folder: &Path) -> Self {
        let mut seen = Self::default();
        for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            if name.starts_with('.') {
                seen.hidden.push(name);
            } else {
                let bytes = fs::read(entry.path()).unwrap_or_default();
                seen.files.insert(name, bytes);
            }
        }
        seen
    }

    /// Whether every file is as it was in one of two folders: nothing half-written is seen.
    pub(crate) fn is_of(&self, one: &Self, other: &Self) -> bool {
        (self.files.iter()).all(|(name, bytes)| {
            let is_in = |seen: &Self| seen.files.get(name) == Some(bytes);
            is_in(one) || is_in(other)
        })
    }
}

/// A folder with these files and nothing else.
pub(crate) fn fill(folder: &Path, seen: &Seen) {
    drop(fs::remove_dir_all(folder));
    if seen.files.is_empty() {
        return;
    }
    let filled = fs::create_dir_all(folder).and_then(|()| {
        (seen.files.iter()).try_for_each(|(name, bytes)| fs::write(folder.join(name), bytes))
    });
    filled.unwrap_or_else(|error| panic!("{error}"));
}

/// What must hold after a command met a failing disk, and after it is run again.
pub(crate) struct Trial<'a> {
    pub(crate) shim: &'a Shim,
    pub(crate) folder: &'a Path,
    /// The folder before; none where it has no files.
    pub(crate) before: &'a Seen,
    /// The folder after a run that goes well.
    pub(crate) after: &'a Seen,
    /// The command; it says one sentence and fails, or it does all.
    pub(crate) command: &'a dyn Fn() -> Command,
    /// How the sentence of a failure begins.
    pub(crate) voice: &'a str,
    /// Of what a second run says where it finds what a killed one left; `None` where it is quiet.
    pub(crate) found: Option<&'a str>,
}

impl Trial<'_> {
    /// Fails the disk at change `at`, then runs the command again as if nothing had happened.
    pub(crate) fn check(&self, mode: Mode, at: usize, change: &str) {
        let place = format!("{mode:?} at change {at}, {change}");
        fill(self.folder, self.before);
        let output = self.shim.fail((self.command)(), mode, at);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let seen = Seen::of(self.folder);
        assert!(
            seen.is_of(self.before, self.after),
            "{place}: something half-written is seen: {said}"
        );
        let missing = (self.before.files.keys()).find(|name| !seen.files.contains_key(*name));
        assert_eq!(missing, None, "{place}: an earlier result is gone: {said}");
        if output.status.success() {
            assert_eq!(
                seen.files, self.after.files,
                "{place}: it says that all is done"
            );
        } else if mode != Mode::Kill {
            let sentences = said.lines().filter(|line| line.starts_with(self.voice));
            assert_eq!(sentences.count(), 1, "{place}: {said}");
            let code = output.status.code();
            assert!(code == Some(1) || code == Some(2), "{place}: {code:?}");
            // Without the permission to move anything, what was moved stays moved until the next run.
            if mode != Mode::Denied {
                assert_eq!(seen, *self.before, "{place}: {said}");
            }
        }
        self.check_again(&place, &seen);
    }

    /// The next run does all, removes what it finds, and says so.
    fn check_again(&self, place: &str, left: &Seen) {
        let output = (self.command)().output();
        let output = output.unwrap_or_else(|error| panic!("{error}"));
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success(), "{place}: the next run: {said}");
        assert_eq!(
            Seen::of(self.folder),
            *self.after,
            "{place}: the next run: {said}"
        );
        if let Some(found) = self.found {
            let has_left = !left.hidden.is_empty();
            assert_eq!(
                said.contains(found),
                has_left,
                "{place}: the next run: {said}"
            );
        }
    }
}
