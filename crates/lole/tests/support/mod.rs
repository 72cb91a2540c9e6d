//! What tests of the command share: a folder of their own, and the command as a user in English calls it.
#![allow(dead_code, reason = "every test file uses some of it")]

use std::fs;
use std::path::PathBuf;
use std::process::Command;

/// A scratch folder that is removed when the test ends.
pub(crate) struct Scratch(pub(crate) PathBuf);

impl Scratch {
    pub(crate) fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("lole-{name}-{}", std::process::id()));
        drop(fs::remove_dir_all(&folder));
        fs::create_dir_all(&folder).unwrap();
        Self(folder)
    }

    pub(crate) fn write(&self, name: &str, text: &str) -> PathBuf {
        let path = self.0.join(name);
        fs::write(&path, text).unwrap();
        path
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        drop(fs::remove_dir_all(&self.0));
    }
}

/// The command in English.
pub(crate) fn lole() -> Command {
    in_english(Command::new(env!("CARGO_BIN_EXE_lole")))
}

/// A command that speaks English, whatever this machine speaks.
pub(crate) fn in_english(mut command: Command) -> Command {
    command
        .env("LANG", "en_US.UTF-8")
        .env_remove("LC_ALL")
        .env_remove("LC_MESSAGES");
    command
}
