//! The folder of a run's results, and what was found in it.

use std::path::Path;

use anyhow::Result;
use lole_files::OutputFolder;
use lole_language::Sentence;

use crate::summary;

/// Makes the folder, and tells what runs that were killed have left in it.
pub(crate) fn create(folder: impl AsRef<Path>) -> Result<OutputFolder> {
    let output = OutputFolder::create(folder.as_ref()).map_err(|why| {
        Sentence::new(
            format!("{}（--out）", why.japanese),
            format!("{} (--out)", why.english),
        )
    })?;
    summary::print_found(output.found());
    Ok(output)
}

/// Removes what an earlier run wrote and this one did not; tells of what cannot be removed.
pub(crate) fn tidy(folder: &Path, names: &[String]) -> Option<Sentence> {
    let stays = |name: &&String| {
        let path = folder.join(name);
        std::fs::remove_file(&path).is_err() && path.exists()
    };
    let names: Vec<&str> = names.iter().filter(stays).map(String::as_str).collect();
    (!names.is_empty()).then(|| {
        let names = names.join(", ");
        Sentence::new(
            format!("前に書いたファイルが消せません。使わないでください: {names}"),
            format!("files of an earlier run cannot be removed; do not use them: {names}"),
        )
    })
}
