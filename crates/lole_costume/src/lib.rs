//! The costume: the design document, the shelf of fabrics, the print, and the drafted pattern
//! sewn to cloth on a body.
//!
//! The crate opens no file and draws no picture: documents come in as text and go out as text.
//!
//! ```
//! use lole_costume::document::{self, Design};
//!
//! let design = document::parse("lole = 1\n[skirt]\nhem_height_cm = 25\n", "mine.lole")?;
//! assert_eq!(design.skirt.hem_height_cm, 25.0);
//! assert_eq!(design.motion, Design::default().motion);
//! # Ok::<(), document::DesignError>(())
//! ```

pub mod cost;
pub mod document;
pub mod fabrics;
pub mod order;
pub mod roster;
pub mod sew;
pub mod size_chart;
pub mod tailoring;
