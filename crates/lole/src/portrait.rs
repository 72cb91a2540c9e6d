//! Pictures of dancers who stand in their costume, for paper: one alone, or a group at one scale.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use lole_costume::document::{Design, to_toml};
use lole_costume::order::{self, DancerPlan, PlanError};
use lole_export::booklet::Worn;
use lole_export::order::PICTURE_FOLDER;
use lole_export::pdf::EncodedPicture;
use lole_picture::portrait::{self, PortraitError};
use lole_stage::Production;

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

/// The pictures of an order, all at one scale: they are kept in its folder, so that an order that was stopped goes
/// on.
pub(crate) struct Album<'a> {
    folder: PathBuf,
    stop: &'a AtomicBool,
}

impl<'a> Album<'a> {
    /// That of the order in the folder `out`.
    ///
    /// # Errors
    /// A folder that cannot be written.
    pub(crate) fn of(out: &Path, stop: &'a AtomicBool) -> Result<Self, Failure> {
        let folder = out.join(PICTURE_FOLDER);
        fs::create_dir_all(&folder).map_err(Failure::error)?;
        Ok(Self { folder, stop })
    }

    /// What is cut for the dancer at a place of the list, and her in her costume; no picture of her who cannot be
    /// cut for, or cannot be dressed.
    ///
    /// # Errors
    /// An interruption.
    pub(crate) fn cut(
        &self,
        place: usize,
        (name, design): (&str, &Design),
    ) -> Result<(Result<DancerPlan, PlanError>, Option<Kept>), Failure> {
        let size = [portrait::STANDING.width, portrait::STANDING.height];
        let version = env!("CARGO_PKG_VERSION");
        let key = format!("{} {version} {size:?}", to_toml(design));
        let key = lole_geom::fnv::hash(key.into_bytes());
        let file = format!("{:03}-{key:016x}.jpg", place + 1);
        let path = self.folder.join(&file);
        let file = format!("{PICTURE_FOLDER}/{file}");
        if let Some(picture) = fs::read(&path).ok().and_then(portrait::of_jpeg) {
            return Ok((order::plan_design(name, design), Some((picture, file))));
        }
        // Her body is built once, for what is cut and for the picture.
        let Ok(dancer) = lole_stage::dancer(design) else {
            return Ok((order::plan_design(name, design), None));
        };
        let plan = order::plan_dancer(name, design, &dancer.0);
        if plan.is_err() {
            return Ok((plan, None));
        }
        let is_stopped = || self.stop.load(Ordering::Relaxed);
        let bytes = match portrait::standing_on(design, dancer, &is_stopped) {
            Ok(bytes) => bytes,
            Err(PortraitError::CalledOff) => return Err(Failure::Interrupted),
            Err(_) => return Ok((plan, None)),
        };
        // Whole or not at all: a half picture would be taken for a kept one.
        let written = lole_files::write_whole(&path, &bytes).is_ok();
        let picture = portrait::of_jpeg(bytes).filter(|_| written);
        Ok((plan, picture.map(|picture| (picture, file))))
    }
}

fn failure(error: PortraitError) -> Failure {
    match error {
        PortraitError::CalledOff => Failure::Interrupted,
        error => Failure::error(error),
    }
}
