//! The live window is a program of its own beside this one, so that commands need no window toolkit.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use lole_language::Sentence;

use crate::Failure;

/// Its name.
const PROGRAM: &str = "lole-studio";

/// Opens the window, with a document or the built-in design, and waits until it is closed; its exit code.
pub(crate) fn open(document: Option<&Path>) -> Result<ExitCode, Failure> {
    let program = beside().ok_or_else(|| Failure::usage(missing()))?;
    let status = (Command::new(&program).args(document).status()).map_err(|error| {
        let name = program.display();
        Failure::error(Sentence::new(
            format!("{name}: 窓を開けません（{error}）"),
            format!("{name}: the window cannot be opened ({error})"),
        ))
    })?;
    let code = status.code().and_then(|code| u8::try_from(code).ok());
    Ok(code.map_or(ExitCode::FAILURE, ExitCode::from))
}

/// The window's program where it lies beside this one.
fn beside() -> Option<PathBuf> {
    let own = std::env::current_exe().ok()?;
    let name = format!("{PROGRAM}{}", std::env::consts::EXE_SUFFIX);
    Some(own.with_file_name(name)).filter(|program| program.is_file())
}

fn missing() -> Sentence {
    Sentence::new(
        format!(
            "踊りの窓 {PROGRAM} が lole と同じフォルダーにありません。ソースからは cargo run --release -p lole_studio で開きます"
        ),
        format!(
            "the window, {PROGRAM}, is not in the folder of lole; from source, cargo run --release -p lole_studio opens it"
        ),
    )
}
