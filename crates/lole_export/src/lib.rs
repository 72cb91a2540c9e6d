//! Files out, as bytes: the caller writes them.
//!
//! | File | Function |
//! |---|---|
//! | `dance.mp4` | [`video::Mp4Writer`]: H.264, one picture at a time |
//! | `booklet.pdf` | [`booklet::booklet_sheets`]: how a costume is sewn, with drawings and cost |
//! | `order.pdf`, `order.json` | [`order::order_sheets`], [`order::order_json`]: a group's costumes |
//! | `form.pdf` | [`form::form_sheets`]: where to measure |
//! | printed pages | [`pdf::Document`]: text, lines and pictures at true size |
//! | cut plans, full-size patterns | [`cutting`]: PDF, SVG, JSON |
//! | `pattern.dxf` | [`dxf::pattern_dxf`]: pieces for pattern software |
//! | `counts.csv` | [`counts::counts_csv`]: when every count of a dance falls |
//! | stills | [`still::encode_png`], [`still::encode_jpeg`] |
//! | `dancer.glb` | [`glb::write_glb`]: skinned dancer and cloth with baked motion |
//! | `costume.vrm` | [`glb::write_glb`] with the extensions of [`vrm`] |
//! | takes | [`take::write_take`]: point caches, OBJ, NumPy, tables, USD |
//! | `dancer.json` | [`dancer_sheet::dancer_json`]: a dancer's tape and capsules |
//! | `group.json` | [`group::group_json`]: who stands where in a film of a group |
//! | `report.json` | [`report::report_json`] |
//! | `report.html` | [`report::report_html`]: one self-contained page in Japanese and English |
//! | `study.json`, `.csv`, `.html` | [`study::study_json`], [`study::study_csv`], [`study::study_html`] |
//! | `bench.html` | [`trade_off::trade_off_html`]: what more time for a frame buys |
//! | `validation.html` | [`validation::validation_html`]: figures against closed forms, with curves |
//!
//! It opens no file, reads no clock, and draws no picture of the dancer: pictures come in as
//! pixels.

pub mod booklet;
mod canvas;
pub mod counts;
pub mod cutting;
pub mod dancer_sheet;
pub mod dxf;
pub mod error;
pub mod form;
pub mod glb;
pub mod group;
mod hpgl;
pub mod order;
mod page;
pub mod pdf;
pub mod report;
pub mod still;
pub mod study;
pub mod svg;
pub mod take;
pub mod trade_off;
pub mod validation;
#[cfg(not(target_arch = "wasm32"))]
pub mod video;
pub mod vrm;

pub use error::ExportError;
pub use still::ImageView;
