//! The studio as a page: what its script calls, and nothing more. The studio itself, with everything that a page
//! does differently, is `lole_studio`.
//!
//! [`scene`] runs the engine's scenes as they are run everywhere else, so that a browser can be held to the same
//! bits.

#[cfg(target_arch = "wasm32")]
pub mod page;
pub mod scene;
