//! The house rules. Each check returns its findings as `path:line: sentence`; none stops another.

mod dependencies;
mod documents;
mod source;
mod words;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use anyhow::{Context as _, ensure};

/// One tracked text file.
pub(crate) struct TextFile {
    /// Path from the repository, with `/`.
    pub(crate) path: String,
    pub(crate) text: String,
}

pub(crate) fn run(repository: &Path) -> anyhow::Result<ExitCode> {
    let files = text_files(repository)?;
    let mut findings = dependencies::check(repository, &files)?;
    findings.extend(source::check(&files));
    findings.extend(documents::check(repository, &files));
    findings.extend(words::check(&files));
    findings.sort();

    for finding in &findings {
        println!("{finding}");
    }
    if findings.is_empty() {
        println!("tidy: {} files keep the house rules", files.len());
        Ok(ExitCode::SUCCESS)
    } else {
        println!("tidy: {} findings", findings.len());
        Ok(ExitCode::FAILURE)
    }
}

/// Every file that git tracks or would track, as far as it is UTF-8.
pub(crate) fn text_files(repository: &Path) -> anyhow::Result<Vec<TextFile>> {
    let listing = Command::new("git")
        .current_dir(repository)
        .args([
            "ls-files",
            "-z",
            "--cached",
            "--others",
            "--exclude-standard",
        ])
        .output()
        .context("cannot ask git for the files")?;
    ensure!(
        listing.status.success(),
        "git: {}",
        String::from_utf8_lossy(&listing.stderr)
    );

    let mut files = Vec::new();
    for path in String::from_utf8_lossy(&listing.stdout)
        .split('\0')
        .filter(|path| !path.is_empty())
    {
        let on_disk: PathBuf = repository.join(path);
        // A file deleted but not yet committed is still listed.
        let Ok(bytes) = std::fs::read(&on_disk) else {
            continue;
        };
        if let Ok(text) = String::from_utf8(bytes) {
            files.push(TextFile {
                path: path.to_owned(),
                text,
            });
        }
    }
    Ok(files)
}
