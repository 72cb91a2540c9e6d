//! The simulation: it dances by the clock, grants wishes between two frames and hands out snapshots.
//! Whoever shows them never waits for it, and it never waits for them. Where it works, [`crate::platform`]
//! says.

mod pace;
mod repair;
pub(crate) mod sewing;
pub(crate) mod stagehand;

use lole_costume::document::Design;
use lole_language::Sentence;

use crate::{Command, Snapshot};
use sewing::Sewn;
#[cfg(test)]
pub(crate) use stagehand::first_moment;

/// What it says besides snapshots.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum News {
    /// A skirt is being sewn; what is on stage goes on.
    Sewing,
    /// It is on stage.
    Sewn,
    /// A wish cannot be granted, with the design that goes on.
    Refused(Sentence, Box<Design>),
    #[cfg_attr(
        not(any(target_arch = "wasm32", test)),
        expect(dead_code, reason = "a window sews on a thread of its own")
    )]
    /// What is wished, and what goes on: somebody else must sew it, and tells when it can be shown.
    Elsewhere(Box<Design>, Box<Design>),
}

/// What reaches it.
pub(crate) enum Input {
    Wanted(Command),
    Sewn(Box<Sewn>),
}

/// Where the simulation leaves what it has to show.
pub(crate) trait Outbox {
    /// Whether the last snapshot was taken, so that another one is wanted.
    fn is_empty(&self) -> bool;

    /// Leaves a snapshot.
    fn post(&self, snapshot: Snapshot);

    /// Says something beside.
    fn say(&self, news: News);
}
