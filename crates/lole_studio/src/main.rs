//! The live window as a program: nothing at all, or one design, may be typed after its name.

use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;

use lole_language::{Bilingual as _, Language, Sentence};
use lole_studio::{Opening, Refusal, open};

#[expect(clippy::print_stderr, reason = "says why there is no window")]
fn main() -> ExitCode {
    let language = Language::of_locale(sys_locale::get_locale().as_deref());
    let words: Vec<OsString> = std::env::args_os().skip(1).collect();
    let result = asked(&words).and_then(|document| open(&Opening { language, document }));
    let (sentence, code) = match result {
        Ok(()) => return ExitCode::SUCCESS,
        Err(Refusal::Document(sentence)) => (sentence, 2),
        Err(Refusal::Window(sentence)) => (sentence, 1),
    };
    let line = sentence.text(language).replace(['\n', '\r'], " ");
    eprintln!("lole: {line}");
    ExitCode::from(code)
}

/// The document to open, if one was typed.
fn asked(words: &[OsString]) -> Result<Option<PathBuf>, Refusal> {
    match words {
        [] => Ok(None),
        [word] if !word.to_string_lossy().starts_with('-') => Ok(Some(PathBuf::from(word))),
        _ => Err(Refusal::Document(Sentence::new(
            "lole-studio のあとには、デザインのファイルを一つだけ書けます",
            "after lole-studio one design may be typed, and nothing else",
        ))),
    }
}
