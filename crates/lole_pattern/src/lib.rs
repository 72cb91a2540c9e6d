//! Flat pieces, drafted from measurements the way a tailor drafts them.
//!
//! Everything here is arithmetic in `f64` on [`Length`](lole_geom::Length): measurements and
//! options go in, cut sizes, lines to mark, elastic, thread and yardage come out.
//! The crate knows no cloth simulation, no body surface, no third dimension and no file.
//!
//! | symbol | meaning |
//! |---|---|
//! | `H` | hip girth, the fullest tape around the hips |
//! | `G` | girth where the skirt is worn |
//! | `r` | gather ratio: flat length over hip girth |
//! | `L` | finished length, top fold to hem |
//! | `F` | fold depth: header, casings and the gaps between them |
//!
//! ```
//! use lole_geom::Length;
//! use lole_pattern::design::pau_skirt::{PauMeasurements, PauOptions, draft_pau_skirt};
//!
//! let measurements = PauMeasurements {
//!     hip_girth: Length::from_cm(91.0),
//!     worn_girth: Length::from_cm(83.0),
//!     worn_height: Length::from_cm(85.0),
//! };
//! let draft = draft_pau_skirt(&measurements, &PauOptions::default())?;
//! assert!((draft.flat_length.to_cm() - 364.0).abs() < 1e-9);
//! # Ok::<(), lole_pattern::DraftError>(())
//! ```

pub mod alterations;
pub mod design;
pub mod error;
pub mod joining;
pub mod marker;
pub mod measures;
pub mod pattern;
pub mod piece;
pub mod polygon;
pub mod ratio;
pub mod tailor_tape;
pub mod yardage;

pub use alterations::{Alteration, Alterations};
pub use error::DraftError;
pub use marker::Marker;
pub use measures::{Measure, Measures};
pub use pattern::Pattern;
pub use piece::Piece;
pub use ratio::{ElasticRatio, GatherRatio};
pub use tailor_tape::{TailorTape, Tailored};
pub use yardage::{Yardage, sold_zip};
