//! The one place where a window and a page differ: who works beside the interface, where files come from and
//! go to, and what outlives it.
//!
//! In a window everybody has a thread. A page has no threads and no files: workers, which share nothing with
//! it, are sent bytes, files are handed in and out by the browser, and what outlives the page lies in the
//! browser's storage. Both sides have the same names, and the rest of the studio knows neither.

#[cfg(any(target_arch = "wasm32", test))]
mod fineness;
#[cfg(any(target_arch = "wasm32", test))]
mod letters;
#[cfg(target_arch = "wasm32")]
pub(crate) mod page;
#[cfg(any(target_arch = "wasm32", test))]
mod parcel;
#[cfg(not(target_arch = "wasm32"))]
pub(crate) mod window;
#[cfg(any(target_arch = "wasm32", test))]
mod zip;

#[cfg(target_arch = "wasm32")]
pub(crate) use page::{
    Asking, HAS_FOLDERS, Keeping, Light, Maker, OrderWork, Sewing, Sim, TAKE_BYTES, Tailor, cores,
    film, group_film, note, pool, products, reveal, take_dropped,
};
#[cfg(not(target_arch = "wasm32"))]
pub(crate) use window::{
    Asking, HAS_FOLDERS, Keeping, Light, Maker, OrderWork, Sewing, Sim, TAKE_BYTES, Tailor, cores,
    film, group_film, note, pool, products, reveal, take_dropped,
};
