//! Runs by the thousand: a sweep names a design and what is varied of it, every run becomes a record, and
//! the records of all runs become one table.
//!
//! | Module | What it is |
//! |---|---|
//! | [`batch`] | a sweep in a file and a folder of results: what the command and queues call |
//! | [`sweep`] | the text of a sweep, read and refused |
//! | [`plan`] | a sweep over a design: which documents are run, and what each is called |
//! | [`perform`](mod@perform) | one document danced from first to last frame, and measured |
//! | [`hem`] | sway and folds of a hem |
//! | [`record`] | what one run leaves behind, as text that any machine can write |
//! | [`table`] | the columns of all runs; as CSV and as Parquet |
//!
//! Files go through `lole_files`; it reads no clock and starts no thread: whoever has cores, a queue or a cluster performs
//! the documents of a [`Plan`] in any order and any number of times, and the table is the same to the bit.

pub mod batch;
pub mod hem;
mod key;
mod npy;
pub mod perform;
pub mod plan;
pub mod record;
pub mod sweep;
pub mod table;

pub use batch::{Batch, Missing};
pub use key::put;
pub use perform::{Files, Performed, perform};
pub use plan::Plan;
pub use record::{Figures, Record};
pub use sweep::{FileKind, Sweep};
