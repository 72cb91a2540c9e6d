//! A design as a command reads it.

use std::path::Path;

use lole_body::Measure;
use lole_costume::document::{self, Design, Place};
use lole_language::Sentence;
use lole_pattern::TailorTape;

use crate::Failure;

/// A design and where it came from. Files that it names are read, and named by their whole paths.
pub(crate) struct Source {
    /// What sentences call it: its path.
    pub(crate) name: String,
    /// The document; empty for the built-in design.
    pub(crate) text: String,
    pub(crate) design: Design,
    /// What the command line puts in place of the design's, by tables.
    put: Vec<&'static str>,
}

/// Reads a document and the files it names; the built-in design without one.
pub(crate) fn read(path: Option<&Path>) -> Result<Source, Failure> {
    let Some(path) = path else {
        return Ok(Source {
            name: "the built-in design".to_owned(),
            text: String::new(),
            design: Design::default(),
            put: Vec::new(),
        });
    };
    let name = path.display().to_string();
    let bytes = lole_files::read_document(path).map_err(Failure::usage)?;
    let mut design =
        document::parse_bytes(&bytes, &name).map_err(|error| Failure::Usage(error.into()))?;
    lole_files::read_linked_files(&mut design, path).map_err(Failure::usage)?;
    lole_files::name_linked_files(&mut design, path);
    let text = String::from_utf8_lossy(&bytes).into_owned();
    Ok(Source {
        name,
        text,
        design,
        put: Vec::new(),
    })
}

impl Source {
    /// A design that was read already, by the name that sentences call it.
    pub(crate) const fn of(name: String, text: String, design: Design) -> Self {
        Self {
            name,
            text,
            design,
            put: Vec::new(),
        }
    }

    /// Lays files of the command line over those of the design: an avatar, a recorded motion.
    pub(crate) fn put(
        &mut self,
        avatar: Option<&Path>,
        motion: Option<&Path>,
    ) -> Result<(), Failure> {
        let files = [
            (&mut self.design.dancer.file, avatar, "dancer", "--avatar"),
            (&mut self.design.motion.file, motion, "motion", "--motion"),
        ];
        for (file, path, table, option) in files {
            if let Some(path) = path {
                *file = Some(lole_files::linked_file(path, option).map_err(Failure::usage)?);
                self.put.push(table);
            }
        }
        Ok(())
    }

    /// Says that what a table of the design holds comes from the command line, so that mistakes in it have no line.
    pub(crate) fn replaces(&mut self, table: &'static str) {
        self.put.push(table);
    }

    /// Builds the design's dancer to the measures of another program's file.
    pub(crate) fn measure(&mut self, path: Option<&Path>) -> Result<(), Failure> {
        let Some(path) = path else {
            return Ok(());
        };
        let name = path.display().to_string();
        let body = lole_files::read_measures(path, "--measures").map_err(Failure::usage)?;
        let dancer = &mut self.design.dancer;
        dancer.file = None;
        for measure in Measure::ALL {
            *dancer.measure_mut(measure) = None;
        }
        dancer.tailor_tape = TailorTape::NONE;
        for taken in &body.measures {
            *dancer.measure_mut(taken.measure) = Some((100.0 * taken.cm).round() / 100.0);
        }
        self.put.push("dancer");
        (self.design.check(&name)).map_err(|error| Failure::Usage(error.into()))
    }

    /// A mistake that only measuring, drafting or sewing finds, with the line where it is mended; a
    /// file of the command line has none.
    pub(crate) fn located(&self, place: Place<'_>, sentence: Sentence) -> Failure {
        if self.put.contains(&place.table) {
            return Failure::usage(sentence);
        }
        Failure::Usage(document::locate(&self.text, &self.name, place, sentence).into())
    }
}
