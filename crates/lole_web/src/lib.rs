//! The studio as a page: what its script calls, and nothing more. The studio itself, with everything that a page
//! does differently, is `lole_studio`.
//!
//! [`scene`] runs the engine's scenes as they are run everywhere else, so that a browser can be held to the same
//! bits.

#![cfg_attr(
    target_arch = "wasm32",
    expect(
        unsafe_code,
        reason = "what JavaScript calls is unsafe by its nature; the macro writes it"
    )
)]

#[cfg(target_arch = "wasm32")]
mod page;
pub mod scene;
