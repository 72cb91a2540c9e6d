//! The studio as a page: what its script calls, and nothing more. The studio itself, with everything that a page
//! does differently, is `lole_studio`; the scenes by which a browser is held to the same bits are
//! `lole_stage::machine`.

#[cfg(target_arch = "wasm32")]
pub mod page;
