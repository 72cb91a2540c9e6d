//! Pictures of dancers who stand in their costume, for paper: one alone, or a group at one scale.

use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use glam::Vec3;
use indicatif::ProgressBar;
use lole_costume::document::{Design, to_toml};
use lole_export::Image;
use lole_export::pdf::Picture;
use lole_export::still::encode_jpeg;
use lole_render::{Backend, Bounds, Camera, LightRig, Renderer, Size, View};
use lole_stage::{Performance, Production};
use rayon::prelude::*;

use crate::Failure;
use crate::studio::{Studio, still_cameras};

/// Folder of the pictures of a group; they are kept, so that an order that was stopped goes on.
const FOLDER: &str = "pictures";

/// Size of the picture on a cover, upright.
const COVER: Size = Size {
    width: 900,
    height: 1200,
};

/// Size of one picture of a group: as wide as her arms and skirt need, as tall as the tallest.
const STANDING: Size = Size {
    width: 478,
    height: 520,
};
/// What it shows to either side, and from the floor up [m]: outstretched arms of a tall dancer.
const STANDING_REACH: [f32; 2] = [0.92, 2.0];

/// Particles of cloth that hangs still in a small picture, around and down: more would not be seen.
const COARSE: [u32; 2] = [224, 32];

/// Frames in which cloth of a small picture comes to hang: what still sways after them would not be
/// seen.
const HANGING_FRAMES: u32 = 75;

/// Quality of stored pictures.
const QUALITY: u8 = 90;

/// A dancer in her costume, large.
///
/// # Errors
/// A costume that cannot be put on, or an interruption.
pub(crate) fn cover(design: &Design, stop: &AtomicBool) -> Result<Picture, Failure> {
    let performance = stand(design, stop, u32::MAX)?;
    let cameras = still_cameras(&performance, COVER);
    let camera = cameras.into_iter().next();
    let camera = camera.unwrap_or_else(|| standing_camera(COVER));
    let image = shoot(&performance, camera, COVER)?;
    picture(&image)
}

/// Every dancer of a group in her costume, all at one scale; `None` where it cannot be put on.
///
/// # Errors
/// An interruption, or a folder that cannot be written.
pub(crate) fn group(
    designs: &[Design],
    out: &Path,
    stop: &AtomicBool,
    bar: &ProgressBar,
) -> Result<Vec<Option<Picture>>, Failure> {
    let folder = out.join(FOLDER);
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
fn kept(
    design: &Design,
    index: usize,
    folder: &Path,
    stop: &AtomicBool,
) -> Result<Picture, Failure> {
    let size = [STANDING.width, STANDING.height];
    let version = env!("CARGO_PKG_VERSION");
    let key = fingerprint(&format!("{} {version} {size:?}", to_toml(design)));
    let path = folder.join(format!("{:03}-{key:016x}.jpg", index + 1));
    if let Some(picture) = fs::read(&path)
        .ok()
        .and_then(|bytes| Picture::of_jpeg(bytes, size))
    {
        return Ok(picture);
    }
    let coarse = coarse(design);
    let performance = stand(&coarse, stop, HANGING_FRAMES)?;
    let image = shoot(&performance, standing_camera(STANDING), STANDING)?;
    let (width, height) = (image.width, image.height);
    let image = Image::new(width, height, &image.pixels).map_err(Failure::error)?;
    let bytes = encode_jpeg(image, QUALITY).map_err(Failure::error)?;
    // Whole or not at all: a half picture would be taken for a kept one.
    let unfinished = path.with_extension("unfinished");
    fs::write(&unfinished, &bytes)
        .and_then(|()| fs::rename(&unfinished, &path))
        .map_err(Failure::error)?;
    Picture::of_jpeg(bytes, size).ok_or_else(|| Failure::error(anyhow::anyhow!("no JPEG")))
}

/// FNV-1a (Fowler, Noll and Vo): the same number for the same text, always.
fn fingerprint(text: &str) -> u64 {
    let bytes = text.bytes().map(u64::from);
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ byte).wrapping_mul(0x0100_0000_01b3)
    })
}

fn coarse(design: &Design) -> Design {
    let mut coarse = design.clone();
    coarse.skirt.column_count = coarse.skirt.column_count.min(COARSE[0]);
    coarse.skirt.row_count = coarse.skirt.row_count.min(COARSE[1]);
    coarse
}

/// Puts the costume on and lets it come to rest, for so many frames at most.
fn stand(design: &Design, stop: &AtomicBool, most_frames: u32) -> Result<Performance, Failure> {
    let production = Production::new(design).map_err(Failure::error)?;
    let mut performance = Performance::new(production).map_err(Failure::error)?;
    let mut frames = 0;
    while performance.time() < 0.0 && frames < most_frames {
        frames += 1;
        if stop.load(Ordering::Relaxed) {
            return Err(Failure::Interrupted);
        }
        performance
            .advance()
            .map_err(|_| Failure::error(anyhow::anyhow!("the cloth diverged")))?;
    }
    performance.pose_body();
    Ok(performance)
}

fn standing_camera(size: Size) -> Camera {
    let [side, top] = STANDING_REACH;
    let bounds = Bounds {
        min: Vec3::new(-side, 0.0, -0.2),
        max: Vec3::new(side, top, 0.2),
    };
    Camera::framing(bounds, View::Front, size.aspect())
}

fn shoot(
    performance: &Performance,
    camera: Camera,
    size: Size,
) -> Result<lole_render::Image, Failure> {
    let studio = Studio::new(performance).map_err(Failure::Run)?;
    let mut renderer = Renderer::new(Backend::Cpu, size).map_err(Failure::error)?;
    let lights = LightRig::seen_from(&camera);
    studio
        .shoot(performance, camera, lights, &mut renderer)
        .map_err(Failure::Run)
}

fn picture(image: &lole_render::Image) -> Result<Picture, Failure> {
    let (width, height) = (image.width, image.height);
    Image::new(width, height, &image.pixels)
        .and_then(Picture::photo)
        .map_err(Failure::error)
}
