//! Shows a folder with the system's own program for files.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::thread;

use lole_language::Sentence;

/// What opens a folder on this system.
const PROGRAM: &str = if cfg!(windows) {
    "explorer"
} else if cfg!(target_os = "macos") {
    "open"
} else {
    "xdg-open"
};

/// Opens a folder, or the one that a file lies in, on a thread of its own; a sentence comes where that
/// does not work.
pub(crate) fn begin(path: &Path, wake: impl Fn() + Send + 'static) -> Receiver<Sentence> {
    let path = path.to_owned();
    let (sender, troubles) = mpsc::channel();
    let open = move || {
        let folder = folder_of(&path);
        if !opens(PROGRAM, &folder) {
            let name = folder.display();
            // The window may have been closed meanwhile.
            drop(sender.send(Sentence::new(
                format!("フォルダーを開くプログラムがありません。ファイルはここにあります: {name}"),
                format!("No program here opens folders; the files are in {name}"),
            )));
            wake();
        }
    };
    // Without a thread nothing is opened, and the path has been told already.
    drop(thread::Builder::new().name("reveal".to_owned()).spawn(open));
    troubles
}

fn opens(program: &str, folder: &Path) -> bool {
    let mut command = Command::new(program);
    command.arg(folder).stdin(Stdio::null());
    command.stdout(Stdio::null()).stderr(Stdio::null());
    // The one of Windows ends with 1 whatever it did.
    (command.status()).is_ok_and(|status| status.success() || cfg!(windows))
}

fn folder_of(path: &Path) -> PathBuf {
    if path.is_dir() {
        return path.to_owned();
    }
    match path.parent() {
        // A name alone lies where the program was started.
        Some(folder) if folder.as_os_str().is_empty() => PathBuf::from("."),
        Some(folder) => folder.to_owned(),
        None => path.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_is_shown_itself_and_a_file_in_its_folder() {
        let folder = std::env::temp_dir();
        assert_eq!(folder_of(&folder), folder);
        assert_eq!(folder_of(&folder.join("no-such.pdf")), folder);
        assert_eq!(folder_of(Path::new("no-such.pdf")), Path::new("."));
    }

    #[test]
    fn a_program_that_is_not_there_opens_nothing() {
        assert!(!opens("lole-no-such-program", &std::env::temp_dir()));
    }
}
