//! The live window: the dance runs on its own thread, and every knob can be turned while it does.
//!
//! The interface holds no cloth and does no arithmetic of its own: it sends [`Command`]s to the
//! simulation's thread and draws the [`Snapshot`]s that come back. A [`Studio`] is all that the
//! panels show and change; it needs neither a display nor a thread, so that they can be tested.

mod app;
mod chooser;
mod clock;
mod command;
mod history;
mod journal;
mod light;
mod look;
mod making;
mod memory;
mod message;
mod opening;
mod orbit;
mod ordering;
mod overlay;
pub mod panel;
mod paper;
mod request;
mod reveal;
mod sim;
mod snapshot;
mod studio;
mod tailor;
mod text;
mod undo;
mod viewport;
mod wished;
mod work;

pub use command::Command;
pub use message::Message;
pub use opening::{Opening, Refusal, open};
pub use snapshot::Snapshot;
pub use studio::Studio;
pub use work::Work;
