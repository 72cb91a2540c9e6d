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
