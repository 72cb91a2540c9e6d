//! The `lole` command: arguments in, files out.

mod args;
mod baked;
mod bench;
mod dance;
mod figures;
mod language;
mod output;
mod stopwatch;
mod studio;
mod summary;

use std::process::ExitCode;

use clap::Parser as _;

use args::{Cli, Command};
use language::Language;

/// Why a command did not do what was asked.
pub(crate) enum Failure {
    /// Wrong usage or unreadable input: exit code 2.
    Usage(anyhow::Error),
    /// A failed run: exit code 1.
    Run(anyhow::Error),
    /// The cloth diverged; the report says so: exit code 1.
    Diverged(String),
    /// Ctrl-C: exit code 130, as shells expect.
    Interrupted,
}

impl Failure {
    /// A failed run.
    pub(crate) fn error(error: impl Into<anyhow::Error>) -> Self {
        Self::Run(error.into())
    }

    /// Wrong usage, in one sentence.
    pub(crate) fn usage(sentence: &str) -> Self {
        Self::Usage(anyhow::anyhow!("{sentence}"))
    }
}

fn main() -> ExitCode {
    let language = Language::of_system();
    let result = match Cli::parse().command {
        Command::Dance(args) => dance::run(&args, language),
        Command::Bench(args) => bench::run(&args, language),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => summary::explain(&failure, language),
    }
}
