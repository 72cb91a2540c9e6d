//! A window: everybody who works beside it has a thread, and files lie in folders.

mod asking;
mod film;
mod journal;
mod keeping;
mod light;
mod maker;
mod memory;
pub(crate) mod opening;
mod order;
mod reveal;
mod sewing;
mod sim;
mod tailor;

use std::path::PathBuf;

use eframe::egui::Context;

use crate::making::Product;

pub(crate) use asking::Asking;
pub(crate) use film::{film, group_film};
pub(crate) use keeping::Keeping;
pub(crate) use light::Light;
pub(crate) use maker::Maker;
pub(crate) use order::OrderWork;
pub(crate) use reveal::begin as reveal;
pub(crate) use sewing::Sewing;
pub(crate) use sim::Sim;
pub(crate) use tailor::Tailor;

/// Whether files lie in folders that can be shown.
pub(crate) const HAS_FOLDERS: bool = true;

/// What is kept of the dance to be seen again takes so many bytes at most: nearly a minute of a skirt.
pub(crate) const TAKE_BYTES: usize = 512 << 20;

/// Nothing: nobody measures a window from outside.
pub(crate) const fn note(_what: &str) {}

/// Processors that may work at a time.
pub(crate) fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// So many threads for one piece of work; `None` where the work is done by whoever asks.
pub(crate) fn pool(threads: usize) -> Option<rayon::ThreadPool> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    pool.build().ok()
}

/// What can be made here.
pub(crate) const fn products() -> &'static [Product] {
    &Product::ALL
}

/// A file that was dropped on the window since the last picture.
pub(crate) fn take_dropped(context: &Context) -> Option<PathBuf> {
    context.input(|input| {
        let files = &input.raw.dropped_files;
        files.first().map(|file| file.path().to_owned())
    })
}
