//! A page: workers instead of threads, files handed in and out by the browser, and the browser's storage.

mod asking;
mod browser;
mod keeping;
mod light;
mod maker;
pub(crate) mod opening;
mod order;
mod sim;
mod tailor;
mod worker;

use std::path::Path;
use std::sync::mpsc::{self, Receiver};

use lole_language::Sentence;

use crate::making::{Line, Product, Unmade, Wish};

pub(crate) use asking::Asking;
pub(crate) use browser::{note, take_dropped};
pub(crate) use keeping::Keeping;
pub(crate) use light::Light;
pub(crate) use maker::Maker;
pub(crate) use order::OrderWork;
pub(crate) use sim::{Sewing, Sim};
pub(crate) use tailor::Tailor;

/// Whether files lie in folders that can be shown.
pub(crate) const HAS_FOLDERS: bool = false;

/// What is kept of the dance to be seen again takes so many bytes at most.
pub(crate) const TAKE_BYTES: usize = 128 << 20;

/// Processors that may work at a time: a worker has one.
pub(crate) const fn cores() -> usize {
    1
}

/// A worker has no threads of its own.
pub(crate) const fn pool(_threads: usize) -> Option<rayon::ThreadPool> {
    None
}

/// What can be made here: all but the film, whose encoder is C++.
pub(crate) const fn products() -> &'static [Product] {
    &[Product::Booklet, Product::Pattern, Product::Model]
}

/// The film, which is not offered here.
pub(crate) fn film(_wish: &Wish, _line: &Line<'_>) -> Result<Vec<u8>, Unmade> {
    Err(Unmade::Failed(Sentence::new(
        "ブラウザーでは動画を作れません。パソコンの lole で作ってください。",
        "A page makes no film; make it with lole on a computer.",
    )))
}

/// The same of everybody.
pub(crate) fn group_film(wish: &Wish, line: &Line<'_>) -> Result<Vec<u8>, Unmade> {
    film(wish, line)
}

/// Nothing: what was downloaded is shown by the browser itself.
pub(crate) fn reveal(_path: &Path, _wake: impl Fn() + Send + 'static) -> Receiver<Sentence> {
    mpsc::channel().1
}
