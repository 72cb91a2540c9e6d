//! The `lole` command: arguments in, files out.

mod args;
mod batch;
mod bench;
mod clock;
mod dance;
mod dancer;
mod export;
mod fabric;
mod handbook;
mod inspect;
mod order;
mod output;
mod patience;
mod pattern;
mod portrait;
mod source;
mod study;
mod summary;
mod usage;
mod validate;
mod wear;
mod window;

use std::process::ExitCode;

use lole_language::{Language, Sentence};
use lole_study::StudyError;

use args::Command;
use usage::Asked;

/// Why a command did not do what was asked.
pub(crate) enum Failure {
    /// Wrong usage or unreadable input: exit code 2.
    Usage(anyhow::Error),
    /// A failed run: exit code 1.
    Run(anyhow::Error),
    /// The cloth diverged; the report says so: exit code 1.
    Diverged(Sentence),
    /// Ctrl-C: exit code 130, as shells expect.
    Interrupted,
    /// The same, where something is kept for the next time.
    Paused(Sentence),
}

impl Failure {
    /// A failed run.
    pub(crate) fn error(error: impl Into<anyhow::Error>) -> Self {
        Self::Run(error.into())
    }

    /// Wrong usage, in one sentence.
    pub(crate) fn usage(sentence: Sentence) -> Self {
        Self::Usage(sentence.into())
    }
}

impl From<StudyError> for Failure {
    fn from(error: StudyError) -> Self {
        match error {
            StudyError::CalledOff => Self::Interrupted,
            // Said in both languages.
            StudyError::Stage(error) => Self::error(error),
            error => Self::error(error),
        }
    }
}

fn main() -> ExitCode {
    let language = Language::of_locale(sys_locale::get_locale().as_deref());
    let asked = match usage::read(language) {
        Ok(asked) => asked,
        Err(exit_code) => return exit_code,
    };
    let result = match asked {
        Asked::Window(document) => match window::open(document.as_deref()) {
            Ok(exit_code) => return exit_code,
            Err(failure) => Err(failure),
        },
        Asked::Command(command) => match *command {
            Command::Dance(args) => dance::run(&args, language),
            Command::Wear(args) => wear::run(*args, language),
            Command::Export(args) => export::run(&args, language),
            Command::Vrm(args) => export::run_vrm(&args, language),
            Command::Pattern(args) => pattern::run(&args, language),
            Command::Order(args) => order::run_order(&args, language),
            Command::Booklet(args) => order::run_booklet(&args, language),
            Command::Cost(args) => order::run_cost(&args, language),
            Command::Form(args) => order::run_form(&args, language),
            Command::Study(args) => study::run(&args, language),
            Command::Validate(args) => validate::run(&args, language),
            Command::Batch(args) => batch::run(&args, language),
            Command::Bench(args) => bench::run(&args, language),
            Command::Dancer(args) => dancer::run(&args, language),
            Command::Fabric(args) => fabric::run(&args, language),
            Command::Inspect(args) => inspect::run(&args, language),
            Command::Completions(args) => handbook::complete(&args),
            Command::Man(args) => handbook::man(&args, language),
        },
    };
    match result {
        Ok(()) => summary::end(language),
        Err(failure) => summary::explain(&failure, language),
    }
}
