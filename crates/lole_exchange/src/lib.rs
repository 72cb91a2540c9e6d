//! Patterns and measures of other programs: read and checked, drawn flat, and written in the same form.
//!
//! A reader takes bytes and gives what the rest of Lole works with, or one sentence that says where in the file
//! something is wrong and what to do. What a file does not say is not guessed in silence: it is taken in the way
//! that the format's own rules ask for and told among the notes.

mod error;
mod fields;
pub mod flat;
pub mod garmentcode;
mod inspection;
pub mod measures;

pub use error::ExchangeError;
pub use inspection::{InspectedPanel, InspectedStitch, PatternInspection};
