//! What a run reports about itself: numbers for programs, and a page for people.
//!
//! Both say the same: [`report_json`] for programs, [`report_html`] for eyes.

mod html;
mod model;

pub use model::{
    DancerMeasure, ElasticHoldFacts, GarmentFacts, MeanPercentileMax, MedianPercentile, MinMeanMax,
    Remark, ReportDivergence, ReportFile, ReportPieceOver, RunReport, RunSeries, SkirtFacts, Still,
    Worst,
};

use crate::ExportError;

/// `report.json`: the report as indented JSON; a number that is not finite becomes `null`.
///
/// # Errors
/// [`ExportError::Encoding`] when the report cannot be written as JSON.
pub fn report_json(report: &RunReport) -> Result<String, ExportError> {
    serde_json::to_string_pretty(report)
        .map(|text| text + "\n")
        .map_err(|error| ExportError::Encoding {
            file: "report.json",
            cause: error.to_string(),
        })
}

/// What the page shows besides numbers.
#[derive(Debug, Clone, Copy, Default)]
pub struct PageMedia<'a> {
    /// The film; the page is made without one when `None`.
    pub film: Option<PageFilm<'a>>,
    /// Stills as JPEG bytes, in the order of the page; the first is the film's poster.
    pub stills: &'a [Still<'a>],
}

/// The film of a page.
#[derive(Debug, Clone, Copy)]
pub enum PageFilm<'a> {
    /// MP4 bytes that the page holds itself.
    Held(&'a [u8]),
    /// Name of an MP4 beside the page: one that is too long for browsers to open a page with.
    Beside(&'a str),
}

/// `report.html`: one page in Japanese and English.
#[must_use]
pub fn report_html(report: &RunReport, media: PageMedia<'_>) -> String {
    html::page(report, media)
}
