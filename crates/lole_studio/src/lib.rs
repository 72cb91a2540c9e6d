//! The live window: the dance runs on its own thread, and every knob can be turned while it does.
//!
//! The interface holds no cloth and does no arithmetic of its own: it sends [`Command`]s to the
//! simulation's thread and draws the [`Snapshot`]s that come back. A [`Studio`] is all that the
//! panels show and change; it needs neither a display nor a thread, so that they can be tested.

#![cfg_attr(
    target_arch = "wasm32",
    expect(
        dead_code,
        reason = "a page leaves out what only a window does, such as lists of folders"
    )
)]

mod app;
mod chooser;
mod clock;
mod command;
mod companion;
mod history;
mod light;
mod look;
mod making;
mod memory;
mod message;
mod orbit;
mod ordering;
mod overlay;
pub mod panel;
mod paper;
mod platform;
mod replay;
mod request;
mod sim;
mod snapshot;
mod studio;
mod tailor;
mod take;
mod text;
mod undo;
mod viewport;
mod wished;
mod work;

#[cfg(target_arch = "wasm32")]
pub use lole_export::pdf::give_fonts;
#[cfg(target_arch = "wasm32")]
pub use platform::page::opening::{PageOpening, open_page, serve};

pub use command::Command;
pub use message::Message;
#[cfg(not(target_arch = "wasm32"))]
pub use platform::window::opening::{Opening, Refusal, open};
pub use snapshot::Snapshot;
pub use studio::Studio;
pub use work::Work;
