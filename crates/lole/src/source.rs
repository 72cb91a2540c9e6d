//! The design that a command works on.

use std::path::Path;

use lole_costume::document::{self, Design};

use crate::Failure;

/// A design and where it came from.
pub(crate) struct Source {
    /// Path of the document, or what stands for it.
    pub(crate) name: String,
    /// Its text; empty for the built-in design.
    pub(crate) text: String,
    /// What it says, with the files that it names.
    pub(crate) design: Design,
}

/// Reads a document and the files that it names; the built-in design without one.
pub(crate) fn read(path: Option<&Path>) -> Result<Source, Failure> {
    let Some(path) = path else {
        return Ok(Source {
            name: "the built-in design".to_owned(),
            text: String::new(),
            design: Design::default(),
        });
    };
    let name = path.display().to_string();
    let bytes = lole_studio::read_document(path).map_err(Failure::usage)?;
    let mut design =
        document::parse_bytes(&bytes, &name).map_err(|error| Failure::Usage(error.into()))?;
    lole_studio::read_linked_files(&mut design, path).map_err(Failure::usage)?;
    let text = String::from_utf8_lossy(&bytes).into_owned();
    Ok(Source { name, text, design })
}
