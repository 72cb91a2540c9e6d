//! Pictures of dancers who stand in their costume, for paper: one alone, or a group at one scale.

use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::ProgressBar;
use lole_costume::document::{Design, to_toml};
use lole_export::booklet::Worn;
use lole_export::order::PICTURE_FOLDER;
use lole_export::pdf::EncodedPicture;
use lole_picture::portrait::{self, PortraitError};
use lole_stage::Production;
use rayon::prelude::*;

use crate::Failure;

/// A dancer in her costume, for a booklet.
///
/// # Errors
/// A costume that cannot be put on, or an interruption.
pub(crate) fn worn(design: &Design, stop: &AtomicBool) -> Result<Worn, Failure> {
    let is_stopped = || stop.load(Ordering::Relaxed);
    let production = Production::new(design).map_err(PortraitError::from);
    let performance = production
        .and_then(|production| portrait::stand(production, u32::MAX, &is_stopped))
        .map_err(failure)?;
    portrait::of_booklet(&performance).map_err(failure)
}

/// A dancer's picture and the file that it is kept in, by its path in the order's folder.
pub(crate) type Kept = (EncodedPicture, String);

/// Every dancer of a group in her costume, all at one scale; `None` where it cannot be put on. They are
/// kept in the order's folder, so that an order that was stopped goes on.
///
/// # Errors
/// An interruption, or a folder that cannot be written.
pub(crate) fn group(
    designs: &[Design],
    out: &Path,
    stop: &AtomicBool,
    bar: &ProgressBar,
) -> Result<Vec<Option<Kept>>, Failure> {
    let folder = out.join(PICTURE_FOLDER);
    fs::create_dir_all(&folder).map_err(Failure::error)?;
    (designs.par_iter().enumerate())
        .map(|(index, design)| {
            let picture = kept(design, index, &folder, stop);
            bar.inc(1);
            match picture {
                Ok(picture) => Ok(Some(picture)),
                Err(Failure::Interrupted) => Err(Failure::Interrupted),
                Err(_) => Ok(None),
            }
        })
        .collect()
}

/// The picture of an earlier run of the same design and dancer, or a new one, kept for the next.
fn kept(design: &Design, index: usize, folder: &Path, stop: &AtomicBool) -> Result<Kept, Failure> {
    let size = [portrait::STANDING.width, portrait::STANDING.height];
    let version = env!("CARGO_PKG_VERSION");
    let key = lole_geom::fnv::hash(format!("{} {version} {size:?}", to_toml(design)).into_bytes());
    let name = format!("{:03}-{key:016x}.jpg", index + 1);
    let path = folder.join(&name);
    let name = format!("{PICTURE_FOLDER}/{name}");
    if let Some(picture) = fs::read(&path).ok().and_then(portrait::of_jpeg) {
        return Ok((picture, name));
    }
    let is_stopped = || stop.load(Ordering::Relaxed);
    let bytes = portrait::standing(design, &is_stopped).map_err(failure)?;
    // Whole or not at all: a half picture would be taken for a kept one.
    lole_files::write_whole(&path, &bytes).map_err(Failure::error)?;
    let picture = portrait::of_jpeg(bytes);
    let picture = picture.ok_or_else(|| Failure::error(anyhow::anyhow!("no JPEG")))?;
    Ok((picture, name))
}

fn failure(error: PortraitError) -> Failure {
    match error {
        PortraitError::CalledOff => Failure::Interrupted,
        error => Failure::error(error),
    }
}
